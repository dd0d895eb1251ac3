//! What an arrangement leaves against what it costs.

use super::at_spacing;
use crate::kit::axis::Axis;
use crate::kit::figure::{Figure, Panel};
use crate::kit::number::{self, Scale};
use crate::kit::svg::{Anchor, Path, Svg, text_width};
use lanchester_balance::{Arrangement, Arrangements, SpacingArrangements};

const WIDTH: f64 = 640.0;
const HEIGHT: f64 = 430.0;
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
                  moment and every price; hollow ones are beaten. A number is a balance shaft \
                  by its speed over that of the crank; a star, the lightest weights within the limit."
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
        number::capital(found.criterion.name()),
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
    let simplest = spacing.simplest.map(|k| &spacing.arrangements[k]);
    labels(&mut svg, &shown, simplest, place, (TOP, right));
    if let Some(simplest) = simplest {
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

/// Distances from a mark at which its name may stand; beyond the first a line leads there.
const REACHES: [f64; 7] = [0.0, 14.0, 26.0, 38.0, 50.0, 64.0, 80.0];

/// Names of the front's marks, as near as there is room.
fn labels(
    svg: &mut Svg,
    shown: &[(usize, &Arrangement)],
    simplest: Option<&Arrangement>,
    place: impl Fn(&Arrangement) -> (f64, f64),
    (top, right): (f64, f64),
) {
    let mut marks: Vec<(f64, f64)> = shown.iter().map(|(_, a)| place(a)).collect();
    if let Some((x, y)) = simplest.map(&place) {
        // The circle around it takes room on all sides.
        marks.extend([(x - 8.0, y), (x + 8.0, y), (x, y - 8.0), (x, y + 8.0)]);
    }
    let mut taken: Vec<((f64, f64), f64)> = Vec::new();
    for (_, a) in shown.iter().filter(|(_, a)| a.on_front) {
        let at = place(a);
        let label = short(a);
        let half = 0.5 * text_width(&label, 12.5) + 1.0;
        let spots = REACHES.iter().flat_map(|reach| {
            let (side, up, down) = (half + 9.0 + 0.5 * reach, -6.0 - reach, 13.0 + reach);
            [(side, up), (-side, up), (side, down), (-side, down), (0.0, up - 4.0), (0.0, down + 4.0)]
                .map(|(x, y)| (*reach, (at.0 + x, at.1 + y)))
        });
        let free = spots.into_iter().find(|(_, spot)| {
            let clear = |other: &(f64, f64)| {
                (other.0 - spot.0).abs() > half + 6.0 || (other.1 - (spot.1 - 4.0)).abs() > 10.0
            };
            spot.1 > top + 10.0
                && spot.1 < HEIGHT - BOTTOM - 3.0
                && spot.0 - half > LEFT
                && spot.0 + half < right
                && marks.iter().all(clear)
                && taken.iter().all(|(t, other)| {
                    (t.0 - spot.0).abs() > half + other + 3.0 || (t.1 - spot.1).abs() > 12.0
                })
        });
        if let Some((reach, spot)) = free {
            taken.push((spot, half));
            if reach > 0.0 {
                let towards = (spot.0 + (at.0 - spot.0).clamp(-half, half), spot.1 - 4.0);
                svg.line("dimension", at, towards);
            }
            svg.text("small halo", spot, Anchor::Middle, &label);
        }
    }
}

/// Its label with true minus signs; a star for the lightest within the limit.
fn short(arrangement: &Arrangement) -> String {
    arrangement.label.replace('-', "\u{2212}").replace(", lightest", "*")
}
