//! Production scatter: what tolerances of parts do to the residual forces and couples.
//!
//! [`scatter`] draws samples, each addressed by its number, so that no result depends on threads; [`Scattering`] draws them stretch by
//! stretch; [`worst_cases`] looks for the worst combination; [`assign`] tells which weighed piston and rod belongs into which cylinder.

mod articulated;
mod assignment;
mod coefficients;
mod crank_speed;
mod deviated;
mod error;
mod farthest;
mod model;
mod moving_parts;
mod peak;
mod plain_rod;
mod request;
mod result;
mod sampler;
mod scattering;
mod share;
mod spectrum;
mod statistics;
pub(crate) mod stream;
mod study;
mod tolerance;
mod turned;
mod value;
mod worst;

pub use assignment::{Assignment, AssignmentRequest, WeighedRod, assign, standard_lever};
pub use error::ScatterError;
pub use request::{Limit, Output, ScatterRequest};
pub use result::{Capability, Contribution, Deviation, OutputScatter, Percentile, SCATTER_VERSION, Scatter};
pub use scattering::{Drawn, Scattering, Tally, scatter};
pub use study::{
    LimitVerdict, SCATTER_STUDY_VERSION, ScatterOptions, ScatterStudy, TOLD_SHARES, Tightened, scatter_study,
    scatter_study_of,
};
pub use worst::{WorstCase, worst_cases};
