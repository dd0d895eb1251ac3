//! The tool paper's family: closed form against the outline, degenerate cases against independent integration.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester_shape::{Contour, Corner, CounterweightShape, Edge, Point};
use proptest::prelude::*;
use std::f64::consts::PI;

fn shape(r: f64, h: f64, big_h: f64, radius: f64, alpha: f64) -> CounterweightShape {
    CounterweightShape {
        web_radius: r,
        rectangle_height: h,
        shoulder_height: big_h,
        arc_radius: radius,
        arc_angle: alpha,
    }
    .checked()
    .unwrap()
}

/// Any shape of the family, with zero heights, tapers both ways, discs through the crown, arcs beyond half a turn.
fn any_shape() -> impl Strategy<Value = CounterweightShape> {
    let height = || prop_oneof![Just(0.0), 0.0..0.05f64, (-9.0..-3.0f64).prop_map(|power| 10f64.powf(power))];
    let angle = prop_oneof![0.05..3.1f64, 3.2..6.2f64, Just(PI)];
    (0.005..0.05f64, height(), height(), 0.005..0.1f64, angle)
        .prop_map(|(r, h, big_h, radius, alpha)| shape(r, h, big_h, radius, alpha))
}

/// Half width of the union at the distance `x` from the crank axis, straight from the figure's definition.
fn half_width(shape: &CounterweightShape, x: f64) -> f64 {
    let (r, h, y_s) = (shape.web_radius, shape.rectangle_height, shape.chord_distance());
    let disc = (r * r - x * x).max(0.0).sqrt();
    let profile = if x <= h {
        r
    } else if x <= y_s {
        r + shape.shoulder() * (x - h) / shape.shoulder_height
    } else {
        let u = x - shape.centre_distance();
        (shape.arc_radius * shape.arc_radius - u * u).max(0.0).sqrt()
    };
    disc.max(profile)
}

