//! Conditions C and D: the block on its mounts, the linear response of the closed form against the simulated motion.
//!
//! The linear model of `mounts` lets a block of constant inertia swing under the loads that it would feel at rest. It counts
//!
//! ```text
//! (1) SUM rho J w Omega x z       gyroscopic couple of the rotors
//! (2) I_zz - SUM rho J            the drive turns the rotors on while the block rolls: their polar inertia does not follow it
//! ```
//! and leaves out that pistons, rods and unbalances move within the block (3): their part `m M_1(theta)` of the mass matrix. With `H` the response of the block
//! to a load, the motion that a load f makes is
//!
//! ```text
//! q = H f - H (m M_1 q)'' = H f - m H (M_1 H f)'' + m^2 H (M_1 H (M_1 H f)'')'' - ...
//! ```
//! so that what is left of it is `D(m) = m a + m^2 b + ...`, and `4 D(m/2) - D(m) = m a + O(m^3)` is free of the square, which counts where an order comes near a
//! natural frequency of heavy parts: where what is left does not halve, this must. The motion by the masses' own inertia goes with m itself: there D is taken for
//! each kilogram. With gas the mean torque is taken by a load on the block, so that it does not lean. The gas does not halve with the masses, and on soft mounts it
//! turns the block so far that the linear response is off by that alone (4); on stiff ones what is left is below the error of the runs. Its ratio is held for as
//! much of the gas as moves the block by [`SMALL`], and what the rest of it adds stands beside. Mounts with a loss factor or a table over frequency are Maxwell chains
//! in both: the linear response takes the complex stiffness of the chains at its orders, so that what they are off the file's is no difference here.

use crate::crosscheck::pair::{CrossCheckError, Pair};
use crate::inertias::{rotating_bodies, rotor_inertia};
use crate::pressure::simulated::GivenGas;
use crate::simulation::mount_chains::{chain_band, fit_mounts, with_chains};
use lanchester_mechanism::{
    GasTrain, Lever, MountSystem, OrderResponse, RotorEffects, inertia_excitations, merged_orders,
    rotor_inertia_about_z,
};
use lanchester_model::{Block, Engine, EngineParts, MovingParts};
use lanchester_multibody::{
    BlockMotion, GasPressure, Load, LoadLaw, Motion, MultibodyError, ReactsOn, Simulation, Train,
};
use lanchester_report::{CrossRow, CrossVerdict};
use lanchester_results::OrderLoads;
use lanchester_results::amplitude;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use num_complex::Complex64;

/// Orders of the comparison: beyond, a block on its mounts hardly moves.
const ORDERS: u32 = 12;

/// Share by which the ratio of what is left may be off 2.
const RATIO: f64 = 0.02;

/// Below this share nothing is left that could be halved.
const NOTHING: f64 = 1e-8;

/// What the ends of a periodic motion are apart at most [m, rad]: `CLOSED` of a millimetre or milliradian.
const CLOSED: f64 = 1e-13;

/// Orders below this share of the largest are not listed.
const LISTED: f64 = 1e-3;

/// Turn of the block [rad] and displacement of its centre [m] by gas that count as small: their squares are below 1e-7 of them, and a run closes to some 1e-13.
/// Both signs of the gas are simulated.
const SMALL: [f64; 2] = [1e-4, 1e-4];

/// By order: displacement of the block's centre [m], rotation [rad], and the force on every mount [N], three amplitudes each.
type Orders = Vec<(f64, Vec<Complex64>)>;

/// Kinds of quantities: name, unit, first component; forces at mounts go to the end.
const KINDS: [(&str, &str, usize); 3] = [
    ("translation of the block's centre", "m", 0),
    ("rotation of the block", "rad", 3),
    ("forces at the mounts", "N", 6),
];

/// First components of the motion's kinds.
const TURNED_OR_MOVED: [usize; 2] = [0, 3];

/// Components of a kind.
fn part(values: &[Complex64], from: usize) -> &[Complex64] {
    if from < 6 { &values[from..from + 3] } else { values.get(6..).unwrap_or_default() }
}

/// Root of the sum of the squares of some amplitudes.
fn size(values: &[Complex64]) -> f64 {
    values.iter().map(|value| value.norm_sqr()).sum::<f64>().sqrt()
}

