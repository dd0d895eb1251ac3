//! The best weights of balance shafts: against weights of the same unbalance at random within the ranges.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester_geometry::{
    Range, ShaftWeightAim, ShaftWeightDesign, ShaftWeightLimit, ShaftWeightOutcome, ShaftWeightShape,
    ShaftWeightTask, best_shaft_weight,
};
use proptest::prelude::*;

/// A task around a weight within its ranges, that weight's unbalance, shape and length.
fn any_task() -> impl Strategy<Value = (ShaftWeightTask, f64, ShaftWeightShape, f64)> {
    use ShaftWeightAim::{Inertia, Length, Mass, Radius};
    let aim = prop_oneof![Just(Mass), Just(Length), Just(Radius), Just(Inertia)];
    let width = || prop_oneof![Just(0.0), 0.0..1.0f64];
    (
        0.005..0.02f64,
        0.002..0.05f64,
        0.02..0.98f64,
        0.01..0.1f64,
        [width(), width(), width()],
        [width(), width(), width()],
        aim,
    )
        .prop_map(|(shaft_radius, beyond, part, length, below, above, minimise)| {
            let least_radius = shaft_radius + 0.001;
            let radius = shaft_radius + beyond;
            let reach = radius.min(least_radius);
            let chord = -0.99 * reach + part * (0.99 * reach + 0.99 * shaft_radius);
            let shape = ShaftWeightShape { shaft_radius, radius, chord };
            let range = |value: f64, low: f64, high: f64, k: usize| {
                Range::new(
                    value - below[k] * (value - low).max(0.0),
                    value + above[k] * (high - value).max(0.0),
                )
            };
            let task = ShaftWeightTask {
                minimise,
                density: 7850.0,
                shaft_radius,
                radius: range(radius, least_radius.min(radius), 0.09, 0),
                chord: range(chord, -0.99 * reach, 0.99 * shaft_radius, 1),
                length: range(length, 0.005, 0.2, 2),
            };
            (task, ShaftWeightDesign::new(shape, length, 7850.0).unbalance, shape, length)
        })
}

fn aimed(aim: ShaftWeightAim, design: &ShaftWeightDesign) -> f64 {
    match aim {
        ShaftWeightAim::Mass => design.mass,
        ShaftWeightAim::Length => design.length,
        ShaftWeightAim::Radius => design.shape.radius,
        ShaftWeightAim::Inertia => design.polar_inertia,
    }
}

/// The task with another value of a limit.
fn with(task: &ShaftWeightTask, limit: ShaftWeightLimit, value: f64) -> ShaftWeightTask {
    let mut task = *task;
    match limit {
        ShaftWeightLimit::LargestRadius => task.radius.most = value,
        ShaftWeightLimit::LeastRadius => task.radius.least = value,
        ShaftWeightLimit::LargestLength => task.length.most = value,
        ShaftWeightLimit::LeastLength => task.length.least = value,
        ShaftWeightLimit::LargestChord => task.chord.most = value,
        ShaftWeightLimit::LeastChord => task.chord.least = value,
        ShaftWeightLimit::ShaftDiameter => task.shaft_radius = value / 2.0,
        ShaftWeightLimit::Density => task.density = value,
    }
    task
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn prop_no_weight_within_the_ranges_is_better((task, unbalance, shape, length) in any_task()) {
        let outcome = best_shaft_weight(unbalance, &task).unwrap();
        let ShaftWeightOutcome::Best(best) = outcome else {
            return Err(TestCaseError::fail(format!("{outcome:?} of {task:?}")));
        };
        prop_assert!((best.unbalance / unbalance - 1.0).abs() < 1e-9, "{:?} {:?}", best, task);
        // Of least inertia the one found may have a part in a million more.
        let is_inertia = task.minimise == ShaftWeightAim::Inertia;
        let slack = if is_inertia { 1.0 + 1e-6 } else { 1.0 + 1e-12 };
        let within = |range: Range, value: f64| value >= range.least && value <= range.most;
        prop_assert!(within(task.radius, best.shape.radius) && within(task.chord, best.shape.chord));
        prop_assert!(within(task.length, best.length));
        let mut tried = 0;
        for k in 0..400u32 {
            let share = |step: f64| (0.5 + f64::from(k) * step).fract();
            let between = |range: Range, share: f64| range.least + share * (range.most - range.least);
            let (radius, chord) = if k == 0 {
                (shape.radius, shape.chord)
            } else {
                (between(task.radius, share(0.754_877_666_246_693)), between(task.chord, share(0.569_840_290_998_053)))
            };
            let other = ShaftWeightShape { radius, chord, ..shape };
            let needed = unbalance / (task.density * other.moments().first.x);
            let needed = if k == 0 { length } else { needed };
            if !within(task.length, needed) {
                continue;
            }
            tried += 1;
            let other = ShaftWeightDesign::new(other, needed, task.density);
            let (ours, theirs) = (aimed(task.minimise, &best), aimed(task.minimise, &other));
            prop_assert!(ours <= theirs * slack * slack, "{} {} {:?} {:?}", ours, theirs, best, other);
            // The shortest weight is alone: beside it the length grows with the square of a change of the chord, the mass
            // changes with the change itself, so that a billionth more length may be much less mass.
            let is_as_good = match task.minimise {
                ShaftWeightAim::Inertia => false,
                ShaftWeightAim::Length => theirs <= ours,
                _ => (ours - theirs).abs() <= 1e-9 * theirs,
            };
            if is_as_good {
                prop_assert!(best.mass <= other.mass * (1.0 + 1e-6), "{:?} {:?}", best, other);
            }
        }
        prop_assert!(tried > 0);
    }

    #[test]
    fn prop_what_no_weight_has_is_told((task, unbalance, ..) in any_task(), beyond in 1.001..3.0f64) {
        let outcome = best_shaft_weight(1e6, &task).unwrap();
        let ShaftWeightOutcome::Infeasible { least, most, .. } = outcome else {
            return Err(TestCaseError::fail("a ton at a metre"));
        };
        prop_assert!(least <= unbalance * (1.0 + 1e-9) && unbalance <= most * (1.0 + 1e-9));
        for (unbalance, is_possible) in [(most * 0.999_999, true), (most * beyond, false), (least / beyond, false)] {
            if is_possible && unbalance < least {
                continue;
            }
            let outcome = best_shaft_weight(unbalance, &task).unwrap();
            prop_assert_eq!(matches!(outcome, ShaftWeightOutcome::Best(_)), is_possible);
            let ShaftWeightOutcome::Infeasible { nearest, .. } = outcome else { continue };
            prop_assert!(!nearest.is_empty());
            for near in nearest {
                let eased = |value: f64| best_shaft_weight(unbalance, &with(&task, near.limit, value)).unwrap();
                let is_met = |value: f64| matches!(eased(value), ShaftWeightOutcome::Best(_));
                prop_assert!(is_met(near.nearest), "{:?} {:?}", near, task);
                // A little less of the way is not enough.
                let short = near.nearest + 1e-6 * (near.asked - near.nearest);
                prop_assert!(!is_met(short), "{:?} {:?}", near, task);
            }
        }
    }
}

