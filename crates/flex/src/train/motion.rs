//! How the flywheel turns, imposed, and what presses on pistons over its angle.

use std::f64::consts::TAU;

/// Speed over time at the flywheel: a mean and orders of the period.
///
/// ```text
/// theta = a_0 + w t + SUM (a_k cos k W t + b_k sin k W t)    W = 2 pi w/P
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ImposedMotion {
    /// Mean speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Period [rad] of crankshaft 1.
    pub period: f64,
    /// Angle at which the mean begins [rad].
    pub offset: f64,
    /// Angles `a_k`, `b_k` from k = 1 on [rad].
    pub swing: Vec<[f64; 2]>,
}

/// Angle, speed, acceleration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Turn {
    pub angle: f64,
    pub speed: f64,
    pub acceleration: f64,
}

impl ImposedMotion {
    /// Constant speed [rad/s].
    pub fn constant(speed: f64, period: f64) -> ImposedMotion {
        ImposedMotion { speed, period, offset: 0.0, swing: Vec::new() }
    }

    /// Speeds [rad/s] at equally spaced angles of a period, as a motion over time with so many orders.
    ///
    /// `t(theta)` by the trapezoidal rule of `1/w`, which converges at once for periodic samples; the orders of `theta - w t` from samples at equal times.
    pub fn of_speeds(speeds: &[f64], period: f64, orders: usize) -> ImposedMotion {
        let n = speeds.len();
        let step = period / n.max(1) as f64;
        let mut times = vec![0.0];
        for k in 0..n {
            let next = times[k] + 0.5 * step * (1.0 / speeds[k] + 1.0 / speeds[(k + 1) % n]);
            times.push(next);
        }
        let whole = times[n];
        let speed = period / whole;
        // Angle at equal times, linear between the samples in time; a sample a degree is fine enough for what orders are kept.
        let mut swing = vec![[0.0; 2]; orders.min(n / 4)];
        let (mut at, mut offset) = (0, 0.0);
        for k in 0..n {
            let t = whole * k as f64 / n as f64;
            while at + 1 < n && times[at + 1] < t {
                at += 1;
            }
            let share = (t - times[at]) / (times[at + 1] - times[at]);
            let beyond = step * (at as f64 + share) - speed * t;
            offset += beyond / n as f64;
            for (order, [a, b]) in swing.iter_mut().enumerate() {
                let (sin, cos) = (TAU * (order + 1) as f64 * k as f64 / n as f64).sin_cos();
                *a += 2.0 / n as f64 * beyond * cos;
                *b += 2.0 / n as f64 * beyond * sin;
            }
        }
        ImposedMotion { speed, period, offset, swing }
    }

    /// Duration of a period [s].
    pub fn duration(&self) -> f64 {
        self.period / self.speed
    }

    /// At a time [s].
    pub(crate) fn at(&self, t: f64) -> Turn {
        let mut turn = Turn { angle: self.offset + self.speed * t, speed: self.speed, acceleration: 0.0 };
        let base = TAU * self.speed / self.period;
        for (k, [a, b]) in self.swing.iter().enumerate() {
            let rate = base * (k + 1) as f64;
            let (sin, cos) = (rate * t).sin_cos();
            turn.angle += a * cos + b * sin;
            turn.speed += rate * (b * cos - a * sin);
            turn.acceleration -= rate * rate * (a * cos + b * sin);
        }
        turn
    }
}

/// A force over a period of angle, at equally spaced samples: cubic between them.
#[derive(Debug, Clone, PartialEq)]
pub struct PeriodicForce {
    /// Period [rad].
    pub period: f64,
    /// Samples [N] from 0 on, the end excluded.
    pub samples: Vec<f64>,
}

impl PeriodicForce {
    /// None.
    pub fn none(period: f64) -> PeriodicForce {
        PeriodicForce { period, samples: vec![0.0] }
    }

    /// Force at an angle [N].
    pub(crate) fn at(&self, angle: f64) -> f64 {
        let n = self.samples.len();
        let place = (angle / self.period).rem_euclid(1.0) * n as f64;
        let i = (place as usize).min(n.saturating_sub(1));
        let t = place - i as f64;
        let value = |k: usize| self.samples[(i + n + k - 1) % n];
        let weights = [
            -0.5 * t * (1.0 - t) * (1.0 - t),
            1.0 + t * t * (1.5 * t - 2.5),
            t * (0.5 + t * (2.0 - 1.5 * t)),
            -0.5 * t * t * (1.0 - t),
        ];
        (0..4).map(|k| weights[k] * value(k)).sum()
    }

    /// Its largest size [N].
    pub(crate) fn largest(&self) -> f64 {
        self.samples.iter().fold(0.0, |most, force| most.max(force.abs()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rippling_speed_is_followed_over_time() {
        let period = 2.0 * TAU;
        let n = 720;
        let speed = |theta: f64| 400.0 * (1.0 + 0.02 * (2.0 * theta).sin() + 0.005 * theta.cos());
        let samples: Vec<f64> = (0..n).map(|k| speed(period * k as f64 / n as f64)).collect();
        let motion = ImposedMotion::of_speeds(&samples, period, 60);
        for k in 0..50 {
            let t = motion.duration() * (k as f64 + 0.3) / 50.0;
            let turn = motion.at(t);
            // Fourth-order aliasing of linear interpolation in time: 2e-5 of the ripple.
            assert!(
                (turn.speed / speed(turn.angle) - 1.0).abs() < 2e-5,
                "{k}: {turn:?} {}",
                speed(turn.angle)
            );
            let h = 1e-7;
            let slope = (motion.at(t + h).speed - motion.at(t - h).speed) / (2.0 * h);
            assert!((slope - turn.acceleration).abs() < 1e-4 * 400.0 * 400.0 * 0.04);
        }
        let whole = motion.at(motion.duration());
        assert!((whole.angle - motion.at(0.0).angle - period).abs() < 1e-12 * period);
    }

    #[test]
    fn a_periodic_force_goes_through_its_samples() {
        let force =
            PeriodicForce { period: 12.0, samples: (0..24).map(|k| (k as f64 * TAU / 24.0).sin()).collect() };
        for k in 0..24 {
            assert!((force.at(0.5 * k as f64 + 24.0) - force.samples[k]).abs() < 1e-12);
        }
        assert!((force.at(0.25) - (TAU / 48.0).sin()).abs() < 1e-3);
        assert!((force.largest() - 1.0).abs() < 1e-12);
    }
}
