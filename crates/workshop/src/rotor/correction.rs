//! Where to add or remove how much: from vibration with trial weights, or from a balancing machine's display.

use crate::error::WorkshopError;
use crate::rotor::allowed::split;
use crate::rotor::grade::{Grade, of_unbalances};
use crate::rotor::history::History;
use crate::rotor::influence::{SensorFit, alike, fits};
use crate::rotor::least_squares::Decomposition;
use crate::rotor::plane::{Plane as NamedPlane, PlaneUnbalance, in_two_planes};
use crate::rotor::remark::{ILL_CONDITIONED, Remark, remarks};
use crate::rotor::run_log::{RunEntry, ShownVibration, run_log, shown};
use lanchester_task::workshop::{Action, Plane, Sheet, VibrationQuantity};
use num_complex::Complex64;
use serde::Serialize;

/// What to do about the unbalance of a rotor.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Correction {
    /// [`WORKSHOP_VERSION`](crate::WORKSHOP_VERSION).
    pub version: u32,
    /// Name of the sheet.
    pub name: String,
    /// What the runs say; `None` for a correction from a display.
    pub runs: Option<RunFindings>,
    /// What to add or remove, plane by plane. Empty before any trial weight.
    pub planes: Vec<PlaneCorrection>,
    /// The balance quality grade as the rotor is now, where mass, service speed, grade and the places of the planes
    /// are given.
    pub grade_now: Option<Grade>,
    /// The same with the corrections made as told.
    pub grade_after: Option<Grade>,
    /// Doubts.
    pub remarks: Vec<Remark>,
    /// Whether every limit that the sheet states holds now; `None` where none is stated or nothing measured.
    pub holds: Option<bool>,
    /// What to do next.
    pub next: NextStep,
}

/// What measured runs say.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct RunFindings {
    /// Every run, with what the runs before it predicted.
    pub log: Vec<RunEntry>,
    /// Effect of each plane on each sensor at each speed.
    pub influence: Vec<Influence>,
    /// Condition of the influence coefficients, with the planes' effects at equal size; 1 is best.
    pub condition: Option<f64>,
    /// Every sensor at every speed: as the rotor is now, and as predicted with the correction.
    pub sensors: Vec<SensorPrediction>,
}

/// Effect of a weight in one plane on one sensor at one speed.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Influence {
    /// Name of the plane.
    pub plane: String,
    /// Name of the sensor.
    pub sensor: String,
    /// Speed [rad/s].
    pub speed: f64,
    /// Peak velocity per unbalance [m/s per kg m]; its argument is the angle by which the peak of the velocity leads the
    /// passing of the heavy spot at the sensor, whatever the conventions of the sheet.
    #[schemars(with = "[f64; 2]")]
    pub response: Complex64,
    /// Its standard deviation [same unit]; `None` where the runs leave no freedom.
    pub deviation: Option<f64>,
    /// Quantity in which the sensor is read.
    pub quantity: VibrationQuantity,
    /// Amplitude per unbalance as the sensor's detector gives it [m, m/s or m/s^2 per kg m].
    pub shown: f64,
}

/// A sensor at one speed.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SensorPrediction {
    /// Name of the sensor.
    pub sensor: String,
    /// Speed [rad/s].
    pub speed: f64,
    /// Standard deviation of one reading as the sensor's detector gives it, from what the fit leaves over; `None` where
    /// the runs leave no freedom.
    pub scatter: Option<f64>,
    /// As the rotor is now: as measured, or as fitted where the last run's weights were taken off again.
    pub now: ShownVibration,
    /// With the corrections made as told.
    pub after: Option<ShownVibration>,
    /// Largest amplitude accepted, as the sensor's detector gives it.
    pub limit: Option<f64>,
}

/// What to add or remove in one plane.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PlaneCorrection {
    /// Name of the plane.
    pub plane: String,
    /// Whether weight is added or removed.
    pub action: Action,
    /// Unbalance to put on [kg m]: its argument is the angle on the rotor at which weight would be added.
    #[schemars(with = "[f64; 2]")]
    pub unbalance: Complex64,
    /// What to do at which allowed angles.
    pub placements: Vec<Placement>,
    /// What these leave undone, as an unbalance to put on [kg m].
    #[schemars(with = "[f64; 2]")]
    pub left: Complex64,
}

