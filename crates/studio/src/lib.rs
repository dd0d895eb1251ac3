//! The studio: engine file, loads, balancing, counterweights and report in a browser, served to this machine alone.
//!
//! [`serve`] answers at one address, which holds a random token: a page of assets that stand in the program, and an interface of
//! JSON over the facade, the same structures as `--format json` prints. The engine file's text is the only state, and the page
//! holds it: every question brings the text along, so that two windows, a restart or a lost connection cost nothing.
//!
//! `questions` has the one list of questions: the server answers by it, and [`openapi`] and [`typescript`] describe it.
#![forbid(unsafe_code)]

mod api;
mod asker;
mod assets;
mod error;
mod folder;
mod gate;
mod lanes;
mod openapi;
mod problem;
mod questions;
mod remembered;
mod server;
mod state;
mod typescript;
mod watch;

pub use assets::THIRD_PARTY;
pub use error::StudioError;
pub use openapi::openapi;
pub use server::{Options, serve};
pub use typescript::typescript;
