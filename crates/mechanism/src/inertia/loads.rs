//! All loads of an engine: whole, by part, by cylinder.

use crate::inertia::diagnosis::diagnose;
use crate::inertia::part::Part;
use crate::inertia::peaks::Scale;
use crate::inertia::request::{LoadError, LoadRequest};
use crate::inertia::result::{CylinderLoads, Loads, PartLoads, RESULT_VERSION};
use crate::train::mechanism::{Mechanism, Selection};
use crate::train::motion::motion;
use lanchester_model::Engine;
use lanchester_results::LoadSet;

/// All inertia loads of `engine`: what the moving parts exert on the block, and the inertia torque at crankshaft 1.
///
/// Parts and cylinders sum to the whole: parts exactly, cylinders together with counterweights, shafts and throws
/// that carry no rod. The frame and the signs are those of the book, "Conventions".
///
/// # Errors
/// [`LoadError`] where the request is impossible or the engine is not valid; never on an engine that was read from a
/// file and a request with its default values, but for speed ratios whose common period is too long and masses or
/// speeds beyond the range of numbers.
pub fn loads(engine: &Engine, request: &LoadRequest) -> Result<Loads, LoadError> {
    let whole = Mechanism::new(engine, request)?;
    let (scale, resolution) = (whole.scale(), whole.resolution());
    let set = |mechanism: &Mechanism| load_set(mechanism, request, resolution, scale);
    let parts = Part::ALL
        .into_iter()
        .filter(|&part| has_part(engine, part))
        .map(|part| {
            let mechanism = Mechanism::of(engine, request, Selection::Part(part))?;
            Ok(PartLoads { part, loads: set(&mechanism) })
        })
        .collect::<Result<Vec<_>, LoadError>>()?;
    let cylinders = (0..engine.cylinders.len())
        .map(|index| {
            let mechanism = Mechanism::of(engine, request, Selection::Cylinder(index))?;
            Ok(CylinderLoads { cylinder: index + 1, loads: set(&mechanism) })
        })
        .collect::<Result<Vec<_>, LoadError>>()?;
    let total = set(&whole);
    Ok(Loads {
        version: RESULT_VERSION,
        engine: engine.name.clone(),
        speed: whole.speed,
        reference: request.reference,
        kinematics: request.kinematics.name(),
        period: whole.period(),
        diagnosis: diagnose(engine, whole.speed, &total, &cylinders),
        total,
        parts,
        cylinders,
        motion: motion(engine, request)?,
    })
}

/// The loads of the whole engine alone, without parts and cylinders: [`Loads::total`] of [`loads`].
///
/// # Errors
/// As [`loads`].
pub fn total_loads(engine: &Engine, request: &LoadRequest) -> Result<LoadSet, LoadError> {
    let whole = Mechanism::new(engine, request)?;
    Ok(load_set(&whole, request, whole.resolution(), whole.scale()))
}

/// Trace, orders and extremes of some masses.
fn load_set(mechanism: &Mechanism, request: &LoadRequest, resolution: usize, scale: Scale) -> LoadSet {
    let trace = mechanism.trace(request.samples);
    let peaks = mechanism.peaks(&trace, request.peaks, resolution, scale);
    LoadSet { orders: mechanism.orders(), trace, peaks }
}

/// Whether the engine has parts of this kind.
fn has_part(engine: &Engine, part: Part) -> bool {
    match part {
        Part::Rotating => {
            engine.throws.iter().any(|t| t.unbalance != 0.0)
                || engine.cylinders.iter().any(|c| c.rod.big_end_mass != 0.0)
        }
        Part::Reciprocating => !engine.cylinders.is_empty(),
        Part::RodInertia => engine.cylinders.iter().any(|c| c.rod.residual_inertia() != 0.0),
        Part::Counterweights => !engine.counterweights.is_empty(),
        Part::Shafts => !engine.shafts.is_empty(),
    }
}
