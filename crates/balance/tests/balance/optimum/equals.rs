//! What decides among answers that the stages leave equal.

use crate::optimum::support::*;
use lanchester_balance::{Answer, Effect, optimise};
use lanchester_file::read;
use lanchester_task::*;

fn effect(answer: &Answer, load: Load) -> Effect {
    *answer.effects.iter().find(|e| e.criterion == Criterion::Peak(load)).expect("always there")
}

fn least(criterion: Criterion) -> Stage {
    Stage { terms: vec![(1.0, criterion)] }
}

/// A task that names the couple alone has the force that it would have had by naming it second.
#[test]
fn the_least_couple_leaves_no_more_force_than_it_must() {
    for name in ["single", "twin-270", "in-line-3", "v2-90", "v6-60"] {
        let engine = stripped(name);
        let task = |stages: &[Load]| BalanceTask {
            weights: [-0.1, 0.03, 0.12].iter().map(|z| on_crank(&format!("{z}"), *z)).collect(),
            stages: stages.iter().map(|load| stage(*load)).collect(),
            ..Default::default()
        };
        let alone = optimise(&engine, &task(&[Load::Couple])).unwrap();
        let both = optimise(&engine, &task(&[Load::Couple, Load::Force])).unwrap();
        assert_proved(&engine, &alone);
        assert_proved(&engine, &both);
        assert_eq!(alone.stages.len(), 1);
        let blocks = [Load::Force, Load::Couple, Load::RollMoment].map(Criterion::Peak);
        assert!(
            both.among_equals.iter().all(|stage| !blocks.contains(&stage.terms[0].0)),
            "{name}: both are asked for, no device acts on the roll moment, and bearings are left"
        );
        let [force, ..] = alone.among_equals.as_slice() else { panic!("{name}: nothing was left open") };
        assert_eq!(force.terms[0].0, Criterion::Peak(Load::Force));
        for load in [Load::Force, Load::Couple] {
            let (a, b) = (effect(&alone, load), effect(&both, load));
            assert!(
                (a.after - b.after).abs() < 1e-8 * b.without.max(1e-6 * all_masses(&engine)),
                "{name} {a:?} {b:?}"
            );
        }
        assert!((force.value - effect(&alone, Load::Force).after).abs() <= 1e-12 * force.value);
    }
}

/// A shaft beside the crankshaft can take roll moment that force and couple leave open: its weights do not turn for that,
/// and its axis, where it is free, stands where the roll moment is least, unless the least weights are asked for.
#[test]
fn roll_moment_decides_where_a_device_is_free_for_its_sake() {
    let engine = stripped("single");
    let peaks = [Load::Force, Load::Couple].map(|load| least(Criterion::Peak(load)));
    let weighed = [peaks.as_slice(), &[least(Criterion::AddedUnbalance)]].concat();
    let task = |x: Place, stages: &[Stage]| BalanceTask {
        shafts: vec![FreeShaft { x, ..shaft("beside", -1, 0.0, 0.1) }],
        weights: vec![
            FreeWeight { most: Some(1.0), ..on_crank("crank", 0.0) },
            FreeWeight { most: Some(1.0), ..weight("beside", Seat::Shaft(0), 0.0) },
        ],
        stages: stages.to_vec(),
        ..Default::default()
    };
    let amount = |a: &Answer| a.weights.iter().map(|w| w.unbalance.norm()).sum::<f64>();
    let block = [Load::Force, Load::Couple, Load::RollMoment].map(Criterion::Peak);
    let criteria = |a: &Answer| a.among_equals.iter().map(|s| s.terms[0].0).collect::<Vec<_>>();
    let named = |a: &Answer| criteria(a).into_iter().filter(|c| block.contains(c)).collect::<Vec<_>>();

    let fixed = optimise(&engine, &task(Place::At(0.0), &[])).unwrap();
    let lightest = optimise(&engine, &task(Place::At(0.0), &weighed)).unwrap();
    assert_proved(&engine, &fixed);
    assert_proved(&engine, &lightest);
    assert_eq!(named(&fixed), []);
    assert!((amount(&fixed) - amount(&lightest)).abs() < 1e-6 * amount(&fixed));

    let found = optimise(&engine, &task(Place::Between(-0.1, 0.15), &[])).unwrap();
    assert_proved(&engine, &found);
    assert_eq!(named(&found), [Criterion::Peak(Load::RollMoment)]);
    let roll = |a: &Answer| effect(a, Load::RollMoment).after;
    assert!((found.among_equals[0].value - roll(&found)).abs() <= 1e-12 * roll(&found));
    for x in (0..=50).map(|k| -0.1 + 0.005 * f64::from(k)) {
        let stages = [peaks.as_slice(), &[least(Criterion::Peak(Load::RollMoment))]].concat();
        let at = optimise(&engine, &task(Place::At(x), &stages)).unwrap();
        assert!(roll(&found) <= roll(&at) * (1.0 + 1e-8), "{x}: {} {}", roll(&found), roll(&at));
    }
    assert!(roll(&found) < 0.99 * roll(&fixed));
    let weighed = optimise(&engine, &task(Place::Between(-0.1, 0.15), &weighed)).unwrap();
    assert_eq!(named(&weighed), []);

    let mut heron = task(Place::At(0.0), &[]);
    heron.inertias.push(FreeInertia {
        name: "heron".into(),
        ratio: 1.0,
        crank_inertia: 0.2,
        most: None,
        optional: false,
    });
    let heron = optimise(&engine, &heron).unwrap();
    assert_eq!(named(&heron), [Criterion::Peak(Load::RollMoment)]);
    assert!(roll(&heron) < 0.9 * roll(&fixed));
    for (a, b) in [(&found, &fixed), (&heron, &fixed)] {
        let (a, b) = (effect(a, Load::Force), effect(b, Load::Force));
        assert!((a.after - b.after).abs() < 1e-8 * b.after, "{a:?} {b:?}");
    }
}

