//! Influence coefficients: what a weight in a plane does to a sensor, fitted to all runs at once.

use crate::error::WorkshopError;
use crate::rotor::history::History;
use crate::rotor::least_squares::Decomposition;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// What the runs of one speed say about one sensor: `v = initial + SUM over planes of response u`.
#[derive(Debug, Clone)]
pub(crate) struct SensorFit {
    /// Place of the speed in [`History::speeds`].
    pub(crate) group: usize,
    pub(crate) sensor: usize,
    /// Velocity without any weight [m/s].
    pub(crate) initial: Complex64,
    /// Velocity per unbalance of each plane of the fit [m/s per kg m].
    pub(crate) responses: Vec<Complex64>,
    /// The runs of the fit, with measured less fitted velocity [m/s].
    pub(crate) residuals: Vec<(usize, Complex64)>,
    /// Readings beyond the unknowns.
    pub(crate) freedom: usize,
    /// Standard deviation of the initial velocity and of each response for one of the readings.
    spread: Vec<f64>,
}

impl SensorFit {
    /// Standard deviation of a reading [m/s]; `None` where there are no more readings than unknowns.
    pub(crate) fn deviation(&self) -> Option<f64> {
        let squares: f64 = self.residuals.iter().map(|(_, residual)| residual.norm_sqr()).sum();
        (self.freedom > 0).then(|| (squares / self.freedom as f64).sqrt())
    }

    /// Standard deviation of each response [m/s per kg m].
    pub(crate) fn response_deviations(&self) -> Option<Vec<f64>> {
        self.deviation().map(|one| self.spread.iter().skip(1).map(|spread| spread * one).collect())
    }

    /// Velocity with these unbalances in the planes of the fit [m/s].
    pub(crate) fn velocity(&self, unbalances: &[Complex64]) -> Complex64 {
        self.initial
            + self.responses.iter().zip(unbalances).map(|(response, u)| response * u).sum::<Complex64>()
    }
}

/// Fits every sensor at every speed to all runs.
///
/// # Errors
/// [`WorkshopError`] where a plane's effect cannot be told, with the run or the weights that are needed.
pub(crate) fn fits(history: &History<'_>, planes: &[usize]) -> Result<Vec<SensorFit>, WorkshopError> {
    check_speeds(history)?;
    let mut fits = Vec::new();
    for group in 0..history.speeds.len() {
        let runs: Vec<usize> =
            (0..history.runs.len()).filter(|run| history.runs[*run].group == group).collect();
        check_group(history, planes, group, &runs)?;
        for sensor in history.sensors(group) {
            let fit = sensor_fit(history, planes, group, sensor, history.runs.len()).ok_or_else(|| {
                WorkshopError::SensorMissing {
                    sensor: history.sheet.sensors[sensor].name.clone(),
                    run: runs
                        .iter()
                        .find(|run| history.runs[**run].velocities[sensor].is_none())
                        .map_or_else(String::new, |run| history.sheet.runs[*run].name.clone()),
                }
            })?;
            fits.push(fit);
        }
    }
    Ok(fits)
}

/// Fits one sensor at one speed to the runs before `end`; `None` where they do not determine every response.
pub(crate) fn sensor_fit(
    history: &History<'_>,
    planes: &[usize],
    group: usize,
    sensor: usize,
    end: usize,
) -> Option<SensorFit> {
    let measured: Vec<(usize, Complex64)> = history.runs[..end]
        .iter()
        .enumerate()
        .filter(|(_, run)| run.group == group)
        .filter_map(|(index, run)| Some((index, run.velocities[sensor]?)))
        .collect();
    let rows: Vec<Vec<Complex64>> = measured.iter().map(|(run, _)| row(history, planes, *run)).collect();
    let data: Vec<Complex64> = measured.iter().map(|(_, velocity)| *velocity).collect();
    let decomposition = Decomposition::of(&rows);
    if rows.is_empty() || !decomposition.is_full() {
        return None;
    }
    let unknowns = decomposition.solve(&data);
    let residuals = measured
        .iter()
        .zip(&rows)
        .map(|((run, velocity), row)| {
            let fitted: Complex64 = row.iter().zip(&unknowns).map(|(a, x)| a * x).sum();
            (*run, velocity - fitted)
        })
        .collect();
    Some(SensorFit {
        group,
        sensor,
        initial: unknowns[0],
        responses: unknowns[1..].to_vec(),
        residuals,
        freedom: rows.len() - unknowns.len(),
        spread: decomposition.spread(),
    })
}

fn row(history: &History<'_>, planes: &[usize], run: usize) -> Vec<Complex64> {
    let during = &history.runs[run].during;
    std::iter::once(Complex64::new(1.0, 0.0)).chain(planes.iter().map(|plane| during[*plane])).collect()
}

/// Whether no run stands alone at its speed.
fn check_speeds(history: &History<'_>) -> Result<(), WorkshopError> {
    let runs = &history.sheet.runs;
    let alone = |index: &usize| {
        let group = history.runs[*index].group;
        history.runs.iter().filter(|run| run.group == group).count() == 1
    };
    let Some(index) = (0..runs.len()).find(alone).filter(|_| runs.len() > 1) else { return Ok(()) };
    // The first run of all may itself be the one that stands alone.
    let other = if index == 0 { &runs[1] } else { &runs[0] };
    Err(WorkshopError::OtherSpeed {
        run: runs[index].name.clone(),
        speed_rpm: runs[index].speed * 60.0 / TAU,
        other: other.name.clone(),
        other_rpm: other.speed * 60.0 / TAU,
    })
}

/// Whether the runs of a speed can tell the planes apart; if not, why.
fn check_group(
    history: &History<'_>,
    planes: &[usize],
    group: usize,
    runs: &[usize],
) -> Result<(), WorkshopError> {
    let sheet = history.sheet;
    let speed_rpm = history.speeds[group] * 60.0 / TAU;
    let untried = planes.iter().find(|plane| {
        let first = history.runs[runs[0]].during[**plane];
        runs.iter().all(|run| (history.runs[*run].during[**plane] - first).norm() <= 1e-9 * history.largest())
    });
    if let Some(plane) = untried {
        return Err(WorkshopError::NoTrial { plane: sheet.planes[*plane].name.clone(), speed_rpm });
    }
    let rows: Vec<Vec<Complex64>> = runs.iter().map(|run| row(history, planes, *run)).collect();
    let decomposition = Decomposition::of(&rows);
    if decomposition.is_full() {
        return Ok(());
    }
    if rows.len() <= planes.len() {
        let (got, needed) = (rows.len(), planes.len() + 1);
        return Err(WorkshopError::FewRuns { got, needed, speed_rpm });
    }
    let weakest = decomposition.weakest();
    let together = alike(&weakest[1..], planes, history);
    Err(WorkshopError::MovedTogether { planes: together, speed_rpm })
}

/// Names of the planes that make up most of a combination without effect.
pub(crate) fn alike(shares: &[f64], planes: &[usize], history: &History<'_>) -> Vec<String> {
    let most = shares.iter().copied().fold(0.0, f64::max);
    shares
        .iter()
        .zip(planes)
        .filter(|(share, _)| **share >= 0.3 * most)
        .map(|(_, plane)| history.sheet.planes[*plane].name.clone())
        .collect()
}
