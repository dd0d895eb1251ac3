//! Production scatter: what tolerances of parts do to the residual forces and couples.
//!
//! [`scatter`] draws samples, each addressed by its number, so that no result depends on threads; [`Scattering`] draws them stretch by
//! stretch; [`worst_cases`] looks for the worst combination; [`assign`] tells which weighed piston and rod belongs into which cylinder.

mod assignment;
mod coefficients;
mod deviated;
mod error;
mod lanes;
mod model;
mod peak;
mod run;
mod sampler;
mod scattering;
mod share;
mod statistics;
pub(crate) mod stream;
mod study;
mod tolerance;
mod worst;

pub use assignment::{Assignment, AssignmentRequest, WeighedRod, assign, standard_lever};
pub use error::ScatterError;
pub use run::{
    Capability, Contribution, Limit, Output, OutputScatter, Percentile, SCATTER_VERSION, Scatter,
    ScatterRequest, scatter,
};
pub use scattering::{Drawn, Scattering, Tally};
pub use study::{
    Deviation, LimitVerdict, SCATTER_STUDY_VERSION, ScatterOptions, ScatterStudy, TOLD_SHARES, Tightened,
    scatter_study, scatter_study_of,
};
pub use worst::{WorstCase, worst_cases};
