//! Bodies that move: the block on its mounts, the crank train in it, bonds between elements.

use super::linkage::Linkage;
use super::sheet::Sketch;
use crate::generate::pen::{Anchor, Pen, Plane, Point, between, beyond};

/// Those of this file.
pub fn sketches() -> Vec<Sketch> {
    vec![
        Sketch {
            name: "block-on-mounts",
            title: "The block on its mounts",
            says: "The block as a rigid body with its centre of mass. It moves by u and turns by φ; mount j at ρ_j from the centre holds it with stiffness k and damping c along each of \
                   its directions a.",
            size: (460.0, 300.0),
            draw: block_on_mounts,
        },
        Sketch {
            name: "block-in-motion",
            title: "The crank train in a moving block",
            says: "The block moves with the velocity v and turns with Ω; crankshaft 1 turns with w in it. Crankpin P and piston pin W close a loop: the rod d from P to W has the length l, and \
                   W = s u + e v in the plane of the cylinder.",
            size: (460.0, 550.0),
            draw: block_in_motion,
        },
        Sketch {
            name: "bonds",
            title: "Bonds, junctions and causality",
            says: "A bond graph of a slider-crank: the gas is a source of effort on the 1-junction of the piston, whose flow is s′ w; the transformer with the modulus s′ joins it \
                   to the 1-junction of the crank with the flow w. The inertia J is in integral causality; the mass m follows.",
            size: (460.0, 330.0),
            draw: bonds,
        },
        Sketch {
            name: "chain",
            title: "A torsional chain",
            says: "Inertias at stations from the ring of the damper to the driveline, joined by shafts of stiffness k and damping c; a shaft behind gears turns ρ times as fast, and its \
                   inertia and stiffness count ρ² times.",
            size: (460.0, 300.0),
            draw: chain,
        },
    ]
}

fn block_on_mounts(pen: &mut Pen) {
    let plane = Plane::level((220.0, 150.0), 1.0);
    let outline = [
        (-130.0, -50.0),
        (-130.0, 30.0),
        (-90.0, 90.0),
        (70.0, 90.0),
        (70.0, 40.0),
        (150.0, 40.0),
        (150.0, -30.0),
        (90.0, -50.0),
    ];
    pen.area("metal", &outline.map(|p| plane.at(p)));
    // The same body after a small motion of its centre and a small turn.
    let (shift, turn) = ((30.0, 20.0), 4f64.to_radians());
    let moved = outline.map(|(a, b)| {
        plane.at((shift.0 + a * turn.cos() - b * turn.sin(), shift.1 + a * turn.sin() + b * turn.cos()))
    });
    pen.area("s1", &moved);
    let centre = plane.at((0.0, 0.0));
    for (index, (place, slant)) in [((-96.0, -50.0), -0.35), ((104.0, -44.0), 0.35)].into_iter().enumerate() {
        let top = plane.at(place);
        let foot = |aside: f64| (top.0 + aside + 76.0 * f64::sin(slant), top.1 + 76.0 * f64::cos(slant));
        pen.spring((top.0 - 11.0, top.1), foot(-11.0));
        pen.dashpot((top.0 + 11.0, top.1), foot(11.0));
        let end = foot(0.0);
        pen.ground((end.0 + 34.0, end.1), (end.0 - 34.0, end.1));
        pen.circle("dot", top, 4.0);
        if index == 1 {
            pen.arrow("a3", centre, top);
            let (x, y) = between(centre, top, 0.6);
            pen.symbol((x + 4.0, y - 6.0), Anchor::Start, "ρ_j");
            pen.symbol((end.0 - 40.0, end.1 - 34.0), Anchor::End, "k, η");
            pen.symbol((end.0 + 16.0, end.1 - 34.0), Anchor::Start, "c");
            let far = (top.0 + 62.0, top.1 + 8.0);
            let direction = (-f64::sin(slant), -f64::cos(slant));
            pen.arrow("a1", far, (far.0 + 40.0 * direction.0, far.1 + 40.0 * direction.1));
            pen.symbol((far.0 + 4.0, far.1 - 8.0), Anchor::Start, "a");
        }
    }
    pen.arrow("a2", centre, plane.at(shift));
    pen.symbol((256.0, 128.0), Anchor::Start, "u");
    pen.turn("a2", &plane.arc((0.0, 0.0), 54.0, 1.9, 3.2));
    pen.symbol((160.0, 112.0), Anchor::End, "φ");
    pen.circle("dot", centre, 5.0);
    pen.symbol((212.0, 178.0), Anchor::End, "m, J");
    pen.remark((16.0, 26.0), Anchor::Start, "dashed: displaced by u and φ");
}

