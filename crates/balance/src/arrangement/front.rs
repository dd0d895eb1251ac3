//! The Pareto front of arrangements.
//!
//! One arrangement beats another if it is no worse in residual, roll moment and every price, and better in one. Two
//! numbers count as equal within a share of 1e-6 of the larger one, so that rounding decides nothing.

use crate::arrangement::result::Arrangement;

/// Below this share two numbers are equal.
const EQUAL: f64 = 1e-6;

/// Residual, roll moment and prices of one arrangement.
fn objectives(arrangement: &Arrangement) -> [f64; 8] {
    let price = &arrangement.price;
    [
        arrangement.residual,
        arrangement.roll_moment,
        price.shafts as f64,
        (price.meshes + price.chains) as f64,
        price.mass(),
        price.inertia,
        price.bearing_load,
        price.drive_power,
    ]
}

/// Whether `a` beats `b`; `scale` is what is nothing in each objective.
fn beats(a: &[f64; 8], b: &[f64; 8], scale: &[f64; 8]) -> bool {
    let mut better = false;
    for k in 0..a.len() {
        let margin = EQUAL * a[k].abs().max(b[k].abs()) + scale[k];
        if a[k] > b[k] + margin {
            return false;
        }
        better |= a[k] < b[k] - margin;
    }
    better
}

/// Marks the front among the possible arrangements; its indices by falling residual. `baseline` and `roll` are the
/// criterion and the roll moment with nothing added.
pub(crate) fn mark_front(arrangements: &mut [Arrangement], baseline: f64, roll: f64) -> Vec<usize> {
    let points: Vec<[f64; 8]> = arrangements.iter().map(objectives).collect();
    let mut scale = [0.0; 8];
    (scale[0], scale[1]) = (EQUAL * baseline, EQUAL * roll);
    for k in 0..arrangements.len() {
        arrangements[k].on_front = arrangements[k].possible
            && !(0..arrangements.len())
                .any(|j| j != k && arrangements[j].possible && beats(&points[j], &points[k], &scale));
    }
    let mut front: Vec<usize> = (0..arrangements.len()).filter(|k| arrangements[*k].on_front).collect();
    // In whole steps of what is nothing, so that of equals the first stays first.
    let steps = |k: usize| match arrangements[k].residual {
        residual if scale[0] > 0.0 => (residual / scale[0]).round(),
        residual => residual,
    };
    front.sort_by(|a, b| steps(*b).total_cmp(&steps(*a)).then(a.cmp(b)));
    front
}

/// The simplest that reaches the limit: fewest shafts, then meshes and chains, then mass.
pub(crate) fn simplest(arrangements: &[Arrangement]) -> Option<usize> {
    let reaching = (0..arrangements.len())
        .filter(|k| arrangements[*k].possible && arrangements[*k].reaches_limit == Some(true));
    reaching.min_by(|a, b| {
        let [a, b] = [a, b].map(|k| &arrangements[*k]);
        let count = |x: &Arrangement| (x.shafts.len(), x.price.meshes + x.price.chains);
        count(a)
            .cmp(&count(b))
            .then(a.price.mass().total_cmp(&b.price.mass()))
            .then(a.residual.total_cmp(&b.residual))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const NOTHING: [f64; 8] = [1e-6, 1e-6, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];

    #[test]
    fn worse_in_nothing_and_better_in_something() {
        let a = [1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0];
        let mut b = a;
        assert!(!beats(&a, &b, &NOTHING));
        b[2] = 2.0;
        assert!(beats(&a, &b, &NOTHING) && !beats(&b, &a, &NOTHING));
        b[0] = 0.5;
        assert!(!beats(&a, &b, &NOTHING) && !beats(&b, &a, &NOTHING));
    }

    #[test]
    fn rounding_does_not_beat() {
        let a = [1.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0];
        let b = [1.0 + 1e-9, 1e-9, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0];
        assert!(!beats(&a, &b, &NOTHING) && !beats(&b, &a, &NOTHING));
    }
}
