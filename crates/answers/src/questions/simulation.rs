//! A run in time: the answer of `simulate`.

use crate::api::Api;
use crate::asker::Asker;
use crate::problem::Problem;
use crate::questions::reading::engine_file;
use crate::state::superseded;
use lanchester::file::event_from_words;
use lanchester::model::NamedPoint;
use lanchester::multibody::{LoadLaw, MainRule, RunOutcome};
use lanchester::report::{SimulationResult, extreme_rows, period_flows, run_flows, simulation_words};
use lanchester::task::option;
use lanchester::{RunLength, SimulateRequest, simulate_watched};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Most revolutions and seconds of a run that a page waits for.
const MOST_REVOLUTIONS: f64 = 2000.0;
const MOST_SECONDS: f64 = 120.0;

/// Samples of every curve, at most.
const MOST_SAMPLES: usize = 4000;

/// A run to be made. What is left out is as the file says, else as `lanchester simulate` has it.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct SimulateQuestion {
    /// The engine file.
    text: String,
    /// Speed of crankshaft 1 at the start [rad/s].
    #[serde(default)]
    speed: Option<f64>,
    /// Crank angle at the start [rad].
    #[serde(default)]
    angle: Option<f64>,
    /// Revolutions that it lasts.
    #[serde(default)]
    revolutions: Option<f64>,
    /// Whether the periodic motion is searched instead.
    #[serde(default)]
    periodic: bool,
    /// Whether a drive keeps the speed.
    #[serde(default)]
    imposed: Option<bool>,
    /// Whether the block moves on its mounts.
    #[serde(default)]
    on_mounts: Option<bool>,
    /// Whether weight acts.
    #[serde(default)]
    gravity: Option<bool>,
    /// Whether the gas of the file acts.
    #[serde(default)]
    gas: Option<bool>,
    /// Torque of a constant load with its unit, or `none`, as `--load` takes it.
    #[serde(default)]
    load: Option<String>,
    /// Numbers of cylinders that fire no more after the first revolution.
    #[serde(default)]
    misfire: Vec<usize>,
    /// What happens on the way, besides what the file says.
    #[serde(default)]
    events: Vec<AskedEvent>,
    /// Points of the block whose motion is asked for besides those of the file, with the block as drawn [m].
    #[serde(default)]
    points: Vec<[f64; 3]>,
}

/// Something that is to happen on the way, in the words of the engine file.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct AskedEvent {
    /// A time, an angle, revolutions or a speed that is passed: `3 revolutions`, `speed falls to 900 rpm`.
    when: String,
    /// `misfire 3`, `fuel 0 %`, `load 120 N m`, `load none`, `clutch open` or `stop`.
    what: String,
}

/// Most events and points of a question.
const MOST_EVENTS: usize = 64;
const MOST_POINTS: usize = 16;

/// A run. Every curve has one value a sample.
#[derive(Debug, Serialize, JsonSchema)]
struct SimulationAnswer {
    /// How it ended, what was chosen for it, and what it does not use.
    words: Vec<String>,
    /// Whether it ran to its end.
    complete: bool,
    /// Highest, lowest and mean speed in the last period [rad/s].
    speeds: [f64; 3],
    /// First sample of the last period.
    period_start: usize,
    /// Time [s].
    time: Vec<f64>,
    /// Crank angle of crankshaft 1 relative to the block [rad].
    theta: Vec<f64>,
    /// Its rate [rad/s].
    speed: Vec<f64>,
    /// Torques that act somewhere in the run [N m].
    torques: Vec<NamedCurve>,
    /// Where the block's origin is [m]: x, y and z; empty with a fixed block.
    position: Vec<[f64; 3]>,
    /// Turn of the block: unit quaternion w, x, y, z; empty with a fixed block.
    orientation: Vec<[f64; 4]>,
    /// Force of the block on every mount [N], its size.
    mounts: Vec<NamedCurve>,
    /// Force of the journals on every main bearing [N], its size, by the rule of the file.
    mains: Vec<NamedCurve>,
    /// Side thrust of every cylinder [N].
    side_thrust: Vec<NamedCurve>,
    /// Paths of the points that were asked for; empty with a fixed block.
    points: Vec<PointPath>,
    /// Torque of gear or chain on every driven shaft [N m].
    gear_torques: Vec<NamedCurve>,
    /// Force of the teeth on every driven shaft whose pressure angle the file gives [N], its size.
    gear_forces: Vec<NamedCurve>,
    /// Twists of the springs of the driveline [rad]; empty without one.
    driveline_twists: Vec<NamedCurve>,
    /// Their torques with their dampers on the inertia behind each [N m].
    driveline_torques: Vec<NamedCurve>,
    /// Speeds of the inertias of the driveline [rad/s].
    driveline_speeds: Vec<NamedCurve>,
    /// Largest and smallest values of the whole run, beside those of the last period.
    extremes: Vec<RunExtreme>,
    /// What put energy in, positive, and what took or stores it, negative [J].
    energy: Vec<EnergyPart>,
    /// The same over the last period, from the fuel on where a cycle computes the pressures; empty without a whole one.
    period_energy: Vec<EnergyPart>,
    /// Largest error of the energy over its throughput.
    energy_error: f64,
    /// What happened on the way.
    events: Vec<SimulatedEvent>,
}

