//! Limits of an answer with their shadow prices.

use crate::answer::{Answer, FoundLimit, LimitSide};
use crate::convex::dense::{RowFactors, add_scaled, dot};
use crate::problem::{Problem, Rule};
use crate::stages::{Reached, StageProof};
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, criterion_name, criterion_unit};

/// A limit with a smaller multiplier, in natural units, is not active: an interior-point method leaves such multipliers.
const ACTIVE: f64 = 1e-9;

/// Every limit; `inertia` is the one that is used.
pub(crate) fn found_limits(
    engine: &Engine,
    problem: &Problem,
    task: &BalanceTask,
    reached: &Reached,
    answer: &Answer,
    inertia: Option<usize>,
) -> Vec<FoundLimit> {
    let mut found = Vec::new();
    for (row, &(rule, unit)) in problem.rules.iter().enumerate() {
        // The first stage that it holds up; a price is the stage's unit over the limit's.
        let is_active = |proof: &StageProof| proof.prices[row] > ACTIVE * proof.scale;
        let priced = reached.stages.iter().position(is_active);
        let priced = priced.map(|stage| (stage, reached.stages[stage].prices[row] / unit));
        let (stage, price) = priced.unzip();
        let price = price.unwrap_or(0.0);
        let of_amount = |what: &str, index: usize, side: LimitSide, most: f64| FoundLimit {
            what: format!("{what} amount of `{}`", task.weights[index].name),
            criterion: None,
            side,
            unit: "kg m".into(),
            most,
            value: answer.weights[index].unbalance.norm(),
            price,
            price_unit: String::new(),
            stage,
        };
        let limit = match rule {
            Rule::Limit(index) => {
                let judged = &problem.limits[index];
                FoundLimit {
                    what: criterion_name(&judged.criterion, engine),
                    criterion: Some(judged.criterion),
                    side: LimitSide::AtMost,
                    unit: criterion_unit(&judged.criterion).into(),
                    most: task.limits[index].most,
                    value: problem.value(judged, &reached.x),
                    price,
                    price_unit: String::new(),
                    stage,
                }
            }
            // Amounts of a catalogue are chosen: no price is that of one.
            Rule::MostAmount(index) | Rule::LeastAmount(index) if task.weights[index].catalogue.is_some() => {
                continue;
            }
            Rule::MostAmount(index) => {
                let most = task.weights[index].most.unwrap_or(f64::INFINITY);
                of_amount("largest", index, LimitSide::AtMost, most)
            }
            Rule::LeastAmount(index) => {
                of_amount("least", index, LimitSide::AtLeast, task.weights[index].least)
            }
            Rule::MostInertia => {
                let Some(index) = inertia else { continue };
                let inertia = &task.inertias[index];
                let Some(most) = inertia.most else { continue };
                let k = inertia.ratio;
                // ds/dJ at the largest inertia.
                let slope =
                    k * (k + 1.0) * inertia.crank_inertia / (inertia.crank_inertia + k * k * most).powi(2);
                FoundLimit {
                    what: format!("largest inertia of `{}`", inertia.name),
                    criterion: None,
                    side: LimitSide::AtMost,
                    unit: "kg m^2".into(),
                    most,
                    value: answer.inertias[index].inertia,
                    price: price * slope,
                    price_unit: String::new(),
                    stage,
                }
            }
            Rule::Plain => continue,
        };
        found.push(limit);
    }
    found.extend(given_amounts(problem, task, reached, answer));
    for limit in &mut found {
        if let Some(stage) = limit.stage {
            limit.price_unit = format!("{} per {}", answer.stages[stage].unit, limit.unit);
        }
    }
    found
}

/// Given amounts in a given direction, where the first stage depends on them: by how much it would fall if they were smaller. Of
/// later stages nothing is stated, as the first one moves with such an amount too.
fn given_amounts(
    problem: &Problem,
    task: &BalanceTask,
    reached: &Reached,
    answer: &Answer,
) -> Vec<FoundLimit> {
    let Some(proof) = reached.stages.first() else { return Vec::new() };
    let slopes = equality_slopes(problem, proof);
    let mut found = Vec::new();
    for &(weight, row) in &problem.given {
        if task.weights[weight].catalogue.is_some() || slopes[row].abs() <= ACTIVE * proof.scale {
            continue;
        }
        let price = slopes[row] / problem.operator.weights[weight].unit;
        found.push(FoundLimit {
            what: format!("given amount of `{}`", task.weights[weight].name),
            criterion: None,
            side: LimitSide::Given,
            unit: "kg m".into(),
            most: task.weights[weight].least,
            value: answer.weights[weight].unbalance.norm(),
            price,
            price_unit: String::new(),
            stage: Some(0),
        });
    }
    found
}

/// How fast the first stage grows with the right side of every equality, in the unit of the stage: its multipliers' slope along the
/// shortest step that changes this right side alone, the same along every such step.
fn equality_slopes(problem: &Problem, proof: &StageProof) -> Vec<f64> {
    let mut slope = vec![0.0; problem.programme.variables];
    for one in &proof.solution.support {
        let member = &problem.programme.groups[one.group].members[one.member];
        member.directions(one.angle).add_transposed(&one.y, proof.scale, &mut slope);
    }
    for (row, price) in problem.programme.rows.iter().zip(&proof.prices) {
        add_scaled(&mut slope, *price, &row.directions);
    }
    let equalities = RowFactors::of(&problem.operator.equalities, 1e-12);
    let step = |row: usize| {
        let mut right = vec![0.0; problem.operator.equalities.rows];
        right[row] = 1.0;
        dot(&slope, &equalities.shortest(&right))
    };
    (0..problem.operator.equalities.rows).map(step).collect()
}