/// Factors times orders, summed.
fn sum(terms: &[(f64, &Orders)]) -> Orders {
    let Some((_, first)) = terms.first() else { return Vec::new() };
    let all = first.iter().enumerate().map(|(index, (order, values))| {
        let of = |k: usize| terms.iter().map(|(factor, own)| *factor * own[index].1[k]).sum();
        (*order, (0..values.len()).map(of).collect())
    });
    all.collect()
}

/// Why neither C nor D applies, if they do not.
fn cannot_move(pair: &Pair<'_>) -> Option<String> {
    if let Some(reason) = &pair.train.fixed_because {
        return Some(reason.clone());
    }
    train_on_mounts(pair, pair.engine).err().map(|error| error.to_string())
}

/// The crank train of `engine`, mounts with a loss factor or a table over frequency by their chains.
fn train_on_mounts(pair: &Pair<'_>, engine: &Engine) -> Result<Train, MultibodyError> {
    let mut train = Train::new(engine, &rotor_inertia(engine))?;
    let band = chain_band(engine, &train, &[pair.speed]);
    fit_mounts(&mut train, band)?;
    Ok(train)
}

/// Rows of condition C, or why it does not apply.
pub(crate) fn moving_block(pair: &Pair<'_>) -> Result<Result<Vec<CrossRow>, String>, CrossCheckError> {
    if let Some(reason) = cannot_move(pair) {
        return Ok(Err(reason));
    }
    let Some(whole) = with_whole_block(pair.engine) else {
        return Ok(Err("its mounts leave a motion free".into()));
    };
    let none = || Ok(Err("no periodic motion was found".into()));
    let Some(found) = simulated(pair, &whole, Run::Imposed(0.0))? else { return none() };
    let Some(both) = linear(pair, &whole, RotorEffects::BOTH, 0.0)? else {
        return Ok(Err("its mounts have no response at this speed".into()));
    };
    let left = off(&both, &found);
    let mut rows = motion_rows("", &both, &found, |_, _| "moving masses".into());
    for (what, without, cause) in [
        (
            "neither (1) nor (2)",
            RotorEffects::NONE,
            "(1) gyroscopic couple of the rotors, (2) their inertia does not follow the roll",
        ),
        ("(1) alone", RotorEffects::COUPLE, "(2) the rotors' inertia does not follow the roll"),
        ("(2) alone", RotorEffects::ROLL, "(1) gyroscopic couple of the rotors"),
    ] {
        // A block that is light beside its rotors has no inertia that could stand for one cause alone.
        let Some(without) = linear(pair, &whole, without, 0.0)? else { continue };
        let without = off(&without, &found);
        rows.push(CrossRow {
            quantity: format!("motion, largest difference; {what} in the closed form, and with both"),
            unit: "share".into(),
            order: None,
            closed_form: Some(without),
            bond_graph: None,
            multibody: left,
            difference: left,
            scale: 1.0,
            bar: None,
            verdict: CrossVerdict::DiffersAsItMust,
            reason: Some(format!("the first number lacks {cause}; the second has both")),
        });
    }
    // For each kilogram, as the motion itself goes with the moving mass.
    let by_inertia = |engine: &Engine, mass: f64| -> Result<Option<Orders>, CrossCheckError> {
        let found = simulated(pair, engine, Run::Imposed(0.0))?;
        let both = linear(pair, engine, RotorEffects::BOTH, 0.0)?;
        Ok(both.zip(found).map(|(both, found)| sum(&[(1.0 / mass, &both), (-1.0 / mass, &found)])))
    };
    let what = "what is left, over that of half the moving mass";
    let own = sum(&[(1.0, &both), (-1.0, &found)]);
    let Some(row) = ratio_row(what, (&whole, &own, &found), CLOSED, by_inertia)? else {
        return Ok(Err("no periodic motion was found with less moving mass".into()));
    };
    rows.extend(row);
    if pair.gas.is_some()
        && let (Some(full), Some(both_full)) =
            (simulated(pair, &whole, Run::Imposed(1.0))?, linear(pair, &whole, RotorEffects::BOTH, 1.0)?)
        && let share = small_share(&both, &both_full)
        && let Some(gas) = of_small_gas(pair, &whole, share)?
    {
        // What inertia and a little gas leave, each for itself, as if the motion of all of it were small.
        let small = sum(&[(1.0, &both), (-1.0, &found), (1.0, &gas.closed), (-1.0, &gas.found)]);
        let all = sum(&[(1.0, &both_full), (-1.0, &full), (-1.0, &small)]);
        rows.extend(motion_rows(", with gas", &both_full, &full, |index, from| {
            let share = |own: &Orders| size(part(&own[index].1, from)) / largest(&full, from);
            format!("moving masses {:.1e}, size of the motion {:.1e}", share(&small), share(&all))
        }));
        let what = "what is left of the motion by a little gas, over that of half the moving mass";
        let by_gas = |engine: &Engine, _| Ok(of_small_gas(pair, engine, share)?.map(|gas| gas.left()));
        rows.extend(ratio_row(what, (&whole, &gas.left(), &gas.found), CLOSED / share, by_gas)?.flatten());
    }
    Ok(Ok(rows))
}

