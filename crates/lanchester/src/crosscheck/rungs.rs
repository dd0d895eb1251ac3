//! Closed form and bond graph held against the multibody simulation of the same engine.

use crate::crosscheck::orders::{larger, largest_order_rows, order_rows};
use crate::crosscheck::pair::{CrossCheckError, CrossCheckRequest, Loads, Pair, loads_at, loads_beside_jump};
use crate::inertias::{known_inertia, rotor_inertia};
use crate::pressure::cylinders::cylinder_gas;
use crate::pressure::measured::TraceFile;
use crate::pressure::simulated::GivenGas;
use lanchester_mechanism::{
    BearingRequest, GasTrain, Lever, LoadError, LoadRequest, Mechanism, OuterTorque, RippleOutcome,
    bearing_loads, speed_ripple,
};
use lanchester_model::{Engine, SimulationInput};
use lanchester_multibody::{LoadLaw, Reactions, RunOutcome, Simulation, Train};
use lanchester_report::{CROSSCHECK_VERSION, Condition, ConditionCheck, CrossCheck, CrossRow};
use num_complex::Complex64;
use std::cell::RefCell;
use std::f64::consts::TAU;

/// Both sides are exact but for rounding: the share of the largest amplitude of their kind by which they may differ.
const LIKE_FOR_LIKE: f64 = 1e-10;

/// The same for the speed of a run whose steps have the tolerance [`STEPS`].
const FREE_SPEED: f64 = 1e-9;
const STEPS: f64 = 1e-12;

/// A kind of load that cancels is held against this share of what single parts exert.
const CANCELLED: f64 = 1e-3;

/// Samples of one revolution.
const SAMPLES: usize = 180;

/// Loads on the block and at the shaft.
const KINDS: [(&str, &str); 4] =
    [("force", "N"), ("couple", "N m"), ("roll moment", "N m"), ("shaft torque", "N m")];

/// Compares closed form, bond graph and multibody simulation of `engine`, with its own gas where the file gives some; `traces` holds the files that
/// [`crate::trace_names`] names.
///
/// ```
/// use lanchester::{CrossCheckRequest, crosscheck};
///
/// let template = lanchester::file::template("v6-90").expect("it is in the gallery");
/// let engine = lanchester::file::read(template.text).engine().expect("the gallery has no mistakes");
/// let check = crosscheck(&engine, &[], &CrossCheckRequest::default())?;
/// assert!(check.agrees());
/// # Ok::<(), lanchester::CrossCheckError>(())
/// ```
///
/// # Errors
/// [`CrossCheckError`] where one of the two computations refuses the engine.
pub fn crosscheck(
    engine: &Engine,
    traces: &[TraceFile],
    request: &CrossCheckRequest,
) -> Result<CrossCheck, CrossCheckError> {
    let speed = request.speed.unwrap_or(engine.speed.highest);
    let report = match engine.gas {
        Some(_) => Some(cylinder_gas(engine, traces, speed)?),
        None => None,
    };
    let pair = Pair {
        engine,
        speed,
        gas: report.as_ref().map(|report| &report.cylinders[..]),
        train: Train::new(engine, &rotor_inertia(engine))?,
        request,
        derivative: RefCell::default(),
    };
    let wanted = |condition: &&Condition| match request.conditions.as_slice() {
        [] => condition.is_usual(),
        asked => asked.contains(condition),
    };
    let conditions = Condition::ALL.iter().filter(wanted).map(|&condition| pair.check(condition));
    Ok(CrossCheck {
        version: CROSSCHECK_VERSION,
        engine: engine.name.clone(),
        speed,
        conditions: conditions.collect::<Result<Vec<_>, _>>()?,
        gas: report.map(|report| report.source),
        notes: request.simulation.as_deref().and_then(left_out).into_iter().collect(),
    })
}

