//! Devices that may be left out, against all subsets.

use crate::optimum::support::*;
use lanchester_balance::{Outcome, optimise};
use lanchester_model::*;
use lanchester_task::*;

/// Subsets of `0..count` with at most `most` members.
fn subsets(count: usize, most: usize) -> Vec<Vec<usize>> {
    let all = (0..1usize << count).map(|bits| (0..count).filter(|k| bits >> k & 1 == 1).collect());
    all.filter(|set: &Vec<usize>| set.len() <= most).collect()
}

fn optional(name: &str, seat: Seat, z: f64, most: f64) -> FreeWeight {
    FreeWeight { most: Some(most), optional: true, ..weight(name, seat, z) }
}

/// The best of all subsets of the optional weights: least amounts on a direction hold, since that is convex.
fn best_subset(engine: &Engine, task: &BalanceTask) -> f64 {
    let most = task.most_optional.unwrap_or(task.weights.len());
    let optional: Vec<usize> = (0..task.weights.len()).filter(|&w| task.weights[w].optional).collect();
    subsets(optional.len(), most)
        .iter()
        .map(|set| {
            let kept = |w: &usize| !task.weights[*w].optional || set.iter().any(|&k| optional[k] == *w);
            let weights = (0..task.weights.len()).filter(kept).map(|w| task.weights[w].clone());
            let weights: Vec<_> = weights.map(|w| FreeWeight { optional: false, ..w }).collect();
            let part = BalanceTask { weights, most_optional: None, ..task.clone() };
            optimise(engine, &part)
                .expect("a valid task")
                .stages
                .first()
                .map_or(f64::INFINITY, |stage| stage.value)
        })
        .fold(f64::INFINITY, f64::min)
}

#[test]
fn the_best_k_weights_of_five_are_those_of_all_subsets() {
    for (name, load) in [("v6-60", Load::Couple), ("in-line-3", Load::Couple), ("twin-270", Load::Force)] {
        let engine = stripped(name);
        let planes = [-0.16, -0.07, 0.01, 0.08, 0.15];
        let weights = planes.map(|z| optional(&format!("at {z}"), Seat::Crankshaft(0), z, 0.05)).to_vec();
        for most in 0..=3 {
            let task = BalanceTask {
                weights: weights.clone(),
                stages: vec![stage(load)],
                most_optional: Some(most),
                ..Default::default()
            };
            let answer = optimise(&engine, &task).unwrap();
            assert_proved(&engine, &answer);
            let used = answer.weights.iter().filter(|w| w.used).count();
            assert!(used <= most, "{name}: {used} of at most {most}");
            let best = best_subset(&engine, &task);
            let value = answer.stages[0].value;
            assert!((value - best).abs() <= 1e-8 * best.max(1e-6), "{name} {most}: {value} against {best}");
        }
    }
}

/// Shafts of four kinds of which two may be used.
#[test]
fn the_best_two_of_four_shafts() {
    let engine = stripped("twin-270");
    let shafts: Vec<FreeShaft> = [-1, 1, -2, 2]
        .into_iter()
        .map(|ratio| FreeShaft { optional: true, ..shaft(&format!("ratio {ratio}"), ratio, 0.0, 0.1) })
        .collect();
    let on = |s: usize| {
        [-0.05, 0.05]
            .map(|z| FreeWeight { most: Some(0.02), ..weight(&format!("{s} at {z}"), Seat::Shaft(s), z) })
    };
    let weights: Vec<FreeWeight> = (0..4).flat_map(on).chain([on_crank("crank", 0.0)]).collect();
    let task = |chosen: &[usize]| BalanceTask {
        shafts: chosen.iter().map(|&s| shafts[s].clone()).collect(),
        weights: weights
            .iter()
            .filter_map(|w| match w.seat {
                Seat::Shaft(s) => {
                    let place = chosen.iter().position(|c| *c == s)?;
                    Some(FreeWeight { seat: Seat::Shaft(place), ..w.clone() })
                }
                Seat::Crankshaft(_) => Some(w.clone()),
            })
            .collect(),
        stages: vec![Stage {
            terms: vec![(1.0, Criterion::Peak(Load::Force)), (5.0, Criterion::Peak(Load::Couple))],
        }],
        ..Default::default()
    };
    let best = subsets(4, 2)
        .iter()
        .map(|set| optimise(&engine, &task(set)).unwrap().stages[0].value)
        .fold(f64::INFINITY, f64::min);
    let all = BalanceTask { most_optional: Some(2), ..task(&[0, 1, 2, 3]) };
    let answer = optimise(&engine, &all).unwrap();
    assert_proved(&engine, &answer);
    assert!(answer.shafts.iter().filter(|s| s.used).count() <= 2);
    let value = answer.stages[0].value;
    assert!((value - best).abs() <= 1e-8 * best, "{value} against {best}");
}

#[test]
fn nothing_optional_left_is_the_engine_as_it_is() {
    let engine = stripped("single");
    let weights = vec![optional("crank", Seat::Crankshaft(0), 0.0, 0.1)];
    let task = BalanceTask { weights, most_optional: Some(0), ..Default::default() };
    let answer = optimise(&engine, &task).unwrap();
    assert_eq!(answer.outcome, Outcome::Optimal);
    assert!(!answer.weights[0].used);
    assert!((answer.effects[0].after - answer.effects[0].without).abs() < 1e-9);
}
