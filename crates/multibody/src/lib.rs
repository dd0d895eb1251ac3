//! The rigid crank train on its mounts, as a second opinion on the closed form and for what the closed form cannot say.
#![forbid(unsafe_code)]

mod block_body;
mod dynamics;
mod error;
mod motion;
mod mount_place;
mod place;
mod train;

pub use block_body::BlockBody;
pub use dynamics::{CrankInertia, Equations};
pub use error::MultibodyError;
pub use motion::Motion;
pub use mount_place::MountPlace;
pub use place::Place;
pub use train::*;
