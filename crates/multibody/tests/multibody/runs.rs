//! Runs: conservation, start, run-down, load step, misfire, governor, driveline, imposed speed, accuracy.

use crate::support;
use lanchester_model::{Block, Engine, Mount, MountSpring, MovingParts, Strokes};
use lanchester_multibody::*;
use std::f64::consts::{PI, TAU};
use support::{engine, in_line, throw};

/// A closed cylinder: `p V^n` constant, one turn a cycle.
pub struct Sealed {
    radius: f64,
    rod: f64,
    ratio: f64,
    exponent: f64,
    /// Factor on the expansion: 1 without combustion.
    fired: f64,
}

impl Sealed {
    fn motored_at(&self, own: f64) -> f64 {
        let (sin, cos) = own.sin_cos();
        let travel = self.radius * cos + (self.rod * self.rod - (self.radius * sin).powi(2)).sqrt();
        let top = self.radius + self.rod;
        let clearance = 2.0 * self.radius / (self.ratio - 1.0);
        let volume = (top - travel + clearance) / (2.0 * self.radius + clearance);
        1e5 * volume.powf(-self.exponent) - 1e5
    }
}

impl GasPressure for Sealed {
    fn pressure(&self, _: usize, own: f64, _: f64) -> f64 {
        let own = own.rem_euclid(self.cycle());
        let motored = self.motored_at(own);
        if own < PI { motored * self.fired } else { motored }
    }

    fn cycle(&self) -> f64 {
        2.0 * TAU
    }

    fn kinks(&self, _: usize) -> Vec<f64> {
        if self.fired == 1.0 { Vec::new() } else { vec![0.0, PI] }
    }
}

pub fn gas(fired: f64) -> Sealed {
    Sealed { radius: 0.045, rod: 0.15, ratio: 9.0, exponent: 1.35, fired }
}

/// An in-line engine with bores and firings, in a block on four mounts.
pub fn fired(count: usize) -> Engine {
    let angles: Vec<f64> = match count {
        1 => vec![0.0],
        2 => vec![0.0, PI],
        _ => vec![0.0, PI, PI, 0.0],
    };
    let mut engine = in_line(&angles);
    engine = engine
        .with(|engine| {
            engine.strokes = Strokes::Four;
        })
        .unwrap();
    let firings = [0.0, 3.0 * PI, PI, TAU];
    engine = engine
        .with(|engine| {
            for (index, cylinder) in engine.cylinders.iter_mut().enumerate() {
                cylinder.bore = Some(0.08);
                cylinder.firing_angle = Some(if count == 1 { 0.0 } else { firings[index] });
            }

            engine.block = Some(Block {
                mass: 120.0,
                centre: [0.06, 0.01, 0.02],
                inertia: [9.0, 8.0, 4.0],
                products: [0.1, -0.2, 0.15],
                moving_parts: MovingParts::Included,
                gravity: [-1.0, 0.0, 0.0],
                driveline_torque: [0.0; 3],
            });
        })
        .unwrap();
    for (y, z) in [(0.25, 0.3), (-0.25, 0.3), (0.25, -0.25), (-0.25, -0.25)] {
        let spring = MountSpring { damping: [300.0; 3], ..MountSpring::along_frame([9e4, 5e4, 6e4]) };
        engine = engine
            .with(|engine| {
                engine.mounts.push(Mount {
                    name: format!("at {y} {z}"),
                    x: -0.1,
                    y,
                    z,
                    spring: Some(spring),
                });
            })
            .unwrap();
    }
    engine
}

pub fn train(engine: &Engine) -> Train {
    let inertia = RotorInertia {
        crankshafts: vec![Some(0.25); engine.crankshafts.len()],
        flywheel: 0.18,
        shafts: vec![Some(2e-4); engine.shafts.len()],
    };
    Train::new(engine, &inertia).expect("it turns")
}

