//! Peaks of what is left, straight from the loads of the engine with its new parts: no use is made of the optimum.

use crate::BalanceError;
use lanchester_mechanism::{LoadRequest, Mechanism};
use lanchester_model::Engine;
use lanchester_results::{Components, Trace};

/// Angles in a revolution between which a peak is looked for.
const SCAN: usize = 360;

/// Largest resultant force [N], couple [N m] about the origin and roll moment [N m] over the cycle.
pub(crate) fn peaks(engine: &Engine) -> Result<[f64; 3], BalanceError> {
    let mechanism = Mechanism::new(engine, &LoadRequest { max_order: 1, ..LoadRequest::default() })?;
    let trace = mechanism.trace(SCAN);
    let quantities: [fn(&Components) -> f64; 3] =
        [|c| c.force_x.hypot(c.force_y), |c| c.couple_x.hypot(c.couple_y), |c| c.roll_moment.abs()];
    Ok(quantities.map(|quantity| peak(&mechanism, &trace, quantity)))
}

fn peak(mechanism: &Mechanism, trace: &Trace, quantity: fn(&Components) -> f64) -> f64 {
    let value = |k: usize| {
        quantity(&Components {
            force_x: trace.force_x[k],
            force_y: trace.force_y[k],
            couple_x: trace.couple_x[k],
            couple_y: trace.couple_y[k],
            roll_moment: trace.roll_moment[k],
            shaft_torque: 0.0,
        })
    };
    let values: Vec<f64> = (0..trace.theta.len()).map(value).collect();
    let top = values.iter().copied().fold(0.0, f64::max);
    let step = trace.theta.get(1).copied().unwrap_or_default();
    // Between grid points a peak rises by no more than a small share of the highest one.
    let near = (0..values.len()).filter(|&k| {
        let [before, after] = [values.len() - 1, 1].map(|shift| values[(k + shift) % values.len()]);
        values[k] >= before && values[k] >= after && values[k] > 0.99 * top
    });
    near.map(|k| highest(mechanism, quantity, trace.theta[k], step)).fold(top, f64::max)
}

/// Golden-section search for the highest value within a step to both sides of `theta`.
fn highest(mechanism: &Mechanism, quantity: fn(&Components) -> f64, theta: f64, step: f64) -> f64 {
    let share = 0.5 * (5f64.sqrt() - 1.0);
    let at = |theta: f64| quantity(&mechanism.components(theta));
    let (mut low, mut high) = (theta - step, theta + step);
    let mut inner = [high - share * (high - low), low + share * (high - low)];
    let mut values = inner.map(at);
    for _ in 0..30 {
        if values[0] > values[1] {
            high = inner[1];
            inner = [high - share * (high - low), inner[0]];
            values = [at(inner[0]), values[0]];
        } else {
            low = inner[0];
            inner = [inner[1], low + share * (high - low)];
            values = [values[1], at(inner[1])];
        }
    }
    values[0].max(values[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arrangement::sample::{in_line, twin};
    use lanchester_mechanism::loads;

    #[test]
    fn peaks_are_those_of_the_loads() {
        for engine in [twin(), in_line(&[0.0, 180.0]), in_line(&[0.0, 120.0, 240.0])] {
            let expected = loads(&engine, &LoadRequest::default()).unwrap().total.peaks;
            let found = peaks(&engine).unwrap();
            let expected = [
                expected.force.max.value,
                expected.couple.max.value,
                expected.roll_moment.max.value.max(-expected.roll_moment.min.value),
            ];
            for (found, expected) in found.into_iter().zip(expected) {
                assert!((found - expected).abs() <= 1e-9 * expected.max(1.0), "{found} {expected}");
            }
        }
    }
}
