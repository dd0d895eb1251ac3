//! A crankshaft that somebody else has meshed: a deck with sets, held against the engine.

use crate::crank_mesh::{CrankMesh, FilletPlace};
use crate::deck::read_mesh;
use crate::mesh::{Mesh, NodeSet, quality, surface, surface_areas};
use crate::{FlexError, LEAST_JACOBIAN, Material};
use lanchester_shape::Point;
use std::collections::HashSet;

/// Mass of a mesh over that of the body of the engine file, and the same turned round, beyond which its units are taken for wrong. Fillets, bores and
/// counterweights that only one of the two has stay far below.
const MASS_RATIO: f64 = 2.0;

/// How far the middle of a pin or journal may be from its place, as a share of the largest crank radius.
const MISPLACED: f64 = 0.03;

/// What the engine says of a crankshaft that its mesh must agree with.
#[derive(Debug, Clone, PartialEq)]
pub struct OwnMeshPlan {
    /// Material of elements without one of their own.
    pub material: Material,
    /// Numbers of its pins with the place of their axes across the crank, x along its first throw [m].
    pub pins: Vec<(usize, [f64; 2])>,
    /// Middles of the journals along z, from the free end on [m]; empty where the engine does not say how many there are.
    pub journals: Vec<f64>,
    /// Mass of the body [kg], where the file knows it.
    pub mass: Option<f64>,
}

/// Reads a mesh in N, mm, tonne, s, MPa: the axis along z from the free end to the flywheel, throw 1 along x, z from the reference plane.
/// Sets: `PIN_n`, `MAIN_1` .., `FLYWHEEL`; `FREE_END` where both ends are to be clamped; sets that begin with `FILLET` are fillets of their own, without
/// any the surface outside of all sets stands for them.
///
/// # Errors
/// [`FlexError::Deck`] with its line, [`FlexError::Inverted`] with the number of the element, [`FlexError::OwnMesh`] with all that does not fit.
pub fn own_mesh(text: &str, plan: &OwnMeshPlan) -> Result<CrankMesh, FlexError> {
    let deck = read_mesh(text, &plan.material)?;
    let mesh = deck.mesh;
    let quality = quality(&mesh)?;
    if quality.least_jacobian < LEAST_JACOBIAN {
        let number = deck.element_numbers.get(quality.worst_element - 1).copied().unwrap_or_default();
        return Err(FlexError::Inverted {
            element: number as usize,
            at: quality.worst_place,
            jacobian: quality.least_jacobian,
            needed: LEAST_JACOBIAN,
        });
    }
    let mut faults = Vec::new();
    let (faces, crowded) = surface(&mesh);
    if crowded > 0 {
        faults.push(format!("{crowded} faces belong to more than two elements"));
    }
    // Middle of a bearing surface; a fault where there is none.
    let middle = |name: &str, faults: &mut Vec<String>| -> Option<[f64; 3]> {
        let Some(set) = mesh.sets.iter().find(|set| set.name == name) else {
            faults.push(format!("the set {name} is missing"));
            return None;
        };
        let own: HashSet<u32> = set.nodes.iter().copied().collect();
        let whole: Vec<_> =
            faces.iter().filter(|face| face.nodes.iter().all(|node| own.contains(node))).cloned().collect();
        if set.nodes.is_empty() {
            faults.push(format!("the set {name} is empty"));
            return None;
        }
        if whole.is_empty() {
            faults.push(format!(
                "the set {name} holds no whole face of the surface, with the nodes in the middle of its edges"
            ));
            return None;
        }
        let areas = surface_areas(&mesh, &whole);
        let size = |area: &[f64; 3]| area.iter().map(|x| x * x).sum::<f64>().sqrt();
        let all: f64 = areas.values().map(size).sum();
        Some(std::array::from_fn(|k| {
            areas.iter().map(|(node, area)| size(area) * mesh.nodes[*node as usize][k]).sum::<f64>() / all
        }))
    };
    let reach = plan.pins.iter().map(|(_, at)| at[0].hypot(at[1])).fold(0.0, f64::max);
    let misplaced =
        |at: [f64; 3], wanted: [f64; 2]| (at[0] - wanted[0]).hypot(at[1] - wanted[1]) > MISPLACED * reach;
    let in_mm = |at: &[f64]| -> String {
        let each: Vec<String> = at.iter().map(|x| format!("{:.1}", 1e3 * x)).collect();
        format!("({}) mm", each.join(", "))
    };
    let needs: Vec<String> = plan
        .pins
        .iter()
        .map(|(number, _)| format!("PIN_{number}"))
        .chain((1..=plan.journals.len()).map(|number| format!("MAIN_{number}")))
        .chain(["FLYWHEEL".to_owned()])
        .collect();
    let found: Vec<Option<[f64; 3]>> = needs.iter().map(|name| middle(name, &mut faults)).collect();
    let unit_fault = plan.mass.and_then(|mass| units(quality.mass, mass));
    if let Some(fault) = unit_fault {
        // Places in wrong units are all wrong: one sentence for them.
        faults.push(fault);
    } else {
        for (k, at) in found.iter().enumerate().filter_map(|(k, at)| Some((k, (*at)?))) {
            let wanted = match plan.pins.get(k) {
                Some((_, wanted)) => *wanted,
                None => [0.0; 2],
            };
            // The flywheel's face may have any shape.
            if k + 1 < needs.len() && misplaced(at, wanted) {
                faults.push(format!(
                    "the middle of {} is at {} across the crank, by the engine file at {}",
                    needs[k],
                    in_mm(&at[..2]),
                    in_mm(&wanted)
                ));
            }
        }
        let journals = &found[plan.pins.len()..plan.pins.len() + plan.journals.len()];
        for (number, (at, plane)) in journals.iter().zip(&plan.journals).enumerate() {
            let Some(at) = at else { continue };
            if (at[2] - plane).abs() > 0.5 * reach {
                faults.push(format!(
                    "the middle of MAIN_{} is at z = {:.1} mm, by the engine file at {:.1} mm from the reference plane",
                    number + 1,
                    1e3 * at[2],
                    1e3 * plane
                ));
            }
        }
        if let (Some(Some(first)), Some(Some(end))) = (journals.first(), found.last())
            && end[2] <= first[2]
        {
            faults.push("FLYWHEEL lies before MAIN_1: z runs from the free end to the flywheel".to_owned());
        }
    }
    if !faults.is_empty() {
        return Err(FlexError::OwnMesh { faults });
    }
    let corners = corners(&mesh, &faces);
    let body_mass = plan.mass.unwrap_or(0.0);
    Ok(CrankMesh {
        mesh,
        quality,
        corners,
        webs: Vec::new(),
        weights: Vec::new(),
        body_mass,
        left_out: Vec::new(),
    })
}

