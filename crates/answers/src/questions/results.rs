//! What the engine does: the answers of `loads`, `torque`, `bearings`, `mounts` and `compare`.

use crate::api::Api;
use crate::asker::Asker;
use crate::problem::Problem;
use crate::questions::reading::{engine, engine_file};
use lanchester::film::Cavitation;
use lanchester::mechanism::{
    BearingLoads, BearingPart, BearingRequest, InternalMoments, InternalRequest, LoadRequest, Loads,
    MotionTrace, MountStudy, TorqueRequest, internal_cases, loads, motion,
};
use lanchester::model::{Engine, SpeedRange};
use lanchester::results::Trace;
use lanchester::study::compare::{Comparison, Equal, Held};
use lanchester::{
    BearingFilms, CompareEntry, CompareRequest, ComparedWith, FilmMethod, MountSpeeds, TorqueReport,
    TorqueReportRequest, bearing_films, bearing_report, compare, mounts, power_speeds, torque_report,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// Angles a revolution of shear forces and bending moments.
const INTERNAL_ANGLES: usize = 72;
/// Angles of the curves in a revolution.
const MOST_ANGLES: usize = 20_000;
/// Speeds of the power curve, where a cycle is computed.
const POWER_SPEEDS: usize = 7;
/// Speeds of the mounts, where nobody says, and the most.
const MOUNT_SPEEDS: usize = 61;
const MOST_MOUNT_SPEEDS: usize = 1000;
/// Highest order of the mounts.
const MOUNT_ORDERS: u32 = 8;
/// Engines that are compared at once.
const MOST_ENGINES: usize = 20;

/// An engine at a speed.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct AtSpeed {
    /// The engine file.
    text: String,
    /// Speed of crankshaft 1 [rad/s]; the highest of the engine where it is left out.
    #[serde(default)]
    speed: Option<f64>,
}

impl AtSpeed {
    fn speed(&self) -> Result<Option<f64>, Problem> {
        positive(self.speed)
    }
}

pub(crate) fn positive(speed: Option<f64>) -> Result<Option<f64>, Problem> {
    match speed {
        Some(speed) if !(speed > 0.0 && speed.is_finite()) => Err(Problem::refused(format!(
            "the speed must be positive, got {speed} rad/s\nhint: leave it out for the highest"
        ))),
        speed => Ok(speed),
    }
}

/// An engine at a speed, and which curves are wanted.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct LoadsQuestion {
    /// The engine file.
    text: String,
    /// Speed of crankshaft 1 [rad/s]; the highest of the engine where it is left out.
    #[serde(default)]
    speed: Option<f64>,
    /// Angles of the curves in a revolution; as many as `lanchester loads` has where it is left out.
    #[serde(default)]
    samples: Option<usize>,
    /// Whose curves over the crank angle are in the answer; all of them where it is left out.
    #[serde(default)]
    curves: Curves,
}

/// Whose curves over the crank angle are in the answer.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum Curves {
    /// Of the whole engine, of its parts and cylinders, and of the motion of its pistons.
    #[default]
    All,
    /// Of the whole engine alone: the others are empty, an answer a seventh as long.
    Whole,
}

/// An engine on its mounts.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Mounted {
    /// The engine file.
    text: String,
    /// Speeds over the range of the engine.
    #[serde(default)]
    steps: Option<usize>,
}

/// Loads of the bearings, and without counterweights where the engine has some.
#[derive(Debug, Serialize, JsonSchema)]
struct BearingsAnswer {
    #[serde(flatten)]
    loads: BearingLoads,
    without_counterweights: Option<BearingLoads>,
}

/// An engine at a speed, and which models of cavitation its films have.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct FilmsQuestion {
    /// The engine file.
    text: String,
    /// Speed of crankshaft 1 [rad/s]; the highest of the engine where it is left out.
    #[serde(default)]
    speed: Option<f64>,
    /// Models of cavitation side by side; that of the file, else Guembel's, where it is left out.
    #[serde(default)]
    models: Vec<Cavitation>,
    /// Whether bearings with grooves have films with them, solved at every instant: some seconds each. Tables without grooves where it is left out.
    #[serde(default)]
    grooves: bool,
}

