//! Forces at mounts with springs over a range of speeds.

use super::mounts::{engine, task};
use lanchester_balance::{Answer, Outcome, fitted, optimise};
use lanchester_mechanism::{MountSystem, inertia_excitations};
use lanchester_model::{Engine, SpeedRange};
use lanchester_task::{BalanceTask, Criterion, Limit, Load, Stage};

/// The three on its mounts, whose resonances lie within its range.
fn soft() -> Engine {
    engine(1.5e6, 90.0)
        .with(|parts| parts.speed = SpeedRange { lowest: 50.0, highest: 420.0 })
        .expect("an engine")
}

fn largest() -> BalanceTask {
    task(Load::LargestMountForce)
}

/// Largest force at any mount at a speed, by the kernel of the response.
fn response(engine: &Engine, speeds: &[f64]) -> Vec<f64> {
    let excitations = inertia_excitations(engine, speeds, 24).expect("the engine is valid");
    let found =
        MountSystem::new(engine).and_then(|system| system.response(&excitations)).expect("it is held");
    found.speeds.iter().map(|at| at.peaks.iter().map(|peak| peak.value).fold(0.0, f64::max)).collect()
}

/// Proved over the range as far as its search goes.
fn assert_proved(answer: &Answer) {
    assert!(matches!(answer.outcome, Outcome::Optimal), "{:?}", answer.outcome);
    for stage in &answer.stages {
        assert!(stage.gap >= 0.0 && stage.gap < 2e-6 * stage.value, "{stage:?}");
    }
}

fn grid(engine: &Engine) -> Vec<f64> {
    let SpeedRange { lowest, highest } = engine.speed;
    (0..=4000).map(|k| lowest + (highest - lowest) * f64::from(k) / 4000.0).collect()
}

/// Nothing on a fine grid of speeds passes the value, which is reached at the speed that is told.
fn assert_over_the_range(engine: &Engine, answer: &Answer) -> f64 {
    assert_proved(answer);
    let told = answer.mount_speeds.as_ref().expect("mount forces are judged over a range");
    let stage = &answer.stages[0];
    let fitted = fitted(engine, answer);
    let highest = response(&fitted, &grid(engine)).into_iter().fold(0.0, f64::max);
    assert!(highest <= stage.value * (1.0 + 1e-6), "{highest} {stage:?}");
    let there = response(&fitted, &[told.worst])[0];
    assert!((there - stage.value).abs() < 2e-6 * stage.value, "{there} {} {told:?}", stage.value);
    assert!(told.range && told.excess <= 1e-6, "{told:?}");
    stage.value
}

#[test]
fn the_range_has_far_more_than_the_highest_speed() {
    let engine = soft();
    let answer = optimise(&engine, &largest()).expect("the engine is valid");
    let value = assert_over_the_range(&engine, &answer);
    let told = answer.mount_speeds.as_ref().expect("mount forces are judged over a range");
    assert!(told.worst < 0.9 * engine.speed.highest, "{told:?}");
    // Judged at the highest speed alone, they seem to leave a fraction of what the range has, and leave more of it.
    let speeds = vec![engine.speed.highest];
    let alone = optimise(&engine, &BalanceTask { speeds, ..largest() }).expect("the engine is valid");
    let of_alone = response(&fitted(&engine, &alone), &grid(&engine)).into_iter().fold(0.0, f64::max);
    assert!(of_alone > value * (1.0 + 1e-3) && alone.stages[0].value < 0.5 * of_alone, "{of_alone} {value}");
    let alone_told = alone.mount_speeds.expect("mount forces are judged");
    assert!(!alone_told.range && alone_told.worst == engine.speed.highest);
    // What the file has is told over the range too.
    let effect = answer.effects.iter().find(|e| e.criterion == Criterion::Peak(Load::LargestMountForce));
    let before = effect.expect("the stage is told").before;
    let standing = response(&engine, &grid(&engine)).into_iter().fold(0.0, f64::max);
    assert!(
        (before - standing).abs() < 1e-3 * standing && before >= standing * (1.0 - 1e-9),
        "{before} {standing}"
    );
}

#[test]
fn one_mount_and_one_order_over_the_range() {
    let engine = soft();
    let one = optimise(&engine, &task(Load::MountForce(1))).expect("the engine is valid");
    assert_proved(&one);
    let all = optimise(&engine, &largest()).expect("the engine is valid");
    assert!(one.stages[0].value <= all.stages[0].value * (1.0 + 1e-6));
    let first = Criterion::Order(Load::MountForce(1), 1.0);
    let asked = BalanceTask { stages: vec![Stage { terms: vec![(1.0, first)] }], ..largest() };
    let order = optimise(&engine, &asked).expect("the engine is valid");
    assert!(order.stages[0].value <= one.stages[0].value * (1.0 + 1e-6) && order.mount_speeds.is_some());
}