/// A weight to add or remove at an allowed angle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Placement {
    /// Angle on the rotor [rad], within [0, 2 pi).
    pub angle: f64,
    /// Mass times radius [kg m].
    pub unbalance: f64,
    /// Mass at the radius of the plane [kg], where that is given.
    pub mass: Option<f64>,
}

/// What to do next.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum NextStep {
    /// Run with a trial weight in each of these planes, one after the other.
    Try {
        /// Names of the planes.
        planes: Vec<String>,
    },
    /// Settle the serious doubts first: the corrections told may be wrong.
    Settle,
    /// Make the corrections told, run again and add the run to the sheet.
    Correct,
    /// Nothing: every limit holds.
    Finished,
}

/// The correction of a sheet: from its runs, or from its displays.
///
/// From runs, the influence coefficients of all planes are fitted to all runs at once, and the weights are those that
/// leave the least sum of squared peak velocities over all sensors and speeds:
///
/// ```text
/// v_r = v_0 + SUM over planes of A_p u_pr          fitted over the runs r, for each sensor and speed
/// SUM over sensors and speeds of |v + SUM A_p x_p|^2 -> least          v: as the rotor is now
/// ```
/// From displays, the weights take away resultant and moment; with one plane the resultant alone.
///
/// # Errors
/// [`WorkshopError`] where the sheet has neither, or both, or its data cannot tell the planes apart.
pub fn correction(sheet: &Sheet) -> Result<Correction, WorkshopError> {
    match (sheet.runs.is_empty(), sheet.displays.is_empty()) {
        (false, true) => from_runs(sheet),
        (true, false) => from_displays(sheet),
        (true, true) => Err(WorkshopError::missing(
            "a measurement",
            "a correction",
            "add [[run]] with readings of vibration sensors, or [[display]] from a balancing machine",
        )),
        (false, false) => Err(WorkshopError::Impossible {
            what: "the sheet has both runs and displays, and each gives its own correction".into(),
            hint: "keep one of the two in this sheet",
        }),
    }
}

fn from_runs(sheet: &Sheet) -> Result<Correction, WorkshopError> {
    let history = History::of(sheet).ok_or_else(|| {
        WorkshopError::missing(
            "the sense of marks, rotation and phase",
            "runs",
            "add marks, rotation and phase to [rotor]",
        )
    })?;
    let tried = history.tried();
    let fits = if tried.is_empty() { Vec::new() } else { fits(&history, &tried)? };
    let (unbalances, condition) = if tried.is_empty() {
        (Vec::new(), None)
    } else {
        let (unbalances, condition) = least_vibration(&history, &tried, &fits)?;
        (unbalances, Some(condition))
    };
    let planes: Vec<PlaneCorrection> = tried
        .iter()
        .zip(&unbalances)
        .map(|(plane, unbalance)| placed(&sheet.planes[*plane], history.convention.on_rotor(*unbalance)))
        .collect();
    let made: Vec<Complex64> =
        planes.iter().map(|plane| history.convention.on_rotor(plane.unbalance - plane.left)).collect();
    let sensors = predictions(&history, &tried, &fits, &made);
    let log = run_log(&history);
    let residual = |over: &dyn Fn(&PlaneCorrection) -> Complex64| {
        let planes: Option<Vec<PlaneUnbalance>> = planes
            .iter()
            .zip(&tried)
            .map(|(plane, index)| {
                let (name, z) = (plane.plane.clone(), sheet.planes[*index].z?);
                Some(PlaneUnbalance { name, z, unbalance: -over(plane) })
            })
            .collect();
        planes.filter(|planes| !planes.is_empty())
    };
    let grade_now = graded(sheet, residual(&|plane| plane.unbalance))?;
    let grade_after = graded(sheet, residual(&|plane| plane.left))?;
    let mut remarks = remarks(&history, &fits);
    if let Some(condition) = condition.filter(|condition| *condition > ILL_CONDITIONED) {
        let decomposition = Decomposition::of(&response_rows(&tried, &fits));
        remarks.push(Remark::ill_conditioned(condition, &alike(&decomposition.weakest(), &tried, &history)));
    }
    let holds = verdict(
        sensors.iter().filter_map(|sensor| Some(sensor.now.amplitude <= sensor.limit?)),
        grade_now.as_ref(),
    );
    let next = match (holds, tried.is_empty()) {
        (Some(true), _) => NextStep::Finished,
        (_, true) => NextStep::Try { planes: sheet.planes.iter().map(|plane| plane.name.clone()).collect() },
        _ if remarks.iter().any(|remark| remark.kind.is_serious()) => NextStep::Settle,
        _ => NextStep::Correct,
    };
    let influence = influence(&history, &tried, &fits);
    Ok(Correction {
        version: crate::WORKSHOP_VERSION,
        name: sheet.name.clone(),
        runs: Some(RunFindings { log, influence, condition, sensors }),
        planes,
        grade_now,
        grade_after,
        remarks,
        holds,
        next,
    })
}

