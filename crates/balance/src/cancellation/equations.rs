//! What must vanish as linear equations in the free unbalances, scaled to numbers about 1.
//!
//! ```text
//! one order of a load over the cycle:   F_x + i F_y = f_+ e^{i n theta} + f_- e^{-i n theta}     (force, couple)
//!                                       M_z = Re( m e^{i n theta} )                              (one component)
//! f_+ = 0, f_- = 0, m = 0               each a complex equation  a u = -f_0
//! ```
//! Loads are measured against those of all moving masses at their largest acceleration, unbalances against the one that
//! would make such a load; ties are further equations with nothing on the right.

use super::answer::OrderSense;
use crate::convex::dense::Matrix;
use crate::criterion::{order_key, vectors};
use crate::error::BalanceError;
use crate::operator::Operator;
use crate::wave::Wave;
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Criterion, Load, Phase, criterion_unit};
use num_complex::Complex64;

/// Share of all moving masses' loads below which a load is rounding.
const ROUNDING: f64 = 1e-13;

/// One rotating or alternating part of an order that must vanish.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Part {
    /// Load and order; the largest mount force by its mounts.
    pub criterion: Criterion,
    pub sense: OrderSense,
    /// What 1 of its row is [N or N m].
    pub scale: f64,
    /// Without the free devices [N or N m].
    pub amount: Complex64,
    /// What 1 of each variable of the operator adds, by variable [N or N m].
    pub columns: Vec<(usize, Complex64)>,
}

/// A free weight, or the free inertia, in natural amounts.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Device {
    pub variables: Vec<usize>,
    /// The variable is not negative.
    pub one_sided: bool,
    /// Largest amount, in natural amounts.
    pub most: Option<f64>,
    /// What a natural amount is [kg m]; 1 for the inertia's share.
    pub natural: f64,
    /// Index among the weights of the task; `None` for the inertia.
    pub weight: Option<usize>,
}

/// `matrix u = right` with bounds on the devices.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Equations {
    pub parts: Vec<Part>,
    /// Real and imaginary row of every part, then the ties.
    pub matrix: Matrix,
    pub right: Vec<f64>,
    /// Variable of the operator over that of the equations.
    pub stretch: Vec<f64>,
    pub devices: Vec<Device>,
}

impl Equations {
    /// The orders of `task.cancel` with the devices of `operator`.
    pub fn new(engine: &Engine, task: &BalanceTask, operator: &Operator) -> Result<Equations, BalanceError> {
        let mut stretch = vec![1.0; operator.variables];
        let mut devices = Vec::new();
        for (index, (weight, free)) in operator.weights.iter().zip(&task.weights).enumerate() {
            let natural = operator.natural_force / (weight.ratio.value() * operator.speed).powi(2);
            let variables: Vec<usize> = weight.corners[0].terms.iter().map(|t| t.0).collect();
            variables.iter().for_each(|&v| stretch[v] = natural / weight.unit);
            devices.push(Device {
                variables,
                one_sided: matches!(free.phase, Phase::Direction(_)),
                most: free.most.map(|most| most / natural),
                natural,
                weight: Some(index),
            });
        }
        if let Some((variable, most)) = operator.inertia {
            devices.push(Device {
                variables: vec![variable],
                one_sided: true,
                most: Some(most),
                natural: 1.0,
                weight: None,
            });
        }
        let mut parts = Vec::new();
        for &(load, order) in &task.cancel {
            parts.extend(parts_of(engine, operator, load, order)?);
        }
        let (mut matrix, mut right) = (Matrix::zeros(0, operator.variables), Vec::new());
        for part in &parts {
            let mut rows = [vec![0.0; operator.variables], vec![0.0; operator.variables]];
            for &(variable, column) in &part.columns {
                let column = column * stretch[variable] / part.scale;
                rows[0][variable] += column.re;
                rows[1][variable] += column.im;
            }
            rows.iter().for_each(|row| matrix.push(row));
            right.extend([-part.amount.re / part.scale, -part.amount.im / part.scale]);
        }
        for i in 0..operator.equalities.rows {
            let mut row = operator.equalities.row(i).to_vec();
            row.iter_mut().zip(&stretch).for_each(|(value, stretch)| *value *= stretch);
            let largest = row.iter().fold(0.0f64, |a, b| a.max(b.abs()));
            if largest > 0.0 {
                row.iter_mut().for_each(|value| *value /= largest);
                matrix.push(&row);
                right.push(0.0);
            }
        }
        Ok(Equations { parts, matrix, right, stretch, devices })
    }

