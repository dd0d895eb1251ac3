//! Conditions C and D: the block on its mounts, the linear response of the closed form against the simulated motion.
//!
//! The linear model of `mounts` lets a block of constant inertia swing under the loads that it would feel at rest. It counts
//!
//! ```text
//! (1) SUM rho J w Omega x z       gyroscopic couple of the rotors
//! (2) I_zz - SUM rho J            the drive turns the rotors on while the block rolls: their polar inertia does not follow it
//! ```
//! and leaves out that pistons, rods and unbalances move within the block: what that changes goes with the moving mass, and halves with it. With gas the mean
//! torque is taken by a load on the block, so that it does not lean; the loads of the gas do not halve with the masses, so that no ratio is held.

use crate::crosscheck::orders::order_of;
use crate::crosscheck::pair::{CrossCheckError, Pair};
use crate::inertias::{rotating_bodies, rotor_inertia};
use crate::pressure::simulated::GivenGas;
use lanchester_mechanism::{
    GasTrain, Lever, MountSystem, inertia_excitations, merged_orders, rotor_inertia_about_z,
};
use lanchester_model::{Block, Engine, EngineParts, MovingParts};
use lanchester_multibody::{BlockMotion, GasPressure, Load, LoadLaw, Motion, ReactsOn, Simulation, Train};
use lanchester_report::{CrossRow, CrossVerdict};
use nalgebra::{Rotation3, Vector3};
use num_complex::Complex64;

/// Orders of the comparison: beyond, a block on its mounts hardly moves.
const ORDERS: u32 = 12;

/// Share by which the ratio of what is left may be off 2.
const RATIO: f64 = 0.02;

/// Below this share nothing is left that could be halved.
const NOTHING: f64 = 1e-8;

/// Orders below this share of the largest are not listed.
const LISTED: f64 = 1e-3;

/// Motion of the block's centre [m] and rotation [rad], one amplitude an order.
type Orders = Vec<(f64, [Complex64; 6])>;

/// Kinds of motion: name, unit, first component.
const KINDS: [(&str, &str, usize); 2] =
    [("translation of the block's centre", "m", 0), ("rotation of the block", "rad", 3)];

/// Why neither C nor D applies, if they do not.
fn cannot_move(pair: &Pair<'_>) -> Option<String> {
    if let Some(reason) = &pair.train.fixed_because {
        return Some(reason.clone());
    }
    let mount = pair.train.mounts.iter().find(|mount| mount.frequency_dependent)?;
    let reason = "has a loss factor or a table over frequency, which has no exact form in time";
    Some(format!("mount `{}` {reason}", mount.name))
}

/// Rows of condition C, or why it does not apply.
pub(crate) fn moving_block(pair: &Pair<'_>) -> Result<Result<Vec<CrossRow>, String>, CrossCheckError> {
    if let Some(reason) = cannot_move(pair) {
        return Ok(Err(reason));
    }
    let Some(whole) = with_whole_block(pair.engine) else {
        return Ok(Err("its mounts leave a motion free".into()));
    };
    let (Some(found), Some(plain), Some(both)) = (
        simulated(pair, &whole, Run::Imposed)?,
        linear(pair, &whole, false, false)?,
        linear(pair, &whole, true, false)?,
    ) else {
        return Ok(Err("no periodic motion was found".into()));
    };
    let half = halved(&whole);
    let (Some(half_found), Some(half_both)) =
        (simulated(pair, &half, Run::Imposed)?, linear(pair, &half, true, false)?)
    else {
        return Ok(Err("no periodic motion was found with half the moving mass".into()));
    };
    let mut rows = motion_rows("", &both, &found, |_, _| "moving masses".into());
    let (left, half_left) = (off(&both, &found), off(&half_both, &half_found));
    rows.push(CrossRow {
        quantity: "motion, largest difference; without what the rotors do in the closed form".into(),
        unit: "share".into(),
        order: None,
        closed_form: Some(off(&plain, &found)),
        bond_graph: None,
        multibody: left,
        difference: left,
        scale: 1.0,
        bar: None,
        verdict: CrossVerdict::DiffersAsItMust,
        reason: Some("the first number is without the gyroscopic couple and the roll of the rotors, the second with them".into()),
    });
    if left > NOTHING {
        let ratio = left / half_left;
        let values = [2.0, ratio, (ratio - 2.0).abs(), 2.0];
        let name = "what is left, over that of half the moving mass";
        rows.push(CrossRow::held(name, "1", None, values, RATIO));
    }
    if pair.gas.is_some()
        && let (Some(found), Some(both)) =
            (simulated(pair, &whole, Run::ImposedWithGas)?, linear(pair, &whole, true, true)?)
    {
        rows.extend(motion_rows(", with gas", &both, &found, |_, _| "moving masses".into()));
    }
    Ok(Ok(rows))
}

