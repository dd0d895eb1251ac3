//! Searches that end early: by number of nodes, by whoever watches, at a wider gap. Never by the clock.

use crate::optimum::support::*;
use lanchester_balance::{
    Answer, BalanceError, BalanceSettings, Method, Next, Outcome, StopCause, optimise, optimise_watched,
};
use lanchester_model::*;
use lanchester_task::*;
use std::cell::RefCell;

const FULL: BalanceSettings = BalanceSettings { gap: 1e-8, max_nodes: 2000, time_limit: None };

/// Two of six weights of free phase, neither small: many nodes until the proof is closed.
fn task() -> (Engine, BalanceTask) {
    let optional = |z: f64| FreeWeight {
        least: 0.02,
        most: Some(0.05),
        optional: true,
        ..on_crank(&format!("at {z}"), z)
    };
    let task = BalanceTask {
        weights: [-0.16, -0.1, -0.04, 0.03, 0.08, 0.15].map(optional).to_vec(),
        stages: vec![stage(Load::Couple), stage(Load::Force)],
        most_optional: Some(2),
        ..Default::default()
    };
    (stripped("v4-90"), task)
}

fn nodes(answer: &Answer) -> usize {
    match answer.method {
        Method::BranchAndBound { nodes, .. } => nodes,
        Method::Convex { .. } => panic!("a search over choices"),
    }
}

/// The answer where whoever watches wants it after so many nodes.
fn stopped_after(engine: &Engine, task: &BalanceTask, most: usize) -> Answer {
    let watch = |state: &lanchester_balance::SearchState| match state.nodes >= most {
        true => Next::Stop(StopCause::Cancelled),
        false => Next::Continue,
    };
    optimise_watched(engine, task, None, &FULL, &watch).expect("a valid task")
}

#[test]
fn a_search_that_is_stopped_has_its_best_and_a_bound_that_holds() {
    let (engine, task) = task();
    let whole = optimise(&engine, &task).unwrap();
    assert_proved(&engine, &whole);
    let best = whole.stages[0].value;
    let mut before = (f64::INFINITY, 0.0f64);
    for most in [1, 2, 3, 5, 9] {
        assert!(nodes(&whole) > most, "it would have ended by itself: {:?}", whole.method);
        let answer = stopped_after(&engine, &task, most);
        assert_eq!(nodes(&answer), most);
        let Outcome::Stopped { reason, cause } = &answer.outcome else { panic!("{:?}", answer.outcome) };
        assert_eq!(*cause, StopCause::Cancelled);
        assert!(
            reason.contains(&format!("cancelled after {most} node")) && reason.contains("gap"),
            "{reason}"
        );
        assert!(answer.weights.iter().filter(|weight| weight.used).count() <= 2, "{:?}", answer.weights);
        for weight in answer.weights.iter().filter(|weight| weight.used) {
            assert!((0.02 - 1e-9..0.05 + 1e-9).contains(&weight.unbalance.norm()), "{weight:?}");
        }
        let found = &answer.stages[0];
        assert!(
            found.lower_bound <= best * (1.0 + 1e-8) && best <= found.value * (1.0 + 1e-8),
            "{found:?} {best}"
        );
        assert!((found.gap - (found.value - found.lower_bound)).abs() < 1e-12 * best);
        // More nodes never know less.
        assert!(
            found.value <= before.0 * (1.0 + 1e-8) && found.lower_bound >= before.1,
            "{found:?} {before:?}"
        );
        before = (found.value, found.lower_bound);
        assert!(
            answer.stages[1].lower_bound >= 0.0 && answer.stages[1].value >= answer.stages[1].lower_bound
        );
    }
}

#[test]
fn a_search_that_is_stopped_before_anything_is_found_says_so() {
    let (engine, task) = task();
    let answer = stopped_after(&engine, &task, 0);
    let Outcome::Stopped { reason, cause } = &answer.outcome else { panic!("{:?}", answer.outcome) };
    assert_eq!(
        (reason.as_str(), *cause),
        ("cancelled after 0 nodes before any feasible point was found", StopCause::Cancelled)
    );
    assert!(answer.stages.is_empty() && answer.weights.is_empty());
}

#[test]
fn a_later_stage_that_is_stopped_leaves_the_earlier_ones_proved() {
    let (engine, task) = task();
    let watch = |state: &lanchester_balance::SearchState| match state.index {
        0 => Next::Continue,
        _ => Next::Stop(StopCause::TimeLimit),
    };
    let whole = optimise(&engine, &task).unwrap();
    let answer = optimise_watched(&engine, &task, None, &FULL, &watch).unwrap();
    let Outcome::Stopped { reason, cause } = &answer.outcome else { panic!("{:?}", answer.outcome) };
    assert_eq!(*cause, StopCause::TimeLimit);
    assert!(reason.contains("in stage 2"), "{reason}");
    let (first, second) = (&answer.stages[0], &answer.stages[1]);
    assert!(first.gap <= 1e-8 * first.value, "{first:?}");
    assert!((first.value - whole.stages[0].value).abs() <= 2e-8 * first.value);
    assert!(
        second.lower_bound <= whole.stages[1].value && whole.stages[1].value <= second.value * (1.0 + 1e-6)
    );
}