/// The ratio of what is left to what is left with half the moving mass, which must be 2; none where nothing is left that stands out of the error of the runs, and no
/// row but `None` where a motion is not found. Where it is not 2, what goes with the square of the moving mass is taken out with the help of a quarter of it. Beside the engine what is left
/// of it and of which motion; `left_of` another one with this share of the moving mass.
fn ratio_row(
    name: &str,
    (engine, all, whole): (&Engine, &Orders, &Orders),
    error: f64,
    left_of: impl Fn(&Engine, f64) -> Result<Option<Orders>, CrossCheckError>,
) -> Result<Option<Option<CrossRow>>, CrossCheckError> {
    // Half of what is left must stand so far above the error that the ratio keeps its bar.
    let stands_out = |from: &usize| RATIO * 0.5 * most(all, *from) > 2.0 * error;
    let kinds: Vec<usize> = TURNED_OR_MOVED.into_iter().filter(stands_out).collect();
    let share = |own: &Orders| share(&kinds, own, whole);
    if share(all) <= NOTHING {
        return Ok(Some(None));
    }
    let row = |ratio: f64| CrossRow::held(name, "1", None, [2.0, ratio, (ratio - 2.0).abs(), 2.0], RATIO);
    let half = halved(engine);
    let Some(of_half) = left_of(&half, 0.5)? else { return Ok(None) };
    let plain = share(all) / share(&of_half);
    let found = row(plain);
    if found.verdict == CrossVerdict::Agrees {
        return Ok(Some(Some(found)));
    }
    let Some(of_quarter) = left_of(&halved(&half), 0.25)? else { return Ok(None) };
    let own = share(&sum(&[(4.0, &of_half), (-1.0, all)]));
    let of_half = share(&sum(&[(4.0, &of_quarter), (-1.0, &of_half)]));
    let mut found = row(own / of_half);
    found.reason = Some(format!("without what goes with the square of the moving mass; with it {plain:.4}"));
    Ok(Some(Some(found)))
}

/// How much of the gas moves the block by little, from the linear response to inertia and to inertia with gas.
fn small_share(inertia: &Orders, with_gas: &Orders) -> f64 {
    let gas = sum(&[(1.0, with_gas), (-1.0, inertia)]);
    let [turn, moved] = SMALL;
    // Never so much that pressures are no numbers any more.
    (turn / largest(&gas, 3)).min(moved / largest(&gas, 0)).clamp(1e-6, 1e4)
}

/// Motion by the gas alone, as far as it is in proportion to it: closed form and simulation.
struct OfGas {
    closed: Orders,
    found: Orders,
}

impl OfGas {
    /// What the closed form lacks.
    fn left(&self) -> Orders {
        sum(&[(1.0, &self.closed), (-1.0, &self.found)])
    }
}