/// Mean torque of the gas over one working cycle at constant speed.
pub fn mean_torque(train: &Train, gas: &dyn GasPressure) -> f64 {
    let run = train
        .run(&Simulation { tolerance: 1e-11, ..Simulation::imposed(100.0, 2.0) }, Some(gas))
        .expect("it runs");
    run.energy.gas / (2.0 * TAU)
}

#[test]
fn prop_energy_of_a_sealed_engine_stays_for_a_hundred_revolutions() {
    let train = train(&fired(2));
    let simulation = Simulation { tolerance: 1e-12, step: 0.3, ..Simulation::free(150.0, 100.0) };
    let run = train.run(&simulation, Some(&gas(1.0))).expect("it runs");
    assert_eq!(run.outcome, RunOutcome::Complete);
    let [first, last] = run.energy.kinetic;
    let stored = (last - run.energy.gas - first).abs() / first;
    assert!(stored < 1e-10 && run.audit.energy < 1e-10, "{stored:e} {:?}", run.audit);
    assert!(run.audit.loops < 1e-12);
    // The gas gives back what it takes: after whole cycles the speed is that of the start.
    let speed = run.samples.speed[0];
    assert!((run.end[2] / speed - 1.0).abs() < 1e-9, "{} {speed}", run.end[2]);
}

#[test]
fn prop_momenta_in_space_stay_without_outside_loads() {
    let mut engine = fired(2);
    engine = engine
        .with(|engine| {
            engine.mounts.clear();
        })
        .unwrap();
    let train = train(&engine);
    let start = BlockStart::Moving { velocity: [0.1, -0.2, 0.05], spin: [0.3, 0.2, -0.4] };
    let mut simulation =
        Simulation { block: BlockMotion::Floating, block_start: start, ..Simulation::free(100.0, 20.0) };
    simulation.tolerance = 1e-12;
    let run = train.run(&simulation, Some(&gas(1.6))).expect("it runs");
    let audit = run.audit;
    let [linear, angular] =
        [audit.linear_momentum, audit.angular_momentum].map(|a| a.expect("nothing acts from outside"));
    assert!(linear < 1e-11 && angular < 1e-11 && audit.energy < 1e-10, "{audit:?}");
    // The quaternion goes back to size 1 after each piece only.
    assert!(audit.quaternion < 1e-8);
}

#[test]
fn prop_energy_on_mounts_with_everything() {
    let train = train(&fired(4));
    let gas = gas(1.8);
    let mut simulation = Simulation::free(150.0, 100.0);
    simulation.block = BlockMotion::Mounts;
    simulation.gravity = STANDARD_GRAVITY;
    simulation.piston_damping = 15.0;
    simulation.friction_torque = 4.0;
    simulation.step = 0.1;
    simulation.load.law = LoadLaw::Viscous { torque: mean_torque(&train, &gas), at: 150.0 };
    let link = |inertia, ratio| DrivelineInertia { inertia, stiffness: 4e3, damping: 4.0, ratio };
    simulation.driveline = vec![link(0.1, 1.0), link(0.4, 0.5)];
    let run = train.run(&simulation, Some(&gas)).expect("it runs");
    assert_eq!(run.outcome, RunOutcome::Complete);
    assert!(run.audit.energy < 1e-9, "{:?} {:?}", run.audit, run.energy);
    assert!(
        run.energy.mount_damping < 0.0
            && run.energy.driveline_damping < 0.0
            && run.energy.piston_friction < 0.0
    );
    assert!(run.energy.load < 0.0 && run.energy.gas > 0.0);
}

#[test]
fn tolerance_means_error_at_every_sample() {
    let train = train(&fired(4));
    let gas = gas(1.8);
    let load = LoadLaw::Constant(mean_torque(&train, &gas));
    let with = |tolerance| {
        let mut simulation = Simulation { tolerance, ..Simulation::free(120.0, 10.0) };
        simulation.load.law = load.clone();
        train.run(&simulation, Some(&gas)).expect("it runs").samples.speed
    };
    let exact = with(1e-13);
    for power in 6..=11 {
        let tolerance = 10f64.powi(-power);
        let off = with(tolerance).iter().zip(&exact).map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max);
        assert!(off <= 10.0 * tolerance, "tolerance {tolerance:e}: {off:e}");
        assert!(off > 1e-4 * tolerance, "tolerance {tolerance:e} is wasted: {off:e}");
    }
}

