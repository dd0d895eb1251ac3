//! What ends a piece of a run.

use crate::powered::Powered;
use lanchester_numerics::System;

/// A change of sign that ends a piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Watch {
    /// `speed - value`, where it falls or rises.
    Speed(f64, bool, Mark),
    /// `theta - value`.
    Angle(f64, Mark),
    /// `t - value`.
    Time(f64, Mark),
    /// What friction can hold less what it must.
    Grip,
}

/// What a watch is for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Mark {
    Event(usize),
    Starter,
    Mode,
    Halt,
    Kink,
    Knot,
}

/// The equations of a piece with what ends it.
pub(super) struct Piece<'r, 'a> {
    pub powered: &'r mut Powered<'a>,
    pub over_angle: bool,
    pub watches: Vec<Watch>,
}

impl System for Piece<'_, '_> {
    fn dimension(&self) -> usize {
        self.powered.layout.dimension()
    }

    fn derivative(&mut self, x: f64, y: &[f64], derivative: &mut [f64]) {
        if self.over_angle {
            self.powered.rates(y[0], x, y, derivative);
            let by_angle = 1.0 / y[1];
            derivative.iter_mut().for_each(|rate| *rate *= by_angle);
            derivative[0] = by_angle;
        } else {
            self.powered.rates(x, y[0], y, derivative);
        }
    }

    fn enter(&mut self, from: f64, to: f64) {
        if self.over_angle {
            self.powered.conditions.window = [from, to];
        } else {
            self.powered.conditions.times = [from, to];
        }
    }

    fn events(&self) -> usize {
        self.watches.len()
    }

    fn is_quiet(&self, from: f64, to: f64, start: &[f64], reach: &[f64]) -> bool {
        let apart = |component: usize, value: f64| (start[component] - value).abs() > reach[component];
        let beside = |place: f64| (place - from) * (place - to) > 0.0;
        self.watches.iter().all(|watch| match *watch {
            Watch::Speed(speed, _, _) => apart(1, speed),
            Watch::Angle(angle, _) if self.over_angle => beside(angle),
            Watch::Time(time, _) if !self.over_angle => beside(time),
            Watch::Angle(value, _) | Watch::Time(value, _) => apart(0, value),
            Watch::Grip => false,
        })
    }

    fn event_functions(&mut self, x: f64, y: &[f64], values: &mut [f64]) {
        let (t, theta) = if self.over_angle { (y[0], x) } else { (x, y[0]) };
        for (value, watch) in values.iter_mut().zip(&self.watches) {
            *value = match *watch {
                Watch::Speed(speed, _, _) => y[1] - speed,
                Watch::Angle(angle, _) => theta - angle,
                Watch::Time(time, _) => t - time,
                Watch::Grip => {
                    let mut rates = vec![0.0; y.len()];
                    self.powered.rates(t, theta, y, &mut rates);
                    self.powered.dry_torque() - self.powered.holding.abs()
                }
            };
        }
    }
}

impl Watch {
    /// The same with nothing to be done at it.
    pub fn passed_over(self) -> Watch {
        match self {
            Watch::Speed(speed, rising, _) => Watch::Speed(speed, rising, Mark::Mode),
            other => other,
        }
    }
}
