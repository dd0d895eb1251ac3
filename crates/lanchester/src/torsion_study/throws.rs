//! Stiffness of throws from a mesh, for the torsional chain.

use crate::stress::{StressError, StressMesh, StressStage, throw_stiffnesses};
use lanchester_flex::crank_mesh::CrankMeshOptions;
use lanchester_flex::statics::SolveOptions;
use lanchester_model::Engine;
use lanchester_report::MeshedThrow;

/// Stiffness of the throws of all crankshafts by finite elements.
///
/// `held`: whether the chain is to have that with the middles of the journals on the axis; else the one with journals free to move aside.
///
/// # Errors
/// As [`throw_stiffnesses`].
pub fn meshed_throws(
    engine: &Engine,
    options: CrankMeshOptions,
    solve: SolveOptions,
    held: bool,
    watch: &dyn Fn(StressStage),
) -> Result<Vec<MeshedThrow>, StressError> {
    let mut found = Vec::new();
    for crankshaft in 0..engine.crankshafts.len() {
        let mesh = StressMesh { crankshaft, options, ..StressMesh::default() };
        let throws = throw_stiffnesses(engine, &mesh, solve, watch)?;
        found.extend(throws.iter().map(|own| MeshedThrow {
            throw: own.throw + 1,
            free: own.free,
            held: own.held,
            is_held: held,
        }));
    }
    Ok(found)
}
