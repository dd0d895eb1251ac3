//! Friction and power: from indicated to brake, and the literature's cubic through power over speed.
//!
//! ```text
//! fmep    = A + B p_max + C S + D S^2                    S: mean piston speed          (24.8)
//! T_brake = T - fmep V_swept / P                         P: angle of the working cycle (24.9)
//! P(w)    = a w + b w^2 + c w^3                          least squares over the points (24.10)
//! ```

use crate::torque::result::Indicated;
use lanchester_model::Friction;
use serde::Serialize;
use std::f64::consts::TAU;

/// What friction leaves.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Brake {
    /// Friction mean effective pressure [Pa].
    pub fmep: f64,
    /// Brake mean effective pressure [Pa]: what is left of the mean effective pressure of both sides of the pistons.
    pub bmep: f64,
    /// Brake torque at crankshaft 1 [N m].
    pub torque: f64,
    /// Brake power [W].
    pub power: f64,
    /// Brake over indicated torque [1].
    pub efficiency: f64,
}

impl Indicated {
    /// Friction mean effective pressure at this working point [Pa].
    pub fn fmep(&self, friction: &Friction) -> f64 {
        match *friction {
            Friction::Given { fmep } => fmep,
            Friction::ChenFlynn { constant, peak_pressure, speed, speed_squared } => {
                let piston = self.mean_piston_speed;
                constant
                    + peak_pressure * self.peak_pressure
                    + speed * piston
                    + speed_squared * piston * piston
            }
        }
    }

    /// Brake torque and power at `speed` [rad/s].
    ///
    /// The work of friction a cycle is `fmep V`, as that of the gas is `imep V`: both are spread over the cycle alike.
    pub fn brake(&self, friction: &Friction, speed: f64) -> Brake {
        let fmep = self.fmep(friction);
        let mep = self.imep - self.crankcase_mep;
        // Torque a unit of mean effective pressure: V over the angle of the cycle, gears included.
        let torque = self.torque - fmep * self.torque_per_mep;
        Brake { fmep, bmep: mep - fmep, torque, power: torque * speed, efficiency: torque / self.torque }
    }
}

/// Power over speed as a cubic through the origin.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PowerCurve {
    /// Points that it fits: speed [rad/s] and power [W].
    pub points: Vec<(f64, f64)>,
    /// `a`, `b`, `c` of `P = a w + b w^2 + c w^3` [W s, W s^2, W s^3] with the speed in rad/s.
    pub coefficients: [f64; 3],
    /// Speed [rad/s] and power [W] of the largest power between 0 and the highest point's speed.
    pub peak: (f64, f64),
    /// Largest departure of a point from the curve [W].
    pub misfit: f64,
}

impl PowerCurve {
    /// The cubic through the origin of least squares; `None` for fewer than three different speeds above zero.
    pub fn fit(points: &[(f64, f64)]) -> Option<PowerCurve> {
        let highest = points.iter().map(|p| p.0).fold(0.0, f64::max);
        let mut speeds: Vec<f64> = points.iter().map(|p| p.0).filter(|speed| *speed > 0.0).collect();
        speeds.sort_by(f64::total_cmp);
        speeds.dedup_by(|next, kept| *next - *kept <= 1e-9 * highest);
        if speeds.len() < 3 || points.iter().any(|p| !p.0.is_finite() || !p.1.is_finite()) {
            return None;
        }
        // Columns x, x^2, x^3 of x = w / w_max, made orthogonal one after another (modified Gram and Schmidt).
        let column = |n: i32| points.iter().map(|p| (p.0 / highest).powi(n)).collect::<Vec<f64>>();
        let mut columns = [column(1), column(2), column(3)];
        let mut triangle = [[0.0; 3]; 3];
        let mut rest: Vec<f64> = points.iter().map(|p| p.1).collect();
        let mut sides = [0.0; 3];
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        for k in 0..3 {
            let norm = dot(&columns[k], &columns[k]).sqrt();
            triangle[k][k] = norm;
            let unit: Vec<f64> = columns[k].iter().map(|x| x / norm).collect();
            for j in k + 1..3 {
                triangle[k][j] = dot(&unit, &columns[j]);
                let share = triangle[k][j];
                columns[j].iter_mut().zip(&unit).for_each(|(x, u)| *x -= share * u);
            }
            sides[k] = dot(&unit, &rest);
            let share = sides[k];
            rest.iter_mut().zip(&unit).for_each(|(x, u)| *x -= share * u);
        }
        let mut solution = [0.0; 3];
        for k in (0..3).rev() {
            let known: f64 = (k + 1..3).map(|j| triangle[k][j] * solution[j]).sum();
            solution[k] = (sides[k] - known) / triangle[k][k];
        }
        let coefficients = std::array::from_fn(|k| solution[k] / highest.powi(k as i32 + 1));
        let mut curve =
            PowerCurve { points: points.to_vec(), coefficients, peak: (highest, 0.0), misfit: 0.0 };
        curve.peak = curve.largest(highest);
        curve.misfit = points.iter().map(|p| (p.1 - curve.power(p.0)).abs()).fold(0.0, f64::max);
        Some(curve)
    }

    /// Power [W] at `speed` [rad/s].
    pub fn power(&self, speed: f64) -> f64 {
        let [a, b, c] = self.coefficients;
        speed * (a + speed * (b + speed * c))
    }

