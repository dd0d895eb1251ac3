//! Parts against textbook solids, finite slices and the laws of inertia.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::support::random_outline::{any_star, star};
use lanchester_shape::{Chamfer, Contour, Cut, Face, GeometryError, Insert, Outline, Part, Point};
use lanchester_testkit::Within;
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_4, PI};

const STEEL: f64 = 7850.0;

fn disc(radius: f64) -> Outline {
    Contour::circle(Point::ORIGIN, radius).unwrap().into()
}

fn at(x: f64, y: f64) -> Point {
    Point::new(x, y)
}

fn turned(radius: f64, angle: f64, face: Face) -> Chamfer {
    Chamfer { cut: Cut::Turned { radius }, angle, face }
}

fn milled(direction: f64, distance: f64, angle: f64, face: Face) -> Chamfer {
    Chamfer { cut: Cut::Milled { direction, distance }, angle, face }
}

#[track_caller]
fn assert_close(ours: f64, exact: f64, scale: f64, what: &str) {
    let within = Within::of(scale.abs().max(exact.abs()), 1e-13, "rounding of the terms of an exact sum");
    lanchester_testkit::assert_close(what, ours, exact, within);
}

#[test]
fn cylinder_and_bar_are_the_textbook_ones() {
    let (radius, thickness) = (0.05, 0.02);
    let properties = Part::new(disc(radius), thickness, STEEL).unwrap().at(0.3).mass_properties();
    let mass = STEEL * PI * radius * radius * thickness;
    assert_close(properties.mass, mass, mass, "mass");
    assert_close(properties.centre[2], 0.3, 0.3, "centre");
    assert_close(properties.polar_inertia(), mass * radius * radius / 2.0, 0.0, "polar");
    let across = mass * (3.0 * radius * radius + thickness * thickness) / 12.0;
    assert_close(properties.inertia_about_centre[0][0], across, mass * 0.09, "across");
    assert_close(properties.inertia_about_axis[0][0], across + mass * 0.09, 0.0, "about the axis at z = 0");

    let bar = Contour::polygon(&[at(0.01, -0.03), at(0.05, -0.03), at(0.05, 0.03), at(0.01, 0.03)]).unwrap();
    let properties = Part::new(bar.into(), thickness, STEEL).unwrap().at(0.1).mass_properties();
    let mass = STEEL * 0.04 * 0.06 * thickness;
    assert_close(properties.unbalance.x, mass * 0.03, 0.0, "unbalance");
    assert_close(
        properties.inertia_about_centre[2][2],
        mass * (0.04f64.powi(2) + 0.06f64.powi(2)) / 12.0,
        0.0,
        "polar",
    );
    assert_close(properties.inertia_about_axis[0][2], -mass * 0.03 * 0.1, 0.0, "product x z");
}

#[test]
fn turned_chamfer_of_a_disc_is_a_frustum() {
    // The disc with a 45 degree chamfer of 5 mm is a cylinder below a frustum of a cone.
    let (outer, inner, thickness) = (0.05, 0.045, 0.02);
    let height = outer - inner;
    let part = Part::new(disc(outer), thickness, STEEL).unwrap();
    let part = part.with_chamfer(turned(inner, FRAC_PI_4, Face::Rear)).unwrap();
    let frustum = PI * height / 3.0 * (outer * outer + outer * inner + inner * inner);
    let cylinder = PI * outer * outer * (thickness - height);
    let properties = part.mass_properties();
    assert_close(properties.mass, STEEL * (frustum + cylinder), 0.0, "mass");
    // Polar: rho pi/10 h (R^5 - r^5)/(R - r) for the frustum.
    let polar = PI / 10.0 * height * (outer.powi(5) - inner.powi(5)) / (outer - inner)
        + PI / 2.0 * outer.powi(4) * (thickness - height);
    assert_close(properties.polar_inertia(), STEEL * polar, 0.0, "polar");
    // Centre of a frustum above its larger base: h/4 (R^2 + 2 R r + 3 r^2)/(R^2 + R r + r^2).
    let above = height / 4.0 * (outer * outer + 2.0 * outer * inner + 3.0 * inner * inner)
        / (outer * outer + outer * inner + inner * inner);
    let z = (frustum * (thickness / 2.0 - height + above) - cylinder * height / 2.0) / (frustum + cylinder);
    assert_close(properties.centre[2], z, thickness, "centre");
    let front = Part::new(disc(outer), thickness, STEEL).unwrap();
    let front = front.with_chamfer(turned(inner, FRAC_PI_4, Face::Front)).unwrap().mass_properties();
    assert_close(front.centre[2], -z, thickness, "the same on the front face");
    assert_close(properties.unbalance.norm(), 0.0, properties.mass * outer, "no unbalance");
}

