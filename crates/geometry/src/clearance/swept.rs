//! Swept circles: balance shafts against each other and against crankshafts, plane by plane.

use super::clearance_model::has_big_end;
use super::error::ClearanceError;
use super::turning_body::{Spindle, TurningBody};
use lanchester_model::{CrankElementForm, Engine};
use lanchester_shape::Point;
use serde::Serialize;

/// Two swept circles that overlap in a plane across the crank: whether what turns in them meets depends on their phases.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SweptOverlap {
    /// Name of the weight of a balance shaft.
    pub weight: String,
    /// What it overlaps: another weight, a counterweight, a web, a crankpin or a big end.
    pub other: String,
    /// Sum of both swept radii less the distance of the axes [m].
    pub depth: f64,
    /// First plane of the overlap [m], from the origin.
    pub from: f64,
    /// Last plane of the overlap [m], from the origin.
    pub to: f64,
}

/// A circle about an axis between two planes.
struct Swept {
    name: String,
    /// Index of the balance shaft; none on crankshafts.
    shaft: Option<usize>,
    axis: Point,
    radius: f64,
    faces: [f64; 2],
}

/// Circles that overlap by less [m] touch: it is rounding.
const TOUCH: f64 = 1e-9;

/// The weights of balance shafts that have a shape, against those of other shafts and against all of the crankshafts: counterweights and
/// webs, crankpins (without a thickness where the engine has no crank body), big ends where the engine has their envelope.
///
/// # Errors
/// Where a web has no outline.
pub fn swept_overlaps(engine: &Engine) -> Result<Vec<SweptOverlap>, ClearanceError> {
    let weights = weights(engine);
    if weights.is_empty() {
        return Ok(Vec::new());
    }
    let cranks = cranks(engine)?;
    let mut found = Vec::new();
    for (number, weight) in weights.iter().enumerate() {
        let shafts = weights[number + 1..].iter().filter(|other| other.shaft != weight.shaft);
        for other in shafts.chain(&cranks) {
            let depth = weight.radius + other.radius - (weight.axis - other.axis).norm();
            let from = weight.faces[0].max(other.faces[0]);
            let to = weight.faces[1].min(other.faces[1]);
            // A pin without a thickness is in one plane alone.
            let is_within = to - from > TOUCH || (other.faces[0] == other.faces[1] && to >= from);
            if depth > TOUCH && is_within {
                let (weight, other) = (weight.name.clone(), other.name.clone());
                found.push(SweptOverlap { weight, other, depth, from, to });
            }
        }
    }
    Ok(found)
}

fn weights(engine: &Engine) -> Vec<Swept> {
    let mut found = Vec::new();
    for (index, shaft) in engine.shafts.iter().enumerate() {
        for (number, weight) in shaft.weights.iter().enumerate() {
            let Some(part) = &weight.part else { continue };
            found.push(Swept {
                name: shaft.weight_name(number),
                shaft: Some(index),
                axis: Point::new(shaft.x, shaft.y),
                radius: part.shape.radius,
                faces: [weight.z - part.length / 2.0, weight.z + part.length / 2.0],
            });
        }
    }
    found
}

fn cranks(engine: &Engine) -> Result<Vec<Swept>, ClearanceError> {
    let swept = |name: String, crankshaft: usize, radius: f64, faces: [f64; 2]| {
        let axis = Spindle::of(engine, crankshaft).axis;
        Swept { name, shaft: None, axis, radius, faces }
    };
    let mut found = Vec::new();
    for body in TurningBody::all(engine)? {
        let plates = body.plates.iter();
        found
            .extend(plates.map(|plate| {
                swept(body.name.clone(), body.crankshaft, plate.farthest().norm(), plate.faces)
            }));
    }
    for (index, throw) in engine.throws.iter().enumerate() {
        let (radius, faces) = match pin(engine, index, throw.crankshaft) {
            Some((diameter, faces)) => (throw.radius + diameter / 2.0, faces),
            None => (throw.radius, [throw.z; 2]),
        };
        found.push(swept(format!("crankpin {}", index + 1), throw.crankshaft, radius, faces));
    }
    if let Some(rod) = engine.envelope.and_then(|envelope| envelope.rod) {
        for (index, cylinder) in engine.cylinders.iter().enumerate().filter(|(_, own)| has_big_end(own)) {
            let throw = &engine.throws[cylinder.throw];
            let faces = [cylinder.z - rod.big_end_width / 2.0, cylinder.z + rod.big_end_width / 2.0];
            let radius = throw.radius + rod.big_end_radius;
            found.push(swept(format!("big end {}", index + 1), throw.crankshaft, radius, faces));
        }
    }
    Ok(found)
}

/// Diameter and faces [m] of the pin of a throw, where the engine has them.
fn pin(engine: &Engine, throw: usize, crankshaft: usize) -> Option<(f64, [f64; 2])> {
    let elements = engine.crank_elements(crankshaft).ok()?;
    elements.into_iter().find_map(|element| match element.form {
        CrankElementForm::Pin { throw: own, bar, .. } if own == throw => Some((bar.diameter, element.faces)),
        _ => None,
    })
}
