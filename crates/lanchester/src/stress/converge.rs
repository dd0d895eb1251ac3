//! Stress and modes on three meshes, extrapolated.

use crate::pressure::measured::TraceFile;
use crate::stress::mesh::{MOST_NODES, StressMesh};
use crate::stress::request::{ModesRequest, StaticRequest, StressError, StressStage};
use crate::stress::run::{crank_modes, static_stress};
use lanchester_flex::FlexError;
use lanchester_flex::crank_mesh::{CrankMeshOptions, crank_mesh};
use lanchester_flex::richardson::richardson;
use lanchester_model::Engine;
use lanchester_report::{
    ConvergedNumber, Convergence, ConvergenceMesh, CrankModes, CrankSheet, MeshOrigin, StaticStress,
};

/// The size asked for over those of the three meshes.
const REFINED: [f64; 3] = [1.0, 1.4, 2.0];
/// Elements across a fillet of the finest of three meshes, at least: 2 and 4 have the others.
const LEAST_FINEST: usize = 6;

/// The meshes of a study, and what is to be said of them.
pub(crate) struct Study {
    pub(crate) meshes: [StressMesh; 3],
    pub(crate) note: Option<String>,
}

impl Study {
    /// Meshes of sizes h, h/1.4, h/2; elements across a fillet n, about 1.4 n, 2 n, even and each more than before. Where nobody says how many,
    /// they are the largest three even numbers up to these of which the finest mesh has no more than [`MOST_NODES`]; where 2, 4 and 6 are too many,
    /// all meshes have one number and differ in the size of their elements alone. Where nobody says the size, the finest mesh has the usual one.
    pub(crate) fn of(engine: &Engine, mesh: &StressMesh) -> Result<Study, StressError> {
        if let Some(own) = &mesh.own {
            return Err(StressError::OneMesh { name: own.name.clone() });
        }
        let first = mesh.options.fillet_elements;
        let even = |factor: f64| 2 * (first as f64 * factor / 2.0).round() as usize;
        let second = even(REFINED[1]).max(first + 2);
        let most = even(REFINED[2]).max(second + 2);
        if mesh.origins.fillet_elements != MeshOrigin::Usual || !mesh.options.fillets {
            return Ok(Study {
                meshes: of_counts(mesh, mesh.options.size, [first, second, most]),
                note: None,
            });
        }
        let coarse = match mesh.origins.size {
            MeshOrigin::Usual => mesh.options.size * REFINED[2],
            _ => mesh.options.size,
        };
        // Nodes of the finest mesh with so many elements across a fillet; none where its elements are not sound.
        let nodes = |count: usize| {
            let size = coarse / REFINED[2];
            let options = CrankMeshOptions { size, fillet_elements: count, ..mesh.options };
            match crank_mesh(engine, mesh.crankshaft, options) {
                Ok(found) => Ok(Some(found.mesh.nodes.len())),
                Err(FlexError::Crowded { .. }) => Ok(None),
                Err(error) => Err(StressError::from(error)),
            }
        };
        let mut three: Option<(usize, usize)> = None;
        for count in (LEAST_FINEST..=most).step_by(2) {
            match nodes(count)? {
                Some(nodes) if nodes <= MOST_NODES => three = Some((count, nodes)),
                _ => break,
            }
        }
        if let Some((count, nodes)) = three {
            let counts = [count - 4, count - 2, count];
            let note = format!(
                "These meshes have {}, {} and {} elements across the fillets; the finest mesh has {nodes} nodes. These are the most that an \
                 ordinary computer solves in minutes ({MOST_NODES} nodes, no more than {most} elements); other numbers can be asked for.",
                counts[0], counts[1], counts[2]
            );
            return Ok(Study { meshes: of_counts(mesh, coarse, counts), note: Some(note) });
        }
        let fits = |nodes: Option<usize>| nodes.is_some_and(|nodes| nodes <= MOST_NODES);
        let count = if fits(nodes(4)?) { 4 } else { 2 };
        let note = format!(
            "All three meshes have {count} elements across the fillets, since 2, 4 and 6 would take more than {MOST_NODES} \
             nodes, which an ordinary computer solves in minutes: what they say of displacement, energy and frequencies holds, and stresses of fillets \
             are coarse and have no band; 2, 4 and 6 can be asked for."
        );
        let meshes = of_counts(mesh, coarse, [count; 3]).map(|mut own| {
            if count < first {
                own.origins.fillet_elements = MeshOrigin::Fitted;
            }
            own
        });
        Ok(Study { meshes, note: Some(note) })
    }
}

