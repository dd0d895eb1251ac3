//! What fits on webs, as `balance` tells it.

use lanchester::report::{BoundedWeight, Table, obstacle_name, web_bounds_table};
use lanchester::{BoundedAnswer, FitLimit};

/// The bounds of an answer by what fits; none where none is bounded so.
pub fn table(bounded: &BoundedAnswer) -> Option<Table> {
    let weights: Vec<BoundedWeight> = bounded
        .bounds
        .iter()
        .map(|bound| {
            let found = bounded.answer.weights.iter().find(|found| found.name == bound.name);
            BoundedWeight {
                name: &bound.name,
                most: bound.most,
                found: found.map_or(0.0, |found| found.unbalance.norm()),
                direction: bound.direction,
                limits: bound.limits.iter().map(words).collect::<Vec<_>>().join(", "),
            }
        })
        .collect();
    let by_default = bounded.bounds.iter().all(|bound| bound.is_default);
    (!weights.is_empty()).then(|| web_bounds_table(&weights, by_default))
}

fn words(limit: &FitLimit) -> String {
    match limit {
        FitLimit::Clearance(obstacle) => format!("clearance to {}", obstacle_name(*obstacle)),
        FitLimit::Thickness => "thickness".to_owned(),
        FitLimit::RodsBeside => "clearance to the rods beside the web".to_owned(),
        FitLimit::SweptRadius => "swept radius".to_owned(),
        FitLimit::Mass => "mass".to_owned(),
        FitLimit::Inertia => "inertia".to_owned(),
        FitLimit::HalfWidth => "half width".to_owned(),
        FitLimit::ArcRadius => "arc radius".to_owned(),
        FitLimit::ArcAngle => "arc angle".to_owned(),
        FitLimit::Height => "heights of rectangle and trapezoid".to_owned(),
    }
}
