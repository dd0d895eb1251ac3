//! A value with its first derivatives, exact by the rules of differentiation.

use std::ops::{Add, Mul, Neg, Sub};

/// What a [`Jet`] is made of: plain numbers, or all numbers of an interval.
pub trait Ring:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// A constant.
    fn of(value: f64) -> Self;
    /// Times a constant.
    fn times(self, factor: f64) -> Self {
        self * Self::of(factor)
    }
    /// Its square.
    fn square(self) -> Self {
        self * self
    }
}

impl Ring for f64 {
    fn of(value: f64) -> f64 {
        value
    }
}

/// A value and its derivatives by `N` variables.
///
/// ```
/// use lanchester_numerics::{Interval, Jet};
/// // x y - y at x = 3, y = 2: 4, with the derivatives 2 and 2.
/// let (x, y) = (Jet::<f64, 2>::variable(3.0, 0), Jet::variable(2.0, 1));
/// assert_eq!(x * y - y, Jet { value: 4.0, by: [2.0, 2.0] });
/// // All values and slopes of x x while x runs from 1 to 2.
/// let x = Jet::<Interval, 1>::variable(Interval::new(1.0, 2.0), 0);
/// assert_eq!(x * x, Jet { value: Interval::new(1.0, 4.0), by: [Interval::new(2.0, 4.0)] });
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jet<T, const N: usize> {
    /// The value.
    pub value: T,
    /// Its derivative by each variable.
    pub by: [T; N],
}

impl<T: Ring, const N: usize> Jet<T, N> {
    /// The variable number `at`.
    pub fn variable(value: T, at: usize) -> Self {
        let mut by = [T::of(0.0); N];
        by[at] = T::of(1.0);
        Jet { value, by }
    }

    /// A function of this, from its value and its derivative.
    pub fn chain(self, value: T, slope: T) -> Self {
        Jet { value, by: self.by.map(|d| d * slope) }
    }
}

impl<T: Ring, const N: usize> Ring for Jet<T, N> {
    fn of(value: f64) -> Self {
        Jet { value: T::of(value), by: [T::of(0.0); N] }
    }
    fn times(self, factor: f64) -> Self {
        Jet { value: self.value.times(factor), by: self.by.map(|d| d.times(factor)) }
    }
    fn square(self) -> Self {
        let slope = self.value.times(2.0);
        Jet { value: self.value.square(), by: self.by.map(|d| d * slope) }
    }
}

impl<T: Ring, const N: usize> Add for Jet<T, N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Jet { value: self.value + other.value, by: std::array::from_fn(|i| self.by[i] + other.by[i]) }
    }
}

impl<T: Ring, const N: usize> Sub for Jet<T, N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Jet { value: self.value - other.value, by: std::array::from_fn(|i| self.by[i] - other.by[i]) }
    }
}

impl<T: Ring, const N: usize> Neg for Jet<T, N> {
    type Output = Self;
    fn neg(self) -> Self {
        Jet { value: -self.value, by: self.by.map(|d| -d) }
    }
}

impl<T: Ring, const N: usize> Mul for Jet<T, N> {
    type Output = Self;
    #[allow(clippy::suspicious_arithmetic_impl, reason = "the derivative of a product is a sum")]
    fn mul(self, other: Self) -> Self {
        Jet {
            value: self.value * other.value,
            by: std::array::from_fn(|i| self.value * other.by[i] + self.by[i] * other.value),
        }
    }
}
