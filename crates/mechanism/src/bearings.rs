//! Loads of pistons, pins and bearings.

pub(crate) mod beam;
pub(crate) mod main_forces;
pub(crate) mod main_loads;
pub(crate) mod main_orders;
pub(crate) mod plan;
pub(crate) mod request;
pub(crate) mod result;
pub(crate) mod rod_force;
pub(crate) mod throw_forces;

pub use beam::{Beam, BeamModel};
pub use main_forces::{MainForces, MainGas, MainInertia};
pub use main_loads::{MainInertiaLoad, main_inertia_loads};
pub use main_orders::{MainOrder, MainOrders, main_orders};
pub use plan::{BearingPlan, BearingTrace, RodTrace};
pub use request::{BearingPart, BearingRequest};
pub use result::*;
pub use throw_forces::{ThrowForce, throw_forces};
