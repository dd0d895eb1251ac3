//! A run that is advanced from call to call: against one run of the same engine, and against itself from a saved state.

use crate::runs::{fired, gas, mean_torque, train};
use lanchester_multibody::*;
use std::f64::consts::TAU;

/// Advances in pieces of `piece` [s] until `end`; everything that happened.
fn advance(stepper: &mut Stepper<'_>, end: f64, piece: f64) -> Vec<Happened> {
    let start = stepper.time();
    let count = ((end - start) / piece).round() as u32;
    let mut all = Vec::new();
    for k in 1..=count {
        let to = start + (end - start) * f64::from(k) / f64::from(count);
        let found = stepper.advance(to).expect("the time lies ahead");
        assert_eq!(found.outcome, RunOutcome::Complete);
        assert_eq!(stepper.time(), to);
        all.extend(found.happened);
    }
    all
}

fn for_time(simulation: Simulation, time: f64) -> Simulation {
    Simulation { duration: Duration::Time(time), ..simulation }
}

/// Ten revolutions and more, fixed and on mounts, in pieces far shorter than the steps, about as long, and longer: the error of speed and angle stays within ten times the tolerance.
#[test]
fn pieces_of_any_length_are_one_run() {
    let train = train(&fired(4));
    let gas = gas(2.2);
    let full = mean_torque(&train, &gas);
    for block in [BlockMotion::Fixed, BlockMotion::Mounts] {
        let mut simulation = Simulation { block, gravity: 9.81, ..Simulation::free(250.0, 1.0) };
        simulation.load.law = LoadLaw::Quadratic { torque: full, at: 240.0 };
        let end = 0.3;
        let exact = Simulation { tolerance: 1e-13, ..for_time(simulation.clone(), end) };
        let exact = train.run(&exact, Some(&gas)).expect("it runs").end;
        assert!(exact[1] > 10.0 * TAU);
        for tolerance in [1e-7, 1e-9, 1e-11] {
            let simulation = Simulation { tolerance, ..simulation.clone() };
            let run = train.run(&for_time(simulation.clone(), end), Some(&gas)).expect("it runs").end;
            for piece in [1e-4, 1e-3, 1.7e-3, 0.02, 0.3] {
                let mut stepper = Stepper::new(&train, &simulation, Some(&gas), StepInputs::default())
                    .expect("it can be stepped");
                advance(&mut stepper, end, piece);
                let own = [stepper.time(), stepper.angle(), stepper.speed()];
                for other in [run, exact] {
                    assert!((own[0] - other[0]).abs() < 1e-14);
                    for k in [1, 2] {
                        let off = (own[k] / other[k] - 1.0).abs();
                        assert!(off < 10.0 * tolerance, "{block:?} {tolerance:e} {piece}: {k} {off:e}");
                    }
                }
            }
        }
    }
}

/// A sealed single falls below 5 rad/s at every compression and rises beyond 6 rad/s between: the independent variable goes from angle to time and back within and between the calls.
#[test]
fn the_independent_variable_changes_on_the_way() {
    let mut train = train(&fired(1));
    train.rotors[0].inertia = 12.0;
    let gas = gas(1.0);
    let simulation = Simulation { tolerance: 1e-10, ..Simulation::free(4.5, 1.0) };
    let end = 6.0;
    let run = train.run(&for_time(simulation.clone(), end), Some(&gas)).expect("it runs");
    let exact = Simulation { tolerance: 1e-13, ..for_time(simulation.clone(), end) };
    let exact = train.run(&exact, Some(&gas)).expect("it runs").end;
    let speeds = || run.samples.speed.iter().copied();
    let (least, most) = (speeds().fold(f64::INFINITY, f64::min), speeds().fold(0.0, f64::max));
    assert!(least < 4.9 && least > 0.5 && most > 6.1, "{least} {most}");
    let falls = run.samples.speed.windows(2).filter(|pair| pair[0] >= 5.0 && pair[1] < 5.0).count();
    assert!(falls >= 2, "{falls}");
    for piece in [1e-3, 0.0137] {
        let mut stepper =
            Stepper::new(&train, &simulation, Some(&gas), StepInputs::default()).expect("it can be stepped");
        advance(&mut stepper, end, piece);
        for (own, wanted) in [(stepper.angle(), exact[1]), (stepper.speed(), exact[2])] {
            assert!((own / wanted - 1.0).abs() < 10.0 * 1e-10, "{piece}: {own} {wanted}");
        }
    }
}

