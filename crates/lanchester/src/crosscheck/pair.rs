//! One engine in both computations: what to compare, and why nothing can be.

use crate::pressure::error::GasError;
use lanchester_bondgraph::EngineGraphError;
use lanchester_mechanism::{CylinderGas, LoadError, TorqueError};
use lanchester_model::{Engine, SimulationInput};
use lanchester_multibody::{
    Guidance, Instant, MapDerivative, Motion, MultibodyError, Reactions, RotorShares, Train,
};
use lanchester_report::Condition;
use nalgebra::Vector3;
use num_complex::Complex64;
use std::cell::RefCell;

/// What to compare.
#[derive(Debug, Clone, PartialEq)]
pub struct CrossCheckRequest {
    /// Speed of crankshaft 1 [rad/s]; `None`: the highest of the engine.
    pub speed: Option<f64>,
    /// Conditions; empty: all but E, which meshes the crankshaft.
    pub conditions: Vec<Condition>,
    /// Highest order listed.
    pub max_order: u32,
    /// Bar of condition A; `None`: 1e-10.
    pub bar: Option<f64>,
    /// What the file says of a run in time: its torques over the angle count in condition B.
    pub simulation: Option<Box<SimulationInput>>,
}

impl Default for CrossCheckRequest {
    fn default() -> Self {
        CrossCheckRequest { speed: None, conditions: Vec::new(), max_order: 4, bar: None, simulation: None }
    }
}

/// Why nothing can be compared.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CrossCheckError {
    /// The pressures.
    #[error(transparent)]
    Gas(#[from] GasError),
    /// The closed form.
    #[error(transparent)]
    Loads(#[from] LoadError),
    /// The closed form with gas.
    #[error(transparent)]
    Torque(#[from] TorqueError),
    /// The simulation.
    #[error(transparent)]
    Multibody(#[from] MultibodyError),
    /// The bond graph.
    #[error(transparent)]
    BondGraph(#[from] EngineGraphError),
}

/// One engine in both computations.
pub(crate) struct Pair<'a> {
    pub engine: &'a Engine,
    pub speed: f64,
    pub gas: Option<&'a [CylinderGas]>,
    pub train: Train,
    pub request: &'a CrossCheckRequest,
    /// Derivative of the map of a period on mounts, from one run to the next.
    pub derivative: RefCell<MapDerivative>,
}

/// Force, couple, roll moment on the block and shaft torque, as complex numbers.
pub(crate) type Loads = [Complex64; 4];

/// How far beside a jump its two sides are looked at [rad]: above the rounding of an angle, below what changes a load.
const BESIDE: f64 = 1e-12;

/// What the simulation says of the block and the shaft at `theta`, speed imposed, block fixed; and of every joint.
pub(crate) fn loads_at(pair: &Pair<'_>, theta: f64, shares: &[RotorShares]) -> (Loads, Reactions) {
    loads_of(pair.reactions(theta, shares))
}

/// The same where a pressure jumps at `theta`, on both sides of the jump: which of them counts at that angle is a matter of rounding. None elsewhere.
pub(crate) fn loads_beside_jump(
    pair: &Pair<'_>,
    theta: f64,
    shares: &[RotorShares],
) -> Vec<(Loads, Reactions)> {
    let [before, after] = [-BESIDE, BESIDE].map(|shift| pair.gas_forces(theta, shift));
    let jumps = before.iter().zip(&after).any(|(a, b)| (a - b).abs() > 1e-9 * a.abs().max(b.abs()));
    if !jumps {
        return Vec::new();
    }
    [before, after].map(|forces| loads_of(pair.reactions_under(theta, &forces, shares))).into()
}

fn loads_of(all: Reactions) -> (Loads, Reactions) {
    let [x, y, _] = all.on_block.force;
    let [mx, my, mz] = all.on_block.moment;
    let real = |value: f64| Complex64::new(value, 0.0);
    ([Complex64::new(x, y), Complex64::new(mx, my), real(mz), real(all.shaft_torque)], all)
}

impl Pair<'_> {
    /// Reactions of the simulation at `theta`, speed imposed, block fixed.
    pub(crate) fn reactions(&self, theta: f64, shares: &[RotorShares]) -> Reactions {
        self.reactions_under(theta, &self.gas_forces(theta, 0.0), shares)
    }

    /// Gas forces of the cylinders [N] at `theta`, their own angles shifted [rad].
    fn gas_forces(&self, theta: f64, shift: f64) -> Vec<f64> {
        (0..self.train.cylinders.len()).map(|index| self.shifted_gas_force(index, theta, shift)).collect()
    }

    /// Gas force of a cylinder [N] at `theta`.
    pub(crate) fn gas_force(&self, index: usize, theta: f64) -> f64 {
        self.shifted_gas_force(index, theta, 0.0)
    }

    fn shifted_gas_force(&self, index: usize, theta: f64, shift: f64) -> f64 {
        let own = self.train.own_angle(index, theta) + shift;
        let area = self.train.cylinders[index].area.unwrap_or(0.0);
        self.gas.map_or(0.0, |gas| area * (gas[index].cylinder.at(own) - gas[index].crankcase.at(own)))
    }

    fn reactions_under(&self, theta: f64, forces: &[f64], shares: &[RotorShares]) -> Reactions {
        let motion = Motion::fixed(theta, self.speed);
        let mut places = Vec::new();
        self.train.places_into(theta, &mut places);
        let instant = Instant {
            motion: &motion,
            places: &places,
            rates: [0.0; 7],
            gas: forces,
            gravity: Vector3::zeros(),
            piston_damping: 0.0,
            guidance: Guidance::Crankpin,
        };
        self.train.reactions(&instant, shares)
    }
}
