//! The bending moment along the crankshaft as what is judged.

use crate::optimum::support::*;
use lanchester_balance::{fitted, optimise};
use lanchester_mechanism::{InternalRequest, internal_moments};
use lanchester_model::*;
use lanchester_task::*;
use num_complex::Complex64;

/// Largest bending moment along crankshaft 1 as a free beam under all that turns, by the mechanism's own walk along it.
fn bending(engine: &Engine) -> f64 {
    let request = InternalRequest { samples: 1, ..InternalRequest::default() };
    internal_moments(engine, &request).expect("a valid engine").crankshafts[0].free_beam.peak_moment.value
}

/// A stripped in-line engine whose throws have webs this far apart, with a free weight on every one of `webs` (from 1).
fn weights_on_webs(engine: &Engine, distance: f64, webs: &[usize]) -> Vec<FreeWeight> {
    let plane = |web: usize| {
        let throw = &engine.throws[(web - 1) / 2];
        throw.z + if web % 2 == 1 { -0.5 * distance } else { 0.5 * distance }
    };
    webs.iter().map(|&web| on_crank(&format!("web {web}"), plane(web))).collect()
}

fn task(weights: Vec<FreeWeight>) -> BalanceTask {
    BalanceTask { weights, stages: vec![stage(Load::BendingMoment)], ..Default::default() }
}

/// Rotating unbalance of a throw with its big ends [kg m].
fn rotating(engine: &Engine, throw: usize) -> f64 {
    engine.throws[throw].unbalance + engine.rod_unbalance(throw)
}

/// The engine where each web takes half of its own throw.
fn each_web_its_own_half(engine: &Engine, distance: f64) -> Engine {
    let half = |(k, throw): (usize, &Throw)| {
        [-0.5, 0.5].map(|side| Counterweight {
            name: format!("throw {} {side}", k + 1),
            crankshaft: 0,
            z: throw.z + side * distance,
            unbalance: 0.5 * (throw.unbalance + engine.rod_unbalance(k)),
            angle: throw.angle + std::f64::consts::PI,
            part: None,
        })
    };
    let halves: Vec<Counterweight> = engine.throws.iter().enumerate().flat_map(half).collect();
    engine.with(|parts| parts.counterweights.extend(halves)).expect("an engine")
}

#[test]
fn weights_in_the_throw_planes_leave_no_bending() {
    let engine = stripped("in-line-4");
    let weights = (0..4).map(|k| on_crank(&format!("throw {}", k + 1), engine.throws[k].z)).collect();
    let answer = optimise(&engine, &task(weights)).unwrap();
    let without = bending(&engine);
    assert_proved(&engine, &answer);
    assert!(answer.stages[0].value < 1e-12 * without, "{:?}", answer.stages);
    for (k, found) in answer.weights.iter().enumerate() {
        let want = -Complex64::from_polar(rotating(&engine, k), engine.throws[k].angle);
        assert!((found.unbalance - want).norm() < 1e-9 * want.norm(), "{found:?}");
    }
}

/// Webs stand beside the pins, so that something is left. The rule of thumb leaves `F d / 4` in every throw; the optimum
/// lets the two webs of a throw press the ends of their bay the other way and halves it.
#[test]
fn the_optimum_on_webs_beats_each_web_its_own_half() {
    let engine = stripped("in-line-4");
    let distance = 0.04;
    let weights = weights_on_webs(&engine, distance, &[1, 2, 3, 4, 5, 6, 7, 8]);
    let answer = optimise(&engine, &task(weights)).unwrap();
    assert_proved(&engine, &answer);
    let rule = bending(&each_web_its_own_half(&engine, distance));
    let force = rotating(&engine, 0) * engine.speed.highest.powi(2);
    assert!((rule - 0.25 * force * distance).abs() < 1e-12 * rule, "{rule}");
    let value = answer.stages[0].value;
    assert!((value - 0.5 * rule).abs() < 1e-7 * rule, "{value} against {rule}");
    assert!((bending(&fitted(&engine, &answer)) - value).abs() < 1e-9 * value);
}

/// A real in-line four has weights on four webs only: the optimum is below any mix of the rules of thumb.
#[test]
fn four_weights_do_what_they_can() {
    let engine = stripped("in-line-4");
    let weights = weights_on_webs(&engine, 0.04, &[1, 4, 5, 8]);
    let answer = optimise(&engine, &task(weights)).unwrap();
    assert_proved(&engine, &answer);
    let value = answer.stages[0].value;
    let effect = answer.effects.iter().find(|e| e.criterion == Criterion::Peak(Load::BendingMoment)).unwrap();
    assert!((effect.without - bending(&engine)).abs() < 1e-12 * effect.without, "{effect:?}");
    assert!(value > 0.0 && value < 0.5 * effect.without, "{value} of {}", effect.without);
    // Any change for the worse: an optimum that the engine's own walk along the shaft cannot beat.
    let mut seed = 1u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    for size in [1e-3, 1e-2, 0.1, 1.0] {
        for _ in 0..200 {
            let mut changed = answer.clone();
            for weight in &mut changed.weights {
                weight.unbalance += size * rotating(&engine, 0) * Complex64::new(random(), random());
                weight.used = true;
            }
            let other = bending(&fitted(&engine, &changed));
            assert!(other >= value * (1.0 - 1e-9), "{other} below {value}");
        }
    }
}

#[test]
fn a_limit_on_bending_has_a_price() {
    let engine = stripped("v8-crossplane");
    let ends = [engine.throws[0].z, engine.throws[3].z];
    let weights: Vec<FreeWeight> = ends.iter().map(|z| on_crank(&format!("at {z}"), *z)).collect();
    let stages = vec![stage(Load::Couple)];
    let free = BalanceTask { weights: weights.clone(), stages: stages.clone(), ..Default::default() };
    let best = optimise(&engine, &free).unwrap();
    let bends = bending(&fitted(&engine, &best));
    let least = optimise(&engine, &task(weights)).unwrap().stages[0].value;
    assert!(least < bends, "{least} {bends}");
    let limited = |most: f64| {
        let limit = Limit { criterion: Criterion::Peak(Load::BendingMoment), most };
        let answer = optimise(&engine, &BalanceTask { limits: vec![limit], ..free.clone() }).unwrap();
        assert_proved(&engine, &answer);
        answer
    };
    let middle = 0.5 * (least + bends);
    let answer = limited(middle);
    assert!((answer.limits[0].value - middle).abs() < 1e-8 * middle, "{:?}", answer.limits);
    assert!((bending(&fitted(&engine, &answer)) - middle).abs() < 1e-7 * middle);
    let step = 1e-3 * middle;
    let slope =
        (limited(middle - step).stages[0].value - limited(middle + step).stages[0].value) / (2.0 * step);
    let price = answer.limits[0].price;
    assert!((price - slope).abs() < 1e-3 * slope, "{price} {slope}");
}

#[test]
fn what_bends_only_turns() {
    let engine = stripped("in-line-4");
    let weights = vec![on_crank("middle", 0.0)];
    let order = |n: f64| {
        let stages = vec![Stage { terms: vec![(1.0, Criterion::Order(Load::BendingMoment, n))] }];
        optimise(&engine, &BalanceTask { weights: weights.clone(), stages, ..Default::default() }).unwrap()
    };
    let peak = optimise(&engine, &task(weights.clone())).unwrap().stages[0].value;
    assert!((order(1.0).stages[0].value - peak).abs() < 1e-8 * peak);
    assert_eq!(order(2.0).stages[0].value, 0.0);
}