fn block_in_motion(pen: &mut Pen) {
    let lean = 7f64.to_radians();
    let origin = (230.0, 372.0);
    let linkage = Linkage { r: 66.0, l: 210.0, e: 18.0, phi: 50f64.to_radians() };
    // The block's own axes, turned by the lean.
    let at = |(a, b): (f64, f64)| -> Point {
        Plane::upright(origin, 1.0).at((a * lean.cos() - b * lean.sin(), a * lean.sin() + b * lean.cos()))
    };
    let block = [
        (-88.0, -110.0),
        (-88.0, 110.0),
        (70.0, 100.0),
        (120.0, 72.0),
        (318.0, 72.0),
        (318.0, -40.0),
        (120.0, -56.0),
        (70.0, -100.0),
    ];
    pen.area("metal", &block.map(at));
    for (foot, ground) in [((-88.0, -84.0), (150.0, 540.0)), ((-88.0, 84.0), (300.0, 540.0))] {
        let top = at(foot);
        pen.spring(top, (top.0, ground.1 - 8.0));
        pen.ground((top.0 + 30.0, ground.1 - 8.0), (top.0 - 30.0, ground.1 - 8.0));
    }
    let (pin, piston) = (linkage.crankpin(), linkage.piston_pin());
    pen.line("axis-line", at((-40.0, 0.0)), at((330.0, 0.0)));
    pen.line("axis-line", at((-20.0, linkage.e)), at((330.0, linkage.e)));
    pen.area(
        "pin",
        &[(30.0, -46.0), (30.0, 46.0), (-26.0, 46.0), (-26.0, -46.0)]
            .map(|(a, b)| at((piston.0 + a, linkage.e + b))),
    );
    pen.line("crank", at((0.0, 0.0)), at(pin));
    pen.arrow("a3", at(pin), at(piston));
    for place in [(0.0, 0.0), pin, piston] {
        pen.circle("pin", at(place), 5.0);
    }
    let label = |pen: &mut Pen, place: (f64, f64), (dx, dy): (f64, f64), anchor: Anchor, text: &str| {
        let (x, y) = at(place);
        pen.symbol((x + dx, y + dy), anchor, text);
    };
    label(pen, pin, (10.0, 8.0), Anchor::Start, "P");
    label(pen, piston, (10.0, -8.0), Anchor::Start, "W");
    label(pen, between(pin, piston, 0.5), (8.0, 0.0), Anchor::Start, "d");
    label(pen, between((0.0, 0.0), piston, 0.72), (-16.0, 0.0), Anchor::End, "s");
    pen.arrow("measure", at((0.0, -12.0)), at((piston.0, -12.0)));
    pen.arrow("a1", at((0.0, 0.0)), at((56.0, 0.0)));
    label(pen, (48.0, 0.0), (-8.0, 0.0), Anchor::End, "u");
    pen.arrow("a1", at((0.0, 0.0)), at((0.0, 50.0)));
    label(pen, (0.0, 50.0), (8.0, 14.0), Anchor::Start, "v");
    pen.turn(
        "a0",
        &[0.0, 0.2, 0.4, 0.6, 0.8, 1.0].map(|k| at(beyond((0.0, 0.0), 52.0, 3.7 - 0.9 + 0.9 * k))),
    );
    label(pen, beyond((0.0, 0.0), 52.0, 3.3), (0.0, 22.0), Anchor::Middle, "w");
    pen.arrow("a2", at((0.0, 0.0)), (origin.0 - 66.0, origin.1 - 30.0));
    pen.symbol((172.0, 334.0), Anchor::Middle, "v");
    pen.turn("a2", &Plane::upright(origin, 1.0).arc((0.0, 0.0), 150.0, 1.15, 1.75));
    pen.symbol((396.0, 352.0), Anchor::Start, "Ω");
    pen.remark((16.0, 26.0), Anchor::Start, "ground: springs; the block may move");
    pen.remark((16.0, 46.0), Anchor::Start, "by any amount");
}

/// A bond with its half arrow at the end and its causal stroke at the beginning or at the end.
fn bond(pen: &mut Pen, from: Point, to: Point, stroke_at_end: bool) {
    let length = (to.0 - from.0).hypot(to.1 - from.1);
    let (ux, uy) = ((to.0 - from.0) / length, (to.1 - from.1) / length);
    pen.line("outline", from, to);
    pen.line("outline", to, (to.0 - 13.0 * ux + 8.0 * uy, to.1 - 13.0 * uy - 8.0 * ux));
    let end = if stroke_at_end { to } else { from };
    pen.line("s0", (end.0 - 9.0 * uy, end.1 + 9.0 * ux), (end.0 + 9.0 * uy, end.1 - 9.0 * ux));
}

