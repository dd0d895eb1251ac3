//! The closed form at the mean speed of a run's last period, for pictures that show both.

use crate::mounted::{MountSpeeds, mounts};
use crate::pressure::cylinders::cylinder_gas;
use crate::pressure::measured::TraceFile;
use lanchester_file::EngineFile;
use lanchester_mechanism::{BearingRequest, bearing_loads};
use lanchester_report::{ClosedFormBeside, SimulationResult};

/// Highest order of the forces on mounts.
const MOUNT_ORDERS: u32 = 8;

/// What the closed form says at the mean speed of the last period; `None` where the engine comes to rest, or does not have all its fuel throughout.
pub fn simulation_beside(
    file: &EngineFile,
    traces: &[TraceFile],
    result: &SimulationResult,
) -> Option<ClosedFormBeside> {
    let engine = &file.engine;
    let [_, least, speed] = result.speeds();
    if least <= 0.0 || !result.period.is_whole || !result.is_fired_throughout {
        return None;
    }
    let gas = match (&engine.gas, &result.gas) {
        (Some(_), Some(_)) => Some(cylinder_gas(engine, traces, speed).ok()?.cylinders),
        _ => None,
    };
    let mut beside = ClosedFormBeside { speed, ..ClosedFormBeside::default() };
    let request = BearingRequest { speed: Some(speed), ..BearingRequest::default() };
    if let Ok(loads) = bearing_loads(engine, gas.as_deref(), &request) {
        for main in &loads.mains {
            let shaft = main.crankshaft - 1;
            beside.mains.resize(beside.mains.len().max(shaft + 1), Vec::new());
            let path = main.load.load.iter().map(|force| [force.re, force.im]).collect();
            beside.mains[shaft].push(path);
        }
        beside.crankpins = loads
            .cylinders
            .iter()
            .map(|own| {
                own.radial.iter().zip(&own.tangential).map(|(along, across)| [*along, *across]).collect()
            })
            .collect();
    }
    if !result.mounts.is_empty() {
        let traces = gas.as_ref().map(|_| traces);
        let found = mounts(engine, &MountSpeeds::List(vec![speed]), MOUNT_ORDERS, traces, &[]).ok();
        let response = found.as_ref().and_then(|study| study.response.speeds.first());
        if let Some(response) = response {
            beside.mounts = response.orders.iter().map(|own| (own.order, own.forces.clone())).collect();
        }
    }
    Some(beside)
}