/// A curve with its name.
#[derive(Debug, Serialize, JsonSchema)]
struct NamedCurve {
    name: String,
    values: Vec<f64>,
}

/// The path of a point of the block.
#[derive(Debug, Serialize, JsonSchema)]
struct PointPath {
    name: String,
    /// Displacement from where it is with the block as drawn [m]: x, y and z.
    displacement: Vec<[f64; 3]>,
}

/// An extreme of the run.
#[derive(Debug, Serialize, JsonSchema)]
struct RunExtreme {
    /// What.
    quantity: String,
    /// Its unit, SI.
    unit: String,
    /// Over the whole run.
    value: f64,
    /// When [s].
    time: f64,
    /// At which crank angle [rad].
    theta: f64,
    /// Over the last period.
    last_period: f64,
}

/// A work, or a change of what is stored.
#[derive(Debug, Serialize, JsonSchema)]
struct EnergyPart {
    name: String,
    /// [J].
    energy: f64,
}

/// Something that happened on the way.
#[derive(Debug, Serialize, JsonSchema)]
struct SimulatedEvent {
    /// What, in words.
    what: String,
    /// When [s].
    time: f64,
    /// At which crank angle [rad].
    theta: f64,
    /// At which speed [rad/s].
    speed: f64,
}

pub(crate) fn questions(api: Api) -> Api {
    api.post("/api/simulate", "The crank train in time: `lanchester simulate`.", simulated)
}