fn bonds(pen: &mut Pen) {
    let (y, low) = (120.0, 240.0);
    let element = |pen: &mut Pen, x: f64, y: f64, text: &str| pen.symbol((x, y + 6.0), Anchor::Middle, text);
    element(pen, 34.0, y, "Se");
    bond(pen, (54.0, y), (122.0, y), true);
    element(pen, 136.0, y, "1");
    bond(pen, (150.0, y), (206.0, y), true);
    // Flow is set by the transformer on the left, by the junction of the crank on the right.
    element(pen, 230.0, y, "MTF");
    bond(pen, (256.0, y), (318.0, y), true);
    element(pen, 332.0, y, "1");
    bond(pen, (346.0, y), (402.0, y), true);
    element(pen, 424.0, y, "I : J");
    bond(pen, (136.0, y + 16.0), (136.0, low - 18.0), false);
    element(pen, 136.0, low, "I : m");
    bond(pen, (332.0, y + 16.0), (332.0, low - 18.0), false);
    element(pen, 332.0, low, "R : load");
    pen.symbol((88.0, y - 10.0), Anchor::Middle, "e");
    pen.symbol((88.0, y + 24.0), Anchor::Middle, "f");
    pen.symbol((230.0, y - 22.0), Anchor::Middle, "s′(θ)");
    pen.remark((34.0, y - 24.0), Anchor::Middle, "gas");
    pen.remark((136.0, y - 46.0), Anchor::Middle, "piston");
    pen.symbol((136.0, y - 24.0), Anchor::Middle, "f = s′ w");
    pen.remark((332.0, y - 46.0), Anchor::Middle, "crank");
    pen.symbol((332.0, y - 24.0), Anchor::Middle, "f = w");
    pen.remark((424.0, y + 34.0), Anchor::Middle, "integral");
    pen.remark((136.0, low + 30.0), Anchor::Middle, "follows");
    pen.remark((16.0, 312.0), Anchor::Start, "stroke: at the end that sets the flow; half arrow: power");
}

fn chain(pen: &mut Pen) {
    let axis = 110.0;
    // Heights of the discs as the fourth roots of inertias whose ratios are those of a car engine.
    let stations = [
        (40.0, 34.0, "ring"),
        (86.0, 22.0, ""),
        (138.0, 30.0, ""),
        (190.0, 30.0, ""),
        (242.0, 30.0, ""),
        (306.0, 62.0, "flywheel"),
    ];
    pen.line("axis-line", (16.0, axis), (440.0, axis));
    for pair in stations.windows(2).skip(1) {
        pen.line("shaft-line", (pair[0].0 + 6.0, axis), (pair[1].0 - 6.0, axis));
    }
    pen.spring((46.0, axis - 14.0), (80.0, axis - 14.0));
    pen.dashpot((46.0, axis + 14.0), (80.0, axis + 14.0));
    for (x, half, _) in stations {
        pen.area(
            "metal",
            &[(x - 6.0, axis - half), (x + 6.0, axis - half), (x + 6.0, axis + half), (x - 6.0, axis + half)],
        );
    }
    for (index, x) in [138.0, 190.0, 242.0].into_iter().enumerate() {
        pen.symbol((x, axis - 40.0), Anchor::Middle, &format!("J_{}", index + 3));
        pen.turn("a1", &[(x - 10.0, axis + 44.0), (x, axis + 48.0), (x + 12.0, axis + 44.0)]);
        pen.symbol((x, axis + 70.0), Anchor::Middle, &format!("φ_{}", index + 3));
    }
    pen.symbol((164.0, axis - 12.0), Anchor::Middle, "k, c");
    pen.symbol((216.0, axis - 12.0), Anchor::Middle, "k, c");
    for (x, y, text) in [
        (40.0, axis - 44.0, "ring"),
        (92.0, axis + 48.0, "hub"),
        (190.0, axis - 70.0, "throws"),
        (306.0, axis - 72.0, "flywheel"),
    ] {
        pen.remark((x, y), Anchor::Middle, text);
    }
    // Gears of the ratio ρ = 2: radii 2 to 1 on parallel shafts.
    let (big, small) = (56.0, 28.0);
    let second = axis + big + small;
    pen.line("shaft-line", (312.0, axis), (362.0, axis));
    pen.area("metal", &[(356.0, axis - big), (368.0, axis - big), (368.0, axis + big), (356.0, axis + big)]);
    pen.area(
        "metal",
        &[(356.0, second - small), (368.0, second - small), (368.0, second + small), (356.0, second + small)],
    );
    pen.line("shaft-line", (368.0, second), (414.0, second));
    pen.area(
        "metal",
        &[(414.0, second - 36.0), (426.0, second - 36.0), (426.0, second + 36.0), (414.0, second + 36.0)],
    );
    pen.symbol((384.0, axis + 40.0), Anchor::Start, "ρ = −2");
    pen.symbol((420.0, second + 60.0), Anchor::Middle, "ρ² J");
    pen.remark((300.0, second + 62.0), Anchor::Middle, "branch, referred:");
}