/// Friction brings the crank to rest, where it stays through calls; a torque from outside below the friction does not move it, one above does, in its own sense.
#[test]
fn a_run_down_ends_at_rest_until_a_torque_moves_it() {
    let train = train(&fired(2));
    let gas = gas(1.0);
    let friction_torque = 12.0;
    let simulation = Simulation { friction_torque, ..Simulation::free(40.0, 1.0) };
    let run = train.run(&for_time(simulation.clone(), 60.0), Some(&gas)).expect("it runs");
    let RunOutcome::AtRest { theta, .. } = run.outcome else { panic!("{:?}", run.outcome) };
    let held = run.events.last().expect("it is held");
    assert_eq!(held.what, Occasion::Held);
    let mut stepper =
        Stepper::new(&train, &simulation, Some(&gas), StepInputs::default()).expect("it can be stepped");
    let until = (held.time + 0.5).ceil();
    let found = advance(&mut stepper, until, 1e-3);
    assert_eq!(
        found.iter().map(|own| own.what).collect::<Vec<_>>(),
        run.events.iter().map(|own| own.what).collect::<Vec<_>>()
    );
    let last = found.last().expect("it is held");
    assert!((last.time - held.time).abs() < 1e-7, "{} {}", last.time, held.time);
    assert!((stepper.angle() - theta).abs() < 1e-7, "{} {theta}", stepper.angle());
    assert_eq!(stepper.speed(), 0.0);
    let rests_at = stepper.angle();
    for load in [0.5, -0.5] {
        stepper.set_inputs(StepInputs { load, ..StepInputs::default() }).expect("it is a torque");
        assert_eq!(stepper.advance(stepper.time() + 0.1).expect("it goes on").happened, []);
        assert_eq!((stepper.angle(), stepper.speed()), (rests_at, 0.0));
    }
    let saved = stepper.save();
    for load in [60.0, -60.0] {
        stepper.restore(&saved).expect("its own state");
        stepper.set_inputs(StepInputs { load, ..StepInputs::default() }).expect("it is a torque");
        let found = stepper.advance(stepper.time() + 0.05).expect("it goes on");
        assert_eq!(found.happened.first().map(|own| own.what), Some(Occasion::Released));
        assert!((stepper.angle() - rests_at) * load < 0.0, "{load}: {}", stepper.angle() - rests_at);
    }
}

/// A torque that is set between two calls acts as the event of a list that changes the load then; so does the fuel.
#[test]
fn inputs_between_calls_act_as_events_do() {
    let train = train(&fired(4));
    let gas = gas(2.2);
    let full = mean_torque(&train, &gas);
    let mut simulation = Simulation { block: BlockMotion::Mounts, ..Simulation::free(200.0, 1.0) };
    simulation.load.law = LoadLaw::Constant(0.4 * full);
    let mut with_events = for_time(simulation.clone(), 0.2);
    with_events.events = vec![
        Event { when: When::Time(0.05), action: Action::Load(LoadLaw::Constant(0.9 * full)) },
        Event { when: When::Time(0.12), action: Action::Fuel(0.5) },
    ];
    let wanted = train.run(&with_events, Some(&gas)).expect("it runs").end;
    let mut stepper =
        Stepper::new(&train, &simulation, Some(&gas), StepInputs::default()).expect("it can be stepped");
    advance(&mut stepper, 0.05, 1e-3);
    stepper.set_inputs(StepInputs { load: 0.5 * full, fuel: 1.0 }).expect("they are numbers");
    advance(&mut stepper, 0.12, 1e-3);
    stepper.set_inputs(StepInputs { load: 0.5 * full, fuel: 0.5 }).expect("they are numbers");
    advance(&mut stepper, 0.2, 1e-3);
    for (own, wanted) in [(stepper.angle(), wanted[1]), (stepper.speed(), wanted[2])] {
        assert!((own / wanted - 1.0).abs() < 10.0 * 1e-9, "{own} {wanted}");
    }
    let torque = stepper.sample().load_torque[0];
    assert!((torque / -(0.9 * full) - 1.0).abs() < 1e-12, "{torque}");
}

