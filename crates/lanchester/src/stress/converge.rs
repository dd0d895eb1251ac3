//! Stress and modes on three meshes, extrapolated.

use crate::pressure::measured::TraceFile;
use crate::stress::mesh::StressMesh;
use crate::stress::request::{ModesRequest, StaticRequest, StressError, StressStage};
use crate::stress::run::{crank_modes, static_stress};
use lanchester_flex::crank_mesh::CrankMeshOptions;
use lanchester_flex::richardson::richardson;
use lanchester_report::{
    ConvergedNumber, Convergence, ConvergenceMesh, CrankModes, CrankSheet, StaticStress,
};

/// The size asked for over those of the three meshes.
const REFINED: [f64; 3] = [1.0, 1.4, 2.0];

/// Meshes of sizes h, h/1.4, h/2; elements across a fillet n, about 1.4 n, 2 n, even and each more than before.
fn meshes(mesh: &StressMesh) -> Result<[StressMesh; 3], StressError> {
    if let Some(own) = &mesh.own {
        return Err(StressError::OneMesh { name: own.name.clone() });
    }
    let first = mesh.options.fillet_elements;
    let even = |factor: f64| 2 * (first as f64 * factor / 2.0).round() as usize;
    let second = even(REFINED[1]).max(first + 2);
    let counts = [first, second, even(REFINED[2]).max(second + 2)];
    Ok(std::array::from_fn(|k| {
        let size = mesh.options.size / REFINED[k];
        let options = CrankMeshOptions { size, fillet_elements: counts[k], ..mesh.options };
        StressMesh { options, ..mesh.clone() }.held()
    }))
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
    engine: &lanchester_model::Engine,
    traces: &[TraceFile],
    request: &StaticRequest,
    watch: &dyn Fn(StressStage),
) -> Result<StaticStress, StressError> {
    let own = meshes(&request.mesh)?;
    let solve = |mesh: &StressMesh| -> Result<StaticStress, StressError> {
        let asked = StaticRequest { mesh: mesh.clone(), ..request.clone() };
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
    for (k, corner) in found[2].sheet.crank.corners.iter().enumerate() {
        let peak = |stress: &StaticStress| {
            let peaks = stress.cases.iter().filter_map(|case| case.result.peaks.get(k)?.stress);
            peaks.map(|peak| peak.von_mises).reduce(f64::max)
        };
        let values = [0, 1, 2].map(|mesh: usize| peak(&found[mesh]));
        numbers.extend(converged(format!("{}: von Mises", corner.name), "MPa", 1e6, fillets, values));
    }
    let meshes = [0, 1, 2].map(|mesh: usize| sheet_of(&found[mesh].sheet, found[mesh].solve.unknowns));
    let [_, _, mut finest] = found;
    finest.convergence = Some(Convergence { meshes, numbers });
    Ok(finest)
}

/// Natural modes on three meshes: those of the finest, with a convergence study of their frequencies.
///
/// # Errors
/// As [`crank_modes`].
pub fn converged_modes(
    engine: &lanchester_model::Engine,
    request: &ModesRequest,
    watch: &dyn Fn(StressStage),
) -> Result<CrankModes, StressError> {
    let own = meshes(&request.mesh)?;
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
    finest.convergence = Some(Convergence { meshes, numbers });
    Ok(finest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn meshes_of_a_study_become_finer() {
        for fillet_elements in [2, 4, 6, 8] {
            let options = CrankMeshOptions { fillet_elements, ..CrankMeshOptions::default() };
            let mesh = StressMesh { options, ..StressMesh::default() };
            let counts = meshes(&mesh).expect("it is ours").map(|mesh| mesh.options.fillet_elements);
            assert!(
                counts[0] == fillet_elements && counts[1] > counts[0] && counts[2] > counts[1],
                "{counts:?}"
            );
            assert!(counts.iter().all(|count| count % 2 == 0), "{counts:?}");
        }
    }
}
