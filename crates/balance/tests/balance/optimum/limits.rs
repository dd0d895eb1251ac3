//! Limits, their prices, and limits that cannot be held.

use crate::optimum::support::*;
use lanchester_balance::{Answer, BalanceError, Outcome, optimise};
use lanchester_model::*;
use lanchester_task::*;

fn value(engine: &Engine, task: &BalanceTask) -> f64 {
    let answer = optimise(engine, task).expect("a valid task");
    assert_proved(engine, &answer);
    answer.stages[0].value
}

/// Prices against central differences of the optimum.
fn assert_prices(engine: &Engine, task: &BalanceTask, tolerance: f64) -> Answer {
    let answer = optimise(engine, task).expect("a valid task");
    assert_proved(engine, &answer);
    let mut priced = 0;
    let widened = |index: usize, factor: f64| {
        let mut task = task.clone();
        if index < task.limits.len() {
            task.limits[index].most *= factor;
            return task;
        }
        let bounded: Vec<usize> =
            (0..task.weights.len()).filter(|&w| task.weights[w].most.is_some()).collect();
        match bounded.get(index - task.limits.len()) {
            Some(&weight) => task.weights[weight].most = task.weights[weight].most.map(|m| m * factor),
            None => task.inertias[0].most = task.inertias[0].most.map(|m| m * factor),
        }
        task
    };
    for (index, limit) in answer.limits.iter().enumerate() {
        let h = 1e-5;
        let rise = value(engine, &widened(index, 1.0 + h)) - value(engine, &widened(index, 1.0 - h));
        let want = -rise / (2.0 * h * limit.most);
        let got = limit.price;
        let size = answer.effects[0].without.max(answer.effects[1].without).max(answer.effects[2].without);
        assert!(
            (got - want).abs() < tolerance * (want.abs() + 1e-3 * size / limit.most),
            "{}: {got} {want}",
            limit.what
        );
        priced += usize::from(got > 0.0);
    }
    assert!(priced > 0, "some limit holds it up: {:#?}", answer.limits);
    answer
}

#[test]
fn prices_of_largest_amounts() {
    let engine = stripped("twin-270");
    let bounded = |name: &str, z: f64, most: f64| FreeWeight { most: Some(most), ..on_crank(name, z) };
    let weights =
        vec![bounded("front", -0.08, 0.005), bounded("middle", 0.0, 0.004), bounded("rear", 0.07, 0.006)];
    let task = BalanceTask { weights, stages: vec![stage(Load::Force)], ..Default::default() };
    assert_prices(&engine, &task, 1e-4);
}

#[test]
fn price_of_a_limited_couple() {
    let engine = stripped("twin-270");
    // All weights on one side: force and couple contradict one another.
    let weights = vec![on_crank("near", 0.02), on_crank("far", 0.03)];
    let free = BalanceTask { weights, stages: vec![stage(Load::Couple)], ..Default::default() };
    let couple = value(&engine, &free);
    let limit = Limit { criterion: Criterion::Peak(Load::Couple), most: 1.2 * couple };
    let mut task = BalanceTask { limits: vec![limit], stages: vec![stage(Load::Force)], ..free };
    task.weights.pop();
    let alone =
        value(&engine, &BalanceTask { limits: vec![], stages: vec![stage(Load::Couple)], ..task.clone() });
    task.limits[0].most = 1.02 * alone;
    let answer = assert_prices(&engine, &task, 1e-3);
    let limit = &answer.limits[0];
    assert!(limit.value <= limit.most * (1.0 + 1e-9), "{limit:?}");
    let sum: f64 = answer.stages[0]
        .active
        .iter()
        .filter(|a| a.criterion == Criterion::Peak(Load::Couple))
        .map(|a| a.multiplier)
        .sum();
    assert!((sum - limit.price).abs() < 1e-9 * sum, "multipliers of a limited criterion add up to its price");
}

#[test]
fn price_of_added_mass_and_of_added_unbalance() {
    let engine = stripped("v4-90");
    let weights: Vec<FreeWeight> = [-0.15, -0.05, 0.1]
        .iter()
        .enumerate()
        .map(|(k, z)| FreeWeight { radius: Some(0.04 + 0.01 * k as f64), ..on_crank(&format!("{k}"), *z) })
        .collect();
    let mut task = BalanceTask { weights, stages: vec![stage(Load::Couple)], ..Default::default() };
    for criterion in [Criterion::AddedMass, Criterion::AddedUnbalance] {
        task.limits = vec![];
        let free = optimise(&engine, &task).unwrap();
        let amount = |w: &lanchester_balance::FoundWeight| match criterion {
            Criterion::AddedMass => w.mass.unwrap(),
            _ => w.unbalance.norm(),
        };
        let sum: f64 = free.weights.iter().map(amount).sum();
        task.limits = vec![Limit { criterion, most: 0.6 * sum }];
        let answer = assert_prices(&engine, &task, 1e-4);
        assert!((answer.limits[0].value - 0.6 * sum).abs() < 1e-9 * sum);
    }
}

