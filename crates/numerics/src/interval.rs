//! Intervals: all values that a formula takes while its arguments run through theirs.
//!
//! Rounding is not directed outwards: whoever proves something with intervals leaves room for it, some 1e-15 of the terms.

use crate::jet::Ring;
use std::ops::{Add, Mul, Neg, Sub};

/// All numbers from `low` to `high`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// Least number.
    pub low: f64,
    /// Largest number.
    pub high: f64,
}

impl Interval {
    /// From the least and the largest number.
    pub fn new(low: f64, high: f64) -> Interval {
        Interval { low, high }
    }

    /// Smallest and largest absolute value.
    pub fn sizes(self) -> [f64; 2] {
        let (a, b) = (self.low.abs(), self.high.abs());
        let least = if self.low <= 0.0 && self.high >= 0.0 { 0.0 } else { a.min(b) };
        [least, a.max(b)]
    }
}

impl Ring for Interval {
    fn of(value: f64) -> Interval {
        Interval { low: value, high: value }
    }
    fn times(self, factor: f64) -> Interval {
        let (a, b) = (self.low * factor, self.high * factor);
        Interval { low: a.min(b), high: a.max(b) }
    }
    // Narrower than the product with itself, which takes its factors for independent.
    fn square(self) -> Interval {
        let [least, most] = self.sizes();
        Interval { low: least * least, high: most * most }
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
