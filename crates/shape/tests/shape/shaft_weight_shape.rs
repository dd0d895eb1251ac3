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

    #[test]
    fn prop_weights_meet_where_some_place_is_in_both(
        shafts in (0.005..0.02f64, 0.005..0.02f64),
        beyond in (0.001..0.06f64, 0.001..0.06f64),
        parts in (0.02..0.98f64, 0.02..0.98f64),
        angle in prop_oneof![-7.0..7.0f64, Just(PI), Just(0.0), Just(-PI / 2.0)],
    ) {
        let shape = |shaft_radius: f64, beyond: f64, part: f64| {
            let radius = shaft_radius + beyond;
            ShaftWeightShape { shaft_radius, radius, chord: -radius + part * (radius + shaft_radius) }
        };
        let (one, other) = (shape(shafts.0, beyond.0, parts.0), shape(shafts.1, beyond.1, parts.1));
        let within = |shape: &ShaftWeightShape, place: Point, room: f64| {
            let norm = place.norm();
            norm > shape.shaft_radius + room && norm < shape.radius - room && place.x > shape.chord + room
        };
        let shared = |one: &ShaftWeightShape, other: &ShaftWeightShape, room: f64| {
            (0..40_000).any(|k| {
                let norm = (f64::from(k / 400) + 0.5) / 100.0 * one.radius;
                let turn = f64::from(k % 400) / 400.0 * 2.0 * PI;
                let place = |turn: f64| Point::new(norm * turn.cos(), norm * turn.sin());
                within(one, place(turn), room) && within(other, place(turn - angle), room)
            })
        };
        prop_assert_eq!(one.meets(&other, angle), other.meets(&one, -angle));
        if shared(&one, &other, 1e-8) {
            prop_assert!(one.meets(&other, angle));
        }
        // A millimetre more all round is enough for the grid to find what they share.
        let wider = |shape: &ShaftWeightShape| ShaftWeightShape {
            shaft_radius: shape.shaft_radius - 1e-3,
            radius: shape.radius + 1e-3,
            chord: shape.chord - 1e-3,
        };
        if one.meets(&other, angle) {
            let (one, other) = (wider(&one), wider(&other));
            prop_assert!(shared(&one, &other, 0.0), "{one:?} and {other:?}");
        }
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
fn halves_of_one_disc_touch_and_more_than_halves_meet() {
    let half = ShaftWeightShape { shaft_radius: 0.01, radius: 0.04, chord: 0.0 };
    assert!(!half.meets(&half, PI) && half.meets(&half, 3.1) && half.meets(&half, 0.0));
    let more = ShaftWeightShape { chord: -1e-6, ..half };
    assert!(more.meets(&half, PI));
    // Chords across each other, whose corner lies beyond the smaller disc.
    let thin = ShaftWeightShape { chord: 0.009, ..half };
    let small = ShaftWeightShape { radius: 0.0127, ..thin };
    assert!(
        !thin.meets(&small, PI / 2.0) && thin.meets(&ShaftWeightShape { radius: 0.0128, ..small }, PI / 2.0)
    );
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
