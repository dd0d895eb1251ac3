//! Torques on crankshaft 1 that the engine file gives over the angle: a torque as a sum of orders, and a load that varies (book, eq. 25.9).
//!
//! ```text
//! T(theta) = SUM over orders of ( a sin(n theta) + b cos(n theta) )  -  ( L(theta) - L_mean )
//! ```
//! The load takes the mean of all torques, and beside it what its table varies about its own mean. The table counts where the load sits on crankshaft 1
//! itself: behind a driveline its angle is another one.

use crate::inertia::request::{LoadError, MAX_REVOLUTIONS};
use lanchester_model::{LoadLaw, SimulationInput, TorqueOrder};
use std::f64::consts::TAU;

/// Orders and periods closer to a whole number than this count as whole.
const WHOLE: f64 = 1e-9;

/// Torques over the angle that a run in time is given.
#[derive(Debug, Clone, PartialEq)]
pub struct OuterTorque {
    orders: Vec<TorqueOrder>,
    /// Period [rad], points of angle [rad] and torque [N m], mean [N m].
    load: Option<(f64, Vec<[f64; 2]>, f64)>,
    /// Revolutions after which they repeat together.
    pub(crate) revolutions: u32,
}

impl Default for OuterTorque {
    /// None.
    fn default() -> Self {
        OuterTorque { orders: Vec::new(), load: None, revolutions: 1 }
    }
}

impl OuterTorque {
    /// Those that `input` gives.
    ///
    /// # Errors
    /// [`LoadError::Request`] where they repeat after more than 120 revolutions, [`LoadError::Unread`] where a file of torque has not been read.
    pub fn of(input: Option<&SimulationInput>) -> Result<OuterTorque, LoadError> {
        let Some(input) = input else { return Ok(OuterTorque::default()) };
        let load = match input.load.as_ref().map(|load| &load.law) {
            Some(LoadLaw::Angle { period, points }) if input.driveline.is_empty() => {
                Some((*period, points.clone(), mean(points, *period)))
            }
            _ => None,
        };
        let orders = input.torque_orders().map_err(LoadError::Unread)?;
        let fits = |revolutions: &u32| {
            let whole = |value: f64| (value - value.round()).abs() < WHOLE * value.max(1.0);
            let turns = f64::from(*revolutions);
            orders.iter().all(|one| whole(one.order * turns))
                && load.as_ref().is_none_or(|(period, ..)| whole(TAU * turns / period))
        };
        let found = (1..=MAX_REVOLUTIONS).find(fits);
        let refused = LoadError::Request {
            quantity: "revolutions after which the torques over the angle repeat",
            needed: "at most 120",
            got: f64::INFINITY,
        };
        Ok(OuterTorque { load, revolutions: found.ok_or(refused)?, orders })
    }

    /// Whether there is none.
    pub fn is_none(&self) -> bool {
        self.orders.is_empty() && self.load.is_none()
    }

    /// Mean of the torque [N m].
    pub(crate) fn mean(&self) -> f64 {
        self.orders.iter().filter(|one| one.order == 0.0).map(|one| one.cos).sum()
    }

    /// Torque at `theta` [rad] less what the load varies [N m].
    pub(crate) fn torque(&self, theta: f64) -> f64 {
        let orders = self.orders.iter().map(|one| {
            let (sin, cos) = (one.order * theta).sin_cos();
            one.sin * sin + one.cos * cos
        });
        let load = self.load.as_ref().map_or(0.0, |(period, points, mean)| at(points, *period, theta) - mean);
        orders.sum::<f64>() - load
    }

    /// Angles at which the load bends, over so many revolutions [rad].
    pub(crate) fn kinks(&self, revolutions: u32) -> Vec<f64> {
        let Some((period, points, _)) = &self.load else { return Vec::new() };
        let count = (TAU * f64::from(revolutions) / period).round() as u32;
        (0..count)
            .flat_map(|turn| points.iter().map(move |point| point[0] + period * f64::from(turn)))
            .collect()
    }
}

/// Value on straight lines through points within a period, from the last to the first of the next.
fn at(points: &[[f64; 2]], period: f64, theta: f64) -> f64 {
    let count = points.len();
    let own = theta.rem_euclid(period);
    let after = points.partition_point(|point| point[0] <= own);
    let (before, next) = ((after + count - 1) % count, after % count);
    let [from, low] = points[before];
    let [to, high] = points[next];
    let length = (to - from).rem_euclid(period);
    if length == 0.0 { low } else { low + (high - low) * (own - from).rem_euclid(period) / length }
}

/// Mean over the period: of trapezia.
fn mean(points: &[[f64; 2]], period: f64) -> f64 {
    if let [[_, only]] = points {
        return *only;
    }
    let next = points.iter().cycle().skip(1);
    let area = points
        .iter()
        .zip(next)
        .map(|([from, low], [to, high])| 0.5 * (low + high) * (to - from).rem_euclid(period));
    area.sum::<f64>() / period
}
