//! What a weight has to do: its unbalance, its web, its direction beside the crankpin.

use lanchester_model::{Counterweight, Engine};
use lanchester_numerics::about_zero;
use std::f64::consts::{PI, TAU};

/// The unbalance that a weight should have [kg m].
pub(crate) fn duty_of(weight: &Counterweight) -> f64 {
    weight.part.as_ref().and_then(|part| part.wanted).unwrap_or(weight.unbalance)
}

/// How far a weight stands from the opposite of its crankpin, without its sign [rad].
pub(crate) fn tilt(engine: &Engine, weight: &Counterweight) -> f64 {
    let Some(web) = web_of(engine, weight) else { return 0.0 };
    let off = weight.angle - engine.throws[web / 2].angle - PI;
    about_zero(off, TAU).abs()
}

/// The web in whose plane a weight stands, counted through all throws.
pub(crate) fn web_of(engine: &Engine, weight: &Counterweight) -> Option<usize> {
    if let Some(part) = &weight.part {
        return part.web;
    }
    let webs = engine.throws.iter().enumerate().flat_map(|(index, throw)| {
        let planes = throw.webs.filter(|_| throw.crankshaft == weight.crankshaft);
        planes.into_iter().flatten().enumerate().map(move |(side, z)| (2 * index + side, z))
    });
    let mut near = webs.filter(|(_, z)| (z - weight.z).abs() < 1e-9);
    // The web between two pins is no place for a shape.
    let shared: Vec<usize> = engine.shared_webs().into_iter().flat_map(|shared| shared.webs()).collect();
    near.next().map(|(web, _)| web).filter(|web| engine.crank_body.is_none() || !shared.contains(web))
}
