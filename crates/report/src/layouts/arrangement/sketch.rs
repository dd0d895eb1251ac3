//! The drive and the place of every arrangement, seen from the free end.

use super::at_spacing;
use crate::engine::pose::{bore, pose};
use crate::kit::figure::{Figure, Panel};
use crate::kit::number;
use crate::kit::svg::{Anchor, Path, Svg, wrap};
use crate::kit::view::{Bounds, View, side};
use lanchester_balance::{Arrangement, Arrangements, GearSeat, PartSizes, SpacingArrangements};
use lanchester_model::Engine;
use num_complex::Complex64;
use std::f64::consts::TAU;

const WIDTH: f64 = 340.0;
const MARGIN: f64 = 26.0;
const HEAD: f64 = 54.0;
const TALLEST: f64 = 330.0;

/// Crank angles at which the rods are drawn.
const POSES: usize = 36;

/// Those of the arrangements `shown` at one spacing that have shafts: crank sweep, rods, shafts with their weights, and
/// gears.
///
/// `engine` and `parts` are those of the search.
pub fn drive_sketches(
    engine: &Engine,
    parts: &PartSizes,
    found: &Arrangements,
    spacing: &SpacingArrangements,
    shown: &[usize],
) -> Figure {
    let with_shafts = shown.iter().filter_map(|&k| {
        let arrangement = spacing.arrangements.get(k).filter(|a| a.drive.is_some());
        arrangement.map(|a| sketch(engine, parts, k + 1, a))
    });
    let panels: Vec<Panel> = with_shafts.collect();
    Figure {
        id: "drives".to_owned(),
        title: format!("Places and drives{}", at_spacing(spacing, found.spacings.len() == 1)),
        caption: "Seen from the free end at θ = 0. Dashed: what the crank sweeps; grey: the rods over a revolution; full \
                  circles: the sweep of the shaft weights, with the weight filled; dash-dotted: pitch circles of the gears. \
                  Arrows show the sense of rotation."
            .to_owned(),
        columns: panels.len().clamp(1, 3),
        panels,
    }
}

fn sketch(engine: &Engine, parts: &PartSizes, label: usize, arrangement: &Arrangement) -> Panel {
    let side = side(engine.rotation);
    let radius = engine.throws.iter().fold(0.0f64, |m, t| m.max(t.radius));
    let big_end = parts.big_end_radius.unwrap_or(0.75 * radius);
    let sweep = |crankshaft: usize| {
        let throws = engine.throws.iter().filter(|t| t.crankshaft == crankshaft);
        let own = throws.fold(0.0f64, |m, t| m.max(t.radius));
        parts.crank_sweep.unwrap_or(own + big_end)
    };
    let mut space = Bounds::empty();
    for (index, shaft) in engine.crankshafts.iter().enumerate() {
        space.take((side * shaft.y, -shaft.x), sweep(index));
    }
    for shaft in &arrangement.shafts {
        space.take((side * shaft.y, -shaft.x), shaft.weight_sweep);
    }
    for gear in arrangement.drive.iter().flat_map(|d| &d.gears) {
        space.take((side * gear.y, -gear.x), 0.5 * gear.pitch_diameter + parts.gear_module);
    }
    for cylinder in 0..engine.cylinders.len() {
        for theta in [0.0, 0.25 * TAU, 0.5 * TAU, 0.75 * TAU] {
            let pin = pose(engine, cylinder, theta).piston_pin;
            space.take((side * pin.im, -pin.re), 0.25 * bore(engine, cylinder));
        }
    }
    let scale = ((WIDTH - 2.0 * MARGIN) / space.width()).min(TALLEST / space.height());
    let height = space.height() * scale + HEAD + MARGIN + 20.0;
    let centre = (0.5 * WIDTH - 0.5 * (space.low.0 + space.high.0) * scale, HEAD + 4.0 - space.low.1 * scale);
    let view = View::new(engine.rotation, centre, scale);
    let mut svg = Svg::new(WIDTH, height);
    for (index, line) in
        wrap(&format!("{label}: {}", arrangement.name), 13.0, WIDTH - 8.0).iter().take(3).enumerate()
    {
        svg.text("small strong", (4.0, 13.0 + 15.0 * index as f64), Anchor::Start, line);
    }
    draw_rods(&mut svg, &view, engine, parts.rod_width.unwrap_or(0.5 * radius), big_end);
    for (index, shaft) in engine.crankshafts.iter().enumerate() {
        let at = view.at(Complex64::new(shaft.x, shaft.y));
        svg.circle("outline dashed", at, sweep(index) * scale);
        svg.circle("pin", at, 3.4);
        turn(&mut svg, &view, at, 0.5 * radius * scale, shaft.ratio.value());
    }
    draw_shafts(&mut svg, &view, arrangement, parts.shaft_radius);
    draw_gears(&mut svg, &view, arrangement);
    if let Some(clearance) = &arrangement.clearance {
        let text = format!("narrowest place {} mm", number::short(1e3 * clearance.distance, 2));
        svg.text("small muted", (4.0, height - 6.0), Anchor::Start, &text);
    }
    let places: Vec<String> = (arrangement.shafts.iter())
        .map(|s| {
            let [x, y] = [s.x, s.y].map(|v| number::short(1e3 * v, 3));
            format!("{} at x {x} mm, y {y} mm", s.name)
        })
        .collect();
    Panel::new(svg, format!("{}: {}.", arrangement.name, places.join(", ")))
}

