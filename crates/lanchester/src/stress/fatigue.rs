//! Fatigue of a crankshaft: finite elements give the stress of unit loads, the closed form the loads, Findley's criterion judges every fillet.
//!
//! Forces on a pin are a pressure over the half of its surface that faces them, so their pattern turns with them. Unit forces in 24 directions are solved for each
//! pin; a force between two of them is their sum with weights that give its resultant:
//!
//! ```text
//! F = |F| (sin(a_1 - a)/sin(a_1 - a_0) e_0 + sin(a - a_0)/sin(a_1 - a_0) e_1)         a_0 <= a < a_1                   (book, eq. 49.15)
//! ```

use crate::pressure::cylinders::cylinder_gas;
use crate::pressure::measured::TraceFile;
use crate::stress::mesh::StressMesh;
use crate::stress::request::{StressError, StressStage, support_words};
use crate::stress::run::{check_crankshaft, sheet};
use crate::stress::worst_point::WorstPoint;
use lanchester_flex::case::StaticCase;
use lanchester_flex::crank_case::{
    BearingSurfaces, CrankSupport, PinLoad, PinPressure, crank_support, load_pin,
};
use lanchester_flex::crank_mesh::CrankMesh;
use lanchester_flex::sparse::SolveReport;
use lanchester_flex::statics::{SolveOptions, StaticSystem, node_stresses};
use lanchester_mechanism::{BearingPart, BearingRequest, ThrowForce, throw_forces};
use lanchester_model::Engine;
use lanchester_report::{
    CRANK_FATIGUE_VERSION, CrankFatigue, FatigueAtSpeed, FatigueFactors, FatigueMeasure, FilletFatigue,
};
use lanchester_strength::{FatigueLimits, Findley, StressState};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Directions of unit forces on each pin.
const DIRECTIONS: usize = 24;

/// Cases that are solved at once.
const BLOCK: usize = 8;

/// Size of a unit force [N].
const UNIT: f64 = 1000.0;

/// What to compute.
#[derive(Debug, Clone, PartialEq)]
pub struct FatigueRequest {
    /// Which crankshaft, how fine.
    pub mesh: StressMesh,
    /// What holds it.
    pub support: CrankSupport,
    /// Speeds of crankshaft 1 [rad/s]; none: the lowest and the highest of the engine.
    pub speeds: Vec<f64>,
    /// Whether the gas of the file acts.
    pub gas: bool,
    /// What lowers the fatigue limits of polished specimens.
    pub factors: FatigueFactors,
    /// Instants of a revolution of crankshaft 1.
    pub instants: usize,
    /// How to solve.
    pub solve: SolveOptions,
}

impl Default for FatigueRequest {
    /// On journals, with gas, polished, every 5 degrees.
    fn default() -> FatigueRequest {
        FatigueRequest {
            mesh: StressMesh::default(),
            support: CrankSupport::Journals,
            speeds: Vec::new(),
            gas: true,
            factors: FatigueFactors::default(),
            instants: 72,
            solve: SolveOptions::default(),
        }
    }
}

