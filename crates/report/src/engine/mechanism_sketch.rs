//! The crank train across the crank, drawn the same way in the engine drawing and in the stepped story.

use crate::engine::pose::{Pose, bore, pose};
use crate::kit::number;
use crate::kit::svg::{Anchor, Path, Svg, text_width};
use crate::kit::view::{Bounds, View};
use lanchester_model::Engine;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Height of a piston over its bore.
const PISTON_HEIGHT: f64 = 0.55;

/// Cylinders that look the same in this view: one bore line and all the positions of its pistons.
pub(crate) struct Bank {
    /// Indices of its cylinders.
    pub cylinders: Vec<usize>,
    /// Direction of the axis.
    pub axis: Complex64,
    /// Foot of the axis: the point nearest to the crankshaft's axis.
    pub foot: Complex64,
    /// From the foot to the lower edge of the bore and to the head [m].
    pub walls: (f64, f64),
    /// Bore [m].
    pub bore: f64,
}

/// Cylinders grouped by their axis.
pub(crate) fn banks(engine: &Engine) -> Vec<Bank> {
    let mut banks: Vec<Bank> = Vec::new();
    for (index, cylinder) in engine.cylinders.iter().enumerate() {
        let still = pose(engine, index, 0.0);
        let foot = still.centre + still.axis * Complex64::new(0.0, cylinder.offset);
        let bore = bore(engine, index);
        // The stroke as the picture needs it; the tables print the exact one.
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for step in 0..72 {
            let at = pose(engine, index, TAU * f64::from(step) / 72.0);
            let height = ((at.piston - foot) / at.axis).re;
            (low, high) = (low.min(height), high.max(height));
        }
        let half = 0.5 * PISTON_HEIGHT * bore;
        let walls = (low - half, high + half + 0.06 * bore);
        let same = |b: &&mut Bank| (b.axis - still.axis).norm() < 1e-6 && (b.foot - foot).norm() < 1e-6;
        match banks.iter_mut().find(same) {
            Some(bank) => {
                bank.cylinders.push(index);
                bank.walls = (bank.walls.0.min(walls.0), bank.walls.1.max(walls.1));
                bank.bore = bank.bore.max(bore);
            }
            None => banks.push(Bank { cylinders: vec![index], axis: still.axis, foot, walls, bore }),
        }
    }
    banks
}

/// The space that the crank train needs, as `(y, -x)` with +y to the right.
pub(crate) fn bounds(engine: &Engine, banks: &[Bank], side: f64) -> Bounds {
    let mut out = Bounds::empty();
    let mut take = |p: Complex64, radius: f64| out.take((side * p.im, -p.re), radius);
    for throw in &engine.throws {
        let shaft = &engine.crankshafts[throw.crankshaft];
        take(Complex64::new(shaft.x, shaft.y), 1.45 * throw.radius);
    }
    for bank in banks {
        for height in [bank.walls.0, bank.walls.1] {
            for across in [-0.5 * bank.bore, 0.5 * bank.bore] {
                take(bank.foot + bank.axis * Complex64::new(height, across), 0.0);
            }
        }
    }
    out
}

/// Walls and heads of all cylinders.
pub(crate) fn draw_walls(svg: &mut Svg, view: &View, banks: &[Bank]) {
    for bank in banks {
        let at = |height: f64, across: f64| view.at(bank.foot + bank.axis * Complex64::new(height, across));
        let half = 0.5 * bank.bore;
        let path = Path::new()
            .move_to(at(bank.walls.0, -half))
            .line_to(at(bank.walls.1, -half))
            .line_to(at(bank.walls.1, half))
            .line_to(at(bank.walls.0, half));
        svg.path("wall", &path);
    }
}

