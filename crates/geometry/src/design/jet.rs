//! A value with its first derivatives, exact by the rules of differentiation.

use super::interval::Interval;
use super::number::Number;
use std::ops::{Add, Mul, Neg, Sub};

/// A value and its derivatives by `N` variables.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Jet<T, const N: usize> {
    pub value: T,
    pub by: [T; N],
}

/// What a jet is made of: what the derivatives of the segment need.
pub(super) trait Base: Number {
    /// Half angle `atan2(w, d)` of a segment.
    fn half_angle(w: Self, d: Self) -> Self;
    /// One over a positive number.
    fn inverse(self) -> Self;
    /// `min(d, 0)`.
    fn negative_part(self) -> Self;
    /// One below zero, zero above: the derivative of [`Base::negative_part`].
    fn below_zero(self) -> Self;
}

impl Base for f64 {
    fn half_angle(w: f64, d: f64) -> f64 {
        w.atan2(d)
    }
    fn inverse(self) -> f64 {
        1.0 / self
    }
    fn negative_part(self) -> f64 {
        self.min(0.0)
    }
    fn below_zero(self) -> f64 {
        f64::from(u8::from(self < 0.0))
    }
}

impl Base for Interval {
    // It shrinks with d, and changes with w in the sense of the sign of d.
    fn half_angle(w: Interval, d: Interval) -> Interval {
        let low = w.low.atan2(d.high).min(w.high.atan2(d.high));
        let high = w.low.atan2(d.low).max(w.high.atan2(d.low));
        Interval { low, high }
    }
    fn inverse(self) -> Interval {
        Interval { low: 1.0 / self.high, high: 1.0 / self.low }
    }
    fn negative_part(self) -> Interval {
        Interval { low: self.low.min(0.0), high: self.high.min(0.0) }
    }
    fn below_zero(self) -> Interval {
        Interval { low: self.high.below_zero(), high: self.low.below_zero() }
    }
}

impl<T: Base, const N: usize> Base for Jet<T, N> {
    fn half_angle(w: Self, d: Self) -> Self {
        let inverse = (w.value.square() + d.value.square()).inverse();
        let angle = T::half_angle(w.value, d.value);
        Jet::chain(w, d, angle, d.value * inverse, -(w.value * inverse))
    }
    fn inverse(self) -> Self {
        let inverse = self.value.inverse();
        let slope = -inverse.square();
        Jet { value: inverse, by: self.by.map(|d| d * slope) }
    }
    fn negative_part(self) -> Self {
        let slope = self.value.below_zero();
        Jet { value: self.value.negative_part(), by: self.by.map(|d| d * slope) }
    }
    fn below_zero(self) -> Self {
        Jet { value: self.value.below_zero(), by: [T::of(0.0); N] }
    }
}

/// Derivative of [`Number::segment_polar`] by `d`: `2 (a d R^2 - w d^2 - w^3/3)`. The outer circle moves out with `d`, the chord
/// moves in.
pub(super) fn polar_slope<T: Base>(w: T, d: T) -> T {
    let square = w.square() + d.square();
    (T::half_angle(w, d) * d * square - w * d.square() - (w.square() * w).times(1.0 / 3.0)).times(2.0)
}

impl<T: Base, const N: usize> Jet<T, N> {
    /// The variable number `at`.
    pub fn variable(value: T, at: usize) -> Self {
        let mut by = [T::of(0.0); N];
        by[at] = T::of(1.0);
        Jet { value, by }
    }

    /// A function of two jets, from its value and its derivatives.
    fn chain(w: Self, d: Self, value: T, by_w: T, by_d: T) -> Self {
        Jet { value, by: std::array::from_fn(|i| w.by[i] * by_w + d.by[i] * by_d) }
    }
}

impl<T: Base, const N: usize> Add for Jet<T, N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Jet { value: self.value + other.value, by: std::array::from_fn(|i| self.by[i] + other.by[i]) }
    }
}

impl<T: Base, const N: usize> Sub for Jet<T, N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Jet { value: self.value - other.value, by: std::array::from_fn(|i| self.by[i] - other.by[i]) }
    }
}

impl<T: Base, const N: usize> Neg for Jet<T, N> {
    type Output = Self;
    fn neg(self) -> Self {
        Jet { value: -self.value, by: self.by.map(|d| -d) }
    }
}

impl<T: Base, const N: usize> Mul for Jet<T, N> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Jet {
            value: self.value * other.value,
            by: std::array::from_fn(|i| self.value * other.by[i] + self.by[i] * other.value),
        }
    }
}

impl<T: Base, const N: usize> Number for Jet<T, N> {
    fn of(value: f64) -> Self {
        Jet { value: T::of(value), by: [T::of(0.0); N] }
    }
    fn radius(w: Self, d: Self) -> Self {
        let radius = T::radius(w.value, d.value);
        let inverse = radius.inverse();
        Self::chain(w, d, radius, w.value * inverse, d.value * inverse)
    }
    fn segment(w: Self, d: Self) -> Self {
        let a = T::half_angle(w.value, d.value);
        let by_d = (d.value * a - w.value).times(2.0);
        Self::chain(w, d, T::segment(w.value, d.value), (w.value * a).times(2.0), by_d)
    }
    fn segment_polar(w: Self, d: Self) -> Self {
        let square = w.value.square() + d.value.square();
        let by_w = (T::half_angle(w.value, d.value) * square * w.value).times(2.0);
        Self::chain(w, d, T::segment_polar(w.value, d.value), by_w, polar_slope(w.value, d.value))
    }
    fn negative_square(self) -> Self {
        let slope = self.value.negative_part().times(2.0);
        Jet { value: self.value.negative_square(), by: self.by.map(|d| d * slope) }
    }
    fn times(self, factor: f64) -> Self {
        Jet { value: self.value.times(factor), by: self.by.map(|d| d.times(factor)) }
    }
    fn square(self) -> Self {
        let slope = self.value.times(2.0);
        Jet { value: self.value.square(), by: self.by.map(|d| d * slope) }
    }
}