/// Safety against fatigue of every fillet of a crankshaft; `watch` sees how far it is. `traces` holds the files that [`crate::trace_names`] names.
///
/// # Errors
/// [`StressError`] where the file says too little, the shape is not covered, or the factor needs more memory than allowed.
pub fn crank_fatigue(
    engine: &Engine,
    traces: &[TraceFile],
    request: &FatigueRequest,
    watch: &dyn Fn(StressStage),
) -> Result<CrankFatigue, StressError> {
    check_crankshaft(engine, &request.mesh)?;
    if request.support.depends_on_angle() {
        return Err(StressError::AngledSprings);
    }
    let measure = fatigue_measure(engine, request.factors)?.ok_or(StressError::NoFatigueLimit)?;
    let yielding = engine.crank_material.unwrap_or_default().yield_strength();
    let crankshaft = request.mesh.crankshaft;
    let mut speeds = request.speeds.clone();
    if speeds.is_empty() {
        speeds = vec![engine.speed.lowest, engine.speed.highest];
        speeds.dedup();
    }
    let sheet = sheet(engine, &request.mesh, watch)?;
    if sheet.crank.corners.iter().all(|corner| corner.nodes.is_empty()) {
        return Err(StressError::NoFillet { crankshaft: crankshaft + 1 });
    }
    let units = UnitStresses::new(engine, &sheet.crank, request, watch)?;
    let ratio = engine.crankshafts[crankshaft].ratio.value();
    let (mut found, mut source) = (Vec::new(), None);
    for speed in speeds {
        let gas = match &engine.gas {
            Some(_) if request.gas => Some(cylinder_gas(engine, traces, speed)?),
            _ => None,
        };
        let part = if gas.is_some() { BearingPart::All } else { BearingPart::Inertia };
        let asked = BearingRequest { speed: Some(speed), part, ..BearingRequest::default() };
        let revolutions = engine.strokes.revolutions();
        let count = request.instants.max(4) * revolutions as usize;
        let period = TAU * f64::from(revolutions);
        let theta: Vec<f64> = (0..count).map(|k| period * k as f64 / count as f64).collect();
        let cylinders = gas.as_ref().map(|gas| gas.cylinders.as_slice());
        let forces = throw_forces(engine, cylinders, &asked, crankshaft, &theta)?;
        let weights: Vec<Vec<(usize, f64)>> =
            forces.iter().map(|forces| units.weights(forces, ratio * speed)).collect();
        let judge = |corner: &lanchester_flex::crank_mesh::FilletPlace| {
            let history = |node: usize| units.history(corner.nodes[node], &weights);
            let mut worst = WorstPoint::new(&measure.findley);
            (0..corner.nodes.len()).for_each(|node| worst.see(node, &history(node)));
            let worst = worst.found(history)?;
            let at = sheet.crank.mesh.nodes[corner.nodes[worst.node] as usize];
            Some(FilletFatigue {
                name: corner.name.clone(),
                radius: corner.radius,
                at,
                angle: (at[1] - corner.centre.y).atan2(at[0] - corner.centre.x),
                critical_angle: theta[worst.point.plane.instant],
                point: worst.point,
                von_mises: worst.von_mises,
                static_safety: yielding.map(|strength| strength.value / worst.von_mises),
            })
        };
        let fillets: Vec<FilletFatigue> = sheet.crank.corners.par_iter().filter_map(judge).collect();
        found.push(FatigueAtSpeed { speed, fillets });
        source = gas.map(|gas| gas.source).or(source);
    }
    Ok(CrankFatigue {
        version: CRANK_FATIGUE_VERSION,
        support: support_words(&request.support),
        gas: source,
        solve: units.report,
        measure,
        instants: request.instants,
        speeds: found,
        notes: notes(&measure),
        sheet,
    })
}

/// Findley's criterion with the limits of the crankshaft's material; `None` where the file gives no strength.
///
/// # Errors
/// [`StressError`] where the criterion cannot hold both limits.
pub(crate) fn fatigue_measure(
    engine: &Engine,
    factors: FatigueFactors,
) -> Result<Option<FatigueMeasure>, StressError> {
    let material = engine.crank_material.unwrap_or_default();
    let (Some(bending), Some(torsion)) = (material.fatigue_bending(), material.fatigue_torsion()) else {
        return Ok(None);
    };
    let limits = FatigueLimits { bending: bending.value, torsion: torsion.value };
    let findley = Findley::new(limits, factors.product())?;
    Ok(Some(FatigueMeasure { bending_limit: bending, torsion_limit: torsion, findley, factors }))
}

fn notes(measure: &FatigueMeasure) -> Vec<String> {
    let mut notes = vec![
        "Forces of gas and of the inertia of pistons and rods from the closed form at constant speed; the crankshaft's own centrifugal field acts. Torsional vibration and \
         the bearings' films are left out: use the sheet of formulas for the former."
            .to_owned(),
        "Findley's criterion at the surface nodes of every fillet; a node that cannot hold the largest value, by an upper bound, is passed over. Stress is that of the \
         mesh: with 6 elements across a fillet some 2 % of the peak are missing."
            .to_owned(),
    ];
    notes.extend(measure.estimated());
    notes
}

/// Stress of unit loads at the nodes of fillets.
struct UnitStresses {
    /// Index of each pin's throw, by its place.
    throws: Vec<usize>,
    /// Place of each fillet node.
    places: BTreeMap<u32, usize>,
    /// By case (pins by directions, then the centrifugal field at 1 rad/s) and place [Pa].
    stresses: Vec<Vec<StressState>>,
    /// Of the last block.
    report: SolveReport,
}

