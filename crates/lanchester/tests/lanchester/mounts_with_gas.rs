//! Forces at mounts on springs with the torque of the gas, over the range of speeds, as criteria and limits.

use lanchester::balance::{Answer, BalanceSettings, Next, Outcome, fitted};
use lanchester::model::{Engine, EngineParts, SpeedRange};
use lanchester::task::{BalanceTask, Criterion, Limit, Load, Stage, criterion, criterion_name, default_task};
use lanchester::{MountSpeeds, mounts, optimised};

fn read(text: &str) -> Engine {
    lanchester::file::read(text).engine().expect("the example has no mistakes")
}

fn four() -> Engine {
    read(include_str!("../../../../examples/in-line-4-mounts.toml"))
}

const LARGEST: Criterion = Criterion::Peak(Load::LargestMountForceWithGas);

/// Weights on the crank and on a pair of shafts beside it at twice its speed, which can answer part of the torque.
fn free(engine: &Engine, criterion: Criterion) -> BalanceTask {
    let mut task = BalanceTask { limits: Vec::new(), ..default_task(engine) };
    for shaft in ["2 @ 40 mm, 90 mm @ 0 mm", "-2 @ -30 mm, -90 mm @ 0 mm"] {
        task.add_shaft(shaft, "shaft").expect("it is a shaft");
    }
    task.stages = vec![Stage { terms: vec![(1.0, criterion)] }];
    task
}

fn asked(engine: &Engine, task: &BalanceTask) -> Answer {
    optimised(engine, Ok(&[]), task, &BalanceSettings::default(), &|_| Next::Continue).expect("an answer")
}

fn grid(engine: &Engine, count: u32) -> Vec<f64> {
    let SpeedRange { lowest, highest } = engine.speed;
    (0..=count).map(|k| lowest + (highest - lowest) * f64::from(k) / f64::from(count)).collect()
}

/// Largest force at any mount of `of` at each speed, by the mounts themselves.
fn response(engine: &Engine, speeds: &[f64], of: Option<usize>) -> Vec<f64> {
    let study = mounts(engine, &MountSpeeds::List(speeds.to_vec()), 96, Some(&[]), &[]).expect("it is held");
    let largest = |peaks: &[lanchester::results::Extreme]| match of {
        Some(mount) => peaks[mount].value,
        None => peaks.iter().map(|peak| peak.value).fold(0.0, f64::max),
    };
    study.response.speeds.iter().map(|at| largest(&at.peaks)).collect()
}

fn highest(forces: Vec<f64>) -> f64 {
    forces.into_iter().fold(0.0, f64::max)
}

#[test]
fn the_least_force_of_inertia_and_gas_over_the_range() {
    let four = four();
    for (criterion, mount) in [(LARGEST, None), (Criterion::Peak(Load::MountForceWithGas(1)), Some(1))] {
        let answer = asked(&four, &free(&four, criterion));
        assert_eq!(answer.outcome, Outcome::Optimal);
        let stage = &answer.stages[0];
        assert!(stage.gap >= 0.0 && stage.gap <= 2e-6 * stage.value, "{stage:?}");
        let told = answer.mount_gas_speeds.as_ref().expect("it is judged over a range");
        assert!(told.range && told.excess <= 1e-6 && answer.mount_speeds.is_none(), "{told:?}");
        // No speed passes it, and it is reached where the answer says.
        let best = fitted(&four, &answer);
        let over = highest(response(&best, &grid(&four, 600), mount));
        assert!(over <= stage.value * (1.0 + 1e-5), "{over} N beside {stage:?}");
        let there = response(&best, &[told.worst], mount)[0];
        assert!((there - stage.value).abs() < 1e-5 * there, "{there} N beside {stage:?}");
        let effect = answer.effects.iter().find(|one| one.criterion == criterion).expect("it is told");
        let before = highest(response(&four, &grid(&four, 600), mount));
        assert!(
            effect.before >= before * (1.0 - 1e-5) && effect.before < 1.01 * before,
            "{before} {effect:?}"
        );
        assert!(stage.value < 0.99 * before, "{before} N beside {stage:?}");
        // Others near the best do no better.
        for trial in 0..16 {
            let mut other = best.clone();
            let turn = |k: usize| f64::from(trial) * 1.7 + k as f64 * 2.3;
            other = other
                .with(|other| {
                    for (k, weight) in other.counterweights.iter_mut().enumerate() {
                        weight.unbalance *= 1.0 + 0.1 * turn(k).sin();
                        weight.angle += 0.1 * turn(k).cos();
                    }

                    for (k, weight) in
                        other.shafts.iter_mut().flat_map(|shaft| &mut shaft.weights).enumerate()
                    {
                        weight.unbalance *= 1.0 + 0.1 * turn(k + 3).sin();
                        weight.phase += 0.1 * turn(k + 5).cos();
                    }
                })
                .unwrap();
            let theirs = highest(response(&other, &grid(&four, 150), mount));
            assert!(theirs >= stage.lower_bound * (1.0 - 1e-6), "{trial}: {theirs} N beside {stage:?}");
        }
    }
}