/// What is wrong with the units, by the mass.
fn units(mesh: f64, body: f64) -> Option<String> {
    let ratio = mesh / body;
    if (1.0 / MASS_RATIO..=MASS_RATIO).contains(&ratio) {
        return None;
    }
    let near = |wanted: f64| (ratio / wanted).max(wanted / ratio) < MASS_RATIO;
    let guess = if near(1e-9) {
        "its lengths are in m where mm are needed"
    } else if near(1.0 / 25.4_f64.powi(3)) {
        "its lengths are in inches where mm are needed"
    } else if near(1e-3) {
        "its lengths are in cm where mm are needed"
    } else if near(1e12) || near(1e9) || near(1e3) {
        "its density is not in tonne/mm3 (steel: 7.85e-9)"
    } else {
        "its units are others than mm and tonne, or it is another crankshaft"
    };
    Some(format!("the mesh weighs {mesh:.3e} kg and the body of the engine file {body:.3} kg: {guess}"))
}

/// Sets of fillets, or the surface outside of all sets.
fn corners(mesh: &Mesh, faces: &[crate::mesh::SurfaceFace]) -> Vec<FilletPlace> {
    let outer: HashSet<u32> = faces.iter().flat_map(|face| face.nodes.iter().copied()).collect();
    let place = |name: String, nodes: Vec<u32>| {
        let mean = |k: usize| {
            nodes.iter().map(|node| mesh.nodes[*node as usize][k]).sum::<f64>() / nodes.len().max(1) as f64
        };
        FilletPlace { name, radius: 0.0, centre: Point::new(mean(0), mean(1)), bar: 0.0, nodes }
    };
    let is_fillet = |set: &&NodeSet| set.name.starts_with("FILLET") && !set.nodes.is_empty();
    let fillets: Vec<FilletPlace> = mesh
        .sets
        .iter()
        .filter(is_fillet)
        .map(|set| {
            let name = set.name.to_lowercase().replace('_', " ");
            place(name, set.nodes.iter().copied().filter(|node| outer.contains(node)).collect())
        })
        .collect();
    if !fillets.is_empty() {
        return fillets;
    }
    let is_bearing = |set: &&NodeSet| {
        ["PIN_", "MAIN_"].iter().any(|word| set.name.starts_with(word))
            || ["FLYWHEEL", "FREE_END"].contains(&set.name.as_str())
    };
    let taken: HashSet<u32> =
        mesh.sets.iter().filter(is_bearing).flat_map(|set| set.nodes.iter().copied()).collect();
    let mut nodes: Vec<u32> = outer.difference(&taken).copied().collect();
    nodes.sort_unstable();
    vec![place("surface outside of the sets".to_owned(), nodes)]
}