/// All rods at many angles, so that what they sweep is seen.
fn draw_rods(svg: &mut Svg, view: &View, engine: &Engine, width: f64, big_end: f64) {
    svg.group("swept");
    let mut drawn: Vec<(Complex64, Complex64)> = Vec::new();
    for cylinder in 0..engine.cylinders.len() {
        for step in 0..POSES {
            let now = pose(engine, cylinder, TAU * step as f64 / POSES as f64);
            let near = |a: Complex64, b: Complex64| (a - b).norm() * view.scale < 0.5;
            if drawn.iter().any(|(b, p)| near(*b, now.big_end) && near(*p, now.piston_pin)) {
                continue;
            }
            drawn.push((now.big_end, now.piston_pin));
            svg.circle("", view.at(now.big_end), big_end * view.scale);
            let along = now.piston_pin - now.big_end;
            let beside = along / along.norm().max(1e-9) * Complex64::new(0.0, 0.5 * width);
            let corners = [
                now.big_end + beside,
                now.piston_pin + beside,
                now.piston_pin - beside,
                now.big_end - beside,
            ];
            let path = corners[1..]
                .iter()
                .fold(Path::new().move_to(view.at(corners[0])), |path, c| path.line_to(view.at(*c)));
            svg.path("", &path.close());
        }
    }
    svg.end();
}

fn draw_shafts(svg: &mut Svg, view: &View, arrangement: &Arrangement, shaft_radius: f64) {
    for (index, shaft) in arrangement.shafts.iter().enumerate() {
        let at = view.at(Complex64::new(shaft.x, shaft.y));
        let radius = shaft.weight_sweep * view.scale;
        let weights = arrangement.answer.task.weights.iter().zip(&arrangement.answer.weights);
        let own: Vec<Complex64> = weights
            .filter(|(free, found)| {
                free.seat == lanchester_task::Seat::Shaft(index) && found.unbalance.norm() > 0.0
            })
            .map(|(_, found)| found.unbalance)
            .collect();
        for unbalance in &own {
            half_disc(svg, view, at, radius, unbalance.arg());
        }
        svg.circle("outline", at, radius);
        svg.circle("pin", at, shaft_radius * view.scale);
        // The number tells the sense too, where there is no room for an arrow.
        if 0.74 * radius > shaft_radius * view.scale + 8.0 {
            turn(svg, view, at, 0.74 * radius, f64::from(shaft.ratio));
        }
        svg.text(
            "small halo",
            (at.0, at.1 + 4.0),
            Anchor::Middle,
            &format!("{:+}", shaft.ratio).replace('-', "\u{2212}"),
        );
    }
}

/// A weight: half a disc towards `direction` [rad in the frame].
fn half_disc(svg: &mut Svg, view: &View, at: (f64, f64), radius: f64, direction: f64) {
    let edge = |offset: f64| {
        let angle = view.angle(direction) + offset;
        (at.0 + radius * angle.cos(), at.1 + radius * angle.sin())
    };
    let path = Path::new().move_to(edge(-0.25 * TAU)).arc_to(radius, false, true, edge(0.25 * TAU)).close();
    svg.path("weight", &path);
}

/// An arrow in the sense of rotation.
fn turn(svg: &mut Svg, view: &View, at: (f64, f64), radius: f64, ratio: f64) {
    let middle = 0.25 * TAU;
    let (from, to) = (view.angle(middle - ratio.signum() * 0.6), view.angle(middle + ratio.signum() * 0.6));
    svg.arc_arrow("arrow turn", at, radius, from, to, 6.0);
}

fn draw_gears(svg: &mut Svg, view: &View, arrangement: &Arrangement) {
    let Some(drive) = &arrangement.drive else { return };
    for gear in &drive.gears {
        let at = view.at(Complex64::new(gear.x, gear.y));
        svg.circle("gear", at, 0.5 * gear.pitch_diameter * view.scale);
        if gear.seat == GearSeat::Idler {
            svg.circle("pin", at, 2.6);
            turn(svg, view, at, 0.5 * gear.pitch_diameter * view.scale * 0.7, gear.ratio);
        }
    }
    for link in drive.links.iter().filter(|l| l.chain) {
        let (from, to) = (&drive.gears[link.driver], &drive.gears[link.driven]);
        let (a, b) = (Complex64::new(from.x, from.y), Complex64::new(to.x, to.y));
        let along = (b - a).norm().max(1e-9);
        let unit = (b - a) / along;
        // Tangents on both sides, on their own sprocket's radius.
        for across in [-1.0, 1.0] {
            let tilt = 0.5 * (from.pitch_diameter - to.pitch_diameter) / along;
            let normal = unit * Complex64::new(tilt, across * (1.0 - tilt * tilt).max(0.0).sqrt());
            let ends = [a + normal * 0.5 * from.pitch_diameter, b + normal * 0.5 * to.pitch_diameter];
            svg.line("gear", view.at(ends[0]), view.at(ends[1]));
        }
    }
}
