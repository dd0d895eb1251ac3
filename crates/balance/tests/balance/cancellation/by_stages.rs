//! Of all weights that make orders vanish, those that the stages of `balance` put first.

use crate::cancellation::support::*;
use lanchester_balance::*;
use lanchester_file::{read, template};
use lanchester_task::*;

fn effect(answer: &Answer, criterion: Criterion) -> Effect {
    *answer.effects.iter().find(|e| e.criterion == criterion).expect("it is always told")
}

const RMS: Criterion = Criterion::MainRms(Mains::All);
const LARGEST: Criterion = Criterion::Peak(Load::LargestMainLoad);

/// The in-line four of the gallery, whose counterweights change neither force nor couple: they are there for its bearings.
#[test]
fn an_in_line_four_keeps_the_counterweights_that_its_bearings_need() {
    let text = template("in-line-4").expect("a template").text;
    let engine = read(text).engine().expect("a valid template");
    let plain = default_task(&engine);
    assert_eq!(plain.weights.len(), engine.counterweights.len(), "all of its counterweights are free");
    let cancel = vec![(Load::Force, 1.0), (Load::Couple, 1.0)];
    let answer = optimise(&engine, &BalanceTask { cancel, ..plain.clone() }).unwrap();
    assert_eq!(least(&answer), 0.0, "nothing at all would cancel them too");
    assert_vanishes(&engine, &answer);
    // Force and couple of the four vanish in these orders anyway: it is the optimum of `balance` itself.
    let balanced = optimise(&engine, &plain).unwrap();
    for criterion in [RMS, LARGEST, Criterion::Peak(Load::BendingMoment)] {
        let (got, want) = (effect(&answer, criterion), effect(&balanced, criterion));
        assert!((got.after - want.after).abs() < 1e-7 * want.without, "{got:?} {want:?}");
    }
    assert!(effect(&answer, RMS).after < effect(&answer, RMS).before * 1.000_001);
    assert!(effect(&answer, RMS).after < 0.7 * effect(&answer, RMS).without, "{:?}", answer.effects);
    assert!(answer.weights.iter().filter(|w| w.used).count() >= 4, "{:#?}", answer.weights);
    assert_eq!(answer.among_equals[0].terms[0].0, RMS);
    for stage in &answer.among_equals {
        assert!(stage.gap >= 0.0 && stage.gap <= 1e-7 * stage.value, "{stage:#?}");
    }
}

fn least(answer: &Answer) -> f64 {
    let CancellationVerdict::Vanish { least, .. } = &cancellation(answer).verdict else {
        panic!("they vanish: {answer:#?}")
    };
    *least
}

/// A random change that keeps the orders away makes the first stage that it moves no better.
#[test]
fn no_other_weights_that_cancel_are_better_for_the_bearings() {
    let engine = stripped("in-line-3");
    let planes: Vec<f64> = engine.throws.iter().map(|t| t.z).collect();
    let mut three = task(on_crank(&planes), &[(Load::Force, 1.0), (Load::Couple, 1.0)]);
    add_shaft(&mut three, -1, 0.0, 0.1, &[-0.15, 0.15]);
    let answer = optimise(&engine, &three).unwrap();
    assert_vanishes(&engine, &answer);
    // The sums of U and of z U over the crank stay: change of the middle by `d`, of the ends by half of it the other way.
    let rms = effect(&answer, RMS);
    assert!((planes[1] - planes[0] - (planes[2] - planes[1])).abs() < 1e-12);
    let mut changed = 0;
    for turn in 0..8 {
        for amount in [1e-5, 1e-4, 1e-3] {
            let d = num_complex::Complex64::from_polar(amount, f64::from(turn) * 0.785);
            let mut other = answer.clone();
            for (weight, share) in other.weights.iter_mut().zip([-0.5, 1.0, -0.5]) {
                weight.unbalance += share * d;
                weight.used = true;
            }
            let engine = fitted(&engine, &other);
            let judged = as_it_stands(&engine, RMS).expect("it has mains");
            assert!(judged >= rms.after * (1.0 - 1e-9), "{judged} {}", rms.after);
            changed += usize::from(judged > rms.after * (1.0 + 1e-9));
        }
    }
    assert!(changed > 12, "the bearings feel it: {changed}");
}

/// Weights on shafts alone, whose amounts nothing else leaves open, are the lightest as before.
#[test]
fn shafts_alone_are_the_lightest() {
    let engine = stripped("in-line-4");
    let mut shafts = task(Vec::new(), &[(Load::Force, 2.0)]);
    add_shaft(&mut shafts, 2, -0.05, 0.1, &[0.0]);
    add_shaft(&mut shafts, -2, -0.05, -0.1, &[0.0]);
    let answer = optimise(&engine, &shafts).unwrap();
    let total = assert_vanishes(&engine, &answer);
    assert!(answer.among_equals.is_empty() && answer.stages.len() == 1, "{answer:#?}");
    assert!((answer.stages[0].value - total).abs() < 1e-12 * total);
}
