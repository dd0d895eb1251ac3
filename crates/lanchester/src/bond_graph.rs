//! The bond graph of an engine file, with its gas, friction, block and load.

use crate::inertias::{rotor_inertia, shaped_crankshafts};
use crate::pressure::cylinders::cylinder_gas;
use crate::pressure::error::GasError;
use crate::pressure::measured::TraceFile;
use crate::simulation::gas_torque::{chosen_load, friction_at, friction_note, mean_and_friction};
use lanchester_bondgraph::{
    Curve, Description, EngineBlock, EngineDrive, EngineGraphError, EngineJoints, EngineLink, EngineLoad,
    EngineRequest, EngineStarter, GasStates, LoadLaw, Unit, engine_graph,
};
use lanchester_mechanism::{CylinderGas, LoadError, TorqueError};
use lanchester_model::{
    Action, BlockKind, Engine, ImposedAgainst, ReactsOn, RunLength, SimulationInput, SpeedKind, StartOfBlock,
    StateTolerances,
};
use lanchester_multibody::STANDARD_GRAVITY;
use lanchester_results::PeriodicCurve;
use std::f64::consts::{PI, TAU};

/// What the graph of an engine file is to hold; the rest follows from the engine.
#[derive(Debug, Clone, PartialEq)]
pub struct BondGraphRequest {
    /// Speed of crankshaft 1 at the start [rad/s]; `None`: the highest of the engine.
    pub speed: Option<f64>,
    /// How the block moves; `None`: in space on mounts where the file gives them in a form that has a course in time, else not at all.
    pub block: Option<EngineBlock>,
    /// Joints of the crank train; masses of crankshafts that are not given come from their shape.
    pub joints: EngineJoints,
    /// Whether the speed is imposed; `None`: where nothing gives the crankshaft an inertia.
    pub imposed: Option<bool>,
    /// Whether weight acts; `true`: as the file says.
    pub gravity: bool,
    /// Whether the gas of the file acts; `true`: as the file says.
    pub gas: bool,
    /// Whether the gas is states of the graph, with valves and heat release, instead of pressures that are computed before.
    pub gas_as_states: bool,
    /// What the file says of a run: load, starter, driveline, torques, start. What is given here goes before it.
    pub simulation: SimulationInput,
    /// Torque of the load; `None`: that of the file, else with gas the mean that the engine gives at the start speed (of a periodic motion in proportion to the speed),
    /// without none.
    pub load: Option<LoadLaw>,
    /// Whether the load is bolted to the block; `false`: as the file says, else from the ground.
    pub load_on_block: bool,
    /// Revolutions of a simulation at the start speed, where the file gives no duration.
    pub revolutions: f64,
}

impl Default for BondGraphRequest {
    fn default() -> Self {
        BondGraphRequest {
            speed: None,
            block: None,
            joints: EngineJoints::Ideal,
            imposed: None,
            gravity: true,
            gas: true,
            gas_as_states: false,
            simulation: SimulationInput::default(),
            load: None,
            load_on_block: false,
            revolutions: 2.0,
        }
    }
}

/// The graph of an engine and what was assumed.
#[derive(Debug, Clone, PartialEq)]
pub struct EngineBondGraph {
    /// The graph as a graph file would describe it.
    pub description: Description,
    /// What the file does not say and was assumed.
    pub notes: Vec<String>,
}