/// The torque from outside sits where the load sits: behind a driveline, and its reaction on the block or the ground.
#[test]
fn a_torque_from_outside_is_a_load() {
    let train = train(&fired(4));
    for reacts_on in [ReactsOn::Ground, ReactsOn::Block] {
        let mut simulation = Simulation { block: BlockMotion::Mounts, ..Simulation::free(180.0, 1.0) };
        simulation.driveline =
            vec![DrivelineInertia { inertia: 0.3, stiffness: 900.0, damping: 0.5, ratio: 0.5 }];
        let mut loaded = for_time(simulation.clone(), 0.1);
        loaded.load = Load { law: LoadLaw::Constant(25.0), reacts_on };
        simulation.load.reacts_on = reacts_on;
        let wanted = train.run(&loaded, None).expect("it runs").samples;
        let inputs = StepInputs { load: 25.0, ..StepInputs::default() };
        let mut stepper = Stepper::new(&train, &simulation, None, inputs).expect("it can be stepped");
        advance(&mut stepper, 0.1, 0.01);
        let own = stepper.sample();
        let last = wanted.time.len() - 1;
        // The last sample of the run over a time is up to one step of angle before its end.
        let again = Simulation { step: 1e9, ..for_time(simulation.clone(), wanted.time[last]) };
        let mut again = Stepper::new(&train, &again, None, inputs).expect("it can be stepped");
        advance(&mut again, wanted.time[last], 0.01);
        let there = again.sample();
        assert!((there.speed[0] / wanted.speed[last] - 1.0).abs() < 1e-8);
        for k in 0..3 {
            assert!((there.mounts[0][0][k] - wanted.mounts[last][0][k]).abs() < 1e-5);
            assert!((there.spin[0][k] - wanted.spin[last][k]).abs() < 1e-8);
        }
        assert_eq!(own.load_torque, [-25.0]);
        assert!(own.driveline_torque[0] != 0.0);
    }
}

/// The events of the list come within calls; `stop` ends a call early, and the next one goes on.
#[test]
fn events_of_the_list_come_within_calls() {
    let train = train(&fired(4));
    let gas = gas(2.2);
    let mut simulation = Simulation { tolerance: 1e-10, ..Simulation::free(150.0, 1.0) };
    simulation.events = vec![
        Event { when: When::Time(0.0213), action: Action::Misfire(1) },
        Event { when: When::SpeedRises(160.0), action: Action::Load(LoadLaw::Constant(30.0)) },
        Event { when: When::Angle(2.0 * TAU), action: Action::Stop },
    ];
    let run = train.run(&for_time(simulation.clone(), 1.0), Some(&gas)).expect("it runs");
    assert_eq!(run.outcome, RunOutcome::Stopped);
    let mut stepper =
        Stepper::new(&train, &simulation, Some(&gas), StepInputs::default()).expect("it can be stepped");
    let mut found = Vec::new();
    let outcome = loop {
        let own = stepper.advance(stepper.time() + 2e-3).expect("it goes on");
        found.extend(own.happened);
        if own.outcome != RunOutcome::Complete {
            break own.outcome;
        }
    };
    assert_eq!(outcome, RunOutcome::Stopped);
    assert_eq!(found.len(), run.events.len());
    for (own, wanted) in found.iter().zip(&run.events) {
        assert_eq!(own.what, wanted.what);
        assert!((own.time - wanted.time).abs() < 1e-9 && (own.theta - wanted.theta).abs() < 1e-7);
    }
    assert!((stepper.angle() - 2.0 * TAU).abs() < 1e-9);
    let later = stepper.time() + 0.01;
    assert_eq!(stepper.advance(later).expect("it goes on").outcome, RunOutcome::Complete);
}

