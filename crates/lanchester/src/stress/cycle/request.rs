//! What is asked of the flexible crankshaft over the cycle.

use crate::stress::mesh::StressMesh;
use lanchester_flex::train::{BasisOptions, CycleOptions};
use lanchester_report::{CycleLaw, CycleSpeed};

/// What to compute.
#[derive(Debug, Clone, PartialEq)]
pub struct CycleRequest {
    /// Which crankshaft, how fine.
    pub mesh: StressMesh,
    /// Laws of the bearings, side by side.
    pub laws: Vec<CycleLaw>,
    /// Whether every law is run with a rigid crankshaft too.
    pub rigid_crank: bool,
    /// Mean speed of crankshaft 1 [rad/s]; `None`: the highest of the engine.
    pub speed: Option<f64>,
    /// How the flywheel turns.
    pub motion: CycleSpeed,
    /// Whether the gas of the file acts.
    pub gas: bool,
    /// Modes and damping of the crankshaft.
    pub basis: BasisOptions,
    /// Instants of a revolution, a multiple of 8.
    pub instants: usize,
    /// Most cycles before an envelope is told.
    pub most_cycles: usize,
}

impl Default for CycleRequest {
    /// The four laws side by side at the highest speed, constant, every degree.
    fn default() -> CycleRequest {
        CycleRequest {
            mesh: StressMesh::default(),
            laws: CycleLaw::FOUR.to_vec(),
            rigid_crank: false,
            speed: None,
            motion: CycleSpeed::Constant,
            gas: true,
            basis: BasisOptions::default(),
            instants: 360,
            most_cycles: CycleOptions::default().most_cycles,
        }
    }
}
