//! The best weight of a balance shaft for an unbalance: the lightest, the shortest, the one of least radius or of least inertia.

mod best;
mod design;
mod inertia;
mod nearest;
mod solids;

pub use best::best_shaft_weight;
pub use design::{ShaftWeightDesign, ShaftWeightOutcome};
pub use nearest::{NearestShaftWeight, ShaftWeightLimit};
pub use solids::shaft_solids;

use lanchester_shape::ShaftWeightShape;
use lanchester_task::ShaftWeightTask;

/// First moments of area [m^3] of weights whose dimensions follow one another.
#[derive(Debug, Clone, Copy)]
struct FirstMoment<'a> {
    task: &'a ShaftWeightTask,
}

impl FirstMoment<'_> {
    fn shape(&self, radius: f64, chord: f64) -> ShaftWeightShape {
        ShaftWeightShape { shaft_radius: self.task.shaft_radius, radius, chord }
    }

    /// First moment of area of a weight [m^3].
    fn of(&self, radius: f64, chord: f64) -> f64 {
        self.shape(radius, chord).moments().first.x
    }

    /// Radius at which a weight with this chord has that first moment [m]: eq. (22.53), solved for it.
    fn radius(&self, first: f64, chord: f64) -> f64 {
        let within = ((self.task.shaft_radius - chord) * (self.task.shaft_radius + chord)).max(0.0);
        chord.hypot((1.5 * first + within.powf(1.5)).cbrt())
    }

    /// Chord of the ranges that is nearest to the axis [m]: of the largest first moment.
    fn nearest_chord(&self) -> f64 {
        0.0f64.clamp(self.task.chord.least, self.task.chord.most)
    }

    /// Chord of the ranges that is farthest from the axis [m]: of the least first moment.
    fn farthest_chord(&self) -> f64 {
        let chord = self.task.chord;
        if chord.least.abs() > chord.most.abs() { chord.least } else { chord.most }
    }
}
