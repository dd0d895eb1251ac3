//! The governor: droop, dead time, lag.

use crate::runs::{fired, gas, mean_torque, train};
use lanchester_multibody::*;
use std::f64::consts::{FRAC_PI_2, TAU};

#[test]
fn a_governor_settles_within_its_droop_after_a_load_step() {
    let mut train = train(&fired(4));
    // A heavy wheel: the governor is not to answer to single firings.
    train.rotors[0].inertia = 4.0;
    let gas = gas(2.2);
    let full = mean_torque(&train, &gas);
    let mut simulation = Simulation { tolerance: 1e-8, step: 0.1, ..Simulation::free(157.0, 1.0) };
    simulation.duration = Duration::Time(16.0);
    simulation.load.law = LoadLaw::Constant(0.3 * full);
    let governor =
        Governor { speed: 157.0, gain: 0.05, integral: 2.0, droop: 0.04, delay: 0.0, lag: 0.02, start: 0.3 };
    simulation.governor = Some(governor);
    simulation.events =
        vec![Event { when: When::Time(4.0), action: Action::Load(LoadLaw::Constant(0.7 * full)) }];
    let run = train.run(&simulation, Some(&gas)).expect("it runs");
    assert_eq!(run.outcome, RunOutcome::Complete);
    let mean = |from: f64| {
        let picked: Vec<f64> = run
            .samples
            .time
            .iter()
            .zip(&run.samples.speed)
            .filter(|(t, _)| **t > from && **t < from + 1.0)
            .map(|(_, w)| *w)
            .collect();
        picked.iter().sum::<f64>() / picked.len() as f64
    };
    let [before, after] = [mean(2.9), mean(14.9)];
    // With droop, the speed falls by the droop times the share of the load.
    assert!((before / (157.0 * (1.0 - 0.04 * 0.3)) - 1.0).abs() < 0.004, "{before}");
    assert!((after / (157.0 * (1.0 - 0.04 * 0.7)) - 1.0).abs() < 0.004, "{after}");
    let lowest = run.samples.speed.iter().copied().fold(f64::INFINITY, f64::min);
    assert!(lowest < after - 1.0, "the step is felt: {lowest} {after}");
}

/// A run of a four with a heavy wheel, whose governor meets a load step.
fn governed(governor: Governor, time: f64, step: f64) -> Run {
    let mut train = train(&fired(4));
    train.rotors[0].inertia = 4.0;
    let gas = gas(2.2);
    let full = mean_torque(&train, &gas);
    let mut simulation = Simulation { step, ..Simulation::free(157.0, 1.0) };
    simulation.duration = Duration::Time(time);
    simulation.load.law = LoadLaw::Constant(0.3 * full);
    simulation.governor = Some(governor);
    simulation.events =
        vec![Event { when: When::Time(0.5 * time), action: Action::Load(LoadLaw::Constant(0.6 * full)) }];
    let run = train.run(&simulation, Some(&gas)).expect("it runs");
    assert_eq!(run.outcome, RunOutcome::Complete);
    run
}

/// Value at `t` between samples: the cubic through the four about it.
fn between(times: &[f64], values: &[f64], t: f64) -> f64 {
    let after = times.partition_point(|time| *time <= t).clamp(2, times.len() - 2);
    let near = after - 2..after + 2;
    let part = |k: usize| {
        let others = near.clone().filter(|j| *j != k);
        others.map(|j| (t - times[j]) / (times[k] - times[j])).product::<f64>() * values[k]
    };
    near.clone().map(part).sum()
}

/// With a dead time and without a lag the factor is what the governor wanted then, of the speed and the factor of then: from the samples alone. Before, it is that of the start.
#[test]
fn a_dead_time_brings_the_command_as_much_later() {
    for droop in [0.0, 0.04] {
        let governor =
            Governor { speed: 157.0, gain: 0.02, integral: 0.0, droop, delay: 0.0173, lag: 0.0, start: 0.3 };
        let run = governed(governor, 0.6, 0.01);
        let samples = &run.samples;
        let wanted: Vec<f64> = samples
            .governor
            .iter()
            .zip(&samples.speed)
            .map(|(u, w)| (0.02 * (157.0 * (1.0 - droop * u) - w) + 0.3).clamp(0.0, 1.0))
            .collect();
        let mut moved = 0.0f64;
        for (t, u) in samples.time.iter().zip(&samples.governor) {
            let then = t - 0.0173;
            // Beside the jumps, which the cubic would cross, it is asked for nothing.
            let jumps = (0..40).map(|k| 0.0173 * f64::from(k)).chain([0.3, 0.3173]);
            if jumps.clone().any(|jump| (then - jump).abs() < 3e-4) {
                continue;
            }
            let known = if then < 0.0 { 0.3 } else { between(&samples.time, &wanted, then) };
            moved = moved.max((known - 0.3).abs());
            assert!((u - known).abs() < 1e-6, "{t}: {u} {known}");
        }
        assert!(moved > 0.01, "it acts: {moved}");
    }
}

