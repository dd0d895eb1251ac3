//! What an arrangement leaves against what it costs.

use super::at_spacing;
use crate::axis::Axis;
use crate::figure::{Figure, Panel};
use crate::number::{self, Scale};
use crate::svg::{Anchor, Path, Svg, text_width};
use lanchester_balance::{Arrangement, Arrangements, SpacingArrangements};

const WIDTH: f64 = 560.0;
const HEIGHT: f64 = 380.0;
const LEFT: f64 = 60.0;
const RIGHT: f64 = 18.0;
const TOP: f64 = 60.0;
const BOTTOM: f64 = 46.0;

/// Residual against added mass, one panel a spacing; the mark tells the number of shafts, filled marks form the front.
pub fn arrangement_figure(found: &Arrangements) -> Figure {
    Figure {
        id: "arrangements".to_owned(),
        title: format!("What arrangements leave: {}", found.criterion.name()),
        caption: "Each mark is an arrangement at its best. Filled marks are those that no other beats in residual, roll \
                  moment and every price; hollow ones are beaten. Numbers are those of the table."
            .to_owned(),
        panels: found.spacings.iter().map(|spacing| panel(found, spacing)).collect(),
        columns: 2.min(found.spacings.len()),
    }
}

fn panel(found: &Arrangements, spacing: &SpacingArrangements) -> Panel {
    let shown: Vec<(usize, &Arrangement)> =
        spacing.arrangements.iter().enumerate().filter(|(_, a)| a.possible).collect();
    let largest = shown.iter().fold(found.limit.unwrap_or(0.0), |m, (_, a)| m.max(a.residual));
    let scale = Scale::of(largest, found.criterion.unit());
    let heaviest = shown.iter().fold(0.0f64, |m, (_, a)| m.max(a.price.mass()));
    let up = Axis::of(0.0, if largest > 0.0 { largest / scale.divisor } else { 1.0 }, 6);
    let along = Axis::of(0.0, if heaviest > 0.0 { 1.02 * heaviest } else { 1.0 }, 7);
    let mut svg = Svg::new(WIDTH, HEIGHT);
    let (right, bottom) = (WIDTH - RIGHT, HEIGHT - BOTTOM);
    let head = format!(
        "{} [{}]{}",
        capital(found.criterion.name()),
        scale.unit,
        at_spacing(spacing, found.spacings.len() == 1)
    );
    svg.text("muted small", (4.0, 13.0), Anchor::Start, &head);
    legend(&mut svg);
    for &tick in &up.ticks {
        let y = up.place(tick, bottom, TOP);
        svg.line(if tick == 0.0 { "zero" } else { "grid" }, (LEFT, y), (right, y));
        svg.text("small", (LEFT - 6.0, y + 4.0), Anchor::End, &number::fixed(tick, up.decimals));
    }
    for &tick in &along.ticks {
        let x = along.place(tick, LEFT, right);
        svg.line("grid", (x, TOP), (x, bottom));
        svg.text("small", (x, bottom + 17.0), Anchor::Middle, &number::fixed(tick, along.decimals));
    }
    svg.text("muted small", (0.5 * (LEFT + right), bottom + 38.0), Anchor::Middle, "added mass [kg]");
    let place = |a: &Arrangement| {
        (along.place(a.price.mass(), LEFT, right), up.place(a.residual / scale.divisor, bottom, TOP))
    };
    if let Some(limit) = found.limit {
        let y = up.place(limit / scale.divisor, bottom, TOP);
        svg.line("s2", (LEFT, y), (right, y));
        svg.text("small halo", (right, y - 5.0), Anchor::End, "good enough below");
    }
    for pass in [false, true] {
        for (_, a) in shown.iter().filter(|(_, a)| a.on_front == pass) {
            mark(&mut svg, place(a), a.shafts.len(), a.on_front);
        }
    }
    labels(&mut svg, &shown, place, (TOP, right));
    if let Some(simplest) = spacing.simplest.map(|k| &spacing.arrangements[k]) {
        svg.circle("outline", place(simplest), 10.0);
    }
    let front: Vec<String> = spacing
        .front
        .iter()
        .map(|&k| &spacing.arrangements[k])
        .map(|a| {
            let left = number::short(a.residual / scale.divisor, 4);
            format!("{}: {left} {} for {} kg", a.name, scale.unit, number::short(a.price.mass(), 3))
        })
        .collect();
    Panel::new(svg, format!("Residual against added mass. On the front: {}.", front.join("; ")))
}

