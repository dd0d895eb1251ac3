//! What the shape's formulas compute with: numbers, intervals, and either with derivatives.
//!
//! A circular segment is given by half its chord `w` and half its angle `a` within ]0, pi[.

use super::arc;
use lanchester_numerics::Ring;
use std::f64::consts::FRAC_PI_2;

/// Arithmetic that the formulas of the shape need.
pub(super) trait Number: Ring {
    /// Sine of an angle within [0, pi].
    fn sin(self) -> Self;
    /// Sine of an angle within [0, pi] beyond a quarter turn, one before: half the width of an arc over its radius, or over half its chord.
    fn late_sine(self) -> Self;
    /// Tangent of half an angle within [0, pi[: height of a segment over half its chord.
    fn half_tangent(self) -> Self;
    /// Area, first moment about the chord, and polar moment about its middle, of a segment whose chord is 2.
    fn segment(self) -> [Self; 3];
}

impl Number for f64 {
    fn sin(self) -> f64 {
        f64::sin(self)
    }
    fn late_sine(self) -> f64 {
        if self > FRAC_PI_2 { f64::sin(self) } else { 1.0 }
    }
    fn half_tangent(self) -> f64 {
        (self / 2.0).tan()
    }
    fn segment(self) -> [f64; 3] {
        arc::segment(self, 0)
    }
}
