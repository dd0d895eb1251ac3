//! What the engine runs on and against: bearings, block and mounts, friction, gas, and runs in time.

mod bearing_data;
pub(crate) mod bearing_design;
pub(crate) mod bearings;
pub(crate) mod block;
pub(crate) mod flywheel;
pub(crate) mod friction;
pub(crate) mod gas;
pub(crate) mod gas_check;
pub(crate) mod load;
pub(crate) mod mount;
pub(crate) mod simulation;
pub(crate) mod torsion;
pub(crate) mod torsion_check;

pub use bearing_design::*;
pub use bearings::{Bearings, PlainBearing};
pub use block::*;
pub use flywheel::Flywheel;
pub use friction::Friction;
pub use gas::*;
pub use load::*;
pub use mount::*;
pub use simulation::*;
pub use torsion::*;
