//! Intervals: all values that a formula takes while its arguments run through theirs.
//!
//! Rounding is not directed outwards: it is some 1e-15 of the scaled formulas, and the proof leaves
//! [`super::refute::ROUNDING`] for it.

use super::number::Number;
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
    fn radius(w: Interval, d: Interval) -> Interval {
        let ([w0, w1], [d0, d1]) = (w.sizes(), d.sizes());
        Interval { low: w0.hypot(d0), high: w1.hypot(d1) }
    }
    // Derivatives 2 w a and 2 (d a - w): it grows with w and shrinks with d.
    fn segment(w: Interval, d: Interval) -> Interval {
        Interval { low: f64::segment(w.low, d.high), high: f64::segment(w.high, d.low) }
    }
    // It grows with w; with d by no more than the derivative at the ends of the range of angles allows.
    fn segment_polar(w: Interval, d: Interval) -> Interval {
        let middle = (d.low + d.high) / 2.0;
        let slope = super::jet::polar_slope(w, d);
        let spread = (slope * Interval { low: d.low - middle, high: d.high - middle }).sizes()[1];
        Interval {
            low: f64::segment_polar(w.low, middle) - spread,
            high: f64::segment_polar(w.high, middle) + spread,
        }
    }
    fn negative_square(self) -> Interval {
        Interval { low: self.high.negative_square(), high: self.low.negative_square() }
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
