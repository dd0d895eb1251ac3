//! A submodel: one bay of a solved crankshaft again, on a finer mesh of its own.
//!
//! ```text
//! u = u_whole on both cuts        f = the loads of its pins, its centrifugal field, and what the supports exert on its journals' surfaces
//! ```
//! The cuts lie in the middle of main journals, where a fillet has faded: what its finer mesh changes there is told
//! ([`SubmodelCase::cut_difference`]).

use crate::FlexError;
use crate::case::StaticCase;
use crate::crank_case::{
    BearingSurfaces, CrankCase, CrankLoad, CrankSupport, PinLoad, crank_support, evaluate, load_pins,
};
use crate::crank_mesh::{CUTS, CrankMesh};
use crate::mesh::PlaceInMesh;
use crate::sparse::SolveEstimate;
use crate::statics::{SolveOptions, StaticSystem};
use serde::Serialize;

/// A crankshaft that was solved as a whole.
#[derive(Debug, Clone, Copy)]
pub struct SolvedCrank<'a> {
    /// Its mesh.
    pub crank: &'a CrankMesh,
    /// What held it.
    pub support: &'a CrankSupport,
    /// What loaded it.
    pub loads: &'a [CrankLoad],
    /// What came of each load.
    pub cases: &'a [CrankCase],
}

/// A case of a submodel.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SubmodelCase {
    /// Displacements and peaks within the bay.
    pub result: CrankCase,
    /// Largest difference of the von Mises stress between both meshes on the cuts, over the largest stress of a fillet of the bay: small where the
    /// cuts are far enough from what the finer mesh changes.
    pub cut_difference: f64,
}

/// Solves a bay of a crankshaft with the displacements of the whole on its cuts; `watch` sees what the factor will cost before it is made.
///
/// # Errors
/// As [`check_cut`]; [`FlexError::Cut`] where a cut does not lie in the mesh of the whole; else as [`StaticSystem::new`].
pub fn solve_submodel(
    whole: SolvedCrank<'_>,
    bay: &CrankMesh,
    options: SolveOptions,
    watch: &dyn Fn(&SolveEstimate),
) -> Result<Vec<SubmodelCase>, FlexError> {
    check_cut(whole.support)?;
    let places = cut_places(whole.crank, bay)?;
    let (surfaces, own_surfaces) = (BearingSurfaces::new(whole.crank), BearingSurfaces::new(bay));
    let cases: Vec<StaticCase> = whole
        .loads
        .iter()
        .zip(whole.cases)
        .map(|(load, solved)| {
            let base = StaticCase { name: "submodel".to_owned(), ..load.turning() };
            let moved = places.iter().fold(base, |case, (node, place)| {
                (0..3).fold(case, |case, axis| {
                    let value = place.value(|node| solved.solution.displacements[node as usize][axis]);
                    case.hold(&[*node], axis as u8, value)
                })
            });
            let held = support_forces(whole, load, solved, [&surfaces, &own_surfaces], moved)?;
            let is_own = |pin: &PinLoad| own_surfaces.areas(&format!("PIN_{}", pin.pin)).is_ok();
            let pins = load.pins.iter().copied().filter(is_own).collect();
            load_pins(&bay.mesh, &own_surfaces, held, &CrankLoad { pins, ..load.clone() })
        })
        .collect::<Result<_, FlexError>>()?;
    // The system needs masses where any case turns.
    let Some(base) = cases.iter().max_by_key(|case| case.turns()) else {
        return Ok(Vec::new());
    };
    let mut system = StaticSystem::new_watched(&bay.mesh, base, options, watch)?;
    let solutions = system.solve_moved(&cases.iter().collect::<Vec<_>>())?;
    let found = solutions.into_iter().zip(whole.cases).map(|(solution, solved)| {
        let result = evaluate(bay, solution);
        let largest = result.peaks.iter().filter_map(|peak| peak.stress).map(|stress| stress.von_mises);
        let largest = largest.fold(f64::MIN_POSITIVE, f64::max);
        let off = places.iter().map(|(node, place)| {
            let before = place.value(|node| solved.stresses[node as usize].stress.von_mises());
            (result.stresses[*node as usize].stress.von_mises() - before).abs()
        });
        SubmodelCase { cut_difference: off.fold(0.0, f64::max) / largest, result }
    });
    Ok(found.collect())
}

/// Refuses what holds a crankshaft so that no bay can be cut out of it.
///
/// # Errors
/// [`FlexError::Nonlinear`] for rings, whose pressures are not known to the bay; [`FlexError::Cut`] for a free crankshaft.
pub fn check_cut(support: &CrankSupport) -> Result<(), FlexError> {
    match support {
        CrankSupport::Rings { .. } | CrankSupport::Films => Err(FlexError::Nonlinear),
        CrankSupport::Free => Err(FlexError::Cut {
            what: "a crankshaft without supports is balanced by its inertia as a whole",
        }),
        _ => Ok(()),
    }
}

/// Nodes of both cuts with their places in the whole.
fn cut_places(whole: &CrankMesh, bay: &CrankMesh) -> Result<Vec<(u32, PlaceInMesh)>, FlexError> {
    let mut found = Vec::new();
    for cut in CUTS {
        let nodes = &bay.mesh.set(cut)?.nodes;
        let Some(first) = nodes.first() else { continue };
        let z = bay.mesh.nodes[*first as usize][2];
        let crosses = |index: &usize| {
            let heights =
                whole.mesh.elements[*index].nodes.iter().map(|node| whole.mesh.nodes[*node as usize][2]);
            let (low, high) =
                heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), z| (a.min(z), b.max(z)));
            (low - 1e-9..=high + 1e-9).contains(&z)
        };
        let elements: Vec<usize> = (0..whole.mesh.elements.len()).filter(crosses).collect();
        for node in nodes {
            let at = bay.mesh.nodes[*node as usize];
            let place = PlaceInMesh::find(&whole.mesh, &elements, at)
                .ok_or(FlexError::Cut { what: "a cut of the submodel leaves the mesh of the crankshaft" })?;
            found.push((*node, place));
        }
    }
    Ok(found)
}

/// Adds to a case of the bay what the springs of the whole exert on its journals' surfaces: each its share by area.
fn support_forces(
    whole: SolvedCrank<'_>,
    load: &CrankLoad,
    solved: &CrankCase,
    [surfaces, own]: [&BearingSurfaces; 2],
    case: StaticCase,
) -> Result<StaticCase, FlexError> {
    let support = crank_support(whole.crank, surfaces, whole.support, load.turn)?;
    let springs = support.springs.iter().zip(&solved.solution.spring_forces);
    springs.into_iter().try_fold(case, |case, (spring, force)| {
        let journal = spring.name.split(' ').next().unwrap_or_default();
        let Ok(areas) = own.signed(journal) else { return Ok(case) };
        let all: f64 = surfaces.signed(journal)?.values().map(|area| area.size).sum();
        // Weights of a mean along a direction add up to that direction.
        let along = spring.nodes.iter().fold([0.0; 3], |sum: [f64; 3], (_, weight)| {
            std::array::from_fn(|axis| sum[axis] + weight[axis])
        });
        let weights: Vec<(u32, f64)> = areas.iter().map(|(node, area)| (*node, area.size / all)).collect();
        Ok(case.push(&weights, along.map(|n| n * force)))
    })
}
