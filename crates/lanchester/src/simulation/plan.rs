//! What a run is asked, from the request, the engine file and defaults, in this order.

use crate::simulation::crank_bodies::crank_bodies;
use crate::simulation::mount_chains::{chain_band, fit_mounts};
use lanchester_model::{
    Action, BlockKind, Engine, ImposedAgainst, NamedPoint, RodGuidance, RunLength, SimulationInput,
    SpeedKind, StartOfBlock, When,
};
use lanchester_multibody::{
    BlockMotion, BlockStart, Drive, Duration, Event, Guidance, LoadLaw, MultibodyError, ReactsOn,
    STANDARD_GRAVITY, Simulation, Train,
};
use serde::Serialize;
use std::f64::consts::TAU;

/// How a note begins that is of samples alone.
pub(crate) const CLOSE_SAMPLES: &str = "Orders need closer samples than";

/// What to simulate; where it says nothing, the engine file does, and then a default.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SimulateRequest {
    /// Speed of crankshaft 1 at the start [rad/s]; by default the highest of the engine.
    pub speed: Option<f64>,
    /// How long; by default ten revolutions.
    pub length: Option<RunLength>,
    /// Whether the speed is imposed; by default it is free.
    pub imposed: Option<bool>,
    /// Whether the block moves on its mounts; by default where the file gives them in a form that a run can use.
    pub on_mounts: Option<bool>,
    /// Whether weight acts; by default it does.
    pub gravity: Option<bool>,
    /// Whether the gas of the file acts; by default it does.
    pub gas: Option<bool>,
    /// Load; by default with gas the constant mean torque that the engine gives at the start speed (of a periodic motion in proportion to the speed), without gas none.
    pub load: Option<LoadLaw>,
    /// Where the reaction to the load goes; by default to the ground.
    pub reacts_on: Option<ReactsOn>,
    /// Cylinders, by index, that fire no more after the first revolution.
    pub misfire: Vec<usize>,
    /// Crank angle between samples [rad]; by default a degree.
    pub step: Option<f64>,
    /// Tolerance of every step; by default 1e-9.
    pub tolerance: Option<f64>,
    /// Crank angle at the start [rad]; by default 0.
    pub start_angle: Option<f64>,
    /// Where the block starts; by default where its mounts carry weight and mean torque.
    pub start_block: Option<StartOfBlock>,
    /// What happens on the way besides what the file says.
    pub events: Vec<Event>,
    /// Points of the block whose motion is asked for, besides those of the file.
    pub points: Vec<NamedPoint>,
    /// Whether it may take as long as it takes.
    pub long: bool,
}

/// What a run is asked, but for gas, load and friction.
pub(crate) struct RunPlan {
    pub simulation: Simulation,
    pub length: RunLength,
    /// Samples from one that was asked for to the next.
    pub every: usize,
    /// Speed at which friction and the mean torque of the gas are judged [rad/s].
    pub reference_speed: f64,
    pub notes: Vec<String>,
}

/// Words for what an event does.
pub(crate) fn action_words(action: &Action) -> String {
    match action {
        Action::Misfire(cylinder) => format!("cylinder {} fires no more", cylinder + 1),
        Action::Fuel(share) => format!("fuel {} %", 100.0 * share),
        Action::Load(law) => match law {
            LoadLaw::Constant(torque) => format!("load {torque} N m"),
            _ => "no load".into(),
        },
        Action::ClutchOpen => "the clutch opens".into(),
        Action::Stop => "stop".into(),
    }
}

/// Where a run starts: speed of crankshaft 1 [rad/s] and crank angle [rad].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct RunStart {
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Crank angle [rad].
    pub angle: f64,
}

impl RunStart {
    /// Of a run that the request asks of the engine, by what its file says.
    pub fn of(engine: &Engine, input: Option<&SimulationInput>, request: &SimulateRequest) -> RunStart {
        let none = SimulationInput::default();
        let input = input.unwrap_or(&none);
        let first = profile(input, request).and_then(|profile| profile.first()).map(|point| point[1]);
        RunStart {
            speed: request.speed.or(first).or(input.start_speed).unwrap_or(engine.speed.highest),
            angle: request.start_angle.or(input.start_angle).unwrap_or(0.0),
        }
    }
}

/// Whether the speed is imposed.
fn is_imposed(input: &SimulationInput, request: &SimulateRequest) -> bool {
    request.imposed.unwrap_or(input.speed == Some(SpeedKind::Imposed))
}