#[test]
fn milled_chamfer_of_a_bar_is_a_prism() {
    let bar =
        Contour::polygon(&[at(-0.02, -0.03), at(0.05, -0.03), at(0.05, 0.03), at(-0.02, 0.03)]).unwrap();
    let part = Part::new(bar.into(), 0.02, STEEL).unwrap();
    let whole = part.moments();
    let cut = part.with_chamfer(milled(0.0, 0.04, 0.5, Face::Front)).unwrap().moments();
    let depth = 0.01 * 0.5f64.tan();
    let prism = STEEL * 0.06 * 0.01 * depth / 2.0;
    assert_close(whole.mass - cut.mass, prism, whole.mass, "mass");
    // The centre of a triangle is a third of its height from its base.
    assert_close(whole.first[0] - cut.first[0], prism * (0.05 - 0.01 / 3.0), whole.mass * 0.05, "x");
    assert_close(whole.first[2] - cut.first[2], prism * (-0.01 + depth / 3.0), whole.mass * 0.05, "z");
    // INTEGRAL z^2 of the triangle from the face: depth^2/6 of its mass.
    let zz = prism * (depth * depth / 6.0 - 2.0 * 0.01 * depth / 3.0 + 0.01 * 0.01);
    assert_close(whole.second[2] - cut.second[2], zz, whole.mass * 0.05 * 0.05, "zz");
}

#[test]
fn slug_and_blind_hole_change_what_they_replace() {
    let part = Part::new(disc(0.05), 0.02, STEEL).unwrap();
    let slug = Insert { centre: at(0.03, 0.0), radius: 0.008, from: 0.0, to: 0.02, density: 18_000.0 };
    let hole = Insert { centre: at(-0.03, 0.0), radius: 0.006, from: 0.012, to: 0.02, density: 0.0 };
    let part = part.with_insert(slug).unwrap().with_insert(hole).unwrap();
    let properties = part.mass_properties();
    let added = (18_000.0 - STEEL) * PI * 0.008f64.powi(2) * 0.02;
    let removed = STEEL * PI * 0.006f64.powi(2) * 0.008;
    assert_close(properties.unbalance.x, 0.03 * (added + removed), 0.0, "unbalance");
    assert_close(properties.mass, STEEL * PI * 0.05f64.powi(2) * 0.02 + added - removed, 0.0, "mass");
    let z = -removed * (0.016 - 0.01) / properties.mass;
    assert_close(properties.centre[2], z, 0.02, "centre");
}

#[test]
fn what_no_part_may_be_is_said() {
    let part = || Part::new(disc(0.05), 0.02, STEEL).unwrap();
    let error = Part::new(disc(0.05), 0.02, 7.85).unwrap_err();
    assert_eq!(
        error.to_string(),
        "density [kg/m3] must be between 1000 and 23000, as materials of crankshafts are, got 7.85\nhint: steel is 7850 kg/m3, which is 7.85 g/cm3; tungsten alloys are 17000 to 18500 kg/m3"
    );
    assert!(Part::new(disc(0.05), 0.02, 7.85e6).is_err() && Part::new(disc(0.05), 0.02, f64::NAN).is_err());
    assert!(Part::new(disc(0.05), -0.02, STEEL).is_err());
    let insert = Insert { centre: at(0.03, 0.0), radius: 0.01, from: 0.0, to: 0.02, density: 18_000.0 };
    for bad in [
        Insert { centre: at(0.045, 0.0), ..insert },
        Insert { centre: at(0.2, 0.0), ..insert },
        Insert { to: 0.03, ..insert },
        Insert { to: 0.0, ..insert },
        Insert { density: 18.0, ..insert },
    ] {
        assert!(part().with_insert(bad).is_err(), "{bad:?}");
    }
    let twice = part().with_insert(insert).unwrap().with_insert(Insert { centre: at(0.02, 0.01), ..insert });
    assert!(matches!(twice, Err(GeometryError::InsertOutside { what: "overlaps another insert", .. })));
    let cut = part().with_insert(insert).unwrap().with_chamfer(turned(0.035, 0.3, Face::Rear));
    assert!(matches!(cut, Err(GeometryError::InsertOutside { what: "is cut by a chamfer", .. })));
    let deep = part().with_chamfer(turned(0.02, FRAC_PI_4, Face::Rear)).unwrap_err();
    assert_eq!(
        deep.to_string(),
        "the chamfer goes 30.0000 mm deep, where 20.0000 mm of thickness are left\nhint: begin it farther out or make it flatter"
    );
    let meeting = part().with_chamfer(turned(0.045, 0.5, Face::Rear)).unwrap();
    let error = meeting.clone().with_chamfer(milled(1.0, 0.04, 0.5, Face::Rear)).unwrap_err();
    assert!(matches!(error, GeometryError::ChamfersMeet { .. }), "{error}");
    assert!(meeting.with_chamfer(milled(1.0, 0.04, 0.5, Face::Front)).is_ok());
    assert!(part().with_chamfer(turned(0.045, 2.0, Face::Rear)).is_err());
}

