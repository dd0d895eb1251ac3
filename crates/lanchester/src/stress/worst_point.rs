//! The point of a fillet where Findley's value is largest, without a search of planes at every node.
//!
//! No plane has more than the largest shear stress of what varies plus k times the largest principal stress: nodes are searched from the highest such bound on, until
//! it is below what was found.

use lanchester_flex::element::Stress;
use lanchester_strength::{Findley, PointFatigue, StressState, von_mises};

/// Bounds of the nodes seen so far.
pub(crate) struct WorstPoint<'a> {
    findley: &'a Findley,
    bounded: Vec<(f64, usize)>,
    von_mises: f64,
}

/// Where Findley's value is largest.
pub(crate) struct FoundPoint {
    /// Index of the node.
    pub node: usize,
    /// Worst plane and safeties.
    pub point: PointFatigue,
    /// Largest of all nodes over the cycle [Pa].
    pub von_mises: f64,
}

/// Largest shear stress of a state [Pa] and largest principal stress.
fn extremes(state: StressState) -> [f64; 2] {
    let principal = Stress(state).principal();
    [0.5 * (principal[0] - principal[2]), principal[0]]
}

impl<'a> WorstPoint<'a> {
    /// None seen yet.
    pub fn new(findley: &'a Findley) -> WorstPoint<'a> {
        WorstPoint { findley, bounded: Vec::new(), von_mises: 0.0 }
    }

    /// Takes the history of a node.
    pub fn see(&mut self, node: usize, history: &[StressState]) {
        let count = history.len().max(1) as f64;
        let mean: StressState = std::array::from_fn(|i| history.iter().map(|s| s[i]).sum::<f64>() / count);
        let (mut shear, mut normal) = (0.0f64, f64::NEG_INFINITY);
        for state in history {
            self.von_mises = self.von_mises.max(von_mises(state));
            shear = shear.max(extremes(std::array::from_fn(|i| state[i] - mean[i]))[0]);
            normal = normal.max(extremes(*state)[1]);
        }
        self.bounded.push((shear + self.findley.weight * normal, node));
    }

    /// The worst of all, with their histories anew; `None` without any.
    pub fn found(mut self, history: impl Fn(usize) -> Vec<StressState>) -> Option<FoundPoint> {
        self.bounded.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        let mut best: Option<(f64, usize)> = None;
        for (bound, node) in self.bounded {
            if best.is_some_and(|(value, _)| bound <= value) {
                break;
            }
            let value = self.findley.critical_plane(&history(node))?.value;
            if best.is_none_or(|(most, _)| value > most) {
                best = Some((value, node));
            }
        }
        let node = best?.1;
        Some(FoundPoint { node, point: self.findley.safety(&history(node))?, von_mises: self.von_mises })
    }
}
