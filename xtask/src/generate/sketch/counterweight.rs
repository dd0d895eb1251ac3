//! The family of counterweights of the tool paper.

use super::sheet::Sketch;
use crate::generate::pen::{Anchor, Pen, Plane, beyond};
use std::f64::consts::PI;

/// Those of this file.
pub fn sketches() -> Vec<Sketch> {
    vec![Sketch {
        name: "counterweight-family",
        title: "The family of counterweights",
        says: "Around the disc of the web of radius r: a rectangle of half width r and height h, a trapezoid of height H out to the half width w, and a circular segment of radius R \
               and included angle α. The chord lies at y_s, the centre of the arc at y_c.",
        size: (460.0, 400.0),
        draw: family,
    }]
}

fn family(pen: &mut Pen) {
    let plane = Plane::level((215.0, 250.0), 1.0);
    let (r, h, height, radius, alpha) = (74.0, 44.0, 40.0, 142.0, 116f64.to_radians());
    // (22.20)
    let w = radius * (alpha / 2.0).sin();
    let (y_s, over) = (h + height, w - r);
    let y_c = y_s - radius * (alpha / 2.0).cos();
    let arc = plane.arc((0.0, y_c), radius, PI / 2.0 - alpha / 2.0, PI / 2.0 + alpha / 2.0);
    let outline =
        [plane.arc((0.0, 0.0), r, PI, 2.0 * PI), vec![plane.at((r, h))], arc, vec![plane.at((-r, h))]]
            .concat();
    pen.area("metal", &outline);
    pen.circle("axis-line", plane.at((0.0, 0.0)), r);
    pen.line("thin", plane.at((-r, h)), plane.at((r, h)));
    pen.line("thin", plane.at((-w, y_s)), plane.at((w, y_s)));
    pen.line("axis-line", plane.at((0.0, -90.0)), plane.at((0.0, 205.0)));
    pen.line("axis-line", plane.at((-100.0, 0.0)), plane.at((100.0, 0.0)));
    pen.circle("dot", plane.at((0.0, 0.0)), 4.0);
    pen.circle("dot", plane.at((0.0, y_c)), 4.0);
    let end = beyond((0.0, y_c), radius, PI / 2.0 - alpha / 2.0);
    pen.line("thin", plane.at((0.0, y_c)), plane.at(end));
    pen.arrow("measure", plane.at((0.0, y_c)), plane.at(beyond((0.0, y_c), radius, PI / 2.0 + 0.3 * alpha)));
    let (x, y) = plane.at(beyond((0.0, y_c), 0.74 * radius, PI / 2.0 + 0.3 * alpha));
    pen.symbol((x - 6.0, y + 18.0), Anchor::Middle, "R");
    pen.turn("turn", &plane.arc((0.0, y_c), 62.0, PI / 2.0, PI / 2.0 - alpha / 2.0));
    let (x, y) = plane.at(beyond((0.0, y_c), 78.0, PI / 2.0 - alpha / 4.0));
    pen.symbol((x, y + 6.0), Anchor::Middle, "α/2");
    pen.measure(plane.at((0.0, 0.0)), plane.at(beyond((0.0, 0.0), r, -PI / 4.0)), 0.0, "r");
    pen.measure(plane.at((r, 0.0)), plane.at((r, h)), -74.0, "h");
    pen.measure(plane.at((w, h)), plane.at((w, y_s)), 74.0 + r - w, "H");
    pen.measure(plane.at((-w, y_s)), plane.at((0.0, y_s)), 86.0, "w");
    pen.measure(plane.at((r, y_s)), plane.at((w, y_s)), 86.0, "");
    let (x, y) = plane.at((r + over / 2.0, y_s + 86.0));
    pen.symbol((x, y - 6.0), Anchor::Middle, "l_c");
    pen.measure(plane.at((-w, 0.0)), plane.at((-w, y_s)), 36.0, "y_s");
    pen.line("dimension", plane.at((-w - 36.0, 0.0)), plane.at((-r - 4.0, 0.0)));
    let (x, y) = plane.at((0.0, y_c));
    pen.symbol((x - 8.0, y + if y_c > 0.0 { -6.0 } else { 18.0 }), Anchor::End, "y_c");
    pen.arrow("a0", plane.at((0.0, 180.0)), plane.at((0.0, 214.0)));
    pen.symbol((205.0, 48.0), Anchor::End, "y");
    pen.arrow("a0", plane.at((96.0, 0.0)), plane.at((124.0, 0.0)));
    pen.symbol((340.0, 268.0), Anchor::Middle, "x");
    pen.remark((16.0, 388.0), Anchor::Start, "dash-dotted: the disc of the web, which counts to the web");
}
