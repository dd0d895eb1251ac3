//! The front between two objectives of a counterweight.

use crate::kit::axis::Axis;
use crate::kit::figure::{Figure, Panel};
use crate::kit::number;
use crate::kit::plot::{BOTTOM, LEFT, RIGHT, value_axis};
use crate::kit::svg::{Anchor, Path, Svg};
use crate::parts::counterweight_tables::objective_name;
use lanchester_geometry::{Front, Objective};

const WIDTH: f64 = 620.0;
const HEIGHT: f64 = 380.0;
const TOP: f64 = 30.0;

/// Mass against swept radius, or any other two: every design a point with its number at both ends and in the middle.
pub fn front_plot(front: &Front) -> Figure {
    let [first, second] = front.objectives;
    let printed = |objective: Objective| -> (String, f64) {
        match objective {
            Objective::Mass => ("Mass [g]".to_owned(), 1e3),
            Objective::SweptRadius => ("Swept radius [mm]".to_owned(), 1e3),
            Objective::Thickness => ("Thickness [mm]".to_owned(), 1e3),
            Objective::Inertia => ("Polar inertia [kg mm²]".to_owned(), 1e6),
        }
    };
    let ((y_name, y_factor), (x_name, x_factor)) = (printed(first), printed(second));
    let points: Vec<(f64, f64)> = front
        .designs
        .iter()
        .map(|design| (design.value(second) * x_factor, design.value(first) * y_factor))
        .collect();
    let ends = |values: &dyn Fn(&(f64, f64)) -> f64| {
        let values = points.iter().map(values);
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
    };
    let (low, high) = ends(&|point| point.0);
    let x_axis = Axis::of(low, high, 8);
    let (low, high) = ends(&|point| point.1);
    let y_axis = Axis::of(low, high, 6);
    let mut svg = Svg::new(WIDTH, HEIGHT);
    let (right, bottom) = (WIDTH - RIGHT - 10.0, HEIGHT - BOTTOM);
    svg.text("muted small", (4.0, 13.0), Anchor::Start, &y_name);
    value_axis(&mut svg, &y_axis, TOP, bottom);
    for &tick in &x_axis.ticks {
        let x = x_axis.place(tick, LEFT, right);
        svg.line("grid", (x, TOP), (x, bottom));
        svg.text("small", (x, bottom + 17.0), Anchor::Middle, &number::fixed(tick, x_axis.decimals));
    }
    svg.text("muted small", ((LEFT + right) / 2.0, bottom + 37.0), Anchor::Middle, &x_name);
    let place = |point: &(f64, f64)| (x_axis.place(point.0, LEFT, right), y_axis.place(point.1, bottom, TOP));
    let places: Vec<(f64, f64)> = points.iter().map(place).collect();
    svg.path("thin", &Path::through(places.iter().copied()));
    for at in &places {
        svg.circle("bar1", *at, 3.2);
    }
    let count = places.len();
    let mut numbered = vec![0, count / 4, count / 2, 3 * count / 4, count.saturating_sub(1)];
    numbered.dedup();
    for index in numbered.into_iter().filter(|index| *index < count) {
        let at = places[index];
        // Inwards, so that no number leaves the plot.
        let anchor = if at.0 > 0.5 * (LEFT + right) { Anchor::End } else { Anchor::Start };
        let shift = if anchor == Anchor::End { -7.0 } else { 7.0 };
        svg.text("small halo", (at.0 + shift, at.1 - 7.0), anchor, &(index + 1).to_string());
    }
    let description = format!("{} designs; {y_name} against {x_name}.", front.designs.len());
    Figure {
        id: "counterweight-front".to_owned(),
        title: format!("Counterweight: {} against {}", objective_name(first), objective_name(second)),
        caption: format!(
            "Every point is a complete design; no shape lies below and to the left of any. Numbers are those of the table. {}",
            if front.proved { "Proved for every point." } else { "Not every point is proved." }
        ),
        panels: vec![Panel::new(svg, description)],
        columns: 1,
    }
}
