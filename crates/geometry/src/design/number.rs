//! What the shape's formulas compute with: numbers, intervals, and either with derivatives.
//!
//! A circular segment is given by its radius `R`, its half angle `a` within [0, pi].

use crate::circular_segment::excess;
use std::ops::{Add, Mul, Neg, Sub};

/// Arithmetic that the formulas of the shape need.
pub(super) trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// A constant.
    fn of(value: f64) -> Self;
    /// Sine of an angle within [0, pi].
    fn sin(self) -> Self;
    /// Cosine of an angle within [0, pi].
    fn cos(self) -> Self;
    /// `a - sin a cos a`: the area of a segment over the square of its radius.
    fn excess(self) -> Self;
    /// `a/2 - sin a cos^3 a/2 - sin^3 a cos a/6`: its polar moment about the circle's centre over the fourth power.
    fn segment_polar(self) -> Self;
    /// `min(d, 0)^2`.
    fn negative_square(self) -> Self;

    /// Times a constant.
    fn times(self, factor: f64) -> Self {
        self * Self::of(factor)
    }
    /// Its square.
    fn square(self) -> Self {
        self * self
    }
}

impl Number for f64 {
    fn of(value: f64) -> f64 {
        value
    }
    fn sin(self) -> f64 {
        f64::sin(self)
    }
    fn cos(self) -> f64 {
        f64::cos(self)
    }
    fn excess(self) -> f64 {
        excess(self)
    }
    fn segment_polar(self) -> f64 {
        let (s, c) = self.sin_cos();
        self / 2.0 - s * c * (c * c / 2.0 + s * s / 6.0)
    }
    fn negative_square(self) -> f64 {
        self.min(0.0).powi(2)
    }
}