/// Rows of condition D, or why it does not apply.
pub(crate) fn all_free(pair: &Pair<'_>) -> Result<Result<Vec<CrossRow>, String>, CrossCheckError> {
    if let Some(reason) = cannot_move(pair) {
        return Ok(Err(reason));
    }
    if pair.gas.is_none() {
        return Ok(Err("the file has no [gas] that could drive the engine".into()));
    }
    if let Some(rotor) = pair.train.rotors.first().filter(|rotor| !rotor.known) {
        return Ok(Err(format!("the moment of inertia of {} is not known", rotor.name)));
    }
    let Some(whole) = with_whole_block(pair.engine) else {
        return Ok(Err("its mounts leave a motion free".into()));
    };
    let (Some(free), Some(imposed), Some(both)) = (
        simulated(pair, &whole, Run::Free)?,
        simulated(pair, &whole, Run::ImposedWithGas)?,
        linear(pair, &whole, true, true)?,
    ) else {
        return Ok(Err("no periodic motion was found".into()));
    };
    // The part of C, and what is left: the free speed.
    Ok(Ok(motion_rows(", by the linear response", &both, &free, |index, from| {
        let size = |a: &[Complex64; 6], b: &[Complex64; 6]| {
            (from..from + 3).map(|k| (a[k] - b[k]).norm_sqr()).sum::<f64>().sqrt()
        };
        let scale = largest(&free, from);
        let masses = size(&imposed[index].1, &both[index].1) / scale;
        let speed = size(&free[index].1, &imposed[index].1) / scale;
        format!("moving masses {masses:.1e} (C), free speed {speed:.1e} (B)")
    })))
}

/// Largest amplitude of three components over all orders.
fn largest(orders: &Orders, from: usize) -> f64 {
    let size =
        |motion: &[Complex64; 6]| motion[from..from + 3].iter().map(|c| c.norm_sqr()).sum::<f64>().sqrt();
    orders.iter().map(|(_, motion)| size(motion)).fold(f64::MIN_POSITIVE, f64::max)
}

/// Rows of every order of two motions that is not small; `reason` of an order by its place and first component.
fn motion_rows(
    what: &str,
    closed: &Orders,
    found: &Orders,
    reason: impl Fn(usize, usize) -> String,
) -> Vec<CrossRow> {
    let mut rows = Vec::new();
    for (name, unit, from) in KINDS {
        let size =
            |motion: &[Complex64; 6]| motion[from..from + 3].iter().map(|c| c.norm_sqr()).sum::<f64>().sqrt();
        let scale = largest(found, from);
        for (index, ((order, ours), (_, theirs))) in found.iter().zip(closed).enumerate() {
            if size(ours).max(size(theirs)) < LISTED * scale {
                continue;
            }
            rows.push(CrossRow {
                quantity: format!("{name}{what}"),
                unit: unit.into(),
                order: Some(*order),
                closed_form: Some(size(theirs)),
                bond_graph: None,
                multibody: size(ours),
                difference: size(&std::array::from_fn(|k| ours[k] - theirs[k])),
                scale,
                bar: None,
                verdict: CrossVerdict::DiffersAsItMust,
                reason: Some(reason(index, from)),
            });
        }
    }
    rows
}

/// Largest difference of two motions, translations over the largest translation and rotations over the largest rotation.
fn off(a: &Orders, b: &Orders) -> f64 {
    let largest = |from: usize| {
        let sizes = b.iter().flat_map(|(_, motion)| motion[from..from + 3].iter().map(|c| c.norm()));
        sizes.fold(f64::MIN_POSITIVE, f64::max)
    };
    let scales = [largest(0), largest(3)];
    let pairs = a
        .iter()
        .zip(b)
        .flat_map(|((_, a), (_, b))| (0..6).map(move |k| (a[k] - b[k]).norm() / scales[k / 3]));
    pairs.fold(0.0, f64::max)
}

/// The engine with the numbers of its whole body in `[block]`; `None` where its mounts do not hold it.
fn with_whole_block(engine: &Engine) -> Option<Engine> {
    let system = MountSystem::new(engine).ok()?;
    let (body, block) = (system.body(), engine.block.as_ref()?);
    let inertia = body.inertia;
    let block = Block {
        mass: body.mass,
        centre: body.centre,
        inertia: [inertia[0][0], inertia[1][1], inertia[2][2]],
        products: [-inertia[0][1], -inertia[1][2], -inertia[2][0]],
        moving_parts: MovingParts::Included,
        ..block.clone()
    };
    engine.with(|parts| parts.block = Some(block)).ok()
}