/// Pistons, rods and throws at crank angle `theta`; links that coincide are drawn once.
pub(crate) fn draw_links(svg: &mut Svg, view: &View, engine: &Engine, theta: f64) {
    let mut poses: Vec<(Pose, f64)> = Vec::new();
    for index in 0..engine.cylinders.len() {
        let now = pose(engine, index, theta);
        let near = |a: Complex64, b: Complex64| (a - b).norm() * view.scale < 0.7;
        let same = |p: &(Pose, f64)| {
            near(p.0.crankpin, now.crankpin)
                && near(p.0.piston_pin, now.piston_pin)
                && near(p.0.big_end, now.big_end)
        };
        if !poses.iter().any(same) {
            poses.push((now, bore(engine, index)));
        }
    }
    for (now, bore) in &poses {
        let (half, height) = (0.47 * bore, 0.5 * PISTON_HEIGHT * bore);
        let corner = |up: f64, across: f64| view.at(now.piston + now.axis * Complex64::new(up, across));
        let path = Path::new()
            .move_to(corner(height, -half))
            .line_to(corner(height, half))
            .line_to(corner(-height, half))
            .line_to(corner(-height, -half))
            .close();
        svg.path("metal", &path);
    }
    for (now, _) in &poses {
        if now.big_end != now.crankpin {
            svg.line("rod", view.at(now.crankpin), view.at(now.big_end));
        }
        svg.line("rod", view.at(now.big_end), view.at(now.piston_pin));
    }
    for (now, _) in &poses {
        svg.line("crank", view.at(now.centre), view.at(now.crankpin));
    }
    for (now, _) in &poses {
        svg.circle("pin", view.at(now.piston_pin), 2.6);
        svg.circle("pin", view.at(now.crankpin), 3.6);
        if now.big_end != now.crankpin {
            svg.circle("pin", view.at(now.big_end), 2.4);
        }
    }
    for shaft in &engine.crankshafts {
        svg.circle("pin", view.at(Complex64::new(shaft.x, shaft.y)), 4.2);
    }
}

/// Cylinder numbers: beside the bores, level with the pistons, where there is room; else beyond the heads.
pub(crate) fn draw_piston_numbers(svg: &mut Svg, view: &View, engine: &Engine, banks: &[Bank], theta: f64) {
    type Place = ((f64, f64), (f64, f64), Vec<usize>);
    let mut places: Vec<Place> = Vec::new();
    // Beside the bores there is room for few.
    let crowded = banks.len() > 1 && engine.cylinders.len() > 6;
    let (beyond, beside): (Vec<&Bank>, Vec<&Bank>) =
        banks.iter().partition(|b| crowded || b.cylinders.len() == 1);
    for bank in beyond {
        let at = view.at(bank.foot + bank.axis * bank.walls.1);
        let outwards = View { scale: 1.0, ..*view }.span(bank.axis);
        places.push((at, outwards, bank.cylinders.iter().map(|c| c + 1).collect()));
    }
    for &index in beside.iter().flat_map(|b| &b.cylinders) {
        let now = pose(engine, index, theta);
        // To the right on the screen, to the upper side of a lying cylinder.
        let across = now.axis * Complex64::new(0.0, 1.0);
        let (dx, dy) = View { scale: 1.0, ..*view }.span(across);
        let sign = if dx > 0.1 || (dx.abs() <= 0.1 && dy < 0.0) { 1.0 } else { -1.0 };
        let at = view.at(now.piston + across * (0.5 * sign * bore(engine, index)));
        match places.iter_mut().find(|p| (p.0.0 - at.0).hypot(p.0.1 - at.1) < 8.0) {
            Some((_, _, list)) => list.push(index + 1),
            None => places.push((at, (sign * dx, sign * dy), vec![index + 1])),
        }
    }
    for (at, (dx, dy), list) in places {
        let label = number::list(&list);
        let gap = 6.0 + dx.abs() * 0.5 * text_width(&label, 12.0);
        svg.text("small strong halo", (at.0 + gap * dx, at.1 + gap * dy + 4.0), Anchor::Middle, &label);
    }
}

/// A weight around its axis: a piece of a ring towards `direction` [rad in the frame].
pub(crate) fn draw_sector(
    svg: &mut Svg,
    view: &View,
    class: &str,
    centre: (f64, f64),
    radii: (f64, f64),
    direction: f64,
) {
    let spread = 0.62;
    let at = |radius: f64, offset: f64| {
        let angle = view.angle(direction) + offset;
        (centre.0 + radius * angle.cos(), centre.1 + radius * angle.sin())
    };
    let path = Path::new()
        .move_to(at(radii.0, -spread))
        .line_to(at(radii.1, -spread))
        .arc_to(radii.1, false, true, at(radii.1, spread))
        .line_to(at(radii.0, spread))
        .arc_to(radii.0, false, false, at(radii.0, -spread))
        .close();
    svg.path(class, &path);
}
