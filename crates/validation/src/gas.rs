//! What the gas does, by the names that the data files use.
//!
//! | name | what it is |
//! |---|---|
//! | `average torque` | of the gas with the lever `r sin(theta)` |
//! | `variation of energy` | the twin thesis's: integral of `|T - T_mean|` of gas and inertia with that lever over the own period |
//! | `peak pressure`, `angle of peak pressure` | of cylinder 1, after its firing top dead centre |
//! | `radial rod force`, `tangential rod force` | largest on the crankpin of cylinder 1, towards the crank axis and in the sense of rotation |
//! | `angle of radial rod force`, `angle of tangential rod force` | where they stand |
//! | `radial rod force at top dead centre` | the first of them at the firing top dead centre |
//! | `largest power of a b c d N m` | of the cubic with a free constant that fits rest and these torques at 1000, 2000, 3000 and 4000 rpm |
//! | `speed of largest power of a b c d N m` | its speed [rpm] |
//!
//! The pressures are those of the synthetic traces, where the engine names them.

use crate::case::Run;
use lanchester::results::Extreme;
use std::f64::consts::PI;

/// A quantity of the gas.
pub(crate) enum GasKey {
    AverageTorque,
    VariationOfEnergy,
    PeakPressure { angle: bool },
    RodForce { radial: bool, angle: bool },
    RadialAtTopDeadCentre,
    LargestPower { torques: [f64; 4], speed: bool },
}

/// Speeds of the thesis's torques [rpm].
const SPEEDS_RPM: [f64; 4] = [1000.0, 2000.0, 3000.0, 4000.0];

impl GasKey {
    pub fn parse(text: &str) -> Option<GasKey> {
        let (name, angle) = match text.strip_prefix("angle of ") {
            Some(name) => (name, true),
            None => (text, false),
        };
        Some(match name {
            "average torque" if !angle => GasKey::AverageTorque,
            "variation of energy" if !angle => GasKey::VariationOfEnergy,
            "peak pressure" => GasKey::PeakPressure { angle },
            "radial rod force" => GasKey::RodForce { radial: true, angle },
            "tangential rod force" => GasKey::RodForce { radial: false, angle },
            "radial rod force at top dead centre" if !angle => GasKey::RadialAtTopDeadCentre,
            _ => {
                let (name, speed) = match text.strip_prefix("speed of ") {
                    Some(name) => (name, true),
                    None => (text, false),
                };
                let list = name.strip_prefix("largest power of ")?.strip_suffix(" N m")?;
                let torques: Option<Vec<f64>> = list.split(' ').map(|torque| torque.parse().ok()).collect();
                GasKey::LargestPower { torques: torques?.try_into().ok()?, speed }
            }
        })
    }

    pub fn of(&self, run: &Run) -> Result<f64, String> {
        if let GasKey::LargestPower { torques, speed } = self {
            let (at, power) = PowerCubic::through(*torques).largest(run.power_step);
            return Ok(if *speed { at } else { power });
        }
        let gas = run.with_gas()?;
        let pin = gas.bearings.cylinders.first().ok_or("the engine has no cylinder")?;
        let cylinder = gas.torque.cylinders.first().ok_or("the engine has no cylinder")?;
        let of =
            |extreme: Extreme, angle: bool| if angle { extreme.theta.to_degrees() } else { extreme.value };
        // Against the outward direction of the results.
        let inward = || pin.radial.iter().map(|force| -force).collect::<Vec<f64>>();
        Ok(match self {
            GasKey::AverageTorque => gas.torque.indicated.torque,
            GasKey::VariationOfEnergy => gas.torque.energy.absolute,
            GasKey::PeakPressure { angle } => of(cylinder.peak_pressure, *angle),
            GasKey::RodForce { radial, angle } => {
                let forces = if *radial { inward() } else { pin.tangential.clone() };
                of(gas.largest_while_pushing(&forces, cylinder.firing_angle), *angle)
            }
            GasKey::RadialAtTopDeadCentre => {
                let step = gas.bearings.period / gas.bearings.theta.len() as f64;
                let index = (cylinder.firing_angle.rem_euclid(gas.bearings.period) / step).round() as usize;
                inward()[index % gas.bearings.theta.len()]
            }
            GasKey::LargestPower { .. } => return Err("the power needs no gas".to_string()),
        })
    }
}

