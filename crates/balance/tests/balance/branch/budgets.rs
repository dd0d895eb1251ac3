//! Costs of weights and shafts against all choices of what is used, one by one.

use crate::optimum::support::*;
use lanchester_balance::{Answer, Outcome, optimise};
use lanchester_model::*;
use lanchester_task::*;

fn solved(engine: &Engine, task: &BalanceTask) -> Answer {
    let answer = optimise(engine, task).expect("a valid task");
    assert_eq!(answer.outcome, Outcome::Optimal, "{answer:#?}");
    answer
}

/// Four weights on a three and two shafts, with their costs.
fn priced() -> (Engine, BalanceTask) {
    let cost = |fixed: f64, per_amount: f64| Cost { fixed, per_amount };
    let bounded =
        |name: &str, z: f64, cost: Cost| FreeWeight { most: Some(0.015), cost, ..on_crank(name, z) };
    let mut weights = vec![
        bounded("a", -0.1, cost(3.0, 100.0)),
        bounded("b", -0.04, cost(1.0, 300.0)),
        bounded("c", 0.05, cost(2.5, 0.0)),
        bounded("d", 0.1, cost(4.0, 50.0)),
    ];
    for (shaft, ends) in [[-0.08, 0.09], [-0.12, 0.03]].into_iter().enumerate() {
        for (k, z) in ends.into_iter().enumerate() {
            let on = weight(&format!("shaft {shaft} {k}"), Seat::Shaft(shaft), z);
            weights.push(FreeWeight { most: Some(0.012), cost: cost(0.0, 20.0), ..on });
        }
    }
    let shafts = vec![shaft("one", -1, 0.0, 0.1), shaft("two", -1, 0.0, -0.12)];
    let task = BalanceTask { shafts, weights, shaft_costs: vec![5.0, 3.5], ..Default::default() };
    (stripped("in-line-3"), task)
}

/// Every set of crank weights and shafts that may be used, with its fixed costs, as a task without choices whose amounts alone
/// cost anything: a cost per amount is a limit or a stage of one cone programme.
fn sets(task: &BalanceTask) -> Vec<(f64, BalanceTask)> {
    let devices = 4 + task.shafts.len();
    (0..1 << devices)
        .map(|set: usize| {
            let is_in = |device: usize| set >> device & 1 == 1;
            let used = |device: usize, weight: &FreeWeight| match weight.seat {
                Seat::Shaft(shaft) => is_in(4 + shaft),
                Seat::Crankshaft(_) => is_in(device),
            };
            let weights = task.weights.iter().enumerate().filter(|(device, weight)| used(*device, weight));
            let free = |weight: &FreeWeight| FreeWeight {
                cost: Cost { fixed: 0.0, ..weight.cost },
                ..weight.clone()
            };
            let mut fixed: f64 = weights.clone().map(|(_, weight)| weight.cost.fixed).sum();
            let weights = weights.map(|(_, weight)| free(weight)).collect();
            let mut own = BalanceTask { weights, ..task.clone() };
            fixed +=
                (0..task.shafts.len()).filter(|&s| is_in(4 + s)).map(|s| task.shaft_cost(s)).sum::<f64>();
            own.shaft_costs.clear();
            (fixed, own)
        })
        .collect()
}

fn cost_of(task: &BalanceTask, answer: &Answer) -> f64 {
    let weights = task.weights.iter().zip(&answer.weights).filter(|(_, found)| found.used);
    let weights: f64 =
        weights.map(|(w, found)| w.cost.fixed + w.cost.per_amount * found.unbalance.norm()).sum();
    let shafts = (0..task.shafts.len()).filter(|&s| answer.shafts[s].used).map(|s| task.shaft_cost(s));
    weights + shafts.sum::<f64>()
}

const COST: Criterion = Criterion::Cost;

fn limit(most: f64) -> Limit {
    Limit { criterion: COST, most }
}

#[test]
fn a_budget_is_spent_on_the_best_devices() {
    let (engine, task) = priced();
    let mut values = Vec::new();
    for budget in [0.0, 4.2, 6.7, 9.3, 13.2, 40.0] {
        let task =
            BalanceTask { stages: vec![stage(Load::Couple)], limits: vec![limit(budget)], ..task.clone() };
        let answer = solved(&engine, &task);
        let mut best = f64::INFINITY;
        for (fixed, own) in sets(&task) {
            if fixed < budget || own.weights.is_empty() {
                let own = BalanceTask { limits: vec![limit(budget - fixed)], ..own };
                let found = solved(&engine, &own);
                best = best.min(found.stages[0].value);
            }
        }
        let stage = &answer.stages[0];
        assert!((stage.value - best).abs() < 1e-7 * best, "{budget}: {} {best}", stage.value);
        assert!(stage.lower_bound <= best * (1.0 + 1e-9));
        let cost = cost_of(&task, &answer);
        assert!(cost <= budget * (1.0 + 1e-8) + 1e-9, "{budget}: {cost}");
        let told = &answer.limits[0];
        assert!(
            told.criterion == Some(COST) && told.unit == "unit" && (told.value - cost).abs() < 1e-6,
            "{told:?} {cost}"
        );
        values.push(stage.value);
    }
    assert!(
        values.windows(2).all(|pair| pair[1] <= pair[0] * (1.0 + 1e-8)) && values[5] < 0.5 * values[0],
        "{values:?}"
    );
}

