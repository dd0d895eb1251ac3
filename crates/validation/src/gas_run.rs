//! Torque and bearing loads by the gas.

use lanchester::mechanism::{
    BearingLoads, BearingRequest, Kinematics, Lever, Torque, TorqueRequest, bearing_loads, torque,
};
use lanchester::model::Engine;
use lanchester::results::Extreme;
use lanchester::{TraceFile, cylinder_gas};
use lanchester_data::TRACES;
use std::f64::consts::TAU;

/// The traces that engine files of `validation/` may name.
pub(crate) fn traces() -> Vec<TraceFile> {
    TRACES.iter().map(|(name, text)| TraceFile { name: (*name).into(), text: (*text).into() }).collect()
}

/// Torque and bearing loads of an engine.
pub(crate) struct GasRun {
    pub torque: Torque,
    pub bearings: BearingLoads,
}

impl GasRun {
    /// Of an engine with the synthetic traces that it names.
    pub fn of(engine: &Engine, kinematics: Kinematics) -> Result<GasRun, String> {
        let traces = traces();
        let gas = cylinder_gas(engine, &traces, engine.speed.highest).map_err(|error| error.to_string())?;
        let request =
            TorqueRequest { lever: Lever::Sine, kinematics, max_order: 1, ..TorqueRequest::default() };
        let found = torque(engine, &gas.cylinders, &request).map_err(|error| error.to_string())?;
        // Forces are printed to whole degrees.
        let request = BearingRequest { samples: 3600, ..BearingRequest::default() };
        let bearings =
            bearing_loads(engine, Some(&gas.cylinders), &request).map_err(|error| error.to_string())?;
        Ok(GasRun { torque: found, bearings })
    }

    /// Largest of some forces within half a turn of firing, and its angle after it [rad].
    pub fn largest_while_pushing(&self, forces: &[f64], firing: f64) -> Extreme {
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
