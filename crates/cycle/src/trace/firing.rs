//! Whether a pressure belongs to its firing top dead centre and its sense of rotation.

use super::fault::TraceFault;
use crate::indicated::indicated;
use crate::volume::CylinderVolume;
use lanchester_results::PeriodicCurve;
use std::f64::consts::TAU;

/// Where the peak lies in any engine, from motored ones to late heat release [deg].
const PEAK: [f64; 2] = [-30.0, 60.0];
/// Mean effective pressures [Pa] below which a trace runs backwards, and below which it is odd.
const BACKWARDS: f64 = -2e5;
const ODD: f64 = -5e4;

/// The peak must lie near firing top dead centre, and the gas must not take up work; what is odd is told.
///
/// # Errors
/// [`TraceFault::PeakAngle`], [`TraceFault::Backwards`].
pub fn check_firing(
    heading: &str,
    pressure: &PeriodicCurve,
    volume: &CylinderVolume,
) -> Result<Vec<String>, TraceFault> {
    let gas = indicated(pressure, volume);
    let at = gas.peak_angle.to_degrees();
    if !(PEAK[0]..=PEAK[1]).contains(&at) {
        let turned = if at > 0.0 { at - 360.0 } else { at + 360.0 };
        let hint = if volume.cycle() > TAU && (PEAK[0]..=PEAK[1]).contains(&turned) {
            "the file counts from the top dead centre of the gas exchange: move `top_dead_centre` of the trace by 360 deg"
        } else {
            "the file counts from another angle: give the angle of the firing top dead centre as `top_dead_centre` of the trace"
        };
        return Err(TraceFault::PeakAngle {
            column: heading.to_string(),
            at,
            between: PEAK,
            hint: hint.into(),
        });
    }
    let mean = gas.mean_effective_pressure;
    if mean < BACKWARDS {
        let column = heading.to_string();
        return Err(TraceFault::Backwards { column, work: gas.work, mean_effective_pressure: mean });
    }
    if mean < ODD {
        return Ok(vec![format!(
            "\"{heading}\" takes up work (mean effective pressure {:.2} bar): is the engine motored, or does the trace run backwards?",
            mean / 1e5
        )]);
    }
    Ok(Vec::new())
}
