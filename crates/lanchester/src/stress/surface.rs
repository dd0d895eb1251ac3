//! Stress of the surface of a crankshaft over the cycle, by superposition, and the peaks of its fillets, solved directly.

use crate::pressure::cylinders::cylinder_gas;
use crate::pressure::measured::TraceFile;
use crate::stress::mesh::StressMesh;
use crate::stress::request::{StressError, StressStage, support_words};
use crate::stress::run::{check_crankshaft, sheet};
use crate::stress::unit_fields::{DIRECTIONS, NodeField, Solved, UnitFields};
use lanchester_flex::FlexError;
use lanchester_flex::case::StaticCase;
use lanchester_flex::crank_case::{
    BearingSurfaces, CrankCase, CrankSupport, PeakStress, PinLoad, PinPressure, crank_support, evaluate,
    load_pin,
};
use lanchester_flex::crank_mesh::{CrankMesh, FilletPlace};
use lanchester_flex::element::Stress;
use lanchester_flex::picture::{Skin, shown_factor, skin};
use lanchester_flex::sparse::{SolveEstimate, SolveReport};
use lanchester_flex::statics::{SolveOptions, StaticSystem};
use lanchester_mechanism::{BearingPart, BearingRequest, ThrowForce, throw_forces};
use lanchester_model::Engine;
use lanchester_report::CrankSheet;
use rayon::prelude::*;
use std::cell::RefCell;
use std::collections::HashMap;
use std::f64::consts::TAU;

/// Instants of a revolution.
const INSTANTS: usize = 360;

/// Share of the length of a crankshaft as which its largest displacement is shown at first.
const SHOWN: f64 = 0.04;

/// What to compute.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceRequest {
    /// Which crankshaft, how fine.
    pub mesh: StressMesh,
    /// What holds it: rings do not hold the same way whatever the load, and cannot.
    pub support: CrankSupport,
    /// Speed of crankshaft 1 [rad/s]; none: the highest of the engine.
    pub speed: Option<f64>,
    /// Whether the gas of the file acts.
    pub gas: bool,
    /// How to solve.
    pub solve: SolveOptions,
}

impl Default for SurfaceRequest {
    /// On journals, with gas.
    fn default() -> SurfaceRequest {
        SurfaceRequest {
            mesh: StressMesh::default(),
            support: CrankSupport::Journals,
            speed: None,
            gas: true,
            solve: SolveOptions::default(),
        }
    }
}

/// What a computation will cost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfacePlan {
    /// Nodes of the mesh.
    pub nodes: usize,
    /// Its matrix and factor.
    pub estimate: SolveEstimate,
    /// Load cases.
    pub cases: usize,
}

/// Stress of the surface of a crankshaft over the cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceStress {
    /// What was meshed.
    pub sheet: CrankSheet,
    /// What holds it, in words.
    pub support: String,
    /// Where the pressures come from; none where no gas acts.
    pub gas: Option<String>,
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// How the equations were solved.
    pub solve: SolveReport,
    /// The surface.
    pub skin: Skin,
    /// Fields of unit loads, node by node of the surface.
    pub fields: Vec<Vec<NodeField>>,
    /// Crank angles of the cycle [rad].
    pub theta: Vec<f64>,
    /// By how much each field counts at each of them.
    pub weights: Vec<Vec<f64>>,
    /// The fillets, along z.
    pub fillets: Vec<FilletCycle>,
    /// At the angle at which a fillet is stressed most of all.
    pub worst: Option<WorstCase>,
    /// Largest share by which superposition and direct solution of a fillet's peak differ.
    pub difference: f64,
    /// What was assumed.
    pub notes: Vec<String>,
}

/// A fillet over the cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct FilletCycle {
    /// "pin 1 at web 2".
    pub name: String,
    /// Radius [m]; 0 of a sharp corner.
    pub radius: f64,
    /// Its nodes, by their place in the skin.
    pub nodes: Vec<u32>,
    /// Its largest von Mises stress at each crank angle [Pa]; empty of a sharp corner, whose stress is no number.
    pub curve: Vec<f64>,
    /// The largest of the cycle.
    pub peak: Option<FilletPeak>,
}

/// The largest stress of a fillet over the cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilletPeak {
    /// Its place in the list of crank angles.
    pub instant: usize,
    /// Solved directly at that angle.
    pub stress: PeakStress,
}

/// The case that stresses a fillet most of all.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WorstCase {
    /// Its place in the list of crank angles.
    pub instant: usize,
    /// Largest displacement [m].
    pub displacement: f64,
    /// Elastic energy [J].
    pub energy: f64,
    /// A round factor that makes displacements visible.
    pub factor: f64,
}