fn response_rows(planes: &[usize], fits: &[SensorFit]) -> Vec<Vec<Complex64>> {
    debug_assert!(fits.iter().all(|fit| fit.responses.len() == planes.len()));
    fits.iter().map(|fit| fit.responses.clone()).collect()
}

/// The unbalances to put on that leave the least vibration, and the condition of the coefficients.
fn least_vibration(
    history: &History<'_>,
    planes: &[usize],
    fits: &[SensorFit],
) -> Result<(Vec<Complex64>, f64), WorkshopError> {
    if fits.len() < planes.len() {
        return Err(WorkshopError::FewReadings { readings: fits.len(), planes: planes.len() });
    }
    let decomposition = Decomposition::of(&response_rows(planes, fits));
    if !decomposition.is_full() {
        let planes = alike(&decomposition.weakest(), planes, history);
        return Err(WorkshopError::Singular { planes });
    }
    let on_rotor: Vec<Complex64> = planes.iter().map(|plane| history.now[*plane]).collect();
    let now: Vec<Complex64> = fits.iter().map(|fit| -fit.velocity(&on_rotor)).collect();
    Ok((decomposition.solve(&now), decomposition.condition()))
}

fn influence(history: &History<'_>, planes: &[usize], fits: &[SensorFit]) -> Vec<Influence> {
    let mut out = Vec::with_capacity(fits.len() * planes.len());
    for fit in fits {
        let (sensor, speed) = (&history.sheet.sensors[fit.sensor], history.speeds[fit.group]);
        let quantity = history.quantity_of(fit.sensor);
        let deviations = fit.response_deviations();
        for (k, plane) in planes.iter().enumerate() {
            let response = fit.responses[k];
            out.push(Influence {
                plane: history.sheet.planes[*plane].name.clone(),
                sensor: sensor.name.clone(),
                speed,
                response,
                deviation: deviations.as_ref().map(|all| all[k]),
                quantity,
                shown: history.convention.shown(sensor, quantity, response, speed).0.amplitude,
            });
        }
    }
    out
}

fn predictions(
    history: &History<'_>,
    planes: &[usize],
    fits: &[SensorFit],
    made: &[Complex64],
) -> Vec<SensorPrediction> {
    let mut out = Vec::new();
    for (group, speed) in history.speeds.iter().copied().enumerate() {
        for sensor in history.sensors(group) {
            let fit = fits.iter().find(|fit| fit.group == group && fit.sensor == sensor);
            let on_rotor = |more: &[Complex64]| -> Vec<Complex64> {
                planes
                    .iter()
                    .enumerate()
                    .map(|(k, p)| history.now[*p] + more.get(k).unwrap_or(&Complex64::default()))
                    .collect()
            };
            // A measurement counts for more than a fit.
            let measured = history
                .runs
                .iter()
                .rev()
                .filter(|run| run.group == group && history.same(&run.during, &history.now))
                .find_map(|run| run.velocities[sensor]);
            let Some(now) = measured.or_else(|| fit.map(|fit| fit.velocity(&on_rotor(&[])))) else {
                continue;
            };
            let place = &history.sheet.sensors[sensor];
            let to_shown = |velocity: f64| {
                history
                    .convention
                    .shown(place, history.quantity_of(sensor), Complex64::from(velocity), speed)
                    .0
                    .amplitude
            };
            let limit = place.limit.map(|limit| {
                let velocity = history.convention.velocity(place, limit, 0.0, speed).norm();
                to_shown(velocity)
            });
            out.push(SensorPrediction {
                sensor: place.name.clone(),
                speed,
                scatter: fit.and_then(SensorFit::deviation).map(to_shown),
                now: shown(history, sensor, now, speed),
                after: fit.map(|fit| shown(history, sensor, fit.velocity(&on_rotor(made)), speed)),
                limit,
            });
        }
    }
    out
}