/// The imposed speed of the file over time, where the run follows it.
fn profile<'a>(input: &'a SimulationInput, request: &SimulateRequest) -> Option<&'a [[f64; 2]]> {
    let follows = is_imposed(input, request) && request.speed.is_none() && !input.imposed.is_empty();
    follows.then_some(&input.imposed)
}

/// The plan of a run of `train`, which is that of `engine`.
pub(crate) fn plan(
    engine: &Engine,
    input: Option<&SimulationInput>,
    train: &mut Train,
    request: &SimulateRequest,
) -> Result<RunPlan, MultibodyError> {
    let none = SimulationInput::default();
    let input = input.unwrap_or(&none);
    let mut notes = Vec::new();
    let imposed = is_imposed(input, request);
    let has_profile = profile(input, request).is_some();
    let RunStart { speed, angle } = RunStart::of(engine, Some(input), request);
    let mut simulation = Simulation::free(speed, 1.0);
    if imposed {
        let against = input.imposed_against.unwrap_or(ImposedAgainst::Block);
        let profile = if has_profile { input.imposed.clone() } else { vec![[0.0, speed]] };
        simulation.drive = Drive::Imposed { profile, against };
    }
    let length = request.length.or(input.duration).unwrap_or(RunLength::Revolutions(10.0));
    if length == RunLength::Periodic
        && let Drive::Imposed { profile, .. } = &simulation.drive
        && profile.windows(2).any(|pair| pair[0][1] != pair[1][1])
    {
        return Err(MultibodyError::NoPeriod);
    }
    match length {
        RunLength::Revolutions(turns) => simulation.duration = Duration::Revolutions(turns),
        RunLength::Time(time) => simulation.duration = Duration::Time(time),
        RunLength::Periodic => {}
    }
    simulation.start_angle = angle;
    let asked = request.step.or(input.step).unwrap_or(simulation.step);
    let (step, every) = sample_step(asked, &simulation, engine.speed.highest, &mut notes);
    simulation.step = step;
    simulation.tolerance = request.tolerance.or(input.tolerance).unwrap_or(simulation.tolerance);
    simulation.tolerances = input.tolerances;
    for mesh in &input.meshes {
        train.set_mesh(&mesh.shaft, mesh.pressure_angle, mesh.z)?;
    }
    notes.extend(crank_bodies(engine, train, input.crank_as_body == Some(true))?);
    if request.long {
        (simulation.most_evaluations, simulation.most_samples) = (u64::MAX, u64::MAX);
    }
    simulation.reactions = true;
    simulation.gravity = match request.gravity {
        Some(true) => input.gravity.filter(|gravity| *gravity > 0.0).unwrap_or(STANDARD_GRAVITY),
        Some(false) => 0.0,
        None => input.gravity.unwrap_or(STANDARD_GRAVITY),
    };
    if input.guidance == Some(RodGuidance::Piston) {
        simulation.guidance = Guidance::Piston;
    }
    if request.start_block.or(input.start_block) == Some(StartOfBlock::AsDrawn) {
        simulation.block_start = BlockStart::AsDrawn;
    }
    if !input.main_stiffness.is_empty() {
        let (count, mains) = (input.main_stiffness.len(), train.rotors.first().map_or(0, |r| r.mains.len()));
        if count != mains {
            return Err(MultibodyError::Number {
                quantity: format!(
                    "number of entries of `main_stiffness` in [simulation] for {mains} main bearings"
                ),
                needed: "that of the main bearings of crankshaft 1",
                got: count as f64,
            });
        }
        simulation.main_stiffness = vec![input.main_stiffness.clone()];
    }
    for named in &input.torque_files {
        if let Some(curve) = &named.curve {
            notes.push(format!(
                "Torque of {}: {} orders, which depart from its samples by at most {:.2} % of their range.",
                named.file,
                curve.orders.len(),
                100.0 * curve.departure
            ));
        }
    }
    simulation.starter = input.starter;
    simulation.driveline.clone_from(&input.driveline);
    simulation.piston_damping = input.piston_damping.unwrap_or(0.0);
    simulation.events.clone_from(&input.events);
    simulation.events.extend(request.events.iter().cloned());
    for &cylinder in &request.misfire {
        simulation.events.push(Event { when: When::Angle(TAU), action: Action::Misfire(cylinder) });
    }
    if length == RunLength::Periodic && !simulation.events.is_empty() {
        notes.push(
            "In the periodic motion misfires hold throughout, and nothing else happens on the way."
                .to_owned(),
        );
        simulation.events.retain(|event| matches!(event.action, Action::Misfire(_)));
        simulation.events.iter_mut().for_each(|event| event.when = When::Angle(0.0));
    }
    let wanted = request.on_mounts.or(input.block.map(|block| block == BlockKind::Mounts));
    let fitted = match wanted {
        Some(false) => Ok(None),
        _ => fit_mounts(train, chain_band(engine, train, &speeds(&simulation, input))),
    };
    let can_move = train.fixed_because.is_none() && fitted.is_ok();
    if wanted.unwrap_or(can_move) {
        notes.extend(fitted?);
        simulation.block = BlockMotion::Mounts;
    } else {
        let given = match fitted {
            Err(MultibodyError::NoMounts { missing }) => missing,
            Err(error) => error.to_string(),
            Ok(_) => train.fixed_because.clone().unwrap_or_default(),
        };
        let because = if can_move { "as asked for".to_owned() } else { given };
        notes.push(format!("The block is fixed: {because}."));
    }
    let unused = unused(engine, input, &simulation, imposed, has_profile);
    if !unused.is_empty() {
        notes.push(format!("Keys of the file that this run does not use: {}.", unused.join(", ")));
    }
    let reference_speed = if speed > 0.0 { speed } else { engine.speed.lowest };
    Ok(RunPlan { simulation, length, every, reference_speed, notes })
}

