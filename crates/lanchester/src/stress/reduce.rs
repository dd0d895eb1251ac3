//! The reduced model of a crankshaft.

use crate::stress::mesh::StressMesh;
use crate::stress::request::{StressError, StressStage};
use crate::stress::run::{check_crankshaft, sheet};
use lanchester_flex::case::StaticCase;
use lanchester_flex::modes::{ModeKind, modes_watched};
use lanchester_flex::reduction::{ReducedModel, ReductionOptions, interfaces, reduce_watched};
use lanchester_flex::statics::SolveOptions;
use lanchester_model::Engine;
use lanchester_report::{REDUCED_VERSION, ReducedCrank};

/// Free natural frequencies of the mesh that stand beside those of the reduced model.
const COMPARED: usize = 6;

/// Reduces a crankshaft to its journals, pins and the flywheel's end face; `watch` sees how far it is.
///
/// # Errors
/// As [`crate::static_stress`].
pub fn reduced_crank(
    engine: &Engine,
    mesh: &StressMesh,
    options: ReductionOptions,
    watch: &dyn Fn(StressStage),
) -> Result<ReducedCrank, StressError> {
    check_crankshaft(engine, mesh)?;
    let sheet = sheet(engine, mesh, watch)?;
    let named = |prefix: &str| -> Vec<String> {
        let sets = sheet.crank.mesh.sets.iter().map(|set| set.name.clone());
        sets.filter(|name| name.starts_with(prefix)).collect()
    };
    let sets = [named("MAIN_"), named("PIN_"), named("FLYWHEEL")].concat();
    let mut own = interfaces(&sheet.crank.mesh, &sets)?;
    // The crankshaft's own axis, not the middle of the nodes that happen to lie on the face.
    own.iter_mut().filter(|own| own.name == "FLYWHEEL").for_each(|own| own.point[..2].fill(0.0));
    let estimate = |estimate: &_| watch(StressStage::Factoring(*estimate));
    let reduction = reduce_watched(&sheet.crank.mesh, &own, options, &estimate)?;
    let model = reduction.model;
    let size = model.size();
    // All reference points along x.
    let along = |k: usize| if k < 6 * own.len() && k.is_multiple_of(6) { 1.0 } else { 0.0 };
    let mass: f64 = (0..size * size).map(|k| along(k / size) * model.mass[k] * along(k % size)).sum();
    let fewer = model.truncated(model.frequencies.len() - model.frequencies.len() / 3);
    let free = |model: &ReducedModel| -> Vec<f64> {
        model.modes().iter().skip(6).map(|mode| mode.frequency).collect()
    };
    let frequencies: Vec<[f64; 2]> =
        free(&model).into_iter().zip(free(&fewer)).map(|(all, fewer)| [all, fewer]).collect();
    // The mesh itself without supports, whose bearing surfaces bend with the crankshaft.
    let solve = SolveOptions { memory: options.memory, ..SolveOptions::default() };
    let count = frequencies.len().min(COMPARED) + 6;
    let found = modes_watched(&sheet.crank.mesh, &StaticCase::default(), count, solve, &estimate)?;
    let found = found.modes.iter().filter(|mode| mode.kind != ModeKind::Rigid);
    let of_mesh = found.map(|mode| mode.frequency).collect();
    Ok(ReducedCrank {
        version: REDUCED_VERSION,
        residual: reduction.residual,
        mass_error: mass / sheet.crank.quality.mass - 1.0,
        frequencies,
        of_mesh,
        model,
        sheet,
    })
}
