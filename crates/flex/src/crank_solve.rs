//! Static cases of a crankshaft solved, whatever holds it.

use crate::FlexError;
use crate::crank_case::{CrankCase, CrankLoad, CrankSupport, crank_cases, evaluate};
use crate::crank_mesh::CrankMesh;
use crate::crank_rings::{RingsOf, solve_on_rings};
use crate::sparse::SolveEstimate;
use crate::statics::{SolveOptions, StaticSystem};

/// Solves a crankshaft with one support under several loads.
///
/// # Errors
/// As [`crank_cases`] and [`StaticSystem::new`].
pub fn solve_crank(
    crank: &CrankMesh,
    support: CrankSupport,
    loads: &[CrankLoad],
    options: SolveOptions,
) -> Result<Vec<CrankCase>, FlexError> {
    solve_crank_watched(crank, support, loads, options, &|_| {})
}

/// The same; `watch` sees what the factor will cost before it is made.
///
/// # Errors
/// As [`solve_crank`].
pub fn solve_crank_watched(
    crank: &CrankMesh,
    support: CrankSupport,
    loads: &[CrankLoad],
    options: SolveOptions,
    watch: &dyn Fn(&SolveEstimate),
) -> Result<Vec<CrankCase>, FlexError> {
    if let CrankSupport::Rings { thickness, modulus } = support {
        return solve_on_rings(crank, RingsOf { thickness, modulus }, loads, options, watch);
    }
    let cases = crank_cases(crank, support, loads)?;
    // The system needs masses where any case turns.
    let Some(base) = cases.iter().max_by(|a, b| a.speed.abs().total_cmp(&b.speed.abs())) else {
        return Ok(Vec::new());
    };
    let mut system = StaticSystem::new_watched(&crank.mesh, base, options, watch)?;
    let solutions = system.solve(&cases.iter().collect::<Vec<_>>())?;
    Ok(solutions.into_iter().map(|solution| evaluate(crank, solution)).collect())
}
