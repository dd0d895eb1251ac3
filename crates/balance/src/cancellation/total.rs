//! What is made small where orders vanish: the mass of all weights where every one has a radius, else the sum of their
//! amounts.

use super::equations::Equations;
use super::lightest::Lightest;
use crate::answer::{FoundLimit, FoundStage, LimitSide};
use crate::operator::{inertia_of, share_of};
use lanchester_task::{BalanceTask, Criterion, criterion_unit};

/// The total as a cost of every device.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Total {
    /// Added mass or added unbalance.
    pub criterion: Criterion,
    /// Cost of a natural amount of each device, the largest 1; inertias cost nothing.
    pub costs: Vec<f64>,
    /// What a total of 1 is [kg or kg m].
    pub unit: f64,
}

impl Total {
    pub fn new(task: &BalanceTask, equations: &Equations) -> Total {
        let is_mass = !task.weights.is_empty() && task.weights.iter().all(|w| w.radius.is_some());
        let cost = |natural: f64, weight: Option<usize>| match weight {
            Some(weight) if is_mass => natural / task.weights[weight].radius.unwrap_or(1.0),
            Some(_) => natural,
            None => 0.0,
        };
        let mut costs: Vec<f64> = equations.devices.iter().map(|d| cost(d.natural, d.weight)).collect();
        let largest = costs.iter().copied().fold(0.0, f64::max);
        let unit = if largest > 0.0 { largest } else { 1.0 };
        costs.iter_mut().for_each(|c| *c /= unit);
        let criterion = if is_mass { Criterion::AddedMass } else { Criterion::AddedUnbalance };
        Total { criterion, costs, unit }
    }

    /// The total of a point of the operator, in its unit.
    pub fn of(&self, equations: &Equations, x: &[f64]) -> f64 {
        let u: Vec<f64> = x.iter().zip(&equations.stretch).map(|(x, stretch)| x / stretch).collect();
        let sizes = equations.devices.iter().map(|device| equations.size(device, &u));
        self.unit * self.costs.iter().zip(sizes).map(|(cost, size)| cost * size).sum::<f64>()
    }

    /// The total with its bound.
    pub fn stage(&self, found: &Lightest) -> FoundStage {
        let value = self.unit * found.value;
        // Both are exact to rounding; the bound may end above the value by that much.
        let lower_bound = (self.unit * found.proof.value).min(value);
        FoundStage {
            value,
            lower_bound,
            gap: value - lower_bound,
            give_up: None,
            without_give_up: None,
            unit: criterion_unit(&self.criterion).into(),
            terms: vec![(self.criterion, value)],
            term_weights: vec![1.0],
            active: Vec::new(),
        }
    }

    /// The largest amounts and what each costs: the total would fall by the price for every unit more.
    pub fn limits(&self, task: &BalanceTask, equations: &Equations, found: &Lightest) -> Vec<FoundLimit> {
        let mut limits = Vec::new();
        for (index, device) in equations.devices.iter().enumerate() {
            let Some(most) = device.most else { continue };
            let charge = found.proof.charges.iter().find(|c| c.0 == index).map_or(0.0, |c| c.1);
            let price = self.unit * charge / most;
            let size = equations.size(device, &found.u);
            let stage = (charge > 0.0).then_some(0);
            let price_unit = |unit: &str| {
                stage.map_or(String::new(), |_| format!("{} per {unit}", criterion_unit(&self.criterion)))
            };
            match (device.weight, task.inertias.first()) {
                (Some(weight), _) => limits.push(FoundLimit {
                    what: format!("largest amount of `{}`", task.weights[weight].name),
                    criterion: None,
                    side: LimitSide::AtMost,
                    unit: "kg m".into(),
                    most: most * device.natural,
                    value: size * device.natural,
                    price: price / device.natural,
                    price_unit: price_unit("kg m"),
                    stage,
                }),
                (None, Some(inertia)) => {
                    let Some(most) = inertia.most else { continue };
                    // The share grows with the inertia by this much: a difference that the curve is straight over.
                    let slope =
                        (share_of(inertia, most * (1.0 + 1e-6)) - share_of(inertia, most)) / (1e-6 * most);
                    limits.push(FoundLimit {
                        what: format!("largest inertia of `{}`", inertia.name),
                        criterion: None,
                        side: LimitSide::AtMost,
                        unit: "kg m^2".into(),
                        most,
                        value: inertia_of(inertia, size),
                        price: price * slope,
                        price_unit: price_unit("kg m^2"),
                        stage,
                    });
                }
                (None, None) => {}
            }
        }
        limits
    }
}
