//! What stands in the way of a shaft's weight: for each limit alone, the nearest value with which there is one.

use super::FirstMoment;
use lanchester_numerics::last_holding;
use lanchester_shape::plausible_density;
use lanchester_task::ShaftWeightTask;
use serde::Serialize;

/// A limit of a task that would have to give way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ShaftWeightLimit {
    /// Largest radius [m].
    LargestRadius,
    /// Least radius [m].
    LeastRadius,
    /// Largest length [m].
    LargestLength,
    /// Least length [m].
    LeastLength,
    /// Largest distance of the chord from the axis [m].
    LargestChord,
    /// Least distance of the chord from the axis [m].
    LeastChord,
    /// Diameter of the shaft [m], which would have to be less.
    ShaftDiameter,
    /// Density [kg/m^3], which would have to be more.
    Density,
}

/// A limit with the value at which there is a weight.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct NearestShaftWeight {
    /// Which limit.
    pub limit: ShaftWeightLimit,
    /// Its value in the task [SI].
    pub asked: f64,
    /// The nearest with which there is a weight [SI].
    pub nearest: f64,
}

/// Where even the largest weight of the ranges has too little.
pub(super) fn for_more(unbalance: f64, task: &ShaftWeightTask) -> Vec<NearestShaftWeight> {
    let first = FirstMoment { task };
    let chord = first.nearest_chord();
    let largest = first.of(task.radius.most, chord);
    let needed = unbalance / (task.density * task.length.most);
    let mut found = vec![
        near(ShaftWeightLimit::LargestRadius, task.radius.most, first.radius(needed, chord)),
        near(ShaftWeightLimit::LargestLength, task.length.most, unbalance / (task.density * largest)),
    ];
    if chord != 0.0 && first.of(task.radius.most, 0.0) >= needed {
        let nearest = last_holding(|chord| first.of(task.radius.most, chord) >= needed, 0.0, chord);
        let limit = if chord > 0.0 { ShaftWeightLimit::LeastChord } else { ShaftWeightLimit::LargestChord };
        found.push(near(limit, chord, nearest));
    }
    // What is left for the shaft of the moment of the whole disc's segment: eq. (22.53).
    let segment = ((task.radius.most - chord) * (task.radius.most + chord)).powf(1.5) - 1.5 * needed;
    let radius = chord.hypot(segment.max(0.0).cbrt());
    if segment > 0.0 && radius > task.chord.most && radius < task.shaft_radius {
        found.push(near(ShaftWeightLimit::ShaftDiameter, 2.0 * task.shaft_radius, 2.0 * radius));
    }
    let density = unbalance / (task.length.most * largest);
    if plausible_density(density).is_ok() {
        found.push(near(ShaftWeightLimit::Density, task.density, density));
    }
    found
}

/// Where even the smallest weight of the ranges has too much.
pub(super) fn for_less(unbalance: f64, task: &ShaftWeightTask) -> Vec<NearestShaftWeight> {
    let first = FirstMoment { task };
    let chord = first.farthest_chord();
    let least = task.radius.least;
    let needed = unbalance / (task.density * task.length.least);
    let mut found = vec![near(
        ShaftWeightLimit::LeastLength,
        task.length.least,
        unbalance / (task.density * first.of(least, chord)),
    )];
    let radius = first.radius(needed, chord);
    if radius > task.shaft_radius {
        found.push(near(ShaftWeightLimit::LeastRadius, least, radius));
    }
    // Just short of where the weight has no hold on its shaft.
    let outermost = task.shaft_radius.next_down();
    if first.of(least, outermost) <= needed {
        let nearest = last_holding(|chord| first.of(least, chord) <= needed, outermost, task.chord.most);
        found.push(near(ShaftWeightLimit::LargestChord, task.chord.most, nearest));
    }
    found
}

fn near(limit: ShaftWeightLimit, asked: f64, nearest: f64) -> NearestShaftWeight {
    NearestShaftWeight { limit, asked, nearest }
}
