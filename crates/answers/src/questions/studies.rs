//! Studies of many engines and of published methods: layouts, production, what the literature does, the workshop.

mod explore;
mod published;
mod scatter;
pub(super) mod turn;
mod workshop;

use crate::api::Api;

pub(crate) fn questions(api: Api) -> Api {
    let api = scatter::questions(explore::questions(api));
    workshop::questions(published::questions(api))
}
