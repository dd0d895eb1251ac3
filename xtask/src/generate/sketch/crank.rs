//! The crank, its rod and what turns with it: conventions, motion, rods, gears, similar engines.

use super::linkage::{Linkage, draw_linkage, draw_piston};
use super::sheet::Sketch;
use crate::generate::pen::{Anchor, Pen, Plane, between, beyond};

/// Those of this file.
pub fn sketches() -> Vec<Sketch> {
    vec![
        Sketch {
            name: "frame",
            title: "Frame and angles",
            says: "Seen from the free end of a V engine, x points up along the bisector of the banks and y to the right; the crank turns from x to y. \
                   θ is the angle of throw 1 from x, a of another throw from throw 1, b of a cylinder from x; φ = θ + a − b. Below, seen \
                   from the side, z runs from the free end to the flywheel; a force F in the plane z gives a couple about the origin.",
            size: (460.0, 560.0),
            draw: frame,
        },
        Sketch {
            name: "slider-crank",
            title: "Slider-crank with an offset",
            says: "A crank of radius r at the angle φ from the cylinder axis, a rod of length l at the angle β, and a piston pin at the place s along the \
                   cylinder and e across it. The rod spans q across the cylinder and W along it.",
            size: (440.0, 560.0),
            draw: slider_crank,
        },
        Sketch {
            name: "articulated",
            title: "Master rod and articulated rod",
            says: "The master rod of length l joins crankpin A and piston pin B. The knuckle pin K stands at the distance k from the crankpin, at the angle κ from \
                   the master rod. The articulated rod of length l_s joins it to the piston pin of the other cylinder.",
            size: (490.0, 480.0),
            draw: articulated,
        },
        Sketch {
            name: "rod",
            title: "A rod as two masses",
            says: "A connecting rod of mass m and inertia I with its centre of gravity at the distance a from the big end and b from the small end; below, the two \
                   masses m_A and m_B at its eyes, with the same mass and centre of gravity.",
            size: (460.0, 330.0),
            draw: rod,
        },
        Sketch {
            name: "geared",
            title: "Crankshaft and a geared shaft",
            says: "Crankshaft 1 stands at θ; a balance shaft of the ratio ρ = −1 beside it turns the other way and its unbalance stands at ρ θ + phase. Its force has \
                   a lever about the crank's axis.",
            size: (460.0, 330.0),
            draw: geared,
        },
        Sketch {
            name: "similar",
            title: "Geometrically similar engines",
            says: "Two slider-cranks of one shape at the same angle: every length of the second is k times that of the first, every mass k cubed.",
            size: (460.0, 360.0),
            draw: similar,
        },
    ]
}

fn frame(pen: &mut Pen) {
    let plane = Plane::upright((215.0, 250.0), 1.0);
    let (theta, a, half_bank, r) = (62f64.to_radians(), 120f64.to_radians(), 30f64.to_radians(), 62.0);
    let origin = plane.at((0.0, 0.0));
    pen.circle("axis-line", origin, r);
    pen.arrow("a0", origin, plane.at((235.0, 0.0)));
    pen.symbol((origin.0 - 12.0, 26.0), Anchor::End, "x");
    pen.arrow("a0", origin, plane.at((0.0, 205.0)));
    pen.symbol((origin.0 + 214.0, origin.1 + 6.0), Anchor::Start, "y");
    for b in [-half_bank, half_bank] {
        pen.line("axis-line", origin, plane.at(beyond((0.0, 0.0), 225.0, b)));
        let ends = [128.0, 205.0].map(|d| beyond((0.0, 0.0), d, b));
        for side in [-1.0, 1.0] {
            let wall = ends.map(|end| plane.at(beyond(end, 27.0 * side, b + 0.5 * std::f64::consts::PI)));
            pen.line("wall", wall[0], wall[1]);
        }
    }
    for angle in [theta, theta + a] {
        pen.line("crank", origin, plane.at(beyond((0.0, 0.0), r, angle)));
        pen.circle("pin", plane.at(beyond((0.0, 0.0), r, angle)), 6.0);
    }
    pen.words((origin.0 + 66.0, origin.1 - 34.0), Anchor::Start, "throw 1");
    pen.words((origin.0 - 14.0, origin.1 + r + 6.0), Anchor::End, "throw 2");
    pen.circle("pin", origin, 5.0);
    pen.remark((origin.0 - 14.0, origin.1 + 6.0), Anchor::End, "z: away from you");
    pen.angle(&plane, (0.0, 0.0), 36.0, [0.0, theta], "θ");
    pen.angle(&plane, (0.0, 0.0), 88.0, [theta, theta + a], "a");
    pen.angle(&plane, (0.0, 0.0), 168.0, [0.0, half_bank], "b");
    pen.angle(&plane, (0.0, 0.0), 122.0, [half_bank, theta + a], "φ");
    let tip = beyond((0.0, 0.0), 205.0, half_bank);
    for (angle, name) in [(half_bank, "u"), (half_bank + 0.5 * std::f64::consts::PI, "v")] {
        pen.arrow("a1", plane.at(tip), plane.at(beyond(tip, 46.0, angle)));
        let (x, y) = plane.at(beyond(tip, 58.0, angle));
        pen.symbol((x, y + 5.0), Anchor::Middle, name);
    }
    pen.remark((12.0, 24.0), Anchor::Start, "from the free end,");
    pen.remark((12.0, 42.0), Anchor::Start, "towards the flywheel");
    side_view(pen);
}