#[test]
fn the_lightest_fills_radius_and_length() {
    let task = ShaftWeightTask {
        minimise: ShaftWeightAim::Mass,
        density: 7850.0,
        shaft_radius: 0.012,
        radius: Range::new(0.02, 0.04),
        chord: Range::new(-0.015, 0.011),
        length: Range::new(0.01, 0.03),
    };
    let ShaftWeightOutcome::Best(best) = best_shaft_weight(0.004, &task).unwrap() else {
        panic!("it is possible")
    };
    assert_eq!(best.shape.radius, 0.04);
    assert!((best.unbalance - 0.004).abs() < 1e-14);
    let part = best.part(0.004).part().unwrap();
    assert!((part.moments().unbalance().x - 0.004).abs() < 1e-14);
    let loose = ShaftWeightTask { chord: Range::new(0.0, 0.012), ..task };
    let error = best_shaft_weight(0.004, &loose).unwrap_err();
    assert!(error.to_string().contains("no hold"));
}

#[test]
fn the_one_of_least_inertia_is_long_and_narrow() {
    let task = ShaftWeightTask {
        minimise: ShaftWeightAim::Inertia,
        density: 7850.0,
        shaft_radius: 0.012,
        radius: Range::new(0.02, 0.04),
        chord: Range::new(-0.015, 0.011),
        length: Range::new(0.01, 0.05),
    };
    let best = |task: &ShaftWeightTask| match best_shaft_weight(0.004, task).unwrap() {
        ShaftWeightOutcome::Best(best) => best,
        other => panic!("{other:?}"),
    };
    let slow = best(&task);
    assert!((slow.length - 0.05).abs() < 1e-12 && slow.shape.radius < 0.03, "{slow:?}");
    // Where the chord is within its range, its points have the mean squared distance over c that the arc has: book, eq. (22.70).
    let ShaftWeightShape { radius, chord, shaft_radius } = slow.shape;
    let (wide, narrow) =
        ((radius * radius - chord * chord).sqrt(), (shaft_radius * shaft_radius - chord * chord).sqrt());
    let along_chord = chord + (wide * wide + wide * narrow + narrow * narrow) / (3.0 * chord);
    let along_arc = radius * (chord / radius).acos() / (wide / radius);
    assert!((chord - 0.011).abs() < 1e-9 || (along_chord / along_arc - 1.0).abs() < 2e-3, "{slow:?}");
    let light = best(&ShaftWeightTask { minimise: ShaftWeightAim::Mass, ..task });
    assert!(light.mass < slow.mass && slow.polar_inertia < 0.8 * light.polar_inertia);
}
