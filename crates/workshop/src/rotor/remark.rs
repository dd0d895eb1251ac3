//! Doubts about a set of runs.

use crate::rotor::history::History;
use crate::rotor::influence::SensorFit;
use num_complex::Complex64;
use serde::Serialize;

/// A weight that changes the amplitude by less than this share and the phase by less than [`LEAST_TURN`] at every
/// sensor is too small to tell: reading errors of some per cent and degrees are usual.
pub const LEAST_CHANGE: f64 = 0.15;
/// See [`LEAST_CHANGE`]; 15 degrees [rad].
pub const LEAST_TURN: f64 = 0.261_799_387_799_149_4;
/// Effects below so many standard deviations of a reading are lost in the scatter.
const SCATTERS: f64 = 3.0;
/// Runs contradict each other where the fit leaves more than this share of the effects of the weights.
pub const CONTRADICTION: f64 = 0.1;
/// Above this condition an error of 5 % in a reading may double or halve the correction.
pub(crate) const ILL_CONDITIONED: f64 = 20.0;

/// A doubt about the data, with what to do.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Remark {
    /// Which doubt.
    pub kind: RemarkKind,
    /// What is doubtful, with numbers.
    pub message: String,
    /// What to do.
    pub hint: &'static str,
}

/// Kinds of doubts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RemarkKind {
    /// A trial weight that changes too little.
    WeakTrial,
    /// Runs that no one set of influence coefficients explains.
    Contradiction,
    /// Influence coefficients that magnify errors.
    IllConditioned,
    /// A plane without a trial run.
    Untried,
}

impl RemarkKind {
    /// Whether a correction should wait until the doubt is settled.
    pub fn is_serious(self) -> bool {
        match self {
            RemarkKind::WeakTrial | RemarkKind::Contradiction | RemarkKind::IllConditioned => true,
            RemarkKind::Untried => false,
        }
    }
}

impl Remark {
    pub(crate) fn ill_conditioned(condition: f64, planes: &[String]) -> Remark {
        Remark {
            kind: RemarkKind::IllConditioned,
            message: format!(
                "weights in {} act almost alike: condition {condition:.0}, so that an error of 1 % in a reading may become \
                 one of {condition:.0} % in the weights",
                planes.join(" and ")
            ),
            hint: "correct in fewer planes, or add a sensor at the other bearing or runs at another speed",
        }
    }
}

/// Weak trials, contradictions and planes without a trial.
pub(crate) fn remarks(history: &History<'_>, fits: &[SensorFit]) -> Vec<Remark> {
    let contradiction = contradiction(history, fits);
    let mut remarks = weak_trials(history, fits, contradiction.is_some());
    remarks.extend(contradiction);
    let tried = history.tried();
    if !tried.is_empty() {
        let planes = history.sheet.planes.iter().enumerate();
        for (_, plane) in planes.filter(|(k, _)| !tried.contains(k)) {
            remarks.push(Remark {
                kind: RemarkKind::Untried,
                message: format!("plane \"{}\" has had no weight in any run and is not used", plane.name),
                hint: "make a run with a trial weight in it to use it too",
            });
        }
    }
    remarks
}

/// Trials whose effect is too small, or lost in the scatter; runs that contradict each other scatter for another reason.
fn weak_trials(history: &History<'_>, fits: &[SensorFit], contradicting: bool) -> Vec<Remark> {
    let mut remarks = Vec::new();
    for (index, run) in history.runs.iter().enumerate() {
        if history.same(&run.before, &run.during) {
            continue;
        }
        // The last run with the rotor as it was before this run's weights.
        let Some(reference) = history.runs[..index]
            .iter()
            .rev()
            .find(|other| other.group == run.group && history.same(&other.during, &run.before))
        else {
            continue;
        };
        let pairs: Vec<(usize, Complex64, Complex64)> = run
            .velocities
            .iter()
            .zip(&reference.velocities)
            .enumerate()
            .filter_map(|(sensor, (with, without))| Some((sensor, (*without)?, (*with)?)))
            .collect();
        if pairs.is_empty() {
            continue;
        }
        let name = &history.sheet.runs[index].name;
        let unchanged = |(_, without, with): &(usize, Complex64, Complex64)| {
            without.norm() > 0.0
                && (with.norm() / without.norm() - 1.0).abs() < LEAST_CHANGE
                && (with / without).arg().abs() < LEAST_TURN
        };
        let scattered = |(sensor, without, with): &(usize, Complex64, Complex64)| {
            fits.iter()
                .find(|fit| fit.group == run.group && fit.sensor == *sensor)
                .and_then(SensorFit::deviation)
                .is_some_and(|deviation| (with - without).norm() < SCATTERS * deviation)
        };
        let message = if pairs.iter().all(unchanged) {
            let (change, turn) = pairs.iter().fold((0.0f64, 0.0f64), |(change, turn), (_, without, with)| {
                let ratio = with / without;
                (change.max((ratio.norm() - 1.0).abs()), turn.max(ratio.arg().abs()))
            });
            format!(
                "the weights of {name} are too small to tell: at every sensor they change the amplitude by at most \
                 {:.0} % and the phase by at most {:.0} deg",
                100.0 * change,
                turn.to_degrees()
            )
        } else if !contradicting && pairs.iter().all(scattered) {
            format!("the effect of the weights of {name} is lost in the scatter of the readings")
        } else {
            continue;
        };
        remarks.push(Remark {
            kind: RemarkKind::WeakTrial,
            message,
            hint: "repeat the run with a heavier weight, or with the weight at another angle",
        });
    }
    remarks
}

fn contradiction(history: &History<'_>, fits: &[SensorFit]) -> Option<Remark> {
    let free: Vec<&SensorFit> = fits.iter().filter(|fit| fit.freedom > 0).collect();
    let tried = history.tried();
    let (mut left, mut freedom, mut effects, mut count) = (0.0, 0, 0.0, 0);
    let mut of_runs = vec![0.0; history.runs.len()];
    for fit in &free {
        freedom += fit.freedom;
        for (run, residual) in &fit.residuals {
            left += residual.norm_sqr();
            of_runs[*run] += residual.norm_sqr();
            let on_rotor: Vec<Complex64> =
                tried.iter().map(|plane| history.runs[*run].during[*plane]).collect();
            let effect = (fit.velocity(&on_rotor) - fit.initial).norm_sqr();
            if effect > 0.0 {
                effects += effect;
                count += 1;
            }
        }
    }
    if freedom == 0 || count == 0 {
        return None;
    }
    let share = (left / freedom as f64).sqrt() / (effects / count as f64).sqrt();
    if share <= CONTRADICTION {
        return None;
    }
    let worst = (0..of_runs.len()).max_by(|a, b| of_runs[*a].total_cmp(&of_runs[*b]))?;
    Some(Remark {
        kind: RemarkKind::Contradiction,
        message: format!(
            "the runs contradict each other: one set of influence coefficients leaves {:.0} % of the effect of the weights \
             over, most of it in {}",
            100.0 * share,
            history.sheet.runs[worst].name
        ),
        hint: "check that run's angle, sign and whether its weight was taken off again; repeat it, or leave it out",
    })
}
