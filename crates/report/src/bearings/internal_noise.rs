//! How large the loads of a crankshaft are, so that rounding is told from them.

use crate::kit::rounding::below;
use lanchester_mechanism::{BeamModel, InternalMoments};

/// What counts as nothing.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Noise {
    /// Shear forces and bearing loads up to this [N].
    pub force: f64,
    /// Bending moments up to this [N m].
    pub moment: f64,
}

impl Noise {
    /// Of the largest of all cases.
    pub fn of(cases: &[InternalMoments]) -> Noise {
        let mut noise = Noise::default();
        for shaft in cases.iter().flat_map(|c| &c.crankshafts) {
            for beam in BeamModel::ALL.map(|model| shaft.of(model)) {
                noise.force = noise.force.max(below(beam.peak_shear.value.max(beam.peak_main.value)));
                noise.moment = noise.moment.max(below(beam.peak_moment.value));
            }
        }
        noise
    }
}
