//! Static cases of a crankshaft: supports by name, loads on pins.
//!
//! ```text
//! p(a) = p_0 cos(a - a_F)  over 180 degrees about the load's direction,  scaled so that the resultant is F          (book, eq. 43.10)
//! ```

use crate::FlexError;
use crate::case::{Spring, StaticCase};
use crate::crank_mesh::CrankMesh;
use crate::mesh::{SurfaceFace, surface, surface_areas};
use crate::statics::{NodeStress, SolveOptions, StaticSolution, StaticSystem, node_stresses};
use serde::Serialize;
use std::collections::{BTreeMap, HashSet};

/// What holds a crankshaft.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum CrankSupport {
    /// Both end faces.
    ClampedEnds,
    /// The mean of each journal's surface in x and y by rigid springs in effect, axial motion at the flywheel, turning there.
    Journals,
    /// As `Journals`, with springs of this stiffness per journal and direction [N/m].
    Springs {
        /// Stiffness [N/m].
        stiffness: f64,
    },
    /// None: loads are balanced by inertia.
    Free,
}

/// A force on a crankpin, in the frame of the crankshaft.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PinLoad {
    /// Number of the pin, from 1.
    pub pin: usize,
    /// Force on the pin [N].
    pub force: [f64; 2],
}

/// The largest stress of a fillet.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FilletPeak {
    /// "pin 1 at web 2".
    pub name: String,
    /// Largest von Mises stress [Pa]; none of a sharp corner, where it would grow with every refinement.
    pub von_mises: Option<f64>,
    /// Principal stress of the largest size there [Pa], tension positive.
    pub principal: f64,
    /// Jump of the stress between the elements there over the stress: a sign of the error.
    pub jump: f64,
    /// Place on the surface [m].
    pub at: [f64; 3],
    /// Angle about the bar's middle [rad].
    pub angle: f64,
}

/// A solved case of a crankshaft.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrankCase {
    /// Displacement, energy, reactions.
    pub solution: StaticSolution,
    /// Stress at each node.
    #[serde(skip)]
    pub stresses: Vec<NodeStress>,
    /// Largest displacement [m].
    pub largest_displacement: f64,
    /// Peaks of all fillets, along z.
    pub peaks: Vec<FilletPeak>,
}

/// Stiffness that counts as rigid beside a crankshaft [N/m].
const RIGID: f64 = 1e13;

/// The supports of a crankshaft as a case without loads.
///
/// # Errors
/// [`FlexError::Missing`] where the mesh lacks a set; [`FlexError::Number`] for a stiffness that is none.
pub fn crank_support(crank: &CrankMesh, support: CrankSupport) -> Result<StaticCase, FlexError> {
    let mesh = &crank.mesh;
    let case = StaticCase::default();
    let stiffness = match support {
        CrankSupport::ClampedEnds => {
            let ends = [mesh.set("FREE_END")?, mesh.set("FLYWHEEL")?].map(|set| set.nodes.clone()).concat();
            return Ok(StaticCase { name: "clamped ends".to_owned(), ..case }.clamp(&ends));
        }
        CrankSupport::Free => {
            return Ok(StaticCase { name: "free".to_owned(), inertia_relief: true, ..case });
        }
        CrankSupport::Journals => RIGID,
        CrankSupport::Springs { stiffness } => stiffness,
    };
    let mut case = StaticCase { name: "journals".to_owned(), ..case };
    let (faces, _) = surface(mesh);
    for number in 1.. {
        let name = format!("MAIN_{number}");
        let Ok(set) = mesh.set(&name) else { break };
        let weights = weights(&set.nodes, &bearing_areas(crank, &set.nodes, &faces));
        for (axis, letter) in ["x", "y"].into_iter().enumerate() {
            let mut direction = [0.0; 3];
            direction[axis] = 1.0;
            case.springs.push(Spring {
                name: format!("{name} {letter}"),
                stiffness,
                direction,
                nodes: weights.clone(),
            });
        }
    }
    if case.springs.is_empty() {
        let (what, name, hint) =
            ("node set", "MAIN_1".to_owned(), "a crankshaft on journals has at least two of them");
        return Err(FlexError::Missing { what, name, hint });
    }
    // At the flywheel: no motion along z or about it.
    let end = mesh.set("FLYWHEEL")?;
    let count = end.nodes.len() as f64;
    let even: Vec<(u32, f64)> = end.nodes.iter().map(|node| (*node, 1.0 / count)).collect();
    case.springs.push(Spring {
        name: "FLYWHEEL z".to_owned(),
        stiffness: RIGID,
        direction: [0.0, 0.0, 1.0],
        nodes: even,
    });
    let far = |axis: usize| {
        end.nodes
            .iter()
            .copied()
            .max_by(|a, b| mesh.nodes[*a as usize][axis].total_cmp(&mesh.nodes[*b as usize][axis]))
    };
    let (Some(right), Some(left)) = (
        far(0),
        end.nodes
            .iter()
            .copied()
            .min_by(|a, b| mesh.nodes[*a as usize][0].total_cmp(&mesh.nodes[*b as usize][0])),
    ) else {
        return Ok(case);
    };
    // A couple: the difference of the tangential motions of two nodes across.
    case.springs.push(Spring {
        name: "FLYWHEEL turning".to_owned(),
        stiffness: RIGID,
        direction: [0.0, 1.0, 0.0],
        nodes: vec![(right, 0.5), (left, -0.5)],
    });
    Ok(case)
}