#[test]
fn a_constant_load_gives_the_speed_of_the_energy_integral() {
    // E(theta) = M w^2 / 2 changes by the work of gas and load alone, both known at every angle.
    let engine = fired(4);
    let train = train(&engine);
    let gas = gas(1.8);
    let load = mean_torque(&train, &gas);
    let mut simulation = Simulation { tolerance: 1e-12, ..Simulation::free(90.0, 4.0) };
    simulation.load.law = LoadLaw::Constant(load);
    let run = train.run(&simulation, Some(&gas)).expect("it runs");
    let last = run.samples.speed.len() - 1;
    let per_cycle = 720;
    assert_eq!(last, 2 * per_cycle);
    for k in 0..=per_cycle {
        let (a, b) = (run.samples.speed[k], run.samples.speed[k + per_cycle]);
        assert!((a / b - 1.0).abs() < 1e-10, "the second cycle repeats the first: {k} {a} {b}");
    }
    // The last period by itself: it repeats, so that the load takes what the gas gives.
    let period = run.last_period.expect("two whole cycles");
    assert!((period.load + load * 4.0 * PI).abs() < 1e-9 * load, "{period:?}");
    assert!((period.gas + period.load).abs() < 1e-9 * period.gas, "{period:?}");
    assert!((period.kinetic[1] - period.kinetic[0]).abs() < 1e-9 * period.throughput, "{period:?}");
    assert!((run.energy.gas - 2.0 * period.gas).abs() < 1e-9 * period.gas, "{:?}", run.energy);
    let short = Simulation { duration: Duration::Revolutions(1.5), ..simulation.clone() };
    assert_eq!(train.run(&short, Some(&gas)).expect("it runs").last_period, None);
    // The work by Simpson's rule on the samples' torques between kinks every half turn.
    let mut places = Vec::new();
    train.places_into(0.0, &mut places);
    let start = 0.5 * train.crank_inertia(&places).inertia * 90.0f64.powi(2);
    let mut work = 0.0;
    let steps = 20_000;
    let h = PI / f64::from(steps);
    for k in 0..steps {
        let theta = h * (f64::from(k) + 0.5);
        let torque = |theta: f64| {
            let mut places = Vec::new();
            train.places_into(theta, &mut places);
            let area = 0.25 * PI * 0.08f64.powi(2);
            let forces: Vec<f64> =
                (0..4).map(|c| area * gas.pressure(c, train.own_angle(c, theta), 90.0)).collect();
            train.piston_torque(&places, 90.0, &forces, 0.0)[0] - load
        };
        let node = 0.5 * h / 3f64.sqrt();
        work += 0.5 * h * (torque(theta - node) + torque(theta + node));
    }
    train.places_into(PI, &mut places);
    let speed = (2.0 * (start + work) / train.crank_inertia(&places).inertia).sqrt();
    assert!((run.samples.speed[180] / speed - 1.0).abs() < 1e-10, "{} {speed}", run.samples.speed[180]);
}