/// Integral by adaptive Simpson's rule.
fn simpson(f: &dyn Fn(f64) -> f64, a: f64, b: f64, tolerance: f64, depth: u32) -> f64 {
    let m = (a + b) / 2.0;
    let (fa, fm, fb) = (f(a), f(m), f(b));
    let (fl, fr) = (f((a + m) / 2.0), f((m + b) / 2.0));
    let whole = (b - a) / 6.0 * (fa + 4.0 * fm + fb);
    let halves = (b - a) / 12.0 * (fa + 4.0 * fl + 2.0 * fm + 4.0 * fr + fb);
    if depth == 0 || (halves - whole).abs() < 15.0 * tolerance {
        return halves + (halves - whole) / 15.0;
    }
    simpson(f, a, m, tolerance / 2.0, depth - 1) + simpson(f, m, b, tolerance / 2.0, depth - 1)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn prop_closed_form_is_the_outline(shape in any_shape()) {
        let Some(closed) = shape.closed_form() else { return Ok(()) };
        let (exact, reach) = (shape.moments(), shape.swept_radius());
        // 1e-12 of area and of area x reach; the web's disc belongs to the figure that is integrated.
        let area = exact.area + PI * shape.web_radius.powi(2);
        prop_assert!((closed.area - exact.area).abs() < 1e-13 * area);
        prop_assert!((closed.first - exact.first).norm() < 1e-13 * area * reach);
        prop_assert!((closed.xx - exact.xx).abs() < 1e-13 * area * reach * reach);
        prop_assert!((closed.yy - exact.yy).abs() < 1e-13 * area * reach * reach);
    }

    #[test]
    fn lit_corrected_formulas_are_the_closed_form(shape in any_shape()) {
        let Some(closed) = shape.closed_form() else { return Ok(()) };
        let (r, h, big_h) = (shape.web_radius, shape.rectangle_height, shape.shoulder_height);
        let (l_c, y_s, y_c) = (shape.shoulder(), shape.chord_distance(), shape.centre_distance());
        let (radius, a) = (shape.arc_radius, shape.arc_angle / 2.0);
        let seg = radius * radius * (a - a.sin() * a.cos());
        let area = seg + (2.0 * r + l_c) * big_h + 2.0 * r * h - PI * r * r / 2.0;
        let first = seg * y_c + 2.0 / 3.0 * (radius * a.sin()).powi(3) + (2.0 * r + l_c) * big_h * y_s
            - big_h * big_h * (3.0 * r + l_c) / 3.0 + r * h * h - 2.0 / 3.0 * r.powi(3);
        let reach = shape.swept_radius() + radius;
        prop_assert!((closed.area - area).abs() < 1e-13 * reach * reach);
        prop_assert!((closed.first.x - first).abs() < 1e-13 * reach.powi(3));
    }

    #[test]
    fn prop_any_shape_is_what_its_figure_says(shape in any_shape()) {
        // Widths are smooth between these places.
        let crown = shape.crown().max(shape.web_radius);
        let (r, h, y_s) = (shape.web_radius, shape.rectangle_height, shape.chord_distance());
        let mut places = [0.0, h, y_s, shape.crown(), r, crown];
        places.sort_by(f64::total_cmp);
        let (mut area, mut first) = (PI * r * r / 2.0, -2.0 / 3.0 * r.powi(3));
        for pair in places.windows(2) {
            let (from, to) = (pair[0], pair[1]);
            if to - from < 1e-14 {
                continue;
            }
            // x = from + (to - from) (1 - cos t)/2 takes the square roots at both ends away.
            let at = |t: f64| from + (to - from) * (t / 2.0).sin().powi(2);
            let width = |t: f64| {
                let inside = at(t).clamp(from.next_up(), to.next_down());
                half_width(&shape, inside) * (to - from) * t.sin()
            };
            area += simpson(&width, 0.0, PI, 1e-14, 30);
            first += simpson(&|t| width(t) * at(t), 0.0, PI, 1e-15, 30);
        }
        let web = shape.outline().moments();
        prop_assert!((web.area - area).abs() < 1e-10, "{} {area}", web.area);
        prop_assert!((web.first.x - first).abs() < 1e-11, "{} {first}", web.first.x);
        prop_assert!(web.first.y.abs() < 1e-16);
    }

    #[test]
    fn prop_outlines_are_sound(shape in any_shape()) {
        let outline = shape.outline();
        // The checks of any outline from outside; edges too short for them stay out.
        let size = outline.size();
        prop_assume!(outline.edges().iter().all(|edge| edge.half_chord() > 1e-8 * size));
        let corners: Vec<Corner> = outline.edges().iter().map(|edge| Corner { at: edge.from, bulge: edge.bulge }).collect();
        prop_assert!(Contour::new(&corners).is_ok());
        let (r, crown) = (shape.web_radius, shape.crown());
        prop_assert!(outline.contains(Point::new(-0.999 * r, 0.0)) && outline.contains(Point::new(0.999 * crown.max(r), 0.0)));
        // The swept radius is the largest of the candidates of the book, eq. 22.25.
        let corner = shape.chord_distance().hypot(shape.half_width());
        let candidates = [r, shape.rectangle_height.hypot(r), corner, crown];
        let reach = candidates.into_iter().fold(0.0, f64::max);
        prop_assert!((shape.swept_radius() - reach).abs() < 1e-13 * reach, "{} {reach}", shape.swept_radius());
    }
}

#[test]
fn discs_are_seen_through_tapers_and_crowns() {
    let edges = |shape: CounterweightShape| shape.outline().edges().len();
    // Hidden wholly in the disc.
    let hidden = shape(0.05, 0.0, 0.01, 0.01, 1.0);
    assert_eq!(edges(hidden), 2);
    assert!(hidden.moments().area.abs() < 1e-17);
    // An inward taper that the disc breaks through and leaves again: its arc stands on both flanks.
    let waist = shape(0.05, 0.01, 0.06, 0.02, 1.5);
    assert!(waist.shoulder() < 0.0 && waist.closed_form().is_none());
    let arcs = waist.outline().edges().iter().filter(|edge: &&Edge| edge.bulge != 0.0).count();
    assert_eq!(arcs, 4, "crown, web and two flanks");
    // Crown within the disc.
    let low = shape(0.05, 0.01, 0.0, 0.06, 1.9);
    assert!(low.crown() < 0.05 && low.closed_form().is_none() && low.moments().area > 0.0);
}

#[test]
fn dimensions_that_cannot_be_are_named() {
    let good = shape(0.02, 0.02, 0.01, 0.05, 2.0);
    for (bad, words) in [
        (CounterweightShape { web_radius: 0.0, ..good }, "web radius r [m] must be positive, got 0"),
        (
            CounterweightShape { rectangle_height: -1.0, ..good },
            "rectangle height h [m] must be zero or more, got -1",
        ),
        (CounterweightShape { arc_radius: f64::NAN, ..good }, "arc radius R [m] must be positive, got NaN"),
        (
            CounterweightShape { arc_angle: 7.0, ..good },
            "arc angle alpha [rad] must be more than 0 and less than a full turn, got 7",
        ),
    ] {
        assert!(bad.checked().unwrap_err().to_string().starts_with(words));
    }
}
