//! Torques of an engine on the stations of its chain: of the gas from the closed form, of the moving masses from their own motion.

use super::error::EngineTorsionError;
use crate::pressure::cylinders::cylinder_gas;
use crate::pressure::measured::TraceFile;
use crate::torque_report::power_speeds;
use lanchester_mechanism::{BearingPart, BearingRequest, CylinderGas, throw_forces};
use lanchester_model::{Engine, GasSource};
use lanchester_torsion::{CrankChain, Excitation, Source, TorqueAt, orders_of, torque_orders, train_inertia};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Most revolutions after which all torques must repeat.
const MOST_REVOLUTIONS: u32 = 64;
/// Angles of a revolution at which the torque of the gas is taken.
const ANGLES: usize = 720;
/// Speeds at which the gas is computed where it depends on speed.
const GAS_SPEEDS: usize = 5;

/// Revolutions of crankshaft 1 after which the torques of all crankshafts repeat.
///
/// # Errors
/// [`EngineTorsionError::Period`].
pub fn torque_period(engine: &Engine) -> Result<u32, EngineTorsionError> {
    let strokes = engine.strokes.revolutions();
    let repeats = |turns: u32| {
        engine.crankshafts.iter().all(|crankshaft| {
            let (p, q) = (crankshaft.ratio.numerator().unsigned_abs(), crankshaft.ratio.denominator());
            (u64::from(turns) * u64::from(p)).is_multiple_of(u64::from(strokes) * u64::from(q))
        })
    };
    (1..=MOST_REVOLUTIONS)
        .find(|turns| repeats(*turns))
        .ok_or(EngineTorsionError::Period { most: MOST_REVOLUTIONS })
}

/// Whether the gas acts, and at which speed its pressures are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExcitingGas {
    /// Whether it acts.
    pub is_on: bool,
    /// Speed of the engine over the one whose pressures it has, 1 but for an engine that stands for one of another size.
    pub speed_of_original: f64,
}

/// Torques on the throws of `crank` up to the order `highest`, and where the pressures come from. Of a cycle that knows of speed the gas is computed at some speeds of
/// the range `speeds` [rad/s], which rise, and taken straight between them.
///
/// # Errors
/// No pressures, or no forces from them.
pub fn engine_excitation(
    engine: &Engine,
    traces: &[TraceFile],
    crank: &CrankChain,
    speeds: &[f64],
    highest: f64,
    gas: ExcitingGas,
) -> Result<(Excitation, Option<String>), EngineTorsionError> {
    let turns = torque_period(engine)?;
    let step = 1.0 / f64::from(turns);
    let count = ((highest / step) + 1e-9).floor().max(1.0) as usize;
    let mut sources: Vec<Source> = (0..engine.throws.len())
        .map(|throw| Source {
            station: crank.throws[throw],
            gas: Vec::new(),
            inertia: masses(engine, throw, turns, count),
        })
        .collect();
    let mut said = None;
    if gas.is_on && engine.gas.is_some() {
        let factor = gas.speed_of_original;
        let own: Vec<f64> = speeds.iter().map(|speed| speed / factor).collect();
        for own in gas_speeds(engine, &own) {
            let speed = own * factor;
            let gas = cylinder_gas(engine, traces, own)?;
            let torques = gas_torques(engine, &gas.cylinders, speed, turns)?;
            for (source, samples) in sources.iter_mut().zip(&torques) {
                let (mean, orders) = orders_of(samples, count);
                source.gas.push(TorqueAt { speed, mean, orders });
            }
            said = Some(gas.source);
        }
    }
    Ok((Excitation { step, count, sources }, said))
}

/// Speeds at which the gas is taken, rising.
fn gas_speeds(engine: &Engine, speeds: &[f64]) -> Vec<f64> {
    let (low, high) = (speeds.first().copied().unwrap_or(1.0), speeds.last().copied().unwrap_or(1.0));
    let known = power_speeds(engine, GAS_SPEEDS);
    let traced = match engine.gas.as_ref().map(|gas| &gas.source) {
        Some(GasSource::Traces { traces, .. }) => traces.iter().any(|trace| trace.speed.is_some()),
        _ => false,
    };
    let mut list: Vec<f64> = if known.is_empty() && !traced {
        vec![high]
    } else {
        known.into_iter().filter(|speed| *speed > low && *speed < high).chain([low, high]).collect()
    };
    list.sort_by(f64::total_cmp);
    list.dedup();
    list
}

/// Torque of the gas on each throw about its own axis, over `turns` revolutions of crankshaft 1 [N m].
fn gas_torques(
    engine: &Engine,
    gas: &[CylinderGas],
    speed: f64,
    turns: u32,
) -> Result<Vec<Vec<f64>>, EngineTorsionError> {
    let angles = ANGLES * turns as usize;
    let theta: Vec<f64> = (0..angles).map(|k| TAU * f64::from(turns) * k as f64 / angles as f64).collect();
    let request = BearingRequest { speed: Some(speed), part: BearingPart::Gas, ..BearingRequest::default() };
    let mut torques = vec![vec![0.0; angles]; engine.throws.len()];
    for (index, crankshaft) in engine.crankshafts.iter().enumerate() {
        let sense = crankshaft.ratio.value().signum();
        let over = throw_forces(engine, Some(gas), &request, index, &theta)?;
        for (at, forces) in over.iter().enumerate() {
            for force in forces {
                torques[force.throw][at] = sense * force.tangential * engine.throws[force.throw].radius;
            }
        }
    }
    Ok(torques)
}

/// Orders of the torque of rods and pistons of a throw about its own axis over the square of the speed of crankshaft 1.
fn masses(engine: &Engine, throw: usize, turns: u32, count: usize) -> Vec<Complex64> {
    let ratio = engine.crankshafts[engine.throws[throw].crankshaft].ratio;
    let (p, q) = (ratio.numerator().unsigned_abs() as usize, ratio.denominator() as usize);
    let value = ratio.value();
    let samples = train_inertia(engine, throw);
    // Order k of the own crankshaft is the multiple k |ratio| turns of the lowest order.
    let own_count = (count * q) / (p * turns as usize).max(1);
    let mut orders = vec![Complex64::default(); count];
    for (index, torque) in
        torque_orders(&samples, own_count.min(samples.len() / 2 - 1)).into_iter().enumerate()
    {
        let multiple = (index + 1) * p * turns as usize / q;
        let torque = torque * (value * value);
        if let Some(order) = orders.get_mut(multiple - 1) {
            *order = if value < 0.0 { torque.conj() } else { torque };
        }
    }
    orders
}
