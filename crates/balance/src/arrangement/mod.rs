//! Which arrangement of crank weights and balance shafts: all that may be fitted, the best of each, their prices and
//! the Pareto front.
//!
//! ```text
//! residual(arrangement) = min over its weights of the criterion's peak over the cycle     ([`crate::optimise`])
//! front = arrangements that no other beats or equals in residual and every price
//! ```
//! An arrangement is crank weights or none, with at most one balance shaft for each order and sense that the engine
//! leaves: two shafts of the same order and sense act as one, crank weights already act on what turns with the crank
//! at first order, and an order that the engine does not have needs no shaft.
//!
//! Shafts are placed and driven after their weights are known: the residual of force, couple and mount force on the
//! crank's own axis does not depend on where a shaft stands, only the roll moment does. Where a limit names the roll
//! moment the weights are found again at the place.

mod bearing;
mod candidate;
mod drive;
mod envelope;
mod front;
mod half_disc;
mod peaks;
mod placement;
mod request;
mod result;
#[cfg(test)]
mod sample;
mod search;
mod spacing;
mod wording;

pub use request::*;
pub use result::*;
pub use search::{arrangements, searched_engine};
