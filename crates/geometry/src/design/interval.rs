//! Intervals: all values that a formula takes while its arguments run through theirs.
//!
//! Rounding is not directed outwards: it is some 1e-15 of the scaled formulas, and the proof leaves
//! [`super::refute::ROUNDING`] for it.

use super::arc;
use super::jet::Base;
use super::number::Number;
use lanchester_numerics::Interval;
use std::f64::consts::FRAC_PI_2;

impl Number for Interval {
    fn sin(self) -> Interval {
        let (a, b) = (self.low.sin(), self.high.sin());
        let top = self.low <= FRAC_PI_2 && self.high >= FRAC_PI_2;
        Interval { low: a.min(b), high: if top { 1.0 } else { a.max(b) } }
    }
    // Falls from one beyond a quarter turn.
    fn late_sine(self) -> Interval {
        Interval { low: self.high.late_sine(), high: self.low.late_sine() }
    }
    fn half_tangent(self) -> Interval {
        Interval { low: self.low.half_tangent(), high: self.high.half_tangent() }
    }
    fn segment(self) -> [Interval; 3] {
        self.segment_by(0)
    }
}

impl Base for Interval {
    fn cos(self) -> Interval {
        Interval { low: self.high.cos(), high: self.low.cos() }
    }
    // Every derivative grows.
    fn segment_by(self, order: usize) -> [Interval; 3] {
        let (low, high) = (arc::segment(self.low, order), arc::segment(self.high, order));
        std::array::from_fn(|k| Interval { low: low[k], high: high[k] })
    }
    fn negative_part(self) -> Interval {
        Interval { low: self.low.min(0.0), high: self.high.min(0.0) }
    }
    fn below_zero(self) -> Interval {
        Interval { low: self.high.below_zero(), high: self.low.below_zero() }
    }
}