/// Three meshes, of which the first has this size of elements, with so many across a fillet each.
fn of_counts(mesh: &StressMesh, size: f64, counts: [usize; 3]) -> [StressMesh; 3] {
    std::array::from_fn(|k| {
        let options =
            CrankMeshOptions { size: size / REFINED[k], fillet_elements: counts[k], ..mesh.options };
        StressMesh { options, ..mesh.clone() }.held()
    })
}

fn sheet_of(sheet: &CrankSheet, unknowns: usize) -> ConvergenceMesh {
    ConvergenceMesh {
        size: sheet.options.size,
        fillet_elements: sheet.options.fillet_elements,
        nodes: sheet.crank.quality.nodes,
        unknowns,
    }
}

/// A number on the three meshes; `None` where it has no value on one.
fn converged(
    name: String,
    unit: &str,
    scale: f64,
    sizes: [f64; 3],
    values: [Option<f64>; 3],
) -> Option<ConvergedNumber> {
    let [Some(a), Some(b), Some(c)] = values else { return None };
    Some(ConvergedNumber { name, unit: unit.to_owned(), scale, found: richardson(sizes, [a, b, c]) })
}

/// Static stress on three meshes: that of the finest, with a convergence study of displacement, energy and the largest stress of every
/// fillet over all cases.
///
/// # Errors
/// As [`static_stress`].
pub fn converged_stress(
    engine: &Engine,
    traces: &[TraceFile],
    request: &StaticRequest,
    watch: &dyn Fn(StressStage),
) -> Result<StaticStress, StressError> {
    let Study { meshes: own, note } = Study::of(engine, &request.mesh)?;
    let solve = |mesh: &StressMesh| -> Result<StaticStress, StressError> {
        // A submodel is one of the finest mesh.
        let submodel = request.submodel.filter(|_| *mesh == own[2]);
        let asked = StaticRequest { mesh: mesh.clone(), submodel, ..request.clone() };
        let mut found = static_stress(engine, traces, &asked, watch)?;
        if *mesh != own[2] {
            // Fields of the coarser meshes are not needed any more.
            for case in &mut found.cases {
                case.result.stresses = Vec::new();
                case.result.solution.displacements = Vec::new();
                case.result.solution.reactions = Vec::new();
            }
        }
        Ok(found)
    };
    let found = [solve(&own[0])?, solve(&own[1])?, solve(&own[2])?];
    let sizes = own.each_ref().map(|mesh| mesh.options.size);
    let fillets = own.each_ref().map(|mesh| 1.0 / mesh.options.fillet_elements as f64);
    let mut numbers = Vec::new();
    for k in 0..found[2].cases.len() {
        let of = |value: &dyn Fn(&lanchester_report::StressCase) -> f64| {
            [0, 1, 2].map(|mesh: usize| found[mesh].cases.get(k).map(value))
        };
        let name = |what: &str| format!("case {}: {what}", k + 1);
        let moved = of(&|case| case.result.largest_displacement);
        numbers.extend(converged(name("largest displacement"), "mm", 1e-3, sizes, moved));
        numbers.extend(converged(name("energy"), "J", 1.0, sizes, of(&|case| case.energy)));
    }
    let is_finer = own[0].options.fillet_elements < own[2].options.fillet_elements;
    for (k, corner) in found[2].sheet.crank.corners.iter().enumerate().filter(|_| is_finer) {
        let peak = |stress: &StaticStress| {
            let peaks = stress.cases.iter().filter_map(|case| case.result.peaks.get(k)?.stress);
            peaks.map(|peak| peak.von_mises).reduce(f64::max)
        };
        let values = [0, 1, 2].map(|mesh: usize| peak(&found[mesh]));
        numbers.extend(converged(format!("{}: von Mises", corner.name), "MPa", 1e6, fillets, values));
    }
    let meshes = [0, 1, 2].map(|mesh: usize| sheet_of(&found[mesh].sheet, found[mesh].solve.unknowns));
    let [_, _, mut finest] = found;
    finest.convergence = Some(Convergence { meshes, numbers, note });
    Ok(finest)
}