/// The crank from the side, with a force in a plane.
fn side_view(pen: &mut Pen) {
    let plane = Plane::level((215.0, 460.0), 1.0);
    let throws = [(-105.0, 1.0), (-35.0, -1.0), (35.0, -1.0), (105.0, 1.0)];
    let mut line = vec![plane.at((-150.0, 0.0))];
    for (z, side) in throws {
        line.extend(
            [(-20.0, 0.0), (-20.0, 30.0), (20.0, 30.0), (20.0, 0.0)]
                .map(|(dz, x)| plane.at((z + dz, side * x))),
        );
    }
    line.push(plane.at((158.0, 0.0)));
    pen.line("axis-line", plane.at((-190.0, 0.0)), plane.at((160.0, 0.0)));
    pen.chain("shaft-line", &line);
    pen.area("metal", &[(158.0, 45.0), (170.0, 45.0), (170.0, -45.0), (158.0, -45.0)].map(|p| plane.at(p)));
    pen.arrow("a0", plane.at((170.0, 0.0)), plane.at((214.0, 0.0)));
    pen.symbol((434.0, 480.0), Anchor::Middle, "z");
    pen.arrow("a0", plane.at((0.0, 0.0)), plane.at((0.0, 80.0)));
    pen.symbol((203.0, 388.0), Anchor::End, "x");
    pen.arrow("a2", plane.at((105.0, 30.0)), plane.at((105.0, 86.0)));
    pen.symbol((330.0, 388.0), Anchor::Start, "F");
    pen.measure(plane.at((0.0, -46.0)), plane.at((105.0, -46.0)), -12.0, "z");
    pen.remark((10.0, 520.0), Anchor::Start, "free end");
    pen.remark((370.0, 526.0), Anchor::Middle, "flywheel");
    pen.remark((215.0, 548.0), Anchor::Middle, "origin: midway between the end throws");
}