/// Engines side by side.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct CompareQuestion {
    /// The engines in the order of the answer.
    engines: Vec<NamedEngine>,
    /// In what they are made equal; as they are where it is left out.
    #[serde(default)]
    equal: Option<EqualIn>,
    /// What a similar engine keeps; the speed where it is left out.
    #[serde(default)]
    hold: Option<Hold>,
    /// Speed of crankshaft 1 of all engines [rad/s]; the highest of each where it is left out.
    #[serde(default)]
    speed: Option<f64>,
    /// Mean piston speed of all engines [m/s], in the place of the speed.
    #[serde(default)]
    piston_speed: Option<f64>,
    /// Place of the one with which the others are compared, from 0.
    #[serde(default)]
    reference: usize,
}

/// An engine under a name of its own.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct NamedEngine {
    /// What it is called in the answer.
    name: String,
    /// The engine file.
    text: String,
}

#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum EqualIn {
    Displacement,
    Power,
}

#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum Hold {
    Speed,
    PistonSpeed,
}

pub(crate) fn questions(api: Api) -> Api {
    api.post("/api/loads", "What shakes the engine: `lanchester loads`.", shaking)
        .post(
            "/api/internal",
            "Shear forces and bending moments of the crankshafts: `internal` of `lanchester loads`.",
            internal,
        )
        .post("/api/torque", "Torque of gas and inertia: `lanchester torque`.", turning)
        .post("/api/bearings", "Loads of pistons, pins and bearings: `lanchester bearings`.", bearings)
        .post("/api/films", "Oil films of the bearings: `lanchester bearings --film`.", films)
        .post(
            "/api/mounts",
            "The block on its mounts: `lanchester mounts`, with a `--point` at each mount.",
            mounted,
        )
        .post("/api/compare", "Engines side by side: `lanchester compare`.", compared)
}

fn shaking(_: &Asker, question: LoadsQuestion) -> Result<Loads, Problem> {
    let samples = question.samples.unwrap_or(LoadRequest::default().samples);
    if !(1..=MOST_ANGLES).contains(&samples) {
        return Err(Problem::refused(format!(
            "curves have 1 to {MOST_ANGLES} angles a revolution, got {samples}\nhint: leave `samples` out"
        )));
    }
    let request = LoadRequest { speed: positive(question.speed)?, samples, ..LoadRequest::default() };
    let mut found = loads(&engine(&question.text)?, &request).map_err(Problem::refused)?;
    if question.curves == Curves::Whole {
        let parts = found.parts.iter_mut().map(|part| &mut part.loads);
        let cylinders = found.cylinders.iter_mut().map(|cylinder| &mut cylinder.loads);
        parts.chain(cylinders).for_each(|set| set.trace = Trace::default());
        found.motion.iter_mut().for_each(|motion| motion.trace = MotionTrace::default());
    }
    Ok(found)
}

fn internal(_: &Asker, question: AtSpeed) -> Result<Vec<InternalMoments>, Problem> {
    let request =
        InternalRequest { speed: question.speed()?, samples: INTERNAL_ANGLES, ..InternalRequest::default() };
    internal_cases(&engine(&question.text)?, &request).map_err(Problem::refused)
}

fn turning(asker: &Asker, question: AtSpeed) -> Result<TorqueReport, Problem> {
    let speed = question.speed()?;
    let file = asker.studio.with_torques(engine_file(&question.text)?)?;
    let engine = file.engine;
    let request = TorqueReportRequest {
        simulation: file.tasks.simulation,
        torque: TorqueRequest { speed, ..TorqueRequest::default() },
        speeds: power_speeds(&engine, POWER_SPEEDS),
        ..TorqueReportRequest::default()
    };
    torque_report(&engine, &asker.studio.traces(&engine)?, &request).map_err(Problem::refused)
}

fn bearings(asker: &Asker, question: AtSpeed) -> Result<BearingsAnswer, Problem> {
    let speed = question.speed()?;
    let engine = engine(&question.text)?;
    let traces = asker.studio.traces(&engine)?;
    let part = if engine.gas.is_some() { BearingPart::All } else { BearingPart::Inertia };
    let loads = |counterweights| {
        let request = BearingRequest { speed, part, counterweights, ..BearingRequest::default() };
        bearing_report(&engine, &traces, &request).map_err(Problem::refused)
    };
    let has_weights = engine.counterweights.iter().any(|weight| weight.unbalance > 0.0);
    let without_counterweights = if has_weights { Some(loads(false)?) } else { None };
    Ok(BearingsAnswer { loads: loads(true)?, without_counterweights })
}

