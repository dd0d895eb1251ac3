//! What a combination of the equations says of every choice of the devices: weighed here, whoever proposed it.
//!
//! ```text
//! matrix u = right   =>   right . m = u . g    g = matrix^T m
//!                         u . g <= SUM over devices of |u_i| |g_i|      (one-sided: u_i max(g_i, 0))
//! SUM c_i |u_i|  >=  right . m - SUM (|g_i| - c_i)_+ most_i
//! ```
//! for every `u` within the bounds, if `|g_i| <= c_i` where nothing bounds `u_i`. With `c = 0` the left is 0: a right side
//! above 0 says that there is no such `u` (the conic lemma of Farkas).

use super::answer::{Functional, FunctionalTerm};
use super::equations::{Device, Equations, RANK};
use crate::convex::dense::{Matrix, RowFactors, dot, norm};
use lanchester_task::BalanceTask;
use num_complex::Complex64;

/// Terms below this share of the largest are rounding.
const NOISE: f64 = 1e-9;

/// A combination of the equations, weighed against the costs of the devices.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Weighed {
    /// One a row of the equations.
    pub multipliers: Vec<f64>,
    /// Device and what it can do against the combination at most.
    pub charges: Vec<(usize, f64)>,
    pub value: f64,
    /// Largest pull of a device without a largest amount over its cost; over the most that a combination of this size
    /// can pull where the cost is 0.
    pub pull: f64,
}

/// Weighs `multipliers` against one cost a device.
pub(super) fn weigh(equations: &Equations, multipliers: &[f64], costs: &[f64]) -> Weighed {
    let mut gradient = vec![0.0; equations.matrix.columns];
    equations.matrix.add_transposed(multipliers, 1.0, &mut gradient);
    let mut value = dot(&equations.right, multipliers);
    let (mut charges, mut pull) = (Vec::new(), 0.0f64);
    for (index, (device, cost)) in equations.devices.iter().zip(costs).enumerate() {
        let size = pull_of(device, &gradient);
        match device.most {
            Some(most) if size > *cost => {
                value -= (size - cost) * most;
                charges.push((index, (size - cost) * most));
            }
            Some(_) => {}
            None => {
                let against = if *cost > 0.0 { *cost } else { farthest(equations, device, multipliers) };
                pull = pull.max(if size > 0.0 { size / against } else { 0.0 });
            }
        }
    }
    Weighed { multipliers: multipliers.to_vec(), charges, value, pull }
}

/// What a combination pulls at a device.
fn pull_of(device: &Device, gradient: &[f64]) -> f64 {
    if device.one_sided {
        device.variables.iter().map(|&v| gradient[v].max(0.0)).sum()
    } else {
        device.variables.iter().map(|&v| gradient[v] * gradient[v]).sum::<f64>().sqrt()
    }
}

/// The most that a combination of this size can pull at a device.
fn farthest(equations: &Equations, device: &Device, multipliers: &[f64]) -> f64 {
    let square = |v: usize| (0..multipliers.len()).map(|r| equations.matrix[(r, v)].powi(2)).sum::<f64>();
    norm(multipliers) * device.variables.iter().map(|&v| square(v)).sum::<f64>().sqrt()
}

/// The multipliers without what pulls at devices that nothing bounds.
pub(super) fn released(equations: &Equations, multipliers: &[f64]) -> Vec<f64> {
    let mut gradient = vec![0.0; equations.matrix.columns];
    equations.matrix.add_transposed(multipliers, 1.0, &mut gradient);
    let pulled = |device: &&Device| device.most.is_none() && pull_of(device, &gradient) > 0.0;
    let mut columns = Matrix::zeros(0, equations.matrix.rows);
    for &v in equations.devices.iter().filter(pulled).flat_map(|d| &d.variables) {
        let column: Vec<f64> = (0..equations.matrix.rows).map(|r| equations.matrix[(r, v)]).collect();
        columns.push(&column);
    }
    let (range, _) = RowFactors::of(&columns, RANK).bases();
    let mut along = vec![0.0; range.columns];
    range.add_transposed(multipliers, 1.0, &mut along);
    multipliers.iter().zip(range.times(&along)).map(|(m, pull)| m - pull).collect()
}

impl Weighed {
    /// As plain data; `unit` is what a value of 1 is in its own unit.
    pub fn functional(&self, equations: &Equations, task: &BalanceTask, unit: f64) -> Functional {
        let factor = |k: usize| Complex64::new(self.multipliers[2 * k], self.multipliers[2 * k + 1]);
        let largest = (0..equations.parts.len()).map(|k| factor(k).norm()).fold(0.0, f64::max);
        let mut terms = Vec::new();
        for (k, part) in equations.parts.iter().enumerate() {
            if factor(k).norm() > NOISE * largest {
                terms.push(FunctionalTerm {
                    criterion: part.criterion,
                    sense: part.sense,
                    factor: factor(k) * unit / part.scale,
                    amount: part.amount,
                });
            }
        }
        let name = |device: usize| match equations.devices[device].weight {
            Some(weight) => task.weights[weight].name.clone(),
            None => task.inertias.first().map_or(String::new(), |inertia| inertia.name.clone()),
        };
        Functional {
            terms,
            charges: self.charges.iter().map(|&(device, charge)| (name(device), charge * unit)).collect(),
            value: self.value * unit,
            largest_pull: self.pull,
        }
    }
}
