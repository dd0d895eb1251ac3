//! The rigid crank train on its mounts, as a second opinion on the closed form and for what the closed form cannot say.
#![forbid(unsafe_code)]

mod block;
mod block_body;
mod dynamics;
mod error;
mod firing;
mod gas_pressure;
mod loads;
mod main_loads;
mod main_rules;
mod maxwell;
mod motion;
mod mount_place;
mod periodic;
mod place;
mod plane_sums;
mod powered;
mod reactions;
pub mod referee;
mod rotor_shares;
mod run;
mod simulation;
mod stepper;
mod symmetric;
mod train;

pub use block::BlockBody;
pub use dynamics::{CrankInertia, Equations};
pub use error::MultibodyError;
pub use gas_pressure::GasPressure;
pub use lanchester_numerics::Outcome;
pub use loads::Loads;
pub use main_loads::MainLoads;
pub use main_rules::{MainRule, MainShares};
pub use maxwell::{MOST_BRANCHES, MaxwellChain};
pub use motion::Motion;
pub use mount_place::MountPlace;
pub use periodic::{Followed, MapDerivative, Periodic, PeriodicOutcome};
pub use place::Place;
pub use reactions::*;
pub use referee::engine::RefereeEngine;
pub use rotor_shares::RotorShares;
pub use run::extremes::{Bounds, CylinderExtremes, Peak, RotorExtremes, RunExtremes};
pub use run::result::*;
pub use simulation::*;
pub use stepper::{Advance, StepInputs, Stepper, StepperState};
pub use train::*;
