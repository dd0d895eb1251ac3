//! Shafts whose axis is to be found, where the roll moment is asked for: it is the product of the axis and the weights.

use crate::optimum::support::*;
use lanchester_balance::{Method, optimise};
use lanchester_task::*;
use proptest::prelude::*;

fn on_shaft(shaft: usize, z: f64, most: f64) -> FreeWeight {
    FreeWeight { most: Some(most), ..weight(&format!("{shaft} at {z}"), Seat::Shaft(shaft), z) }
}

fn crank(z: f64, most: f64) -> FreeWeight {
    FreeWeight { most: Some(most), ..on_crank(&format!("crank {z}"), z) }
}

fn weighted(terms: &[(f64, Load)]) -> Stage {
    Stage { terms: terms.iter().map(|&(weight, load)| (weight, Criterion::Peak(load))).collect() }
}

fn limit(load: Load, most: f64) -> Limit {
    Limit { criterion: Criterion::Peak(load), most }
}

/// Two shafts of second order whose heights are free, and their sides by so much either way.
fn pair(sides: f64) -> BalanceTask {
    let beside = |y: f64| if sides > 0.0 { Place::Between(y - sides, y + sides) } else { Place::At(y) };
    let area = |name: &str, ratio: i32, y: f64| FreeShaft {
        x: Place::Between(-0.1, 0.2),
        y: beside(y),
        ..shaft(name, ratio, 0.0, y)
    };
    BalanceTask {
        shafts: vec![area("forward", 2, -0.09), area("backward", -2, 0.09)],
        weights: vec![on_shaft(0, 0.0, 0.01), on_shaft(1, 0.0, 0.01)],
        ..Default::default()
    }
}

/// One shaft of first order in a box beside the crank, with two weights on the crank.
fn one_shaft(ratio: i32, planes: &[f64]) -> BalanceTask {
    let beside = FreeShaft {
        x: Place::Between(-0.1, 0.1),
        y: Place::Between(0.05, 0.12),
        ..shaft("beside", ratio, 0.0, 0.0)
    };
    let mut weights: Vec<FreeWeight> = planes.iter().map(|&z| on_shaft(0, z, 0.02)).collect();
    weights.extend([crank(0.0, 0.05), crank(0.1, 0.05)]);
    BalanceTask { shafts: vec![beside], weights, ..Default::default() }
}

/// Ordinary questions: proved to the gap within a few hundred boxes.
#[test]
fn ordinary_questions_are_proved_in_a_few_hundred_boxes() {
    use Load::{Couple, Force, RollMoment};
    let ask = |task: BalanceTask, stages: &[&[(f64, Load)]], limits: &[(Load, f64)]| BalanceTask {
        stages: stages.iter().map(|terms| weighted(terms)).collect(),
        limits: limits.iter().map(|&(load, most)| limit(load, most)).collect(),
        ..task
    };
    let roll: &[(f64, Load)] = &[(1.0, RollMoment)];
    let force: &[(f64, Load)] = &[(1.0, Force)];
    for (name, task) in [
        ("in-line-4", ask(pair(0.0), &[force, roll], &[])),
        ("in-line-4", ask(pair(0.02), &[force, roll], &[])),
        ("in-line-4", ask(pair(0.0), &[&[(1.0, Force), (10.0, RollMoment)]], &[])),
        ("in-line-4", ask(pair(0.02), &[roll], &[(Force, 1000.0)])),
        ("in-line-4", ask(pair(0.0), &[force], &[(RollMoment, 350.0)])),
        ("twin-270", ask(one_shaft(-1, &[-0.05, 0.05]), &[force, roll], &[])),
        ("twin-270", ask(one_shaft(-1, &[-0.05, 0.05]), &[force], &[(RollMoment, 300.0)])),
        ("twin-270", ask(one_shaft(-1, &[0.0]), &[&[(1.0, Force), (10.0, RollMoment), (10.0, Couple)]], &[])),
        ("single", ask(one_shaft(-1, &[0.0]), &[&[(1.0, Force), (10.0, RollMoment)]], &[])),
    ] {
        let engine = stripped(name);
        let answer = optimise(&engine, &task).unwrap();
        assert_proved(&engine, &answer);
        let Method::BranchAndBound { nodes, .. } = answer.method else { panic!("{:?}", answer.method) };
        assert!(nodes <= 400, "{name}: {nodes} boxes for {:?} {:?}", task.stages, task.limits);
        for limit in &answer.limits {
            assert!(limit.value <= limit.most * (1.0 + 1e-9), "{name}: {limit:?}");
        }
    }
}