/// Areas that nodes of a bearing surface carry, as vectors along the outward normal [m^2].
fn bearing_areas(crank: &CrankMesh, nodes: &[u32], faces: &[SurfaceFace]) -> BTreeMap<u32, [f64; 3]> {
    let own: HashSet<u32> = nodes.iter().copied().collect();
    let faces: Vec<SurfaceFace> =
        faces.iter().filter(|face| face.nodes.iter().all(|node| own.contains(node))).cloned().collect();
    surface_areas(&crank.mesh, &faces)
}

fn weights(nodes: &[u32], areas: &BTreeMap<u32, [f64; 3]>) -> Vec<(u32, f64)> {
    let size = |node: &u32| areas.get(node).map_or(0.0, |area| area[0].hypot(area[1]));
    let all: f64 = nodes.iter().map(size).sum();
    nodes.iter().filter(|node| size(node) > 0.0).map(|node| (*node, size(node) / all)).collect()
}

/// Adds a force on a pin as a pressure over 180 degrees of its surface (eq. 43.10).
///
/// # Errors
/// [`FlexError::Missing`] where there is no such pin; [`FlexError::Number`] for a force that is none.
pub fn load_pin(crank: &CrankMesh, case: StaticCase, load: PinLoad) -> Result<StaticCase, FlexError> {
    let size = load.force[0].hypot(load.force[1]);
    if !size.is_finite() {
        let quantity = format!("the force on pin {} [N]", load.pin);
        return Err(FlexError::Number {
            quantity,
            needed: "finite".to_owned(),
            got: size,
            hint: "give a number",
        });
    }
    let set = crank.mesh.set(&format!("PIN_{}", load.pin))?;
    if size == 0.0 {
        return Ok(case);
    }
    let along = load.force.map(|force| force / size);
    let (faces, _) = surface(&crank.mesh);
    let areas = bearing_areas(crank, &set.nodes, &faces);
    // The pressure acts where the surface faces against the force, and pushes inwards.
    let mut forces: Vec<(u32, [f64; 2])> = Vec::new();
    let mut sum = [0.0; 2];
    for (node, [x, y, _]) in &areas {
        let facing = -(x * along[0] + y * along[1]) / x.hypot(*y).max(f64::MIN_POSITIVE);
        if facing > 0.0 {
            let force = [-facing * x, -facing * y];
            sum = [sum[0] + force[0], sum[1] + force[1]];
            forces.push((*node, force));
        }
    }
    // Scaled and, by a little shear of the same pattern, turned so that the discrete resultant is the force exactly.
    let parallel = sum[0] * along[0] + sum[1] * along[1];
    let across = sum[1] * along[0] - sum[0] * along[1];
    let (scale, slip) = (size / parallel, across / parallel);
    let mut case = case;
    for (node, [x, y]) in forces {
        let (p, q) = (x * along[0] + y * along[1], y * along[0] - x * along[1]);
        let (p, q) = (scale * p, scale * (q - slip * p));
        case = case.push(&[(node, 1.0)], [p * along[0] - q * along[1], p * along[1] + q * along[0], 0.0]);
    }
    Ok(case)
}

/// Solves a crankshaft with one support under several sets of loads on its pins, each with the centrifugal field at a speed [rad/s].
///
/// # Errors
/// As [`crank_support`], [`load_pin`] and [`StaticSystem::new`].
pub fn solve_crank(
    crank: &CrankMesh,
    support: CrankSupport,
    loads: &[Vec<PinLoad>],
    speed: f64,
    options: SolveOptions,
) -> Result<Vec<CrankCase>, FlexError> {
    let base = StaticCase { speed, ..crank_support(crank, support)? };
    let loaded =
        |loads: &Vec<PinLoad>| loads.iter().try_fold(base.clone(), |case, load| load_pin(crank, case, *load));
    let cases = loads.iter().map(loaded).collect::<Result<Vec<StaticCase>, FlexError>>()?;
    let mut system = StaticSystem::new(&crank.mesh, &base, options)?;
    let solutions = system.solve(&cases.iter().collect::<Vec<_>>())?;
    Ok(solutions.into_iter().map(|solution| evaluate(crank, solution)).collect())
}

fn evaluate(crank: &CrankMesh, solution: StaticSolution) -> CrankCase {
    let stresses = node_stresses(&crank.mesh, &solution.displacements);
    let length = |u: &[f64; 3]| (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]).sqrt();
    let largest_displacement = solution.displacements.iter().map(length).fold(0.0, f64::max);
    let value = |node: &u32| stresses[*node as usize].stress.von_mises();
    let peak = |corner: &crate::crank_mesh::FilletPlace| {
        let Some(node) = corner.nodes.iter().copied().max_by(|a, b| value(a).total_cmp(&value(b))) else {
            let at = [corner.centre.x, corner.centre.y, 0.0];
            return FilletPeak {
                name: corner.name.clone(),
                von_mises: None,
                principal: 0.0,
                jump: 0.0,
                at,
                angle: 0.0,
            };
        };
        let (at, own) = (crank.mesh.nodes[node as usize], stresses[node as usize]);
        FilletPeak {
            name: corner.name.clone(),
            von_mises: Some(value(&node)),
            principal: own.stress.dominant(),
            jump: own.jump / value(&node).max(f64::MIN_POSITIVE),
            at,
            angle: (at[1] - corner.centre.y).atan2(at[0] - corner.centre.x),
        }
    };
    let peaks = crank.corners.iter().map(peak).collect();
    CrankCase { solution, largest_displacement, peaks, stresses }
}
