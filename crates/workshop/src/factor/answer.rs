//! What `workshop factor` answers: the factors of every throw, and the factor that the engine as a whole wants.

use crate::error::WorkshopError;
use crate::factor::balance_factor::{FactorGiven, FactorRequest, ThrowFactor, balance_factors};
use crate::factor::common_factor::{CommonFactor, common_factor};
use lanchester_model::{Engine, Rotation};
use serde::Serialize;

/// Balance factors of an engine.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FactorAnswer {
    /// [`crate::WORKSHOP_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// Sense of rotation, for pictures.
    pub rotation: Rotation,
    /// Speed of crankshaft 1 [rad/s] at which forces are shown.
    pub speed: f64,
    /// What was given.
    pub given: FactorGiven,
    /// Factors of every throw, with the speed of its crankshaft over that of crankshaft 1.
    pub throws: Vec<ThrowFactor>,
    /// Speed ratio of every throw's crankshaft.
    pub ratios: Vec<f64>,
    /// What one factor for all throws does, for every crankshaft: over the square of its own speed.
    pub crankshafts: Vec<CommonFactor>,
    /// Names of counterweights that belong to no throw.
    pub elsewhere: Vec<String>,
}

impl FactorAnswer {
    /// What turns an unbalance [kg m] of a throw into its force [N]: the square of its crankshaft's speed.
    pub fn square(&self, throw: usize) -> f64 {
        (self.speed * self.ratios[throw]).powi(2)
    }
}

/// Balance factors of an engine, by every definition.
///
/// # Errors
/// As [`balance_factors`].
pub fn factor_answer(engine: &Engine, request: &FactorRequest) -> Result<FactorAnswer, WorkshopError> {
    let throws = balance_factors(engine, request)?;
    Ok(FactorAnswer {
        version: crate::WORKSHOP_VERSION,
        engine: engine.name.clone(),
        rotation: engine.rotation,
        speed: engine.speed.highest,
        given: request.given,
        ratios: engine.throws.iter().map(|t| engine.crankshafts[t.crankshaft].ratio.value()).collect(),
        crankshafts: (0..engine.crankshafts.len())
            .map(|index| common_factor(engine, index))
            .collect::<Result<_, _>>()?,
        elsewhere: crate::factor::throw_masses::ownerless(engine),
        throws,
    })
}