fn slider_crank(pen: &mut Pen) {
    let linkage = Linkage { r: 92.0, l: 300.0, e: 26.0, phi: 58f64.to_radians() };
    let plane = Plane::upright((190.0, 450.0), 1.0);
    let (pin, piston) = (linkage.crankpin(), linkage.piston_pin());
    pen.circle("axis-line", plane.at((0.0, 0.0)), linkage.r);
    pen.line("axis-line", plane.at((-105.0, 0.0)), plane.at((430.0, 0.0)));
    pen.line("axis-line", plane.at((-70.0, linkage.e)), plane.at((430.0, linkage.e)));
    for side in [-50.0, 50.0] {
        pen.line("wall", plane.at((270.0, linkage.e + side)), plane.at((425.0, linkage.e + side)));
    }
    draw_piston(pen, &plane, piston, linkage.e, [48.0, 34.0, 30.0]);
    // What the rod spans.
    let corner = (piston.0, pin.1);
    pen.line("dimension", plane.at(pin), plane.at(corner));
    pen.measure(plane.at(corner), plane.at(pin), 44.0, "W");
    pen.measure(plane.at((pin.0 + 56.0, linkage.e)), plane.at((pin.0 + 56.0, pin.1)), 0.0, "q");
    draw_linkage(pen, &plane, &linkage);
    pen.measure(plane.at((0.0, -1.0)), plane.at((piston.0, -1.0)), 92.0, "s");
    pen.line("dimension", plane.at((0.0, -96.0)), plane.at((0.0, -6.0)));
    pen.line("dimension", plane.at((piston.0, -96.0)), plane.at((piston.0, -30.0)));
    pen.measure(plane.at((-82.0, 0.0)), plane.at((-82.0, linkage.e)), 0.0, "");
    pen.symbol((203.0, 552.0), Anchor::Middle, "e");
    pen.angle(&plane, (0.0, 0.0), 40.0, [0.0, linkage.phi], "φ");
    let beta = linkage.rod_angle();
    pen.turn("turn", &plane.arc(pin, 150.0, 0.0, -beta));
    pen.line("thin", plane.at(pin), plane.at((pin.0 + 160.0, pin.1)));
    let (x, y) = plane.at(beyond(pin, 166.0, -beta / 2.0));
    pen.symbol((x, y + 2.0), Anchor::Middle, "β");
    let (x, y) = plane.at(between((0.0, 0.0), pin, 0.6));
    pen.symbol((x + 2.0, y + 22.0), Anchor::Start, "r");
    let (x, y) = plane.at(between(pin, piston, 0.68));
    pen.symbol((x - 9.0, y), Anchor::End, "l");
    let corner = plane.at((0.0, 0.0));
    pen.arrow("a1", corner, (corner.0, corner.1 - 38.0));
    pen.symbol((corner.0 - 8.0, corner.1 - 26.0), Anchor::End, "u");
    pen.arrow("a1", corner, (corner.0 + 38.0, corner.1));
    pen.symbol((corner.0 + 42.0, corner.1 + 18.0), Anchor::Middle, "v");
}

fn articulated(pen: &mut Pen) {
    let plane = Plane::upright((120.0, 380.0), 1.0);
    let tilt = 60f64.to_radians();
    let master = Linkage { r: 70.0, l: 255.0, e: 0.0, phi: 40f64.to_radians() };
    let (pin, piston) = (master.crankpin(), master.piston_pin());
    let (k, kappa, slave) = (66.0, 58f64.to_radians(), 196.0);
    let knuckle = beyond(pin, k, kappa - master.rod_angle());
    // The slave's piston pin on its axis through the origin: w_K e^{−ib} = P + i Q.
    let (along, across) =
        (knuckle.0 * tilt.cos() + knuckle.1 * tilt.sin(), knuckle.1 * tilt.cos() - knuckle.0 * tilt.sin());
    let place = along + (slave * slave - across * across).sqrt();
    let other = beyond((0.0, 0.0), place, tilt);
    pen.circle("axis-line", plane.at((0.0, 0.0)), master.r);
    pen.line("axis-line", plane.at((-90.0, 0.0)), plane.at((365.0, 0.0)));
    pen.line("axis-line", plane.at((0.0, 0.0)), plane.at(beyond((0.0, 0.0), 330.0, tilt)));
    draw_piston(pen, &plane, piston, 0.0, [42.0, 30.0, 26.0]);
    let corner =
        |a: f64, b: f64| plane.at(beyond(beyond(other, a, tilt), b, tilt + 0.5 * std::f64::consts::PI));
    pen.area("metal", &[corner(30.0, -42.0), corner(30.0, 42.0), corner(-26.0, 42.0), corner(-26.0, -42.0)]);
    pen.area("metal", &[pin, beyond(pin, 40.0, -master.rod_angle()), knuckle].map(|p| plane.at(p)));
    pen.line("rod", plane.at(knuckle), plane.at(other));
    draw_linkage(pen, &plane, &master);
    for place in [knuckle, other] {
        pen.circle("pin", plane.at(place), 5.0);
    }
    pen.measure(plane.at(pin), plane.at(knuckle), -26.0, "k");
    pen.angle(&plane, pin, 84.0, [-master.rod_angle(), kappa - master.rod_angle()], "κ");
    let label = |pen: &mut Pen, (a, b): (f64, f64), (dx, dy): (f64, f64), text: &str| {
        let (x, y) = plane.at((a, b));
        pen.symbol((x + dx, y + dy), if dx < 0.0 { Anchor::End } else { Anchor::Start }, text);
    };
    label(pen, pin, (-8.0, -4.0), "A");
    label(pen, piston, (10.0, -6.0), "B");
    label(pen, knuckle, (2.0, -10.0), "K");
    label(pen, between(pin, piston, 0.62), (-8.0, 4.0), "l");
    label(pen, between(knuckle, other, 0.5), (4.0, 18.0), "l_s");
    label(pen, between((0.0, 0.0), pin, 0.5), (4.0, 16.0), "r");
    pen.arrow("a1", plane.at(beyond(other, 32.0, tilt)), plane.at(beyond(other, 68.0, tilt)));
    label(pen, beyond(other, 68.0, tilt), (2.0, -8.0), "b");
    pen.arrow("a1", plane.at((325.0, 0.0)), plane.at((365.0, 0.0)));
    label(pen, (352.0, 0.0), (-8.0, 0.0), "b_m");
}

