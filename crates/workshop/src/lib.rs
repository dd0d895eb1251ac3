//! The workshop: balance factors, bobweights, the unbalance of a crank with its bobweights, weights outside and inside
//! the crankcase; and the balancing of a real rotor, crank or engine from the measurements of a
//! [`Sheet`](lanchester_task::workshop::Sheet).
//!
//! Unbalances are complex [kg m]: modulus = mass times radius, argument = direction. A throw's own frame has its real
//! axis along the throw; the frame of a crankshaft is the engine's at the crankshaft angle 0; that of a rotor is the
//! circle of degrees painted on it.

#![forbid(unsafe_code)]

mod bobweight;
mod bobweight_answer;
mod crank_unbalance;
mod error;
mod external;
mod factor;
mod internal;
mod removal;
mod rotor;

pub use bobweight::{Bobweight, bobweights};
pub use bobweight_answer::{
    BobweightAnswer, BobweightComparison, ComparedBalance, FactorChoice, bobweight_answer, weighed,
};
pub use crank_unbalance::{
    BodyState, CrankBody, CrankUnbalance, QuasiStatic, UnbalanceKind, crank_unbalance,
};
pub use error::WorkshopError;
pub use external::{ExternalBalance, RadiusAndMass, external_balance};
pub use factor::*;
pub use internal::{InternalBalance, InternalPlane, internal_balance};
pub use removal::*;
pub use rotor::*;

/// Version of the structures of the workshop; raised when a field changes its meaning or goes.
pub const WORKSHOP_VERSION: u32 = 1;
