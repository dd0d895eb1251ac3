//! Limits with choices: held, or proved impossible with what can be reached.

use crate::optimum::support::*;
use lanchester_balance::{BalanceError, Method, Outcome, optimise};
use lanchester_model::*;
use lanchester_task::*;

fn found(name: &str, most: f64) -> FreeWeight {
    FreeWeight { z: Place::Between(-0.12, 0.12), most: Some(most), ..on_crank(name, 0.0) }
}

fn limit(load: Load, most: f64) -> Limit {
    Limit { criterion: Criterion::Peak(load), most }
}

/// Smallest couple of one weight in a plane that is found, by a grid of planes.
fn least_couple(engine: &Engine, weight: &FreeWeight) -> f64 {
    (0..=240)
        .map(|k| {
            let z = Place::At(-0.12 + 0.001 * f64::from(k));
            let task = BalanceTask {
                weights: vec![FreeWeight { z, ..weight.clone() }],
                stages: vec![stage(Load::Couple)],
                ..Default::default()
            };
            optimise(engine, &task).expect("a valid task").stages[0].value
        })
        .fold(f64::INFINITY, f64::min)
}

#[test]
fn limits_nobody_can_reach_say_how_close_one_gets() {
    let engine = stripped("twin-270");
    let weight = found("a", 0.01);
    let least = least_couple(&engine, &weight);
    let task = BalanceTask {
        weights: vec![weight],
        stages: vec![stage(Load::Force)],
        limits: vec![limit(Load::Couple, 0.8 * least), limit(Load::RollMoment, 1e6)],
        ..Default::default()
    };
    let answer = optimise(&engine, &task).unwrap();
    let Outcome::Infeasible { relaxation, closest, reason } = &answer.outcome else {
        panic!("{:?}", answer.outcome)
    };
    assert!((closest[0] - least).abs() < 1e-4 * least, "{closest:?} {least}");
    assert!((relaxation - 1.25).abs() < 1e-3, "{relaxation}");
    assert!(reason.contains("cannot be reached even alone"), "{reason}");
    assert!(matches!(answer.method, Method::BranchAndBound { .. }) && answer.weights.is_empty());
}

#[test]
fn a_limit_that_can_just_be_reached_is_held() {
    let engine = stripped("twin-270");
    let weight = found("a", 0.01);
    let least = least_couple(&engine, &weight);
    let task = BalanceTask {
        weights: vec![weight],
        stages: vec![stage(Load::Force)],
        limits: vec![limit(Load::Couple, 1.05 * least)],
        ..Default::default()
    };
    let answer = optimise(&engine, &task).unwrap();
    assert_proved(&engine, &answer);
    assert!(answer.limits[0].value <= 1.05 * least * (1.0 + 1e-9), "{:?}", answer.limits);
    // The price is that with the plane kept: it is what a little more or less of the limit brings there.
    let at = |most: f64| {
        let weights = vec![FreeWeight { z: Place::At(answer.weights[0].z), ..found("a", 0.01) }];
        let task = BalanceTask { weights, limits: vec![limit(Load::Couple, most)], ..task.clone() };
        optimise(&engine, &task).unwrap().stages[0].value
    };
    let (most, step) = (1.05 * least, 1e-5 * least);
    let slope = (at(most - step) - at(most + step)) / (2.0 * step);
    let price = answer.limits[0].price;
    assert!(slope > 0.0 && (price - slope).abs() < 1e-4 * slope, "{price} {slope}");
}

/// The limit needs both of two optional weights, and only one may be used.
#[test]
fn too_few_devices_are_a_reason() {
    let engine = stripped("v4-90");
    let optional = |z: f64| FreeWeight { optional: true, most: Some(0.1), ..on_crank(&format!("at {z}"), z) };
    let both = BalanceTask {
        weights: vec![optional(-0.1), optional(0.1)],
        stages: vec![stage(Load::Force), stage(Load::Couple)],
        ..Default::default()
    };
    let reached = optimise(&engine, &both).unwrap().stages[0].value;
    let task = BalanceTask {
        limits: vec![limit(Load::Force, 1.1 * reached.max(1.0)), limit(Load::Couple, 60.0)],
        stages: vec![stage(Load::Couple)],
        most_optional: Some(1),
        ..both.clone()
    };
    let answer = optimise(&engine, &task).unwrap();
    assert!(matches!(answer.outcome, Outcome::Infeasible { .. }), "{:?}", answer.outcome);
    let answer = optimise(&engine, &BalanceTask { most_optional: Some(2), ..task }).unwrap();
    assert_proved(&engine, &answer);
}

/// A follower cannot have more than its leader gives it.
#[test]
fn least_amounts_against_a_tie() {
    let engine = stripped("single");
    let bound = |name: &str, z: f64, least: f64, most: f64| FreeWeight {
        least,
        most: Some(most),
        ..on_crank(name, z)
    };
    let task = |least: f64| BalanceTask {
        weights: vec![bound("leader", -0.1, 0.0, 0.01), bound("follower", 0.1, least, 0.1)],
        ties: vec![Tie { first: 0, second: 1, factor: 1.0, mirrored: false }],
        ..Default::default()
    };
    let answer = optimise(&engine, &task(0.02)).unwrap();
    assert!(matches!(answer.outcome, Outcome::Infeasible { .. }), "{:?}", answer.outcome);
    let answer = optimise(&engine, &task(0.008)).unwrap();
    assert_proved(&engine, &answer);
    assert!((answer.weights[0].unbalance - answer.weights[1].unbalance).norm() < 1e-12);
}

#[test]
fn a_place_to_be_found_needs_a_largest_amount() {
    let engine = stripped("single");
    let task =
        BalanceTask { weights: vec![FreeWeight { most: None, ..found("a", 1.0) }], ..Default::default() };
    assert_eq!(optimise(&engine, &task), Err(BalanceError::Unbounded { device: "a".into() }));
}
