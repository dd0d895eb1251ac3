//! The engine as a rigid body on elastic mounts (book, eq. 27.1 to 27.11).
//!
//! ```text
//! q = (u, phi)          displacement of the block's centre [m] and small rotation [rad], axes of the frame
//! u_j = B_j q           B_j = ( E , -[rho_j]x )     rho_j: mount j from the centre
//! K = SUM B_j^T K_j B_j                              K_j = SUM over its directions of k a a^T
//! M q'' + C q' + K q = (F, M about the centre)
//! ```

mod at_rest;
mod axes;
mod body;
mod error;
mod excitation;
mod free_motion;
mod modes;
mod peaks;
mod response;
mod result;
mod rotor_effects;
mod rotor_inertia;
mod rotors;
mod spring;
mod study;
mod symmetric;
mod system;

pub use error::MountError;
pub use excitation::{Excitation, inertia_excitations};
pub use result::*;
pub use rotor_effects::RotorEffects;
pub use rotor_inertia::rotor_inertia_about_z;
pub use study::{MountRequest, mount_study};
pub use system::MountSystem;
