//! Measured pressures of an engine at one speed.

use crate::pressure::error::GasError;
use lanchester_cycle::{
    CylinderVolume, MeasuredTrace, TraceError, TraceFault, TraceOptions, TracePlace, at_speed, check_firing,
    read_trace,
};
use lanchester_model::{Gas, PressureTrace};
use lanchester_results::PeriodicCurve;

/// A file that the engine file names, with its text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TraceFile {
    /// Its name as the engine file gives it.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// One curve for each cylinder, and what is to be said of the files.
pub(crate) struct Measured {
    pub(crate) curves: Vec<PeriodicCurve>,
    pub(crate) warnings: Vec<String>,
}

/// The pressures of named files at a speed of crankshaft 1 [rad/s].
pub(crate) fn pressures(
    named: &[PressureTrace],
    files: &[TraceFile],
    gas: &Gas,
    volumes: &[CylinderVolume],
    speed: f64,
    place: TracePlace,
) -> Result<Measured, GasError> {
    let mut warnings = Vec::new();
    let mut measured: Vec<(Option<f64>, Vec<PeriodicCurve>)> = Vec::new();
    for trace in named {
        let file = files
            .iter()
            .find(|file| file.name == trace.file)
            .ok_or_else(|| GasError::MissingTrace { name: trace.file.clone() })?;
        let options = TraceOptions {
            name: &trace.file,
            cycle: volumes.first().map_or(0.0, CylinderVolume::cycle),
            gauge: trace.gauge,
            ambient_pressure: gas.ambient_pressure,
            top_dead_centre: trace.top_dead_centre,
            place,
        };
        let read = read_trace(&file.text, &options)?;
        warnings.extend(read.warnings.iter().cloned());
        let curves = of_cylinders(trace, &read, volumes, place, &mut warnings)?;
        measured.push((trace.speed, curves));
    }
    measured.sort_by(|one, two| one.0.unwrap_or(0.0).total_cmp(&two.0.unwrap_or(0.0)));
    let mut curves = Vec::new();
    let mut is_held = false;
    for cylinder in 0..volumes.len() {
        let own: Vec<(Option<f64>, &PeriodicCurve)> =
            measured.iter().map(|(speed, curves)| (*speed, &curves[cylinder])).collect();
        let (curve, held) = at_speed(&own, speed)?;
        is_held |= held;
        curves.push(curve);
    }
    if is_held {
        let rpm = |speed: f64| speed * 30.0 / std::f64::consts::PI;
        let speeds: Vec<f64> = measured.iter().filter_map(|(speed, _)| speed.map(rpm)).collect();
        let (low, high) = (speeds.first().copied().unwrap_or(0.0), speeds.last().copied().unwrap_or(0.0));
        let nearest = if rpm(speed) < low { low } else { high };
        warnings.push(format!(
            "{:.0} rpm lies outside the measured speeds ({low:.0} to {high:.0} rpm): the pressures of {nearest:.0} rpm are held",
            rpm(speed)
        ));
    }
    Ok(Measured { curves, warnings })
}

/// The columns of a file, one for each cylinder, over the angle since its own firing top dead centre.
fn of_cylinders(
    trace: &PressureTrace,
    read: &MeasuredTrace,
    volumes: &[CylinderVolume],
    place: TracePlace,
    warnings: &mut Vec<String>,
) -> Result<Vec<PeriodicCurve>, TraceError> {
    let fault = |fault| TraceError { file: trace.file.clone(), line: None, fault };
    let (got, cylinders) = (read.columns.len(), volumes.len());
    // Pistons that share a chamber have one pressure: a column for each chamber, or that of its first cylinder.
    let mut chambers: Vec<usize> = volumes.iter().map(CylinderVolume::chamber).collect();
    chambers.sort_unstable();
    chambers.dedup();
    let of_chambers = place == TracePlace::Cylinder && got == chambers.len();
    if got != 1 && got != cylinders && !of_chambers {
        return Err(fault(TraceFault::Columns { got, cylinders }));
    }
    let mut curves = Vec::new();
    for (cylinder, volume) in volumes.iter().enumerate() {
        let first = if place == TracePlace::Cylinder { volume.chamber() } else { cylinder };
        let number = match (got, of_chambers) {
            (1, _) => 0,
            (_, true) => chambers.iter().position(|chamber| *chamber == first).unwrap_or(first),
            (_, false) => first,
        };
        let (heading, column) = &read.columns[number];
        let curve = if trace.counted_from_first && got > 1 {
            // The column is over the angle since the firing of cylinder 1.
            column.delayed(volume.own_angle(volumes[0].firing_angle()))
        } else {
            column.clone()
        };
        if place == TracePlace::Cylinder && (got > 1 || cylinder == 0) && first == cylinder {
            let said = check_firing(heading, &curve, volume).map_err(fault)?;
            warnings.extend(said.into_iter().map(|warning| format!("{}: {warning}", trace.file)));
        }
        curves.push(curve);
    }
    Ok(curves)
}
