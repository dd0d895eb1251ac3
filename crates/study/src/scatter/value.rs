//! Nominal values with their deviations.

use crate::scatter::coefficients::Span;
use crate::scatter::tolerance::Variable;
use crate::scatter::turned::turned;
use lanchester_numerics::{ComplexLanes, Lanes};
use lanchester_task::{Tolerance, Varied};

/// A nominal value with its deviations.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Value {
    pub nominal: f64,
    /// Places of the variables that sum to its deviation.
    pub deviations: Vec<u32>,
    /// Largest sum of the deviations.
    pub half: f64,
}

impl Value {
    /// A value without deviations.
    pub fn fixed(nominal: f64) -> Value {
        Value { nominal, ..Value::default() }
    }

    #[inline]
    pub fn at(&self, deviations: &[Lanes]) -> Lanes {
        let total = sum(&self.deviations, deviations);
        Lanes::each(|i| self.nominal + total[i])
    }

    /// `e^{i value}` of an angle.
    #[inline]
    pub fn direction(&self, deviations: &[Lanes]) -> ComplexLanes {
        let (sin, cos) = self.nominal.sin_cos();
        turned(cos, sin, &sum(&self.deviations, deviations))
    }

    pub fn span(&self) -> [f64; 2] {
        [self.nominal - self.half, self.nominal + self.half]
    }

    /// Largest absolute value.
    pub fn largest(&self) -> f64 {
        self.nominal.abs() + self.half
    }

    /// Range of this over `length`.
    pub fn over(&self, length: &Value) -> Span {
        let ends = self.span();
        let all = ends.into_iter().flat_map(|v| length.span().into_iter().map(move |l| v / l));
        let (low, high) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        let varies = self.half > 0.0 || (length.half > 0.0 && self.nominal != 0.0);
        let half = if varies { 0.5 * (high - low) } else { 0.0 };
        Span { middle: 0.5 * (low + high), half }
    }
}

/// Sum of some variables.
#[inline]
fn sum(places: &[u32], deviations: &[Lanes]) -> Lanes {
    let mut total = Lanes::ZERO;
    for &place in places {
        let one = &deviations[place as usize];
        total = Lanes::each(|i| total[i] + one[i]);
    }
    total
}

/// The tolerances of an engine, of which each part takes its own.
#[derive(Clone, Copy)]
pub(crate) struct Deviations<'a> {
    pub tolerances: &'a [Tolerance],
    pub variables: &'a [Variable],
}

impl Deviations<'_> {
    /// A quantity of a part with its deviations.
    pub fn value(&self, quantity: Varied, part: usize, nominal: f64) -> Value {
        let mut value = Value::fixed(nominal);
        for (place, variable) in self.variables.iter().enumerate() {
            let own = variable.part.is_none_or(|own| own == part);
            if own && self.tolerances[variable.tolerance].quantity == quantity {
                value.deviations.push(place as u32);
                value.half += variable.half_width;
            }
        }
        value
    }
}
