//! Intervals: all values that a formula takes while its arguments run through theirs.
//!
//! Rounding is not directed outwards: it is some 1e-15 of the scaled formulas, and the proof leaves
//! [`super::refute::ROUNDING`] for it.

use super::arc;
use super::jet::Base;
use super::number::Number;
use std::f64::consts::FRAC_PI_2;
use std::ops::{Add, Mul, Neg, Sub};

/// All numbers from `low` to `high`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Interval {
    pub low: f64,
    pub high: f64,
}

impl Interval {
    pub fn new(low: f64, high: f64) -> Interval {
        Interval { low, high }
    }

    /// Smallest and largest absolute value.
    fn sizes(self) -> [f64; 2] {
        let (a, b) = (self.low.abs(), self.high.abs());
        let least = if self.low <= 0.0 && self.high >= 0.0 { 0.0 } else { a.min(b) };
        [least, a.max(b)]
    }
}

impl Add for Interval {
    type Output = Interval;
    fn add(self, other: Interval) -> Interval {
        Interval { low: self.low + other.low, high: self.high + other.high }
    }
}

impl Sub for Interval {
    type Output = Interval;
    fn sub(self, other: Interval) -> Interval {
        Interval { low: self.low - other.high, high: self.high - other.low }
    }
}

impl Neg for Interval {
    type Output = Interval;
    fn neg(self) -> Interval {
        Interval { low: -self.high, high: -self.low }
    }
}

impl Mul for Interval {
    type Output = Interval;
    fn mul(self, other: Interval) -> Interval {
        if self.low >= 0.0 && other.low >= 0.0 {
            return Interval { low: self.low * other.low, high: self.high * other.high };
        }
        let (a, b) = (self.low * other.low, self.low * other.high);
        let (c, d) = (self.high * other.low, self.high * other.high);
        Interval { low: a.min(b).min(c.min(d)), high: a.max(b).max(c.max(d)) }
    }
}

impl Number for Interval {
    fn of(value: f64) -> Interval {
        Interval { low: value, high: value }
    }
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
    fn times(self, factor: f64) -> Interval {
        let (a, b) = (self.low * factor, self.high * factor);
        Interval { low: a.min(b), high: a.max(b) }
    }
    fn square(self) -> Interval {
        let [least, most] = self.sizes();
        Interval { low: least * least, high: most * most }
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