/// Both together: the factor follows what comes out of the dead time, by the lag.
#[test]
fn a_lag_follows_the_dead_time() {
    let governor = Governor {
        speed: 157.0,
        gain: 0.02,
        integral: 0.0,
        droop: 0.04,
        delay: 0.0173,
        lag: 0.011,
        start: 0.3,
    };
    let run = governed(governor, 0.6, 0.01);
    let Samples { time, speed, governor: factor, .. } = &run.samples;
    let wanted: Vec<f64> =
        factor.iter().zip(speed).map(|(u, w)| 0.02 * (157.0 * (1.0 - 0.04 * u) - w) + 0.3).collect();
    let mut checked = 0;
    for k in (2..time.len() - 2).step_by(7) {
        let then = time[k] - 0.0173;
        if then < 1e-3 {
            continue;
        }
        let rate = (factor[k + 1] - factor[k - 1]) / (time[k + 1] - time[k - 1]);
        let known = (between(time, &wanted, then).clamp(0.0, 1.0) - factor[k]) / 0.011;
        assert!((rate - known).abs() < 2e-3 * (1.0 + known.abs()), "{}: {rate} {known}", time[k]);
        checked += 1;
    }
    assert!(checked > 500);
}

/// A run does not depend on how its steps fall: a tighter tolerance gives the same speeds.
#[test]
fn a_dead_time_keeps_the_tolerance() {
    let governor =
        Governor { speed: 157.0, gain: 0.03, integral: 2.0, droop: 0.04, delay: 0.03, lag: 0.0, start: 0.3 };
    let mut train = train(&fired(4));
    train.rotors[0].inertia = 2.0;
    let gas = gas(2.2);
    let full = mean_torque(&train, &gas);
    let with = |tolerance: f64| {
        let mut simulation = Simulation { tolerance, step: 0.2, ..Simulation::free(157.0, 1.0) };
        simulation.duration = Duration::Time(0.8);
        simulation.load.law = LoadLaw::Constant(0.5 * full);
        simulation.governor = Some(governor);
        train.run(&simulation, Some(&gas)).expect("it runs")
    };
    let exact = with(1e-12);
    for tolerance in [1e-6, 1e-8, 1e-10] {
        let run = with(tolerance);
        let off = run.samples.speed.iter().zip(&exact.samples.speed).map(|(a, b)| (a / b - 1.0).abs());
        let off = off.fold(0.0, f64::max);
        assert!(off < 10.0 * tolerance, "{tolerance}: {off}");
    }
}

/// An integrating plant under a proportional governor with the dead time T is stable below the gain pi / (2 T): `w' = -K w(t - T)`.
#[test]
fn a_dead_time_bounds_the_gain() {
    let mut train = train(&fired(4));
    train.rotors[0].inertia = 4.0;
    let gas = gas(2.2);
    let full = mean_torque(&train, &gas);
    let delay = 1.0;
    let swing = |factor: f64| {
        // Small enough to keep off the ends of the fuel, and seen at one phase of the firing. From the fired part of the torque, which the mean is, and the inertia: K = gain torque / J.
        let gain = factor * FRAC_PI_2 / delay * 4.0 / full;
        let mut simulation = Simulation { tolerance: 1e-7, step: TAU, ..Simulation::free(157.1, 1.0) };
        simulation.duration = Duration::Time(20.0);
        simulation.load.law = LoadLaw::Constant(0.5 * full);
        let governor =
            Governor { speed: 157.0, gain, integral: 0.0, droop: 0.0, delay, lag: 0.0, start: 0.5 };
        simulation.governor = Some(governor);
        let run = train.run(&simulation, Some(&gas)).expect("it runs");
        let spread = |from: f64| {
            let picked = run.samples.time.iter().zip(&run.samples.speed);
            let picked = picked.filter(|(t, _)| **t > from && **t < from + 4.0).map(|(_, w)| *w);
            let (low, high) = picked.fold((f64::INFINITY, 0.0f64), |(l, h), w| (l.min(w), h.max(w)));
            high - low
        };
        spread(16.0) / spread(1.0)
    };
    let [calm, growing] = [swing(0.8), swing(1.25)];
    assert!(calm < 0.3 && growing > 3.0, "{calm} {growing}");
}

/// Neither dead time nor lag: the factor solves its own equation at once.
#[test]
fn without_dead_time_and_lag_it_answers_at_once() {
    let governor =
        Governor { speed: 157.0, gain: 0.02, integral: 0.0, droop: 0.04, delay: 0.0, lag: 0.0, start: 0.3 };
    let run = governed(governor, 0.4, 0.05);
    for (u, w) in run.samples.governor.iter().zip(&run.samples.speed) {
        let wanted = 0.02 * (157.0 * (1.0 - 0.04 * u) - w) + 0.3;
        assert!((u - wanted.clamp(0.0, 1.0)).abs() < 1e-12, "{u} {wanted}");
    }
}

