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
//! | `largest power of a b c d N m` | of the cubic through these torques at 1000, 2000, 3000 and 4000 rpm, to 100 rpm |
//! | `speed of largest power of a b c d N m` | where it stands |
//!
//! The pressures are those of the synthetic traces, where the engine names them.

use super::case::Run;
use super::files::TRACES;
use crate::pressure::{TraceFile, cylinder_gas};
use lanchester_mechanism::{
    BearingLoads, BearingRequest, Extreme, Lever, PowerCurve, Torque, TorqueRequest, bearing_loads, torque,
};
use std::f64::consts::{PI, TAU};

/// Torque and bearing loads of an engine.
pub(super) struct GasRun {
    torque: Torque,
    bearings: BearingLoads,
}

/// A quantity of the gas.
pub(super) enum GasKey {
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
            let (at, power) = largest_power(*torques).ok_or("the torques give no power curve")?;
            return Ok(if *speed { at } else { power });
        }
        let gas = run.gas.get_or_init(|| GasRun::of(run)).as_ref().map_err(Clone::clone)?;
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

impl GasRun {
    fn of(run: &Run) -> Result<GasRun, String> {
        let engine = &run.engine;
        let traces = TRACES.map(|(name, text)| TraceFile { name: name.into(), text: text.into() });
        let gas = cylinder_gas(engine, &traces, engine.speed.highest).map_err(|error| error.to_string())?;
        let request = TorqueRequest {
            lever: Lever::Sine,
            kinematics: run.kinematics,
            max_order: 1,
            samples: 1,
            ..TorqueRequest::default()
        };
        let found = torque(engine, &gas.cylinders, &request).map_err(|error| error.to_string())?;
        // Forces are printed to whole degrees.
        let request = BearingRequest { samples: 3600, ..BearingRequest::default() };
        let bearings =
            bearing_loads(engine, Some(&gas.cylinders), &request).map_err(|error| error.to_string())?;
        Ok(GasRun { torque: found, bearings })
    }

    /// Largest of some forces within half a turn of firing, and its angle after it [rad].
    fn largest_while_pushing(&self, forces: &[f64], firing: f64) -> Extreme {
        let period = self.bearings.period;
        let after = |theta: f64| (theta - firing + 0.5 * period).rem_euclid(period) - 0.5 * period;
        let mut largest = Extreme { value: f64::NEG_INFINITY, theta: 0.0 };
        for (force, theta) in forces.iter().zip(&self.bearings.theta) {
            let theta = after(*theta);
            if theta.abs() <= 0.25 * TAU && *force > largest.value {
                largest = Extreme { value: *force, theta };
            }
        }
        largest
    }
}

/// Speed [rpm] and amount [W] of the largest power of the cubic through torques at [`SPEEDS_RPM`], among the hundreds.
fn largest_power(torques: [f64; 4]) -> Option<(f64, f64)> {
    let points: Vec<(f64, f64)> = SPEEDS_RPM
        .iter()
        .zip(torques)
        .map(|(rpm, torque)| (rpm * PI / 30.0, rpm * PI / 30.0 * torque))
        .collect();
    let curve = PowerCurve::fit(&points)?;
    let hundreds = (1..=40).map(|k| 100.0 * f64::from(k)).map(|rpm| (rpm, curve.power(rpm * PI / 30.0)));
    hundreds.max_by(|a, b| a.1.total_cmp(&b.1))
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
    fn the_power_is_looked_for_among_the_hundreds() {
        let (rpm, power) = largest_power([35.5, 80.0, 72.9, 64.1]).unwrap();
        assert!(rpm == 3800.0 && (power - 26.884e3).abs() < 1.0, "{rpm} {power}");
    }
}
