//! The workshop: balance factors, bobweights, the unbalance of a crank with its bobweights, weights outside and inside
//! the crankcase; and the balancing of a real rotor, crank or engine from the measurements of a
//! [`Sheet`](lanchester_task::workshop::Sheet).
//!
//! Unbalances are complex [kg m]: modulus = mass times radius, argument = direction. A throw's own frame has its real
//! axis along the throw; the frame of a crankshaft is the engine's at the crankshaft angle 0; that of a rotor is the
//! circle of degrees painted on it.

#![forbid(unsafe_code)]

mod allowed;
mod balance_factor;
mod bobweight;
mod bobweight_answer;
mod common_factor;
mod correction;
mod crank_unbalance;
mod displayed;
mod drilling;
mod error;
mod external;
mod factor_answer;
mod grade;
mod history;
mod hole;
mod hole_search;
mod influence;
mod internal;
mod least_squares;
mod measured_grade;
mod phasor;
mod plane;
mod primary_ellipse;
mod remark;
mod run_log;
mod slug;
mod throw_masses;

pub use balance_factor::{FactorGiven, FactorRequest, ThrowFactor, balance_factors};
pub use bobweight::{Bobweight, bobweights};
pub use bobweight_answer::{
    BobweightAnswer, BobweightComparison, ComparedBalance, FactorChoice, bobweight_answer, weighed,
};
pub use common_factor::{CommonFactor, FactorEffect, OnePlane, common_factor, pin_pair_effect};
pub use correction::{
    Correction, Influence, NextStep, Placement, PlaneCorrection, RunFindings, SensorPrediction, correction,
};
pub use crank_unbalance::{
    BodyState, CrankBody, CrankUnbalance, QuasiStatic, UnbalanceKind, crank_unbalance,
};
pub use displayed::displayed;
pub use drilling::{DrilledPlane, Drilling, drilling};
pub use error::WorkshopError;
pub use external::{ExternalBalance, RadiusAndMass, external_balance};
pub use factor_answer::{FactorAnswer, factor_answer};
pub use grade::{Grade, GradedBearing, GradedPlane};
pub use history::SAME_SPEED;
pub use hole::Hole;
pub use internal::{InternalBalance, InternalPlane, internal_balance};
pub use measured_grade::grade;
pub use plane::{Plane, PlaneUnbalance, end_planes, in_two_planes};
pub use primary_ellipse::{PrimaryEllipse, Sense};
pub use remark::{CONTRADICTION, LEAST_CHANGE, LEAST_TURN, Remark, RemarkKind};
pub use run_log::{RunEntry, SensorEntry, ShownVibration};
pub use slug::{Slug, SlugPlan, slug_plan};
pub use throw_masses::{FirstOrder, ThrowMasses, throw_masses};

/// Version of the structures of the workshop; raised when a field changes its meaning or goes.
pub const WORKSHOP_VERSION: u32 = 1;
