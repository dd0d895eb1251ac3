//! The frame and the signs in one sketch.

use crate::kit::figure::{Figure, Panel};
use crate::kit::svg::{Anchor, Svg};
use crate::kit::view::View;
use lanchester_model::Rotation;
use num_complex::Complex64;
use std::f64::consts::FRAC_PI_4;

const HEIGHT: f64 = 236.0;

/// The frame from the free end and from the side, with the signs of forces and moments.
pub fn frame_sketch(rotation: Rotation) -> Figure {
    Figure {
        id: "frame".to_owned(),
        title: "Frame and signs".to_owned(),
        caption: "Left: from the free end towards the flywheel; z points away from the reader. Right: from the side.".to_owned(),
        panels: vec![front(rotation), side(rotation)],
        columns: 2,
    }
}

fn front(rotation: Rotation) -> Panel {
    let mut svg = Svg::new(300.0, HEIGHT);
    let view = View::new(rotation, (150.0, 132.0), 58.0);
    let centre = view.centre;
    let end = |x: f64, y: f64| view.at(Complex64::new(x, y));
    svg.circle("axis-line", centre, view.scale);
    svg.line("grid", centre, end(-1.25, 0.0));
    svg.line("grid", centre, end(0.0, -1.6));
    svg.arrow("arrow turn", centre, end(1.75, 0.0), 9.0);
    svg.arrow("arrow turn", centre, end(0.0, 1.75), 9.0);
    let label = end(1.75, 0.0);
    svg.text("strong", (label.0, label.1 - 7.0), Anchor::Middle, "x, F_x, M_x");
    let (label, anchor) = (end(0.0, 1.82), if view.side > 0.0 { Anchor::Start } else { Anchor::End });
    svg.text("strong", (label.0, label.1 - 3.0), anchor, "y");
    svg.text("small muted", (label.0, label.1 + 14.0), anchor, "F_y, M_y");
    let pin = Complex64::from_polar(1.0, FRAC_PI_4 * 1.1);
    svg.line("crank", centre, view.at(pin));
    svg.circle("pin", view.at(pin), 4.5);
    let throw = view.at(pin * 1.18);
    svg.text("small muted", (throw.0 + 24.0 * view.side, throw.1 + 2.0), Anchor::Middle, "throw 1");
    svg.arc_arrow("arrow a1", centre, 34.0, view.angle(0.0), view.angle(FRAC_PI_4 * 1.1), 8.0);
    let theta = view.at(Complex64::from_polar(0.82, 0.42));
    svg.text("strong", (theta.0, theta.1 + 4.0), Anchor::Middle, "θ");
    svg.arc_arrow("arrow turn", centre, 74.0, view.angle(3.4), view.angle(4.2), 9.0);
    let turn = view.at(Complex64::from_polar(1.5, 3.75));
    let anchor = if view.side > 0.0 { Anchor::End } else { Anchor::Start };
    svg.text("small muted", (turn.0, turn.1 + 4.0), anchor, "crank, M_z");
    svg.circle("pin", centre, 6.0);
    svg.line("outline", (centre.0 - 4.0, centre.1 - 4.0), (centre.0 + 4.0, centre.1 + 4.0));
    svg.line("outline", (centre.0 - 4.0, centre.1 + 4.0), (centre.0 + 4.0, centre.1 - 4.0));
    Panel::new(svg, "Seen from the free end: x up, the crank turns from x to y; z points away.")
}

fn side(rotation: Rotation) -> Panel {
    let mut svg = Svg::new(300.0, HEIGHT);
    let origin = (138.0, 140.0);
    let throw = |svg: &mut Svg, x: f64, up: f64| {
        let path = crate::kit::svg::Path::new()
            .move_to((x - 30.0, origin.1))
            .line_to((x - 14.0, origin.1))
            .line_to((x - 14.0, origin.1 - up))
            .line_to((x + 14.0, origin.1 - up))
            .line_to((x + 14.0, origin.1))
            .line_to((x + 30.0, origin.1));
        svg.path("shaft-line", &path);
    };
    throw(&mut svg, 86.0, 34.0);
    throw(&mut svg, 190.0, -34.0);
    svg.line("crank", (30.0, origin.1), (58.0, origin.1));
    svg.line("crank", (114.0, origin.1), (162.0, origin.1));
    svg.line("crank", (218.0, origin.1), (236.0, origin.1));
    svg.rect("metal", 236.0, origin.1 - 44.0, 9.0, 88.0);
    svg.arrow("arrow turn", (245.0, origin.1), (276.0, origin.1), 9.0);
    svg.text("strong", (286.0, origin.1 + 4.5), Anchor::Middle, "z");
    svg.arrow("arrow turn", origin, (origin.0, 56.0), 9.0);
    svg.text("strong", (origin.0, 48.0), Anchor::Middle, "x");
    svg.arrow("arrow a1", (190.0, origin.1), (190.0, origin.1 - 62.0), 10.0);
    svg.text("", (198.0, origin.1 - 52.0), Anchor::Start, "F_x");
    svg.line("dimension", (origin.0, origin.1 + 50.0), (190.0, origin.1 + 50.0));
    svg.line("dimension", (origin.0, origin.1 + 45.0), (origin.0, origin.1 + 55.0));
    svg.line("dimension", (190.0, origin.1 + 45.0), (190.0, origin.1 + 55.0));
    svg.text("small muted halo", (164.0, origin.1 + 54.0), Anchor::Middle, "z");
    svg.circle("outline", origin, 5.0);
    svg.text("small muted", (30.0, HEIGHT - 10.0), Anchor::Start, "free end");
    svg.text("small muted", (276.0, HEIGHT - 10.0), Anchor::End, "flywheel");
    svg.text("small", (30.0, 18.0), Anchor::Start, "M_y = z F_x,  M_x = −z F_y");
    let turning = if rotation == Rotation::Clockwise { "clockwise" } else { "anticlockwise" };
    Panel::new(svg, format!("Seen from the side; from the free end the crank turns {turning}."))
}
