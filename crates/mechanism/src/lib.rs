//! Closed-form crank train: exact kinematics, orders, inertia loads.

mod result;

pub use result::*;
