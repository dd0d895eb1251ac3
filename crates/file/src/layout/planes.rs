//! Planes of throws and cylinders along the crank.

use super::spec::LayoutSpec;
use crate::problem::Problem;

/// Planes of `count` throws or cylinders along the crank, symmetric about z = 0 if they are given by `spacing`.
pub(super) fn planes(
    spec: &LayoutSpec,
    count: usize,
    what: &str,
    problems: &mut Vec<Problem>,
) -> Option<Vec<f64>> {
    if let Some(positions) = &spec.positions {
        if positions.len() != count {
            let got = positions.len();
            problems.push(Problem::new(
                "layout.positions",
                format!("needs {count} positions, one a {what}, got {got}"),
            ));
            return None;
        }
        if positions.windows(2).any(|pair| pair[1] <= pair[0]) {
            problems.push(
                Problem::new("layout.positions", "positions must rise from the free end to the flywheel")
                    .hint("z grows from cylinder 1 at the free end towards the flywheel"),
            );
            return None;
        }
        return Some(positions.clone());
    }
    if count == 1 {
        return Some(vec![0.0]);
    }
    match spec.spacing {
        Some(spacing) if spacing > 0.0 => Some(evenly_spaced(count, spacing)),
        Some(_) => {
            problems.push(Problem::new("layout.spacing", "spacing must be more than 0"));
            None
        }
        None => {
            problems.push(
                Problem::new(
                    "layout.spacing",
                    format!("spacing is missing: the distance from one {what} to the next"),
                )
                .hint("add spacing = \"88 mm\", or positions = [..] if they are not evenly spaced"),
            );
            None
        }
    }
}

/// `count` planes `spacing` apart, symmetric about z = 0.
pub(super) fn evenly_spaced(count: usize, spacing: f64) -> Vec<f64> {
    let middle = (count as f64 - 1.0) / 2.0;
    (0..count).map(|plane| (plane as f64 - middle) * spacing).collect()
}
