//! Closed-form crank train: exact kinematics, orders, inertia loads.
//!
//! [`loads`] computes everything about an engine at one speed: over the cycle, by order split into parts that turn with
//! the crank and against it, by kind of part, by cylinder, with true extremes and a diagnosis in words. Who needs one of
//! these many times over prepares it: [`Mechanism`] is the engine at one speed, [`OrderPlan`] and [`TracePlan`] write its
//! loads without allocating.
//!
//! What moves: [`motion`], [`exact_coefficients`], [`series_coefficients`]. Rigid parts, constant speed, no play.

mod beam;
mod bearing_plan;
mod bearing_request;
mod bearings;
mod chamber;
mod curve;
mod diagnosis;
mod drive;
mod energy;
mod envelope;
mod extremes;
mod firing_chart;
mod flywheel;
mod gas;
mod gas_train;
mod internal;
mod lanes;
mod linkage;
mod loads;
mod main_forces;
mod main_loads;
mod main_orders;
mod motion;
mod mounts;
mod orders;
mod outer_torque;
mod peaks;
mod point;
mod power_curve;
mod request;
mod result;
mod ripple_outcome;
mod rod_force;
mod rod_place;
mod sampling;
mod series;
mod spectrum;
mod spline;
mod torque;
mod torque_request;
mod torque_result;
mod torque_without_gas;
mod trace;
mod train;
mod true_mean;
mod true_peak;
mod turned;
mod wording;

pub use beam::{Beam, BeamModel};
pub use bearing_plan::{BearingPlan, BearingTrace, RodTrace};
pub use bearing_request::{BearingPart, BearingRequest};
pub use bearings::*;
pub use chamber::ChamberMotion;
pub use curve::{CurveError, End, PeriodicCurve};
pub use energy::EnergyVariation;
pub use firing_chart::*;
pub use flywheel::*;
pub use gas::CylinderGas;
pub use gas_train::{GasTrain, merged_orders};
pub use internal::*;
pub use loads::{loads, total_loads};
pub use main_forces::MainForces;
pub use main_loads::{MainInertiaLoad, main_inertia_loads};
pub use main_orders::{MainOrder, MainOrders, main_orders};
pub use motion::motion;
pub use mounts::*;
pub use outer_torque::OuterTorque;
pub use power_curve::{Brake, PowerCurve};
pub use request::{Kinematics, LoadError, LoadRequest, PeakMode};
pub use result::*;
pub use ripple_outcome::*;
pub use rod_place::{RodLinkage, RodPlace, RodReach};
pub use series::{exact_coefficients, series_coefficients};
pub use spectrum::OrderPlan;
pub use torque::torque;
pub use torque_request::{Lever, TorqueError, TorqueRequest};
pub use torque_result::*;
pub use torque_without_gas::torque_without_gas;
pub use trace::{AngleGrid, TracePlan};
pub use train::{Mechanism, Selection, firing_period};