/// The chamfer's volume and static moment by the midpoint rule on a fine grid.
fn on_a_grid(outline: &Outline, chamfer: &Chamfer, cells: usize) -> [f64; 2] {
    let [low, high] = outline.bounds();
    let (dx, dy) = ((high.x - low.x) / cells as f64, (high.y - low.y) / cells as f64);
    let mut sums = [0.0; 2];
    for i in 0..cells {
        for j in 0..cells {
            let point = at(low.x + (i as f64 + 0.5) * dx, low.y + (j as f64 + 0.5) * dy);
            let depth = chamfer.depth(point);
            if depth > 0.0 && outline.contains(point) {
                sums[0] += depth * dx * dy;
                sums[1] += depth * point.x * dx * dy;
            }
        }
    }
    sums
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn prop_chamfers_cut_what_a_grid_says(corners in any_star(), part in 0.6..0.95f64, direction in -3.0..3.0f64, is_turned: bool) {
        let outline: Outline = Contour::new(&corners).unwrap().into();
        let reach = if is_turned { outline.swept_radius() } else { outline.reach(Point::polar(1.0, direction)) };
        prop_assume!(reach > 1e-3);
        let chamfer = if is_turned { turned(part * reach, 0.3, Face::Front) } else { milled(direction, part * reach, 0.3, Face::Front) };
        let whole = Part::new(outline.clone(), 0.2, STEEL).unwrap();
        let before = whole.moments();
        let after = whole.with_chamfer(chamfer).unwrap().moments();
        let [volume, moment] = on_a_grid(&outline, &chamfer, 300);
        // The grid errs by about a cell along the edge of what is cut, where it is deepest.
        let deepest = 0.3f64.tan() * (1.0 - part) * reach;
        let [low, high] = outline.bounds();
        let error = deepest * (high - low).norm().powi(2) / 300.0;
        prop_assert!(((before.mass - after.mass) / STEEL - volume).abs() < error);
        prop_assert!(((before.first[0] - after.first[0]) / STEEL - moment).abs() < error * outline.swept_radius());
    }
}

proptest! {
    #[test]
    fn prop_inertia_obeys_its_laws(corners in any_star(), thickness in 0.005..0.05f64, z in -0.3..0.3f64) {
        let outline: Outline = Contour::new(&corners).unwrap().into();
        let properties = Part::new(outline.clone(), thickness, STEEL).unwrap().at(z).mass_properties();
        let [[a, ..], [_, b, _], [.., c]] = properties.inertia_about_centre;
        // Triangle inequality of the moments, for these or any axes.
        prop_assert!(a + b >= c && b + c >= a && c + a >= b);
        // Parallel axes from the centre back to the crank axis.
        let [x, y, _] = properties.centre;
        let polar = c + properties.mass * (x * x + y * y);
        prop_assert!((properties.polar_inertia() / polar - 1.0).abs() < 1e-11);
        // Turning the part turns its unbalance.
        let turned = Part::new(outline.turned(0.7), thickness, STEEL).unwrap().mass_properties().unbalance;
        prop_assert!((turned - properties.unbalance.turned(0.7)).norm() < 1e-13 * properties.mass * outline.swept_radius());
    }
}

#[test]
fn conv_chamfers_do_not_depend_on_how_the_outline_is_cut() {
    // The same outline with its edges split at their middles: another set of Gauss points, the same integrals.
    let corners = star(5, 0.05, &[0.3, -0.1, 0.0, 0.7, 0.05]);
    let whole = Contour::new(&corners).unwrap();
    let halves: Vec<_> = whole
        .edges()
        .iter()
        .flat_map(|edge| {
            let bulge = (edge.bulge.atan() / 2.0).tan();
            let middle = edge.middle();
            [
                lanchester_shape::Edge { to: middle, bulge, ..*edge },
                lanchester_shape::Edge { from: middle, bulge, ..*edge },
            ]
        })
        .collect();
    let split = Contour::from_edges(&halves, 0.0).unwrap();
    for chamfer in [turned(0.04, 0.6, Face::Rear), milled(0.4, 0.035, 0.6, Face::Rear)] {
        let cut = |contour: &Contour| {
            Part::new(contour.clone().into(), 0.02, STEEL).unwrap().with_chamfer(chamfer).unwrap().moments()
        };
        let (a, b) = (cut(&whole), cut(&split));
        assert_close(a.mass, b.mass, 0.0, "mass");
        for k in 0..6 {
            assert_close(a.second[k], b.second[k], a.mass * 0.05 * 0.05, "second moment");
        }
    }
}
