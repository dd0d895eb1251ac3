//! Forces and what they add up to: planes and couples, a piston and its rod, one order, a weight between two planes.

use super::linkage::{Linkage, draw_linkage, draw_piston};
use super::sheet::Sketch;
use crate::generate::pen::{Anchor, Pen, Plane, between, beyond};
use std::f64::consts::PI;

/// Those of this file.
pub fn sketches() -> Vec<Sketch> {
    vec![
        Sketch {
            name: "planes",
            title: "Forces in their planes",
            says: "Above, from the side: every part p exerts a force F_p in its plane z_p; about the reference point it has the lever z_p − z_ref. Below, from the free \
                   end: the moving parts exert the roll moment M_z on the block and deliver the torque T; a force off the reference point has the levers x − x_ref and y − y_ref.",
            size: (460.0, 480.0),
            draw: planes,
        },
        Sketch {
            name: "piston-forces",
            title: "Forces on piston and rod",
            says: "The gas presses on the piston with f towards the crank, the wall with N across; the rod presses on the piston pin with X and on the crankpin with R. \
                   The force of a light rod lies along the rod.",
            size: (440.0, 566.0),
            draw: piston_forces,
        },
        Sketch {
            name: "ellipse",
            title: "One order is an ellipse",
            says: "The vector f_n turns with the crank, f_−n against it; the tip of their sum runs along an ellipse whose half axes are the sum and the difference of their \
                   amounts, and whose major axis has the mean of their directions.",
            size: (460.0, 420.0),
            draw: ellipse,
        },
        Sketch {
            name: "box",
            title: "A box of choices",
            says: "Left: a weight U in a plane z between z_1 and z_2 acts as U_1 and U_2 at the ends, shared as by a lever. Right: amounts of at least U_least in a sector \
                   of phases lie beyond its chord, which is convex.",
            size: (460.0, 300.0),
            draw: choices,
        },
    ]
}

fn planes(pen: &mut Pen) {
    let side = Plane::level((230.0, 110.0), 1.0);
    pen.line("axis-line", side.at((-205.0, 0.0)), side.at((200.0, 0.0)));
    pen.arrow("a0", side.at((190.0, 0.0)), side.at((212.0, 0.0)));
    pen.symbol((446.0, 128.0), Anchor::Middle, "z");
    // First-order forces of an in-line three along the cylinders at θ = 20°.
    for (index, z) in [-130.0, 0.0, 130.0].into_iter().enumerate() {
        let force = 78.0 * (20f64 - 120.0 * index as f64).to_radians().cos();
        pen.line("thin", side.at((z, -92.0)), side.at((z, 92.0)));
        pen.arrow("a2", side.at((z, 0.0)), side.at((z, force)));
        let (x, y) = side.at((z, force));
        pen.symbol(
            (x + 8.0, y + if force > 0.0 { 10.0 } else { -2.0 }),
            Anchor::Start,
            &format!("F_{}", index + 1),
        );
    }
    let reference = 40.0;
    pen.circle("dot", side.at((reference, 0.0)), 4.0);
    pen.symbol((274.0, 100.0), Anchor::Start, "z_ref");
    pen.line("dimension", side.at((reference, -6.0)), side.at((reference, -92.0)));
    pen.measure(side.at((reference, -70.0)), side.at((130.0, -70.0)), -14.0, "");
    pen.symbol((312.0, 214.0), Anchor::Middle, "z_3 − z_ref");
    let front = Plane::upright((190.0, 370.0), 1.0);
    let block = [(95.0, -70.0), (95.0, 70.0), (20.0, 100.0), (-70.0, 100.0), (-70.0, -100.0), (20.0, -100.0)];
    pen.area("metal", &block.map(|p| front.at(p)));
    let (theta, r) = (35f64.to_radians(), 40.0);
    pen.line("crank", front.at((0.0, 0.0)), front.at(beyond((0.0, 0.0), r, theta)));
    for place in [(0.0, 0.0), beyond((0.0, 0.0), r, theta)] {
        pen.circle("pin", front.at(place), 5.0);
    }
    pen.turn("a1", &front.arc((0.0, 0.0), 56.0, -2.6, -1.0));
    pen.symbol((132.0, 352.0), Anchor::End, "T");
    pen.turn("a2", &front.arc((0.0, 0.0), 130.0, 0.9, 2.0));
    pen.symbol((332.0, 386.0), Anchor::Start, "M_z");
    let shaft = (-40.0, 76.0);
    let (x, y) = front.at(shaft);
    pen.circle("slug", (x, y), 13.0);
    pen.arrow("a2", (x, y), front.at((shaft.0 + 62.0, shaft.1)));
    pen.symbol((x + 6.0, y - 46.0), Anchor::Start, "F_x");
    pen.measure(front.at((-40.0, 0.0)), front.at(shaft), -48.0, "");
    pen.symbol((228.0, 476.0), Anchor::Middle, "y − y_ref");
    pen.line("dimension", front.at((-6.0, 0.0)), front.at((-92.0, 0.0)));
    pen.arrow("a0", (30.0, 300.0), (30.0, 262.0));
    pen.symbol((18.0, 276.0), Anchor::End, "x");
    pen.arrow("a0", (30.0, 300.0), (68.0, 300.0));
    pen.symbol((76.0, 306.0), Anchor::Start, "y");
}

