//! The crankshaft as a body and its bearings: film, throw, fillet, big end.

use super::linkage::Linkage;
use super::sheet::Sketch;
use crate::generate::pen::{Anchor, Pen, Plane, between, beyond};
use std::f64::consts::PI;

/// Those of this file.
pub fn sketches() -> Vec<Sketch> {
    vec![
        Sketch {
            name: "film",
            title: "The film of a journal bearing",
            says: "The journal's centre lies at e from that of the bearing. In the direction n at the angle a the film is h = c − e·n thick: thinnest along e, thickest opposite.",
            size: (460.0, 400.0),
            draw: film,
        },
        Sketch {
            name: "throw-sizes",
            title: "Sizes of a throw",
            says: "Pin of diameter D, journals of diameter D_G, webs of thickness W, crank radius E, fillets R_H and R_G; pin and journal overlap by s D. Right: the web along the \
                   crank, with its width B.",
            size: (460.0, 330.0),
            draw: throw_sizes,
        },
        Sketch {
            name: "fillet-mesh",
            title: "From a sharp corner to the fillet",
            says: "Left: the mesh with a sharp corner between bar and web. Right: its surface moved onto the fillet of radius R by (43.9), the motion fading within the body over \
                   the depth H.",
            size: (460.0, 270.0),
            draw: fillet_mesh,
        },
        Sketch {
            name: "big-end",
            title: "A big end on its pin",
            says: "The big end stands at x along the cylinder axis and y across it; the piston pin follows on the line y = e at s, with the rod at the angle φ and its centre of gravity at \
                   g from the big end. In the enlarged circle the pin lies e from the centre of the big end, within the clearance c.",
            size: (460.0, 460.0),
            draw: big_end,
        },
    ]
}

fn film(pen: &mut Pen) {
    let plane = Plane::level((200.0, 205.0), 1.0);
    let (shell, clearance) = (160.0, 44.0);
    let journal = shell - clearance;
    let (eccentric, attitude) = (27.0, -50f64.to_radians());
    let centre = beyond((0.0, 0.0), eccentric, attitude);
    pen.area("film", &plane.arc((0.0, 0.0), shell, 0.0, 2.0 * PI));
    pen.circle("metal", plane.at(centre), journal);
    pen.circle("outline", plane.at((0.0, 0.0)), shell);
    pen.circle("axis-line", plane.at((0.0, 0.0)), journal);
    pen.line("axis-line", plane.at((-178.0, 0.0)), plane.at((190.0, 0.0)));
    pen.line("axis-line", plane.at((0.0, -178.0)), plane.at((0.0, 178.0)));
    // Along n the journal's surface is met where |p − e| is its radius.
    let a = 58f64.to_radians();
    let along = centre.0 * a.cos() + centre.1 * a.sin();
    let across = centre.1 * a.cos() - centre.0 * a.sin();
    let surface = along + (journal * journal - across * across).sqrt();
    pen.arrow("a1", plane.at((0.0, 0.0)), plane.at(beyond((0.0, 0.0), 74.0, a)));
    let (x, y) = plane.at(beyond((0.0, 0.0), 60.0, a));
    pen.symbol((x - 8.0, y), Anchor::End, "n");
    pen.line("thin", plane.at(beyond((0.0, 0.0), 74.0, a)), plane.at(beyond((0.0, 0.0), surface, a)));
    pen.measure(plane.at(beyond((0.0, 0.0), surface, a)), plane.at(beyond((0.0, 0.0), shell, a)), 0.0, "h");
    pen.angle(&plane, (0.0, 0.0), 40.0, [0.0, a], "a");
    let opposite = 200f64.to_radians();
    pen.measure(
        plane.at(beyond((0.0, 0.0), journal, opposite)),
        plane.at(beyond((0.0, 0.0), shell, opposite)),
        0.0,
        "c",
    );
    pen.arrow("a2", plane.at((0.0, 0.0)), plane.at(centre));
    let (x, y) = plane.at(centre);
    pen.symbol((x + 8.0, y + 14.0), Anchor::Start, "e");
    pen.circle("dot", plane.at((0.0, 0.0)), 4.0);
    pen.circle("dot", plane.at(centre), 4.0);
    pen.turn("a0", &plane.arc(centre, 84.0, -2.1, -1.4));
    let (x, y) = plane.at(beyond(centre, 66.0, -1.7));
    pen.words((x, y), Anchor::Middle, "journal");
    pen.words((372.0, 86.0), Anchor::Start, "shell");
    pen.line("thin", (368.0, 84.0), plane.at(beyond((0.0, 0.0), shell, 0.72)));
    pen.measure(plane.at((0.0, 0.0)), plane.at(beyond((0.0, 0.0), shell, PI)), 0.0, "R");
    pen.remark((16.0, 392.0), Anchor::Start, "clearance enlarged; dash-dotted: the journal without load");
}

