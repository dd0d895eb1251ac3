//! What weights and shafts cost that are used: a fixed charge each, and so much for every unit of amount.
//!
//! ```text
//! cost = SUM over used weights of (fixed_i + rate_i |U_i|) + SUM over used shafts of fixed_s
//! not decided:  fixed_i |U_i| / most_i  and  fixed_s max over its weights of |U_i| / most_i      a bound from below
//! ```

use crate::convex::curve::Member;
use crate::convex::dense::Matrix;
use crate::convex::programme::Group;
use crate::fitted::replaces;
use crate::judged::Judged;
use crate::operator::{Operator, WeightColumns};
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Criterion, Seat};

/// The cost of a task in which `optional` says of a weight or shaft that its use is not decided; a weight without corners is not
/// used.
pub(crate) fn judge(
    task: &BalanceTask,
    operator: &Operator,
    amounts: &[Vec<usize>],
    groups: &mut Vec<Group>,
) -> Judged {
    let mut shares: Vec<(usize, f64)> = Vec::new();
    let mut decided = 0.0;
    let used = |weight: usize| !operator.weights[weight].corners.is_empty();
    for (index, (weight, columns)) in task.weights.iter().zip(&operator.weights).enumerate() {
        let mut per_amount = weight.cost.per_amount;
        match weight.most.filter(|most| weight.optional && *most > 0.0) {
            Some(most) => per_amount += weight.cost.fixed / most,
            None if used(index) => decided += weight.cost.fixed,
            None => {}
        }
        if per_amount > 0.0 {
            shares.extend(amounts[index].iter().map(|&group| (group, per_amount * columns.unit)));
        }
    }
    for (index, shaft) in task.shafts.iter().enumerate() {
        let fixed = task.shaft_cost(index);
        let own: Vec<usize> = (0..task.weights.len())
            .filter(|&weight| task.weights[weight].seat == Seat::Shaft(index) && used(weight))
            .collect();
        if fixed <= 0.0 || own.is_empty() {
            continue;
        }
        let bounded: Option<Vec<f64>> = own.iter().map(|&weight| task.weights[weight].most).collect();
        match bounded.filter(|_| shaft.optional) {
            Some(most) => {
                let members = own.iter().zip(most).filter(|(_, most)| *most > 0.0);
                let members = members.map(|(&weight, most)| share(&operator.weights[weight], most, operator));
                groups.push(Group::new(members.collect()));
                shares.push((groups.len() - 1, fixed));
            }
            None => decided += fixed,
        }
    }
    if decided > 0.0 {
        // What stands fast is the amount of a vector that nothing moves.
        let columns =
            Matrix::from_rows(operator.variables, std::iter::once(&vec![0.0; operator.variables][..]));
        groups.push(Group::new(vec![Member::Vector { base: vec![1.0], columns }]));
        shares.push((groups.len() - 1, decided));
    }
    let scale = shares.iter().map(|share| share.1).fold(0.0, f64::max);
    let scale = if scale > 0.0 { scale } else { 1.0 };
    shares.iter_mut().for_each(|share| share.1 /= scale);
    Judged { criterion: Criterion::Cost, groups: shares, largest: None, scale, unbalanced: 0.0 }
}

/// A weight as a share of its largest amount.
fn share(weight: &WeightColumns, most: f64, operator: &Operator) -> Member {
    let mut rows = [vec![0.0; operator.variables], vec![0.0; operator.variables]];
    for &(variable, value) in weight.corners.iter().flat_map(|corner| &corner.terms) {
        rows[0][variable] += value.re / most;
        rows[1][variable] += value.im / most;
    }
    Member::vector(Matrix::from_rows(operator.variables, rows.iter().map(Vec::as_slice)))
}

/// What the weights and shafts of the engine that the task takes over would cost.
pub(crate) fn of_taken_over(engine: &Engine, task: &BalanceTask) -> f64 {
    let mut sum = 0.0;
    for old in engine.counterweights.iter().filter(|old| replaces(task, &old.name)) {
        let new = task.weights.iter().find(|w| matches!(w.seat, Seat::Crankshaft(_)) && w.name == old.name);
        sum += new.map_or(0.0, |new| new.cost.fixed + new.cost.per_amount * old.unbalance);
    }
    for old in &engine.shafts {
        let Some(index) = task.shafts.iter().position(|shaft| shaft.name == old.name) else { continue };
        sum += task.shaft_cost(index);
        let new = task.weights.iter().filter(|weight| weight.seat == Seat::Shaft(index));
        let pairs = new.zip(&old.weights);
        sum += pairs.map(|(new, old)| new.cost.fixed + new.cost.per_amount * old.unbalance).sum::<f64>();
    }
    sum
}
