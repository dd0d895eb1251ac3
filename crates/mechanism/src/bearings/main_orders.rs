//! Inertia loads of main bearings by order: rods' forces on the crankpin and what turns, shared out throw by throw.
//!
//! ```text
//! F_j(theta) = SUM over rods of share_j R(theta) + e^{i ratio theta} SUM over what turns of share_j U W^2 e^{i angle}    (26.6)
//! ```
//! `R` is smooth and periodic in the angle of its crankshaft: its orders are sampled until two samplings agree to rounding
//! ([`crate::sampling`]), for as many orders as have anything left.

use crate::bearings::beam::{Beam, BeamModel};
use crate::bearings::rod_force::RodForce;
use crate::inertia::internal::turning_loads;
use crate::inertia::request::{LoadError, LoadRequest};
use crate::train::mechanism::{Mechanism, linkage, master_of};
use crate::train::sampling::sampled_orders;
use lanchester_model::{Engine, Ratio};
use num_complex::Complex64;
use std::collections::BTreeMap;

/// Orders above the last one that counts are below this share of the largest.
const TAIL: f64 = 1e-14;

/// Orders of a crankshaft to begin with, and the most.
const FIRST: usize = 24;
const MOST: usize = 1000;

/// What cancels is rounding below this share of its parts, and of the parts of the largest order.
const CANCELS: [f64; 2] = [1e-13, 1e-15];

/// Inertia load of a main bearing by order.
#[derive(Debug, Clone, PartialEq)]
pub struct MainOrders {
    /// Crankshaft, from 0.
    pub crankshaft: usize,
    /// Its plane [m].
    pub z: f64,
    /// Rising orders.
    pub orders: Vec<MainOrder>,
}

/// One order of a main-bearing load: `F_x = Re(x e^{i order theta})`, `F_y` likewise [N]; journal on bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MainOrder {
    /// Harmonic of the crankshaft: the order is this times the amount of the crankshaft's ratio.
    pub harmonic: u32,
    /// Along x.
    pub x: Complex64,
    /// Along y.
    pub y: Complex64,
}

/// A sum of forces with the amounts of its parts.
#[derive(Debug, Clone, Copy, Default)]
struct Sum {
    force: [Complex64; 2],
    parts: [f64; 2],
}

impl Sum {
    fn add(&mut self, force: [Complex64; 2]) {
        for m in 0..2 {
            self.force[m] += force[m];
            self.parts[m] += force[m].norm();
        }
    }
}

/// Loads of all main bearings in the order of [`Engine::main_bearings`], inertia alone, from the request's speed and motion.
///
/// # Errors
/// [`LoadError`] where the request is impossible or the engine is not valid.
pub fn main_orders(engine: &Engine, request: &LoadRequest) -> Result<Vec<MainOrders>, LoadError> {
    let mechanism = Mechanism::new(engine, request)?;
    let mut result = Vec::new();
    for crankshaft in 0..engine.crankshafts.len() {
        let Some(beam) = Beam::new(&engine.main_planes(crankshaft), BeamModel::ThrowByThrow) else {
            continue;
        };
        let mut sums: Vec<BTreeMap<u32, Sum>> = vec![BTreeMap::new(); beam.mains().len()];
        let mut add = |z: f64, harmonic: u32, force: [Complex64; 2]| {
            for (main, share) in beam.shares(z) {
                sums[main].entry(harmonic).or_default().add(force.map(|f| share * f));
            }
        };
        let ratio = engine.crankshafts[crankshaft].ratio;
        let sense = f64::from(ratio.numerator().signum());
        for (z, force) in turning_loads(engine, crankshaft, mechanism.speed) {
            // F e^{i sense psi}, psi the amount of the shaft's angle.
            add(
                z,
                1,
                [Complex64::new(force.re, sense * force.im), Complex64::new(force.im, -sense * force.re)],
            );
        }
        for (index, cylinder) in engine.cylinders.iter().enumerate() {
            if engine.throws[cylinder.throw].crankshaft != crankshaft {
                continue;
            }
            let master = &engine.cylinders[master_of(cylinder).unwrap_or(index)];
            let rod = RodForce::new(mechanism.pistons[index].clone(), linkage(engine, index)?, master.angle);
            for (harmonic, [own, with_master]) in rod_orders(&rod, ratio).into_iter().enumerate() {
                add(cylinder.z, harmonic as u32, own);
                if master_of(cylinder).is_some() {
                    add(master.z, harmonic as u32, with_master);
                }
            }
        }
        let main =
            |(&z, sums): (&f64, BTreeMap<u32, Sum>)| MainOrders { crankshaft, z, orders: cleared(sums) };
        result.extend(beam.mains().iter().zip(sums).map(main));
    }
    Ok(result)
}

/// Orders of a rod's force on its crankpin along x and y, as in [`MainOrder`], from 0 on: in its own plane, and in that of its master.
fn rod_orders(rod: &RodForce, ratio: Ratio) -> Vec<[[Complex64; 2]; 2]> {
    let rate = ratio.value().abs();
    let mut highest = FIRST;
    loop {
        let sampled = sampled_orders(highest, 0, |psi| {
            let [own, with_master] = rod.by_plane(psi / rate);
            [own.re, own.im, with_master.re, with_master.im]
        });
        let size = |one: &[Complex64; 4]| one.iter().map(|part| part.norm()).fold(0.0, f64::max);
        let largest = |orders: &[[Complex64; 4]]| orders.iter().map(size).fold(0.0, f64::max);
        if highest >= MOST || largest(&sampled[3 * highest / 4..]) <= TAIL * largest(&sampled) {
            let real = |(n, one): (usize, [Complex64; 4])| {
                let [x, y, master_x, master_y] = if n == 0 { one } else { one.map(|c| 2.0 * c) };
                [[x, y], [master_x, master_y]]
            };
            return sampled.into_iter().enumerate().map(real).collect();
        }
        highest = (2 * highest).min(MOST);
    }
}

/// The sums without what is rounding of them.
fn cleared(sums: BTreeMap<u32, Sum>) -> Vec<MainOrder> {
    let largest = sums.values().flat_map(|sum| sum.parts).fold(0.0, f64::max);
    let clear = |sum: &Sum, m: usize| {
        let rounding = CANCELS[0] * sum.parts[m] + CANCELS[1] * largest;
        if sum.force[m].norm() <= rounding { Complex64::ZERO } else { sum.force[m] }
    };
    sums.iter()
        .map(|(&harmonic, sum)| MainOrder { harmonic, x: clear(sum, 0), y: clear(sum, 1) })
        .filter(|order| order.x != Complex64::ZERO || order.y != Complex64::ZERO)
        .collect()
}
