//! Functional mock-up units of the crank train at free speed.

use crate::exchange::crank_train_model::CrankTrainModel;
use crate::exchange::unit::{UnitError, UnitKind, UnitParts, UnitText, packed};
use std::f64::consts::TAU;

/// Steps of an experiment to begin with over a revolution at the highest speed, at the least.
const STEPS: f64 = 100.0;

/// The unit of a crank train ([`CrankTrainModel`]) for co-simulation.
///
/// # Errors
/// [`UnitError`].
pub fn crank_train_unit(model: &CrankTrainModel, parts: UnitParts<'_>) -> Result<Vec<u8>, UnitError> {
    // A round number: the largest power of ten.
    let step = 10f64.powf((TAU / model.highest_speed() / STEPS).log10().floor());
    let text = UnitText {
        kind: UnitKind::CrankTrain,
        name: model.name().to_owned(),
        description: format!("Crank train of the engine {} at free speed", model.name()),
        variables: model.variables(),
        stop: model.duration(),
        step,
    };
    packed(text, parts)
}
