//! The engine drawn from the free end towards the flywheel, at theta = 0.

use crate::engine::mechanism_sketch::{Bank, banks, bounds, draw_links, draw_sector, draw_walls};
use crate::kit::figure::{Figure, Panel};
use crate::kit::number;
use crate::kit::svg::{Anchor, Path, Svg, text_width};
use crate::kit::view::{View, side};
use lanchester_model::Engine;
use num_complex::Complex64;
use std::f64::consts::PI;

const WIDTH: f64 = 440.0;
const MARGIN: f64 = 44.0;
const TALLEST: f64 = 420.0;

/// Cylinders, throws, weights, shafts and mounts seen from the free end.
pub fn front_view(engine: &Engine) -> Figure {
    let banks = banks(engine);
    let side = side(engine.rotation);
    let radius = engine.throws.iter().fold(0.0f64, |m, t| m.max(t.radius));
    let shaft_radius = 0.42 * radius;
    let mut space = bounds(engine, &banks, side);
    for shaft in &engine.shafts {
        space.take((side * shaft.y, -shaft.x), 1.5 * shaft_radius);
    }
    for mount in &engine.mounts {
        space.take((side * mount.y, -mount.x), 0.15 * radius);
    }
    let scale = ((WIDTH - 2.0 * MARGIN) / space.width()).min((TALLEST - 2.0 * MARGIN) / space.height());
    let height = (space.height() * scale + 2.0 * MARGIN).max(220.0);
    let centre = (
        0.5 * WIDTH - 0.5 * (space.low.0 + space.high.0) * scale,
        0.5 * height - 0.5 * (space.low.1 + space.high.1) * scale,
    );
    let view = View::new(engine.rotation, centre, scale);

    let mut svg = Svg::new(WIDTH, height + 56.0);
    draw_axes_of(&mut svg, &view, &banks);
    draw_counterweights(&mut svg, &view, engine);
    draw_walls(&mut svg, &view, &banks);
    draw_cranks(&mut svg, &view, engine);
    draw_links(&mut svg, &view, engine, 0.0);
    draw_cylinder_numbers(&mut svg, &view, &banks);
    draw_throw_numbers(&mut svg, &view, engine);
    draw_shafts(&mut svg, &view, engine, shaft_radius * scale);
    draw_mounts(&mut svg, &view, engine);
    draw_frame(&mut svg, side, height + 22.0);
    let description = format!(
        "{} cylinders on {} throws, seen from the free end, at theta = 0.",
        engine.cylinders.len(),
        engine.throws.len()
    );
    Figure {
        id: "front-view".to_owned(),
        title: "The engine from the free end".to_owned(),
        caption: "At θ = 0, looking towards the flywheel. Numbers beyond the heads are cylinders, numbers at the crankpins are throws."
            .to_owned(),
        panels: vec![Panel::new(svg, description)],
        columns: 1,
    }
}

fn draw_axes_of(svg: &mut Svg, view: &View, banks: &[Bank]) {
    for bank in banks {
        let (ux, uy) = View { scale: 1.0, ..*view }.span(bank.axis);
        let end = view.at(bank.foot + bank.axis * bank.walls.1);
        svg.line("axis-line", view.at(bank.foot), (end.0 + 8.0 * ux, end.1 + 8.0 * uy));
    }
}

/// Cylinder numbers beyond the heads; beside the bore where another cylinder stands beyond the head.
fn draw_cylinder_numbers(svg: &mut Svg, view: &View, banks: &[Bank]) {
    for (index, bank) in banks.iter().enumerate() {
        let numbers: Vec<usize> = bank.cylinders.iter().map(|c| c + 1).collect();
        let label = number::list(&numbers);
        let half = 0.5 * text_width(&label, 12.5);
        let beyond = bank.foot + bank.axis * (bank.walls.1 + 16.0 / view.scale);
        let hidden = banks.iter().enumerate().any(|(other, b)| {
            let local = (beyond - b.foot) / b.axis;
            other != index && local.re > b.walls.0 && local.re < b.walls.1 && local.im.abs() < 0.5 * b.bore
        });
        let (from, direction) = if hidden {
            let beside = bank.axis * Complex64::new(0.0, -view.side);
            (bank.foot + bank.axis * 0.5 * (bank.walls.0 + bank.walls.1) + beside * (0.5 * bank.bore), beside)
        } else {
            (bank.foot + bank.axis * bank.walls.1, bank.axis)
        };
        let (ux, uy) = View { scale: 1.0, ..*view }.span(direction);
        let at = view.at(from);
        let gap = if hidden { 8.0 } else { 16.0 } + ux.abs() * half;
        svg.text("strong halo", (at.0 + gap * ux, at.1 + gap * uy + 4.5), Anchor::Middle, &label);
    }
}