fn simulated(asker: &Asker, question: SimulateQuestion) -> Result<SimulationAnswer, Problem> {
    let refused = |message: String| Err(Problem::refused(message));
    if let Some(speed) = question.speed.filter(|speed| !(*speed >= 0.0 && speed.is_finite())) {
        return refused(format!("the speed at the start must be 0 or more, got {speed} rad/s"));
    }
    let fits = |turns: &f64| *turns > 0.0 && *turns <= MOST_REVOLUTIONS;
    if let Some(turns) = question.revolutions.filter(|turns| !fits(turns)) {
        return refused(format!(
            "a run here lasts above 0 and up to {MOST_REVOLUTIONS} revolutions, got {turns}\nhint: `lanchester simulate` runs longer"
        ));
    }
    let file = asker.studio.with_torques(engine_file(&question.text)?)?;
    let count = file.engine.cylinders.len();
    if let Some(number) = question.misfire.iter().find(|number| !(1..=count).contains(*number)) {
        return refused(format!("cylinders are numbered from 1 to {count}, got {number}"));
    }
    if let Some(angle) = question.angle.filter(|angle| !angle.is_finite()) {
        return refused(format!("the crank angle at the start must be a number, got {angle}"));
    }
    if question.events.len() > MOST_EVENTS {
        return refused(format!("a run has at most {MOST_EVENTS} events, got {}", question.events.len()));
    }
    if question.points.len() > MOST_POINTS {
        return refused(format!(
            "a run here shows at most {MOST_POINTS} points, got {}",
            question.points.len()
        ));
    }
    if let Some(index) = question.points.iter().position(|at| !at.iter().all(|own| own.is_finite())) {
        return refused(format!("point {} needs three numbers", index + 1));
    }
    let named = |at: &[f64; 3]| NamedPoint {
        name: format!("{} mm", at.map(|own| format!("{}", (1e6 * own).round() / 1e3)).join(", ")),
        at: *at,
    };
    let mut events = Vec::new();
    for (index, asked) in question.events.iter().enumerate() {
        match event_from_words(&asked.when, &asked.what, count) {
            Ok(event) => events.push(event),
            Err((message, hint)) => {
                return refused(format!("event {}: {message}\nhint: {hint}", index + 1));
            }
        }
    }
    let load = match question.load.as_deref().map(str::trim) {
        None | Some("") => None,
        Some("none") => Some(LoadLaw::None),
        Some(text) => Some(LoadLaw::Constant(option::torque(text, "load").map_err(Problem::refused)?)),
    };
    let length = match (question.periodic, question.revolutions) {
        (true, _) => Some(RunLength::Periodic),
        (false, turns) => turns.map(RunLength::Revolutions),
    };
    let request = SimulateRequest {
        speed: question.speed,
        start_angle: question.angle,
        events,
        points: question.points.iter().map(named).collect(),
        length,
        imposed: question.imposed,
        on_mounts: question.on_mounts,
        gravity: question.gravity,
        gas: question.gas,
        load,
        misfire: question.misfire.iter().map(|number| number - 1).collect(),
        ..SimulateRequest::default()
    };
    let in_file = file.tasks.simulation.as_ref().and_then(|input| input.gas);
    let traces = match request.gas.or(in_file) {
        Some(false) => Vec::new(),
        _ => asker.studio.traces(&file.engine)?,
    };
    // What nobody waits for any more ends, and so does what would keep a page waiting for minutes.
    let result =
        simulate_watched(&file, &traces, &request, &|state| asker.waits() && state.time < MOST_SECONDS);
    if !asker.waits() {
        return Err(superseded());
    }
    Ok(answer(&result.map_err(Problem::refused)?))
}

