//! A real rotor balanced from measurements: influence coefficients, corrections, doubts, grades.

pub(crate) mod allowed;
pub(crate) mod correction;
pub(crate) mod displayed;
pub(crate) mod grade;
pub(crate) mod history;
pub(crate) mod influence;
pub(crate) mod least_squares;
pub(crate) mod measured_grade;
pub(crate) mod phasor;
pub(crate) mod plane;
pub(crate) mod remark;
pub(crate) mod run_log;

pub use correction::{
    Correction, Influence, NextStep, Placement, PlaneCorrection, RunFindings, SensorPrediction, correction,
};
pub use displayed::displayed;
pub use grade::{Grade, GradedBearing, GradedPlane};
pub use history::SAME_SPEED;
pub use measured_grade::grade;
pub use plane::{Plane, PlaneUnbalance, end_planes, in_two_planes};
pub use remark::{CONTRADICTION, LEAST_CHANGE, LEAST_TURN, Remark, RemarkKind};
pub use run_log::{RunEntry, SensorEntry, ShownVibration};
