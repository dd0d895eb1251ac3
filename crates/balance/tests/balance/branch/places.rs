//! Planes and axes that are to be found, against grids of them.

use crate::optimum::support::*;
use lanchester_balance::{Method, optimise};
use lanchester_model::*;
use lanchester_task::*;

fn somewhere(name: &str, seat: Seat, z: (f64, f64), most: f64) -> FreeWeight {
    FreeWeight { z: Place::Between(z.0, z.1), most: Some(most), ..weight(name, seat, 0.0) }
}

/// The best over planes of one weight, by the convex optimum in each.
fn best_plane(engine: &Engine, task: &BalanceTask, weight: usize, count: usize) -> f64 {
    let Place::Between(low, high) = task.weights[weight].z else { panic!("its plane is given") };
    (0..=count)
        .map(|k| {
            let mut task = task.clone();
            task.weights[weight].z = Place::At(low + (high - low) * k as f64 / count as f64);
            optimise(engine, &task).expect("a valid task").stages.first().map_or(f64::INFINITY, |s| s.value)
        })
        .fold(f64::INFINITY, f64::min)
}

/// A single cylinder away from the origin: the weight that takes its force takes its couple too, in the cylinder's plane.
#[test]
fn the_cylinders_own_plane_is_found() {
    let mut engine = stripped("single");
    engine = engine
        .with(|engine| {
            for throw in &mut engine.throws {
                throw.z += 0.0371;
            }

            for cylinder in &mut engine.cylinders {
                cylinder.z += 0.0371;
            }
        })
        .unwrap();
    let task = BalanceTask {
        weights: vec![somewhere("crank", Seat::Crankshaft(0), (-0.1, 0.15), 0.5)],
        ..Default::default()
    };
    let answer = optimise(&engine, &task).unwrap();
    assert_proved(&engine, &answer);
    assert!((answer.weights[0].z - 0.0371).abs() < 1e-6, "{:?}", answer.weights);
}

#[test]
fn the_best_plane_of_one_weight_beside_a_given_one() {
    for (name, load) in [("v4-90", Load::Couple), ("in-line-3", Load::Couple), ("twin-270", Load::Couple)] {
        let engine = stripped(name);
        let task = BalanceTask {
            weights: vec![
                FreeWeight { most: Some(0.008), ..on_crank("given", -0.12) },
                somewhere("found", Seat::Crankshaft(0), (-0.05, 0.16), 0.006),
            ],
            stages: vec![Stage {
                terms: vec![(1.0, Criterion::Peak(load)), (0.03, Criterion::Peak(Load::Force))],
            }],
            ..Default::default()
        };
        let answer = optimise(&engine, &task).unwrap();
        assert_proved(&engine, &answer);
        let grid = best_plane(&engine, &task, 1, 420);
        let value = answer.stages[0].value;
        assert!(value <= grid * (1.0 + 1e-9) && value > grid * (1.0 - 1e-3), "{name}: {value} {grid}");
    }
}

/// Second-order shafts at unequal heights take roll moment: their height is found.
#[test]
fn the_height_of_a_shaft_pair_is_found() {
    let engine = stripped("in-line-4");
    let on =
        |s: usize| FreeWeight { most: Some(0.01), ..weight(&format!("weight {s}"), Seat::Shaft(s), 0.0) };
    let task = BalanceTask {
        shafts: vec![
            FreeShaft { x: Place::Between(-0.1, 0.2), ..shaft("forward", 2, 0.0, -0.09) },
            FreeShaft { x: Place::Between(-0.1, 0.2), ..shaft("backward", -2, 0.0, 0.09) },
        ],
        weights: vec![on(0), on(1)],
        stages: vec![stage(Load::Force), stage(Load::RollMoment)],
        ..Default::default()
    };
    let answer = optimise(&engine, &task).unwrap();
    assert_proved(&engine, &answer);
    let height = |x: f64, k: usize| {
        let mut task = task.clone();
        task.shafts[k].x = Place::At(x);
        task.shafts[1 - k].x = Place::At(if k == 0 { -0.1 } else { 0.2 });
        optimise(&engine, &task).unwrap().stages[1].value
    };
    let grid = (0..=60)
        .flat_map(|k| [height(-0.1 + 0.005 * f64::from(k), 0), height(-0.1 + 0.005 * f64::from(k), 1)])
        .fold(f64::INFINITY, f64::min);
    let value = answer.stages[1].value;
    assert!(value <= grid * (1.0 + 1e-8), "{value} {grid}");
}

/// The beam bends otherwise on either side of a throw: the plane is found across them, beside a grid of planes.
#[test]
fn the_plane_that_leaves_the_least_bending_is_found() {
    let engine = stripped("in-line-4");
    let task = BalanceTask {
        weights: vec![
            FreeWeight { most: Some(0.02), ..on_crank("given", engine.throws[3].z) },
            somewhere("found", Seat::Crankshaft(0), (-0.13, 0.02), 0.02),
        ],
        stages: vec![stage(Load::BendingMoment)],
        ..Default::default()
    };
    let answer = optimise(&engine, &task).unwrap();
    assert_proved(&engine, &answer);
    let grid = best_plane(&engine, &task, 1, 600);
    let value = answer.stages[0].value;
    assert!(value <= grid * (1.0 + 1e-9) && value > grid * (1.0 - 1e-2), "{value} {grid}");
    // With the phase given too, what remains open is the plane alone.
    let mut along = task.clone();
    along.weights[1].phase = Phase::Direction(answer.weights[1].unbalance.arg());
    let same = optimise(&engine, &along).unwrap();
    assert_proved(&engine, &same);
    assert!(matches!(same.method, Method::BranchAndBound { .. }));
    assert!((same.stages[0].value - value).abs() <= 1e-7 * value, "{value} {}", same.stages[0].value);
}

/// Other mains carry a weight on either side of a main: the plane is found across two of them, beside a grid of planes, and
/// nothing in the stretch goes below the bound.
#[test]
fn the_plane_that_loads_the_mains_least_is_found() {
    let engine = stripped("in-line-3");
    let reach = engine.throws[2].z;
    let task = BalanceTask {
        weights: vec![
            FreeWeight { most: Some(0.02), ..on_crank("given", reach) },
            somewhere("found", Seat::Crankshaft(0), (-1.2 * reach, 0.8 * reach), 0.02),
        ],
        ..Default::default()
    };
    for criterion in [Criterion::MainRms(Mains::All), Criterion::Peak(Load::LargestMainLoad)] {
        let task = BalanceTask { stages: vec![Stage { terms: vec![(1.0, criterion)] }], ..task.clone() };
        let answer = optimise(&engine, &task).unwrap();
        assert_proved(&engine, &answer);
        assert!(matches!(answer.method, Method::BranchAndBound { .. }));
        let grid = best_plane(&engine, &task, 1, 200);
        let value = answer.stages[0].value;
        assert!(answer.stages[0].lower_bound <= grid * (1.0 + 1e-9), "{criterion:?}: {value} {grid}");
        assert!(value <= grid * (1.0 + 1e-9) && value > grid * (1.0 - 1e-2), "{criterion:?}: {value} {grid}");
    }
}
