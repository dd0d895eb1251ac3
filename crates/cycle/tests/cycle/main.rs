//! All tests of the crate.

mod balance;
mod ideal;
mod support;
mod trace;
mod zone;