fn answer(result: &SimulationResult) -> SimulationAnswer {
    let run = &result.run;
    let samples = &run.samples;
    let count = samples.time.len();
    let every = count.div_ceil(MOST_SAMPLES).max(1);
    // The last sample belongs to them.
    let kept: Vec<usize> = (0..count).rev().step_by(every).collect::<Vec<_>>().into_iter().rev().collect();
    let thin =
        |values: &[f64]| kept.iter().filter_map(|index| values.get(*index).copied()).collect::<Vec<f64>>();
    let size = |force: &[f64]| force.iter().map(|part| part * part).sum::<f64>().sqrt();
    let torques = [
        ("gas", &samples.gas_torque),
        ("load", &samples.load_torque),
        ("starter", &samples.starter_torque),
        ("friction", &samples.friction_torque),
        ("pistons' friction", &samples.piston_friction_torque),
        ("driveline", &samples.driveline_torque),
        ("drive and others", &samples.outside_torque),
    ];
    let acting = torques.into_iter().filter(|(_, values)| values.iter().any(|torque| *torque != 0.0));
    let named = |name: String, value: &dyn Fn(usize) -> f64| NamedCurve {
        name,
        values: kept.iter().map(|index| value(*index)).collect(),
    };
    let mounts = result.mounts.iter().enumerate().map(|(mount, name)| {
        named(name.clone(), &|k| {
            samples.mounts.get(k).and_then(|all| all.get(mount)).map_or(0.0, |f| size(f))
        })
    });
    let rule = MainRule::ALL.iter().position(|rule| *rule == result.main_rule).unwrap_or(0);
    let places = result
        .mains
        .iter()
        .enumerate()
        .flat_map(|(shaft, planes)| (0..planes.len()).map(move |main| (shaft, main)));
    let mains = places.map(|(shaft, main)| {
        named(format!("main {}.{}", shaft + 1, main + 1), &|k| {
            let rotor = samples.reactions.get(k).and_then(|all| all.rotors.get(shaft));
            rotor.and_then(|rotor| rotor.mains[rule].get(main)).map_or(0.0, |force| size(force))
        })
    });
    let cylinders = samples.reactions.first().map_or(0, |all| all.cylinders.len());
    let side_thrust = (0..cylinders).map(|index| {
        named(format!("cylinder {}", index + 1), &|k| {
            samples.reactions.get(k).map_or(0.0, |all| all.cylinders[index].side_thrust)
        })
    });
    let rotor_of = |k: usize, shaft: usize| samples.reactions.get(k).and_then(|all| all.rotors.get(shaft));
    let shafts = || result.gears.iter().enumerate().map(|(index, name)| (index + 1, name));
    let gear_torques = shafts().map(|(shaft, name)| {
        named(name.clone(), &|k| rotor_of(k, shaft).map_or(0.0, |rotor| rotor.gear_torque))
    });
    let gear_forces = shafts().map(|(shaft, name)| {
        named(name.clone(), &|k| rotor_of(k, shaft).map_or(0.0, |rotor| size(&rotor.gear_force)))
    });
    let links = samples.driveline.first().map_or(0, Vec::len);
    let of_link = |value: &dyn Fn(usize, usize) -> f64| -> Vec<NamedCurve> {
        (0..links).map(|link| named(format!("{}", link + 1), &|k| value(k, link))).collect()
    };
    let spring = |k: usize, link: usize| {
        samples.driveline_springs.get(k).and_then(|all| all.get(link)).copied().unwrap_or_default()
    };
    let points = result.points.iter().filter(|point| !point.displacement.is_empty());
    let points = points.map(|point| PointPath {
        name: point.name.clone(),
        displacement: kept.iter().filter_map(|index| point.displacement.get(*index).copied()).collect(),
    });
    let parts = |flows: Vec<(&'static str, f64)>| -> Vec<EnergyPart> {
        let acting = flows.into_iter().filter(|(_, energy)| *energy != 0.0);
        acting.map(|(name, energy)| EnergyPart { name: name.to_owned(), energy }).collect()
    };
    let first = result.last_period().start;
    SimulationAnswer {
        words: simulation_words(result),
        complete: matches!(
            run.outcome,
            RunOutcome::Complete | RunOutcome::Stopped | RunOutcome::AtRest { .. }
        ),
        speeds: result.speeds(),
        period_start: kept.partition_point(|index| *index < first),
        time: thin(&samples.time),
        theta: thin(&samples.theta),
        speed: thin(&samples.speed),
        torques: acting
            .map(|(name, values)| NamedCurve { name: name.to_owned(), values: thin(values) })
            .collect(),
        position: kept.iter().filter_map(|index| samples.position.get(*index).copied()).collect(),
        orientation: kept.iter().filter_map(|index| samples.orientation.get(*index).copied()).collect(),
        mounts: mounts.collect(),
        mains: mains.collect(),
        side_thrust: side_thrust.collect(),
        points: points.collect(),
        gear_torques: gear_torques.collect(),
        // Without a pressure angle there is none.
        gear_forces: gear_forces.filter(|curve| curve.values.iter().any(|force| *force != 0.0)).collect(),
        driveline_twists: of_link(&|k, link| spring(k, link)[0]),
        driveline_torques: of_link(&|k, link| spring(k, link)[1]),
        driveline_speeds: of_link(&|k, link| samples.driveline[k][link][1]),
        extremes: extreme_rows(result)
            .into_iter()
            .map(|row| RunExtreme {
                quantity: row.quantity,
                unit: row.unit.to_owned(),
                value: row.whole.value,
                time: row.whole.time,
                theta: row.whole.theta,
                last_period: row.last_period.value,
            })
            .collect(),
        energy: parts(run_flows(result)),
        period_energy: parts(period_flows(result).unwrap_or_default()),
        energy_error: run.audit.energy,
        events: run
            .events
            .iter()
            .map(|event| SimulatedEvent {
                what: result.happened(event.what),
                time: event.time,
                theta: event.theta,
                speed: event.speed,
            })
            .collect(),
    }
}
