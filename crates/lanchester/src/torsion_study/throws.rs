//! Stiffness of throws from a mesh, for the torsional chain.

use crate::stress::{StressError, StressMesh, StressStage, throw_stiffnesses};
use lanchester_flex::crank_mesh::CrankMeshOptions;
use lanchester_flex::statics::SolveOptions;
use lanchester_model::Engine;

/// Throws from a mesh.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MeshedThrows {
    /// Stiffness with the index of the throw [N m/rad], as [`crate::TorsionRequest`] takes it.
    pub stiffness: Vec<(usize, f64)>,
    /// Both kinds of each throw in words.
    pub notes: Vec<String>,
}

/// Stiffness of the throws of all crankshafts by finite elements.
///
/// `held`: whether the middles of the journals stay on the axis; else they are free to move aside.
///
/// # Errors
/// As [`throw_stiffnesses`].
pub fn meshed_throws(
    engine: &Engine,
    options: CrankMeshOptions,
    solve: SolveOptions,
    held: bool,
    watch: &dyn Fn(StressStage),
) -> Result<MeshedThrows, StressError> {
    let mut found = MeshedThrows::default();
    for crankshaft in 0..engine.crankshafts.len() {
        let mesh = StressMesh { crankshaft, options, ..StressMesh::default() };
        for own in throw_stiffnesses(engine, &mesh, solve, watch)? {
            found.stiffness.push((own.throw, if held { own.held } else { own.free }));
            found.notes.push(format!(
                "throw {} by finite elements, between the middles of its journals: {:.4} MN m/rad with journals free to move aside, {:.4} MN m/rad with their middles held; taken: {}",
                own.throw + 1,
                1e-6 * own.free,
                1e-6 * own.held,
                if held { "held" } else { "free" }
            ));
        }
    }
    Ok(found)
}
