//! Crankshaft and counterweights as they stand in the file, checked.

use crate::parts::clearance::EngineClearanceError;
use crate::parts::error::CounterweightError;
use lanchester_geometry::clearance::{Clearances, SweptOverlap, swept_overlaps};
use lanchester_geometry::counterweight_properties;
use lanchester_geometry::crankshaft::{CrankshaftBody, crankshaft};
use lanchester_model::Engine;
use lanchester_report::{CrankshaftInput, Section, crankshaft_section};
use serde::Serialize;

/// Version of [`CounterweightCheck`]; raised when a field changes its meaning or goes.
pub const COUNTERWEIGHT_CHECK_VERSION: u32 = 1;

/// Part of the wanted unbalance that a counterweight may miss.
const MISSED: f64 = 0.01;

/// A counterweight that is a part.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
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
    /// Its mass beyond the plain web [kg]: what it adds to the crankshaft.
    pub mass: f64,
    /// Mass of the part as it is exported, with what of the web it covers [kg].
    pub part_mass: f64,
    /// Its polar inertia about the crank axis beyond the plain web [kg m^2].
    pub polar_inertia: f64,
    /// Swept radius [m].
    pub swept_radius: f64,
    /// Thickness [m].
    pub thickness: f64,
}

/// A weight of a balance shaft that is a part.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CheckedShaftWeight {
    /// Its name.
    pub name: String,
    /// Index of its shaft in [`Engine::shafts`].
    pub shaft: usize,
    /// The unbalance that it should have [kg m], if the file says so.
    pub wanted: Option<f64>,
    /// The unbalance that it has [kg m].
    pub unbalance: f64,
    /// Whether it is within a hundredth of what it should be.
    pub is_met: bool,
    /// Its mass without the shaft within it [kg].
    pub mass: f64,
    /// Its moment of inertia about the axis of its shaft, without the shaft [kg m^2].
    pub polar_inertia: f64,
    /// Its radius, which is the swept one [m].
    pub radius: f64,
    /// Diameter of the shaft within it [m].
    pub shaft_diameter: f64,
    /// Its faces along z [m], from the origin.
    pub faces: [f64; 2],
}

/// Crankshafts, counterweights, weights of balance shafts and clearances of an engine.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CounterweightCheck {
    /// [`COUNTERWEIGHT_CHECK_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// Counterweights that are parts.
    pub counterweights: Vec<CheckedCounterweight>,
    /// Weights of balance shafts that are parts.
    pub shaft_weights: Vec<CheckedShaftWeight>,
    /// Where swept circles of weights of balance shafts overlap those of another shaft or of a crankshaft in one plane: whether anything
    /// meets depends on the phases.
    pub swept_overlaps: Vec<SweptOverlap>,
    /// The crankshafts as bodies; empty where the file has no `[crank.body]`.
    pub crankshafts: Vec<CrankshaftBody>,
    /// Clearances; none where the file names nothing to stay clear of.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub clearances: Option<Clearances>,
    /// Whether every counterweight and weight of a shaft has its unbalance and every clearance is kept.
    pub is_kept: bool,
}

impl CounterweightCheck {
    /// As a section of a report.
    pub fn section(&self, engine: &Engine) -> Section {
        let clearances = self.clearances.as_ref();
        let CounterweightCheck { crankshafts: bodies, swept_overlaps, .. } = self;
        crankshaft_section(engine, &CrankshaftInput { bodies, clearances, swept_overlaps })
    }
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
        let is_met = is_met(part.wanted, weight.unbalance);
        counterweights.push(CheckedCounterweight {
            name: weight.name.clone(),
            index,
            wanted: part.wanted,
            unbalance: weight.unbalance,
            is_met,
            mass: properties.mass,
            part_mass: part.part.moments().mass,
            polar_inertia: properties.polar_inertia(),
            swept_radius: part.part.outline().swept_radius(),
            thickness: part.part.thickness(),
        });
    }
    let shaft_weights = shaft_weights(engine);
    if counterweights.is_empty() && shaft_weights.is_empty() && engine.crank_body.is_none() {
        return Err(CounterweightError::NoPart);
    }
    let bodies = if engine.crank_body.is_some() { engine.crankshafts.len() } else { 0 };
    let crankshafts = (0..bodies).map(|index| crankshaft(engine, index)).collect::<Result<Vec<_>, _>>()?;
    let clearances = engine.envelope.map(|_| crate::clearances(engine)).transpose()?;
    let is_kept = counterweights.iter().all(|weight| weight.is_met)
        && shaft_weights.iter().all(|weight| weight.is_met)
        && clearances.as_ref().is_none_or(|clearances| clearances.is_kept);
    Ok(CounterweightCheck {
        version: COUNTERWEIGHT_CHECK_VERSION,
        engine: engine.name.clone(),
        counterweights,
        shaft_weights,
        swept_overlaps: swept_overlaps(engine).map_err(EngineClearanceError::from)?,
        crankshafts,
        clearances,
        is_kept,
    })
}

/// Whether an unbalance [kg m] is within a hundredth of what it should be.
fn is_met(wanted: Option<f64>, unbalance: f64) -> bool {
    wanted.is_none_or(|wanted| (unbalance - wanted).abs() <= MISSED * wanted)
}

fn shaft_weights(engine: &Engine) -> Vec<CheckedShaftWeight> {
    let mut found = Vec::new();
    for (index, shaft) in engine.shafts.iter().enumerate() {
        for (number, weight) in shaft.weights.iter().enumerate() {
            let Some(part) = &weight.part else { continue };
            found.push(CheckedShaftWeight {
                name: shaft.weight_name(number),
                shaft: index,
                wanted: part.wanted,
                unbalance: weight.unbalance,
                is_met: is_met(part.wanted, weight.unbalance),
                mass: part.mass(),
                polar_inertia: part.polar_inertia(),
                radius: part.shape.radius,
                shaft_diameter: 2.0 * part.shape.shaft_radius,
                faces: [weight.z - part.length / 2.0, weight.z + part.length / 2.0],
            });
        }
    }
    found
}
