//! The studio: engine file, loads, balancing, counterweights and report in a browser, served to this machine alone unless a port is to be forwarded.
//!
//! [`serve`] answers at one address, which holds a random token: a page of assets that stand in the program, and an interface of
//! JSON over the facade, the same structures as `--format json` prints. The engine file's text is the only state, and the page
//! holds it: every question brings the text along, so that two windows, a restart or a lost connection cost nothing.
//!
//! The questions and what answers them are `lanchester_answers`; here stands what carries them.
#![forbid(unsafe_code)]

mod asking;
mod assets;
mod error;
mod folder;
mod gate;
mod lanes;
mod server;
mod watch;

pub use assets::THIRD_PARTY;
pub use error::StudioError;
pub use lanchester_answers::{openapi, typescript};
pub use server::{Options, serve};
