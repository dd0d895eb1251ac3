//! Equations in time: compiled, integrated, audited.

pub(crate) mod audit;
mod compiled;
mod conditions;
mod following;
mod held;
mod holding;
pub(crate) mod motion;
mod periodic;
mod returning;
mod seconds;
pub(crate) mod simulate;
mod sticking;
mod tape;
mod trouble;