/// What [`surface_stress`] will cost.
///
/// # Errors
/// As [`surface_stress`].
pub fn surface_plan(engine: &Engine, request: &SurfaceRequest) -> Result<SurfacePlan, StressError> {
    check(engine, request)?;
    let sheet = sheet(engine, &request.mesh, &|_| {})?;
    let surfaces = BearingSurfaces::new(&sheet.crank);
    let base = crank_support(&sheet.crank, &surfaces, &request.support, 0.0)?;
    let found = RefCell::new(None);
    // The estimate comes before the limit on memory, which ends it here.
    let options = SolveOptions { memory: 0, ..request.solve };
    let see = |estimate: &SolveEstimate| *found.borrow_mut() = Some(*estimate);
    let ended = StaticSystem::new_watched(&sheet.crank.mesh, &base, options, &see).map(|_| ());
    match (found.into_inner(), ended) {
        (Some(estimate), _) => {
            let cases = throws(engine, request.mesh.crankshaft).len() * DIRECTIONS + 1;
            Ok(SurfacePlan { nodes: sheet.crank.mesh.nodes.len(), estimate, cases })
        }
        (None, Err(error)) => Err(error.into()),
        (None, Ok(())) => Err(StressError::Cancelled),
    }
}

/// Stress of the surface over the cycle; `watch` sees how far it is, and `waits` says whether somebody waits for it. `traces` holds the files
/// that [`crate::trace_names`] names.
///
/// # Errors
/// [`StressError`] where the file says too little, the shape is not covered, the support is not linear, or the factor needs more memory than
/// allowed; [`StressError::Cancelled`] where nobody waits any more.
pub fn surface_stress(
    engine: &Engine,
    traces: &[TraceFile],
    request: &SurfaceRequest,
    watch: &dyn Fn(StressStage),
    waits: &dyn Fn() -> bool,
) -> Result<SurfaceStress, StressError> {
    check(engine, request)?;
    let crankshaft = request.mesh.crankshaft;
    let speed = request.speed.unwrap_or(engine.speed.highest);
    let (theta, forces, gas) = loads(engine, traces, request, speed)?;
    let sheet = sheet(engine, &request.mesh, watch)?;
    if sheet.crank.corners.iter().all(|corner| corner.nodes.is_empty()) {
        return Err(StressError::NoFillet { crankshaft: crankshaft + 1 });
    }
    let skin = skin(&sheet.crank.mesh);
    let surfaces = BearingSurfaces::new(&sheet.crank);
    let own_speed = engine.crankshafts[crankshaft].ratio.value() * speed;
    let base = crank_support(&sheet.crank, &surfaces, &request.support, 0.0)?;
    let turning = StaticCase { speed: own_speed, ..base.clone() };
    let estimate = |estimate: &_| watch(StressStage::Factoring(*estimate));
    let mut system = StaticSystem::new_watched(&sheet.crank.mesh, &turning, request.solve, &estimate)?;
    let mesh = &sheet.crank.mesh;
    let mut solved =
        Solved { mesh, surfaces: &surfaces, base: &base, system: &mut system, nodes: &skin.nodes, waits };
    let units = UnitFields::new(throws(engine, crankshaft), own_speed, &mut solved)?;
    let weights: Vec<Vec<f64>> = forces.iter().map(|own| units.weights(own, own_speed)).collect();
    let mut fillets = fillets(&sheet.crank.corners, &skin, &units.fields, &weights);
    let direct = Direct { crank: &sheet.crank, turning: &turning, forces: &forces };
    let (worst, difference) = direct.peaks(&mut fillets, &mut solved)?;
    drop(system);
    Ok(SurfaceStress {
        support: support_words(&request.support),
        gas,
        speed,
        solve: units.report,
        skin,
        fields: units.fields,
        theta,
        weights,
        fillets,
        worst,
        difference,
        notes: notes(difference),
        sheet,
    })
}

fn check(engine: &Engine, request: &SurfaceRequest) -> Result<(), StressError> {
    check_crankshaft(engine, &request.mesh)?;
    match &request.support {
        support if !support.is_linear() => Err(FlexError::Nonlinear.into()),
        support if support.depends_on_angle() => Err(StressError::AngledSprings),
        _ => Ok(()),
    }
}

fn throws(engine: &Engine, crankshaft: usize) -> Vec<usize> {
    (0..engine.throws.len()).filter(|throw| engine.throws[*throw].crankshaft == crankshaft).collect()
}

/// Angles over the cycle, forces on the pins there, and where the pressures come from.
type CycleLoads = (Vec<f64>, Vec<Vec<ThrowForce>>, Option<String>);

fn loads(
    engine: &Engine,
    traces: &[TraceFile],
    request: &SurfaceRequest,
    speed: f64,
) -> Result<CycleLoads, StressError> {
    let gas = match &engine.gas {
        Some(_) if request.gas => Some(cylinder_gas(engine, traces, speed)?),
        _ => None,
    };
    let part = if gas.is_some() { BearingPart::All } else { BearingPart::Inertia };
    let asked = BearingRequest { speed: Some(speed), part, ..BearingRequest::default() };
    let revolutions = engine.strokes.revolutions();
    let count = INSTANTS * revolutions as usize;
    let period = TAU * f64::from(revolutions);
    let theta: Vec<f64> = (0..count).map(|k| period * k as f64 / count as f64).collect();
    let cylinders = gas.as_ref().map(|gas| gas.cylinders.as_slice());
    let forces = throw_forces(engine, cylinders, &asked, request.mesh.crankshaft, &theta)?;
    Ok((theta, forces, gas.map(|gas| gas.source)))
}