#[test]
fn a_limit_holds_at_every_speed_of_the_range() {
    let engine = soft();
    let least = optimise(&engine, &largest()).expect("the engine is valid").stages[0].value;
    let limited = |most: f64| {
        let criterion = Criterion::Peak(Load::LargestMountForce);
        let task = BalanceTask { limits: vec![Limit { criterion, most }], ..task(Load::Couple) };
        optimise(&engine, &task).expect("the engine is valid")
    };
    let held = limited(1.3 * least);
    assert!(matches!(held.outcome, Outcome::Optimal), "{:?}", held.outcome);
    let there = response(&fitted(&engine, &held), &grid(&engine)).into_iter().fold(0.0, f64::max);
    assert!(there <= 1.3 * least * (1.0 + 1e-6), "{there} {least}");
    let refused = limited(0.8 * least);
    let Outcome::Infeasible { relaxation, .. } = refused.outcome else { panic!("{:?}", refused.outcome) };
    assert!((relaxation - 1.25).abs() < 0.01, "{relaxation}");
}

#[test]
fn given_speeds_are_the_ones_that_count() {
    let engine = soft();
    let speeds = vec![150.0, 300.0];
    let asked = BalanceTask { speeds: speeds.clone(), ..largest() };
    let answer = optimise(&engine, &asked).expect("the engine is valid");
    assert_proved(&answer);
    let there = response(&fitted(&engine, &answer), &speeds).into_iter().fold(0.0, f64::max);
    assert!((there - answer.stages[0].value).abs() < 1e-7 * there, "{there}");
    assert_eq!(answer.task, asked);
}

/// With a weight the judged value is the largest of weight times force: what one speed may have more, the other gets less.
#[test]
fn a_weight_of_a_speed_multiplies_its_force() {
    let engine = soft();
    let speeds = vec![150.0, 300.0];
    let at_speeds = |weights: &[f64]| {
        let asked = BalanceTask { speeds: speeds.clone(), speed_weights: weights.to_vec(), ..largest() };
        let answer = optimise(&engine, &asked).expect("the engine is valid");
        assert_proved(&answer);
        let forces = response(&fitted(&engine, &answer), &speeds);
        (answer, forces)
    };
    let (equal, plain) = at_speeds(&[]);
    assert!(equal.mount_speeds.expect("they are judged").weights.is_empty());
    for weights in [[4.0, 1.0], [1.0, 4.0], [0.25, 1.0]] {
        let (answer, forces) = at_speeds(&weights);
        let worst = forces.iter().zip(weights).map(|(force, weight)| weight * force).fold(0.0, f64::max);
        let stage = &answer.stages[0];
        assert!((worst - stage.value).abs() < 1e-7 * worst, "{weights:?}: {worst} N beside {stage:?}");
        let of_equal = plain.iter().zip(weights).map(|(force, weight)| weight * force).fold(0.0, f64::max);
        assert!(stage.lower_bound <= of_equal * (1.0 + 1e-9), "{weights:?}");
        let told = answer.mount_speeds.as_ref().expect("they are judged");
        assert_eq!(
            (told.judged.as_slice(), told.weights.as_slice()),
            (speeds.as_slice(), weights.as_slice())
        );
        let effect = answer.effects.iter().find(|e| e.criterion == Criterion::Peak(Load::LargestMountForce));
        let standing = response(&engine, &speeds);
        let before = standing.iter().zip(weights).map(|(force, weight)| weight * force).fold(0.0, f64::max);
        assert!((effect.expect("it is told").before - before).abs() < 1e-7 * before);
    }
    // All weights times the same change nothing but the value.
    let (double, forces) = at_speeds(&[2.0, 2.0]);
    assert!((double.stages[0].value - 2.0 * equal.stages[0].value).abs() < 1e-6 * double.stages[0].value);
    assert!(forces.iter().zip(&plain).all(|(one, other)| (one - other).abs() < 1e-3 * other));
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let asked = BalanceTask { speeds: speeds.clone(), speed_weights: vec![1.0, bad], ..largest() };
        let refused = optimise(&engine, &asked).expect_err("no weight").to_string();
        assert!(refused.contains("weight"), "{refused}");
    }
}
