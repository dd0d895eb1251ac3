//! A derivative on both sides.

use num_dual::Dual64;
use serde::Serialize;

/// Share of the derivative of a vector by which its slope is off since its peak is: a place is known to the root of the last digit.
const ROUNDING: f64 = 1e-6;

/// Derivative of an output by an input, in SI units.
///
/// A size that is zero grows whichever way the input goes, and of two equal peaks one may grow while the other falls: there the derivatives
/// on both sides differ. Infinite (`null` in JSON) where the output leaps: a peak between jumps of several pressures at one angle, which part
/// when the input goes however little.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Slope {
    /// For a larger input.
    pub up: f64,
    /// For a smaller input.
    pub down: f64,
}

/// A slope, and how much of it may be rounding: the size of the derivative of all that it is made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Grown {
    pub slope: Slope,
    pub growth: f64,
}

impl Slope {
    /// The same on both sides.
    pub(super) fn of_both(slope: f64) -> Slope {
        Slope { up: slope, down: slope }
    }

    /// One slope where both sides differ by no more than peaks can be placed, or by no more than `rounding`.
    pub(super) fn joined(self, growth: f64, rounding: f64) -> Slope {
        let close = (self.up - self.down).abs() <= ROUNDING * growth + rounding;
        if close { Slope::of_both((self.up + self.down) / 2.0) } else { self }
    }
}

impl Grown {
    /// Of what leaps up whichever way the input goes.
    pub const LEAP: Grown =
        Grown { slope: Slope { up: f64::INFINITY, down: f64::NEG_INFINITY }, growth: 0.0 };

    /// Of what does not change.
    pub const NONE: Grown = Grown { slope: Slope { up: 0.0, down: 0.0 }, growth: 0.0 };

    /// Of a number with its sign.
    pub fn of_number(value: Dual64) -> Grown {
        Grown { slope: Slope::of_both(value.eps), growth: value.eps.abs() }
    }

    /// Of the size of a vector; of one that vanishes the size of its derivative.
    pub fn of_size(parts: &[Dual64], nothing: f64) -> Grown {
        let size = parts.iter().map(|part| part.re * part.re).sum::<f64>().sqrt();
        let growth = parts.iter().map(|part| part.eps * part.eps).sum::<f64>().sqrt();
        if size <= nothing {
            return Grown { slope: Slope { up: growth, down: -growth }, growth };
        }
        let slope = parts.iter().map(|part| part.re * part.eps).sum::<f64>() / size;
        Grown { slope: Slope::of_both(slope), growth }
    }

    /// Of the sum of two outputs.
    pub fn plus(self, other: Grown) -> Grown {
        let slope = Slope { up: self.slope.up + other.slope.up, down: self.slope.down + other.slope.down };
        Grown { slope, growth: self.growth + other.growth }
    }

    /// Of the output times a factor that is not negative.
    pub fn times(self, factor: f64) -> Grown {
        let slope = Slope { up: factor * self.slope.up, down: factor * self.slope.down };
        Grown { slope, growth: factor * self.growth }
    }

    /// Of the negative of an output: what grows for a larger input falls.
    pub fn negative(self) -> Grown {
        Grown { slope: Slope { up: -self.slope.up, down: -self.slope.down }, ..self }
    }

    /// Of the largest of outputs that are equal: the one that grows most, or falls least.
    pub fn of_largest(all: impl IntoIterator<Item = Grown>) -> Grown {
        let largest = |a: Grown, b: Grown| Grown {
            slope: Slope { up: a.slope.up.max(b.slope.up), down: a.slope.down.min(b.slope.down) },
            growth: a.growth.max(b.growth),
        };
        all.into_iter().reduce(largest).unwrap_or(Grown::NONE)
    }
}
