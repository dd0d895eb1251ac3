//! A value with its first derivatives, exact by the rules of differentiation.

use super::arc;
use super::number::Number;
use std::ops::{Add, Mul, Neg, Sub};

/// A value and its derivatives by `N` variables.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Jet<T, const N: usize> {
    pub value: T,
    pub by: [T; N],
}

/// What a jet is made of: it can be differentiated.
pub(super) trait Base: Number {
    /// Cosine of an angle within [0, pi].
    fn cos(self) -> Self;
    /// Derivatives of [`Number::segment`] by the angle, of an order from 0 to 2.
    fn segment_by(self, order: usize) -> [Self; 3];
    /// `min(d, 0)`.
    fn negative_part(self) -> Self;
    /// One below zero, zero above: the derivative of [`Base::negative_part`].
    fn below_zero(self) -> Self;
}

impl Base for f64 {
    fn cos(self) -> f64 {
        f64::cos(self)
    }
    fn segment_by(self, order: usize) -> [f64; 3] {
        arc::segment(self, order)
    }
    fn negative_part(self) -> f64 {
        self.min(0.0)
    }
    fn below_zero(self) -> f64 {
        f64::from(u8::from(self < 0.0))
    }
}

impl<T: Base, const N: usize> Jet<T, N> {
    /// The variable number `at`.
    pub fn variable(value: T, at: usize) -> Self {
        let mut by = [T::of(0.0); N];
        by[at] = T::of(1.0);
        Jet { value, by }
    }

    /// A function of this, from its value and its derivative.
    fn chain(self, value: T, slope: T) -> Self {
        Jet { value, by: self.by.map(|d| d * slope) }
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
    #[allow(clippy::suspicious_arithmetic_impl, reason = "the derivative of a product is a sum")]
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
    fn sin(self) -> Self {
        self.chain(self.value.sin(), self.value.cos())
    }
    fn late_sine(self) -> Self {
        self.chain(self.value.late_sine(), self.value.cos().negative_part())
    }
    fn half_tangent(self) -> Self {
        let tangent = self.value.half_tangent();
        self.chain(tangent, (T::of(1.0) + tangent.square()).times(0.5))
    }
    fn segment(self) -> [Self; 3] {
        let (values, slopes) = (self.value.segment_by(0), self.value.segment_by(1));
        std::array::from_fn(|k| self.chain(values[k], slopes[k]))
    }
    fn times(self, factor: f64) -> Self {
        Jet { value: self.value.times(factor), by: self.by.map(|d| d.times(factor)) }
    }
    fn square(self) -> Self {
        let slope = self.value.times(2.0);
        Jet { value: self.value.square(), by: self.by.map(|d| d * slope) }
    }
}
