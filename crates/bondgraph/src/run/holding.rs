//! What sticks is held in its place, and lets go: signs by which the functions of [`crate::run::sticking`] stay 0.

use crate::run::compiled::Compiled;
use nalgebra::{DMatrix, DVector};

/// Rounds of signs whose laws are not linear in them.
const ROUNDS: usize = 8;
/// What is left of g' counts as 0 below this share of what one sign makes of it.
const SAME: f64 = 1e-12;
/// Singular values below this share of the largest belong to motions that several share.
const SHARED: f64 = 1e-9;

impl Compiled {
    /// g' of what sticks, with the signs as they are.
    fn drifts(&mut self, t: f64, y: &[f64]) -> DVector<f64> {
        let mut rates = vec![0.0; y.len()];
        self.rates(t, y, &mut rates);
        let Compiled { sticking, inputs, held, work, .. } = self;
        sticking.slopes.run(inputs, held, work, &mut sticking.values);
        let drift = |condition: &usize| -> f64 {
            let slopes = sticking.slopes_of(*condition).unwrap_or_default();
            slopes.iter().map(|(state, at)| sticking.values[*at] * state.map_or(1.0, |k| rates[k])).sum()
        };
        DVector::from_iterator(held.stuck.len(), held.stuck.iter().map(drift))
    }

    /// Sets the signs of what sticks so that it stays; what each sign makes of its own g'.
    fn balance(&mut self, t: f64, y: &[f64]) -> Vec<f64> {
        let stuck = self.held.stuck.clone();
        let mut own = vec![0.0; stuck.len()];
        let mut before = self.drifts(t, y);
        for _ in 0..ROUNDS {
            let mut by_signs = DMatrix::zeros(stuck.len(), stuck.len());
            for (column, condition) in stuck.iter().enumerate() {
                let sign = self.held.signs[*condition];
                let by = if sign > 0.0 { -1.0 } else { 1.0 };
                self.held.signs[*condition] = sign + by;
                by_signs.set_column(column, &((self.drifts(t, y) - &before) / by));
                self.held.signs[*condition] = sign;
            }
            own = by_signs.diagonal().iter().copied().collect();
            let Some(parts) = by_signs.try_svd(true, true, f64::EPSILON, 1000) else { return own };
            let least = SHARED * parts.singular_values.max();
            let Ok(change) = parts.solve(&before, least) else { return own };
            for (condition, change) in stuck.iter().zip(change.iter()) {
                self.held.signs[*condition] -= change;
            }
            before = self.drifts(t, y);
            let is_balanced = |(left, own): (&f64, &f64)| left.abs() <= SAME * own.abs();
            if before.iter().zip(&own).all(is_balanced) {
                break;
            }
        }
        own
    }

    /// The signs of what sticks at a place, if anything does.
    pub(crate) fn hold(&mut self, t: f64, y: &[f64]) {
        if !self.held.stuck.is_empty() {
            self.balance(t, y);
        }
    }

    /// Lets these conditions stick that both sides lead back to; whether one does.
    pub(crate) fn stick(&mut self, conditions: &[usize], t: f64, y: &[f64]) -> bool {
        let mut tried: Vec<usize> = conditions.to_vec();
        tried.retain(|own| self.sticking.slopes_of(*own).is_some() && !self.held.stuck.contains(own));
        if tried.is_empty() {
            return false;
        }
        let sides: Vec<bool> = tried.iter().map(|own| self.held.on[*own]).collect();
        tried.iter().for_each(|own| self.held.stick(*own));
        while !self.held.stuck.is_empty() {
            let own = self.balance(t, y);
            // What its sign does not brake, or what needs the most beyond its friction.
            let excess = |(condition, own): (&usize, &f64)| {
                let sign = self.held.signs[*condition].abs();
                let brakes = *own < 0.0 && sign.is_finite();
                (*condition, if brakes { sign } else { f64::INFINITY })
            };
            let worst = self.held.stuck.iter().zip(&own).map(excess).max_by(|a, b| a.1.total_cmp(&b.1));
            let Some((worst, excess)) = worst.filter(|(_, excess)| *excess >= 1.0) else { break };
            match tried.iter().position(|own| *own == worst) {
                Some(place) => {
                    let side = if excess.is_finite() { self.held.signs[worst] > 0.0 } else { sides[place] };
                    self.held.stuck.retain(|own| *own != worst);
                    self.held.turn(worst, side);
                }
                None => self.give_way(worst, t, y),
            }
        }
        tried.iter().any(|own| self.held.stuck.contains(own))
    }

    /// Lets what sticks go.
    pub(crate) fn give_way(&mut self, condition: usize, t: f64, y: &[f64]) {
        let mut values = vec![0.0; self.held.quantities()];
        self.quantities(t, y, &mut values);
        self.held.give_way(condition, values[condition]);
    }
}
