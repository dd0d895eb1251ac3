//! What the studio answers: questions as JSON over the facade, the same structures as `--format json` prints.
//!
//! Nothing here knows what carries a question, where files stand or what time it is. [`answers`] is the one list of questions: each has a
//! method, a path and a function from the bytes of a question to a [`Reply`]. A server and a worker within a browser answer by it, and
//! [`openapi`] and [`typescript`] describe it. The engine file's text is the only state, and the page holds it: every question brings the text
//! along.
#![forbid(unsafe_code)]

mod api;
mod asker;
mod base64;
mod files;
mod openapi;
mod problem;
mod questions;
mod remembered;
mod state;
mod typescript;

pub use api::{Answers, Question, Reply, broken_off};
pub use asker::Asker;
pub use files::{FileState, Files, LONGEST_FILE, is_engine_file, may_replace, revision, text_of, too_long};
pub use openapi::{answers, openapi};
pub use problem::{Found, Problem, Status};
pub use state::{Studio, superseded};
pub use typescript::typescript;
