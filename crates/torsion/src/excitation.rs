//! Torques on the stations by order, with their phases.
//!
//! ```text
//! T(theta) = T_0 + Re SUM T_k e^(i n_k theta),    n_k = k n_1,   k = 1 ..                                                    (50.5)
//! ```
//! theta is the angle of the reference; n_1 is 1/2 for four strokes, 1 for two. Each `T_k` is that of the gas at this speed and that of the masses, which
//! grows with the square of the speed.

use crate::chain::Chain;
use crate::error::TorsionError;
use num_complex::Complex64;
use serde::Serialize;
use std::f64::consts::TAU;

/// All torques on a chain.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Excitation {
    /// Lowest order, of which all are multiples [1/revolution of the reference].
    pub step: f64,
    /// Number of orders.
    pub count: usize,
    /// Torques on single stations, at their own speeds.
    pub sources: Vec<Source>,
}

/// Torque on one station, at its own speed.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Source {
    /// Index of the station.
    pub station: usize,
    /// What does not go with the square of the speed, at speeds that rise; straight between them, the nearest one beyond. Empty: none.
    pub gas: Vec<TorqueAt>,
    /// Torque over the square of the reference speed by order [N m s^2/rad^2].
    #[schemars(with = "Vec<[f64; 2]>")]
    pub inertia: Vec<Complex64>,
}

/// Torque of a station at one speed.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct TorqueAt {
    /// Speed of the reference [rad/s].
    pub speed: f64,
    /// Mean torque [N m].
    pub mean: f64,
    /// By order [N m].
    #[schemars(with = "Vec<[f64; 2]>")]
    pub orders: Vec<Complex64>,
}

impl Excitation {
    /// The orders.
    pub fn orders(&self) -> Vec<f64> {
        (1..=self.count).map(|k| self.step * k as f64).collect()
    }

    /// Whether its numbers fit each other and the chain.
    ///
    /// # Errors
    /// [`TorsionError`]: what does not.
    pub fn check(&self, chain: &Chain) -> Result<(), TorsionError> {
        let number = |quantity, needed, got| Err(TorsionError::Number { quantity, needed, got });
        if !(self.step > 0.0 && self.step.is_finite()) {
            return number("lowest order", "more than 0", self.step);
        }
        if self.count == 0 || self.count > MOST_ORDERS {
            return number("number of orders", "from 1 to 1000", self.count as f64);
        }
        for source in &self.sources {
            let stations = chain.stations().len();
            if source.station >= stations {
                return Err(TorsionError::Count {
                    what: "station of a torque",
                    needed: format!("from 0 to {}", stations - 1),
                    got: source.station,
                });
            }
            let lists = source.gas.iter().map(|at| &at.orders).chain([&source.inertia]);
            for list in lists {
                if list.len() != self.count {
                    return Err(TorsionError::Count {
                        what: "orders of a torque",
                        needed: self.count.to_string(),
                        got: list.len(),
                    });
                }
                if let Some(bad) = list.iter().find(|t| !t.is_finite()) {
                    return number("torque [N m]", "a finite number", bad.norm());
                }
            }
            if source.gas.windows(2).any(|pair| pair[0].speed >= pair[1].speed) {
                return number("speed of a torque [rad/s]", "above the one before", source.gas[0].speed);
            }
        }
        Ok(())
    }
}

/// Most orders that are taken.
const MOST_ORDERS: usize = 1000;

impl Source {
    /// Torque of order `k` (from 0) at a speed [rad/s], complex [N m].
    pub fn order(&self, k: usize, speed: f64) -> Complex64 {
        let (low, high, share) = self.between(speed);
        let gas = |index: usize| self.gas.get(index).map_or(Complex64::default(), |at| at.orders[k]);
        gas(low) * (1.0 - share) + gas(high) * share + self.inertia[k] * (speed * speed)
    }

    /// Mean torque at a speed [N m].
    pub fn mean(&self, speed: f64) -> f64 {
        let (low, high, share) = self.between(speed);
        let mean = |index: usize| self.gas.get(index).map_or(0.0, |at| at.mean);
        mean(low) * (1.0 - share) + mean(high) * share
    }

    fn between(&self, speed: f64) -> (usize, usize, f64) {
        let above = self.gas.partition_point(|at| at.speed <= speed);
        match (above.checked_sub(1), self.gas.get(above)) {
            (Some(low), Some(high)) => {
                (low, above, (speed - self.gas[low].speed) / (high.speed - self.gas[low].speed))
            }
            (Some(low), None) => (low, low, 0.0),
            (None, _) => (0, 0, 0.0),
        }
    }
}

/// Mean and orders 1 to `count` of a curve that is sampled evenly over its period, the last sample before the first one again:
/// `x = mean + Re SUM x_k e^(i k psi)`.
pub fn orders_of(samples: &[f64], count: usize) -> (f64, Vec<Complex64>) {
    let n = samples.len().max(1) as f64;
    let mean = samples.iter().sum::<f64>() / n;
    let order = |k: usize| {
        let turn = Complex64::cis(-TAU * k as f64 / n);
        let mut factor = Complex64::new(2.0 / n, 0.0);
        let mut sum = Complex64::default();
        for (index, value) in samples.iter().enumerate() {
            if index % 64 == 0 {
                factor = 2.0 / n * Complex64::cis(-TAU * (k * index % samples.len()) as f64 / n);
            }
            sum += factor * value;
            factor *= turn;
        }
        if 2 * k == samples.len() { sum / 2.0 } else { sum }
    };
    (mean, (1..=count).map(order).collect())
}
