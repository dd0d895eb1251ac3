//! The workshop: vibration of a rotor, drilled holes, bearings and planes of a grade.

use super::sheet::Sketch;
use crate::generate::pen::{Anchor, Pen, Plane, beyond};

/// Those of this file.
pub fn sketches() -> Vec<Sketch> {
    vec![
        Sketch {
            name: "rotor",
            title: "A rotor with sensors and a keyphasor",
            says: "Left, along the axis at the instant of the pulse: the keyphasor stands at κ and the sensor at β on the housing; an unbalance U at the angle α on the rotor \
                   then stands at κ + α. Right, from the side: two correction planes p and two sensors s; A_sp is the velocity at s for unit weight in p.",
            size: (460.0, 300.0),
            draw: rotor,
        },
        Sketch {
            name: "holes",
            title: "Drilled holes",
            says: "Left: a radial hole of radius a, depth h and a point of height c in a surface of radius R. Right: two axial holes on a circle of radius R, γ apart, with the \
                   wall between them.",
            size: (460.0, 300.0),
            draw: holes,
        },
        Sketch {
            name: "shares",
            title: "Bearings and correction planes",
            says: "Above: a rotor between the bearings A and B with its centre of mass and two correction planes, one of them overhung. Below: the part of an unbalance at z that \
                   each bearing feels.",
            size: (460.0, 360.0),
            draw: shares,
        },
    ]
}

fn rotor(pen: &mut Pen) {
    let plane = Plane::level((120.0, 150.0), 1.0);
    let (key, sensor, alpha) = (150f64.to_radians(), 62f64.to_radians(), 80f64.to_radians());
    pen.circle("metal", plane.at((0.0, 0.0)), 66.0);
    pen.line("thin", plane.at((0.0, 0.0)), plane.at((98.0, 0.0)));
    for (angle, name) in [(key, "keyphasor"), (sensor, "sensor")] {
        pen.line(
            "crank",
            plane.at(beyond((0.0, 0.0), 72.0, angle)),
            plane.at(beyond((0.0, 0.0), 90.0, angle)),
        );
        pen.line("thin", plane.at((0.0, 0.0)), plane.at(beyond((0.0, 0.0), 66.0, angle)));
        let (x, y) = plane.at(beyond((0.0, 0.0), 98.0, angle));
        pen.remark((x + 12.0, y - 6.0), Anchor::Middle, name);
    }
    let weight = beyond((0.0, 0.0), 52.0, key + alpha);
    pen.line("thin", plane.at((0.0, 0.0)), plane.at(weight));
    pen.circle("slug", plane.at(weight), 8.0);
    pen.circle("pin", plane.at((0.0, 0.0)), 6.0);
    let (x, y) = plane.at(weight);
    pen.symbol((x + 13.0, y + 8.0), Anchor::Start, "U");
    pen.angle(&plane, (0.0, 0.0), 26.0, [0.0, key], "κ");
    pen.angle(&plane, (0.0, 0.0), 46.0, [0.0, sensor], "β");
    pen.angle(&plane, (0.0, 0.0), 34.0, [key, key + alpha], "α");
    pen.turn("a1", &plane.arc((0.0, 0.0), 84.0, -2.2, -1.2));
    pen.symbol((120.0, 256.0), Anchor::Middle, "ω");
    side(pen);
}

/// The rotor from the side, with planes and sensors.
fn side(pen: &mut Pen) {
    let plane = Plane::level((344.0, 150.0), 1.0);
    pen.area("metal", &[(-66.0, 42.0), (66.0, 42.0), (66.0, -42.0), (-66.0, -42.0)].map(|p| plane.at(p)));
    pen.line("shaft-line", plane.at((-106.0, 0.0)), plane.at((-66.0, 0.0)));
    pen.line("shaft-line", plane.at((66.0, 0.0)), plane.at((106.0, 0.0)));
    for (index, z) in [-90.0, 90.0].into_iter().enumerate() {
        let (x, y) = plane.at((z, 0.0));
        pen.area("outline", &[(x, y + 3.0), (x - 12.0, y + 24.0), (x + 12.0, y + 24.0)]);
        pen.ground((x + 16.0, y + 24.0), (x - 16.0, y + 24.0));
        pen.arrow("a1", (x, y - 8.0), (x, y - 46.0));
        pen.symbol((x, y - 56.0), Anchor::Middle, &format!("v_{}", index + 1));
    }
    for (index, z) in [-44.0, 44.0].into_iter().enumerate() {
        pen.line("limit", plane.at((z, 58.0)), plane.at((z, -58.0)));
        let (x, y) = plane.at((z, -74.0));
        pen.words((x, y), Anchor::Middle, &format!("plane {}", index + 1));
        pen.circle("slug", plane.at((z, 36.0)), 6.0);
        pen.symbol((x + 10.0, 98.0 + 0.0 * y), Anchor::Start, &format!("x_{}", index + 1));
    }
    pen.symbol((344.0, 262.0), Anchor::Middle, "v_s + Σ A_sp (u_p + x_p)");
}