/// What neither the block nor the bearings feel is decided by the weights: crank and shaft at the same order share a couple in
/// many ways, of which the bearings choose one for the crank, and lightness what is left to the shafts.
#[test]
fn what_changes_no_load_is_decided_by_the_weights() {
    let engine = stripped("v6-60");
    let reach = engine.throws.iter().map(|t| t.z.abs()).fold(0.05, f64::max);
    let mut task = BalanceTask::default();
    for (index, ratio) in [1, -1, 2, -2].into_iter().enumerate() {
        task.shafts.push(shaft(&format!("{ratio}"), ratio, 0.0, if index % 2 == 0 { 0.1 } else { -0.1 }));
    }
    for (end, z) in [("front", -reach), ("rear", reach)] {
        task.weights.push(on_crank(&format!("crank {end}"), z));
        for (index, shaft) in task.shafts.iter().enumerate() {
            task.weights.push(weight(&format!("{} {end}", shaft.name), Seat::Shaft(index), 0.8 * z));
        }
    }
    let free = optimise(&engine, &task).unwrap();
    let peaks = [Load::Force, Load::Couple].map(|load| least(Criterion::Peak(load)));
    let of_crank = [
        Criterion::MainRms(Mains::All),
        Criterion::Peak(Load::LargestMainLoad),
        Criterion::Peak(Load::BendingMoment),
        Criterion::AddedUnbalance,
    ];
    task.stages = [peaks.as_slice(), &of_crank.map(least)].concat();
    let lightest = optimise(&engine, &task).unwrap();
    assert_proved(&engine, &free);
    assert_proved(&engine, &lightest);
    let (a, b) = (effect(&free, Load::RollMoment), effect(&lightest, Load::RollMoment));
    assert!((a.after - b.after).abs() < 1e-9 * a.without, "no weight helps the roll moment: {a:?} {b:?}");
    let amount = |a: &Answer| a.weights.iter().map(|w| w.unbalance.norm()).sum::<f64>();
    let (free, lightest) = (amount(&free), amount(&lightest));
    assert!((free - lightest).abs() < 1e-6 * lightest, "{free} {lightest}");
}

/// Of four webs the outer two do it; what the solver leaves on the inner two is no weight.
#[test]
fn leftovers_of_the_solver_are_no_weights() {
    let text = include_str!("../../../../../examples/in-line-3-counterweights.toml");
    let engine = read(text).engine().expect("a valid example");
    let mut task = default_task(&engine);
    // Bearings have a use for all four: the lightest are asked for.
    task.stages = [Criterion::Peak(Load::Force), Criterion::Peak(Load::Couple), Criterion::AddedUnbalance]
        .map(least)
        .into();
    let answer = optimise(&engine, &task).unwrap();
    assert_proved(&engine, &answer);
    let used: Vec<bool> = answer.weights.iter().map(|weight| weight.used).collect();
    assert_eq!(used, [true, false, false, true], "{:?}", answer.weights);
    assert!(answer.weights.iter().all(|weight| weight.used == (weight.unbalance.norm() > 0.0)));
}
