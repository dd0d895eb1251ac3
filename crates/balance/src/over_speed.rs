//! Loads that a higher speed need not raise: over a range of speeds, with gas, at mounts on springs.

pub(crate) mod gas;
pub(crate) mod gas_range;
pub(crate) mod mount_range;
pub(crate) mod places;
pub(crate) mod range;

pub use gas::GasOverSpeed;
