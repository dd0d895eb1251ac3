//! What decides among answers that the stages leave equal.

use crate::support::*;
use lanchester_balance::{Answer, Effect, optimise};
use lanchester_model::*;

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
        assert!(
            both.among_equals.is_empty(),
            "{name}: both are asked for, and no device acts on the roll moment"
        );
        let [force] = alone.among_equals.as_slice() else { panic!("{name}: {:?}", alone.among_equals) };
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

/// A shaft beside the crankshaft can take roll moment that force and couple leave open; whoever asks for the least
/// weights does not get it.
#[test]
fn roll_moment_comes_before_the_weights_unless_they_are_asked_for() {
    let engine = stripped("single");
    let task = |stages: Vec<Stage>| BalanceTask {
        shafts: vec![shaft("beside", 1, 0.0, 0.1)],
        weights: vec![on_crank("crank", 0.0), weight("beside", Seat::Shaft(0), 0.0)],
        stages,
        ..Default::default()
    };
    let peaks = [Load::Force, Load::Couple].map(|load| least(Criterion::Peak(load)));
    let free = optimise(&engine, &task(Vec::new())).unwrap();
    let lightest =
        optimise(&engine, &task([peaks.as_slice(), &[least(Criterion::AddedUnbalance)]].concat())).unwrap();
    assert_proved(&engine, &free);
    assert_proved(&engine, &lightest);
    let named: Vec<Criterion> = free.among_equals.iter().map(|s| s.terms[0].0).collect();
    assert_eq!(named, [Criterion::Peak(Load::RollMoment)]);
    assert!(lightest.among_equals.is_empty(), "{:?}", lightest.among_equals);
    let amount = |a: &Answer| a.weights.iter().map(|w| w.unbalance.norm()).sum::<f64>();
    assert!(amount(&lightest) < amount(&free));
    assert!(effect(&free, Load::RollMoment).after < 0.99 * effect(&lightest, Load::RollMoment).after);
    let (a, b) = (effect(&free, Load::Force), effect(&lightest, Load::Force));
    assert!((a.after - b.after).abs() < 1e-8 * b.after, "{a:?} {b:?}");
}

/// A shaft that takes nothing off any load stays empty: crank and shaft at the same order share a couple in many ways,
/// of which the crank alone, with the longer lever, is the lightest.
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
    task.stages = [peaks.as_slice(), &[least(Criterion::AddedUnbalance)]].concat();
    let lightest = optimise(&engine, &task).unwrap();
    assert_proved(&engine, &free);
    assert_proved(&engine, &lightest);
    let (a, b) = (effect(&free, Load::RollMoment), effect(&lightest, Load::RollMoment));
    assert!((a.after - b.after).abs() < 1e-9 * a.without, "no weight helps the roll moment: {a:?} {b:?}");
    let amount = |a: &Answer| a.weights.iter().map(|w| w.unbalance.norm()).sum::<f64>();
    let (free, lightest) = (amount(&free), amount(&lightest));
    assert!((free - lightest).abs() < 1e-6 * lightest, "{free} {lightest}");
}
