//! A value with its first and second derivatives, exact by the rules of differentiation.

use super::jet::Base;
use super::number::Number;
use super::problem::SHAPE;
use lanchester_numerics::Ring;
use std::ops::{Add, Mul, Neg, Sub};

/// Pairs of variables: the lower triangle of a symmetric matrix, row by row.
pub(super) const PAIRS: usize = SHAPE * (SHAPE + 1) / 2;

/// A value and its derivatives by the variables of the shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Curve<T> {
    pub value: T,
    pub by: [T; SHAPE],
    /// Second derivatives, the lower triangle row by row.
    pub bend: [T; PAIRS],
    /// Which variables it depends on, a bit for each: all other derivatives are zero.
    depends: u8,
}

/// The place of a pair of variables.
pub(super) fn pair(j: usize, k: usize) -> usize {
    let (j, k) = (j.max(k), j.min(k));
    j * (j + 1) / 2 + k
}

impl<T: Base> Curve<T> {
    /// The variable number `at`.
    pub fn variable(value: T, at: usize) -> Self {
        let mut variable = Curve::of(value);
        variable.by[at] = T::of(1.0);
        variable.depends = 1 << at;
        variable
    }

    fn of(value: T) -> Self {
        Curve { value, by: [T::of(0.0); SHAPE], bend: [T::of(0.0); PAIRS], depends: 0 }
    }

    /// With this value, and these derivatives where some of `depends` is.
    fn with(value: T, depends: u8, by: impl Fn(usize) -> T, bend: impl Fn(usize, usize, usize) -> T) -> Self {
        let mut curve = Curve::of(value);
        curve.depends = depends;
        for j in 0..SHAPE {
            if depends >> j & 1 == 0 {
                continue;
            }
            curve.by[j] = by(j);
            for k in 0..=j {
                if depends >> k & 1 == 1 {
                    let at = pair(j, k);
                    curve.bend[at] = bend(at, j, k);
                }
            }
        }
        curve
    }

    /// `f_j f_k`, which is no square of two numbers where `j` is `k`.
    fn product_of_slopes(&self, j: usize, k: usize) -> T {
        if j == k { self.by[j].square() } else { self.by[j] * self.by[k] }
    }

    /// A function of this, from its value and its two derivatives.
    fn chain(&self, value: T, slope: T, bend: T) -> Self {
        let bends = |at: usize, j, k| self.bend[at] * slope + self.product_of_slopes(j, k) * bend;
        Curve::with(value, self.depends, |j| self.by[j] * slope, bends)
    }
}

impl<T: Base> Add for Curve<T> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Curve {
            value: self.value + other.value,
            by: std::array::from_fn(|j| self.by[j] + other.by[j]),
            bend: std::array::from_fn(|at| self.bend[at] + other.bend[at]),
            depends: self.depends | other.depends,
        }
    }
}

impl<T: Base> Sub for Curve<T> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Curve {
            value: self.value - other.value,
            by: std::array::from_fn(|j| self.by[j] - other.by[j]),
            bend: std::array::from_fn(|at| self.bend[at] - other.bend[at]),
            depends: self.depends | other.depends,
        }
    }
}

impl<T: Base> Neg for Curve<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Curve {
            value: -self.value,
            by: self.by.map(|d| -d),
            bend: self.bend.map(|d| -d),
            depends: self.depends,
        }
    }
}

impl<T: Base> Mul for Curve<T> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (f, g) = (&self, &other);
        Curve::with(
            f.value * g.value,
            f.depends | g.depends,
            |j| f.value * g.by[j] + f.by[j] * g.value,
            |at, j, k| {
                let crossed = if j == k {
                    (f.by[j] * g.by[j]).times(2.0)
                } else {
                    f.by[j] * g.by[k] + f.by[k] * g.by[j]
                };
                f.value * g.bend[at] + f.bend[at] * g.value + crossed
            },
        )
    }
}

impl<T: Base> Ring for Curve<T> {
    fn of(value: f64) -> Self {
        Curve::of(T::of(value))
    }
    fn times(self, factor: f64) -> Self {
        Curve {
            value: self.value.times(factor),
            by: self.by.map(|d| d.times(factor)),
            bend: self.bend.map(|d| d.times(factor)),
            depends: self.depends,
        }
    }
    fn square(self) -> Self {
        let slope = self.value.times(2.0);
        self.chain(self.value.square(), slope, T::of(2.0))
    }
}

impl<T: Base> Number for Curve<T> {
    fn sin(self) -> Self {
        let sine = self.value.sin();
        self.chain(sine, self.value.cos(), -sine)
    }
    fn late_sine(self) -> Self {
        let cosine = self.value.cos();
        let bend = -(self.value.sin() * cosine.below_zero());
        self.chain(self.value.late_sine(), cosine.negative_part(), bend)
    }
    fn half_tangent(self) -> Self {
        let tangent = self.value.half_tangent();
        let slope = (T::of(1.0) + tangent.square()).times(0.5);
        self.chain(tangent, slope, tangent * slope)
    }
    fn segment(self) -> [Self; 3] {
        let [values, slopes, bends] = [0, 1, 2].map(|order| self.value.segment_by(order));
        std::array::from_fn(|k| self.chain(values[k], slopes[k], bends[k]))
    }
}
