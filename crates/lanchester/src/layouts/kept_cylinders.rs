//! The space of layouts of an engine whose cylinders, rods and pins stay where they are.

use crate::layouts::choices::{LayoutChoices, none, own_pattern, usual_angles};
use crate::layouts::layout_parts::{mean, parts};
use crate::layouts::space_error::LayoutSpaceError;
use lanchester_model::Engine;
use lanchester_numerics::about_zero;
use lanchester_study::explore::{Arrangement, Banks, Parts, Space, even_angles};
use std::f64::consts::TAU;

/// Angles [rad] and planes [m] closer than this are one.
const SAME: f64 = 1e-9;

/// Throw angles, firing, weights and shafts of `engine`, which is not one bank, or two alike, for this `reason`, with what
/// the user should know of it.
///
/// # Errors
/// [`LayoutSpaceError`] where a size is chosen that stays, or nothing is left to choose.
pub(crate) fn kept_cylinders(
    engine: &Engine,
    choices: &LayoutChoices,
    reason: &str,
) -> Result<(Space, Vec<String>), LayoutSpaceError> {
    let has_webs = engine.throws.iter().all(|throw| throw.webs.is_some());
    let kept = [
        ("the number of cylinders", choices.cylinders.is_some()),
        ("the angle of split pins", choices.split_angles.is_some()),
        ("the stagger of banks", choices.staggers.is_some()),
        ("the spacing", choices.spacings.is_some()),
        ("the crank-to-rod ratio", choices.rod_ratios.is_some()),
        ("the thickness of the webs", choices.web_thickness.is_some()),
        ("the diameter of the crankpins", choices.pin_diameter.is_some()),
        ("the distance of the webs", choices.web_distance.is_some() && has_webs),
    ];
    if let Some(&(choice, _)) = kept.iter().find(|(_, is_chosen)| *is_chosen) {
        let (engine, reason) = (engine.name.clone(), reason.to_owned());
        return Err(LayoutSpaceError::Kept { engine, reason, choice });
    }
    let mut notes = vec![format!("cylinders, rods and pins stay as in the file, since {reason}")];
    let spacing = mean_spacing(engine);
    let webs = engine.throws.iter().find_map(|throw| throw.webs).map(|[front, rear]| rear - front);
    let web_distance = choices.web_distance.or(webs).unwrap_or(0.5 * spacing);
    if choices.web_distance.is_none() && !has_webs {
        notes.push("webs stand half a spacing apart: the file does not say where they are".to_owned());
    }
    let arrangement = Arrangement::of(engine, web_distance).map_err(|error| LayoutSpaceError::Banks {
        engine: engine.name.clone(),
        reason: format!("{reason}, and {error}"),
    })?;
    if engine.throws.len() > arrangement.groups() {
        notes.push("throws whose pistons share a chamber keep their angle from each other".to_owned());
    }
    if engine.crankshafts.len() > 1 {
        notes.push(
            "throws of all crankshafts are permuted; their angles count as crankshaft 1 turns, from its first throw"
                .to_owned(),
        );
    }
    let counterweights = choices.counterweights.clone().unwrap_or_else(|| vec![own_pattern(engine)]);
    let shafts = choices.shafts.clone().unwrap_or_else(|| vec![none()]);
    if arrangement.groups() == 1 && counterweights.len() == 1 && shafts.len() == 1 {
        let throws = if engine.throws.len() == 1 { "one throw" } else { "all throws turn as one" };
        return Err(LayoutSpaceError::OneThrow { throws, engine: engine.name.clone() });
    }
    // Means scale what counts as equal; the loads are those of each cylinder.
    let own = parts(engine, choices, None, &[spacing], &[], &mut Vec::new())?;
    let throw_angles = choices.throw_angles.clone().unwrap_or_else(|| angles_of(&arrangement, engine));
    let space = Space {
        parts: Parts { web_distance, ..own },
        cylinders: engine.cylinders.len(),
        banks: Banks::AsGiven(Box::new(arrangement)),
        throw_angles,
        spacings: vec![spacing],
        rod_ratios: vec![own.crank_radius / mean(engine.cylinders.iter().map(|c| c.rod.length))],
        counterweights,
        shafts,
        firing: !choices.without_firing,
    };
    Ok((space, notes))
}

/// Equal parts of a turn that hold the even firing intervals, and the angles of the engine.
fn angles_of(arrangement: &Arrangement, engine: &Engine) -> Vec<f64> {
    let mut angles = even_angles(usual_angles(arrangement.chambers().len(), engine.strokes));
    for &own in &arrangement.throw_angles {
        if !angles.iter().any(|angle| about_zero(angle - own, TAU).abs() < SAME) {
            angles.push(own);
        }
    }
    angles
}

/// Mean distance of neighbouring throws [m]; of one throw twice the distance of its webs.
fn mean_spacing(engine: &Engine) -> f64 {
    let mut planes: Vec<f64> = engine.throws.iter().map(|throw| throw.z).collect();
    planes.sort_by(f64::total_cmp);
    planes.dedup_by(|later, kept| *later - *kept < SAME);
    match (planes.first(), planes.last()) {
        (Some(first), Some(last)) if planes.len() > 1 => (last - first) / (planes.len() - 1) as f64,
        _ => engine.throws.first().and_then(|t| t.webs).map_or(0.1, |[front, rear]| 2.0 * (rear - front)),
    }
}
