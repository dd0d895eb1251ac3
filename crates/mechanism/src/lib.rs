//! Closed-form crank train: exact kinematics, orders, inertia loads.

mod diagnosis;
mod drive;
mod extremes;
mod lanes;
mod linkage;
mod loads;
mod motion;
mod orders;
mod peaks;
mod point;
mod request;
mod result;
mod sampling;
mod series;
mod spectrum;
mod trace;
mod train;
mod wording;

pub use loads::loads;
pub use motion::motion;
pub use request::{Kinematics, LoadError, LoadRequest, PeakMode};
pub use result::*;
pub use series::{exact_coefficients, series_coefficients};
pub use spectrum::OrderPlan;
pub use trace::{AngleGrid, TracePlan};
pub use train::{Mechanism, Selection};