#[test]
fn a_starter_turns_the_engine_over_and_lets_go() {
    let train = train(&fired(4));
    let mut simulation = Simulation::free(0.0, 1.0);
    simulation.duration = Duration::Time(1.5);
    simulation.start_angle = 0.4;
    simulation.friction_torque = 6.0;
    let starter = Starter {
        stall_torque: 12.0,
        free_speed: 900.0,
        ratio: 10.0,
        until: 70.0,
        reacts_on: ReactsOn::Block,
    };
    simulation.starter = Some(starter);
    let run = train.run(&simulation, Some(&gas(1.8))).expect("it runs");
    assert_eq!(run.outcome, RunOutcome::Complete);
    assert!(
        run.events
            .iter()
            .any(|event| event.what == Occasion::StarterOff && (event.speed - 70.0).abs() < 1e-9)
    );
    assert!(
        run.end[2] > 60.0 && run.energy.starter > 0.0 && run.audit.energy < 1e-8,
        "{:?} {:?}",
        run.end,
        run.audit
    );

    // Too weak for the compression: it never turns over, and the run says where and by how much.
    simulation.starter = Some(Starter { stall_torque: 1.5, ..starter });
    simulation.duration = Duration::Time(30.0);
    simulation.start_angle = 1.5;
    let run = train.run(&simulation, Some(&gas(1.0))).expect("it runs");
    let RunOutcome::AtRest { theta, torque, held_by } = run.outcome else { panic!("{:?}", run.outcome) };
    assert!(theta > 1.5 && theta < TAU && held_by == 6.0 && torque.abs() <= 6.0, "{theta} {torque}");
}

#[test]
fn a_run_down_ends_with_its_rock_back() {
    let train = train(&fired(1));
    let mut simulation = Simulation::free(30.0, 1.0);
    simulation.duration = Duration::Time(60.0);
    simulation.friction_torque = 1.5;
    let run = train.run(&simulation, Some(&gas(1.0))).expect("it runs");
    let RunOutcome::AtRest { theta, torque, held_by } = run.outcome else { panic!("{:?}", run.outcome) };
    assert!(torque.abs() <= held_by && run.end[2] == 0.0 && theta == run.end[1]);
    let back = run.events.iter().filter(|event| event.what == Occasion::Reversed).count();
    assert!(back >= 1, "it rocks back on the compression: {:?}", run.events);
    assert!(run.samples.speed.iter().any(|speed| *speed < -0.5));
    assert!(run.audit.energy < 1e-8, "{:?}", run.audit);
}

#[test]
fn a_misfire_brings_half_orders() {
    let train = train(&fired(4));
    let gas = gas(1.8);
    let mut simulation = Simulation::free(150.0, 8.0);
    simulation.load.law = LoadLaw::Constant(mean_torque(&train, &gas));
    simulation.events = vec![Event { when: When::Angle(4.0 * TAU), action: Action::Misfire(2) }];
    let run = train.run(&simulation, Some(&gas)).expect("it runs");
    assert_eq!(run.events[0].what, Occasion::Event { index: 0 });
    assert!((run.events[0].theta - 4.0 * TAU).abs() < 1e-10);
    let half_order = |from: usize| {
        let torque = &run.samples.gas_torque[from..from + 720];
        let (mut re, mut im) = (0.0, 0.0);
        for (k, torque) in torque.iter().enumerate() {
            let (sin, cos) = (0.5 * TAU * k as f64 / 360.0).sin_cos();
            (re, im) = (re + torque * cos / 360.0, im + torque * sin / 360.0);
        }
        f64::hypot(re, im)
    };
    let [before, after] = [half_order(0), half_order(1440)];
    assert!(before < 1e-6 * after && after > 10.0, "{before} {after}");
    assert!(run.end[2] < 150.0);
}

