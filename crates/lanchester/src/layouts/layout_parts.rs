//! The parts of an engine of which its layouts are made.

use crate::layouts::choices::LayoutChoices;
use crate::layouts::own::OwnLayout;
use crate::layouts::space_error::{LayoutSize, LayoutSpaceError};
use lanchester_model::Engine;
use lanchester_study::explore::{Constraint, Parts};

/// Sizes and masses by their means, with a note where they differ or are assumed.
pub(super) fn parts(
    engine: &Engine,
    choices: &LayoutChoices,
    own: Option<&OwnLayout>,
    spacings: &[f64],
    constraints: &[Constraint],
    notes: &mut Vec<String>,
) -> Result<Parts, LayoutSpaceError> {
    let missing = |size| LayoutSpaceError::Missing { size, engine: engine.name.clone() };
    let needs_webs = constraints.iter().any(|c| matches!(c, Constraint::BearingRoom { .. }));
    let needs_pins = constraints.iter().any(|c| matches!(c, Constraint::PinOverlap { .. }));
    let narrowest = spacings.iter().copied().fold(f64::INFINITY, f64::min);
    let body = engine.crank_body.as_ref();
    let web_distance = match choices.web_distance.or(own.and_then(|own| own.web_distance)) {
        Some(distance) => distance,
        None if needs_webs => return Err(missing(LayoutSize::WebDistance)),
        None => {
            notes.push("webs stand half a spacing apart: the file does not say where they are".to_owned());
            0.5 * narrowest
        }
    };
    let web_thickness = match choices.web_thickness.or(body.map(|body| body.web_thickness)) {
        Some(thickness) => thickness,
        None if needs_webs => return Err(missing(LayoutSize::WebThickness)),
        None => 0.0,
    };
    let pin_diameter = match choices.pin_diameter.or(body.map(|body| body.pin_diameter)) {
        Some(diameter) => diameter,
        None if needs_pins => return Err(missing(LayoutSize::PinDiameter)),
        // Nothing else asks for it.
        None => narrowest,
    };
    let cylinders = &engine.cylinders;
    let known_bore = cylinders.iter().map(|c| c.bore).collect::<Option<Vec<f64>>>();
    let bore = known_bore.map(|bores| averaged("bores", bores.into_iter(), notes));
    if bore.is_none() {
        notes.push("whether neighbouring bores overlap is not checked: the file gives no bore".to_owned());
    }
    if cylinders.iter().any(|c| c.net_offset().abs() > 0.0) {
        notes.push("offsets of cylinders and piston pins are left out: layouts are centred".to_owned());
    }
    if cylinders.iter().any(|c| matches!(c.rod.joint, lanchester_model::RodJoint::Articulated { .. })) {
        notes.push("articulated rods are left out: every rod sits on a crankpin".to_owned());
    }
    let inertias = cylinders.iter().map(|c| c.rod.inertia).collect::<Option<Vec<f64>>>();
    let groups = own.map_or(engine.throws.len(), OwnLayout::groups);
    let unbalances = engine.throws.iter().map(|throw| throw.unbalance);
    let throw_unbalance =
        averaged("unbalances of the throws", unbalances, notes) * engine.throws.len() as f64 / groups as f64;
    Ok(Parts {
        strokes: engine.strokes,
        speed: choices.speed.unwrap_or(engine.speed.highest),
        crank_radius: averaged("crank radii", engine.throws.iter().map(|throw| throw.radius), notes),
        piston_mass: averaged("pistons", cylinders.iter().map(|c| c.piston_mass), notes),
        rod_big_end_mass: averaged(
            "masses at the big ends",
            cylinders.iter().map(|c| c.rod.big_end_mass),
            notes,
        ),
        rod_small_end_mass: averaged(
            "masses at the small ends",
            cylinders.iter().map(|c| c.rod.small_end_mass),
            notes,
        ),
        rod_inertia: inertias.map(|all| averaged("inertias of the rods", all.into_iter(), notes)),
        throw_unbalance,
        web_distance,
        web_thickness,
        pin_diameter,
        end_length: choices.end_length.or(bore).unwrap_or(0.0),
        // Without a bore no two of them overlap.
        bore: bore.unwrap_or(narrowest),
    })
}

/// The mean, noted where the values differ.
fn averaged(what: &str, values: impl Iterator<Item = f64> + Clone, notes: &mut Vec<String>) -> f64 {
    let mean = mean(values.clone());
    if values.clone().any(|value| (value - mean).abs() > 1e-9 * mean.abs()) {
        notes.push(format!("{what} differ in the file: layouts have their mean"));
    }
    mean
}

pub(super) fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for value in values {
        sum += value;
        count += 1.0;
    }
    sum / f64::max(count, 1.0)
}
