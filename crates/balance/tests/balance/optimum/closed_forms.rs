//! Optima that are known by hand.

use crate::optimum::support::*;
use lanchester_balance::{fitted, optimise, optimise_with};
use lanchester_mechanism::Kinematics;
use lanchester_task::*;

/// Of a piston's first order half turns with the crank: with orders above left out the best counterweight takes exactly
/// that half and all that rotates, and what is left turns against the crank with a constant amount.
#[test]
fn single_wants_the_rotating_and_half_of_the_reciprocating_mass() {
    let engine = stripped("single");
    let task = BalanceTask { weights: vec![on_crank("weight", 0.0)], ..Default::default() };
    let answer = optimise_with(&engine, &task, Kinematics::Orders(1)).unwrap();
    assert_proved(&engine, &answer);
    let (throw, cylinder) = (&engine.throws[0], &engine.cylinders[0]);
    let reciprocating = cylinder.reciprocating_mass() * throw.radius;
    let want = throw.unbalance + engine.rod_unbalance(0) + 0.5 * reciprocating;
    let got = answer.weights[0].unbalance;
    assert!((got.re + want).abs() < 1e-12 * want && got.im.abs() < 1e-12 * want, "{got} {want}");
    let left = 0.5 * reciprocating * engine.speed.highest.powi(2);
    assert!((answer.stages[0].value - left).abs() < 1e-12 * left);
}

/// A backward shaft in the plane of the cylinder takes the other half: the first order is gone.
#[test]
fn backward_shaft_takes_the_rest_of_the_first_order() {
    let engine = stripped("single");
    let task = BalanceTask {
        shafts: vec![shaft("backward", -1, 0.0, 0.0)],
        weights: vec![on_crank("weight", 0.0), weight("backward", Seat::Shaft(0), 0.0)],
        stages: vec![Stage { terms: vec![(1.0, Criterion::Order(Load::Force, 1.0))] }],
        ..Default::default()
    };
    let answer = optimise(&engine, &task).unwrap();
    assert!(answer.stages[0].value < 1e-11 * answer.effects[0].without, "{:?}", answer.stages);
    let fit = fitted(&engine, &answer);
    let second = grid_peak(&fit, 0, 3600);
    let exact = optimise(&engine, &BalanceTask { stages: vec![stage(Load::Force)], ..task }).unwrap();
    assert_proved(&engine, &exact);
    assert!(
        exact.stages[0].value <= second * (1.0 + 1e-12),
        "the peak itself does no worse than its first order"
    );
}

/// Three weights in three planes are not split at random: the middle one is not needed.
#[test]
fn among_equals_the_lightest() {
    let engine = stripped("v6-60");
    let weights = [-0.15, 0.0, 0.15].map(|z| on_crank(&format!("at {z}"), z)).to_vec();
    // Asked for in so many words: else the bearings decide before.
    let lightest = Stage { terms: vec![(1.0, Criterion::AddedUnbalance)] };
    let stages = vec![stage(Load::Force), stage(Load::Couple), lightest];
    let task = BalanceTask { weights, stages, ..Default::default() };
    let answer = optimise(&engine, &task).unwrap();
    assert_proved(&engine, &answer);
    let amounts: Vec<f64> = answer.weights.iter().map(|w| w.unbalance.norm()).collect();
    assert!(
        amounts[1] < 1e-9 * amounts[0] && (amounts[0] - amounts[2]).abs() < 1e-7 * amounts[0],
        "{amounts:?}"
    );
}

/// The fitted engine's own loads, on a grid a hundred times finer than any table, never exceed the stated peaks.
#[test]
fn stated_peaks_are_true_peaks() {
    for name in
        ["single", "twin-360", "twin-270", "in-line-3", "v6-60", "v4-90", "vr6-15", "radial-3", "square-4"]
    {
        let engine = stripped(name);
        let weights = [-0.1, 0.1].map(|z| on_crank(&format!("at {z}"), z)).to_vec();
        let answer = optimise(&engine, &BalanceTask { weights, ..Default::default() }).unwrap();
        assert_proved(&engine, &answer);
        let fit = fitted(&engine, &answer);
        for which in 0..2 {
            let (stated, seen) = (answer.effects[which].after, grid_peak(&fit, which, 36_000));
            let scale = answer.effects[which].without.max(1e-2 * all_masses(&engine));
            assert!(seen <= stated + 1e-11 * scale, "{name} {which}: {seen} above {stated}");
            assert!(seen >= stated - 1e-6 * scale, "{name} {which}: {seen} far below {stated}");
        }
    }
}