#[test]
fn least_mass_that_holds_a_force() {
    let engine = stripped("single");
    let limit = Limit { criterion: Criterion::Peak(Load::Force), most: 20_000.0 };
    let task = BalanceTask {
        weights: vec![FreeWeight { radius: Some(0.05), ..on_crank("weight", 0.0) }],
        stages: vec![Stage { terms: vec![(1.0, Criterion::AddedMass)] }],
        limits: vec![limit],
        ..Default::default()
    };
    let answer = assert_prices(&engine, &task, 1e-4);
    assert!((answer.limits[0].value - 20_000.0).abs() < 1e-5, "{:?}", answer.limits);
    assert!((answer.stages[0].value - answer.weights[0].mass.unwrap()).abs() < 1e-12);
}

#[test]
fn limits_that_nobody_can_reach() {
    let engine = stripped("single");
    let task = BalanceTask {
        weights: vec![on_crank("weight", 0.0)],
        stages: vec![stage(Load::Couple)],
        ..Default::default()
    };
    let best = value(&engine, &BalanceTask { stages: vec![stage(Load::Force)], ..task.clone() });
    let limited = |most: f64| BalanceTask {
        limits: vec![Limit { criterion: Criterion::Peak(Load::Force), most }],
        ..task.clone()
    };
    let answer = optimise(&engine, &limited(0.5 * best)).unwrap();
    let Outcome::Infeasible { relaxation, closest, reason } = &answer.outcome else {
        panic!("{:?}", answer.outcome)
    };
    assert!((relaxation - 2.0).abs() < 1e-7, "{relaxation}");
    assert!((closest[0] - best).abs() < 1e-7 * best);
    assert!(reason.contains("force") && reason.contains(" N "), "{reason}");
    assert!(answer.weights.is_empty() && answer.stages.is_empty());
    assert_eq!(optimise(&engine, &limited(1.001 * best)).unwrap().outcome, Outcome::Optimal);
}

/// Each limit can be held, both together cannot.
#[test]
fn limits_that_contradict_one_another() {
    let engine = stripped("twin-180");
    let task = BalanceTask { weights: vec![on_crank("one", 0.02)], ..Default::default() };
    let best = |load| value(&engine, &BalanceTask { stages: vec![stage(load)], ..task.clone() });
    let most = [(Load::Force, best(Load::Force)), (Load::Couple, best(Load::Couple))];
    let limits =
        most.map(|(load, best)| Limit { criterion: Criterion::Peak(load), most: 1.0001 * best }).to_vec();
    let both = optimise(&engine, &BalanceTask { limits, ..task.clone() }).unwrap();
    let Outcome::Infeasible { relaxation, closest, .. } = &both.outcome else { panic!("{:?}", both.outcome) };
    assert!(*relaxation > 1.001 && relaxation.is_finite(), "{relaxation}");
    assert!(closest.iter().zip(most).all(|(c, m)| (c - m.1).abs() < 1e-7 * m.1), "{closest:?}");
    // Relaxed by that factor they hold, a little less and they do not.
    let relaxed = |factor: f64| {
        let limits =
            most.map(|(load, best)| Limit { criterion: Criterion::Peak(load), most: 1.0001 * factor * best });
        optimise(&engine, &BalanceTask { limits: limits.to_vec(), ..task.clone() }).unwrap().outcome
    };
    assert_eq!(relaxed(relaxation * 1.0001), Outcome::Optimal);
    assert!(matches!(relaxed(relaxation * 0.9999), Outcome::Infeasible { .. }));
}

#[test]
fn largest_mount_force_is_below_each_single_choice() {
    let engine = stripped("in-line-3").with(|parts| parts.mounts = mounts()).unwrap();
    let task = |load| BalanceTask {
        weights: vec![on_crank("front", -0.1), on_crank("rear", 0.1)],
        stages: vec![stage(load)],
        ..Default::default()
    };
    let answer = optimise(&engine, &task(Load::LargestMountForce)).unwrap();
    assert_proved(&engine, &answer);
    for load in (0..3).map(Load::MountForce) {
        let one = optimise(&engine, &task(load)).unwrap();
        assert_proved(&engine, &one);
        assert!(one.stages[0].value <= answer.stages[0].value * (1.0 + 1e-9));
    }
    let bare = optimise(&stripped("in-line-3"), &task(Load::LargestMountForce));
    assert!(matches!(bare, Err(BalanceError::Missing { .. })), "{bare:?}");
}

fn mounts() -> Vec<Mount> {
    [(-0.08, -0.24, -0.15), (-0.08, 0.24, -0.15), (-0.06, 0.0, 0.62)]
        .map(|(x, y, z)| Mount { name: format!("{y} {z}"), x, y, z, spring: None })
        .to_vec()
}

