//! What is asked of the flexible crankshaft over the cycle.

use crate::stress::mesh::StressMesh;
use lanchester_flex::train::{BasisOptions, CycleOptions};
use lanchester_model::Engine;
use lanchester_report::{CycleLaw, CycleSpeed, FatigueFactors};

/// What to compute.
#[derive(Debug, Clone, PartialEq)]
pub struct CycleRequest {
    /// Which crankshaft, how fine.
    pub mesh: StressMesh,
    /// Laws of the bearings, side by side.
    pub laws: Vec<CycleLaw>,
    /// Whether every law is run with a rigid crankshaft too.
    pub rigid_crank: bool,
    /// Whether films feel how the journals tilt: Guembel's, solved at every instant.
    pub tilt: bool,
    /// Mean speed of crankshaft 1 [rad/s]; `None`: the highest of the engine.
    pub speed: Option<f64>,
    /// How the flywheel turns.
    pub motion: CycleSpeed,
    /// Whether the gas of the file acts.
    pub gas: bool,
    /// Modes of the crankshaft; their damping is `damping`.
    pub basis: BasisOptions,
    /// Damping of every mode as a share of critical damping; `None`: that of `[crank.material]`, 1 % where it gives none.
    pub damping: Option<f64>,
    /// Instants of a revolution, a multiple of 8.
    pub instants: usize,
    /// Most cycles before an envelope is told.
    pub most_cycles: usize,
    /// What lowers the fatigue limits of polished specimens.
    pub factors: FatigueFactors,
}

impl Default for CycleRequest {
    /// The four laws side by side at the highest speed, constant, every degree.
    fn default() -> CycleRequest {
        CycleRequest {
            mesh: StressMesh::default(),
            laws: CycleLaw::FOUR.to_vec(),
            rigid_crank: false,
            tilt: false,
            speed: None,
            motion: CycleSpeed::Constant,
            gas: true,
            basis: BasisOptions::default(),
            damping: None,
            instants: 360,
            most_cycles: CycleOptions::default().most_cycles,
            factors: FatigueFactors::default(),
        }
    }
}

/// Damping of every mode as a share of critical damping, and where it is from: what is asked, else what the material of the crankshaft says, else
/// [`BasisOptions`]. A loss factor `eta` is at the frequency of a mode twice that share.
pub(super) fn damping(request: &CycleRequest, engine: &Engine) -> (f64, &'static str) {
    let material = engine.crank_material.as_ref();
    let ratio = material.and_then(|material| material.damping_ratio);
    let loss = material.and_then(|material| material.loss_factor);
    match (request.damping, ratio, loss) {
        (Some(asked), ..) => (asked, "as asked"),
        (None, Some(ratio), _) => (ratio, "`damping_ratio` of the file"),
        (None, None, Some(loss)) => (0.5 * loss, "half the `loss_factor` of the file"),
        (None, None, None) => (request.basis.damping, "assumed"),
    }
}
