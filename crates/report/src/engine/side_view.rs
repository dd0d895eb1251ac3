//! The engine drawn from the side at theta = 0: free end left, flywheel right, x up.

use crate::engine::front_view::draw_mount;
use crate::engine::mechanism_sketch::banks;
use crate::engine::pose::bore;
use crate::kit::figure::{Figure, Panel};
use crate::kit::number;
use crate::kit::svg::{Anchor, Path, Svg, text_width};
use crate::kit::view::Bounds;
use lanchester_model::Engine;

const WIDTH: f64 = 440.0;
const MARGIN: f64 = 34.0;
const TALLEST: f64 = 300.0;

/// From (z, x) [m] to the screen.
#[derive(Clone, Copy)]
struct Side {
    origin: (f64, f64),
    scale: f64,
}

impl Side {
    fn at(&self, z: f64, x: f64) -> (f64, f64) {
        (self.origin.0 + z * self.scale, self.origin.1 - x * self.scale)
    }
}

/// Where a cylinder appears from the side.
struct Outline {
    number: usize,
    z: f64,
    half: f64,
    /// Lower and upper end along x; equal for a cylinder that points at the viewer.
    span: (f64, f64),
    /// Looking from +y: the other bank lies behind.
    behind: bool,
}

/// Main line, throws, cylinders, weights, shafts and mounts seen from the side.
pub fn side_view(engine: &Engine) -> Figure {
    let outlines = outlines(engine);
    let radius = engine.throws.iter().fold(0.0f64, |m, t| m.max(t.radius));
    let mut space = Bounds::empty();
    for outline in &outlines {
        for x in [outline.span.0, outline.span.1] {
            space.take((outline.z - outline.half, -x), 0.0);
            space.take((outline.z + outline.half, -x), 0.0);
        }
    }
    let others = engine
        .throws
        .iter()
        .map(|t| (t.z, engine.crankshafts[t.crankshaft].x))
        .chain(engine.counterweights.iter().map(|w| (w.z, engine.crankshafts[w.crankshaft].x)));
    for (z, x) in others {
        space.take((z, -x), 1.2 * radius);
    }
    for shaft in &engine.shafts {
        for weight in &shaft.weights {
            space.take((weight.z, -shaft.x), 0.5 * radius);
        }
    }
    let ends_of_crank = (space.low.0, space.high.0);
    for mount in &engine.mounts {
        space.take((mount.z, -mount.x), 0.1 * radius);
    }
    space.take((0.0, 0.0), 0.0);
    let ends = 30.0;
    let scale =
        ((WIDTH - 2.0 * (MARGIN + ends)) / space.width()).min((TALLEST - 2.0 * MARGIN) / space.height());
    let height = space.height() * scale + 2.0 * MARGIN;
    let side = Side {
        origin: (
            0.5 * WIDTH - 0.5 * (space.low.0 + space.high.0) * scale,
            0.5 * height - 0.5 * (space.low.1 + space.high.1) * scale,
        ),
        scale,
    };
    let base = height + 4.0;
    let mut svg = Svg::new(WIDTH, base + 62.0);
    draw_cylinders(&mut svg, &side, &outlines);
    draw_weights(&mut svg, &side, engine, radius);
    draw_crankshafts(&mut svg, &side, engine, ends_of_crank);
    draw_shafts(&mut svg, &side, engine, radius);
    for mount in &engine.mounts {
        draw_mount(&mut svg, side.at(mount.z, mount.x));
    }
    draw_origin(&mut svg, &side);
    draw_dimensions(&mut svg, &side, engine, base);
    svg.text("small muted", (8.0, base + 56.0), Anchor::Start, "free end");
    svg.text("small muted", (WIDTH - 8.0, base + 56.0), Anchor::End, "flywheel");
    svg.arrow("arrow turn", (0.5 * WIDTH - 26.0, base + 52.0), (0.5 * WIDTH + 26.0, base + 52.0), 8.0);
    svg.text("small muted", (0.5 * WIDTH + 36.0, base + 56.0), Anchor::Middle, "z");
    Figure {
        id: "side-view".to_owned(),
        title: "The engine from the side".to_owned(),
        caption: "At θ = 0, x up. Throws stand at their height at this angle; a cylinder behind the crank is drawn dashed, \
                  one that points at the reader as a circle. Distances in mm; the cross is the origin."
            .to_owned(),
        panels: vec![Panel::new(svg, "Crankshaft, cylinders and weights along the crank axis, at theta = 0.")],
        columns: 1,
    }
}

