//! When the cylinders fire: a firing order laid on the dead centres that the crank gives.

mod angle;
mod orders;

pub(crate) use angle::turn;

use crate::problem::Problem;
use angle::{SAME, whole};
use lanchester_model::{Ratio, greatest_common_divisor};
use lanchester_model::{Strokes, working_cycle};
use orders::MOST_LISTED;
use std::f64::consts::TAU;

/// Revolutions of crankshaft 1 beyond which crankshafts have no common period.
const MOST_REVOLUTIONS: u32 = 1 << 16;

/// Angle of crankshaft 1 [rad] after which cylinders on crankshafts of these ratios fire as before: the shortest that is a whole number of
/// revolutions and of their working cycles; without a common one the longest of their cycles.
pub(crate) fn common_cycle(strokes: Strokes, ratios: impl Iterator<Item = Ratio> + Clone) -> f64 {
    let common = ratios.clone().try_fold(1_u32, |all, ratio| {
        // The fewest revolutions R for which R n / d is a whole number of working cycles.
        let own = strokes.revolutions().checked_mul(ratio.denominator())?;
        let own = own / greatest_common_divisor(ratio.numerator().unsigned_abs(), own);
        (all / greatest_common_divisor(all, own)).checked_mul(own).filter(|all| *all <= MOST_REVOLUTIONS)
    });
    match common {
        Some(revolutions) => TAU * f64::from(revolutions),
        None => ratios.map(|ratio| working_cycle(strokes, ratio)).fold(0.0, f64::max),
    }
}

/// Angle [rad] by which the crank stands past the cylinder axis at top dead centre, where crank and rod are in one
/// line: `sin(phi) = offset / (r + l)`. 0 without an offset, or if the reach `r + l` [m] is not known.
pub(crate) fn dead_centre_lead(offset: f64, reach: Option<f64>) -> f64 {
    match reach {
        Some(reach) if offset.abs() < reach => (offset / reach).asin(),
        _ => 0.0,
    }
}

/// Nominal top dead centre of a cylinder: `theta` [rad] where its crankpin passes the cylinder axis (by the lead of
/// [`dead_centre_lead`]), in one revolution of its crankshaft, [0, 2 pi / |ratio|).
///
/// `ratio` is that of its crankshaft, `pin` the angle of its throw at `theta = 0` (crankshaft's phase plus throw's
/// angle), `axis` the direction of the cylinder.
pub(crate) fn nominal_top(ratio: f64, pin: f64, axis: f64, offset: f64, reach: Option<f64>) -> f64 {
    let lead = dead_centre_lead(offset, reach);
    turn((axis + lead - pin) / ratio, TAU / ratio.abs())
}

/// Whether the order names each of the cylinders 1 to `count` once.
pub(crate) fn check_permutation(order: &[usize], count: usize) -> Result<(), Problem> {
    let mut times = vec![0_usize; count];
    let mut faults = Vec::new();
    for &number in order {
        match number.checked_sub(1).and_then(|index| times.get_mut(index)) {
            Some(times) => *times += 1,
            None => faults.push(format!("there is no cylinder {number}")),
        }
    }
    for (index, &times) in times.iter().enumerate() {
        match times {
            0 => faults.push(format!("cylinder {} is missing", index + 1)),
            1 => {}
            _ => faults.push(format!("cylinder {} fires {times} times", index + 1)),
        }
    }
    if faults.is_empty() {
        return Ok(());
    }
    if faults.len() > MOST_LISTED {
        let left = faults.len() - MOST_LISTED;
        faults.truncate(MOST_LISTED);
        faults.push(format!("{left} more"));
    }
    Err(Problem::new(
        "firing.order",
        format!("the firing order needs each cylinder once: {}", faults.join(", ")),
    )
    .hint(format!("write every number from 1 to {count} once")))
}