fn films(asker: &Asker, question: FilmsQuestion) -> Result<BearingFilms, Problem> {
    let speed = positive(question.speed)?;
    let engine = engine(&question.text)?;
    let traces = asker.studio.traces(&engine)?;
    let part = if engine.gas.is_some() { BearingPart::All } else { BearingPart::Inertia };
    let request = BearingRequest { speed, part, ..BearingRequest::default() };
    let loads = bearing_report(&engine, &traces, &request).map_err(Problem::refused)?;
    let method = if question.grooves { FilmMethod::Grooved } else { FilmMethod::Tables };
    bearing_films(&engine, &loads, &question.models, method).map_err(Problem::refused)
}

fn mounted(asker: &Asker, question: Mounted) -> Result<MountStudy, Problem> {
    let steps = question.steps.unwrap_or(MOUNT_SPEEDS);
    if !(2..=MOST_MOUNT_SPEEDS).contains(&steps) {
        return Err(Problem::refused(format!(
            "mounts need 2 to {MOST_MOUNT_SPEEDS} speeds, got {steps}\nhint: leave `steps` out"
        )));
    }
    let engine = engine(&question.text)?;
    let traces = asker.studio.traces(&engine)?;
    asker.studio.mounted.answer((engine, traces, steps), |(engine, traces, steps)| {
        // The points are the mounts themselves: how far each of them moves is drawn.
        let points: Vec<[f64; 3]> = engine.mounts.iter().map(|mount| [mount.x, mount.y, mount.z]).collect();
        mounts(engine, &MountSpeeds::Range(*steps), MOUNT_ORDERS, Some(traces), &points)
            .map_err(Problem::refused)
    })
}

fn compared(asker: &Asker, question: CompareQuestion) -> Result<Comparison, Problem> {
    let count = question.engines.len();
    if count > MOST_ENGINES {
        return Err(Problem::refused(format!(
            "up to {MOST_ENGINES} engines are compared at once, got {count}\nhint: leave some out"
        )));
    }
    if question.speed.is_some() && question.piston_speed.is_some() {
        return Err(Problem::refused(
            "one speed or one mean piston speed is kept equal, and both are given\nhint: leave one of both out",
        ));
    }
    let entry = |named: &NamedEngine| {
        let mut file = asker.studio.with_torques(engine_file(&named.text)?)?;
        let traces = asker.studio.traces(&file.engine)?;
        let speed = match question.piston_speed {
            None => None,
            Some(speed) => Some(speed_at_piston_speed(&file.engine, speed)?),
        };
        file.engine = file
            .engine
            .with(|parts| {
                parts.name.clone_from(&named.name);
                if let Some(highest) = speed {
                    let lowest = parts.speed.lowest.min(highest);
                    parts.speed = SpeedRange { lowest, highest };
                }
            })
            .map_err(|faults| {
                Problem::refused(faults.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "))
            })?;
        Ok(CompareEntry { file, traces, with: ComparedWith::OwnDevices })
    };
    let entries = question.engines.iter().map(entry).collect::<Result<Vec<_>, Problem>>()?;
    let request = CompareRequest {
        equal: match question.equal {
            None => Equal::AsTheyAre,
            Some(EqualIn::Displacement) => Equal::Displacement,
            Some(EqualIn::Power) => Equal::Power,
        },
        held: match question.hold {
            None | Some(Hold::Speed) => Held::Speed,
            Some(Hold::PistonSpeed) => Held::PistonSpeed,
        },
        speed: question.speed,
        reference: question.reference,
        ..CompareRequest::default()
    };
    compare(&entries, &request).map_err(Problem::refused)
}

/// Speed of crankshaft 1 [rad/s] at which the pistons have this mean speed [m/s], that of the longest stroke.
fn speed_at_piston_speed(engine: &Engine, piston_speed: f64) -> Result<f64, Problem> {
    let strokes =
        motion(engine, &LoadRequest { samples: 1, ..LoadRequest::default() }).map_err(Problem::refused)?;
    let longest = strokes.iter().map(|motion| motion.stroke).fold(0.0, f64::max);
    let speed = PI * piston_speed / longest;
    if !(speed > 0.0 && speed.is_finite()) {
        return Err(Problem::refused(format!(
            "the mean piston speed must be above 0 and the engine must have a stroke, got {piston_speed} m/s and {longest} m"
        )));
    }
    Ok(speed)
}
