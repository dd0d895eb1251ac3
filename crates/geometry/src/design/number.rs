//! What the shape's formulas compute with: numbers, intervals, and either with derivatives.
//!
//! A circular segment is given by half its chord `w > 0` and the distance `d` of the chord from the circle's centre, negative for more
//! than half a disc; its half angle is `a = atan2(w, d)`, its radius `hypot(w, d)`.

use crate::circular_segment::excess;
use std::ops::{Add, Mul, Neg, Sub};

/// Arithmetic that the formulas of the shape need.
pub(super) trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// A constant.
    fn of(value: f64) -> Self;
    /// Radius `sqrt(w^2 + d^2)`.
    fn radius(w: Self, d: Self) -> Self;
    /// Area of the segment, `R^2 a - w d`.
    fn segment(w: Self, d: Self) -> Self;
    /// Polar moment of the segment about the circle's centre, `R^4 a/2 - w d^3/2 - w^3 d/6`.
    fn segment_polar(w: Self, d: Self) -> Self;
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
    fn radius(w: f64, d: f64) -> f64 {
        w.hypot(d)
    }
    fn segment(w: f64, d: f64) -> f64 {
        (w * w + d * d) * excess(w.atan2(d))
    }
    fn segment_polar(w: f64, d: f64) -> f64 {
        let square = w * w + d * d;
        square * square * w.atan2(d) / 2.0 - w * d * (d * d / 2.0 + w * w / 6.0)
    }
    fn negative_square(self) -> f64 {
        self.min(0.0).powi(2)
    }
}