fn throw_sizes(pen: &mut Pen) {
    let plane = Plane::level((150.0, 208.0), 1.0);
    let (journal, pin, crank, web, length, fillet) = (84.0, 74.0, 60.0, 32.0, 64.0, 9.0);
    let (low, high) = (-54.0, crank + pin / 2.0 + 12.0);
    // Half the throw to the right of its middle; the other half is its mirror image.
    let half = |side: f64| -> Vec<(f64, f64)> {
        let (inner, outer) = (length / 2.0, length / 2.0 + web);
        let mut points = vec![(0.0, crank + pin / 2.0)];
        points.extend(rounded((inner, crank + pin / 2.0), fillet, [PI * 1.5, PI * 2.0], (-1.0, 1.0)));
        points.extend([(inner, high), (outer, high)]);
        points.extend(rounded((outer, journal / 2.0), fillet, [PI, PI * 1.5], (1.0, 1.0)));
        points.push((outer + 46.0, journal / 2.0));
        points.push((outer + 46.0, -journal / 2.0));
        points.extend(rounded((outer, -journal / 2.0), fillet, [PI * 0.5, PI], (1.0, -1.0)));
        points.extend([(outer, low), (inner, low)]);
        points.extend(rounded((inner, crank - pin / 2.0), fillet, [0.0, PI * 0.5], (-1.0, -1.0)));
        points.push((0.0, crank - pin / 2.0));
        points.into_iter().map(|(a, b)| (side * a, b)).collect()
    };
    let outline: Vec<_> =
        half(1.0).into_iter().chain(half(-1.0).into_iter().rev()).map(|p| plane.at(p)).collect();
    pen.area("metal", &outline);
    pen.line("axis-line", plane.at((-140.0, 0.0)), plane.at((140.0, 0.0)));
    pen.line("axis-line", plane.at((-50.0, crank)), plane.at((50.0, crank)));
    pen.measure(plane.at((14.0, crank - pin / 2.0)), plane.at((14.0, crank + pin / 2.0)), 0.0, "D");
    pen.measure(plane.at((-122.0, -journal / 2.0)), plane.at((-122.0, journal / 2.0)), 0.0, "D_G");
    pen.measure(plane.at((-20.0, 0.0)), plane.at((-20.0, crank)), 0.0, "E");
    pen.measure(plane.at((length / 2.0, high)), plane.at((length / 2.0 + web, high)), 14.0, "");
    pen.symbol((150.0 + length / 2.0 + web / 2.0, 208.0 - high - 22.0), Anchor::Middle, "W");
    // The overlap: from the lower edge of the pin to the upper one of the journal.
    let edge = length / 2.0 + web / 2.0;
    for height in [journal / 2.0, crank - pin / 2.0] {
        pen.line("limit", plane.at((length / 2.0, height)), plane.at((length / 2.0 + web, height)));
    }
    pen.measure(plane.at((edge, crank - pin / 2.0)), plane.at((edge, journal / 2.0)), 0.0, "");
    let (x, y) = plane.at((edge, 6.0));
    pen.symbol((x, y), Anchor::Middle, "s D");
    let (x, y) = plane.at((-length / 2.0 + 4.0, crank + pin / 2.0 + 4.0));
    pen.arrow("measure", (x + 26.0, y - 30.0), (x - 1.0, y - 1.0));
    pen.symbol((x + 28.0, y - 32.0), Anchor::Start, "R_H");
    let (x, y) = plane.at((length / 2.0 + web + 3.0, journal / 2.0 + 3.0));
    pen.arrow("measure", (x + 24.0, y - 26.0), (x, y));
    pen.symbol((x + 26.0, y - 28.0), Anchor::Start, "R_G");
    let face = Plane::level((372.0, 208.0), 1.0);
    let (big, small) = (54.0, pin / 2.0 + 12.0);
    // The hull of a disc about the crank axis and one about the pin.
    let lean = ((big - small) / crank).asin();
    let hull = [
        face.arc((0.0, crank), small, lean, PI - lean),
        face.arc((0.0, 0.0), big, PI - lean, 2.0 * PI + lean),
    ]
    .concat();
    pen.area("metal", &hull);
    pen.circle("outline", face.at((0.0, crank)), pin / 2.0);
    pen.circle("axis-line", face.at((0.0, 0.0)), journal / 2.0);
    pen.line("axis-line", face.at((0.0, -70.0)), face.at((0.0, 122.0)));
    let middle = (journal / 2.0 + crank - pin / 2.0) / 2.0;
    let width = (big - middle * lean.sin()) / lean.cos();
    pen.measure(face.at((-width, middle)), face.at((width, middle)), 0.0, "B");
    pen.remark((372.0, 300.0), Anchor::Middle, "along the crank");
    pen.remark((150.0, 300.0), Anchor::Middle, "from the side");
}

