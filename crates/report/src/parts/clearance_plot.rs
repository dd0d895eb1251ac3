//! Clearance of a counterweight over the crank angle.

use crate::kit::figure::Figure;
use crate::kit::plot::{AnglePlot, Series};
use crate::parts::crankshaft_tables::obstacle_name;
use lanchester_geometry::clearance::{ClearanceCurve, Obstacle};

/// Distance of a counterweight or web from what it comes near to, over the angle; at most five curves are drawn.
pub fn clearance_plot(body: &str, curves: &[(Obstacle, ClearanceCurve)]) -> Figure {
    let shown = &curves[..curves.len().min(5)];
    let (theta, period) = match shown {
        [(_, first), ..] => (first.theta.as_slice(), first.period),
        [] => (&[][..], std::f64::consts::TAU),
    };
    let series = shown.iter().enumerate().map(|(index, (obstacle, curve))| Series {
        name: obstacle_name(*obstacle),
        style: index,
        values: &curve.distance,
    });
    let plot = AnglePlot { quantity: "Clearance", unit: "m", theta, period, series: series.collect() };
    Figure {
        id: "clearance".to_owned(),
        title: format!("Clearance of {body}"),
        caption: "Smallest distance in space at each angle, to the parts that it comes nearest to; zero where they overlap.".to_owned(),
        panels: vec![plot.panel()],
        columns: 1,
    }
}