fn piston_forces(pen: &mut Pen) {
    let linkage = Linkage { r: 92.0, l: 290.0, e: 0.0, phi: 52f64.to_radians() };
    let plane = Plane::upright((190.0, 444.0), 1.0);
    let (pin, piston) = (linkage.crankpin(), linkage.piston_pin());
    pen.circle("axis-line", plane.at((0.0, 0.0)), linkage.r);
    pen.line("axis-line", plane.at((-90.0, 0.0)), plane.at((405.0, 0.0)));
    for side in [-58.0, 58.0] {
        pen.line("wall", plane.at((240.0, side)), plane.at((405.0, side)));
    }
    draw_piston(pen, &plane, piston, 0.0, [56.0, 34.0, 32.0]);
    draw_linkage(pen, &plane, &linkage);
    // F = −f, a piston and a rod without mass: N = −q F/W, R = F u + N v.
    let f = 84.0;
    let n = linkage.across() * f / linkage.along();
    for across in [-30.0, 0.0, 30.0] {
        pen.arrow("a1", plane.at((piston.0 + 84.0, across)), plane.at((piston.0 + 36.0, across)));
    }
    pen.symbol((236.0, 44.0), Anchor::Start, "f");
    // X, R and N per f; N is small beside f.
    const FORCE: f64 = 0.55;
    let scale = 2.4 * FORCE;
    pen.arrow("a3", plane.at((piston.0, -58.0 - scale * n)), plane.at((piston.0, -58.0)));
    pen.symbol((84.0, 98.0), Anchor::Middle, "N");
    pen.arrow("a2", plane.at(piston), plane.at((piston.0 + FORCE * f, piston.1 - FORCE * n)));
    pen.symbol((168.0, 116.0), Anchor::End, "X");
    pen.arrow("a2", plane.at(pin), plane.at((pin.0 - FORCE * f, pin.1 + FORCE * n)));
    pen.symbol((284.0, 432.0), Anchor::Start, "R");
    pen.angle(&plane, (0.0, 0.0), 34.0, [0.0, linkage.phi], "φ");
    let beta = linkage.rod_angle();
    pen.line("thin", plane.at(pin), plane.at((pin.0 + 130.0, pin.1)));
    pen.turn("turn", &plane.arc(pin, 120.0, 0.0, -beta));
    let (x, y) = plane.at(beyond(pin, 134.0, -beta / 2.0));
    pen.symbol((x, y + 4.0), Anchor::Middle, "β");
    pen.arrow("a0", (352.0, 108.0), (352.0, 66.0));
    pen.symbol((362.0, 78.0), Anchor::Start, "u");
    pen.arrow("a0", (352.0, 108.0), (394.0, 108.0));
    pen.symbol((398.0, 126.0), Anchor::Middle, "v");
    pen.remark((16.0, 556.0), Anchor::Start, "drawn for a light piston and rod; N enlarged");
}