    /// The variables of the operator.
    pub fn unscaled(&self, u: &[f64]) -> Vec<f64> {
        u.iter().zip(&self.stretch).map(|(u, stretch)| u * stretch).collect()
    }

    /// Amount of a device at `u`, in natural amounts.
    pub fn size(&self, device: &Device, u: &[f64]) -> f64 {
        device.variables.iter().map(|&v| u[v] * u[v]).sum::<f64>().sqrt()
    }

    /// The largest that any equation is off.
    pub fn residual(&self, u: &[f64]) -> f64 {
        let left = self.matrix.times(u);
        left.iter().zip(&self.right).map(|(left, right)| (left - right).abs()).fold(0.0, f64::max)
    }
}

/// The parts of one order of a load.
pub(super) fn parts_of(
    engine: &Engine,
    operator: &Operator,
    load: Load,
    order: f64,
) -> Result<Vec<Part>, BalanceError> {
    if !(order.is_finite() && order > 0.0) {
        return Err(BalanceError::Number {
            quantity: "order to cancel",
            device: engine.name.clone(),
            needed: "above 0",
            got: order,
        });
    }
    if load == Load::BendingMoment {
        return Err(BalanceError::Unsuited {
            method: "exact cancellation",
            needed: "loads on the engine's block",
            got: "the bending moment of the crankshaft".into(),
            hint: "make it small with `minimise`",
        });
    }
    if load.counts_gas() {
        return Err(BalanceError::Unsuited {
            method: "exact cancellation",
            needed: "loads of inertia",
            got: "a force at mounts with gas".into(),
            hint: "leave \"with gas\" out, or make it small with `minimise`",
        });
    }
    let (vectors, force) = vectors(engine, operator, load)?;
    let scale = if force { operator.natural_force } else { operator.natural_moment };
    let key = order_key(order, operator.grid.revolutions);
    let mut parts = Vec::new();
    for (index, waves) in vectors.iter().enumerate() {
        let load = if load == Load::LargestMountForce { Load::MountForce(index) } else { load };
        let criterion = Criterion::Order(load, order);
        let mut push = |sense: OrderSense, waves: &[Wave]| {
            let mut columns: Vec<(usize, Complex64)> = Vec::new();
            for (m, wave) in waves.iter().enumerate() {
                for &(variable, _, pair) in wave.parts.iter().filter(|p| p.1 == key) {
                    let column = coefficient(sense, m, pair);
                    match columns.iter_mut().find(|c| c.0 == variable) {
                        Some(known) => known.1 += column,
                        None => columns.push((variable, column)),
                    }
                }
            }
            let amount = waves
                .iter()
                .enumerate()
                .map(|(m, wave)| coefficient(sense, m, wave.base.get(&key).copied().unwrap_or([0.0; 2])))
                .sum::<Complex64>();
            let amount = if amount.norm() > ROUNDING * scale { amount } else { Complex64::ZERO };
            parts.push(Part { criterion, sense, scale, amount, columns });
        };
        if let [x, y, ..] = &waves[..] {
            let across = [x.clone(), y.clone()];
            push(OrderSense::Forward, &across);
            push(OrderSense::Backward, &across);
        }
        if let [alone] | [_, _, alone] = &waves[..] {
            push(OrderSense::Alternating, std::slice::from_ref(alone));
        }
    }
    debug_assert!(
        parts.iter().all(|p| (criterion_unit(&p.criterion) == "N") == force),
        "invariant: parts are of the load's kind"
    );
    Ok(parts)
}

/// What `cos` and `sin` of component `m` add to a part: `f_+- = (C -+ i S) / 2` with `C = c_x + i c_y`, `m = c - i s`.
fn coefficient(sense: OrderSense, m: usize, [cos, sin]: [f64; 2]) -> Complex64 {
    let along = if m == 0 { Complex64::ONE } else { Complex64::I };
    match sense {
        OrderSense::Forward => 0.5 * along * Complex64::new(cos, -sin),
        OrderSense::Backward => 0.5 * along * Complex64::new(cos, sin),
        OrderSense::Alternating => Complex64::new(cos, -sin),
    }
}

/// Rows and columns that depend on others to within this share of the longest depend on them: the matrix comes from
/// geometry alone, exact to rounding.
pub(super) const RANK: f64 = 1e-12;