fn from_displays(sheet: &Sheet) -> Result<Correction, WorkshopError> {
    let shown = crate::displayed(&sheet.displays);
    let placed_planes: Vec<(&Plane, f64)> =
        sheet.planes.iter().filter_map(|plane| Some((plane, plane.z?))).collect();
    let wanted: Vec<Complex64> = match placed_planes.as_slice() {
        [_] => vec![shown.iter().map(|at| -at.unbalance).sum()],
        [(one, z_one), (other, z_other)] => {
            let planes = [(one, z_one), (other, z_other)]
                .map(|(plane, z)| NamedPlane { name: plane.name.clone(), z: *z });
            in_two_planes(&shown, &planes)?.map(|at| -at.unbalance).to_vec()
        }
        [] => {
            return Err(WorkshopError::missing(
                "a [[plane]] with its place z",
                "a correction from a display",
                "add one or two planes, each with z",
            ));
        }
        more => {
            return Err(WorkshopError::Impossible {
                what: format!("{} planes have a place, and a display determines weights in two", more.len()),
                hint: "keep the one or two planes that shall be used",
            });
        }
    };
    let planes: Vec<PlaneCorrection> =
        placed_planes.iter().zip(&wanted).map(|((plane, _), wanted)| placed(plane, *wanted)).collect();
    let after = placed_planes.iter().zip(&planes).map(|((_, z), plane)| PlaneUnbalance {
        name: plane.plane.clone(),
        z: *z,
        unbalance: plane.unbalance - plane.left,
    });
    let after: Vec<PlaneUnbalance> = shown.iter().cloned().chain(after).collect();
    let grade_now = graded(sheet, Some(shown))?;
    let grade_after = graded(sheet, Some(after))?;
    let holds = verdict(std::iter::empty(), grade_now.as_ref());
    Ok(Correction {
        version: crate::WORKSHOP_VERSION,
        name: sheet.name.clone(),
        runs: None,
        planes,
        grade_now,
        grade_after,
        remarks: Vec::new(),
        holds,
        next: if holds == Some(true) { NextStep::Finished } else { NextStep::Correct },
    })
}

/// The grade, where the sheet gives all that it needs.
pub(crate) fn graded(
    sheet: &Sheet,
    unbalances: Option<Vec<PlaneUnbalance>>,
) -> Result<Option<Grade>, WorkshopError> {
    let rotor = &sheet.rotor;
    match unbalances {
        Some(unbalances) if rotor.mass.is_some() && rotor.speed.is_some() && rotor.grade.is_some() => {
            of_unbalances(sheet, Some(&unbalances)).map(Some)
        }
        _ => Ok(None),
    }
}

/// Whether all limits hold; `None` where there is none, or where the grade is not judged and nothing else fails.
fn verdict(limits: impl Iterator<Item = bool>, grade: Option<&Grade>) -> Option<bool> {
    let limits = limits.reduce(|all, one| all && one);
    match (limits, grade.map(|grade| grade.kept)) {
        (Some(false), _) | (_, Some(Some(false))) => Some(false),
        (_, Some(None)) => None,
        (_, Some(Some(true))) => Some(true),
        (limits, None) => limits,
    }
}

/// The correction of one plane, split among its allowed angles.
pub(crate) fn placed(plane: &Plane, unbalance: Complex64) -> PlaneCorrection {
    let sign = if plane.action == Action::Add { 1.0 } else { -1.0 };
    let placements: Vec<Placement> = split(sign * unbalance, &plane.allowed)
        .into_iter()
        .map(|(angle, unbalance)| Placement {
            angle,
            unbalance,
            mass: plane.radius.map(|radius| unbalance / radius),
        })
        .collect();
    let made: Complex64 =
        placements.iter().map(|at| Complex64::from_polar(sign * at.unbalance, at.angle)).sum();
    PlaneCorrection {
        plane: plane.name.clone(),
        action: plane.action,
        unbalance,
        placements,
        left: unbalance - made,
    }
}
