//! Crankshaft and counterweights as they stand in the file, checked.

use crate::counterweights::CounterweightError;
use lanchester_geometry::clearance::Clearances;
use lanchester_geometry::counterweight_properties;
use lanchester_geometry::crankshaft::{CrankshaftBody, crankshaft};
use lanchester_model::Engine;
use serde::Serialize;

/// Version of [`CounterweightCheck`]; raised when a field changes its meaning or goes.
pub const COUNTERWEIGHT_CHECK_VERSION: u32 = 1;

/// Part of the wanted unbalance that a counterweight may miss.
const MISSED: f64 = 0.01;

/// A counterweight that is a part.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CheckedCounterweight {
    /// Its name.
    pub name: String,
    /// Its index in [`Engine::counterweights`].
    pub index: usize,
    /// The unbalance that it should have [kg m], if the file says so.
    pub wanted: Option<f64>,
    /// The unbalance that it has on its web [kg m].
    pub unbalance: f64,
    /// Whether it is within a hundredth of what it should be.
    pub is_met: bool,
    /// Its mass beyond the plain web [kg].
    pub mass: f64,
    /// Its polar inertia about the crank axis beyond the plain web [kg m^2].
    pub polar_inertia: f64,
    /// Swept radius [m].
    pub swept_radius: f64,
    /// Thickness [m].
    pub thickness: f64,
}

/// Crankshafts, counterweights and clearances of an engine.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CounterweightCheck {
    /// [`COUNTERWEIGHT_CHECK_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// Counterweights that are parts.
    pub counterweights: Vec<CheckedCounterweight>,
    /// The crankshafts as bodies; empty where the file has no `[crank.body]`.
    pub crankshafts: Vec<CrankshaftBody>,
    /// Clearances; none where the file names nothing to stay clear of.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub clearances: Option<Clearances>,
    /// Whether every counterweight has its unbalance and every clearance is kept.
    pub is_kept: bool,
}

/// Checks what the engine says of its crankshaft as parts.
///
/// # Errors
/// Where it says nothing: neither parts nor a body; where a crankshaft is no body, or a clearance cannot be computed.
pub fn check_counterweights(engine: &Engine) -> Result<CounterweightCheck, CounterweightError> {
    let mut counterweights = Vec::new();
    for (index, weight) in engine.counterweights.iter().enumerate() {
        let Some(part) = &weight.part else { continue };
        let properties = counterweight_properties(engine, part)?;
        let is_met = part.wanted.is_none_or(|wanted| (weight.unbalance - wanted).abs() <= MISSED * wanted);
        counterweights.push(CheckedCounterweight {
            name: weight.name.clone(),
            index,
            wanted: part.wanted,
            unbalance: weight.unbalance,
            is_met,
            mass: properties.mass,
            polar_inertia: properties.polar_inertia(),
            swept_radius: part.part.outline().swept_radius(),
            thickness: part.part.thickness(),
        });
    }
    if counterweights.is_empty() && engine.crank_body.is_none() {
        return Err(CounterweightError::NoPart);
    }
    let bodies = if engine.crank_body.is_some() { engine.crankshafts.len() } else { 0 };
    let crankshafts = (0..bodies).map(|index| crankshaft(engine, index)).collect::<Result<Vec<_>, _>>()?;
    let clearances = engine.envelope.map(|_| crate::clearances(engine)).transpose()?;
    let is_kept = counterweights.iter().all(|weight| weight.is_met)
        && clearances.as_ref().is_none_or(|clearances| clearances.is_kept);
    Ok(CounterweightCheck {
        version: COUNTERWEIGHT_CHECK_VERSION,
        engine: engine.name.clone(),
        counterweights,
        crankshafts,
        clearances,
        is_kept,
    })
}