/// `theta` [rad] in the cycle at which each cylinder fires.
///
/// `tops[i]` is the nominal top dead centre of cylinder `i + 1` ([`nominal_top`]) for crankshafts that run at the
/// speed of crankshaft 1. The first of the order fires in the first revolution; of the choices of revolution that keep the order, the one with the most even
/// intervals (least sum of squares) is taken.
pub(crate) fn assign(strokes: Strokes, tops: &[f64], order: &[usize]) -> Result<Vec<f64>, Problem> {
    check_permutation(order, tops.len())?;
    let revolutions = strokes.revolutions() as usize;
    let cycle = TAU * revolutions as f64;
    let Some(&first) = order.first() else { return Ok(Vec::new()) };
    let start = turn(tops[first - 1], TAU);
    let after_first: Vec<f64> = order.iter().map(|&number| whole(tops[number - 1] - start)).collect();
    let chosen = most_even(&after_first, revolutions)
        .ok_or_else(|| cannot_fire(strokes, tops, order, &after_first))?;
    let mut firing = vec![0.0; tops.len()];
    for (&number, theta) in order.iter().zip(chosen) {
        firing[number - 1] = turn(start + theta, cycle);
    }
    Ok(firing)
}

/// Rising firing angles after the first cylinder's (which is 0), each `tops[k]` plus whole revolutions within the
/// cycle, with the least sum of squared intervals; `None` if none rises.
fn most_even(tops: &[f64], revolutions: usize) -> Option<Vec<f64>> {
    let cycle = TAU * revolutions as f64;
    // best[k][j]: least cost of the first k + 1 cylinders if the last of them fires in revolution j, and the
    // revolution of the cylinder before.
    let mut best: Vec<Vec<Option<(f64, usize)>>> = vec![vec![None; revolutions]];
    best[0][0] = Some((0.0, 0));
    for k in 1..tops.len() {
        let reach = |j: usize| {
            let angle = tops[k] + TAU * j as f64;
            (0..revolutions)
                .filter_map(|i| {
                    let interval = angle - (tops[k - 1] + TAU * i as f64);
                    let (cost, _) = best[k - 1][i]?;
                    (interval > SAME).then_some((cost + interval * interval, i))
                })
                .min_by(|a, b| a.0.total_cmp(&b.0))
        };
        let states = (0..revolutions).map(reach).collect();
        best.push(states);
    }
    let last = tops.len() - 1;
    let closing = |j: usize| (cycle - tops[last] - TAU * j as f64).powi(2);
    let (mut revolution, _) = (0..revolutions)
        .filter_map(|j| best[last][j].map(|(cost, _)| (j, cost + closing(j))))
        .min_by(|a, b| a.1.total_cmp(&b.1))?;
    let mut chosen = vec![0.0; tops.len()];
    for k in (0..tops.len()).rev() {
        chosen[k] = tops[k] + TAU * revolution as f64;
        revolution = best[k][revolution].map_or(0, |(_, before)| before);
    }
    Some(chosen)
}

/// Why the order is impossible: the first cylinder that cannot fire at its place, and the orders that can.
fn cannot_fire(strokes: Strokes, tops: &[f64], order: &[usize], after_first: &[f64]) -> Problem {
    let cycle = TAU * f64::from(strokes.revolutions());
    let mut theta = 0.0;
    let mut blocked = order.len() - 1;
    for k in 1..order.len() {
        let mut next = after_first[k];
        while next <= theta + SAME {
            next += TAU;
        }
        if next > cycle - SAME {
            blocked = k;
            break;
        }
        theta = next;
    }
    let (number, before) = (order[blocked], order[blocked - 1]);
    let message = format!(
        "cylinder {number} cannot fire after cylinder {before}: it comes to top dead centre no more in this cycle"
    );
    let first = order[0];
    let hint = match orders::orders(strokes, tops, first) {
        Ok(orders) if orders.is_empty() => None,
        Ok(orders) => {
            let list: Vec<String> = orders.iter().map(|order| hyphenated(order)).collect();
            Some(format!("this crank can fire, most evenly first, {}", list.join(", ")))
        }
        Err(together) => Some(format!(
            "no order fits this crank: cylinders {} come to top dead centre together; firing.angles can say so",
            listed(&together)
        )),
    };
    Problem { key: "firing.order", message, hint }
}

fn hyphenated(order: &[usize]) -> String {
    let numbers: Vec<String> = order.iter().map(usize::to_string).collect();
    numbers.join("-")
}

fn listed(numbers: &[usize]) -> String {
    let numbers: Vec<String> = numbers.iter().map(usize::to_string).collect();
    match numbers.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
        _ => numbers.concat(),
    }
}

#[cfg(test)]
mod tests;
