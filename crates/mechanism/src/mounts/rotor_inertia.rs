//! Angular momentum of all that turns in the block, from the inertia of its parts (book, eq. 27.12).

use lanchester_model::{Engine, RotatingBody};

/// Angular momentum of all that turns, relative to the block, over the speed of crankshaft 1: `SUM rho J` [kg m^2], of every rotor whose polar inertia is known.
///
/// `crankshafts`: inertia of all crankshafts as seen at crankshaft 1, in equal parts to each; by default that of the file.
pub fn rotor_inertia_about_z(engine: &Engine, crankshafts: Option<f64>) -> f64 {
    let wheel = engine.flywheel.as_ref();
    let flywheel = wheel.and_then(|wheel| wheel.inertia).unwrap_or(0.0);
    let seen = crankshafts.or(wheel.and_then(|wheel| wheel.crankshaft_inertia)).unwrap_or(0.0);
    let ratios = || engine.crankshafts.iter().map(|shaft| shaft.ratio.value());
    let squares: f64 = ratios().map(|ratio| ratio * ratio).sum();
    let crankshafts = if squares > 0.0 { seen * ratios().sum::<f64>() / squares } else { 0.0 };
    let bodies = engine.rotating_bodies(&[]);
    let geared = bodies.iter().filter(|body| body.is_geared()).filter_map(RotatingBody::momentum);
    flywheel + crankshafts + geared.sum::<f64>()
}