/// Marks by number of shafts, above the plot.
fn legend(svg: &mut Svg) {
    let mut x = 12.0;
    for shafts in 0..=4 {
        let name = match shafts {
            0 => "no shaft".to_owned(),
            1 => "1 shaft".to_owned(),
            n => format!("{n} shafts"),
        };
        mark(svg, (x, 30.0), shafts, true);
        svg.text("small", (x + 10.0, 34.0), Anchor::Start, &name);
        x += 10.0 + text_width(&name, 12.5) + 20.0;
    }
    svg.circle("outline", (x + 4.0, 30.0), 10.0);
    svg.text("small", (x + 19.0, 34.0), Anchor::Start, "simplest");
}

/// A mark: circle, triangle, square, diamond, star of four.
fn mark(svg: &mut Svg, (x, y): (f64, f64), shafts: usize, filled: bool) {
    let class = if filled { "bar1" } else { "pin" };
    let corners: &[(f64, f64)] = match shafts {
        0 => {
            svg.circle(class, (x, y), 4.2);
            return;
        }
        1 => &[(0.0, -5.2), (4.8, 3.6), (-4.8, 3.6)],
        2 => &[(-4.0, -4.0), (4.0, -4.0), (4.0, 4.0), (-4.0, 4.0)],
        3 => &[(0.0, -5.6), (5.6, 0.0), (0.0, 5.6), (-5.6, 0.0)],
        _ => &[
            (0.0, -6.5),
            (1.8, -1.8),
            (6.5, 0.0),
            (1.8, 1.8),
            (0.0, 6.5),
            (-1.8, 1.8),
            (-6.5, 0.0),
            (-1.8, -1.8),
        ],
    };
    let mut points = corners.iter().map(|(dx, dy)| (x + dx, y + dy));
    let Some(first) = points.next() else { return };
    svg.path(class, &points.fold(Path::new().move_to(first), Path::line_to).close());
}

/// Numbers beside the marks of the front, where there is room.
fn labels(
    svg: &mut Svg,
    shown: &[(usize, &Arrangement)],
    place: impl Fn(&Arrangement) -> (f64, f64),
    (top, right): (f64, f64),
) {
    let marks: Vec<(f64, f64)> = shown.iter().map(|(_, a)| place(a)).collect();
    let mut taken: Vec<(f64, f64)> = Vec::new();
    for (index, a) in shown.iter().filter(|(_, a)| a.on_front) {
        let at = place(a);
        let label = (index + 1).to_string();
        let half = 0.5 * text_width(&label, 11.5);
        let spots =
            [(half + 9.0, -6.0), (-half - 9.0, -6.0), (half + 9.0, 13.0), (-half - 9.0, 13.0), (0.0, -10.0)];
        let free = spots.iter().map(|(dx, dy)| (at.0 + dx, at.1 + dy)).find(|spot| {
            let clear = |other: &(f64, f64), reach: f64| {
                (other.0 - spot.0).abs() > half + reach || (other.1 - (spot.1 - 4.0)).abs() > reach + 4.0
            };
            spot.1 > top
                && spot.0 + half < right
                && marks.iter().all(|m| clear(m, 6.0))
                && taken
                    .iter()
                    .all(|t| (t.0 - spot.0).abs() > 2.0 * half + 3.0 || (t.1 - spot.1).abs() > 12.0)
        });
        if let Some(spot) = free {
            taken.push(spot);
            svg.text("small halo", spot, Anchor::Middle, &label);
        }
    }
}

/// With a capital first letter.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
