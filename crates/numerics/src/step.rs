//! One accepted step, with the solution between its ends.

use crate::quadrature::{GAUSS_4, unit_points};
use crate::radau_table::{C1, C2};

/// One accepted step. Where an event was located within, it ends there.
#[derive(Debug, Clone, Copy)]
pub struct Step<'a> {
    /// Place of its start.
    pub from: f64,
    /// Place of its end.
    pub to: f64,
    /// State at its start.
    pub start: &'a [f64],
    /// State at its end.
    pub end: &'a [f64],
    /// Length of the step of the interpolant, which an event may have cut.
    pub(crate) length: f64,
    pub(crate) interpolant: Interpolant<'a>,
}

/// Coefficients of the solution within a step.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Interpolant<'a> {
    /// None was asked for: linear between the ends.
    None,
    /// Seven coefficients of the nested polynomial of DOP853, one row of all components each.
    Nested(&'a [f64]),
    /// Increments at the three places of Radau IIA, one row of all components each.
    Collocation(&'a [f64]),
}

impl Step<'_> {
    /// State at `t` within the step.
    pub fn at(&self, t: f64, state: &mut [f64]) {
        let Interpolant::Nested(rows) = self.interpolant else {
            state.iter_mut().enumerate().for_each(|(i, value)| *value = self.component(i, t));
            return;
        };
        if t == self.to {
            state.copy_from_slice(self.end);
            return;
        }
        let n = self.start.len();
        let x = (t - self.from) / self.length;
        state.fill(0.0);
        for row in (0..7).rev() {
            let factor = if row % 2 == 0 { x } else { 1.0 - x };
            for (value, own) in state.iter_mut().zip(&rows[row * n..(row + 1) * n]) {
                *value = (*value + own) * factor;
            }
        }
        state.iter_mut().zip(self.start).for_each(|(value, start)| *value += start);
    }

    /// Shows `add` places, weights and states of the solution: four Gauss points in each of equal pieces of the step that are no longer than `longest`. Sums of
    /// weight times a function of the solution are its integral over the step. The points lie between those at which Radau IIA holds the equations, so that an
    /// integral by them checks the solution.
    pub fn gauss_points(&self, longest: f64, mut add: impl FnMut(f64, f64, &[f64])) {
        let length = self.to - self.from;
        let pieces = (length.abs() / longest).ceil().max(1.0);
        let mut state = vec![0.0; self.start.len()];
        for piece in 0..pieces as usize {
            for (place, weight) in unit_points(&GAUSS_4) {
                let t = self.from + length * (piece as f64 + place) / pieces;
                self.at(t, &mut state);
                add(t, length / pieces * weight, &state);
            }
        }
    }

    /// Component `i` at `t` within the step.
    pub fn component(&self, i: usize, t: f64) -> f64 {
        let n = self.start.len();
        if t == self.to {
            return self.end[i];
        }
        let x = (t - self.from) / self.length;
        match self.interpolant {
            Interpolant::None => {
                let share = (t - self.from) / (self.to - self.from);
                self.start[i] + share * (self.end[i] - self.start[i])
            }
            Interpolant::Nested(rows) => {
                let mut value = 0.0;
                for row in (0..7).rev() {
                    value += rows[row * n + i];
                    value *= if row % 2 == 0 { x } else { 1.0 - x };
                }
                self.start[i] + value
            }
            Interpolant::Collocation(rows) => {
                let weights = collocation_weights(x);
                self.start[i] + (0..3).map(|row| weights[row] * rows[row * n + i]).sum::<f64>()
            }
        }
    }
}

/// Lagrange's polynomials at `x` for the places c1, c2, 1 where the increment at 0 is zero.
pub(crate) fn collocation_weights(x: f64) -> [f64; 3] {
    let at = |c: f64, d: f64, e: f64| x * (x - d) * (x - e) / (c * (c - d) * (c - e));
    [at(C1, C2, 1.0), at(C2, C1, 1.0), at(1.0, C1, C2)]
}