fn holes(pen: &mut Pen) {
    let plane = Plane::upright((112.0, 258.0), 1.0);
    let (radius, a, h) = (170.0, 22.0, 74.0);
    let c = a / 59f64.to_radians().tan();
    pen.area("metal", &[vec![plane.at((0.0, 0.0))], plane.arc((0.0, 0.0), radius, -0.5, 0.5)].concat());
    let edge = (radius * radius - a * a).sqrt();
    let hole = [(edge, -a), (radius - h, -a), (radius - h - c, 0.0), (radius - h, a), (edge, a)];
    pen.area("pin", &hole.map(|p| plane.at(p)));
    pen.line("axis-line", plane.at((-14.0, 0.0)), plane.at((200.0, 0.0)));
    pen.circle("dot", plane.at((0.0, 0.0)), 3.5);
    pen.measure(plane.at((radius - h, a)), plane.at((radius, a)), -28.0, "h");
    pen.measure(plane.at((radius - h - c, a)), plane.at((radius - h, a)), -28.0, "");
    pen.symbol((170.0, 172.0), Anchor::Start, "c");
    pen.measure(plane.at((radius - 30.0, -a)), plane.at((radius - 30.0, 0.0)), 0.0, "a");
    let mouth = plane.at((radius, 0.0));
    pen.measure(plane.at((0.0, -96.0)), (mouth.0 - 96.0, mouth.1), 0.0, "R");
    pen.line("dimension", plane.at((0.0, -4.0)), plane.at((0.0, -100.0)));
    pen.line("dimension", plane.at((radius, -4.0)), plane.at((radius, -100.0)));
    let ring = Plane::upright((340.0, 258.0), 1.0);
    let (radius, gamma, sizes) = (150.0, 44f64.to_radians(), [26.0, 20.0]);
    pen.area(
        "metal",
        &[ring.arc((0.0, 0.0), 186.0, -0.6, 0.6), ring.arc((0.0, 0.0), 60.0, 0.6, -0.6)].concat(),
    );
    pen.chain("axis-line", &ring.arc((0.0, 0.0), radius, -0.62, 0.62));
    pen.circle("dot", ring.at((0.0, 0.0)), 3.5);
    let centres = [-0.5, 0.5].map(|half| beyond((0.0, 0.0), radius, half * gamma));
    for (centre, size) in centres.into_iter().zip(sizes) {
        pen.circle("pin", ring.at(centre), size);
        pen.line("axis-line", ring.at((0.0, 0.0)), ring.at(centre));
    }
    let (first, last) = (ring.at(centres[0]), ring.at(centres[1]));
    let flank = [(first.0 + sizes[0], first.1), (last.0 - sizes[1], last.1)];
    pen.measure(flank[0], flank[1], 0.0, "");
    pen.symbol((342.0, first.1 - 14.0), Anchor::Middle, "wall");
    pen.angle(&ring, (0.0, 0.0), 66.0, [-0.5 * gamma, 0.5 * gamma], "γ");
    pen.arrow("measure", first, (first.0 - 18.0, first.1 - 18.0));
    pen.symbol((first.0 - 4.0, first.1 + 17.0), Anchor::Middle, "a_1");
    pen.symbol((last.0, last.1 + 6.0), Anchor::Middle, "a_2");
    pen.symbol((400.0, 196.0), Anchor::Start, "R");
    pen.remark((112.0, 290.0), Anchor::Middle, "radial");
    pen.remark((340.0, 290.0), Anchor::Middle, "axial");
}

fn shares(pen: &mut Pen) {
    let (a, b, c, planes) = (-110.0, 110.0, 30.0, [-50.0, 170.0]);
    let plane = Plane::level((200.0, 86.0), 1.0);
    pen.area("metal", &[(-84.0, 34.0), (84.0, 34.0), (84.0, -34.0), (-84.0, -34.0)].map(|p| plane.at(p)));
    pen.area("metal", &[(158.0, 44.0), (182.0, 44.0), (182.0, -44.0), (158.0, -44.0)].map(|p| plane.at(p)));
    pen.line("shaft-line", plane.at((-130.0, 0.0)), plane.at((-84.0, 0.0)));
    pen.line("shaft-line", plane.at((84.0, 0.0)), plane.at((158.0, 0.0)));
    for (z, name) in [(a, "A"), (b, "B")] {
        let (x, y) = plane.at((z, 0.0));
        pen.area("outline", &[(x, y + 3.0), (x - 11.0, y + 22.0), (x + 11.0, y + 22.0)]);
        pen.words((x, y - 12.0), Anchor::Middle, name);
    }
    pen.circle("dot", plane.at((c, 0.0)), 5.0);
    for (index, z) in planes.into_iter().enumerate() {
        pen.line("limit", plane.at((z, 52.0)), plane.at((z, -52.0)));
        let (x, y) = plane.at((z, 62.0));
        pen.symbol((x, y), Anchor::Middle, &format!("U_{}", index + 1));
    }
    // λ_A and λ_B over z, one unit 90 px.
    let chart = Plane::level((200.0, 300.0), 1.0);
    let unit = 90.0;
    pen.line("zero", chart.at((-150.0, 0.0)), chart.at((200.0, 0.0)));
    pen.line("grid", chart.at((-150.0, unit)), chart.at((200.0, unit)));
    pen.remark((44.0, 305.0), Anchor::End, "0");
    pen.remark((44.0, 215.0), Anchor::End, "1");
    for (z, name) in [(a, "z_A"), (b, "z_B"), (c, "z_c"), (planes[0], "z_1"), (planes[1], "z_2")] {
        pen.line("grid", plane.at((z, -46.0)), chart.at((z, 0.0)));
        pen.symbol((chart.at((z, 0.0)).0, 324.0), Anchor::Middle, name);
    }
    let part = |from: f64, span: f64, z: f64| (from - z).abs() / span * unit;
    let ends = [-150.0, a, b, 190.0];
    pen.chain("s1", &ends.map(|z| chart.at((z, part(b, b - a, z)))));
    pen.chain("s2", &ends.map(|z| chart.at((z, part(a, b - a, z)))));
    pen.symbol((96.0, 236.0), Anchor::Start, "λ_A");
    pen.symbol((284.0, 236.0), Anchor::End, "λ_B");
}
