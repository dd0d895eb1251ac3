//! What the report tells of the running engine: torque with gas, bearings, the block on its mounts.

use crate::failure::Failure;
use crate::trace_files::trace_files;
use lanchester::mechanism::{MountStudy, TorqueRequest};
use lanchester::model::Engine;
use lanchester::report::{BearingsInput, TorqueInput};
use lanchester::{
    BearingStudy, MountSpeeds, TorqueReport, TorqueReportRequest, TraceFile, bearing_sizes, bearing_study,
    mounts, power_speeds, torque_report,
};
use std::path::Path;

/// Speeds and highest order of the section on mounts.
const MOUNT_SPEEDS: usize = 31;
const MOUNT_ORDERS: u32 = 8;

/// Speeds of the power curve, where a cycle is computed.
const POWER_SPEEDS: usize = 7;

/// The running engine, as far as its file tells.
#[derive(Default)]
pub struct Running {
    pub torque: Option<TorqueReport>,
    pub bearings: Option<BearingStudy>,
    pub mounts: Option<MountStudy>,
}

/// Everything that the file has enough for, torque and bearings at `speed` [rad/s]; what is left out is one more warning.
pub fn running(engine: &Engine, file: &Path, speed: f64, warnings: &mut Vec<String>) -> Running {
    let has_mounts = engine.block.is_some() && engine.mounts.iter().all(|mount| mount.spring.is_some());
    let has_bearings = engine.gas.is_some() || engine.bearings.is_some();
    if !has_mounts && !has_bearings {
        return Running::default();
    }
    let traces = trace_files(engine, file);
    let mut left_out = Vec::new();
    let torque = section(engine.gas.is_some(), "torque with gas is", &traces, &mut left_out, |traces| {
        let request = TorqueReportRequest {
            torque: TorqueRequest { speed: Some(speed), ..TorqueRequest::default() },
            speeds: power_speeds(engine, POWER_SPEEDS),
            ..TorqueReportRequest::default()
        };
        torque_report(engine, traces, &request).map_err(|error| error.to_string())
    });
    let bearings = section(has_bearings, "loads of the bearings are", &traces, &mut left_out, |traces| {
        bearing_study(engine, traces, speed).map_err(|error| error.to_string())
    });
    let mounts = section(has_mounts, "the block on its mounts is", &traces, &mut left_out, |traces| {
        mounts(engine, &MountSpeeds::Range(MOUNT_SPEEDS), MOUNT_ORDERS, Some(traces), &[])
            .map_err(|error| error.to_string())
    });
    for message in &left_out {
        eprintln!("warning: {message}");
    }
    let of_torque = torque.iter().flat_map(|report| &report.warnings);
    let of_mounts = mounts.iter().flat_map(|study| &study.warnings);
    for warning in left_out.iter().chain(of_torque).chain(of_mounts) {
        if !warnings.contains(warning) {
            warnings.push(warning.clone());
        }
    }
    Running { torque, bearings, mounts }
}

/// One section, where it is `wanted`; why it is left out goes to `left_out`.
fn section<T>(
    wanted: bool,
    name: &str,
    traces: &Result<Vec<TraceFile>, Failure>,
    left_out: &mut Vec<String>,
    of: impl FnOnce(&[TraceFile]) -> Result<T, String>,
) -> Option<T> {
    if !wanted {
        return None;
    }
    let found = match traces {
        Ok(traces) => of(traces),
        Err(failure) => Err(failure.message.clone()),
    };
    let because = |error: String| {
        let error = error.strip_prefix("error: ").unwrap_or(&error);
        left_out.push(format!("{name} left out: {error}").replace("\nhint:", ";"));
    };
    found.map_err(because).ok()
}

/// Torque for the report.
pub fn torque_input(report: &TorqueReport) -> TorqueInput<'_> {
    TorqueInput {
        torque: &report.torque,
        source: &report.source,
        brake: report.brake.as_ref(),
        ripples: &report.ripples,
        flywheel: report.flywheel.as_ref(),
        speeds: &report.speeds,
        power: report.power.as_ref(),
    }
}

/// Bearings for the report.
pub fn bearings_input<'a>(engine: &Engine, study: &'a BearingStudy) -> BearingsInput<'a> {
    BearingsInput { parts: &study.parts, bare: study.bare.as_ref(), sizes: bearing_sizes(engine) }
}