/// What of the file's run no condition but B has.
fn left_out(input: &SimulationInput) -> Option<String> {
    let over_angle = input.load.as_ref().is_some_and(|load| load.law.is_over_angle());
    let given = [
        ("torque over the angle", !input.torque.is_empty() || !input.torque_files.is_empty()),
        ("load over the angle", over_angle),
    ];
    let named: Vec<&str> =
        given.into_iter().filter_map(|(name, is_given)| is_given.then_some(name)).collect();
    let others = [
        ("starter", input.starter.is_some()),
        ("governor", input.governor.is_some()),
        ("driveline", !input.driveline.is_empty()),
        ("events", !input.events.is_empty()),
    ];
    let nowhere: Vec<&str> =
        others.into_iter().filter_map(|(name, is_given)| is_given.then_some(name)).collect();
    let mut words = Vec::new();
    if !named.is_empty() {
        words.push(format!("Of [simulation] condition B alone has: {}.", named.join(", ")));
    }
    if !nowhere.is_empty() {
        words.push(format!("Of [simulation] no condition has: {}.", nowhere.join(", ")));
    }
    (!words.is_empty()).then(|| words.join(" "))
}

impl Pair<'_> {
    fn check(&self, condition: Condition) -> Result<ConditionCheck, CrossCheckError> {
        let found = match condition {
            Condition::LikeForLike => Ok(self.like_for_like()?),
            Condition::FreeSpeed => self.free_speed()?,
            Condition::MovingBlock => crate::crosscheck::mounts::moving_block(self)?,
            Condition::AllFree => self.all_free()?,
            Condition::FlexibleCrank => crate::crosscheck::flexible::flexible(self)?,
        };
        let (rows, not_applicable) = match found {
            Ok(rows) => (rows, None),
            Err(reason) => (Vec::new(), Some(reason)),
        };
        Ok(ConditionCheck { condition, not_applicable, rows })
    }

    /// Condition D: the bond graph for some revolutions, then the linear response with the causes of what it misses; either where the file
    /// has its data.
    fn all_free(&self) -> Result<Result<Vec<CrossRow>, String>, CrossCheckError> {
        let graph = crate::crosscheck::graph::all_free(self)?;
        let response = crate::crosscheck::mounts::all_free(self)?;
        Ok(match (graph, response) {
            (Ok(mut rows), Ok(more)) => {
                rows.extend(more);
                Ok(rows)
            }
            (Ok(rows), Err(_)) | (Err(_), Ok(rows)) => Ok(rows),
            (Err(reason), Err(_)) => Err(reason),
        })
    }

    /// Condition A: every component over the cycle and by order.
    fn like_for_like(&self) -> Result<Vec<CrossRow>, CrossCheckError> {
        let bar = self.request.bar.unwrap_or(LIKE_FOR_LIKE);
        let request = LoadRequest { speed: Some(self.speed), ..LoadRequest::default() };
        let closed = Mechanism::new(self.engine, &request)?;
        let train = self.gas.map(|gas| GasTrain::new(self.engine, gas, Lever::Exact)).transpose()?;
        let request =
            BearingRequest { speed: Some(self.speed), samples: SAMPLES, ..BearingRequest::default() };
        let bearings = bearing_loads(self.engine, self.gas, &request)?;
        let shares = self.train.main_shares(&[]);
        let mut on_block: Vec<Loads> = Vec::new();
        let mut by_closed: Vec<Loads> = Vec::new();
        // Side thrust, piston pins, lower pins, mains; of every one of a kind the traces of closed form and simulation.
        let cylinders = self.train.cylinders.len();
        let mut parts: [Vec<[Vec<Complex64>; 2]>; 4] = Default::default();
        for (kind, part) in parts.iter_mut().enumerate() {
            part.resize(if kind < 3 { cylinders } else { bearings.mains.len() }, Default::default());
        }
        let mut reach = 0.0f64;
        for cylinder in &self.train.cylinders {
            reach = reach.max(cylinder.z.abs()).max(cylinder.crankpin.norm());
        }
        for (j, &theta) in bearings.theta.iter().enumerate() {
            let (loads, ours) = loads_at(self, theta, &shares);
            let beside = loads_beside_jump(self, theta, &shares);
            let theirs = closed.components(theta);
            let gas = train.as_ref().map_or(0.0, |train| train.torque(theta));
            let real = |value: f64| Complex64::new(value, 0.0);
            let theirs = [
                Complex64::new(theirs.force_x, theirs.force_y),
                Complex64::new(theirs.couple_x, theirs.couple_y),
                real(theirs.roll_moment - gas),
                real(theirs.shaft_torque + gas),
            ];
            // Of both sides of a jump the one that the closed form took.
            let nearest = |own: Complex64, sides: &mut dyn Iterator<Item = Complex64>, theirs: Complex64| {
                sides.fold(
                    own,
                    |best, side| {
                        if (side - theirs).norm() < (best - theirs).norm() { side } else { best }
                    },
                )
            };
            on_block.push(std::array::from_fn(|kind| {
                nearest(loads[kind], &mut beside.iter().map(|(side, _)| side[kind]), theirs[kind])
            }));
            by_closed.push(theirs);
            let mut compare =
                |kind: usize, index: usize, of: &dyn Fn(&Reactions) -> Complex64, theirs: Complex64| {
                    let [closed, multibody] = &mut parts[kind][index];
                    closed.push(theirs);
                    multibody.push(nearest(of(&ours), &mut beside.iter().map(|(_, side)| of(side)), theirs));
                };
            for (index, theirs) in bearings.cylinders.iter().enumerate() {
                let across = |force: [f64; 3]| Complex64::new(force[0], force[1]);
                let axis = self.train.cylinders[index].axis;
                let thrust = |side: &Reactions| real(side.cylinders[index].side_thrust);
                compare(0, index, &thrust, real(theirs.side_thrust[j]));
                let pin = |side: &Reactions| across(side.cylinders[index].piston_pin.force) * axis.conj();
                compare(1, index, &pin, theirs.piston_pin.load[j]);
                let lower = |side: &Reactions| across(side.cylinders[index].lower_pin.force);
                compare(2, index, &lower, theirs.lower_pin.load[j]);
            }
            for (index, theirs) in bearings.mains.iter().enumerate() {
                let main = |side: &Reactions| {
                    let mains = &side.rotors[theirs.crankshaft - 1].mains[0];
                    let [x, y] = mains.get(theirs.main - 1).copied().unwrap_or([f64::NAN; 2]);
                    Complex64::new(x, y)
                };
                compare(3, index, &main, theirs.load.load[j]);
            }
        }
        let turns = bearings.period / TAU;
        let max_order = self.request.max_order;
        let largest = |trace: &[Complex64]| trace.iter().map(|at| at.norm()).fold(0.0, f64::max);
        let apart =
            |a: &[Complex64], b: &[Complex64]| a.iter().zip(b).map(|(a, b)| (a - b).norm()).fold(0.0, larger);
        let whole = parts[2].iter().map(|[closed, _]| largest(closed)).fold(0.0, f64::max);
        let mut kinds = KINDS.map(|named| (named, 0.0));
        let mut rows = Vec::new();
        for (kind, (named, scale)) in kinds.iter_mut().enumerate() {
            let pick = |trace: &[Loads]| trace.iter().map(|at| at[kind]).collect::<Vec<_>>();
            let (theirs, ours) = (pick(&by_closed), pick(&on_block));
            *scale = largest(&theirs).max(CANCELLED * whole * if kind == 0 { 1.0 } else { reach });
            let values = [largest(&theirs), largest(&ours), apart(&ours, &theirs), *scale];
            rows.push(CrossRow::held(named.0, named.1, None, values, bar));
            rows.extend(order_rows(*named, [&theirs, &ours], turns, max_order, *scale, bar));
        }
        let names = ["side thrust", "piston pins", "crankpins and knuckle pins", "main bearings"];
        for (name, parts) in names.into_iter().zip(&parts) {
            if parts.is_empty() {
                continue;
            }
            let of = |side: usize| parts.iter().map(|part| largest(&part[side])).fold(0.0, f64::max);
            let off = parts.iter().map(|[closed, ours]| apart(ours, closed)).fold(0.0, larger);
            let scale = of(0).max(CANCELLED * whole);
            rows.push(CrossRow::held(name, "N", None, [of(0), of(1), off, scale], bar));
            let traces: Vec<[&[Complex64]; 2]> =
                parts.iter().map(|[closed, ours]| [&closed[..], &ours[..]]).collect();
            rows.extend(largest_order_rows((name, "N"), &traces, turns, max_order, scale, bar));
        }
        rows.extend(crate::crosscheck::graph_loads::load_rows(self, turns, kinds)?);
        rows.extend(crate::crosscheck::graph_joints::joint_rows(self));
        rows.extend(crate::crosscheck::graph_states::gas_row(self)?);
        Ok(rows)
    }

    /// Condition B: the speed over the cycle against the energy integral; or why it does not apply.
    fn free_speed(&self) -> Result<Result<Vec<CrossRow>, String>, CrossCheckError> {
        let input = self.request.simulation.as_deref();
        let torque = match input {
            Some(input) => input.torque_orders().map_err(LoadError::Unread)?,
            None => Vec::new(),
        };
        if self.gas.is_none() && torque.is_empty() {
            return Ok(Err("the file has no [gas] that could drive the engine".into()));
        }
        let ripple = match speed_ripple(
            self.engine,
            self.gas,
            self.speed,
            &OuterTorque::of(input)?,
            known_inertia(self.engine),
        )? {
            RippleOutcome::Periodic(ripple) => ripple,
            RippleOutcome::IncompleteInertia(missing) => return Ok(Err(missing.reason)),
            RippleOutcome::Stops(stopped) => return Ok(Err(stopped.reason)),
        };
        let count = ripple.theta.len();
        let mut simulation = Simulation::free(ripple.speed[0], ripple.period / TAU);
        simulation.torque = torque;
        let own = input.filter(|input| input.driveline.is_empty()).and_then(|input| input.load.as_ref());
        simulation.load.law = match own.and_then(|load| load.law.over_angle(self.speed)) {
            // What the table varies, about the mean of the torques; as the closed form takes it, at the mean speed.
            Some((period, points)) => {
                let next = points.iter().cycle().skip(1);
                let areas = points.iter().zip(next).map(|(a, b)| {
                    let width = if points.len() == 1 { period } else { (b[0] - a[0]).rem_euclid(period) };
                    0.5 * (a[1] + b[1]) * width
                });
                let mean = areas.sum::<f64>() / period;
                let points = points.iter().map(|[at, torque]| [*at, torque - mean + ripple.load]).collect();
                LoadLaw::Angle { period, points }
            }
            None => LoadLaw::Constant(ripple.load),
        };
        simulation.step = ripple.period / count as f64;
        simulation.tolerance = STEPS;
        simulation.reactions = true;
        let given = self.gas.map(GivenGas::new);
        let gas = given.as_ref().map(|given| given as &dyn lanchester_multibody::GasPressure);
        let run = self.train.run(&simulation, gas)?;
        if run.outcome != RunOutcome::Complete {
            return Ok(Err("the simulated engine does not come through its cycle".into()));
        }
        let pairs = || run.samples.speed.iter().zip(&ripple.speed);
        let off = pairs().map(|(ours, theirs)| (ours - theirs).abs()).fold(0.0, f64::max);
        let largest = |speeds: &[f64]| speeds.iter().copied().fold(0.0, f64::max);
        let values = [largest(&ripple.speed), largest(&run.samples.speed[..count]), off, self.speed];
        let mut rows = vec![CrossRow::held("speed", "rad/s", None, values, FREE_SPEED)];
        rows.extend(crate::crosscheck::ripple::load_rows(self, &ripple, &run)?);
        Ok(Ok(rows))
    }
}
