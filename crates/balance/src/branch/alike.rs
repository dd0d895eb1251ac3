//! Devices that may change places: of all orders of them one is enough.

use super::choices::{Choices, Heading, Use, on_shaft};
use lanchester_task::{BalanceTask, FreeWeight, Phase, Place};

/// Pairs of devices, the first before the second, that are the same but for their names.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct Alike {
    weights: Vec<(usize, usize)>,
    shafts: Vec<(usize, usize)>,
}

impl Alike {
    pub fn of(task: &BalanceTask) -> Alike {
        let tied = |w: usize| task.ties.iter().any(|t| t.first == w || t.second == w);
        let pairs = |count: usize| (0..count).flat_map(move |j| (0..j).map(move |i| (i, j)));
        let same = |a: &FreeWeight, b: &FreeWeight| {
            a.z == b.z
                && a.least == b.least
                && a.most == b.most
                && a.phase == b.phase
                && a.optional == b.optional
                && a.radius == b.radius
                && a.cost == b.cost
                && a.catalogue == b.catalogue
                && a.equal_parts == b.equal_parts
        };
        let weights = pairs(task.weights.len())
            .filter(|&(i, j)| {
                let (a, b) = (&task.weights[i], &task.weights[j]);
                !tied(i) && !tied(j) && a.seat == b.seat && same(a, b)
            })
            .collect();
        let shafts = pairs(task.shafts.len())
            .filter(|&(i, j)| {
                let (a, b) = (&task.shafts[i], &task.shafts[j]);
                let (of_a, of_b): (Vec<_>, Vec<_>) =
                    (on_shaft(task, i).collect(), on_shaft(task, j).collect());
                task.shaft_cost(i) == task.shaft_cost(j)
                    && a.ratio == b.ratio
                    && a.x == b.x
                    && a.y == b.y
                    && a.optional == b.optional
                    && of_a.len() == of_b.len()
                    && of_a.iter().chain(&of_b).all(|&w| !tied(w))
                    && of_a.iter().zip(&of_b).all(|(&v, &w)| same(&task.weights[v], &task.weights[w]))
            })
            .collect();
        Alike { weights, shafts }
    }

    /// Whether a box holds choices in the one order that is looked at: used before not used, then by place or, in one
    /// place, by direction. Pairs of weights on shafts that are themselves alike are left to the order of the shafts.
    pub fn in_order(&self, task: &BalanceTask, choices: &Choices) -> bool {
        let passed = |first: [f64; 2], second: [f64; 2]| first[0] > second[1];
        self.weights.iter().all(|&(i, j)| {
            let (a, b) = (&choices.weights[i], &choices.weights[j]);
            let weight = &task.weights[i];
            match (a.usage, b.usage) {
                (Use::No, Use::Yes) => false,
                (Use::Yes, Use::Yes) if matches!(weight.z, Place::Between(..)) => !passed(a.z, b.z),
                (Use::Yes, Use::Yes) if weight.phase == Phase::Free && weight.least > 0.0 => {
                    match (a.heading, b.heading) {
                        (Heading::Sector { start: first, .. }, Heading::Sector { start: second, width }) => {
                            first <= second + width
                        }
                        _ => true,
                    }
                }
                _ => true,
            }
        }) && self.shafts.iter().all(|&(i, j)| {
            let (a, b) = (&choices.shafts[i], &choices.shafts[j]);
            match (a.usage, b.usage) {
                (Use::No, Use::Yes) => false,
                (Use::Yes, Use::Yes) if matches!(task.shafts[i].x, Place::Between(..)) => !passed(a.x, b.x),
                (Use::Yes, Use::Yes) => !passed(a.y, b.y),
                _ => true,
            }
        })
    }
}