#[test]
fn a_periodic_motion_is_found_and_closes() {
    let engine = fired(4);
    let train = train(&engine);
    let gas = gas(1.8);
    let torque = mean_torque(&train, &gas);
    let with = |reacts_on| {
        let mut simulation = Simulation { step: PI / 1440.0, ..Simulation::free(150.0, 1.0) };
        simulation.block = BlockMotion::Mounts;
        simulation.load = Load { law: LoadLaw::Viscous { torque, at: 150.0 }, reacts_on };
        train.periodic(&simulation, Some(&gas)).expect("it runs")
    };
    // Mean over one period of the roll moment of the block on its mounts, by the reaction to the load: the damped springs' mean is that of the load.
    let roll = |periodic: &Periodic| {
        let samples = &periodic.run.samples;
        let moment = |k: usize| {
            let turn = samples.orientation[k];
            let mounts = samples.mounts[k].iter().zip(&train.mounts);
            let motion =
                Motion { orientation: turn, position: samples.position[k].into(), ..Motion::fixed(0.0, 0.0) };
            mounts
                .map(|(force, mount)| {
                    let at = motion.position + motion.rotation() * mount.at;
                    at.x * force[1] - at.y * force[0]
                })
                .sum::<f64>()
        };
        // Simpson's rule over the angle, whose steps end at the kinks of the pressures.
        let last = samples.theta.len() - 1;
        assert_eq!(last % 8, 0, "whole pairs between kinks half a turn apart");
        let over = |value: &dyn Fn(usize) -> f64| -> f64 {
            let weight = |k: usize| match k {
                0 => 1.0,
                k if k == last => 1.0,
                k if k % 2 == 1 => 4.0,
                _ => 2.0,
            };
            (0..=last).map(|k| weight(k) * value(k) / samples.speed[k]).sum()
        };
        let time = over(&|_| 1.0);
        // The torque from the ground is one about the crank axis, which the block tilts.
        let along = |k: usize| {
            let motion = Motion { orientation: samples.orientation[k], ..Motion::fixed(0.0, 0.0) };
            samples.load_torque[k] * motion.rotation()[(2, 2)]
        };
        (over(&moment) / time, -over(&along) / time)
    };
    let bolted = with(ReactsOn::Block);
    assert_eq!(bolted.outcome, PeriodicOutcome::Stable, "{} {:?}", bolted.residual, bolted.multipliers);
    assert!(bolted.residual < 1e-10 && bolted.iterations <= 8);
    let largest = bolted.multipliers[0];
    assert!(largest[0].hypot(largest[1]) < 1.0 && bolted.multipliers.len() == 13);
    let last = bolted.run.samples.speed.len() - 1;
    assert!((bolted.run.samples.speed[last] / bolted.run.samples.speed[0] - 1.0).abs() < 1e-9);
    // The angular momentum of the whole returns, so that nothing is left on average but what the period is short of closing.
    let (mean, load) = roll(&bolted);
    assert!(mean.abs() < 1e-9 * load, "bolted: {mean:e} {load}");
    let free = with(ReactsOn::Ground);
    let (mean, load) = roll(&free);
    assert!((mean + load).abs() < 1e-9 * load, "free: {:e} {load}", mean + load);

    // A constant load prefers no speed; more than the engine gives has no periodic motion.
    let fixed = |law| {
        let mut simulation = Simulation::free(150.0, 1.0);
        simulation.load.law = law;
        train.periodic(&simulation, Some(&gas)).expect("it runs")
    };
    let neutral = fixed(LoadLaw::Constant(torque));
    assert_eq!(neutral.outcome, PeriodicOutcome::Neutral, "{:?}", neutral.multipliers);
    assert_eq!(fixed(LoadLaw::Constant(1.1 * torque)).outcome, PeriodicOutcome::NotFound);
}

#[test]
fn an_imposed_speed_follows_its_profile() {
    let train = train(&fired(4));
    let mut simulation = Simulation::imposed(80.0, 1.0);
    simulation.duration = Duration::Time(1.0);
    simulation.drive =
        Drive::Imposed { profile: vec![[0.2, 80.0], [0.7, 180.0]], against: ImposedAgainst::Block };
    let run = train.run(&simulation, Some(&gas(1.8))).expect("it runs");
    assert!((run.end[2] - 180.0).abs() < 1e-8, "{:?}", run.end);
    let turned = 80.0 * 0.2 + 0.5 * (80.0 + 180.0) * 0.5 + 180.0 * 0.3;
    assert!((run.end[1] - turned).abs() < 1e-7, "{:?} {turned}", run.end);
    assert!(run.audit.energy < 1e-9, "{:?}", run.audit);

    // On mounts: relative to the block, or to the ground, from which it differs by the roll.
    let on = |against| {
        let mut simulation = Simulation::imposed(150.0, 6.0);
        simulation.block = BlockMotion::Mounts;
        simulation.drive = Drive::Imposed { profile: vec![[0.0, 150.0]], against };
        train.run(&simulation, Some(&gas(1.8))).expect("it runs")
    };
    let relative = on(ImposedAgainst::Block);
    assert!(relative.samples.speed.iter().all(|speed| (speed - 150.0).abs() < 1e-9));
    let absolute = on(ImposedAgainst::Ground);
    let both = absolute.samples.speed.iter().zip(&absolute.samples.spin).map(|(w, spin)| w + spin[2]);
    assert!(
        both.clone().all(|sum| (sum - 150.0).abs() < 1e-6),
        "{:?}",
        both.fold(0.0f64, |m, s| m.max((s - 150.0).abs()))
    );
    assert!(absolute.samples.speed.iter().any(|speed| (speed - 150.0).abs() > 1e-3));
    assert!(relative.audit.energy < 1e-8 && absolute.audit.energy < 1e-8);
}

