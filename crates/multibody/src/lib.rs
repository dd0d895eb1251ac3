//! The rigid crank train on its mounts, as a second opinion on the closed form and for what the closed form cannot say.
#![forbid(unsafe_code)]

mod block_body;
mod dynamics;
mod error;
mod firing;
mod main_rules;
mod motion;
mod mount_place;
mod place;
mod reactions;
mod train;

pub use block_body::BlockBody;
pub use dynamics::{CrankInertia, Equations};
pub use error::MultibodyError;
pub use main_rules::{MainRule, MainShares};
pub use motion::Motion;
pub use mount_place::MountPlace;
pub use place::Place;
pub use reactions::*;
pub use train::*;
