//! Quantities that belong to no engine.

pub(crate) mod elastic;
pub(crate) mod film;
pub(crate) mod mechanism;
