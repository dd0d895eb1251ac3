//! How far inputs go.

use super::quantity::Measure;

/// How far an input goes either way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Amount {
    /// A share of its nominal value [1].
    Share(f64),
    /// So much, in its SI unit.
    Absolute(f64),
}

impl Amount {
    /// Where nobody says: 1 % of a size or a factor, 1 mm of a place, 1 degree of a direction.
    pub fn standard(measure: Measure) -> Amount {
        match measure {
            Measure::Mass
            | Measure::Length
            | Measure::Unbalance
            | Measure::Inertia
            | Measure::BodyMass
            | Measure::BodyInertia
            | Measure::Speed
            | Measure::Factor => Amount::Share(0.01),
            Measure::Place => Amount::Absolute(1e-3),
            Measure::Angle => Amount::Absolute(1f64.to_radians()),
        }
    }

    /// How far it goes either way of `nominal`, in its SI unit; a share of what has no size is taken of 1.
    pub(super) fn half_width(self, nominal: Option<f64>) -> f64 {
        match self {
            Amount::Absolute(amount) => amount,
            Amount::Share(share) => share * nominal.filter(|size| *size != 0.0).unwrap_or(1.0).abs(),
        }
    }
}
