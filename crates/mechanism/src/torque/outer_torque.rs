//! Torques on crankshaft 1 that the engine file gives over the angle: a torque as a sum of orders, and a load that varies (book, eq. 25.9).
//!
//! ```text
//! T(theta) = SUM over orders of ( a sin(n theta) + b cos(n theta) )  -  ( L(theta) - L_mean )
//! ```
//! The load takes the mean of all torques, and beside it what its table varies about its own mean. The table counts where the load sits on crankshaft 1
//! itself: behind a driveline its angle is another one.

use crate::inertia::request::{LoadError, MAX_REVOLUTIONS};
use lanchester_model::{LoadLaw, SimulationInput, TorqueOrder, periodic_value};
use std::f64::consts::TAU;

/// Orders and periods closer to a whole number than this count as whole.
const WHOLE: f64 = 1e-9;

/// Torques over the angle that a run in time is given.
#[derive(Debug, Clone, PartialEq)]
pub struct OuterTorque {
    orders: Vec<TorqueOrder>,
    load: Option<LoadLaw>,
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
        let own = input.load.as_ref().filter(|load| load.law.is_over_angle() && input.driveline.is_empty());
        let load = own.map(|load| load.law.clone());
        let orders = input.torque_orders().map_err(LoadError::Unread)?;
        let fits = |revolutions: &u32| {
            let whole = |value: f64| (value - value.round()).abs() < WHOLE * value.max(1.0);
            let turns = f64::from(*revolutions);
            orders.iter().all(|one| whole(one.order * turns))
                && load
                    .as_ref()
                    .and_then(|load| load.over_angle(0.0))
                    .is_none_or(|(period, _)| whole(TAU * turns / period))
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

    /// As they are at a speed of crankshaft 1 [rad/s].
    pub(crate) fn at(&self, speed: f64) -> OuterAt<'_> {
        let load = self.load.as_ref().and_then(|load| load.over_angle(speed));
        OuterAt {
            orders: &self.orders,
            load: load.map(|(period, points)| (mean(&points, period), period, points)),
        }
    }
}

/// Torques over the angle at one speed.
#[derive(Debug)]
pub(crate) struct OuterAt<'a> {
    orders: &'a [TorqueOrder],
    /// Mean [N m] and period [rad] of the load, its angles [rad] and torques [N m].
    load: Option<(f64, f64, Vec<[f64; 2]>)>,
}

impl OuterAt<'_> {
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
        let varied = |(mean, period, points): &(f64, f64, Vec<[f64; 2]>)| {
            periodic_value(points, *period, theta) - mean
        };
        let load = self.load.as_ref().map_or(0.0, varied);
        orders.sum::<f64>() - load
    }

    /// Angles at which the load bends, over so many revolutions [rad].
    pub(crate) fn kinks(&self, revolutions: u32) -> Vec<f64> {
        let Some((_, period, points)) = &self.load else { return Vec::new() };
        let count = (TAU * f64::from(revolutions) / period).round() as u32;
        (0..count)
            .flat_map(|turn| points.iter().map(move |point| point[0] + period * f64::from(turn)))
            .collect()
    }
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