/// Inertia alone is another question: at idle the gas turns the block far more.
#[test]
fn without_the_words_the_gas_is_left_out() {
    let four = four();
    let alone = Criterion::Peak(Load::LargestMountForce);
    let answer = asked(&four, &free(&four, alone));
    assert!(answer.mount_gas_speeds.is_none() && answer.mount_speeds.is_some());
    let with_gas = asked(&four, &free(&four, LARGEST));
    assert!(answer.stages[0].value < 0.5 * with_gas.stages[0].value);
    let of_alone = highest(response(&fitted(&four, &answer), &grid(&four, 300), None));
    assert!(of_alone > with_gas.stages[0].value, "{of_alone} N");
}

#[test]
fn an_order_and_a_limit_with_gas() {
    let four = four();
    let second = criterion("mount force torque rod with gas order 2", &four).expect("it is one");
    assert_eq!(criterion_name(&second, &four), "mount force torque rod with gas order 2");
    let answer = asked(&four, &free(&four, second));
    let best = fitted(&four, &answer);
    let study = mounts(&best, &MountSpeeds::List(grid(&four, 300)), 8, Some(&[]), &[]).expect("it is held");
    let of_second = |at: &lanchester::mechanism::SpeedResponse| {
        let order = at.orders.iter().find(|one| one.order == 2.0).expect("it is listed");
        lanchester::mechanism::vector_amplitude(&order.forces[2])
    };
    let over = highest(study.response.speeds.iter().map(of_second).collect());
    let value = answer.stages[0].value;
    assert!(over <= value * (1.0 + 1e-6) && over > 0.98 * value, "{over} N beside {value} N");

    let least = asked(&four, &free(&four, LARGEST)).stages[0].value;
    let limited = |most: f64| {
        let limits = vec![Limit { criterion: LARGEST, most }];
        asked(&four, &BalanceTask { limits, ..free(&four, Criterion::AddedUnbalance) })
    };
    let held = limited(1.03 * least);
    assert_eq!(held.outcome, Outcome::Optimal);
    let there = highest(response(&fitted(&four, &held), &grid(&four, 300), None));
    assert!(there <= 1.03 * least * (1.0 + 1e-5), "{there} N beside {least} N");
    let Outcome::Infeasible { relaxation, .. } = limited(0.9 * least).outcome else { panic!("it holds") };
    assert!((relaxation - 1.0 / 0.9).abs() < 0.005, "{relaxation}");
}

/// A computed cycle is another one at every speed: at the speeds where it is computed the mounts have what they are judged by.
#[test]
fn a_computed_cycle_is_interpolated_between_its_speeds() {
    let single = read(include_str!("../../../../examples/single-gas.toml"));
    let EngineParts { block, mounts: places, .. } = four().into_parts();
    let engine = single
        .with(|parts| {
            parts.block = block;
            parts.mounts = places;
        })
        .unwrap();
    let task = BalanceTask {
        stages: vec![Stage { terms: vec![(1.0, LARGEST)] }],
        limits: Vec::new(),
        ..default_task(&engine)
    };
    let answer = asked(&engine, &task);
    let stage = &answer.stages[0];
    assert!(stage.gap >= 0.0 && stage.gap <= 2e-6 * stage.value, "{stage:?}");
    let best = fitted(&engine, &answer);
    let at_steps = response(&best, &grid(&engine, 12), None);
    assert!(highest(at_steps) <= stage.value * (1.0 + 1e-5));
    let told = answer.mount_gas_speeds.expect("it is judged over a range");
    let there = response(&best, &[told.worst], None)[0];
    assert!((there - stage.value).abs() < 0.01 * there, "{there} N beside {stage:?}");
}

#[test]
fn what_is_missing_is_told() {
    let four = four();
    let refused = |engine: &Engine| {
        let task =
            BalanceTask { stages: vec![Stage { terms: vec![(1.0, LARGEST)] }], ..default_task(engine) };
        let found = optimised(engine, Ok(&[]), &task, &BalanceSettings::default(), &|_| Next::Continue);
        found.expect_err("it is refused").to_string()
    };
    let without_gas = refused(&four.with(|parts| parts.gas = None).unwrap());
    assert!(
        without_gas.contains("mount force with gas") && without_gas.contains("add [gas]"),
        "{without_gas}"
    );
    let mut stiff = four.clone();
    stiff = stiff
        .with(|stiff| {
            stiff.mounts.iter_mut().for_each(|mount| mount.spring = None);
        })
        .unwrap();
    let stiff = refused(&stiff);
    assert!(stiff.contains("stiffness to every [[mount]]"), "{stiff}");
    let none = refused(&four.with(|parts| parts.mounts = Vec::new()).unwrap());
    assert!(none.contains("[[mount]]"), "{none}");
}
