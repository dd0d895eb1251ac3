//! Condition C: the block on its mounts at imposed speed, linear response against the simulated motion.
//!
//! The linear model of `mounts` lets a block of constant inertia swing under the loads that it would feel at rest. The simulated motion differs by three causes:
//!
//! ```text
//! (1) SUM rho J w Omega x z       gyroscopic couple of the rotors
//! (2) I_zz - SUM rho J            the drive turns the rotors on while the block rolls: their polar inertia does not follow it
//! (3)                             pistons, rods and unbalances move within the block
//! ```
//! With (1) and (2) in the linear model too, what is left goes with the moving mass: halved, it halves. Inertia loads alone are compared: the mean torque of
//! gas would lean the block, which a linear model about the place of the file leaves out.

use crate::crosscheck::{CrossCheckError, Pair, rotor_inertia};
use crate::crosscheck_orders::order_of;
use lanchester_mechanism::{MountSystem, OrderLoads, inertia_excitations};
use lanchester_model::{Block, Engine, EngineParts, MountSpring, MovingParts};
use lanchester_multibody::{BlockMotion, Motion, Simulation, Train};
use lanchester_report::{CrossRow, CrossVerdict};
use nalgebra::{Matrix6, Rotation3, Vector3, Vector6};
use num_complex::Complex64;

/// Orders of the comparison: beyond, a block on its mounts hardly moves.
const ORDERS: u32 = 12;

/// Share by which the ratio of what is left may be off 2.
const RATIO: f64 = 0.02;

/// Below this share nothing is left that could be halved.
const NOTHING: f64 = 1e-8;

/// Motion of the block's centre [m] and rotation [rad], one amplitude an order.
type Orders = Vec<(f64, [Complex64; 6])>;