/// The periodic motion under a governor, from a start that drives it to an end of its range: that to which a long run comes.
fn settles(delay: f64, gain: f64) {
    let mut train = train(&fired(4));
    train.rotors[0].inertia = 2.0;
    let gas = gas(2.2);
    let mut simulation = Simulation::free(175.0, 1.0);
    simulation.load.law = LoadLaw::Constant(0.5 * mean_torque(&train, &gas));
    simulation.step = 2.0 * TAU;
    simulation.tolerance = 1e-11;
    simulation.governor =
        Some(Governor { speed: 157.0, gain, integral: 2.0, droop: 0.04, delay, lag: 0.0, start: 0.3 });
    let found = train.periodic(&simulation, Some(&gas)).expect("it runs");
    assert_eq!(found.outcome, PeriodicOutcome::Stable, "{} {:?}", found.residual, found.followed);
    let followed = found.followed.expect("the start is far away");
    assert!(followed.periods >= 20 && !followed.came_to_rest && followed.speeds[0] == 175.0, "{followed:?}");
    let [first, last] = [found.run.samples.speed[0], found.run.end[2]];
    assert!((last / first - 1.0).abs() < 1e-9, "{first} {last}");
    simulation.duration = Duration::Time(130.0);
    let long = train.run(&simulation, Some(&gas)).expect("it runs");
    let settled = *long.samples.speed.last().expect("it has samples");
    assert!((settled / first - 1.0).abs() < 1e-7, "{delay}: {settled} {first}");
}

#[test]
fn the_periodic_motion_under_a_governor_is_that_to_which_a_run_comes() {
    settles(0.0, 0.05);
}

#[test]
fn with_a_dead_time_the_motion_is_followed_until_it_repeats() {
    settles(0.03, 0.03);
    // Longer than the period of 0.08 s.
    settles(0.1, 0.01);
}

/// More load than the engine carries: the run until it stands is shown. Less than it gives without a governor: the speed goes on rising.
#[test]
fn without_a_periodic_motion_what_happens_is_told() {
    let train = train(&fired(4));
    let gas = gas(1.8);
    let torque = mean_torque(&train, &gas);
    let with = |share: f64| {
        let mut simulation = Simulation::free(150.0, 1.0);
        simulation.load.law = LoadLaw::Constant(share * torque);
        train.periodic(&simulation, Some(&gas)).expect("it runs")
    };
    let stalled = with(1.5);
    let followed = stalled.followed.expect("it was followed");
    assert!(stalled.outcome == PeriodicOutcome::NotFound && followed.came_to_rest, "{followed:?}");
    assert!(
        matches!(stalled.run.outcome, RunOutcome::AtRest { .. }) && stalled.run.samples.speed[0] == 150.0
    );
    let rising = with(0.9);
    let followed = rising.followed.expect("it was followed");
    assert!(rising.outcome == PeriodicOutcome::NotFound && !followed.came_to_rest);
    let [start, before, last] = followed.speeds;
    assert!(start < before && before < last && rising.run.end[2] > last, "{followed:?}");
    assert!((rising.run.samples.speed[0] - last).abs() < 1e-9 * last);
}

/// A driveline too stiff for explicit steps is refused before the run.
#[test]
fn a_stiff_driveline_is_estimated_before_the_run() {
    let train = train(&fired(4));
    let mut simulation = Simulation::free(150.0, 10.0);
    let link = DrivelineInertia { inertia: 1e-6, stiffness: 1e9, damping: 0.0, ratio: 1.0 };
    simulation.driveline = vec![link];
    let error = train.run(&simulation, None).expect_err("it would take 10 million evaluations");
    assert!(matches!(error, MultibodyError::TooLong { evaluations, .. } if evaluations > 1e7), "{error}");
    simulation.driveline = vec![DrivelineInertia { inertia: 0.5, stiffness: 1e4, ..link }];
    let run = train.run(&simulation, None).expect("it runs");
    assert!(run.outcome == RunOutcome::Complete && run.cost.evaluations < 100_000, "{:?}", run.cost);
}

/// Tolerances by kind of state are stated, and one that is given counts.
#[test]
fn tolerances_are_by_kind_of_state() {
    let train = train(&fired(4));
    let mut simulation = Simulation { block: BlockMotion::Mounts, ..Simulation::free(150.0, 2.0) };
    let gas = gas(2.0);
    let plain = train.run(&simulation, Some(&gas)).expect("it runs");
    assert_eq!((plain.tolerances.relative, plain.tolerances.angle), (1e-9, 1e-9));
    assert!((plain.tolerances.speed / 150e-9 - 1.0).abs() < 1e-12);
    assert!((plain.tolerances.displacement / 1e-12 - 1.0).abs() < 1e-12);
    simulation.tolerances =
        StateTolerances { velocity: Some(1e-5), spin: Some(1e-5), ..StateTolerances::default() };
    let loose = train.run(&simulation, Some(&gas)).expect("it runs");
    assert_eq!((loose.tolerances.velocity, loose.tolerances.spin), (1e-5, 1e-5));
    assert!(loose.cost.steps < plain.cost.steps, "{} {}", loose.cost.steps, plain.cost.steps);
    simulation.tolerances.energy = Some(0.0);
    assert!(train.run(&simulation, Some(&gas)).is_err());
}