    /// Torque [N m] at `speed` [rad/s]: power over speed.
    pub fn torque(&self, speed: f64) -> f64 {
        let [a, b, c] = self.coefficients;
        a + speed * (b + speed * c)
    }

    /// Largest power from 0 to `highest`: at a root of `a + 2 b w + 3 c w^2`, or at the end.
    fn largest(&self, highest: f64) -> (f64, f64) {
        let [a, b, c] = self.coefficients;
        let root = (b * b - 3.0 * a * c).max(0.0).sqrt();
        let q = -(b + b.signum() * root);
        [q / (3.0 * c), a / q, highest]
            .into_iter()
            .filter(|speed| speed.is_finite() && *speed > 0.0 && *speed <= highest)
            .map(|speed| (speed, self.power(speed)))
            .fold((0.0, 0.0), |best, here| if here.1 > best.1 { here } else { best })
    }
}

impl Indicated {
    /// Mean piston speed [m/s] of a stroke [m] at a speed [rad/s] of its crankshaft.
    pub(crate) fn piston_speed(stroke: f64, speed: f64) -> f64 {
        2.0 * stroke * speed / TAU
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// A two-litre four-stroke with a mean effective pressure of 10 bar.
    fn indicated() -> Indicated {
        let torque_per_mep = 2e-3 / (2.0 * TAU);
        Indicated {
            torque: 10e5 * torque_per_mep,
            power: 0.0,
            displacement: 2e-3,
            imep: 10e5,
            crankcase_mep: 0.0,
            torque_per_mep,
            mean_piston_speed: 10.0,
            peak_pressure: 60e5,
        }
    }

    #[test]
    fn every_term_of_chen_and_flynn_counts_once() {
        let friction = Friction::ChenFlynn {
            constant: 0.4e5,
            peak_pressure: 0.005,
            speed: 0.09e5,
            speed_squared: 900.0,
        };
        // 0.4 + 0.005 * 60 + 0.09 * 10 + 0.009 * 100 = 2.5 bar.
        let fmep = indicated().fmep(&friction);
        assert!((fmep - 2.5e5).abs() < 1e-6, "{fmep}");
        for (peak_pressure, speed, speed_squared, bar) in
            [(0.0, 0.0, 0.0, 0.4), (0.005, 0.0, 0.0, 0.7), (0.0, 0.09e5, 0.0, 1.3), (0.0, 0.0, 900.0, 1.3)]
        {
            let one = Friction::ChenFlynn { constant: 0.4e5, peak_pressure, speed, speed_squared };
            assert!((indicated().fmep(&one) - bar * 1e5).abs() < 1e-6, "{one:?}");
        }
    }

    #[test]
    fn friction_takes_its_share_of_torque_and_power() {
        let brake = indicated().brake(&Friction::Given { fmep: 2.5e5 }, 300.0);
        assert!((brake.efficiency - 0.75).abs() < 1e-14 && (brake.bmep - 7.5e5).abs() < 1e-6, "{brake:?}");
        // 7.5 bar of two litres over two turns: 119.366 N m.
        assert!((brake.torque - 1500.0 / (2.0 * TAU)).abs() < 1e-10, "{brake:?}");
        assert_eq!(brake.power, 300.0 * brake.torque);
    }

    /// Louvigny 2008, Tables 27, 28 and 29 with figures 60, 65 and 67: 26.9, 53.7 and 59.4 kW at 3800 rpm.
    #[test]
    fn lit_the_cubic_of_the_twin_thesis() {
        let tables = [
            ([35.5, 80.0, 72.9, 64.1], 26.9e3),
            ([71.1, 160.0, 145.8, 128.1], 53.7e3),
            ([78.6, 176.9, 161.2, 141.6], 59.4e3),
        ];
        for (torques, printed) in tables {
            let speeds = [1000.0, 2000.0, 3000.0, 4000.0].map(|rpm: f64| rpm * PI / 30.0);
            let points: Vec<(f64, f64)> = speeds.iter().zip(torques).map(|(w, t)| (*w, w * t)).collect();
            let curve = PowerCurve::fit(&points).unwrap();
            // Half a printed digit.
            assert!((curve.power(3800.0 * PI / 30.0) - printed).abs() < 50.0, "{curve:?}");
            let rpm = curve.peak.0 * 30.0 / PI;
            // Read off the figure to the nearest hundred.
            assert!((rpm / 100.0).round() == 38.0, "{rpm}");
        }
    }

    #[test]
    fn a_cubic_is_found_again() {
        let points: Vec<(f64, f64)> =
            (1..=5).map(|k| 100.0 * f64::from(k)).map(|w| (w, w * (40.0 + w * (0.3 - w * 5e-4)))).collect();
        let curve = PowerCurve::fit(&points).unwrap();
        let [a, b, c] = curve.coefficients;
        assert!((a - 40.0).abs() < 1e-9 && (b - 0.3).abs() < 1e-11 && (c + 5e-4).abs() < 1e-14, "{curve:?}");
        // 40 + 0.6 w = 1.5e-3 w^2.
        let wanted = (0.6 + (0.36f64 + 0.24).sqrt()) / 3e-3;
        assert!((curve.peak.0 - wanted).abs() < 1e-9 * wanted && curve.misfit < 1e-7, "{curve:?}");
        assert!(PowerCurve::fit(&points[..2]).is_none());
    }
}