/// Rows of condition C, or why it does not apply.
pub(crate) fn moving_block(pair: &Pair<'_>) -> Result<Result<Vec<CrossRow>, String>, CrossCheckError> {
    if let Some(reason) = &pair.train.fixed_because {
        return Ok(Err(reason.clone()));
    }
    if let Some(mount) = pair.train.mounts.iter().find(|mount| mount.frequency_dependent) {
        let reason = "has a loss factor or a table over frequency, which has no exact form in time";
        return Ok(Err(format!("mount `{}` {reason}", mount.name)));
    }
    let Some(whole) = with_whole_block(pair.engine) else {
        return Ok(Err("its mounts leave a motion free".into()));
    };
    let (Some(found), Some(plain), Some(both)) =
        (simulated(pair, &whole)?, linear(pair, &whole, false)?, linear(pair, &whole, true)?)
    else {
        return Ok(Err("no periodic motion was found".into()));
    };
    let half = halved(&whole);
    let (Some(half_found), Some(half_both)) = (simulated(pair, &half)?, linear(pair, &half, true)?) else {
        return Ok(Err("no periodic motion was found with half the moving mass".into()));
    };
    let mut rows = Vec::new();
    for (place, (name, unit)) in [("translation", "m"), ("rotation", "rad")].into_iter().enumerate() {
        let size = |motion: &[Complex64; 6]| {
            motion[3 * place..3 * place + 3].iter().map(|c| c.norm_sqr()).sum::<f64>().sqrt()
        };
        let scale = found.iter().map(|(_, motion)| size(motion)).fold(f64::MIN_POSITIVE, f64::max);
        for ((order, ours), (_, theirs)) in found.iter().zip(&plain) {
            let difference = size(&std::array::from_fn(|k| ours[k] - theirs[k]));
            if size(ours).max(size(theirs)) < 1e-3 * scale {
                continue;
            }
            rows.push(CrossRow {
                quantity: format!("{name} of the block's centre"),
                unit: unit.into(),
                order: Some(*order),
                closed_form: Some(size(theirs)),
                bond_graph: None,
                multibody: size(ours),
                difference,
                scale,
                bar: None,
                verdict: CrossVerdict::DiffersAsItMust,
                reason: Some("gyroscopic couple of the rotors, roll of their inertia, moving masses".into()),
            });
        }
    }
    let (left, half_left) = (off(&both, &found), off(&half_both, &half_found));
    let without = off(&plain, &found);
    rows.push(CrossRow {
        quantity: "motion, with the rotors' gyroscopic couple and inertia in the linear model".into(),
        unit: "share".into(),
        order: None,
        closed_form: Some(without),
        bond_graph: None,
        multibody: left,
        difference: left,
        scale: 1.0,
        bar: None,
        verdict: CrossVerdict::DiffersAsItMust,
        reason: Some("moving masses: the first number is the difference without these two causes".into()),
    });
    if left > NOTHING {
        let ratio = left / half_left;
        let values = [2.0, ratio, (ratio - 2.0).abs(), 2.0];
        rows.push(CrossRow::held(
            "what is left, over that of half the moving mass",
            "1",
            None,
            values,
            RATIO,
        ));
    }
    Ok(Ok(rows))
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

/// The periodic motion of the simulation by order; `None` where there is none.
fn simulated(pair: &Pair<'_>, engine: &Engine) -> Result<Option<Orders>, CrossCheckError> {
    let train = Train::new(engine, &rotor_inertia(engine))?;
    let simulation = Simulation { block: BlockMotion::Mounts, ..Simulation::imposed(pair.speed, 1.0) };
    let found = train.periodic(&simulation, None)?;
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

/// The linear response by order, with the rotors' two causes where asked for; `None` where a mount has no spring.
fn linear(pair: &Pair<'_>, engine: &Engine, rotors: bool) -> Result<Option<Orders>, CrossCheckError> {
    let Some(block) = &engine.block else { return Ok(None) };
    let train = Train::new(engine, &rotor_inertia(engine))?;
    let Ok(excitations) = inertia_excitations(engine, &[pair.speed], ORDERS) else { return Ok(None) };
    let loads: Vec<OrderLoads> = excitations.into_iter().flat_map(|excitation| excitation.orders).collect();
    let mut mass = Matrix6::zeros();
    let tensor = block.tensor();
    for i in 0..3 {
        mass[(i, i)] = block.mass;
        for j in 0..3 {
            mass[(3 + i, 3 + j)] = tensor[i][j];
        }
    }
    let (mut stiffness, mut damping) = (Matrix6::zeros(), Matrix6::zeros());
    if rotors {
        let turning: f64 = train.rotors.iter().map(|rotor| rotor.ratio * rotor.inertia).sum();
        mass[(5, 5)] -= turning;
        damping[(3, 4)] += turning * pair.speed;
        damping[(4, 3)] -= turning * pair.speed;
    }
    let springs: Vec<(&lanchester_model::Mount, &MountSpring)> =
        engine.mounts.iter().filter_map(|mount| Some((mount, mount.spring.as_ref()?))).collect();
    let centre = Vector3::from(block.centre);
    for (mount, spring) in springs {
        let from_centre = Vector3::new(mount.x, mount.y, mount.z) - centre;
        for (k, axis) in spring.axes.iter().enumerate() {
            let axis = Vector3::from(*axis);
            let turn = from_centre.cross(&axis);
            let along = Vector6::new(axis.x, axis.y, axis.z, turn.x, turn.y, turn.z);
            stiffness += spring.stiffness[k] * along * along.transpose();
            damping += spring.damping[k] * along * along.transpose();
        }
    }
    let response = |k: u32| {
        let order = f64::from(k) / f64::from(train.revolutions);
        let own = loads.iter().find(|loads| (loads.order - order).abs() < 1e-9);
        let w = order * pair.speed;
        let matrix = Matrix6::from_fn(|a, b| {
            Complex64::new(stiffness[(a, b)] - w * w * mass[(a, b)], w * damping[(a, b)])
        });
        let load = own.map_or(Vector6::zeros(), |loads| about(loads, centre));
        let motion =
            matrix.lu().solve(&load).unwrap_or_else(|| Vector6::from_element(Complex64::new(f64::NAN, 0.0)));
        (order, std::array::from_fn(|c| motion[c]))
    };
    Ok(Some((1..=ORDERS * train.revolutions).map(response).collect()))
}

/// Force and moment about `centre` as complex amplitudes.
fn about(loads: &OrderLoads, centre: Vector3<f64>) -> Vector6<Complex64> {
    let parts = |forward: Complex64, backward: Complex64| {
        let back = backward.conj();
        [forward + back, -Complex64::I * (forward - back)]
    };
    let [x, y] = parts(loads.force_forward, loads.force_backward);
    let [mx, my] = parts(loads.couple_forward, loads.couple_backward);
    let roll = loads.roll_moment - centre.x * y + centre.y * x;
    Vector6::new(x, y, Complex64::ZERO, mx + centre.z * y, my - centre.z * x, roll)
}