fn ellipse(pen: &mut Pen) {
    let plane = Plane::upright((230.0, 222.0), 1.0);
    let (forward, backward) = ((118.0, 20f64.to_radians()), (62.0, 100f64.to_radians()));
    let turn = -35f64.to_radians();
    let sum =
        |angle: f64| beyond(beyond((0.0, 0.0), forward.0, forward.1 + angle), backward.0, backward.1 - angle);
    pen.line("grid", plane.at((-200.0, 0.0)), plane.at((200.0, 0.0)));
    pen.line("grid", plane.at((0.0, -215.0)), plane.at((0.0, 215.0)));
    let points: Vec<_> = (0..=180).map(|k| plane.at(sum(f64::from(k) * PI / 90.0))).collect();
    pen.area("s0", &points);
    let major = (forward.1 + backward.1) / 2.0;
    let ends = [0.0, PI].map(|half| plane.at(beyond((0.0, 0.0), forward.0 + backward.0, major + half)));
    pen.line("axis-line", ends[0], ends[1]);
    let ends =
        [-0.5, 0.5].map(|half| plane.at(beyond((0.0, 0.0), forward.0 - backward.0, major + half * PI)));
    pen.line("axis-line", ends[0], ends[1]);
    let tip = beyond((0.0, 0.0), forward.0, forward.1 + turn);
    pen.circle("grid", plane.at((0.0, 0.0)), forward.0);
    pen.circle("grid", plane.at(tip), backward.0);
    pen.arrow("a1", plane.at((0.0, 0.0)), plane.at(tip));
    pen.arrow("a2", plane.at(tip), plane.at(sum(turn)));
    pen.arrow("a0", plane.at((0.0, 0.0)), plane.at(sum(turn)));
    pen.turn(
        "a1",
        &plane.arc((0.0, 0.0), forward.0 + 10.0, forward.1 + turn - 0.62, forward.1 + turn - 0.12),
    );
    pen.turn("a2", &plane.arc(tip, backward.0 + 9.0, backward.1 - turn + 0.95, backward.1 - turn + 0.2));
    let (x, y) = plane.at(between((0.0, 0.0), tip, 0.52));
    pen.symbol((x - 8.0, y - 2.0), Anchor::End, "f_n");
    let (x, y) = plane.at(between(tip, sum(turn), 0.55));
    pen.symbol((x - 2.0, y - 10.0), Anchor::Middle, "f_−n");
    pen.angle(&plane, (0.0, 0.0), 150.0, [0.0, major], "");
    let (x, y) = plane.at(beyond((0.0, 0.0), 196.0, 0.42 * major));
    pen.symbol((x, y), Anchor::Middle, "½ (arg f_n + arg f_−n)");
    let (x, y) = plane.at(beyond((0.0, 0.0), forward.0 + backward.0, major + PI));
    pen.symbol((x - 6.0, y + 34.0), Anchor::Start, "|f_n| + |f_−n|");
    let (x, y) = plane.at(beyond((0.0, 0.0), forward.0 - backward.0, major + 0.5 * PI));
    pen.symbol((x + 10.0, y + 16.0), Anchor::Start, "| |f_n| − |f_−n| |");
    pen.symbol((218.0, 20.0), Anchor::End, "F_x");
    pen.symbol((438.0, 214.0), Anchor::End, "F_y");
}

fn choices(pen: &mut Pen) {
    let plane = Plane::level((40.0, 200.0), 1.0);
    let (first, last, z, amount) = (0.0, 150.0, 52.0, 130.0);
    pen.line("axis-line", plane.at((-26.0, 0.0)), plane.at((176.0, 0.0)));
    let share = (last - z) / (last - first);
    for (place, size, class) in
        [(first, share * amount, "a1"), (last, (1.0 - share) * amount, "a1"), (z, amount, "a2")]
    {
        pen.arrow(class, plane.at((place, 0.0)), plane.at((place, size)));
        pen.line("dimension", plane.at((place, -8.0)), plane.at((place, -30.0)));
    }
    pen.symbol((46.0, 126.0), Anchor::Start, "U_1");
    pen.symbol((196.0, 158.0), Anchor::Start, "U_2");
    pen.symbol((100.0, 82.0), Anchor::Start, "U");
    for (place, name) in [(first, "z_1"), (z, "z"), (last, "z_2")] {
        pen.symbol((plane.at((place, 0.0)).0, 248.0), Anchor::Middle, name);
    }
    pen.measure(plane.at((first, -70.0)), plane.at((last, -70.0)), 0.0, "w");
    let ring = Plane::level((262.0, 232.0), 1.0);
    let (alpha, beta, least) = (18f64.to_radians(), 60f64.to_radians(), 118.0);
    let chord = [alpha, alpha + beta].map(|angle| beyond((0.0, 0.0), least, angle));
    let beyond_chord: Vec<_> = [ring.at(chord[0])]
        .into_iter()
        .chain(ring.arc((0.0, 0.0), 188.0, alpha, alpha + beta))
        .chain([ring.at(chord[1])])
        .collect();
    pen.area("film", &beyond_chord);
    pen.chain("s0", &ring.arc((0.0, 0.0), least, alpha, alpha + beta));
    pen.line("limit", ring.at(chord[0]), ring.at(chord[1]));
    for angle in [alpha, alpha + beta] {
        pen.line("thin", ring.at((0.0, 0.0)), ring.at(beyond((0.0, 0.0), 188.0, angle)));
    }
    pen.arrow("a0", ring.at((0.0, 0.0)), ring.at((180.0, 0.0)));
    pen.symbol((446.0, 252.0), Anchor::End, "Re U");
    pen.angle(&ring, (0.0, 0.0), 84.0, [0.0, alpha], "α");
    pen.angle(&ring, (0.0, 0.0), 52.0, [alpha, alpha + beta], "β");
    let (x, y) = ring.at(beyond((0.0, 0.0), least + 6.0, alpha + 0.5 * beta));
    pen.symbol((x + 4.0, y), Anchor::Start, "U_least");
    pen.remark((40.0, 24.0), Anchor::Start, "a stretch of planes");
    pen.remark((262.0, 24.0), Anchor::Start, "a sector of phases");
}
