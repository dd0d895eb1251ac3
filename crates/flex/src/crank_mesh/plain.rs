//! A crankshaft without the chamfers of its counterweights, which are not meshed.

use crate::FlexError;
use crate::crank_mesh::segment::refuse;
use lanchester_geometry::crankshaft::{CrankshaftBody, crankshaft};
use lanchester_model::Engine;
use lanchester_shape::Part;

/// The body of crankshaft `index` without chamfers, and what that changes, in words.
///
/// # Errors
/// [`FlexError::Crankshaft`] where the file does not say enough.
pub(super) fn plain_body(engine: &Engine, index: usize) -> Result<(CrankshaftBody, Vec<String>), FlexError> {
    let exact = crankshaft(engine, index)?;
    let mut plain = engine.clone().into_parts();
    let mut names = Vec::new();
    for weight in plain.counterweights.iter_mut().filter(|weight| weight.crankshaft == index) {
        let Some(own) = &mut weight.part else { continue };
        if own.part.chamfers().is_empty() {
            continue;
        }
        own.part = without_chamfers(&own.part)
            .map_err(|source| refuse(&weight.name, source.to_string(), "leave its chamfers out"))?;
        names.push(weight.name.clone());
    }
    if names.is_empty() {
        return Ok((exact, Vec::new()));
    }
    let plain = Engine::new(plain).map_err(|faults| {
        let fault = faults.first().map_or_else(String::new, ToString::to_string);
        refuse(&names.join(", "), fault, "leave the chamfers out")
    })?;
    let body = crankshaft(&plain, index)?;
    let unbalance = (body.unbalance.unbalance - exact.unbalance.unbalance).norm();
    let words = format!(
        "chamfers of {} (with them: mass {:.4} kg less, unbalance by {:.4} kg mm other, polar inertia {:.3e} kg m2 less)",
        names.join(", "),
        body.mass.mass - exact.mass.mass,
        1e3 * unbalance,
        body.polar_inertia - exact.polar_inertia,
    );
    Ok((body, vec![words]))
}

fn without_chamfers(part: &Part) -> Result<Part, lanchester_shape::GeometryError> {
    let [front, rear] = part.faces();
    let plain = Part::new(part.outline().clone(), part.thickness(), part.density())?.at((front + rear) / 2.0);
    part.inserts().iter().try_fold(plain, |plain, insert| plain.with_insert(*insert))
}