/// Every fillet with its largest stress at each instant, by superposition.
fn fillets(
    corners: &[FilletPlace],
    skin: &Skin,
    fields: &[Vec<NodeField>],
    weights: &[Vec<f64>],
) -> Vec<FilletCycle> {
    let places: HashMap<u32, u32> =
        skin.nodes.iter().enumerate().map(|(place, node)| (*node, place as u32)).collect();
    let of = |corner: &FilletPlace| {
        let nodes: Vec<u32> = corner.nodes.iter().filter_map(|node| places.get(node).copied()).collect();
        let curve = match nodes.is_empty() {
            true => Vec::new(),
            false => weights.par_iter().map(|weights| largest(&nodes, fields, weights)).collect(),
        };
        FilletCycle { name: corner.name.clone(), radius: corner.radius, nodes, curve, peak: None }
    };
    corners.iter().map(of).collect()
}

/// Largest von Mises stress of nodes at an instant [Pa].
fn largest(nodes: &[u32], fields: &[Vec<NodeField>], weights: &[f64]) -> f64 {
    let mut sums = vec![[0.0f32; 6]; nodes.len()];
    for (field, weight) in fields.iter().zip(weights) {
        let weight = *weight as f32;
        for (sum, node) in sums.iter_mut().zip(nodes) {
            let stress = &field[*node as usize][3..];
            sum.iter_mut().zip(stress).for_each(|(sum, stress)| *sum += weight * stress);
        }
    }
    sums.into_iter().map(|sum| Stress(sum.map(f64::from)).von_mises()).fold(0.0, f64::max)
}

/// Instants that are solved directly.
struct Direct<'a> {
    crank: &'a CrankMesh,
    /// Supports with the speed.
    turning: &'a StaticCase,
    forces: &'a [Vec<ThrowForce>],
}

impl Direct<'_> {
    /// Solves the instants at which the fillets are stressed most, for their peaks; the worst of them, and the largest share by which
    /// superposition differs.
    fn peaks(
        &self,
        fillets: &mut [FilletCycle],
        solved: &mut Solved,
    ) -> Result<(Option<WorstCase>, f64), StressError> {
        let highest = |curve: &[f64]| (0..curve.len()).max_by(|a, b| curve[*a].total_cmp(&curve[*b]));
        let wanted: Vec<Option<usize>> = fillets.iter().map(|own| highest(&own.curve)).collect();
        let mut instants: Vec<usize> = wanted.iter().flatten().copied().collect();
        instants.sort_unstable();
        instants.dedup();
        let cases = instants.iter().map(|k| self.case(solved.surfaces, *k)).collect::<Result<Vec<_>, _>>()?;
        let (mut worst, mut most, mut difference) = (None, 0.0, 0.0f64);
        solved.each(&cases, &mut |k, solution| {
            let found = evaluate(self.crank, solution);
            let own = fillets.iter_mut().zip(&wanted).zip(&found.peaks);
            for ((fillet, _), peak) in own.filter(|((_, wanted), _)| **wanted == Some(instants[k])) {
                let Some(stress) = peak.stress else { continue };
                fillet.peak = Some(FilletPeak { instant: instants[k], stress });
                difference = difference.max((fillet.curve[instants[k]] / stress.von_mises - 1.0).abs());
                if stress.von_mises > most {
                    most = stress.von_mises;
                    worst = Some(self.worst(instants[k], &found));
                }
            }
        })?;
        Ok((worst, difference))
    }

    fn case(&self, surfaces: &BearingSurfaces, instant: usize) -> Result<StaticCase, FlexError> {
        let load = |case, own: &ThrowForce| {
            let load = PinLoad { pin: own.throw + 1, force: [own.force.re, own.force.im] };
            load_pin(surfaces, case, load, PinPressure::Cosine)
        };
        self.forces[instant].iter().try_fold(self.turning.clone(), load)
    }

    fn worst(&self, instant: usize, found: &CrankCase) -> WorstCase {
        WorstCase {
            instant,
            displacement: found.largest_displacement,
            energy: found.solution.energy,
            factor: shown_factor(&self.crank.mesh, &found.solution.displacements, SHOWN),
        }
    }
}

fn notes(difference: f64) -> Vec<String> {
    vec![
        "Forces of gas and of the inertia of pistons and rods from the closed form at constant speed; the crankshaft's own centrifugal field acts. \
         Loads on a pin act as a pressure p0 cos(a) over 180 deg and its whole width between the fillets; small displacements, linear elastic."
            .to_owned(),
        format!(
            "Picture and curves are sums of unit loads: {DIRECTIONS} directions of a force on each pin, and the centrifugal field. The table of fillets is \
             solved directly at the crank angle of each fillet's largest stress; there the sums differ from it by {:.2} % at most.",
            100.0 * difference
        ),
    ]
}