fn outlines(engine: &Engine) -> Vec<Outline> {
    let mut out = Vec::with_capacity(engine.cylinders.len());
    for bank in banks(engine) {
        for &index in &bank.cylinders {
            let at = |height: f64| (bank.foot + bank.axis * height).re;
            let upright = bank.axis.re.abs() > 0.12;
            let span =
                if upright { (at(bank.walls.0), at(bank.walls.1)) } else { (bank.foot.re, bank.foot.re) };
            out.push(Outline {
                number: index + 1,
                z: engine.cylinders[index].z,
                half: 0.5 * bore(engine, index),
                span,
                behind: bank.axis.im < -1e-6,
            });
        }
    }
    out.sort_by_key(|o| (!o.behind, o.number));
    out
}

fn draw_cylinders(svg: &mut Svg, side: &Side, outlines: &[Outline]) {
    let mut labels: Vec<((f64, f64), Vec<usize>)> = Vec::new();
    for outline in outlines {
        let class = if outline.behind { "wall dashed" } else { "wall" };
        let (left, right) = (outline.z - outline.half, outline.z + outline.half);
        let (low, high) = outline.span;
        let at = if low == high {
            svg.circle(class, side.at(outline.z, low), outline.half * side.scale);
            let (x, y) = side.at(outline.z, low);
            (x, y - outline.half * side.scale - 6.0)
        } else {
            let path = Path::new()
                .move_to(side.at(left, low))
                .line_to(side.at(left, high))
                .line_to(side.at(right, high))
                .line_to(side.at(right, low));
            svg.path(class, &path);
            let (x, y) = side.at(outline.z, high);
            (x, if high > low { y - 7.0 } else { y + 16.0 })
        };
        match labels.iter_mut().find(|(p, _)| (p.0 - at.0).abs() < 14.0 && (p.1 - at.1).abs() < 12.0) {
            Some((place, list)) => {
                place.0 = 0.5 * (place.0 + at.0);
                list.push(outline.number);
            }
            None => labels.push((at, vec![outline.number])),
        }
    }
    for (at, list) in labels {
        svg.text("strong", at, Anchor::Middle, &number::list(&list));
    }
}

/// Crankshafts as one line through journals, webs and pins.
fn draw_crankshafts(svg: &mut Svg, side: &Side, engine: &Engine, ends: (f64, f64)) {
    for (index, shaft) in engine.crankshafts.iter().enumerate() {
        let mut throws: Vec<(usize, f64)> = (0..engine.throws.len())
            .filter(|&t| engine.throws[t].crankshaft == index)
            .map(|t| (t, engine.throws[t].z))
            .collect();
        throws.sort_by(|a, b| a.1.total_cmp(&b.1));
        let gaps = throws.windows(2).map(|w| w[1].1 - w[0].1).filter(|g| *g > 1e-4);
        let radius = throws.iter().fold(0.0f64, |m, t| m.max(engine.throws[t.0].radius));
        let web = gaps.fold(1.2 * radius, f64::min) * 0.3;
        let margin = 14.0 / side.scale;
        let mut path = Path::new().move_to(side.at(ends.0 - margin, shaft.x));
        let mut last = f64::NEG_INFINITY;
        for &(throw, z) in &throws {
            let height = shaft.x + engine.throws[throw].radius * engine.pin_angle(throw, 0.0).cos();
            // Neighbouring pins of a split pair share the web between them.
            let left = (z - web).max(last);
            path = path
                .line_to(side.at(left, shaft.x))
                .line_to(side.at(left, height))
                .line_to(side.at(z + web, height))
                .line_to(side.at(z + web, shaft.x));
            last = z + web;
        }
        let end = ends.1 + margin;
        svg.path("shaft-line", &path.line_to(side.at(end, shaft.x)));
        for &(throw, z) in &throws {
            let height = shaft.x + engine.throws[throw].radius * engine.pin_angle(throw, 0.0).cos();
            svg.circle("pin", side.at(z, height), 2.6);
        }
        if index == 0 {
            let (x, y) = side.at(end, shaft.x);
            let half = (1.1 * radius * side.scale).clamp(14.0, 40.0);
            svg.rect("metal", x, y - half, 8.0, 2.0 * half);
        }
    }
}

