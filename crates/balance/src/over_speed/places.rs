//! Where a programme judges loads that a higher speed need not raise: forces at mounts on springs at speeds, loads of main bearings
//! with gas at places, of the engine without what the task takes over.
//!
//! ```text
//! F_j(theta, W; x) = F0_j(theta, W) + (W / W_0)^2 SUM over variables of x_v C_jv(theta)
//! ```
//! `F0` has the gas in it and is no short sum of orders: a peak is judged at places (bearing, speed, angle), a statistic over
//! the cycle at speeds. The devices turn with few orders `C`: of `F0` a root mean square needs these orders and the
//! mean square of the rest, which no device changes (Parseval).

use crate::convex::curve::Member;
use crate::convex::dense::Matrix;
use crate::operator::Operator;
use crate::over_speed::gas::GasRoll;
use crate::wave::Wave;
use lanchester_mechanism::MainForces;
use num_complex::Complex64;
use std::collections::BTreeSet;
use std::f64::consts::{SQRT_2, TAU};
use std::rc::Rc;

/// Key of what no device changes: above every order.
const REST: u32 = u32::MAX;

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
    nodes: Vec<(f64, f64)>,
    /// `F0` of every main bearing at the angles [N].
    mains: Vec<Vec<Complex64>>,
}

impl GasCycle {
    pub fn of(forces: &MainForces, weight: f64) -> GasCycle {
        let nodes = forces.nodes();
        let mains = (0..forces.count()).map(|main| forces.at_nodes(main, &nodes)).collect();
        GasCycle { speed: forces.speed(), weight, nodes, mains }
    }

    /// The load of a main bearing as waves whose root mean square over the cycle is its own.
    pub fn waves(&self, operator: &Operator, main: usize) -> [Wave; 2] {
        let own = &operator.mains[main];
        let growth = self.weight * (self.speed / operator.speed).powi(2);
        let keys: BTreeSet<u32> = own.iter().flat_map(|wave| wave.parts.iter().map(|part| part.1)).collect();
        let loads = &self.mains[main];
        let mut rest: f64 = self.nodes.iter().zip(loads).map(|(node, load)| node.1 * load.norm_sqr()).sum();
        let mut waves: [Wave; 2] = std::array::from_fn(|m| Wave {
            parts: own[m].parts.iter().map(|&(v, key, part)| (v, key, part.map(|p| growth * p))).collect(),
            ..Wave::default()
        });
        for key in keys {
            let order = f64::from(key) / f64::from(operator.grid.revolutions);
            let twice = if key == 0 { 1.0 } else { 2.0 };
            let mut sums = [[0.0; 2]; 2];
            for ((theta, weight), load) in self.nodes.iter().zip(loads) {
                let (sin, cos) = (order * theta).sin_cos();
                let share = twice * weight;
                for (sum, part) in sums.iter_mut().zip([load.re, load.im]) {
                    *sum = [sum[0] + share * part * cos, sum[1] + share * part * sin];
                }
            }
            for (wave, [cos, sin]) in waves.iter_mut().zip(sums) {
                wave.add_base(key, self.weight * cos, self.weight * sin);
                rest -= if key == 0 { 1.0 } else { 0.5 } * (cos * cos + sin * sin);
            }
        }
        waves[0].add_base(REST, SQRT_2 * self.weight * rest.max(0.0).sqrt(), 0.0);
        waves
    }

    /// The load of a main bearing at every angle, one vector each, with its weight in the mean over the cycle.
    pub fn vectors(&self, operator: &Operator, main: usize) -> Vec<(f64, Member)> {
        let nodes = self.nodes.iter().zip(&self.mains[main]);
        nodes
            .map(|((theta, weight), force)| {
                (*weight, vector(operator, main, [self.speed, self.weight], *theta, *force))
            })
            .collect()
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
    /// The load at this place.
    pub fn vector(&self, operator: &Operator) -> Member {
        vector(operator, self.main, [self.speed, self.weight], self.theta, self.force)
    }

    /// Whether another place is this one.
    pub fn is(&self, other: &GasPeak, period: f64) -> bool {
        let apart = (self.theta - other.theta).rem_euclid(period);
        self.main == other.main && self.speed == other.speed && apart.min(period - apart) < 1e-9 * TAU
    }
}

/// `F0 + (W / W_0)^2 C x` at one angle, times its weight, measured against the natural force.
fn vector(
    operator: &Operator,
    main: usize,
    [speed, weight]: [f64; 2],
    theta: f64,
    force: Complex64,
) -> Member {
    let unit = weight / operator.natural_force;
    let growth = unit * (speed / operator.speed).powi(2);
    let phi = theta / f64::from(operator.grid.revolutions);
    let mut columns = Matrix::zeros(2, operator.variables);
    for (row, wave) in operator.mains[main].iter().enumerate() {
        for &(variable, key, [cos, sin]) in &wave.parts {
            let (s, c) = (f64::from(key) * phi).sin_cos();
            columns[(row, variable)] += growth * (cos * c + sin * s);
        }
    }
    Member::Vector { base: vec![unit * force.re, unit * force.im], columns }
}
