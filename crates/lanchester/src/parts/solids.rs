//! What of crankshafts and balance shafts goes into a CAD file.

use crate::parts::design::chosen;
use crate::parts::error::CounterweightError;
use lanchester_geometry::crankshaft::crankshaft;
use lanchester_geometry::export::PlacedPart;
use lanchester_geometry::shaft_solids;
use lanchester_model::Engine;

/// The solids of a crankshaft (by index): all of it where the engine has a body, else its counterweights; with names only the
/// counterweights of these names.
///
/// Frame: that of the crankshaft at angle zero, z from the origin of the engine.
///
/// # Errors
/// Where there is no such weight, none is a part, or the crankshaft is no body.
pub fn crankshaft_parts(
    engine: &Engine,
    index: usize,
    names: &[String],
) -> Result<Vec<PlacedPart>, CounterweightError> {
    if names.is_empty() && engine.crank_body.is_some() {
        return Ok(crankshaft(engine, index)?.parts);
    }
    let indices = match names.is_empty() {
        true => (0..engine.counterweights.len()).collect(),
        false => chosen(engine, names)?,
    };
    let parts: Vec<PlacedPart> = indices
        .into_iter()
        .map(|index| &engine.counterweights[index])
        .filter(|weight| weight.crankshaft == index || !names.is_empty())
        .filter_map(|weight| {
            let part = weight.part.as_ref()?;
            Some(PlacedPart::new(&weight.name, part.part.clone()).turned(part.angle).moved(part.z))
        })
        .collect();
    if parts.is_empty() { Err(CounterweightError::NoPart) } else { Ok(parts) }
}

/// The solids of the balance shafts: those of these names, or all whose weights have shapes.
///
/// Frame: that of the engine at `theta = 0`, which is that of crankshaft 1.
///
/// # Errors
/// Where there is no such shaft, or none of its weights has a shape.
pub fn shaft_parts(engine: &Engine, names: &[String]) -> Result<Vec<PlacedPart>, CounterweightError> {
    if let Some(name) = names.iter().find(|name| engine.shafts.iter().all(|shaft| shaft.name != **name)) {
        let known: Vec<String> = engine.shafts.iter().map(|shaft| format!("\"{}\"", shaft.name)).collect();
        return Err(CounterweightError::UnknownShaft { name: name.clone(), known: known.join(", ") });
    }
    let mut parts = Vec::new();
    for shaft in engine.shafts.iter().filter(|shaft| names.is_empty() || names.contains(&shaft.name)) {
        let own = shaft_solids(shaft)?;
        if own.is_empty() && !names.is_empty() {
            return Err(CounterweightError::BareShaft { name: shaft.name.clone() });
        }
        parts.extend(own);
    }
    Ok(parts)
}

/// The solids of an engine: the first crankshaft with the balance shafts around it.
///
/// Frame: that of the engine at `theta = 0`, which is that of crankshaft 1.
///
/// # Errors
/// Where neither has a part.
pub fn engine_parts(engine: &Engine) -> Result<Vec<PlacedPart>, CounterweightError> {
    let shafts = shaft_parts(engine, &[])?;
    let mut parts = match crankshaft_parts(engine, 0, &[]) {
        Err(CounterweightError::NoPart) if !shafts.is_empty() => Vec::new(),
        of_crank => of_crank?,
    };
    parts.extend(shafts);
    Ok(parts)
}

/// What is asked for of an engine: balance shafts of these names alone, else counterweights of these names or a crankshaft (by index), else
/// all of it ([`engine_parts`]).
///
/// # Errors
/// As [`shaft_parts`], [`crankshaft_parts`] and [`engine_parts`].
pub fn chosen_parts(
    engine: &Engine,
    crankshaft: usize,
    counterweights: &[String],
    shafts: &[String],
) -> Result<Vec<PlacedPart>, CounterweightError> {
    if !shafts.is_empty() {
        shaft_parts(engine, shafts)
    } else if crankshaft > 0 || !counterweights.is_empty() {
        crankshaft_parts(engine, crankshaft, counterweights)
    } else {
        engine_parts(engine)
    }
}