/// Natural modes on three meshes: those of the finest, with a convergence study of their frequencies.
///
/// # Errors
/// As [`crank_modes`].
pub fn converged_modes(
    engine: &Engine,
    request: &ModesRequest,
    watch: &dyn Fn(StressStage),
) -> Result<CrankModes, StressError> {
    let Study { meshes: own, note } = Study::of(engine, &request.mesh)?;
    let solve = |mesh: &StressMesh| {
        crank_modes(engine, &ModesRequest { mesh: mesh.clone(), ..request.clone() }, watch)
    };
    let found = [solve(&own[0])?, solve(&own[1])?, solve(&own[2])?];
    let sizes = own.each_ref().map(|mesh| mesh.options.size);
    let count = found.iter().map(|found| found.modes.modes.len()).min().unwrap_or(0);
    let number = |k: usize| {
        let values = [0, 1, 2].map(|mesh: usize| Some(found[mesh].modes.modes[k].frequency));
        converged(format!("mode {}", k + 1), "Hz", 1.0, sizes, values)
    };
    let numbers = (0..count).filter_map(number).collect();
    let meshes = [0, 1, 2].map(|mesh: usize| sheet_of(&found[mesh].sheet, found[mesh].modes.unknowns));
    let [_, _, mut finest] = found;
    finest.convergence = Some(Convergence { meshes, numbers, note });
    Ok(finest)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(meshes: &[StressMesh; 3]) -> [usize; 3] {
        meshes.each_ref().map(|mesh| mesh.options.fillet_elements)
    }

    fn read(text: &str) -> Engine {
        lanchester_file::read(text).engine().expect("the file has no mistakes")
    }

    const FOUR: &str = include_str!("../../../../examples/in-line-4-crank-by-elements.toml");

    #[test]
    fn meshes_of_a_study_become_finer() {
        let engine = read(FOUR);
        for fillet_elements in [2, 4, 6, 8] {
            let mesh = StressMesh::of(None, 0, None, Some(fillet_elements), CrankMeshOptions::default());
            let study = Study::of(&engine, &mesh).expect("it is ours");
            let counts = counts(&study.meshes);
            assert!(
                counts[0] == fillet_elements && counts[1] > counts[0] && counts[2] > counts[1],
                "{counts:?}"
            );
            assert!(counts.iter().all(|count| count % 2 == 0) && study.note.is_none(), "{counts:?}");
        }
    }

    #[test]
    fn where_nobody_says_how_fine_a_study_is_what_can_be_solved() {
        let single = lanchester_file::template("single").expect("it is in the gallery");
        let completed = lanchester_file::complete(single.text, &[], None).expect("it is completed");
        let engine = read(&completed.text);
        let mesh = StressMesh::default();
        let study = Study::of(&engine, &mesh).expect("it is meshed");
        let [a, b, c] = counts(&study.meshes);
        assert!(a >= 2 && b == a + 2 && c == a + 4, "{a} {b} {c}");
        let nodes = |options| crank_mesh(&engine, 0, options).expect("it is meshed").mesh.nodes.len();
        let finest = study.meshes[2].options;
        assert!(finest.size == mesh.options.size && nodes(finest) <= MOST_NODES, "{finest:?}");
        assert!(study.note.is_some_and(|note| note.contains(&format!("{a}, {b} and {c} elements"))));
        // Eight webs with 2, 4 and 6 elements a fillet are too many.
        let study = Study::of(&read(FOUR), &mesh).expect("it is meshed");
        assert_eq!(counts(&study.meshes), [2, 2, 2]);
        let sizes = study.meshes.each_ref().map(|mesh| mesh.options.size);
        assert!(sizes[0] > sizes[1] && sizes[1] > sizes[2], "{sizes:?}");
        assert!(study.meshes.iter().all(|mesh| mesh.origins.fillet_elements == MeshOrigin::Fitted));
        assert!(study.note.is_some_and(|note| note.starts_with("All three meshes have 2 elements")));
    }
}