fn draw_weights(svg: &mut Svg, side: &Side, engine: &Engine, radius: f64) {
    for weight in engine.counterweights.iter().filter(|w| w.unbalance > 0.0) {
        let shaft = &engine.crankshafts[weight.crankshaft];
        let height = 1.15 * radius * (shaft.phase + weight.angle).cos();
        let (x, y) = side.at(weight.z, shaft.x);
        // A weight that points at the reader shows its width.
        let tall = if height.abs() < 0.25 * radius { 0.25 * radius } else { height };
        svg.rect("weight", x - 4.0, y, 8.0, -tall * side.scale);
    }
}

fn draw_shafts(svg: &mut Svg, side: &Side, engine: &Engine, radius: f64) {
    for shaft in &engine.shafts {
        let low = shaft.weights.iter().fold(f64::INFINITY, |m, w| m.min(w.z)).min(0.0) - 0.5 * radius;
        let high = shaft.weights.iter().fold(f64::NEG_INFINITY, |m, w| m.max(w.z)).max(0.0) + 0.5 * radius;
        svg.line("outline", side.at(low, shaft.x), side.at(high, shaft.x));
        for weight in shaft.weights.iter().filter(|w| w.unbalance > 0.0) {
            let height = 0.42 * radius * weight.phase.cos();
            let (x, y) = side.at(weight.z, shaft.x);
            let tall = if height.abs() < 0.15 * radius { 0.15 * radius } else { height };
            svg.rect("weight", x - 6.0, y, 12.0, -tall * side.scale);
        }
    }
}

fn draw_origin(svg: &mut Svg, side: &Side) {
    let (x, y) = side.at(0.0, 0.0);
    svg.circle("outline", (x, y), 5.0);
    svg.line("outline", (x - 8.0, y), (x + 8.0, y));
    svg.line("outline", (x, y - 8.0), (x, y + 8.0));
}

/// Distances between neighbouring throw planes, and the whole.
fn draw_dimensions(svg: &mut Svg, side: &Side, engine: &Engine, y: f64) {
    let mut planes: Vec<f64> = engine.throws.iter().map(|t| t.z).collect();
    planes.sort_by(f64::total_cmp);
    planes.dedup_by(|a, b| (*a - *b).abs() < 1e-5);
    let millimetres =
        |length: f64| number::fixed(1e3 * length, usize::from((1e3 * length).fract().abs() > 0.05));
    let mut line = |from: f64, to: f64, y: f64| {
        let (left, right) = (side.at(from, 0.0).0, side.at(to, 0.0).0);
        let text = millimetres(to - from);
        let width = text_width(&text, 11.5);
        if width + 16.0 > right - left {
            return;
        }
        svg.line("dimension", (left, y - 5.0), (left, y + 5.0));
        svg.line("dimension", (right, y - 5.0), (right, y + 5.0));
        svg.line("dimension", (left, y), (right, y));
        svg.text("small muted halo", (0.5 * (left + right), y + 4.0), Anchor::Middle, &text);
    };
    // One of many equal distances is enough.
    let equal = planes.windows(3).all(|w| ((w[2] - w[1]) - (w[1] - w[0])).abs() < 1e-5);
    let shown = if equal { 2.min(planes.len()) } else { planes.len() };
    for pair in planes[..shown].windows(2) {
        line(pair[0], pair[1], y);
    }
    if let (Some(first), Some(last), true) = (planes.first(), planes.last(), planes.len() > 2) {
        line(*first, *last, y + 22.0);
    }
}