#[test]
fn the_largest_number_of_nodes_is_a_setting() {
    let (engine, task) = task();
    let best = optimise(&engine, &task).unwrap().stages[0].value;
    let few = BalanceSettings { max_nodes: 4, ..FULL };
    let answer = optimise_watched(&engine, &task, None, &few, &|_| Next::Continue).unwrap();
    assert!(
        matches!(answer.outcome, Outcome::Stopped { cause: StopCause::MaxNodes, .. }),
        "{:?}",
        answer.outcome
    );
    assert_eq!(answer.settings, few);
    assert!(answer.stages[0].lower_bound <= best && best <= answer.stages[0].value * (1.0 + 1e-8));
}

/// Whatever the gap, nodes are divided until the bound is as near.
#[test]
fn a_wider_gap_ends_the_search_earlier() {
    let engine = stripped("v4-90");
    let given = |z: f64| FreeWeight { least: 0.03, most: Some(0.03), ..on_crank(&format!("at {z}"), z) };
    let task = BalanceTask {
        weights: [-0.16, -0.04, 0.08, 0.15].map(given).to_vec(),
        stages: vec![Stage { terms: vec![(1.0, Criterion::MainRms(Mains::All))] }],
        ..Default::default()
    };
    let whole = optimise(&engine, &task).unwrap();
    let best = whole.stages[0].value;
    let mut last = nodes(&whole);
    for gap in [1e-4, 1e-2, 0.5] {
        let wide = BalanceSettings { gap, ..FULL };
        let answer = optimise_watched(&engine, &task, None, &wide, &|_| Next::Continue).unwrap();
        assert_eq!(answer.outcome, Outcome::Optimal, "{gap}");
        let found = &answer.stages[0];
        assert!(found.gap <= gap * found.value, "{gap}: {found:?}");
        assert!(
            found.lower_bound <= best * (1.0 + 1e-8) && best <= found.value * (1.0 + 1e-8),
            "{gap}: {found:?} {best}"
        );
        assert!(nodes(&answer) <= last, "{gap}: {} after {last}", nodes(&answer));
        last = nodes(&answer);
    }
    assert!(last < nodes(&whole), "{last} of {}", nodes(&whole));
}

#[test]
fn whoever_watches_sees_value_and_bound_close_in() {
    let (engine, task) = task();
    let seen = RefCell::new(Vec::new());
    let watch = |state: &lanchester_balance::SearchState| {
        seen.borrow_mut().push((state.index, state.value, state.bound, state.nodes));
        Next::Continue
    };
    let answer = optimise_watched(&engine, &task, None, &FULL, &watch).unwrap();
    let seen = seen.into_inner();
    assert_eq!(seen.len(), nodes(&answer), "once before each node");
    assert!(seen.windows(2).all(|pair| pair[1].3 > pair[0].3 && pair[1].0 >= pair[0].0));
    for (index, value, bound, _) in &seen {
        let found = &answer.stages[*index];
        assert!(*bound <= found.value * (1.0 + 1e-8), "{bound} {found:?}");
        // An earlier stage may be passed by as much as its gap, which a later one gains from.
        assert!(value.is_none_or(|value| value >= found.lower_bound * (1.0 - 1e-8)), "{value:?} {found:?}");
    }
}

/// That limits cannot hold is proved first; how far they are from it may be left open.
#[test]
fn a_refusal_that_is_stopped_is_still_a_proof() {
    let (engine, mut task) = task();
    let best = optimise(&engine, &task).unwrap().stages[0].value;
    task.limits = vec![Limit { criterion: Criterion::Peak(Load::Couple), most: 0.5 * best }];
    let watch = |state: &lanchester_balance::SearchState| match state.stage {
        Some(_) => Next::Continue,
        None => Next::Stop(StopCause::Cancelled),
    };
    let answer = optimise_watched(&engine, &task, None, &FULL, &watch).unwrap();
    let Outcome::Infeasible { closest, reason, .. } = &answer.outcome else { panic!("{:?}", answer.outcome) };
    assert!(closest.is_empty() && reason.contains("cannot hold together"), "{reason}");
    assert!(matches!(
        optimise_watched(&engine, &task, None, &FULL, &|_| Next::Abandon),
        Err(BalanceError::BrokenOff)
    ));
}

#[test]
fn settings_without_a_meaning_are_refused() {
    let (engine, task) = task();
    for settings in [
        BalanceSettings { gap: 0.0, ..FULL },
        BalanceSettings { gap: f64::NAN, ..FULL },
        BalanceSettings { gap: 0.6, ..FULL },
        BalanceSettings { max_nodes: 0, ..FULL },
        BalanceSettings { time_limit: Some(0.0), ..FULL },
        BalanceSettings { time_limit: Some(f64::INFINITY), ..FULL },
    ] {
        let refused = optimise_watched(&engine, &task, None, &settings, &|_| Next::Continue);
        assert!(matches!(refused, Err(BalanceError::Setting { .. })), "{settings:?}: {refused:?}");
    }
    let limited = BalanceSettings { time_limit: Some(2.0), ..FULL };
    assert_eq!((limited.next(1.9), limited.next(2.0)), (Next::Continue, Next::Stop(StopCause::TimeLimit)));
    assert_eq!(FULL.next(1e9), Next::Continue);
}
