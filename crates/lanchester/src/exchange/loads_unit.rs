//! Functional mock-up units of the loads of an engine.

use crate::exchange::loads_model::LoadsModel;
use crate::exchange::unit::{UnitError, UnitKind, UnitParts, UnitText, packed};
use std::f64::consts::TAU;

/// The unit of an engine's loads ([`LoadsModel`]) for co-simulation.
///
/// # Errors
/// [`UnitError`].
pub fn loads_unit(model: &LoadsModel, parts: UnitParts<'_>) -> Result<Vec<u8>, UnitError> {
    let engine = model.engine();
    let cycle = TAU * f64::from(engine.strokes.revolutions()) / engine.speed.highest;
    let text = UnitText {
        kind: UnitKind::Loads,
        name: engine.name.clone(),
        description: format!("Shaking forces, couples and torque of the engine {}", engine.name),
        variables: model.variables(),
        stop: cycle,
        step: cycle / 720.0,
    };
    packed(text, parts)
}
