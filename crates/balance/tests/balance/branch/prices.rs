//! Shadow prices of least and given amounts, of later stages and of weighted sums, against central differences of the
//! optimum.

use crate::optimum::support::*;
use lanchester_balance::{Answer, FoundLimit, LimitSide, optimise};
use lanchester_model::*;
use lanchester_task::*;
use lanchester_testkit::{Within, assert_close};

/// Share of a limit that it is moved by for a difference.
const STEP: f64 = 1e-5;

fn proved(engine: &Engine, task: &BalanceTask) -> Answer {
    let answer = optimise(engine, task).expect("a valid task");
    assert_proved(engine, &answer);
    answer
}

/// Central difference of a stage's optimum over a limit that `set` sets.
fn slope(
    engine: &Engine,
    task: &BalanceTask,
    stage: usize,
    at: f64,
    set: &dyn Fn(&mut BalanceTask, f64),
) -> f64 {
    let value = |limit: f64| {
        let mut task = task.clone();
        set(&mut task, limit);
        proved(engine, &task).stages[stage].value
    };
    (value(at * (1.0 + STEP)) - value(at * (1.0 - STEP))) / (2.0 * STEP * at)
}

fn limit<'a>(answer: &'a Answer, what: &str) -> &'a FoundLimit {
    let found = answer.limits.iter().find(|limit| limit.what == what);
    found.unwrap_or_else(|| panic!("{what}: {:#?}", answer.limits))
}

#[track_caller]
fn near(got: f64, want: f64) {
    assert_close("price", got, want, Within::share(1e-4, "what is wanted is a quotient of differences"));
}

/// Force of a single-cylinder engine with one weight on its crank, whose best amount is `best`.
fn of_one_weight(change: impl Fn(&mut FreeWeight, f64)) -> (Engine, BalanceTask) {
    let engine = stripped("single");
    let mut task = BalanceTask {
        weights: vec![on_crank("crank", 0.0)],
        stages: vec![stage(Load::Force)],
        ..Default::default()
    };
    let best = proved(&engine, &task).weights[0].unbalance.norm();
    change(&mut task.weights[0], best);
    (engine, task)
}

#[test]
fn a_least_amount_that_is_active_has_its_price() {
    for phase in [None, Some(2.9)] {
        let (engine, task) = of_one_weight(|weight, best| {
            (weight.least, weight.most) = (1.3 * best, Some(3.0 * best));
            weight.phase = phase.map_or(Phase::Free, Phase::Direction);
        });
        let answer = proved(&engine, &task);
        let least = limit(&answer, "least amount of `crank`");
        assert_eq!((least.side, least.stage), (LimitSide::AtLeast, Some(0)));
        assert_eq!((least.unit.as_str(), least.price_unit.as_str()), ("kg m", "N per kg m"));
        let want = slope(&engine, &task, 0, least.most, &|task, to| task.weights[0].least = to);
        assert!(want > 0.0);
        near(least.price, want);
        assert_eq!(limit(&answer, "largest amount of `crank`").price, 0.0);
    }
}

#[test]
fn a_least_amount_that_is_not_active_costs_nothing() {
    let (engine, task) = of_one_weight(|weight, best| {
        (weight.least, weight.most) = (0.7 * best, Some(3.0 * best));
    });
    let least = &proved(&engine, &task).limits[1];
    assert_eq!((least.what.as_str(), least.price, least.stage), ("least amount of `crank`", 0.0, None));
    assert_eq!(least.price_unit, "");
}

/// Too small a given amount would better be larger, too large a one smaller.
#[test]
fn a_given_amount_has_a_price_of_either_sign() {
    for (factor, sign) in [(0.6, -1.0), (1.6, 1.0)] {
        let (engine, task) = of_one_weight(|weight, best| {
            (weight.least, weight.most) = (factor * best, Some(factor * best));
        });
        let answer = proved(&engine, &task);
        let given = limit(&answer, "given amount of `crank`");
        assert_eq!((given.side, given.stage), (LimitSide::Given, Some(0)));
        assert!(given.price * sign > 0.0, "{given:?}");
        let set = |task: &mut BalanceTask, to: f64| {
            (task.weights[0].least, task.weights[0].most) = (to, Some(to));
        };
        near(given.price, slope(&engine, &task, 0, given.most, &set));
    }
}

/// Two opposed weights leave the force as it is: their largest amount holds up the couple, the second stage.
#[test]
fn a_price_names_the_stage_that_it_belongs_to() {
    let engine = stripped("in-line-3");
    let mut task = BalanceTask {
        weights: vec![on_crank("front", -0.1), on_crank("rear", 0.1)],
        ties: vec![Tie { first: 0, second: 1, factor: -1.0, mirrored: false }],
        stages: vec![stage(Load::Force), stage(Load::Couple)],
        ..Default::default()
    };
    let best = proved(&engine, &task).weights[0].unbalance.norm();
    task.weights[0].most = Some(0.6 * best);
    let answer = proved(&engine, &task);
    let most = limit(&answer, "largest amount of `front`");
    assert_eq!((most.stage, most.price_unit.as_str()), (Some(1), "N m per kg m"));
    let set = |task: &mut BalanceTask, to: f64| task.weights[0].most = Some(to);
    near(most.price, -slope(&engine, &task, 1, most.most, &set));
}

/// Of a weighted sum the price is that of the sum, which has no unit.
#[test]
fn the_price_of_a_weighted_sum_is_that_of_the_sum() {
    let engine = stripped("twin-270");
    let terms =
        vec![(1.0 / 3000.0, Criterion::Peak(Load::Force)), (1.0 / 200.0, Criterion::Peak(Load::Couple))];
    let mut task = BalanceTask {
        weights: vec![on_crank("front", -0.07), on_crank("rear", 0.08)],
        stages: vec![Stage { terms }],
        ..Default::default()
    };
    let free = proved(&engine, &task);
    task.weights[0].most = Some(0.7 * free.weights[0].unbalance.norm());
    let answer = proved(&engine, &task);
    let found = &answer.stages[0];
    assert!(found.is_weighted_sum());
    assert_eq!((found.unit.as_str(), &found.term_weights), ("1", &vec![1.0 / 3000.0, 1.0 / 200.0]));
    let sum = found.terms[0].1 / 3000.0 + found.terms[1].1 / 200.0;
    assert!((found.value - sum).abs() < 1e-12 * sum);
    let most = limit(&answer, "largest amount of `front`");
    assert_eq!((most.stage, most.price_unit.as_str()), (Some(0), "1 per kg m"));
    let set = |task: &mut BalanceTask, to: f64| task.weights[0].most = Some(to);
    near(most.price, -slope(&engine, &task, 0, most.most, &set));
}