/// Crank circles with the sense of rotation.
fn draw_cranks(svg: &mut Svg, view: &View, engine: &Engine) {
    for (index, shaft) in engine.crankshafts.iter().enumerate() {
        let radius =
            engine.throws.iter().filter(|t| t.crankshaft == index).fold(0.0f64, |m, t| m.max(t.radius));
        let at = view.at(Complex64::new(shaft.x, shaft.y));
        svg.circle("axis-line", at, radius * view.scale);
        let sense = shaft.ratio.value().signum();
        let middle = free_direction(engine, index);
        let (from, to) = (view.angle(middle - sense * 0.42), view.angle(middle + sense * 0.42));
        svg.arc_arrow("arrow turn", at, 1.34 * radius * view.scale, from, to, 9.0);
    }
}

/// The direction farthest from cylinders and throws of a crankshaft; the opposite of its cylinders where it can be.
fn free_direction(engine: &Engine, crankshaft: usize) -> f64 {
    let throws = (0..engine.throws.len()).filter(|t| engine.throws[*t].crankshaft == crankshaft);
    let taken: Vec<f64> = throws
        .map(|t| engine.pin_angle(t, 0.0))
        .chain(
            engine
                .cylinders
                .iter()
                .filter(|c| engine.throws[c.throw].crankshaft == crankshaft)
                .map(|c| c.angle),
        )
        .collect();
    let room = |direction: f64| {
        let apart = |a: &f64| PI - ((direction - a).rem_euclid(2.0 * PI) - PI).abs();
        taken.iter().map(apart).fold(PI, f64::min)
    };
    let candidates = (0..24).map(|k| 0.5 * PI + PI * f64::from(k) / 12.0);
    // The first of equals: rounding must not choose.
    candidates.fold((0.5 * PI, -1.0), |best, c| if room(c) > best.1 + 1e-6 { (c, room(c)) } else { best }).0
}

/// Counterweights, those of one direction once.
fn draw_counterweights(svg: &mut Svg, view: &View, engine: &Engine) {
    let mut drawn: Vec<(usize, Complex64)> = Vec::new();
    for weight in engine.counterweights.iter().filter(|w| w.unbalance > 0.0) {
        let shaft = &engine.crankshafts[weight.crankshaft];
        let direction = shaft.phase + weight.angle;
        let unit = Complex64::from_polar(1.0, direction);
        if drawn.iter().any(|(s, d)| *s == weight.crankshaft && (d - unit).norm() < 0.02) {
            continue;
        }
        drawn.push((weight.crankshaft, unit));
        let radius = engine
            .throws
            .iter()
            .filter(|t| t.crankshaft == weight.crankshaft)
            .fold(0.0f64, |m, t| m.max(t.radius))
            * view.scale;
        let at = view.at(Complex64::new(shaft.x, shaft.y));
        draw_sector(svg, view, "weight", at, (0.35 * radius, 1.18 * radius), direction);
    }
}

/// Throws of one direction, and where their numbers stand.
struct ThrowLabel {
    at: (f64, f64),
    outwards: (f64, f64),
    numbers: Vec<usize>,
}

/// Throw numbers beyond the crankpins, those of one direction together.
fn draw_throw_numbers(svg: &mut Svg, view: &View, engine: &Engine) {
    // Beyond the counterweights, where there are any.
    let out = if engine.counterweights.iter().any(|w| w.unbalance > 0.0) { 1.22 } else { 1.0 };
    let mut labels: Vec<ThrowLabel> = Vec::new();
    for (index, throw) in engine.throws.iter().enumerate() {
        let shaft = &engine.crankshafts[throw.crankshaft];
        let unit = Complex64::from_polar(1.0, engine.pin_angle(index, 0.0));
        // Above, the label stands beside the pin and needs no room for the weight.
        let distance = throw.radius * if unit.re > 0.8 { 1.0 } else { out };
        let at = view.at(Complex64::new(shaft.x, shaft.y) + unit * distance);
        match labels.iter_mut().find(|l| (l.at.0 - at.0).hypot(l.at.1 - at.1) < 2.0) {
            Some(label) => label.numbers.push(index + 1),
            None => {
                let outwards = View { scale: 1.0, ..*view }.span(unit);
                labels.push(ThrowLabel { at, outwards, numbers: vec![index + 1] });
            }
        }
    }
    for ThrowLabel { at, outwards: (ux, uy), numbers } in labels {
        let label = number::list(&numbers);
        let half = 0.5 * text_width(&label, 11.5);
        // Beside the pin, not on the rod that goes on from it.
        let (x, y) = if uy < -0.8 {
            (at.0 + half + 9.0, at.1 + 4.0)
        } else {
            (at.0 + ux * (half + 9.0), at.1 + uy * 14.0 + 4.0)
        };
        svg.text("small halo", (x, y), Anchor::Middle, &label);
    }
}