/// The cubic with four free coefficients over the speed, fitted in least squares to rest and the powers of four torques.
pub(crate) struct PowerCubic {
    /// Power at rest [W], and its differences by Newton's form in `s = n / 1000 rpm`.
    differences: [f64; 4],
}

impl PowerCubic {
    /// Of the torques at 1000, 2000, 3000 and 4000 rpm.
    ///
    /// The cubic through five points at equal distances goes through the points less their share of (1, -4, 6, -4, 1),
    /// the one row of five that no cubic can follow.
    pub fn through(torques: [f64; 4]) -> PowerCubic {
        const REST: [f64; 5] = [1.0, -4.0, 6.0, -4.0, 1.0];
        let mut points = [0.0; 5];
        for (point, (rpm, torque)) in points[1..].iter_mut().zip(SPEEDS_RPM.iter().zip(torques)) {
            *point = rpm * PI / 30.0 * torque;
        }
        let share = points.iter().zip(REST).map(|(p, r)| p * r).sum::<f64>() / 70.0;
        let [a, b, c, d, _]: [f64; 5] = std::array::from_fn(|k| points[k] - share * REST[k]);
        PowerCubic { differences: [a, b - a, c - 2.0 * b + a, d - 3.0 * c + 3.0 * b - a] }
    }

    /// Its power [W] at a speed [rpm].
    pub fn power(&self, rpm: f64) -> f64 {
        let [rest, first, second, third] = self.differences;
        let s = rpm / 1000.0;
        rest + s * (first + (s - 1.0) / 2.0 * (second + (s - 2.0) / 3.0 * third))
    }

    /// Speed [rpm] and amount [W] of the largest power up to 4000 rpm, among the multiples of a step if one is given.
    fn largest(&self, step: Option<f64>) -> (f64, f64) {
        let speeds: Vec<f64> = match step {
            Some(step) => (1..).map(|k| f64::from(k) * step).take_while(|rpm| *rpm <= 4000.0).collect(),
            None => {
                // The slope is x + y s + z s^2.
                let [_, first, second, third] = self.differences;
                let (x, y, z) = (first - second / 2.0 + third / 3.0, second - third, third / 2.0);
                let root = (y * y - 4.0 * x * z).max(0.0).sqrt();
                let flat = [(-y + root) / (2.0 * z), (-y - root) / (2.0 * z), 4.0];
                flat.into_iter().filter(|s| (0.0..=4.0).contains(s)).map(|s| 1000.0 * s).collect()
            }
        };
        let best = speeds.into_iter().map(|rpm| (rpm, self.power(rpm)));
        best.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0.0, self.power(0.0)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read() {
        for name in [
            "average torque",
            "angle of peak pressure",
            "radial rod force at top dead centre",
            "speed of largest power of 35.5 80 72.9 64.1 N m",
        ] {
            assert!(GasKey::parse(name).is_some(), "{name}");
        }
        for name in ["angle of average torque", "largest power of 35.5 N m", "torque", ""] {
            assert!(GasKey::parse(name).is_none(), "{name}");
        }
    }

    #[test]
    fn the_cubic_is_that_of_the_normal_equations() {
        // Solved apart from this by elimination: 26 879.577 W at 3761 rpm, 26 871.269 W at 3800 rpm.
        let torques = [35.5, 80.0, 72.9, 64.1];
        let (rpm, power) = PowerCubic::through(torques).largest(None);
        assert!((rpm - 3761.0).abs() < 1.0 && (power - 26_879.577).abs() < 0.01, "{rpm} {power}");
        let (rpm, power) = PowerCubic::through(torques).largest(Some(100.0));
        assert!((rpm - 3800.0).abs() < 1e-9 && (power - 26_871.269).abs() < 0.01, "{rpm} {power}");
    }
}
