//! The workshop: balance factors, bobweights, the unbalance of a crank with its bobweights, weights outside and inside
//! the crankcase.
//!
//! Unbalances are complex [kg m]: modulus = mass times radius, argument = direction. A throw's own frame has its real
//! axis along the throw; the frame of a crankshaft is the engine's at the crankshaft angle 0.

mod balance_factor;
mod common_factor;
mod error;
mod primary_ellipse;
mod throw_masses;

pub use balance_factor::{FactorGiven, FactorRequest, ThrowFactor, balance_factors};
pub use common_factor::{CommonFactor, FactorEffect, OnePlane, common_factor, pin_pair_effect};
pub use error::WorkshopError;
pub use primary_ellipse::{PrimaryEllipse, Sense};
pub use throw_masses::{FirstOrder, ThrowMasses, throw_masses};