/// A sealed cylinder whose pressure is no number behind an angle.
struct Broken(Sealed);

impl GasPressure for Broken {
    fn pressure(&self, cylinder: usize, own: f64, speed: f64) -> f64 {
        if own > 1.3 * TAU { f64::NAN } else { self.0.pressure(cylinder, own, speed) }
    }

    fn cycle(&self) -> f64 {
        self.0.cycle()
    }

    fn kinks(&self, cylinder: usize) -> Vec<f64> {
        self.0.kinks(cylinder)
    }
}

/// A state that becomes no number ends the run with its angle and its quantity, and keeps the samples before it.
#[test]
fn what_is_no_number_ends_the_run_with_its_good_samples() {
    let train = train(&fired(1));
    let run = train.run(&Simulation::free(150.0, 3.0), Some(&Broken(gas(1.0)))).expect("it starts");
    let RunOutcome::Failed { theta, quantity, .. } = run.outcome else { panic!("{:?}", run.outcome) };
    assert!((theta - 1.3 * TAU).abs() < 1e-3, "{theta}");
    assert!(quantity.is_some() || theta > 1.29 * TAU, "{quantity:?}");
    let samples = &run.samples;
    assert!(samples.theta.len() > 460 && *samples.theta.last().unwrap() <= theta);
    assert!(samples.speed.iter().chain(&samples.acceleration).all(|value| value.is_finite()));
}