/// Crank angle between samples from which largest values and orders are taken [rad], and most of them.
const FINE: f64 = TAU / 360.0;
const MOST_FINE: f64 = 200_000.0;

/// Crank angle between the samples of a run [rad] where `asked` lies between those that are written, and how many of the first make one of the second: largest values
/// and orders are not to depend on what is written. A long run keeps the step that was asked for, and says so;
/// `highest`: speed that a free run may come to [rad/s].
fn sample_step(asked: f64, simulation: &Simulation, highest: f64, notes: &mut Vec<String>) -> (f64, usize) {
    if !(asked > FINE * (1.0 + 1e-9) && asked.is_finite()) {
        return (asked, 1);
    }
    let turned = match simulation.duration {
        Duration::Revolutions(turns) => TAU * turns,
        Duration::Time(time) => {
            let fastest = match &simulation.drive {
                Drive::Imposed { profile, .. } => {
                    profile.iter().map(|[_, speed]| speed.abs()).fold(0.0, f64::max)
                }
                Drive::Free => simulation.start_speed.abs().max(highest),
            };
            fastest * time
        }
    };
    let parts = (asked / FINE * (1.0 - 1e-9)).ceil();
    if turned / asked * parts > MOST_FINE {
        notes.push(format!(
            "{CLOSE_SAMPLES} {:.4} deg: a shorter run takes them from samples a degree apart whatever its step.",
            asked.to_degrees()
        ));
        return (asked, 1);
    }
    (asked / parts, parts as usize)
}

/// Speeds that a run is known to have [rad/s].
fn speeds(simulation: &Simulation, input: &SimulationInput) -> Vec<f64> {
    let mut speeds: Vec<f64> = match &simulation.drive {
        Drive::Imposed { profile, .. } => profile.iter().map(|point| point[1]).collect(),
        Drive::Free => vec![simulation.start_speed],
    };
    speeds.extend(input.governor.map(|governor| governor.speed));
    speeds
}

/// Keys that the file gives and this run has no use for.
fn unused(
    engine: &Engine,
    input: &SimulationInput,
    simulation: &Simulation,
    imposed: bool,
    has_profile: bool,
) -> Vec<&'static str> {
    let moves = simulation.block != BlockMotion::Fixed;
    let driveline_torque = engine.block.as_ref().is_some_and(|block| block.driveline_torque != [0.0; 3]);
    [
        ("`imposed_against`", input.imposed_against.is_some() && !(imposed && moves)),
        ("`imposed`", !input.imposed.is_empty() && !has_profile),
        ("`block` of `start`", input.start_block.is_some() && !moves),
        ("`point`", !input.points.is_empty() && !moves),
        ("`driveline_torque` of [block]", driveline_torque),
        (
            "the clutch of an event, which needs a [[driveline]]",
            simulation.driveline.is_empty()
                && simulation.events.iter().any(|event| event.action == Action::ClutchOpen),
        ),
        (
            "[starter]: the run starts above its `until`",
            simulation.starter.is_some_and(|starter| simulation.start_speed >= starter.until),
        ),
        ("`gas = \"states\"`, which the bond graph alone has", input.gas_states),
    ]
    .into_iter()
    .filter_map(|(key, is_unused)| is_unused.then_some(key))
    .collect()
}
