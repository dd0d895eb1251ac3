//! What a stage gives up for later ones where there are choices.

use crate::optimum::support::*;
use lanchester_balance::{Answer, Outcome, optimise};
use lanchester_model::*;
use lanchester_task::*;

fn solved(engine: &Engine, task: &BalanceTask) -> Answer {
    let answer = optimise(engine, task).expect("a valid task");
    assert_eq!(answer.outcome, Outcome::Optimal, "{answer:#?}");
    answer
}

/// One of three weights may be used: the couple takes another one than the force where it may cost some of it.
#[test]
fn another_choice_may_be_worth_it() {
    let engine = stripped("in-line-3");
    let optional = |name: &str, z: f64| FreeWeight { optional: true, most: Some(0.02), ..on_crank(name, z) };
    let weights = vec![optional("a", -0.1), optional("b", 0.01), optional("c", 0.09)];
    let task = |give_up: Vec<GiveUp>, limits: Vec<Limit>, loads: &[Load]| BalanceTask {
        weights: weights.clone(),
        stages: loads.iter().map(|load| stage(*load)).collect(),
        most_optional: Some(1),
        give_up,
        limits,
        ..Default::default()
    };
    let both = [Load::Couple, Load::Force];
    let mut used = Vec::new();
    for share in [0.02, 0.3, 1.0] {
        let answer = solved(&engine, &task(vec![GiveUp::Share(share)], Vec::new(), &both));
        let least = solved(&engine, &task(Vec::new(), Vec::new(), &[Load::Couple])).stages[0].value;
        let limit = Limit { criterion: Criterion::Peak(Load::Couple), most: (1.0 + share) * least };
        let want = solved(&engine, &task(Vec::new(), vec![limit], &[Load::Force])).stages[0].value;
        let got = answer.stages[1].value;
        assert!((got - want).abs() < 1e-6 * want.max(1e-3), "{share}: {got} {want}");
        let given = answer.stages[0].give_up.expect("it gives up something");
        assert!((given.least - least).abs() < 1e-7 * least, "{given:?} {least}");
        assert!(answer.stages[0].value <= given.most * (1.0 + 1e-7), "{answer:#?}");
        used.push(answer.weights.iter().position(|w| w.used));
    }
    assert!(used.iter().any(|one| *one != used[0]), "the choice changes: {used:?}");
}
