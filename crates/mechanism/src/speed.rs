//! Speed within the cycle: inertia over the angle, energy, flywheel.

pub(crate) mod energy;
pub(crate) mod flywheel;
pub(crate) mod ripple;
pub(crate) mod ripple_outcome;

pub use energy::EnergyVariation;
pub use flywheel::*;
pub use ripple::*;
pub use ripple_outcome::*;
