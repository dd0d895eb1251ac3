//! What a stage gives up for later ones, against solves in which a limit stands in its place.

use crate::optimum::support::*;
use lanchester_balance::{Answer, BalanceError, FoundStage, Outcome, optimise};
use lanchester_model::*;
use lanchester_task::*;
use lanchester_testkit::{Within, assert_close};

fn solved(engine: &Engine, task: &BalanceTask) -> Answer {
    let answer = optimise(engine, task).expect("a valid task");
    assert_eq!(answer.outcome, Outcome::Optimal, "{answer:#?}");
    answer
}

/// Two weights on one side of a three, which cannot balance it.
fn one_sided(stages: &[Load], give_up: &[GiveUp]) -> (Engine, BalanceTask) {
    let bounded = |name: &str, z: f64| FreeWeight { most: Some(0.02), ..on_crank(name, z) };
    let weights = vec![bounded("front", -0.1), bounded("middle", -0.02)];
    let stages = stages.iter().map(|load| stage(*load)).collect();
    (stripped("in-line-3"), BalanceTask { weights, stages, give_up: give_up.to_vec(), ..Default::default() })
}

fn limited(task: &BalanceTask, at: usize, limits: &[(Load, f64)]) -> BalanceTask {
    BalanceTask {
        stages: vec![task.stages[at].clone()],
        limits: limits
            .iter()
            .map(|(load, most)| Limit { criterion: Criterion::Peak(*load), most: *most })
            .collect(),
        give_up: Vec::new(),
        ..task.clone()
    }
}

#[track_caller]
fn assert_near(got: f64, want: f64, what: &str) {
    let within =
        Within::of(want.abs().max(1e-9), 2e-8, "the solver's gap, of this stage and of the one before");
    assert_close(what, got, want, within);
}

fn given(stage: &FoundStage) -> lanchester_balance::StageGiveUp {
    stage.give_up.expect("the stage gives up something")
}

#[test]
fn a_share_of_one_stage_is_a_limit_for_the_next() {
    for share in [0.01, 0.2] {
        let (engine, task) = one_sided(&[Load::Couple, Load::Force], &[GiveUp::Share(share)]);
        let answer = solved(&engine, &task);
        let least = solved(&engine, &limited(&task, 0, &[])).stages[0].value;
        let most = (1.0 + share) * least;
        let want = solved(&engine, &limited(&task, 1, &[(Load::Couple, most)])).stages[0].value;
        let couple = given(&answer.stages[0]);
        assert_near(couple.least, least, "the couple by itself");
        assert_near(couple.most, most, "what it may become");
        assert_near(answer.stages[1].value, want, "the force");
        // The force uses all of it, and both proofs are closed.
        assert_near(answer.stages[0].value, most, "the couple that is left");
        assert_near(couple.used, share * least, "what is used");
        for stage in &answer.stages {
            assert!(stage.gap >= 0.0 && stage.gap < 1e-7 * stage.value, "{stage:#?}");
        }
        // The gain is told against the strict order of stages.
        let strict = solved(&engine, &BalanceTask { give_up: Vec::new(), ..task.clone() });
        let told = answer.stages[1].without_give_up.expect("the couple gives up something");
        assert_near(told, strict.stages[1].value, "the force without that");
        assert!(
            answer.stages[1].value < told * (1.0 - 1e-3 * share),
            "it gains: {} {told}",
            answer.stages[1].value
        );
        assert!(strict.stages.iter().all(|s| s.give_up.is_none() && s.without_give_up.is_none()));
    }
}

#[test]
fn amounts_and_shares_add_up_over_stages() {
    let give_up = [GiveUp::Amount(3.0), GiveUp::Share(0.05)];
    let (engine, task) = one_sided(&[Load::Couple, Load::Force, Load::LargestMainLoad], &give_up);
    let answer = solved(&engine, &task);
    let couple = solved(&engine, &limited(&task, 0, &[])).stages[0].value + 3.0;
    let force = 1.05 * solved(&engine, &limited(&task, 1, &[(Load::Couple, couple)])).stages[0].value;
    let limits = [(Load::Couple, couple), (Load::Force, force)];
    let want = solved(&engine, &limited(&task, 2, &limits)).stages[0].value;
    assert_near(answer.stages[2].value, want, "the largest main load");
    assert!(
        answer.stages[0].value <= couple * (1.0 + 1e-9) && answer.stages[1].value <= force * (1.0 + 1e-9)
    );
    assert_near(given(&answer.stages[1]).least, force / 1.05, "the force by itself");
}

#[test]
fn what_decides_among_equals_uses_it_too() {
    // The default stages: what couple gives up goes to the loads of the main bearings.
    let (engine, task) = one_sided(&[], &[GiveUp::Nothing, GiveUp::Share(0.1)]);
    let strict = solved(&engine, &BalanceTask { give_up: Vec::new(), ..task.clone() });
    let answer = solved(&engine, &task);
    let rms = |answer: &Answer| {
        answer
            .effects
            .iter()
            .find(|e| e.criterion == Criterion::MainRms(Mains::All))
            .expect("always told")
            .after
    };
    assert!(rms(&answer) < rms(&strict) * (1.0 - 1e-4), "{} {}", rms(&answer), rms(&strict));
    assert_near(answer.stages[0].value, strict.stages[0].value, "the force");
    let couple = given(&answer.stages[1]);
    assert!(couple.used > 0.0 && answer.stages[1].value <= couple.most * (1.0 + 1e-9));
    let told = answer.among_equals[0].without_give_up.expect("the couple gives up something");
    assert_near(told, rms(&strict), "the loads without that");
}

#[test]
fn nothing_and_what_vanishes_give_up_nothing() {
    let (engine, task) = one_sided(&[Load::Couple, Load::Force], &[GiveUp::Share(0.0)]);
    let strict = solved(&engine, &BalanceTask { give_up: Vec::new(), ..task.clone() });
    let answer = solved(&engine, &task);
    assert!(answer.stages[0].give_up.is_none());
    assert_eq!(answer.weights, strict.weights);
}

#[test]
fn what_has_no_meaning_is_refused() {
    let (engine, task) = one_sided(&[Load::Couple, Load::Force], &[]);
    for give_up in [
        vec![GiveUp::Share(-0.01)],
        vec![GiveUp::Amount(f64::NAN)],
        vec![GiveUp::Nothing, GiveUp::Nothing, GiveUp::Share(0.1)],
    ] {
        let refused = optimise(&engine, &BalanceTask { give_up, ..task.clone() });
        assert!(matches!(refused, Err(BalanceError::Number { .. })), "{refused:?}");
    }
    // Nothing is decided after the last stage where all that decides is named.
    let named = [Load::Force, Load::Couple].map(stage);
    let shafts = vec![shaft("lower", -1, 0.0, 0.1)];
    let weights = vec![weight("lower 1", Seat::Shaft(0), 0.0)];
    let task = BalanceTask {
        shafts,
        weights,
        stages: named.to_vec(),
        give_up: vec![GiveUp::Nothing, GiveUp::Share(0.1)],
        ..Default::default()
    };
    let refused = optimise(&engine, &task);
    assert!(matches!(refused, Err(BalanceError::Unsuited { .. })), "{refused:?}");
}
