//! Shaking forces, couples, roll moment of the whole engine: over the angle, by order, their extremes and what they mean.

pub(crate) mod diagnosis;
pub(crate) mod internal;
pub(crate) mod loads;
pub(crate) mod order_axis;
pub(crate) mod orders;
pub(crate) mod part;
pub(crate) mod peaks;
pub(crate) mod point;
pub(crate) mod request;
pub(crate) mod result;
pub(crate) mod spectrum;
pub(crate) mod trace;

pub use internal::*;
pub use loads::{loads, total_loads};
pub use part::Part;
pub use request::{Kinematics, LoadError, LoadRequest, PeakMode};
pub use result::*;
pub use spectrum::OrderPlan;
pub use trace::{AngleGrid, TracePlan};