fn draw_shafts(svg: &mut Svg, view: &View, engine: &Engine, radius: f64) {
    let radius = radius.max(9.0);
    let mut taken: Vec<(f64, f64, f64)> = Vec::new();
    for shaft in &engine.shafts {
        let at = view.at(Complex64::new(shaft.x, shaft.y));
        svg.circle("thin", at, radius);
        let mut drawn: Vec<Complex64> = Vec::new();
        for weight in shaft.weights.iter().filter(|w| w.unbalance > 0.0) {
            let unit = Complex64::from_polar(1.0, weight.phase);
            if !drawn.iter().any(|d| (d - unit).norm() < 0.02) {
                drawn.push(unit);
                draw_sector(svg, view, "weight", at, (0.0, radius), weight.phase);
            }
        }
        svg.circle("pin", at, 3.0);
        let sense = shaft.ratio.value().signum();
        let (from, to) = (view.angle(-sense * 0.9), view.angle(sense * 0.9));
        svg.arc_arrow("arrow turn", at, radius + 5.0, from, to, 8.0);
        let ratio = shaft.ratio.to_string().replace('-', "\u{2212}");
        let half = 0.5 * text_width(&shaft.name, 11.5).max(30.0);
        let x = at.0.clamp(half + 2.0, WIDTH - half - 2.0);
        // Names of neighbours that would meet go one below the other.
        let mut y = at.1 + radius + 17.0;
        while taken.iter().any(|(tx, ty, other)| (tx - x).abs() < half + other + 4.0 && (ty - y).abs() < 27.0)
        {
            y += 28.0;
        }
        taken.push((x, y, half));
        svg.name("small halo", (x, y), Anchor::Middle, &shaft.name);
        svg.text("small muted halo", (x, y + 13.0), Anchor::Middle, &format!("{ratio} \u{d7}"));
    }
}

fn draw_mounts(svg: &mut Svg, view: &View, engine: &Engine) {
    let mut drawn: Vec<((f64, f64), Vec<&str>)> = Vec::new();
    for mount in &engine.mounts {
        let at = view.at(Complex64::new(mount.x, mount.y));
        match drawn.iter_mut().find(|(p, _)| (p.0 - at.0).hypot(p.1 - at.1) < 3.0) {
            Some((_, names)) => names.push(&mount.name),
            None => drawn.push((at, vec![&mount.name])),
        }
    }
    for (at, names) in drawn {
        draw_mount(svg, at);
        let label = names.join(", ");
        let half = 0.5 * text_width(&label, 11.5);
        svg.name(
            "small muted",
            (at.0.clamp(half + 2.0, WIDTH - half - 2.0), at.1 + 24.0),
            Anchor::Middle,
            &label,
        );
    }
}

/// A mount: a triangle on a line.
pub(crate) fn draw_mount(svg: &mut Svg, at: (f64, f64)) {
    let (x, y) = at;
    svg.path(
        "metal",
        &Path::new().move_to(at).line_to((x - 6.0, y + 9.0)).line_to((x + 6.0, y + 9.0)).close(),
    );
    svg.line("outline", (x - 9.0, y + 9.0), (x + 9.0, y + 9.0));
}

/// The axes of the frame in the lower corner: x up, y aside, z away from the viewer.
fn draw_frame(svg: &mut Svg, side: f64, base: f64) {
    let x = if side > 0.0 { 26.0 } else { 74.0 };
    let origin = (x, base + 14.0);
    svg.arrow("arrow turn", origin, (x, origin.1 - 38.0), 8.0);
    svg.arrow("arrow turn", origin, (x + side * 38.0, origin.1), 8.0);
    svg.circle("pin", origin, 5.0);
    svg.line("thin", (x - 3.5, origin.1 - 3.5), (x + 3.5, origin.1 + 3.5));
    svg.line("thin", (x - 3.5, origin.1 + 3.5), (x + 3.5, origin.1 - 3.5));
    svg.text("small muted", (x, origin.1 - 43.0), Anchor::Middle, "x");
    svg.text("small muted", (x + side * 46.0, origin.1 + 4.0), Anchor::Middle, "y");
    svg.text("small muted", (x - side * 13.0, origin.1 + 13.0), Anchor::Middle, "z");
}
