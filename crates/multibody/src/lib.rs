//! The rigid crank train on its mounts, as a second opinion on the closed form and for what the closed form cannot say.
#![forbid(unsafe_code)]

mod block_body;
mod dynamics;
mod error;
mod firing;
mod loads;
mod main_rules;
mod motion;
mod mount_place;
mod place;
mod reactions;
pub mod referee;
mod referee_engine;
mod symmetric;
mod train;

pub use block_body::BlockBody;
pub use dynamics::{CrankInertia, Equations};
pub use error::MultibodyError;
pub use loads::Loads;
pub use main_rules::{MainRule, MainShares};
pub use motion::Motion;
pub use mount_place::MountPlace;
pub use place::Place;
pub use reactions::*;
pub use referee_engine::RefereeEngine;
pub use train::*;