impl UnitStresses {
    fn new(
        engine: &Engine,
        crank: &CrankMesh,
        request: &FatigueRequest,
        watch: &dyn Fn(StressStage),
    ) -> Result<UnitStresses, StressError> {
        let own = |throw: &usize| engine.throws[*throw].crankshaft == request.mesh.crankshaft;
        let throws: Vec<usize> = (0..engine.throws.len()).filter(own).collect();
        let surfaces = BearingSurfaces::new(crank);
        let base = crank_support(crank, &surfaces, &request.support, 0.0)?;
        let top = engine.speed.highest.max(1.0);
        let mut cases = Vec::new();
        for throw in &throws {
            for k in 0..DIRECTIONS {
                let (sin, cos) = (TAU * k as f64 / DIRECTIONS as f64).sin_cos();
                let load = PinLoad { pin: throw + 1, force: [UNIT * cos, UNIT * sin] };
                cases.push((load_pin(&surfaces, base.clone(), load, PinPressure::Cosine)?, UNIT));
            }
        }
        cases.push((StaticCase { speed: top, ..base }, top * top));
        let places: BTreeMap<u32, usize> = {
            let nodes: std::collections::BTreeSet<u32> =
                crank.corners.iter().flat_map(|corner| corner.nodes.iter().copied()).collect();
            nodes.into_iter().enumerate().map(|(place, node)| (node, place)).collect()
        };
        let estimate = |estimate: &_| watch(StressStage::Factoring(*estimate));
        let turning = cases.last().map(|(case, _)| case.clone()).unwrap_or_default();
        let mut system = StaticSystem::new_watched(&crank.mesh, &turning, request.solve, &estimate)?;
        let (mut stresses, mut report) = (Vec::with_capacity(cases.len()), None);
        for block in cases.chunks(BLOCK) {
            let solutions = system.solve(&block.iter().map(|(case, _)| case).collect::<Vec<_>>())?;
            let of =
                |(solution, (_, size)): (&lanchester_flex::statics::StaticSolution, &(StaticCase, f64))| {
                    let all = node_stresses(&crank.mesh, &solution.displacements);
                    places.keys().map(|node| all[*node as usize].stress.0.map(|s| s / size)).collect()
                };
            stresses.extend(solutions.iter().zip(block).map(of));
            report = solutions.first().map(|solution| solution.report).or(report);
        }
        let report = report.ok_or_else(|| StressError::Missing {
            what: "load case",
            number: 1,
            there: "none".to_owned(),
        })?;
        Ok(UnitStresses { throws, places, stresses, report })
    }

    /// Cases with their weights that make up the loads of an instant; `speed` of the crankshaft itself [rad/s].
    fn weights(&self, forces: &[ThrowForce], speed: f64) -> Vec<(usize, f64)> {
        let step = TAU / DIRECTIONS as f64;
        let mut weights = vec![(self.stresses.len() - 1, speed * speed)];
        for force in forces {
            let Some(pin) = self.throws.iter().position(|throw| *throw == force.throw) else { continue };
            let (size, angle) = (force.force.norm(), force.force.arg().rem_euclid(TAU));
            let first = (angle / step) as usize % DIRECTIONS;
            let beyond = angle - step * first as f64;
            let second = (first + 1) % DIRECTIONS;
            weights.push((pin * DIRECTIONS + first, size * (step - beyond).sin() / step.sin()));
            weights.push((pin * DIRECTIONS + second, size * beyond.sin() / step.sin()));
        }
        weights
    }

    /// Stress of a node at every instant.
    fn history(&self, node: u32, weights: &[Vec<(usize, f64)>]) -> Vec<StressState> {
        let place = self.places[&node];
        weights.iter().map(|weights| self.stress(place, weights)).collect()
    }

    /// Stress of a node at an instant.
    fn stress(&self, place: usize, weights: &[(usize, f64)]) -> StressState {
        weights.iter().fold([0.0; 6], |sum, (case, weight)| {
            let own = &self.stresses[*case][place];
            std::array::from_fn(|i| sum[i] + weight * own[i])
        })
    }
}