/// Why an engine file has no graph.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BondGraphError {
    /// Its pressures.
    #[error(transparent)]
    Gas(#[from] GasError),
    /// Its torque.
    #[error(transparent)]
    Torque(#[from] TorqueError),
    /// Its parts.
    #[error(transparent)]
    Engine(#[from] EngineGraphError),
}

/// The bond graph of `engine`; `traces` holds the files that [`crate::trace_names`] names.
///
/// ```
/// use lanchester::{BondGraphRequest, engine_bond_graph};
/// use lanchester::bondgraph::{Graph, equations};
///
/// let template = lanchester::file::template("v2-90").expect("it is in the gallery");
/// let engine = lanchester::file::read(template.text).engine().expect("the gallery has no mistakes");
/// let found = engine_bond_graph(&engine, &[], &BondGraphRequest::default())?;
/// let graph = Graph::new(&found.description).expect("names and units fit");
/// assert!(equations(&graph).is_ok());
/// # Ok::<(), lanchester::BondGraphError>(())
/// ```
///
/// # Errors
/// [`BondGraphError`] where the file lacks something that the graph needs.
pub fn engine_bond_graph(
    engine: &Engine,
    traces: &[TraceFile],
    request: &BondGraphRequest,
) -> Result<EngineBondGraph, BondGraphError> {
    let input = &request.simulation;
    let mut notes = Vec::new();
    let inertia = rotor_inertia(engine);
    let known = |list: &[Option<f64>]| -> Vec<f64> { list.iter().map(|own| own.unwrap_or(0.0)).collect() };
    let crankshaft_inertia = known(&inertia.crankshafts);
    let has_inertia = crankshaft_inertia.first().is_some_and(|own| *own > 0.0);
    let wanted = request.imposed.or(input.speed.map(|kind| kind == SpeedKind::Imposed));
    let imposed = wanted.unwrap_or(!has_inertia);
    if imposed && wanted.is_none() {
        notes.push(
            "The speed is imposed: nothing gives the crankshaft an inertia ([flywheel] or [crank.body] do)."
                .to_owned(),
        );
    }
    let profile = if imposed && request.speed.is_none() { input.imposed.clone() } else { Vec::new() };
    let first = profile.first().map(|point| point[1]);
    let speed = request.speed.or(first).or(input.start_speed).unwrap_or(engine.speed.highest);
    // Pressures, friction and durations need a speed of the running engine.
    let reference = if speed > 0.0 { speed } else { engine.speed.lowest };
    let of_file = input.block.map(|kind| match kind {
        BlockKind::Fixed => EngineBlock::Fixed,
        BlockKind::Mounts => EngineBlock::Space,
    });
    let asked = request.block.or(of_file.filter(|block| *block == EngineBlock::Fixed || can_move(engine)));
    let block = asked.unwrap_or(if can_move(engine) { EngineBlock::Space } else { EngineBlock::Fixed });
    if asked.is_none() && block == EngineBlock::Fixed {
        notes.push(
            "The block is fixed: the file gives no [block] on mounts with stiffness and viscous damping."
                .to_owned(),
        );
    }
    let with_gas = request.gas && input.gas.unwrap_or(true);
    let report = match (&engine.gas, with_gas) {
        (Some(_), true) => Some(cylinder_gas(engine, traces, reference)?),
        _ => None,
    };
    let mut found = EngineRequest::free(speed, 1.0);
    found.duration = match input.duration {
        Some(RunLength::Time(time)) => time,
        Some(RunLength::Revolutions(turns)) => turns * TAU / reference,
        Some(RunLength::Periodic) | None => request.revolutions * TAU / reference,
    };
    found.periodic = input.duration == Some(RunLength::Periodic);
    if found.periodic {
        found.duration = 2.0 * TAU / reference;
    }
    found.start_angle = input.start_angle.unwrap_or(0.0);
    found.tolerance = input.tolerance.unwrap_or(found.tolerance);
    if let Some(step) = input.step {
        found.samples = (found.duration * reference / step).ceil().clamp(1.0, 1e6) as usize;
    }
    let as_states = request.gas_as_states || (input.gas_states && with_gas);
    if as_states {
        let mut states = GasStates::of(engine)?;
        if let (Some(walls), Some(body)) =
            (&mut states.walls, report.as_ref().and_then(|report| report.body_temperature))
        {
            walls.start = body;
            notes.push(format!(
                "The body starts with {body:.1} K: its temperature at {:.0} rpm.",
                reference * 30.0 / PI
            ));
        }
        found.gas_states = Some(states);
    }
    let (mut mean, mut friction) = (0.0, 0.0);
    if let Some(report) = &report {
        if !as_states {
            found.pressures = gauge_pressures(&report.cylinders);
            notes.push(format!("Gas: pressures at {:.0} rpm, whatever the speed.", reference * 30.0 / PI));
        }
        let (of_gas, parts) = mean_and_friction(engine, &report.cylinders, reference)?;
        mean = of_gas;
        friction = friction_at(parts, reference);
        [found.friction_torque, found.friction_growth[0], found.friction_growth[1]] = parts;
        if engine.friction.is_some() {
            notes.push(friction_note(parts, reference));
        }
    }
    let law = match (&request.load, &input.load) {
        (Some(law), _) => law.clone(),
        (None, Some(load)) => load.law.clone(),
        (None, None) if imposed || report.is_none() => LoadLaw::None,
        (None, None) => {
            let load = (mean - friction).max(0.0);
            let ratio = input.driveline.iter().map(|link| link.ratio).product();
            let is_periodic = found.periodic && input.governor.is_none();
            chosen_load(load, reference, ratio, is_periodic, &mut notes)
        }
    };
    found.drive = if imposed { EngineDrive::Imposed } else { EngineDrive::Free };
    found.profile = profile;
    found.against_ground = input.imposed_against == Some(ImposedAgainst::Ground);
    found.block = block;
    found.equilibrium = input.start_block != Some(StartOfBlock::AsDrawn);
    found.mounts = engine.mounts.iter().any(|mount| mount.spring.is_some());
    found.gravity = if request.gravity { input.gravity.unwrap_or(STANDARD_GRAVITY) } else { 0.0 };
    found.crankshaft_inertia = crankshaft_inertia;
    found.shaft_inertia = known(&inertia.shafts);
    let on_block = input.load.as_ref().is_some_and(|load| load.reacts_on == ReactsOn::Block);
    found.load = EngineLoad { torque: law, reacts_on_block: request.load_on_block || on_block };
    found.piston_damping = input.piston_damping.unwrap_or(0.0);
    found.driveline = (input.driveline.iter())
        .map(|link| EngineLink {
            inertia: link.inertia,
            stiffness: link.stiffness,
            damping: link.damping,
            ratio: link.ratio,
        })
        .collect();
    found.starter = input.starter.map(|starter| EngineStarter {
        stall_torque: starter.stall_torque,
        free_speed: starter.free_speed,
        ratio: starter.ratio,
        until: starter.until,
        reacts_on_block: starter.reacts_on == ReactsOn::Block,
    });
    // What came a dead time before is no state of a graph.
    found.governor = input.governor.filter(|governor| governor.delay == 0.0);
    found.events.clone_from(&input.events);
    let orders = input.torque_orders().map_err(|error| TorqueError::from(LoadError::Unread(error)))?;
    found.torque = orders.iter().map(|order| [order.order, order.sin, order.cos]).collect();
    found.joints = joints(engine, &request.joints, &mut notes);
    let unused = left_out(engine, input, &found, request);
    if !unused.is_empty() {
        notes.push(format!("Left out of the graph: {}.", unused.join(", ")));
    }
    Ok(EngineBondGraph { description: engine_graph(engine, &found)?, notes })
}

/// Joints with the masses of the crankshafts, and what was assumed of them.
fn joints(engine: &Engine, asked: &EngineJoints, notes: &mut Vec<String>) -> EngineJoints {
    let EngineJoints::Compliant(asked) = asked else { return EngineJoints::Ideal };
    let mut joints = asked.clone();
    if joints.crankshafts.is_empty() {
        let shaped = shaped_crankshafts(engine);
        joints.crankshafts =
            shaped.iter().map(|shape| shape.map(|shape| [shape.mass, shape.centre[2]])).collect();
    }
    if joints.crankshafts.iter().all(Option::is_none) {
        notes.push(
            "The main bearings are rigid: no mass of the crankshaft is known ([crank.body] gives it)."
                .to_owned(),
        );
    }
    if joints.skirt_length.is_none() {
        notes.push(
            "Pistons: cylinders of the bore, 0.8 of it long, with a contact at each end, centre at the pin."
                .to_owned(),
        );
    }
    EngineJoints::Compliant(joints)
}

/// What the file gives for a run and the graph does not hold.
fn left_out(
    engine: &Engine,
    input: &SimulationInput,
    found: &EngineRequest,
    request: &BondGraphRequest,
) -> Vec<&'static str> {
    let moves = found.block != EngineBlock::Fixed;
    let on_mounts = found.mounts && !matches!(found.block, EngineBlock::Fixed | EngineBlock::Held);
    let has_gas = found.gas_states.is_some() || !found.pressures.is_empty();
    let imposed = found.drive == EngineDrive::Imposed;
    let driveline_torque = engine.block.as_ref().is_some_and(|block| block.driveline_torque != [0.0; 3]);
    let does = |wanted: fn(&Action) -> bool| input.events.iter().any(|event| wanted(&event.action));
    [
        ("[governor] without gas", input.governor.is_some() && !has_gas),
        ("[governor] with a dead time", input.governor.is_some_and(|governor| governor.delay > 0.0)),
        (
            "misfires and fuel of [[simulation.event]] without gas",
            !has_gas && does(|a| matches!(a, Action::Misfire(_) | Action::Fuel(_))),
        ),
        (
            "the clutch of [[simulation.event]] without [[driveline]]",
            input.driveline.is_empty() && does(|a| matches!(a, Action::ClutchOpen)),
        ),
        ("`imposed_against`", input.imposed_against.is_some() && !(imposed && moves)),
        ("`imposed`", !input.imposed.is_empty() && (!imposed || request.speed.is_some())),
        ("`block` of `start`", input.start_block.is_some() && !on_mounts),
        (
            "`gas = \"states\"` without [gas] that acts",
            request.gas && input.gas_states && found.gas_states.is_none(),
        ),
        (
            "`axial_inertia` of the rods with compliant joints",
            moves
                && found.joints != EngineJoints::Ideal
                && engine.cylinders.iter().any(|own| own.rod.axial_inertia != 0.0),
        ),
        ("`guidance`", input.guidance.is_some()),
        ("`tolerances`", input.tolerances != StateTolerances::default()),
        ("`crankshaft = \"body\"`", input.crank_as_body == Some(true)),
        ("`mesh`", !input.meshes.is_empty()),
        ("`point`", !input.points.is_empty()),
        ("`main_stiffness`", !input.main_stiffness.is_empty()),
        ("`driveline_torque` of [block]", driveline_torque),
        ("friction without gas", engine.friction.is_some() && engine.gas.is_none()),
        (
            "loss factors of mounts",
            !moves && engine.mounts.iter().any(|mount| mount.spring.is_some()) && !can_move(engine),
        ),
    ]
    .into_iter()
    .filter_map(|(what, is_left_out)| is_left_out.then_some(what))
    .collect()
}

/// Whether the block stands on mounts that have a course in time.
fn can_move(engine: &Engine) -> bool {
    engine.block.is_some()
        && !engine.mounts.is_empty()
        && engine.mounts.iter().all(|mount| {
            mount.spring.as_ref().is_some_and(|spring| {
                spring.table.is_empty() && spring.loss_factor.iter().all(|loss| *loss == 0.0)
            })
        })
}

/// Pressures in the cylinders less those under the pistons as curves of a bond graph.
pub fn gauge_pressures(gas: &[CylinderGas]) -> Vec<Curve> {
    let units = [Unit::NONE, Unit::of([-1, 1, -2, 0, 0])];
    let curve = |own: &CylinderGas| -> Option<Curve> {
        let gauge = PeriodicCurve::sum(&[(1.0, &own.cylinder), (-1.0, &own.crankcase)]).ok()?;
        let pieces: Vec<(f64, [f64; 4])> =
            gauge.pieces().map(|(start, _, coefficients)| (start, coefficients)).collect();
        let end = pieces.first()?.0 + gauge.period();
        Curve::cubics(&pieces, end, true, units)
    };
    gas.iter().filter_map(curve).collect()
}
