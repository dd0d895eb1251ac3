//! Torsional vibration of an engine: its chain, its torques, what follows from them.

mod error;
mod excitation;
mod study;
mod throws;

pub use error::EngineTorsionError;
pub use excitation::{ExcitingGas, engine_excitation, torque_period};
pub(crate) use study::{Swept, driveline, has_torsion, speeds_between, swept};
pub use study::{TORSION_SPEEDS, TorsionRequest, engine_chain, torsion};
pub use throws::meshed_throws;