/// Points of a fillet's arc about the corner of a bar and a face; the centre lies towards the given quadrant.
fn rounded(
    corner: (f64, f64),
    radius: f64,
    [from, to]: [f64; 2],
    (right, up): (f64, f64),
) -> Vec<(f64, f64)> {
    let centre = (corner.0 + right * radius, corner.1 + up * radius);
    (0..=8).map(|k| beyond(centre, radius, from + (to - from) * f64::from(k) / 8.0)).collect()
}

/// Fillet and depth of the mesh that is drawn [px], and its parts across the fillet.
const RADIUS: f64 = 84.0;
const DEPTH: f64 = 84.0;
const PARTS: i32 = 6;

fn fillet_mesh(pen: &mut Pen) {
    for (mapped, left) in [(false, 26.0), (true, 250.0)] {
        // ζ to the right from the web's face, ρ up from the cylinder.
        let plane = Plane::level((left + DEPTH, 104.0), 1.0);
        let place = |zeta: f64, rho: f64| plane.at(if mapped { moved(zeta, rho) } else { (zeta, rho) });
        let steps = |from: f64, to: f64| {
            (0..=PARTS).map(move |k| from + (to - from) * f64::from(k) / f64::from(PARTS))
        };
        // Lines along the bar and into it, then those of the web.
        for rho in steps(-DEPTH, 0.0) {
            let line: Vec<_> =
                (0..=40).map(|k| place(-DEPTH + (RADIUS + DEPTH) * f64::from(k) / 40.0, rho)).collect();
            pen.chain("hatch", &line);
        }
        for zeta in steps(0.0, RADIUS).chain(steps(-DEPTH, 0.0)) {
            let line: Vec<_> = (0..=20).map(|k| place(zeta, -DEPTH * f64::from(k) / 20.0)).collect();
            pen.chain("hatch", &line);
        }
        for zeta in steps(-DEPTH, 0.0) {
            let line: Vec<_> = (0..=20).map(|k| place(zeta, RADIUS * f64::from(k) / 20.0)).collect();
            pen.chain("hatch", &line);
        }
        for rho in steps(0.0, RADIUS) {
            let line: Vec<_> = (0..=20).map(|k| place(-DEPTH * f64::from(k) / 20.0, rho)).collect();
            pen.chain("hatch", &line);
        }
        let surface: Vec<_> = (0..=20)
            .map(|k| place(0.0, RADIUS * (1.0 - f64::from(k) / 20.0)))
            .chain((0..=20).map(|k| place(RADIUS * f64::from(k) / 20.0, 0.0)))
            .collect();
        pen.chain("s0", &surface);
        if mapped {
            let centre = plane.at((RADIUS, RADIUS));
            let foot = plane.at(beyond((RADIUS, RADIUS), RADIUS, PI * 1.25));
            pen.arrow("measure", centre, foot);
            let (x, y) = between(centre, foot, 0.45);
            pen.symbol((x + 4.0, y + 18.0), Anchor::Start, "R");
            pen.circle("dot", centre, 3.0);
        } else {
            let corner = plane.at((0.0, 0.0));
            pen.arrow("a1", corner, (corner.0 + 44.0, corner.1));
            pen.symbol((corner.0 + 46.0, corner.1 - 8.0), Anchor::Middle, "ζ");
            pen.arrow("a1", corner, (corner.0, corner.1 - 44.0));
            pen.symbol((corner.0 + 10.0, corner.1 - 36.0), Anchor::Start, "ρ");
            pen.measure(plane.at((RADIUS, 0.0)), plane.at((RADIUS, -DEPTH)), 16.0, "H");
        }
        pen.remark((left + 40.0, 226.0), Anchor::Middle, "web");
        pen.remark((left + 128.0, 226.0), Anchor::Middle, "pin or journal");
    }
    pen.remark((230.0, 256.0), Anchor::Middle, "(43.9), fading with w(u)");
}

/// Where (43.9) moves a point of the body: on the surface onto the fillet, within it less and less.
fn moved(zeta: f64, rho: f64) -> (f64, f64) {
    let onto = |a: f64| (RADIUS * (1.0 - a.cos()), RADIUS * (1.0 - a.sin()));
    // (outside the cylinder, into the bar), as the equation has them.
    let shift = |outside: f64, into: f64| {
        let a =
            if into > 0.0 { PI / 4.0 * (1.0 - into / RADIUS) } else { PI / 4.0 * (1.0 + outside / RADIUS) };
        let (to_outside, to_into) = onto(a);
        (to_outside - outside, to_into - into)
    };
    let fade = |depth: f64| {
        let u = (depth / DEPTH).clamp(0.0, 1.0);
        (1.0 - u) * (1.0 - u) * (1.0 + 2.0 * u)
    };
    let (outside, into) = (rho.max(0.0), zeta.max(0.0));
    let (d_outside, d_into) = shift(outside, into);
    let weight = fade(outside - rho) * fade(into - zeta);
    (zeta + weight * d_into, rho + weight * d_outside)
}

