//! What was on the rotor in every run, and which runs belong together.

use crate::rotor::phasor::Convention;
use lanchester_task::workshop::{Action, Reading, Run, Sheet, VibrationQuantity};
use num_complex::Complex64;

/// Speeds that differ by no more than this share are one speed: machines hardly hold theirs better, and away from
/// resonance the vibration changes by a few times as much.
pub const SAME_SPEED: f64 = 0.01;

/// The runs of a sheet as vectors; unbalances and velocities as [`Convention`] makes them.
#[derive(Debug)]
pub(crate) struct History<'a> {
    pub(crate) sheet: &'a Sheet,
    pub(crate) convention: Convention,
    /// Speed of each group of runs: that of its first run [rad/s].
    pub(crate) speeds: Vec<f64>,
    pub(crate) runs: Vec<HistoryRun>,
    /// What the last run left on the rotor, per plane [kg m].
    pub(crate) now: Vec<Complex64>,
}

#[derive(Debug)]
pub(crate) struct HistoryRun {
    /// Its group: place in [`History::speeds`].
    pub(crate) group: usize,
    /// What earlier runs had left on the rotor, per plane [kg m].
    pub(crate) before: Vec<Complex64>,
    /// What was on it in the run.
    pub(crate) during: Vec<Complex64>,
    /// Velocity at each sensor [m/s]; `None` where it was not read.
    pub(crate) velocities: Vec<Option<Complex64>>,
}

impl<'a> History<'a> {
    /// The quantity in which a sensor is read; a sensor has one.
    pub(crate) fn quantity_of(&self, sensor: usize) -> VibrationQuantity {
        let readings = self.sheet.runs.iter().flat_map(|run| &run.readings);
        let of_sensor = readings.into_iter().find(|reading| reading.sensor == sensor);
        of_sensor.map_or(VibrationQuantity::Velocity, |reading| reading.vibration.quantity)
    }

    /// `None` where the conventions are not stated.
    pub(crate) fn of(sheet: &'a Sheet) -> Option<History<'a>> {
        let convention = Convention::of(&sheet.rotor)?;
        let mut now = vec![Complex64::default(); sheet.planes.len()];
        let mut speeds: Vec<f64> = Vec::new();
        let mut runs = Vec::with_capacity(sheet.runs.len());
        for run in &sheet.runs {
            let same = |speed: &f64| (run.speed - speed).abs() <= SAME_SPEED * speed;
            let group = speeds.iter().position(same).unwrap_or_else(|| {
                speeds.push(run.speed);
                speeds.len() - 1
            });
            let before = now.clone();
            let mut during = now.clone();
            for weight in &run.weights {
                let sign = if weight.action == Action::Add { 1.0 } else { -1.0 };
                let unbalance = convention.unbalance(sign * weight.unbalance, weight.angle);
                during[weight.plane] += unbalance;
                if weight.kept {
                    now[weight.plane] += unbalance;
                }
            }
            let velocities = velocities(sheet, &convention, run);
            runs.push(HistoryRun { group, before, during, velocities });
        }
        Some(History { sheet, convention, speeds, runs, now })
    }

    /// Planes that ever carried a weight, rising.
    pub(crate) fn tried(&self) -> Vec<usize> {
        (0..self.sheet.planes.len())
            .filter(|plane| self.runs.iter().any(|run| run.during[*plane].norm() > 0.0))
            .collect()
    }

    /// The largest unbalance that was ever on the rotor [kg m].
    pub(crate) fn largest(&self) -> f64 {
        self.runs
            .iter()
            .flat_map(|run| &run.during)
            .fold(0.0, |most: f64, unbalance| most.max(unbalance.norm()))
    }

    /// Whether the same weights were on the rotor, but for rounding.
    pub(crate) fn same(&self, one: &[Complex64], other: &[Complex64]) -> bool {
        let rounding = 1e-9 * self.largest();
        one.iter().zip(other).all(|(a, b)| (a - b).norm() <= rounding)
    }

    /// Sensors with a reading in some run of the group, rising.
    pub(crate) fn sensors(&self, group: usize) -> Vec<usize> {
        (0..self.sheet.sensors.len())
            .filter(|sensor| {
                self.runs.iter().any(|run| run.group == group && run.velocities[*sensor].is_some())
            })
            .collect()
    }
}

fn velocities(sheet: &Sheet, convention: &Convention, run: &Run) -> Vec<Option<Complex64>> {
    let of = |reading: &Reading| {
        let sensor = &sheet.sensors[reading.sensor];
        convention.velocity(sensor, reading.vibration, reading.phase, run.speed)
    };
    (0..sheet.sensors.len())
        .map(|sensor| run.readings.iter().find(|reading| reading.sensor == sensor).map(of))
        .collect()
}