#[test]
fn a_profile_that_ends_at_rest_bounds_the_revolutions() {
    let engine = engine("bare", vec![throw(0.0, 0.0)], vec![support::cylinder(0, 0.0, 0.0)]);
    let train = Train::new(&engine, &RotorInertia::of(&engine.rotating_bodies(&[]))).expect("it turns");
    let run = |profile: &[[f64; 2]], duration: Duration| {
        let drive = Drive::Imposed { profile: profile.to_vec(), against: ImposedAgainst::Block };
        train.run(&Simulation { drive, duration, ..Simulation::imposed(1.0, 1.0) }, None)
    };
    // Half of 100 rad/s for 1 s, and 0.5 s at full speed before it: 100 rad. Then backwards, which brings nothing.
    let falls = [[0.5, 100.0], [1.5, 0.0]];
    let turns_back = [[0.0, 100.0], [0.5, 100.0], [2.5, -100.0]];
    for (profile, stands) in [(&falls[..], 1.5), (&turns_back[..], 1.5)] {
        let most = 100.0 / TAU;
        for wanted in [most, most + 0.1, 1e3] {
            let refused = run(profile, Duration::Revolutions(wanted)).expect_err("it stands");
            let MultibodyError::StandsStill { at, turned, .. } = refused else { panic!("{refused}") };
            assert!((at - stands).abs() < 1e-12 && (turned - most).abs() < 1e-12, "{at} {turned}");
        }
        let done = run(profile, Duration::Revolutions(most - 0.1)).expect("it gets there");
        assert_eq!(done.outcome, RunOutcome::Complete);
        // The last sample lies less than a step before the end: samples are a degree apart at full speed.
        let left = 100.0 - 0.1 * TAU - done.samples.theta.last().unwrap();
        assert!(left.abs() < PI / 180.0, "{left}");
    }
    // Against the ground a block on mounts may roll by what is missing: there must be room for it.
    let on_mounts = self::train(&fired(4));
    let rolling = |wanted: f64| {
        let drive = Drive::Imposed { profile: falls.to_vec(), against: ImposedAgainst::Ground };
        let duration = Duration::Revolutions(wanted);
        let block = BlockMotion::Mounts;
        on_mounts.run(&Simulation { drive, duration, block, ..Simulation::imposed(1.0, 1.0) }, None)
    };
    let refused = rolling(100.0 / TAU - 0.01).expect_err("its roll may bring it to a stand before");
    assert!(matches!(refused, MultibodyError::StandsStill { .. }), "{refused}");
    assert_eq!(rolling(100.0 / TAU - 0.1).expect("it gets there").outcome, RunOutcome::Complete);
    // A pause between two speeds counts by its samples, the turning by its evaluations.
    let pauses = [[0.0, 100.0], [1.0, 0.0], [1e6, 0.0], [1e6 + 1.0, 100.0]];
    for duration in [Duration::Revolutions(10.0), Duration::Time(1e6 + 1.0)] {
        let refused = run(&pauses, duration).expect_err("it waits for days");
        let MultibodyError::TooLong { samples, .. } = refused else { panic!("{refused}") };
        assert!((samples / (5e6 / (PI / 180.0)) - 1.0).abs() < 1e-4, "{samples}");
    }
    let short = run(&pauses, Duration::Revolutions(5.0)).expect("before the pause");
    assert_eq!(short.outcome, RunOutcome::Complete);
    // Over a time it may stand.
    let stands = run(&falls, Duration::Time(2.0)).expect("a time ends");
    assert_eq!(stands.outcome, RunOutcome::Complete);
    let left = 100.0 - stands.samples.theta.last().unwrap();
    assert!(left.abs() < PI / 180.0, "{left}");
}

#[test]
fn what_is_missing_is_named() {
    let mut engine = engine("bare", vec![throw(0.0, 0.0)], vec![support::cylinder(0, 0.0, 0.0)]);
    let train = Train::new(&engine, &RotorInertia::of(&engine.rotating_bodies(&[]))).expect("it turns");
    let refused = train.run(&Simulation::free(100.0, 1.0), None).expect_err("no inertia");
    assert!(refused.to_string().contains("[flywheel]"), "{refused}");
    let on_mounts = Simulation { block: BlockMotion::Mounts, ..Simulation::imposed(100.0, 1.0) };
    let refused = train.run(&on_mounts, None).expect_err("no block");
    assert!(refused.to_string().contains("[block]"), "{refused}");
    let refused = train.run(&Simulation::imposed(100.0, 1.0), Some(&gas(1.0))).expect_err("no bore");
    assert!(refused.to_string().contains("bore"), "{refused}");
    engine = engine
        .with(|engine| {
            engine.block = fired(1).block.clone().map(|block| Block { mass: 1.0, ..block });
        })
        .unwrap();
    let refused =
        Train::new(&engine, &RotorInertia::of(&engine.rotating_bodies(&[]))).expect_err("too small");
    assert!(refused.to_string().contains("cylinder 1"), "{refused}");
    let few = Simulation { most_evaluations: 500, ..Simulation::imposed(100.0, 1000.0) };
    let refused = train.run(&few, None).expect_err("it would take too long");
    assert!(matches!(refused, MultibodyError::TooLong { .. }), "{refused}");
    let few = Simulation { most_evaluations: 500, tolerance: 1e-12, ..Simulation::imposed(100.0, 3.0) };
    let cut = train.run(&few, None).expect("it starts");
    assert_eq!(cut.outcome, RunOutcome::TooManyEvaluations);
    assert!(cut.samples.time.len() > 10);
}