fn big_end(pen: &mut Pen) {
    let plane = Plane::upright((140.0, 380.0), 1.0);
    let linkage = Linkage { r: 80.0, l: 235.0, e: 22.0, phi: 55f64.to_radians() };
    let (end, piston) = (linkage.crankpin(), linkage.piston_pin());
    pen.line("axis-line", plane.at((-60.0, 0.0)), plane.at((360.0, 0.0)));
    pen.line("axis-line", plane.at((-30.0, linkage.e)), plane.at((360.0, linkage.e)));
    for side in [-46.0, 46.0] {
        pen.line("wall", plane.at((220.0, linkage.e + side)), plane.at((345.0, linkage.e + side)));
    }
    pen.area(
        "metal",
        &[(32.0, -44.0), (32.0, 44.0), (-28.0, 44.0), (-28.0, -44.0)]
            .map(|(a, b)| plane.at((piston.0 + a, linkage.e + b))),
    );
    pen.line("rod", plane.at(end), plane.at(piston));
    for place in [end, piston] {
        pen.circle("pin", plane.at(place), 6.0);
    }
    pen.circle("dot", plane.at((0.0, 0.0)), 4.0);
    let centre = between(end, piston, 0.34);
    pen.circle("dot", plane.at(centre), 5.0);
    let (x, y) = plane.at(centre);
    pen.symbol((x - 12.0, y + 4.0), Anchor::End, "m_R, I");
    let (from, to) = (plane.at(end), plane.at(centre));
    pen.measure(to, from, 22.0, "g");
    pen.measure(plane.at((0.0, -1.0)), plane.at((piston.0, -1.0)), 70.0, "s");
    pen.line("dimension", plane.at((piston.0, -74.0)), plane.at((piston.0, -26.0)));
    pen.measure(plane.at((0.0, end.1)), plane.at(end), -30.0, "x");
    pen.line("dimension", plane.at((0.0, -74.0)), plane.at((0.0, end.1 + 34.0)));
    pen.measure(plane.at((-40.0, 0.0)), plane.at((-40.0, end.1)), 0.0, "y");
    pen.line("dimension", plane.at(end), plane.at((-44.0, end.1)));
    pen.line("thin", plane.at(end), plane.at((end.0 + 150.0, end.1)));
    pen.turn("turn", &plane.arc(end, 140.0, 0.0, -linkage.rod_angle()));
    let (x, y) = plane.at(beyond(end, 156.0, -linkage.rod_angle() / 2.0));
    pen.symbol((x, y + 4.0), Anchor::Middle, "φ");
    let (x, y) = plane.at((340.0, linkage.e));
    pen.symbol((x + 8.0, y), Anchor::Start, "y = e");
    pen.arrow("a1", plane.at((piston.0 + 80.0, linkage.e)), plane.at((piston.0 + 34.0, linkage.e)));
    pen.symbol((148.0, 62.0), Anchor::End, "F");
    // The bearing, enlarged.
    let circle = Plane::level((352.0, 170.0), 1.0);
    let (shell, gap) = (74.0, 20.0);
    let offset = beyond((0.0, 0.0), 12.0, 2.3);
    pen.area("film", &circle.arc((0.0, 0.0), shell, 0.0, 2.0 * PI));
    pen.circle("outline", circle.at((0.0, 0.0)), shell);
    pen.circle("metal", circle.at(offset), shell - gap);
    pen.arrow("a2", circle.at((0.0, 0.0)), circle.at(beyond((0.0, 0.0), 34.0, 2.3)));
    pen.circle("dot", circle.at((0.0, 0.0)), 3.5);
    pen.circle("dot", circle.at(offset), 3.5);
    let (x, y) = circle.at(beyond((0.0, 0.0), 40.0, 2.3));
    pen.symbol((x - 2.0, y - 2.0), Anchor::End, "n");
    pen.symbol((358.0, 164.0), Anchor::Start, "e");
    pen.words((352.0, 212.0), Anchor::Middle, "pin");
    pen.remark((352.0, 264.0), Anchor::Middle, "pin in the big end,");
    pen.remark((352.0, 282.0), Anchor::Middle, "clearance c enlarged");
    pen.line("dimension", plane.at(end), circle.at(beyond((0.0, 0.0), shell, 3.9)));
}