/// Half the mass of everything that moves in the block.
fn halved(engine: &Engine) -> Engine {
    let halve = |parts: &mut EngineParts| {
        for cylinder in &mut parts.cylinders {
            cylinder.piston_mass *= 0.5;
            cylinder.rod.big_end_mass *= 0.5;
            cylinder.rod.small_end_mass *= 0.5;
            cylinder.rod.inertia = cylinder.rod.inertia.map(|inertia| 0.5 * inertia);
        }
        parts.throws.iter_mut().for_each(|throw| throw.unbalance *= 0.5);
        let of_shafts = parts.shafts.iter_mut().flat_map(|shaft| &mut shaft.weights);
        let of_shafts = of_shafts.map(|weight| &mut weight.unbalance);
        let of_crank = parts.counterweights.iter_mut().map(|weight| &mut weight.unbalance);
        of_shafts.chain(of_crank).for_each(|unbalance| *unbalance *= 0.5);
    };
    engine.with(halve).expect("invariant: half of a mass is a mass")
}

/// What is simulated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Run {
    /// Imposed speed, inertia alone.
    Imposed,
    /// Imposed speed, gas.
    ImposedWithGas,
    /// Free speed, gas.
    Free,
}

/// The periodic motion of the simulation by order; `None` where there is none.
fn simulated(pair: &Pair<'_>, engine: &Engine, run: Run) -> Result<Option<Orders>, CrossCheckError> {
    let train = Train::new(engine, &rotor_inertia(engine))?;
    let mut simulation = match run {
        Run::Free => Simulation::free(pair.speed, 1.0),
        _ => Simulation::imposed(pair.speed, 1.0),
    };
    simulation.block = BlockMotion::Mounts;
    let given = pair.gas.filter(|_| run != Run::Imposed).map(GivenGas::new);
    if let (Some(gas), Some(_)) = (pair.gas, &given) {
        let mean = GasTrain::new(engine, gas, Lever::Exact)?.mean_torques().iter().sum::<f64>();
        if mean <= 0.0 && run == Run::Free {
            return Ok(None);
        }
        // Dampers of the mounts take power from a free engine: a load that falls with the speed leaves it a speed near the one wanted.
        let law = match run {
            Run::Free => LoadLaw::Viscous { torque: mean, at: pair.speed },
            _ => LoadLaw::Constant(mean),
        };
        simulation.load = Load { law, reacts_on: ReactsOn::Block };
    }
    let found = train.periodic(&simulation, given.as_ref().map(|given| given as &dyn GasPressure))?;
    let Some(block) = engine.block.as_ref().filter(|_| found.residual < 1e-8) else { return Ok(None) };
    let centre = Vector3::from(block.centre);
    let samples = &found.run.samples;
    let at = |k: usize| {
        let (position, orientation) = (samples.position[k].into(), samples.orientation[k]);
        let rotation = Motion { position, orientation, ..Motion::fixed(0.0, 0.0) }.rotation();
        let moved = position + rotation * centre - centre;
        let turn = Rotation3::from_matrix_unchecked(rotation).scaled_axis();
        [moved.x, moved.y, moved.z, turn.x, turn.y, turn.z]
    };
    let count = samples.theta.len() - 1;
    let traces: Vec<[f64; 6]> = (0..count).map(at).collect();
    let turns = f64::from(train.revolutions);
    let orders = (1..=ORDERS * train.revolutions).map(|k| {
        let order = f64::from(k) / turns;
        (order, std::array::from_fn(|c| 2.0 * order_of(traces.iter().map(|at| at[c]), count, turns, order)))
    });
    Ok(Some(orders.collect()))
}

/// The response of `mounts` by order, with what the rotors do and with gas where asked for; `None` where there is none.
fn linear(
    pair: &Pair<'_>,
    engine: &Engine,
    rotors: bool,
    with_gas: bool,
) -> Result<Option<Orders>, CrossCheckError> {
    let (Ok(system), Ok(mut excitations)) =
        (MountSystem::new(engine), inertia_excitations(engine, &[pair.speed], ORDERS))
    else {
        return Ok(None);
    };
    if let (Some(gas), true, Some(excitation)) = (pair.gas, with_gas, excitations.first_mut()) {
        let gas = GasTrain::new(engine, gas, Lever::Exact)?.orders(ORDERS);
        excitation.orders = merged_orders(&excitation.orders, &gas);
    }
    let about_z = rotor_inertia_about_z(&rotating_bodies(engine));
    let system = system.with_rotors(if rotors { about_z } else { 0.0 });
    let Ok(response) = system.response(&excitations) else { return Ok(None) };
    let all = |k: u32| {
        let order = f64::from(k) / f64::from(pair.train.revolutions);
        let own = response.speeds[0].orders.iter().find(|own| (own.order - order).abs() < 1e-9);
        (order, own.map_or([Complex64::ZERO; 6], |own| own.motion))
    };
    Ok(Some((1..=ORDERS * pair.train.revolutions).map(all).collect()))
}