/// From a share of the gas with either sign.
fn of_small_gas(pair: &Pair<'_>, engine: &Engine, share: f64) -> Result<Option<OfGas>, CrossCheckError> {
    let both = |plus: Option<Orders>, minus: Option<Orders>| {
        Some(sum(&[(0.5 / share, &plus?), (-0.5 / share, &minus?)]))
    };
    let found =
        both(simulated(pair, engine, Run::Imposed(share))?, simulated(pair, engine, Run::Imposed(-share))?);
    let closed = both(
        linear(pair, engine, RotorEffects::BOTH, share)?,
        linear(pair, engine, RotorEffects::BOTH, -share)?,
    );
    Ok(closed.zip(found).map(|(closed, found)| OfGas { closed, found }))
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
    let (Some(imposed), Some(free), Some(both)) = (
        simulated(pair, &whole, Run::Imposed(1.0))?,
        simulated(pair, &whole, Run::Free)?,
        linear(pair, &whole, RotorEffects::BOTH, 1.0)?,
    ) else {
        return Ok(Err("no periodic motion was found".into()));
    };
    // The part of C, that of the free speed, and what neither explains.
    let of_masses = sum(&[(1.0, &imposed), (-1.0, &both)]);
    let of_speed = sum(&[(1.0, &free), (-1.0, &imposed)]);
    Ok(Ok(motion_rows(", by the linear response", &both, &free, |index, from| {
        let share = |own: &Orders| size(part(&own[index].1, from)) / largest(&free, from);
        format!("as in C {:.1e}, free speed {:.1e} (B)", share(&of_masses), share(&of_speed))
    })))
}

/// Largest size of a kind over all orders.
fn largest(orders: &Orders, from: usize) -> f64 {
    orders.iter().map(|(_, values)| size(part(values, from))).fold(f64::MIN_POSITIVE, f64::max)
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
        let scale = largest(found, from);
        let apart = sum(&[(1.0, found), (-1.0, closed)]);
        for (index, (order, ours)) in found.iter().enumerate() {
            let [ours, theirs, apart] =
                [ours, &closed[index].1, &apart[index].1].map(|v| size(part(v, from)));
            if ours.max(theirs) < LISTED * scale {
                continue;
            }
            rows.push(CrossRow {
                quantity: format!("{name}{what}"),
                unit: unit.into(),
                order: Some(*order),
                closed_form: Some(theirs),
                bond_graph: None,
                multibody: ours,
                difference: apart,
                scale,
                bar: None,
                verdict: CrossVerdict::DiffersAsItMust,
                reason: Some(reason(index, from)),
            });
        }
    }
    rows
}

/// Largest difference of two motions, as a share of the second.
fn off(a: &Orders, b: &Orders) -> f64 {
    share(&TURNED_OR_MOVED, &sum(&[(1.0, a), (-1.0, b)]), b)
}

/// Largest component of a kind over all orders.
fn most(orders: &Orders, from: usize) -> f64 {
    let all = orders.iter().flat_map(|(_, motion)| part(motion, from)).map(|value| value.norm());
    all.fold(f64::MIN_POSITIVE, f64::max)
}

/// Largest component of a difference, each kind over its largest in `whole`.
fn share(kinds: &[usize], difference: &Orders, whole: &Orders) -> f64 {
    kinds.iter().map(|from| most(difference, *from) / most(whole, *from)).fold(0.0, f64::max)
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
#[derive(Debug, Clone, Copy, PartialEq)]
enum Run {
    /// Imposed speed, with this share of the gas.
    Imposed(f64),
    /// Free speed, gas.
    Free,
}

/// A share of a gas.
struct Share<'a> {
    of: GivenGas<'a>,
    share: f64,
}

impl GasPressure for Share<'_> {
    fn pressure(&self, cylinder: usize, own_angle: f64, speed: f64) -> f64 {
        self.share * self.of.pressure(cylinder, own_angle, speed)
    }

    fn cycle(&self) -> f64 {
        self.of.cycle()
    }

    fn kinks(&self, cylinder: usize) -> Vec<f64> {
        self.of.kinks(cylinder)
    }
}