/// Lengths of the rod that is drawn: between the eyes, to the centre of gravity, radii of the eyes.
const ROD: [f64; 4] = [300.0, 96.0, 44.0, 24.0];

fn rod(pen: &mut Pen) {
    let [l, a, big, small] = ROD;
    let plane = Plane::level((90.0, 90.0), 1.0);
    let (at_big, at_small) = ((0.0, 0.0), (l, 0.0));
    // The shank, tangential enough to both eyes.
    pen.area(
        "metal",
        &[(big - 4.0, 18.0), (l - small + 4.0, 11.0), (l - small + 4.0, -11.0), (big - 4.0, -18.0)]
            .map(|p| plane.at(p)),
    );
    for (eye, radius) in [(at_big, big), (at_small, small)] {
        pen.circle("metal", plane.at(eye), radius);
        pen.circle("pin", plane.at(eye), 0.62 * radius);
    }
    pen.line("axis-line", plane.at((-60.0, 0.0)), plane.at((l + 44.0, 0.0)));
    let centre = plane.at((a, 0.0));
    pen.circle("dot", centre, 5.0);
    pen.symbol((centre.0, centre.1 - 26.0), Anchor::Middle, "m, I");
    pen.measure(plane.at((0.0, -48.0)), plane.at((a, -48.0)), -14.0, "a");
    pen.measure(plane.at((a, -48.0)), plane.at((l, -48.0)), -14.0, "b");
    for z in [0.0, a, l] {
        pen.line("dimension", plane.at((z, -48.0)), plane.at((z, -8.0)));
    }
    let low = Plane::level((90.0, 236.0), 1.0);
    pen.line("rod", low.at(at_big), low.at(at_small));
    // Areas as the masses: m_A = m b/l, m_B = m a/l.
    for (place, share, name) in [(at_big, (l - a) / l, "m_A = m b/l"), (at_small, a / l, "m_B = m a/l")] {
        let radius = 30.0 * share.sqrt();
        pen.circle("slug", low.at(place), radius);
        let (x, y) = low.at(place);
        pen.symbol((x, y + 50.0), Anchor::Middle, name);
    }
    let centre = low.at((a, 0.0));
    pen.circle("dot", centre, 4.0);
    pen.remark((centre.0 + 4.0, centre.1 + 26.0), Anchor::Start, "same centre of gravity");
    pen.measure(low.at((0.0, -62.0)), low.at((l, -62.0)), -12.0, "l");
}

