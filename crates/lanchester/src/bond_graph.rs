//! The bond graph of an engine file, with its gas, friction, block and load.

use crate::crosscheck::rotor_inertia;
use crate::pressure::{GasError, TraceFile, cylinder_gas};
use lanchester_bondgraph::{
    Curve, Description, EngineBlock, EngineDrive, EngineGraphError, EngineLoad, EngineRequest, LoadTorque,
    Unit, engine_graph,
};
use lanchester_mechanism::{CylinderGas, GasTrain, Lever, PeriodicCurve, TorqueError, TorqueRequest, torque};
use lanchester_model::Engine;
use lanchester_multibody::STANDARD_GRAVITY;

/// What the graph of an engine file is to hold; the rest follows from the engine.
#[derive(Debug, Clone, PartialEq)]
pub struct BondGraphRequest {
    /// Speed of crankshaft 1 at the start [rad/s]; `None`: the highest of the engine.
    pub speed: Option<f64>,
    /// How the block moves; `None`: in space on mounts where the file gives them in a form that has a course in time, else not at all.
    pub block: Option<EngineBlock>,
    /// Whether the speed is imposed; `None`: where nothing gives the crankshaft an inertia.
    pub imposed: Option<bool>,
    /// Whether weight acts.
    pub gravity: bool,
    /// Whether the gas of the file acts.
    pub gas: bool,
    /// Torque of the load; `None`: with gas the mean that the engine gives at the start speed, without none.
    pub load: Option<LoadTorque>,
    /// Whether the load is bolted to the block.
    pub load_on_block: bool,
    /// Revolutions of a simulation at the start speed.
    pub revolutions: f64,
}

impl Default for BondGraphRequest {
    fn default() -> Self {
        BondGraphRequest {
            speed: None,
            block: None,
            imposed: None,
            gravity: true,
            gas: true,
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
    let speed = request.speed.unwrap_or(engine.speed.highest);
    let mut notes = Vec::new();
    let inertia = rotor_inertia(engine);
    let known = |list: &[Option<f64>]| -> Vec<f64> { list.iter().map(|own| own.unwrap_or(0.0)).collect() };
    let crankshaft_inertia = known(&inertia.crankshafts);
    let has_inertia = crankshaft_inertia.first().is_some_and(|own| *own > 0.0);
    let imposed = request.imposed.unwrap_or(!has_inertia);
    if imposed && request.imposed.is_none() {
        notes.push(
            "The speed is imposed: nothing gives the crankshaft an inertia ([flywheel] or [crank.body] do)."
                .to_owned(),
        );
    }
    let block =
        request.block.unwrap_or(if can_move(engine) { EngineBlock::Space } else { EngineBlock::Fixed });
    if request.block.is_none() && block == EngineBlock::Fixed {
        notes.push(
            "The block is fixed: the file gives no [block] on mounts with stiffness and viscous damping."
                .to_owned(),
        );
    }
    let report = match (&engine.gas, request.gas) {
        (Some(_), true) => Some(cylinder_gas(engine, traces, speed)?),
        _ => None,
    };
    let mut found = EngineRequest::free(speed, request.revolutions);
    let mut mean = 0.0;
    if let Some(report) = &report {
        found.pressures = gauge_pressures(&report.cylinders);
        mean = GasTrain::new(engine, &report.cylinders, Lever::Exact)?.mean_torques().iter().sum();
        if let Some(friction) = engine.friction {
            let asked =
                TorqueRequest { speed: Some(speed), samples: 4, max_order: 1, ..TorqueRequest::default() };
            let given = torque(engine, &report.cylinders, &asked)?;
            let brake = given.indicated.brake(&friction, speed);
            found.friction_torque = (given.indicated.torque - brake.torque).max(0.0);
        }
    }
    let law = match request.load {
        Some(law) => law,
        None if imposed || report.is_none() => LoadTorque::None,
        None => {
            let load = mean - found.friction_torque;
            notes.push(format!(
                "Load: {load:.4} N m, constant, the mean that the engine gives at the start speed."
            ));
            LoadTorque::Constant(load)
        }
    };
    found.drive = if imposed { EngineDrive::Imposed } else { EngineDrive::Free };
    found.block = block;
    found.mounts = engine.mounts.iter().any(|mount| mount.spring.is_some());
    found.gravity = if request.gravity { STANDARD_GRAVITY } else { 0.0 };
    found.crankshaft_inertia = crankshaft_inertia;
    found.shaft_inertia = known(&inertia.shafts);
    found.load = EngineLoad { torque: law, reacts_on_block: request.load_on_block };
    Ok(EngineBondGraph { description: engine_graph(engine, &found)?, notes })
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