/// From a saved state the same calls give the same bits, in the same stepper and in a new one, through a governor with a dead time, its past included, and the switch of the independent variable.
#[test]
fn a_saved_state_repeats_every_bit() {
    let mut train = train(&fired(4));
    train.rotors[0].inertia = 2.0;
    let gas = gas(2.2);
    let full = mean_torque(&train, &gas);
    let mut simulation = Simulation { block: BlockMotion::Mounts, ..Simulation::free(157.0, 1.0) };
    simulation.governor = Some(Governor {
        speed: 157.0,
        gain: 0.03,
        integral: 2.0,
        droop: 0.04,
        delay: 0.03,
        lag: 0.01,
        start: 0.3,
    });
    simulation.events = vec![Event { when: When::Time(0.17), action: Action::Misfire(2) }];
    let inputs = |k: u32| StepInputs { load: full * f64::from(k % 3) / 2.0, fuel: 1.0 };
    let mut stepper = Stepper::new(&train, &simulation, Some(&gas), inputs(1)).expect("it can be stepped");
    let go = |stepper: &mut Stepper<'_>| -> Vec<(StepperState, Samples)> {
        let step = |k: u32| {
            stepper.set_inputs(inputs(k / 20)).expect("they are numbers");
            let to = stepper.time() + 1.3e-3;
            assert_eq!(stepper.advance(to).expect("it goes on").outcome, RunOutcome::Complete);
            (stepper.save(), stepper.sample())
        };
        (0..120).map(step).collect()
    };
    advance(&mut stepper, 0.1, 1e-3);
    let saved = stepper.save();
    let first = go(&mut stepper);
    stepper.restore(&saved).expect("its own state");
    assert_eq!(stepper.save(), saved);
    assert_eq!(go(&mut stepper), first);
    let mut other = Stepper::resume(&train, &simulation, Some(&gas), saved).expect("a state of this run");
    assert_eq!(go(&mut other), first);
    assert!(first.iter().any(|(_, own)| (own.governor[0] - 0.3).abs() > 0.01), "the governor acts");
    assert_eq!(other.into_state(), first[119].0);
}

/// With a governor that has a dead time calls are one run too.
#[test]
fn a_dead_time_lives_through_calls() {
    let mut train = train(&fired(4));
    train.rotors[0].inertia = 2.0;
    let gas = gas(2.2);
    let full = mean_torque(&train, &gas);
    let mut simulation = Simulation { tolerance: 1e-8, ..Simulation::free(157.0, 1.0) };
    simulation.load.law = LoadLaw::Constant(0.5 * full);
    simulation.governor = Some(Governor {
        speed: 157.0,
        gain: 0.03,
        integral: 2.0,
        droop: 0.04,
        delay: 0.03,
        lag: 0.0,
        start: 0.3,
    });
    let exact = Simulation { tolerance: 1e-12, ..for_time(simulation.clone(), 0.5) };
    let exact = train.run(&exact, Some(&gas)).expect("it runs").end;
    let mut stepper =
        Stepper::new(&train, &simulation, Some(&gas), StepInputs::default()).expect("it can be stepped");
    advance(&mut stepper, 0.5, 1e-3);
    for (own, wanted) in [(stepper.angle(), exact[1]), (stepper.speed(), exact[2])] {
        assert!((own / wanted - 1.0).abs() < 10.0 * 1e-8, "{own} {wanted}");
    }
}