/// The periodic motion of the simulation by order; `None` where there is none.
fn simulated(pair: &Pair<'_>, engine: &Engine, run: Run) -> Result<Option<Orders>, CrossCheckError> {
    let train = train_on_mounts(pair, engine)?;
    let mut simulation = match run {
        Run::Free => Simulation::free(pair.speed, 1.0),
        _ => Simulation::imposed(pair.speed, 1.0),
    };
    simulation.block = BlockMotion::Mounts;
    let share = if let Run::Imposed(share) = run { share } else { 1.0 };
    let gas = pair.gas.filter(|_| share != 0.0);
    let given = gas.map(|gas| Share { of: GivenGas::new(gas), share });
    if let Some(gas) = gas {
        let mean = share * GasTrain::new(engine, gas, Lever::Exact)?.mean_torques().iter().sum::<f64>();
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
    let given = given.as_ref().map(|given| given as &dyn GasPressure);
    // Moving masses and gas hardly change what a motion of the block comes to in a period.
    let found = train.closed_period(&simulation, given, &mut pair.derivative.borrow_mut())?;
    let (Some(found), Some(block)) = (found, &engine.block) else { return Ok(None) };
    let centre = Vector3::from(block.centre);
    let samples = &found.samples;
    let at = |k: usize| -> Vec<f64> {
        let (position, orientation) = (samples.position[k].into(), samples.orientation[k]);
        let rotation = Motion { position, orientation, ..Motion::fixed(0.0, 0.0) }.rotation();
        let moved = position + rotation * centre - centre;
        // From the quaternion: the cosine of so small an angle keeps hardly a digit of it.
        let [w, x, y, z] = orientation;
        let turn = UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z)).scaled_axis();
        let motion = [moved.x, moved.y, moved.z, turn.x, turn.y, turn.z];
        motion.into_iter().chain(samples.mounts.get(k).into_iter().flatten().flatten().copied()).collect()
    };
    let count = samples.theta.len() - 1;
    let traces: Vec<Vec<f64>> = (0..count).map(at).collect();
    let components = traces.first().map_or(0, Vec::len);
    let turns = f64::from(train.revolutions);
    let orders = (1..=ORDERS * train.revolutions).map(|k| {
        let order = f64::from(k) / turns;
        let of = |c: usize| amplitude(traces.iter().map(|at| at[c]), count, 0.0, turns, order);
        (order, (0..components).map(of).collect())
    });
    Ok(Some(orders.collect()))
}

/// The response of `mounts` by order, with what of the rotors and which share of the gas is asked for; `None` where there is none.
fn linear(
    pair: &Pair<'_>,
    engine: &Engine,
    effects: RotorEffects,
    share: f64,
) -> Result<Option<Orders>, CrossCheckError> {
    let about_z = rotor_inertia_about_z(&rotating_bodies(engine));
    let listed =
        || (1..=ORDERS * pair.train.revolutions).map(|k| f64::from(k) / f64::from(pair.train.revolutions));
    let chained;
    let engine = if pair.train.mounts.iter().any(|mount| mount.frequency_dependent) {
        // The same chains as in the run, at the frequencies of its orders.
        let frequencies: Vec<f64> = listed().map(|order| order * pair.speed).collect();
        chained = with_chains(engine, &train_on_mounts(pair, engine)?, &frequencies);
        &chained
    } else {
        engine
    };
    let (Ok(system), Ok(mut excitations)) =
        (MountSystem::new(engine), inertia_excitations(engine, &[pair.speed], ORDERS))
    else {
        return Ok(None);
    };
    if let (Some(gas), true, Some(excitation)) = (pair.gas, share != 0.0, excitations.first_mut()) {
        let mut gas = GasTrain::new(engine, gas, Lever::Exact)?.orders(ORDERS);
        gas.iter_mut().for_each(|order| scale(order, share));
        excitation.orders = merged_orders(&excitation.orders, &gas);
    }
    let system = system.with_rotors(about_z).with_effects(effects);
    let Ok(response) = system.response(&excitations) else { return Ok(None) };
    let mounts = engine.mounts.len();
    let all = |order: f64| {
        let own = response.speeds[0].orders.iter().find(|own| (own.order - order).abs() < 1e-9);
        let of = |own: &OrderResponse| -> Vec<Complex64> {
            own.motion.iter().chain(own.forces.iter().flatten()).copied().collect()
        };
        (order, own.map_or_else(|| vec![Complex64::ZERO; 6 + 3 * mounts], of))
    };
    Ok(Some(listed().map(all).collect()))
}

/// Loads of one order times a factor.
fn scale(order: &mut OrderLoads, factor: f64) {
    for load in [
        &mut order.force_forward,
        &mut order.force_backward,
        &mut order.couple_forward,
        &mut order.couple_backward,
        &mut order.roll_moment,
        &mut order.shaft_torque,
    ] {
        *load *= factor;
    }
}