/// Axis areas, planes and amounts as numbers between 0 and 1.
#[derive(Debug, Clone)]
struct Draft {
    ratio: i32,
    area: [f64; 4],
    planes: Vec<f64>,
    most: f64,
}

fn draft() -> impl Strategy<Value = Draft> {
    let share = || 0.0..1.0f64;
    let ratio = proptest::sample::select(&[-2, -1, 1, 2][..]);
    (ratio, [share(), share(), share(), share()], proptest::collection::vec(share(), 1..3), share())
        .prop_map(|(ratio, area, planes, most)| Draft { ratio, area, planes, most })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, ..ProptestConfig::default() })]

    #[test]
    fn prop_no_axis_in_its_area_goes_below_the_bound(
        name in proptest::sample::select(&["single", "twin-270", "in-line-3", "v4-90", "v6-60"][..]),
        drafts in proptest::collection::vec(draft(), 1..3),
        crank_weights in proptest::collection::vec(0.0..1.0f64, 0..3),
        lever in 0.05..0.35f64,
        roll in 1.0..4.0f64,
        seed in any::<u64>(),
    ) {
        let engine = stripped(name);
        let scale = all_masses(&engine) / engine.speed.highest.powi(2);
        let mut task = BalanceTask::default();
        for (k, one) in drafts.iter().enumerate() {
            let corner = |share: f64| 0.2 * share - 0.1;
            let [x, y, wide, high] = one.area;
            task.shafts.push(FreeShaft {
                x: Place::Between(corner(x), corner(x) + 0.1 * wide + 1e-3),
                y: Place::Between(corner(y), corner(y) + 0.1 * high + 1e-3),
                ..shaft(&format!("shaft {k}"), one.ratio, 0.0, 0.0)
            });
            task.weights.extend(one.planes.iter().map(|&z| on_shaft(k, corner(z), 0.3 * one.most * scale + 1e-4)));
        }
        task.weights.extend(crank_weights.iter().map(|&z| crank(0.2 * z - 0.1, 0.3 * scale)));
        task.stages = vec![weighted(&[(lever, Load::Force), (1.0, Load::Couple), (roll, Load::RollMoment)])];
        let answer = optimise(&engine, &task).unwrap();
        let (value, bound) = (answer.stages[0].value, answer.stages[0].lower_bound);
        proved_or_told(&engine, &answer).map_err(TestCaseError::fail)?;
        for (free, found) in task.shafts.iter().zip(&answer.shafts) {
            for (place, at) in [(free.x, found.x), (free.y, found.y)] {
                let Place::Between(low, high) = place else { unreachable!("every axis is free") };
                prop_assert!((low..=high).contains(&at), "{} outside {} .. {}", at, low, high);
            }
        }
        let mut state = seed | 1;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        for _ in 0..8 {
            let mut chosen = task.clone();
            for place in chosen.shafts.iter_mut().flat_map(|shaft| [&mut shaft.x, &mut shaft.y]) {
                let Place::Between(low, high) = *place else { unreachable!("every axis is free") };
                // Corners as often as what lies between them.
                *place = Place::At(low + (high - low) * (2.0 * random() - 0.5).clamp(0.0, 1.0));
            }
            let other = optimise(&engine, &chosen).unwrap().stages[0].value;
            let scale = all_masses(&engine);
            prop_assert!(other >= bound - 1e-10 * scale, "{} below {}", other, bound);
            prop_assert!(other >= value * (1.0 - 1e-7) - 1e-10 * scale, "{} better than {}", other, value);
        }
    }
}
