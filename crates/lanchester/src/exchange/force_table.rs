//! Forces at mounts and main bearings by order and speed.

use crate::mounted::{MountSpeeds, MountedError, mounts};
use crate::pressure::measured::TraceFile;
use crate::torque_report::{TorqueReportError, bearing_report};
use lanchester_exchange::{ForceTable, LoadedPoint, OrderForces};
use lanchester_mechanism::{BearingLoads, BearingPart, BearingRequest};
use lanchester_model::Engine;
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};

/// Which points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LoadedPoints {
    /// Mounts and main bearings, as far as the engine has them.
    All,
    /// Its mounts.
    Mounts,
    /// Its main bearings.
    Bearings,
}

/// What to compute.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceTableRequest {
    /// Which points.
    pub points: LoadedPoints,
    /// Speeds of crankshaft 1 [rad/s].
    pub speeds: MountSpeeds,
    /// Highest order.
    pub max_order: u32,
    /// Whether the gas counts, where the file gives it.
    pub gas: bool,
    /// Number of the first point.
    pub first_id: u32,
}

/// Why there are no forces by order.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ForceTableError {
    /// The block on its mounts.
    #[error(transparent)]
    Mounts(#[from] MountedError),
    /// The main bearings.
    #[error(transparent)]
    Bearings(#[from] TorqueReportError),
    /// There is nothing to tell of.
    #[error("the engine has no main bearing whose load is known")]
    NoBearing,
    /// An order needs a range of speeds.
    #[error("forces by order over speed need two different speeds at least, got {got}")]
    OneSpeed {
        /// How many there are.
        got: usize,
    },
}

/// Angles in one revolution of crankshaft 1 from which orders of bearing loads are found.
const ANGLES: usize = 720;

/// Forces of the block on its mounts and of the journals on their bearings, by order and speed; `traces` holds the files that
/// [`crate::trace_names`] names. Mean forces are left out.
///
/// # Errors
/// [`ForceTableError`]. Of [`LoadedPoints::All`] what the engine has not is left out with a note, as long as something is left.
pub fn force_table(
    engine: &Engine,
    traces: &[TraceFile],
    request: &ForceTableRequest,
) -> Result<ForceTable, ForceTableError> {
    let mut speeds = request.speeds.of(engine);
    speeds.sort_by(f64::total_cmp);
    speeds.dedup();
    if speeds.len() < 2 {
        return Err(ForceTableError::OneSpeed { got: speeds.len() });
    }
    let mut table = ForceTable {
        title: format!("Lanchester: {}, forces by order and speed", engine.name),
        notes: Vec::new(),
        speeds: speeds.clone(),
        points: Vec::new(),
        orders: Vec::new(),
    };
    if request.points != LoadedPoints::Bearings {
        match mount_forces(engine, traces, &speeds, request) {
            Ok((mut points, orders, words)) => {
                let words = format!("force of the block on each mount, from {words}.");
                table.notes.push(format!("Mounts: {words}"));
                points.iter_mut().for_each(|point| point.words.clone_from(&words));
                add(&mut table, points, orders);
            }
            Err(error) if request.points == LoadedPoints::All => {
                table.notes.push(format!("Mounts are left out: {error}"));
            }
            Err(error) => return Err(error.into()),
        }
    }
    if request.points != LoadedPoints::Mounts {
        let part = match request.gas && engine.gas.is_some() {
            true => BearingPart::All,
            false => BearingPart::Inertia,
        };
        let at = |speed: &f64| {
            let request = BearingRequest { speed: Some(*speed), part, counterweights: true, samples: ANGLES };
            bearing_report(engine, traces, &request)
        };
        let loads = speeds.iter().map(at).collect::<Result<Vec<_>, _>>()?;
        let words = if part == BearingPart::All { "inertia and gas" } else { "inertia" };
        let mains = loads[0].mains.len();
        if mains > 0 {
            let words = format!("force of the journal on each bearing, of the block, from {words}.");
            table.notes.push(format!("Main bearings: {words}"));
            let (mut points, orders) = bearing_forces(&loads, request);
            points.iter_mut().for_each(|point| point.words.clone_from(&words));
            add(&mut table, points, orders);
        } else if table.points.is_empty() {
            return Err(ForceTableError::NoBearing);
        }
    }
    Ok(table)
}

type Found = (Vec<LoadedPoint>, Vec<OrderForces>, String);

fn mount_forces(
    engine: &Engine,
    traces: &[TraceFile],
    speeds: &[f64],
    request: &ForceTableRequest,
) -> Result<Found, MountedError> {
    let gas = (request.gas && engine.gas.is_some()).then_some(traces);
    let list = MountSpeeds::List(speeds.to_vec());
    let study = mounts(engine, &list, request.max_order, gas, &[])?;
    let points: Vec<LoadedPoint> = engine
        .mounts
        .iter()
        .enumerate()
        .map(|(k, mount)| LoadedPoint {
            id: request.first_id + k as u32,
            name: format!("mount {}", mount.name),
            position: [mount.x, mount.y, mount.z],
            words: String::new(),
        })
        .collect();
    let mut orders: Vec<f64> =
        study.response.speeds.iter().flat_map(|own| own.orders.iter().map(|own| own.order)).collect();
    orders.sort_by(f64::total_cmp);
    orders.dedup();
    let forces = |order: f64, point: usize| -> Vec<[Complex64; 3]> {
        let at = |own: &lanchester_mechanism::SpeedResponse| {
            let found = own.orders.iter().find(|own| own.order == order);
            found.map_or([Complex64::ZERO; 3], |own| own.forces[point])
        };
        study.response.speeds.iter().map(at).collect()
    };
    let orders = orders.into_iter().map(|order| OrderForces {
        order,
        forces: (0..points.len()).map(|point| forces(order, point)).collect(),
    });
    Ok((points.clone(), orders.collect(), study.excitation))
}

/// Orders of the loads of the main bearings, by the discrete Fourier transform of their trace.
///
/// ```text
/// F_n = 2/N SUM_k F(theta_k) e^{-i n theta_k}        n = 1/R, 2/R, ... with the period of R revolutions
/// ```
fn bearing_forces(
    loads: &[BearingLoads],
    request: &ForceTableRequest,
) -> (Vec<LoadedPoint>, Vec<OrderForces>) {
    let mains = &loads[0].mains;
    let several = mains.iter().any(|main| main.crankshaft > 1);
    let points: Vec<LoadedPoint> = mains
        .iter()
        .enumerate()
        .map(|(k, main)| LoadedPoint {
            id: request.first_id + 1000 + k as u32,
            name: match several {
                true => format!("main bearing {} of crankshaft {}", main.main, main.crankshaft),
                false => format!("main bearing {}", main.main),
            },
            position: [0.0, 0.0, main.z],
            words: String::new(),
        })
        .collect();
    let revolutions = (loads[0].period / TAU).round().max(1.0) as u32;
    let harmonic = |own: &BearingLoads, main: usize, order: f64| -> [Complex64; 3] {
        let load = &own.mains[main].load.load;
        let scale = 2.0 / load.len() as f64;
        let mut sums = [Complex64::ZERO; 3];
        for (theta, force) in own.theta.iter().zip(load) {
            let turn = Complex64::cis(-order * theta);
            sums[0] += scale * force.re * turn;
            sums[1] += scale * force.im * turn;
        }
        // What is no more than rounding is nothing.
        let size = load.iter().map(|force| force.norm()).fold(0.0, f64::max);
        sums.map(|sum| if sum.norm() > 1e-12 * size { sum } else { Complex64::ZERO })
    };
    let orders = (1..=request.max_order * revolutions).map(|k| {
        let order = f64::from(k) / f64::from(revolutions);
        let at = |main: usize| loads.iter().map(|own| harmonic(own, main, order)).collect();
        OrderForces { order, forces: (0..points.len()).map(at).collect() }
    });
    (points.clone(), orders.collect())
}

/// Puts points with their forces into the table: an order that only some of the points have is 0 at the others.
fn add(table: &mut ForceTable, points: Vec<LoadedPoint>, orders: Vec<OrderForces>) {
    let nothing = vec![[Complex64::ZERO; 3]; table.speeds.len()];
    let (before, count) = (table.points.len(), points.len());
    table.points.extend(points);
    for own in &mut table.orders {
        own.forces.extend(vec![nothing.clone(); count]);
    }
    for own in orders {
        match table.orders.iter_mut().find(|there| there.order == own.order) {
            Some(there) => there.forces.splice(before.., own.forces).for_each(drop),
            None => {
                let forces = [vec![nothing.clone(); before], own.forces].concat();
                table.orders.push(OrderForces { order: own.order, forces });
            }
        }
    }
    table.orders.retain(|own| own.forces.iter().flatten().flatten().any(|force| force.norm_sqr() > 0.0));
    table.orders.sort_by(|one, other| one.order.total_cmp(&other.order));
}

/// A speed in revolutions a minute, for words.
pub(crate) fn rpm(speed: f64) -> f64 {
    speed * 30.0 / PI
}
