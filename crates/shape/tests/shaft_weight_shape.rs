//! Weights of balance shafts: closed form against the outline, whatever the side of the chord.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester_shape::{AreaMoments, Point, ShaftWeightShape};
use proptest::prelude::*;
use std::f64::consts::PI;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn prop_closed_form_is_the_outline_without_the_shaft(
        shaft_radius in 0.005..0.03f64,
        beyond in 0.001..0.08f64,
        part in 0.001..0.999f64,
    ) {
        let radius = shaft_radius + beyond;
        let chord = -radius + part * (radius + shaft_radius);
        prop_assume!((chord + shaft_radius).abs() > 1e-6);
        let shape = ShaftWeightShape { shaft_radius, radius, chord };
        let outline = shape.outline().unwrap();
        let (ours, whole) = (shape.moments(), outline.moments());
        let exact = whole - AreaMoments::disc(Point::ORIGIN, shaft_radius);
        prop_assert!((ours.area - exact.area).abs() < 1e-13 * whole.area);
        prop_assert!((ours.first - exact.first).norm() < 1e-13 * whole.area * radius);
        prop_assert!((ours.xx - exact.xx).abs() < 1e-13 * whole.area * radius * radius);
        prop_assert!((ours.yy - exact.yy).abs() < 1e-13 * whole.area * radius * radius);
        prop_assert!((outline.swept_radius() - radius).abs() < 1e-14);
    }
}

#[test]
fn half_a_disc_around_a_shaft_is_the_textbook_one() {
    let shape = ShaftWeightShape { shaft_radius: 0.01, radius: 0.04, chord: 0.0 };
    let moments = shape.moments();
    assert!((moments.area - PI / 2.0 * (0.04f64.powi(2) - 0.01f64.powi(2))).abs() < 1e-17);
    assert!((moments.first.x - 2.0 / 3.0 * (0.04f64.powi(3) - 0.01f64.powi(3))).abs() < 1e-19);
    assert!((moments.polar() - PI / 4.0 * (0.04f64.powi(4) - 0.01f64.powi(4))).abs() < 1e-20);
}

#[test]
fn weights_without_a_hold_and_whole_discs_are_refused() {
    let good = ShaftWeightShape { shaft_radius: 0.01, radius: 0.04, chord: 0.005 };
    assert!(good.checked().is_ok());
    for (bad, words) in [
        (ShaftWeightShape { chord: 0.01, ..good }, "no hold"),
        (ShaftWeightShape { chord: -0.04, ..good }, "whole disc"),
        (ShaftWeightShape { chord: f64::NAN, ..good }, "chord"),
        (ShaftWeightShape { radius: 0.01, ..good }, "stands out"),
        (ShaftWeightShape { shaft_radius: 0.0, ..good }, "radius of the shaft"),
    ] {
        let error = bad.outline().unwrap_err().to_string();
        assert!(error.contains(words), "{error}");
    }
}
