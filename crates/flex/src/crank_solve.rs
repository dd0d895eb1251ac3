//! Static cases of a crankshaft solved, whatever holds it.

use crate::FlexError;
use crate::case::StaticCase;
use crate::crank_case::{CrankCase, CrankLoad, CrankSupport, crank_cases, evaluate};
use crate::crank_films::solve_in_films;
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
    support: &CrankSupport,
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
    support: &CrankSupport,
    loads: &[CrankLoad],
    options: SolveOptions,
    watch: &dyn Fn(&SolveEstimate),
) -> Result<Vec<CrankCase>, FlexError> {
    if let CrankSupport::Rings { thickness, modulus } = *support {
        return solve_on_rings(crank, RingsOf { thickness, modulus }, loads, options, watch);
    }
    if *support == CrankSupport::Films {
        return solve_in_films(crank, loads, options, watch);
    }
    let cases = crank_cases(crank, support, loads)?;
    let mut found: Vec<Option<CrankCase>> = loads.iter().map(|_| None).collect();
    // Loads that the support holds the same way have one factor.
    while let Some(first) = found.iter().position(Option::is_none) {
        let is_same = |k: &usize| !support.depends_on_angle() || loads[*k].turn == loads[first].turn;
        let own: Vec<usize> = (0..loads.len()).filter(is_same).collect();
        let own_cases: Vec<&StaticCase> = own.iter().map(|k| &cases[*k]).collect();
        // The system needs masses where any case turns.
        let turning = own_cases.iter().max_by_key(|case| case.turns());
        let Some(base) = turning else { break };
        let mut system = StaticSystem::new_watched(&crank.mesh, base, options, watch)?;
        for (place, solution) in own.iter().zip(system.solve(&own_cases)?) {
            found[*place] = Some(evaluate(crank, solution));
        }
    }
    Ok(found.into_iter().flatten().collect())
}