#[test]
fn the_least_cost_that_holds_a_limit() {
    let (engine, task) = priced();
    let couple = |most: f64| Limit { criterion: Criterion::Peak(Load::Couple), most };
    let least =
        solved(&engine, &BalanceTask { stages: vec![stage(Load::Couple)], ..task.clone() }).stages[0].value;
    let cost = Stage { terms: vec![(1.0, COST)] };
    let asked = BalanceTask { stages: vec![cost], ..task };
    for share in [1.3, 2.0, 2.5] {
        let asked = BalanceTask { limits: vec![couple(share * least)], ..asked.clone() };
        let answer = solved(&engine, &asked);
        let mut best = f64::INFINITY;
        for (fixed, own) in sets(&asked) {
            let found = optimise(&engine, &own).expect("a valid task");
            if found.outcome == Outcome::Optimal {
                best = best.min(fixed + found.stages[0].value);
            }
        }
        let value = answer.stages[0].value;
        assert!((value - best).abs() < 1e-6 * best + 1e-9, "{share}: {value} {best}");
        assert!((cost_of(&asked, &answer) - value).abs() < 1e-6 * value + 1e-9, "{answer:#?}");
        let effect = answer.effects.iter().find(|e| e.criterion == COST).expect("it is asked for");
        assert!(effect.without == 0.0 && (effect.after - value).abs() < 1e-6 * value + 1e-9, "{effect:?}");
    }
}

#[test]
fn costs_go_with_steps_and_optional_devices() {
    let (engine, mut task) = priced();
    task.shafts.clear();
    task.shaft_costs.clear();
    task.keep_weights(|weight| matches!(weight.seat, Seat::Crankshaft(_)));
    for (weight, throw) in task.weights.iter_mut().zip([0, 0, 2, 2]) {
        weight.phase = Phase::Direction(engine.throws[throw].angle + std::f64::consts::PI);
        weight.catalogue = Some(Catalogue::Steps(0.004));
    }
    task.weights[0].optional = true;
    task.weights[3].optional = true;
    task.most_optional = Some(1);
    task.limits = vec![limit(6.6)];
    task.stages = vec![stage(Load::Couple)];
    let answer = solved(&engine, &task);
    // All steps of all four.
    let mut best = f64::INFINITY;
    for number in 0..4usize.pow(4) {
        let steps: Vec<usize> = (0..4).map(|k| number / 4usize.pow(k) % 4).collect();
        let amounts: Vec<f64> = steps.iter().map(|k| 0.004 * *k as f64).collect();
        let used = task.weights.iter().zip(&amounts).filter(|(_, amount)| **amount > 0.0);
        let cost: f64 = used.map(|(w, amount)| w.cost.fixed + w.cost.per_amount * amount).sum();
        if cost > 6.6 || steps[0] > 0 && steps[3] > 0 {
            continue;
        }
        let mut fitted = engine.clone();
        for (weight, amount) in task.weights.iter().zip(&amounts) {
            let (Place::At(z), Phase::Direction(phase)) = (weight.z, weight.phase) else {
                panic!("{weight:?}")
            };
            let angle = phase - engine.crankshafts[0].phase;
            let name = weight.name.clone();
            fitted = fitted
                .with(|fitted| {
                    fitted.counterweights.push(Counterweight {
                        name,
                        crankshaft: 0,
                        z,
                        unbalance: *amount,
                        angle,
                        part: None,
                    });
                })
                .unwrap();
        }
        let couple = Criterion::Peak(Load::Couple);
        best = best.min(lanchester_balance::as_it_stands(&fitted, couple).expect("a load"));
    }
    let value = answer.stages[0].value;
    assert!((value - best).abs() < 1e-8 * best, "{value} {best}");
}

/// Amounts alone that cost something are one convex programme.
#[test]
fn costs_of_amounts_alone_need_no_search() {
    let (engine, mut task) = priced();
    task.weights.iter_mut().for_each(|weight| weight.cost = Cost { fixed: 0.0, per_amount: 10.0 });
    task.shaft_costs.clear();
    task.stages = vec![stage(Load::Couple)];
    task.limits = vec![limit(0.1)];
    let answer = solved(&engine, &task);
    assert!(matches!(answer.method, lanchester_balance::Method::Convex { .. }));
    let by_amount = BalanceTask {
        limits: vec![Limit { criterion: Criterion::AddedUnbalance, most: 0.01 }],
        ..task.clone()
    };
    let want = solved(&engine, &by_amount).stages[0].value;
    assert!((answer.stages[0].value - want).abs() < 1e-8 * want);
    let price = &answer.limits[0];
    assert!(price.price > 0.0 && price.price_unit == "N m per unit", "{price:?}");
}

#[test]
fn an_in_line_four_in_steps_keeps_the_weights_of_its_bearings() {
    let engine = engine("in-line-4");
    let mut task = default_task(&engine);
    let any = solved(&engine, &task);
    let rms = |answer: &Answer| {
        answer
            .effects
            .iter()
            .find(|e| e.criterion == Criterion::MainRms(Mains::All))
            .expect("always told")
            .after
    };
    for (weight, old) in task.weights.iter_mut().zip(&engine.counterweights) {
        weight.catalogue = Some(Catalogue::Steps(0.002));
        weight.phase = Phase::Direction(old.angle + engine.crankshafts[0].phase);
    }
    let answer = optimise(&engine, &task).expect("a valid task");
    assert!(answer.weights.iter().filter(|w| w.used).count() >= 4, "{:#?}", answer.weights);
    let without =
        answer.effects.iter().find(|e| e.criterion == Criterion::MainRms(Mains::All)).unwrap().without;
    assert!(
        rms(&answer) < rms(&any) + 0.1 * (without - rms(&any)),
        "{} {} {without}",
        rms(&answer),
        rms(&any)
    );
}
