//! Where a programme judges loads that a higher speed need not raise: forces at mounts on springs at speeds, loads of main bearings
//! with gas at places, of the engine without what the task takes over.
//!
//! ```text
//! F_j(theta, W; x) = F0_j(theta, W) + (W / W_0)^2 SUM over variables of x_v C_jv(theta)
//! ```
//! `F0` has the gas in it and is no short sum of orders: a peak is judged at places (bearing, speed, angle), a statistic over
//! the cycle at speeds. The devices turn with few orders `C`: of `F0` a root mean square needs these orders and the
//! mean square of the rest, which no device changes (Parseval).

use crate::over_speed::gas::GasRoll;
use lanchester_mechanism::MainForces;
use num_complex::Complex64;
use std::f64::consts::TAU;
use std::rc::Rc;

/// Where loads are judged over speed.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct SpeedPlaces {
    /// Speeds of forces at mounts on springs.
    pub mounts: Vec<MountPlace>,
    /// Period of the gas that these count [revolutions of crankshaft 1]; 0 without.
    pub revolutions: u32,
    /// Highest order of that gas.
    pub highest_order: u32,
    /// Places of peaks of main bearings with gas.
    pub peaks: Vec<GasPeak>,
    /// Speeds of their statistics over the cycle.
    pub cycles: Vec<GasCycle>,
}

/// A speed at which forces at mounts on springs are judged.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct MountPlace {
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// What the force is multiplied by.
    pub weight: f64,
    /// What the gas does to the block, where that counts.
    pub gas: Rc<GasRoll>,
}

/// A load at one place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct GasPeak {
    /// Main bearing, from 0.
    pub main: usize,
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// What the load is multiplied by.
    pub weight: f64,
    /// Angle of crankshaft 1 [rad].
    pub theta: f64,
    /// `F0_x + i F0_y` [N].
    pub force: Complex64,
}

/// Loads over the cycle at one speed.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct GasCycle {
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// What the load is multiplied by.
    pub weight: f64,
    /// Angles of crankshaft 1 over one period [rad] with their weights in a mean.
    pub nodes: Vec<(f64, f64)>,
    /// `F0` of every main bearing at the angles [N].
    pub mains: Vec<Vec<Complex64>>,
}

impl GasCycle {
    pub fn of(forces: &MainForces, weight: f64) -> GasCycle {
        let nodes = forces.nodes();
        let mains = (0..forces.count()).map(|main| forces.at_nodes(main, &nodes)).collect();
        GasCycle { speed: forces.speed(), weight, nodes, mains }
    }
}

impl SpeedPlaces {
    /// Adds a place of a peak that is not yet known; `period` of the engine [rad].
    pub fn add_peak(&mut self, peak: GasPeak, period: f64) {
        if self.peaks.iter().all(|known| !known.is(&peak, period)) {
            self.peaks.push(peak);
        }
    }

    /// Adds a speed of statistics that is not yet known.
    pub fn add_cycle(&mut self, cycle: GasCycle) {
        if self.cycles.iter().all(|known| known.speed != cycle.speed) {
            self.cycles.push(cycle);
        }
    }
}

impl GasPeak {
    /// Whether another place is this one.
    pub fn is(&self, other: &GasPeak, period: f64) -> bool {
        let apart = (self.theta - other.theta).rem_euclid(period);
        self.main == other.main && self.speed == other.speed && apart.min(period - apart) < 1e-9 * TAU
    }
}