/// A counter-rotating inertia of the crank train's own cancels the torque reaction and leaves the rest.
#[test]
fn counter_rotating_inertia_takes_the_torque_reaction() {
    let engine = stripped("in-line-4");
    let inertia =
        |most| FreeInertia { name: "heron".into(), ratio: 1.0, crank_inertia: 0.2, most, optional: false };
    let task = |most| BalanceTask {
        inertias: vec![inertia(most)],
        stages: vec![stage(Load::RollMoment)],
        ..Default::default()
    };
    let free = optimise(&engine, &task(None)).unwrap();
    assert!((free.inertias[0].inertia - 0.2).abs() < 1e-6, "{:?}", free.inertias);
    assert!(free.inertias[0].roll_share.abs() < 1e-6);
    let small = optimise(&engine, &task(Some(0.05))).unwrap();
    let share = (0.2 - 0.05) / (0.2 + 0.05);
    assert!((small.inertias[0].roll_share - share).abs() < 1e-9, "{:?}", small.inertias);
    assert!(
        (small.stages[0].value - share * small.effects[2].without).abs() < 1e-9 * small.effects[2].without
    );
    assert_prices(&engine, &task(Some(0.05)), 1e-4);
}

#[test]
fn questions_without_a_meaning() {
    let engine = stripped("twin-180");
    let task = BalanceTask { weights: vec![on_crank("a", 0.0), on_crank("b", 0.0)], ..Default::default() };
    assert!(matches!(optimise(&engine, &task), Err(BalanceError::Alike { .. })));
    let tied =
        BalanceTask { ties: vec![Tie { first: 0, second: 1, factor: 1.0, mirrored: false }], ..task.clone() };
    assert!(optimise(&engine, &tied).is_ok());
    let mass = BalanceTask {
        weights: vec![on_crank("a", 0.0)],
        stages: vec![Stage { terms: vec![(1.0, Criterion::AddedMass)] }],
        ..Default::default()
    };
    assert!(matches!(optimise(&engine, &mass), Err(BalanceError::NoRadius { .. })));
    for (least, most) in
        [(f64::NAN, None), (-1.0, None), (0.2, Some(0.1)), (0.0, Some(f64::NAN)), (0.0, Some(f64::INFINITY))]
    {
        let weights = vec![FreeWeight { least, most, ..on_crank("a", 0.0) }];
        let refused = optimise(&engine, &BalanceTask { weights, ..Default::default() });
        assert!(matches!(refused, Err(BalanceError::Number { .. })), "{least} {most:?}: {refused:?}");
    }
}

#[test]
fn ties_and_lines_of_phase_hold() {
    let engine = stripped("v4-90");
    let mut weights = vec![on_crank("a", -0.1), on_crank("b", 0.1), on_crank("c", 0.02), on_crank("d", 0.15)];
    weights[2].phase = Phase::Line(0.7);
    weights[3].phase = Phase::Direction(2.0);
    let ties = vec![Tie { first: 0, second: 1, factor: -0.5, mirrored: true }];
    let task = BalanceTask {
        weights,
        ties,
        stages: vec![stage(Load::Force), stage(Load::Couple)],
        ..Default::default()
    };
    let answer = optimise(&engine, &task).unwrap();
    assert_proved(&engine, &answer);
    let u: Vec<_> = answer.weights.iter().map(|w| w.unbalance).collect();
    let size = u.iter().map(|u| u.norm()).fold(0.0, f64::max);
    assert!((u[1] + 0.5 * u[0].conj()).norm() < 1e-9 * size, "{u:?}");
    assert!((u[2] * num_complex::Complex64::cis(-0.7)).im.abs() < 1e-12 * size);
    let along = u[3] * num_complex::Complex64::cis(-2.0);
    assert!(along.im.abs() < 1e-12 * size && along.re >= 0.0, "{along}");
}

/// Roll moment by second-order shafts at unequal heights, as in a four-cylinder engine.
#[test]
fn second_order_shafts_at_unequal_heights_take_roll_moment_too() {
    let engine = stripped("in-line-4");
    let task = |x: [f64; 2]| BalanceTask {
        shafts: vec![shaft("a", 2, x[0], 0.1), shaft("b", -2, x[1], -0.1)],
        weights: vec![weight("a", Seat::Shaft(0), 0.0), weight("b", Seat::Shaft(1), 0.0)],
        stages: vec![stage(Load::Force), stage(Load::RollMoment)],
        ..Default::default()
    };
    let level = optimise(&engine, &task([0.0, 0.0])).unwrap();
    assert_proved(&engine, &level);
    let roll = |a: &Answer| a.effects[2].after;
    let lifts: Vec<f64> =
        [-0.05, 0.05].iter().map(|h| roll(&optimise(&engine, &task([*h, -*h])).unwrap())).collect();
    assert!(lifts.iter().any(|l| *l < 0.9 * roll(&level)), "{lifts:?} {}", roll(&level));
}
