//! Angles of the throws: given, or derived from the firing order.

use super::skeleton::{Skeleton, ThrowFrame};
use super::spec::LayoutSpec;
use crate::firing;
use crate::problem::{Problem, degrees};
use std::f64::consts::TAU;

/// Largest disagreement of two cylinders about the angle of a pin that they share [rad] that is taken for rounding of
/// the angles in the file (a tenth of a degree).
const ROUNDING: f64 = 1.8e-3;

/// Angle of every throw, the first at 0, each in [0, 2 pi).
pub(super) fn angles(
    spec: &LayoutSpec,
    skeleton: &Skeleton,
    problems: &mut Vec<Problem>,
) -> Option<Vec<f64>> {
    let entries = skeleton.throws.iter().map(|throw| throw.entry + 1).max().unwrap_or(0);
    let entry_angles = match &spec.crank_angles {
        Some(given) => checked(given, entries, skeleton.entry, problems)?,
        None => {
            // One throw stands at 0 by the definition of theta, whatever fires when.
            let trivial = entries == 1;
            if trivial && spec.crank_phase.is_some() {
                problems
                    .push(Problem::new("layout.crank_phase", "crank_phase has no effect on a single throw"));
            }
            if trivial { vec![0.0] } else { derived(spec, skeleton, entries, problems)? }
        }
    };
    let first = skeleton.throws.first().map_or(0.0, |throw| entry_angles[throw.entry] + throw.lead);
    let angle = |throw: &ThrowFrame| firing::turn(entry_angles[throw.entry] + throw.lead - first, TAU);
    Some(skeleton.throws.iter().map(angle).collect())
}

/// The given angles, if there are as many as needed and the first is 0.
fn checked(given: &[f64], entries: usize, entry: &str, problems: &mut Vec<Problem>) -> Option<Vec<f64>> {
    if given.len() != entries {
        let got = given.len();
        problems.push(Problem::new(
            "layout.crank_angles",
            format!("needs {entries} crank angles, one a {entry}, got {got}"),
        ));
        return None;
    }
    if given[0] != 0.0 {
        problems.push(
            Problem::new(
                "layout.crank_angles",
                format!("the first throw must stand at 0 deg, got {}", degrees(given[0])),
            )
            .hint(format!("theta counts from it: take {} off all of them", degrees(given[0]))),
        );
        return None;
    }
    Some(given.to_vec())
}

/// Angles that bring every cylinder to its nominal top dead centre at its firing angle, one interval after the other:
/// the throw of a cylinder on axis b that fires at f stands at `b + asin(offset / reach) - f`.
fn derived(
    spec: &LayoutSpec,
    skeleton: &Skeleton,
    entries: usize,
    problems: &mut Vec<Problem>,
) -> Option<Vec<f64>> {
    let count = skeleton.cylinders.len();
    let Some(order) = &spec.order else {
        let key = if spec.crank_phase.is_some() { "firing.order" } else { "layout.crank_angles" };
        problems.push(Problem::new(key, "the angles of the throws are missing").hint(format!(
            "add crank_angles = [..] (one a {}) to [layout], or order = [..] to [firing] to derive them",
            skeleton.entry
        )));
        return None;
    };
    if let Err(problem) = firing::check_permutation(order, count) {
        problems.push(problem);
        return None;
    }
    let cycle = TAU * f64::from(spec.strokes.revolutions());
    let interval = spec.crank_phase.unwrap_or(cycle / count as f64);
    let mut wanted: Vec<Option<(usize, f64)>> = vec![None; entries];
    for (place, &number) in order.iter().enumerate() {
        let cylinder = &skeleton.cylinders[number - 1];
        let throw = &skeleton.throws[cylinder.throw];
        let top = cylinder.angle + firing::dead_centre_lead(cylinder.offset.unwrap_or(0.0), spec.reach);
        let angle = top - interval * place as f64 - throw.lead;
        match wanted[throw.entry] {
            None => wanted[throw.entry] = Some((number, angle)),
            Some((other, before)) => {
                let apart = firing::turn(angle - before + TAU / 2.0, TAU) - TAU / 2.0;
                if apart.abs() > ROUNDING {
                    problems.push(disagreement(spec, skeleton.entry, interval, (other, number), apart));
                    return None;
                }
            }
        }
    }
    Some(wanted.iter().map(|entry| entry.map_or(0.0, |(_, angle)| angle)).collect())
}

/// Two cylinders that want the same throw at two angles.
fn disagreement(
    spec: &LayoutSpec,
    entry: &str,
    interval: f64,
    (one, other): (usize, usize),
    apart: f64,
) -> Problem {
    let key = if spec.crank_phase.is_some() { "layout.crank_phase" } else { "firing.order" };
    let message = format!(
        "cylinders {one} and {other} share a {entry}, but firing every {} wants it at angles {} apart",
        degrees(interval),
        degrees(apart.abs())
    );
    Problem::new(key, message).hint("give layout.crank_angles: this crank does not fire this order evenly")
}
