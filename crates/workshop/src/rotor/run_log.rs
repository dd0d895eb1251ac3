//! The log of the runs: what each showed, and what the runs before it had predicted.

use crate::rotor::history::History;
use crate::rotor::influence::sensor_fit;
use lanchester_task::workshop::VibrationQuantity;
use num_complex::Complex64;
use serde::Serialize;

/// A run of the log.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct RunEntry {
    /// Name of the run.
    pub name: String,
    /// Speed [rad/s].
    pub speed: f64,
    /// What was on the rotor beyond its first state: name of the plane, unbalance on the rotor's circle [kg m].
    #[schemars(with = "Vec<(String, [f64; 2])>")]
    pub weights: Vec<(String, Complex64)>,
    /// Its sensors.
    pub sensors: Vec<SensorEntry>,
}

/// A sensor in a run of the log.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SensorEntry {
    /// Name of the sensor.
    pub sensor: String,
    /// As measured.
    pub measured: ShownVibration,
    /// As the runs before predict it; `None` where they do not tell the effect of every weight on the rotor.
    pub predicted: Option<ShownVibration>,
    /// Measured less predicted: amplitude of the difference as the sensor's detector gives it.
    pub missed: Option<f64>,
}

/// A vibration as the instrument shows it, and as a vector to be drawn.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ShownVibration {
    /// What the sensor measures.
    pub quantity: VibrationQuantity,
    /// Amplitude as the sensor's detector gives it [m, m/s or m/s^2].
    pub amplitude: f64,
    /// Phase in the convention of the sheet [rad], within [0, 2 pi).
    pub phase: f64,
}

impl ShownVibration {
    /// Amplitude and phase as a complex number.
    pub fn vector(&self) -> Complex64 {
        Complex64::from_polar(self.amplitude, self.phase)
    }
}

/// A velocity as the instrument shows it.
pub(crate) fn shown(history: &History<'_>, sensor: usize, velocity: Complex64, speed: f64) -> ShownVibration {
    let place = &history.sheet.sensors[sensor];
    let (vibration, phase) = history.convention.shown(place, history.quantity_of(sensor), velocity, speed);
    ShownVibration { quantity: vibration.quantity, amplitude: vibration.amplitude, phase }
}

/// The log of all runs. Coefficients are refined with every run: each is predicted from all that came before.
pub(crate) fn run_log(history: &History<'_>) -> Vec<RunEntry> {
    history
        .runs
        .iter()
        .enumerate()
        .map(|(index, run)| {
            let source = &history.sheet.runs[index];
            let sensors = run.velocities.iter().enumerate().filter_map(|(sensor, velocity)| {
                let velocity = (*velocity)?;
                let predicted = predicted(history, index, sensor);
                let missed = predicted
                    .map(|predicted| shown(history, sensor, velocity - predicted, source.speed).amplitude);
                Some(SensorEntry {
                    sensor: history.sheet.sensors[sensor].name.clone(),
                    measured: shown(history, sensor, velocity, source.speed),
                    predicted: predicted.map(|velocity| shown(history, sensor, velocity, source.speed)),
                    missed,
                })
            });
            let weights = run
                .during
                .iter()
                .zip(&history.sheet.planes)
                .filter(|(unbalance, _)| unbalance.norm() > 1e-9 * history.largest())
                .map(|(unbalance, plane)| (plane.name.clone(), history.convention.on_rotor(*unbalance)));
            RunEntry {
                name: source.name.clone(),
                speed: source.speed,
                weights: weights.collect(),
                sensors: sensors.collect(),
            }
        })
        .collect()
}

/// What the runs before `index` at its speed predict for a sensor of it.
fn predicted(history: &History<'_>, index: usize, sensor: usize) -> Option<Complex64> {
    let run = &history.runs[index];
    let earlier = || history.runs[..index].iter().filter(|other| other.group == run.group);
    let moved = |unbalances: &[Complex64], plane: usize| unbalances[plane].norm() > 0.0;
    let planes: Vec<usize> = (0..history.sheet.planes.len())
        .filter(|plane| earlier().any(|other| moved(&other.during, *plane)))
        .collect();
    if (0..history.sheet.planes.len()).any(|plane| moved(&run.during, plane) && !planes.contains(&plane)) {
        return None;
    }
    let fit = sensor_fit(history, &planes, run.group, sensor, index)?;
    let unbalances: Vec<Complex64> = planes.iter().map(|plane| run.during[*plane]).collect();
    Some(fit.velocity(&unbalances))
}