/// What cannot be is refused; a call that fails leaves the stepper where it was, and the next one may succeed.
#[test]
fn a_call_that_fails_changes_nothing() {
    let train = train(&fired(4));
    let gas = gas(2.2);
    let simulation = Simulation { most_evaluations: 400, ..Simulation::free(200.0, 1.0) };
    let none = StepInputs::default();
    for inputs in [
        StepInputs { load: f64::NAN, ..none },
        StepInputs { load: f64::INFINITY, ..none },
        StepInputs { fuel: 1.1, ..none },
        StepInputs { fuel: f64::NAN, ..none },
    ] {
        assert!(Stepper::new(&train, &simulation, Some(&gas), inputs).is_err());
    }
    let mut stepper = Stepper::new(&train, &simulation, Some(&gas), none).expect("it can be stepped");
    assert!(stepper.set_inputs(StepInputs { fuel: -0.1, ..none }).is_err());
    assert_eq!(stepper.advance(0.005).expect("it goes on").outcome, RunOutcome::Complete);
    for to in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(stepper.advance(to).is_err(), "{to}");
    }
    let before = stepper.save();
    // The limit holds for every call.
    let found = stepper.advance(10.0).expect("the time lies ahead");
    assert_eq!(found.outcome, RunOutcome::TooManyEvaluations);
    assert!(found.cost.evaluations <= 400);
    assert_eq!(stepper.save(), before);
    for k in 1..200 {
        let found = stepper.advance(0.005 + 0.005 * f64::from(k)).expect("the time lies ahead");
        assert_eq!(found.outcome, RunOutcome::Complete);
    }
    // A torque beyond all bounds cannot be integrated.
    let before = stepper.save();
    stepper.set_inputs(StepInputs { load: -1e300, ..none }).expect("it is a number");
    let found = stepper.advance(stepper.time() + 0.01).expect("the time lies ahead");
    assert!(!matches!(found.outcome, RunOutcome::Complete | RunOutcome::Stopped), "{:?}", found.outcome);
    stepper.restore(&before).expect("its own state");
    assert_eq!(stepper.advance(stepper.time() + 0.01).expect("it goes on").outcome, RunOutcome::Complete);
    // A state of an engine with another block.
    let other = Simulation { block: BlockMotion::Mounts, ..simulation.clone() };
    let mut other = Stepper::new(&train, &other, Some(&gas), none).expect("it can be stepped");
    assert!(matches!(other.restore(&before), Err(MultibodyError::ForeignState { .. })));
    assert!(matches!(
        Stepper::resume(&train, &simulation, Some(&gas), other.save()),
        Err(MultibodyError::ForeignState { .. })
    ));
}

/// An event may move a crank that friction holds, in a run as in calls.
#[test]
fn an_event_moves_a_crank_that_is_held() {
    let train = train(&fired(4));
    let drives = LoadLaw::Angle { period: TAU, points: vec![[0.0, -50.0]] };
    let mut simulation =
        Simulation { friction_torque: 12.0, block: BlockMotion::Mounts, ..Simulation::free(0.0, 1.0) };
    simulation.events = vec![Event { when: When::Time(0.3), action: Action::Load(drives) }];
    let run = train.run(&for_time(simulation.clone(), 0.5), None).expect("it runs");
    let occasions: Vec<Occasion> = run.events.iter().map(|own| own.what).collect();
    assert_eq!(occasions, [Occasion::Held, Occasion::Event { index: 0 }, Occasion::Released]);
    assert!(run.end[2] > 5.0, "{:?}", run.end);
    let mut stepper =
        Stepper::new(&train, &simulation, None, StepInputs::default()).expect("it can be stepped");
    advance(&mut stepper, 0.5, 0.01);
    assert!((stepper.speed() / run.end[2] - 1.0).abs() < 1e-8, "{} {:?}", stepper.speed(), run.end);
}
