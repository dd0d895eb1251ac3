//! Balance factors of throws and of the engine, and the primary ellipse.

pub(crate) mod answer;
pub(crate) mod balance_factor;
pub(crate) mod common_factor;
pub(crate) mod primary_ellipse;
pub(crate) mod throw_masses;

pub use answer::{FactorAnswer, factor_answer};
pub use balance_factor::{FactorGiven, FactorRequest, ThrowFactor, balance_factors};
pub use common_factor::{CommonFactor, FactorEffect, OnePlane, common_factor, pin_pair_effect};
pub use primary_ellipse::{PrimaryEllipse, Sense};
pub use throw_masses::{FirstOrder, ThrowMasses, throw_masses};
