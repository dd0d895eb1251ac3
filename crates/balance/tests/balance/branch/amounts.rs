//! Given and least amounts, against grids of the phase.

use crate::optimum::support::*;
use lanchester_balance::{Method, optimise};
use lanchester_model::*;
use lanchester_task::*;
use std::f64::consts::TAU;

/// The best over directions of one weight, by the convex optimum in each.
fn best_direction(engine: &Engine, task: &BalanceTask, weight: usize, count: usize) -> f64 {
    (0..count)
        .map(|k| {
            let mut task = task.clone();
            task.weights[weight].phase = Phase::Direction(TAU * k as f64 / count as f64);
            optimise(engine, &task).expect("a valid task").stages.first().map_or(f64::INFINITY, |s| s.value)
        })
        .fold(f64::INFINITY, f64::min)
}

#[test]
fn a_least_amount_beyond_the_optimum_holds_it_there() {
    let engine = stripped("single");
    let free = BalanceTask {
        weights: vec![on_crank("crank", 0.0)],
        stages: vec![stage(Load::Force)],
        ..Default::default()
    };
    let unbound = optimise(&engine, &free).unwrap();
    let amount = unbound.weights[0].unbalance.norm();
    for factor in [0.5, 1.0, 1.3, 2.0] {
        let mut task = free.clone();
        (task.weights[0].least, task.weights[0].most) = (factor * amount, Some(3.0 * amount));
        let answer = optimise(&engine, &task).unwrap();
        assert_proved(&engine, &answer);

        let got = answer.weights[0].unbalance.norm();
        let want = amount * f64::max(factor, 1.0);
        assert!((got - want).abs() < 1e-6 * want, "{factor}: {got} against {want}");
        let grid = best_direction(&engine, &task, 0, 60);
        assert!(answer.stages[0].value <= grid * (1.0 + 1e-9), "{factor}");
    }
}

#[test]
fn given_amounts_find_their_phase() {
    let engine = stripped("v4-90");
    let given = |z: f64, amount: f64| FreeWeight {
        least: amount,
        most: Some(amount),
        ..on_crank(&format!("at {z}"), z)
    };
    let free = BalanceTask {
        weights: vec![on_crank("front", -0.1), on_crank("rear", 0.1)],
        stages: vec![stage(Load::Couple)],
        ..Default::default()
    };
    let best = optimise(&engine, &free).unwrap();
    let amount = best.weights[0].unbalance.norm();
    for factor in [0.4, 1.7] {
        let task = BalanceTask {
            weights: vec![given(-0.1, factor * amount), on_crank("rear", 0.1)],
            ..free.clone()
        };
        let answer = optimise(&engine, &task).unwrap();
        assert_proved(&engine, &answer);
        assert!(matches!(answer.method, Method::BranchAndBound { .. }));
        let got = answer.weights[0].unbalance.norm();
        assert!((got - factor * amount).abs() < 1e-12 * amount, "{got}");
        let grid = best_direction(&engine, &task, 0, 360);
        let value = answer.stages[0].value;
        assert!(value <= grid * (1.0 + 1e-9) && value > grid * (1.0 - 1e-3), "{value} {grid}");
    }
}
