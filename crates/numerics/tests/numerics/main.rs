//! All tests of the crate.

mod explicit;
mod implicit;
