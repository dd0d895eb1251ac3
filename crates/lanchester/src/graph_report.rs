//! The engine as a bond graph for the report: a working cycle at one speed.

use crate::bond_graph::{BondGraphRequest, engine_bond_graph};
use crate::pressure::measured::TraceFile;
use lanchester_bondgraph::{Graph, Notation, SimulationRequest, equations, placed};
use lanchester_file::Diagnostic;
use lanchester_model::{Engine, SimulationInput};
use lanchester_report::{BOND_GRAPH_VERSION, BondGraphResult};

/// Samples of the cycle, and the tolerance of its steps.
const SAMPLES: usize = 360;
const TOLERANCE: f64 = 1e-8;

/// Whether the file says what the graph of a running engine needs: its inertia and a block on mounts, or a run in time.
pub(crate) fn has_graph(engine: &Engine, input: Option<&SimulationInput>) -> bool {
    input.is_some() || (engine.flywheel.is_some() && engine.block.is_some() && engine.is_on_springs())
}

/// The graph of `engine`, its equations, and a working cycle from `speed` [rad/s] on, with the gas, block and load of the file.
///
/// # Errors
/// Why there is none, in words.
pub fn bond_graph_report(
    engine: &Engine,
    traces: &[TraceFile],
    input: Option<&SimulationInput>,
    speed: f64,
) -> Result<BondGraphResult, String> {
    let mut simulation = input.cloned().unwrap_or_default();
    // One cycle at a running speed: neither start nor duration of the run that the file describes.
    (simulation.duration, simulation.step, simulation.starter) = (None, None, None);
    let request = BondGraphRequest {
        speed: Some(speed),
        revolutions: f64::from(engine.strokes.revolutions()),
        simulation,
        ..BondGraphRequest::default()
    };
    let found = engine_bond_graph(engine, traces, &request).map_err(|error| error.to_string())?;
    let told = |mistakes: Vec<Diagnostic>| {
        mistakes.into_iter().map(|mistake| mistake.message).collect::<Vec<_>>().join("; ")
    };
    let graph = Graph::new(&found.description).map_err(told)?;
    let equations = equations(&graph).map_err(told)?;
    let asked =
        SimulationRequest { audit: true, samples: SAMPLES, tolerance: TOLERANCE, ..equations.request() };
    Ok(BondGraphResult {
        version: BOND_GRAPH_VERSION,
        notes: found.notes,
        drawing: placed(&graph, &equations.causality),
        causality: equations.causality.clone(),
        equations: equations.shown(Notation::Text),
        formulas: equations.shown(Notation::Latex),
        run: equations.simulate(&asked),
    })
}