fn geared(pen: &mut Pen) {
    let (theta, phase, r, radius) = (50f64.to_radians(), 20f64.to_radians(), 62.0, 82.0);
    let (crank, shaft) = (Plane::upright((130.0, 165.0), 1.0), Plane::upright((294.0, 165.0), 1.0));
    for plane in [&crank, &shaft] {
        pen.circle("gear", plane.at((0.0, 0.0)), radius);
        pen.line("axis-line", plane.at((-100.0, 0.0)), plane.at((118.0, 0.0)));
    }
    let throw = beyond((0.0, 0.0), r, theta);
    pen.line("crank", crank.at((0.0, 0.0)), crank.at(throw));
    for place in [(0.0, 0.0), throw] {
        pen.circle("pin", crank.at(place), 6.0);
    }
    // ρ = −1.
    let angle = -theta + phase;
    let sector: Vec<_> = shaft.arc((0.0, 0.0), 52.0, angle - 1.0, angle + 1.0);
    pen.area("slug", &[vec![shaft.at((0.0, 0.0))], sector].concat());
    pen.circle("pin", shaft.at((0.0, 0.0)), 6.0);
    pen.arrow("a2", shaft.at(beyond((0.0, 0.0), 52.0, angle)), shaft.at(beyond((0.0, 0.0), 118.0, angle)));
    pen.angle(&crank, (0.0, 0.0), 30.0, [0.0, theta], "θ");
    pen.turn("turn", &shaft.arc((0.0, 0.0), 66.0, 0.0, angle));
    let (x, y) = shaft.at(beyond((0.0, 0.0), 104.0, angle / 2.0 + 0.03));
    pen.symbol((x + 2.0, y - 2.0), Anchor::Middle, "θ_k");
    let (x, y) = shaft.at(beyond((0.0, 0.0), 118.0, angle));
    pen.symbol((x + 4.0, y - 4.0), Anchor::End, "(ρω)² U");
    let ring = |plane: &Plane, from: f64, to: f64| plane.arc((0.0, 0.0), radius + 12.0, from, to);
    pen.turn("a1", &ring(&crank, 3.6, 4.5));
    pen.turn("a1", &ring(&shaft, -3.6, -4.5));
    pen.words((64.0, 300.0), Anchor::Middle, "crankshaft 1");
    pen.words((370.0, 282.0), Anchor::Middle, "shaft k, here ρ = −1:");
    pen.symbol((370.0, 306.0), Anchor::Middle, "θ_k = ρ θ + phase");
    pen.arrow("a0", (26.0, 60.0), (26.0, 22.0));
    pen.symbol((14.0, 38.0), Anchor::End, "x");
    pen.arrow("a0", (26.0, 60.0), (64.0, 60.0));
    pen.symbol((72.0, 66.0), Anchor::Start, "y");
}

fn similar(pen: &mut Pen) {
    let k = 1.5;
    let small = Linkage { r: 34.0, l: 118.0, e: 0.0, phi: 50f64.to_radians() };
    for (scale, right, names) in [(1.0, 110.0, ["r", "l", "m"]), (k, 312.0, ["k r", "k l", "k³ m"])] {
        let plane = Plane::upright((right, 280.0), scale);
        let (pin, piston) = (small.crankpin(), small.piston_pin());
        pen.circle("axis-line", plane.at((0.0, 0.0)), scale * small.r);
        pen.line("axis-line", plane.at((-42.0, 0.0)), plane.at((178.0, 0.0)));
        for side in [-26.0, 26.0] {
            pen.line("wall", plane.at((78.0, side)), plane.at((176.0, side)));
        }
        draw_piston(pen, &plane, piston, 0.0, [24.0, 18.0, 16.0]);
        draw_linkage(pen, &plane, &small);
        let (x, y) = plane.at(between((0.0, 0.0), pin, 0.5));
        pen.symbol((x + 8.0, y + 16.0), Anchor::Start, names[0]);
        let (x, y) = plane.at(between(pin, piston, 0.4));
        pen.symbol((x + 10.0, y + 2.0), Anchor::Start, names[1]);
        let (x, y) = plane.at((piston.0, 26.0));
        pen.symbol((x + 8.0, y + 6.0), Anchor::Start, names[2]);
    }
    pen.remark((110.0, 346.0), Anchor::Middle, "the reference");
    pen.remark((312.0, 346.0), Anchor::Middle, "the similar engine, here k = 1.5");
}
