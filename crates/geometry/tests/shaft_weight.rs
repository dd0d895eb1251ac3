//! The best weights of balance shafts: against weights of the same unbalance at random within the ranges.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester_geometry::{
    Range, ShaftWeightAim, ShaftWeightDesign, ShaftWeightOutcome, ShaftWeightShape, ShaftWeightTask,
};
use proptest::prelude::*;

/// A task around a weight within its ranges, and that weight's share of each range.
fn any_task() -> impl Strategy<Value = (ShaftWeightTask, ShaftWeightShape, f64)> {
    let aim =
        prop_oneof![Just(ShaftWeightAim::Mass), Just(ShaftWeightAim::Length), Just(ShaftWeightAim::Radius)];
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
        .prop_map(|(shaft_radius, beyond, part, length, below, above, aim)| {
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
                unbalance: ShaftWeightDesign::new(shape, length, 7850.0).unbalance,
                density: 7850.0,
                shaft_radius,
                radius: range(radius, least_radius.min(radius), 0.09, 0),
                chord: range(chord, -0.99 * reach, 0.99 * shaft_radius, 1),
                length: range(length, 0.005, 0.2, 2),
                aim,
            };
            (task, shape, length)
        })
}

fn aimed(aim: ShaftWeightAim, design: &ShaftWeightDesign) -> f64 {
    match aim {
        ShaftWeightAim::Mass => design.mass,
        ShaftWeightAim::Length => design.length,
        ShaftWeightAim::Radius => design.shape.radius,
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn prop_no_weight_within_the_ranges_is_better((task, shape, length) in any_task()) {
        let outcome = task.best().unwrap();
        let ShaftWeightOutcome::Best(best) = outcome else {
            return Err(TestCaseError::fail(format!("{outcome:?} of {task:?}")));
        };
        prop_assert!((best.unbalance / task.unbalance - 1.0).abs() < 1e-9, "{:?} {:?}", best, task);
        let slack = 1.0 + 1e-12;
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
            let needed = task.unbalance / (task.density * other.moments().first.x);
            let needed = if k == 0 { length } else { needed };
            if !within(task.length, needed) {
                continue;
            }
            tried += 1;
            let other = ShaftWeightDesign::new(other, needed, task.density);
            let (ours, theirs) = (aimed(task.aim, &best), aimed(task.aim, &other));
            prop_assert!(ours <= theirs * slack * slack, "{} {} {:?} {:?}", ours, theirs, best, other);
            if (ours - theirs).abs() <= 1e-9 * theirs {
                prop_assert!(best.mass <= other.mass * (1.0 + 1e-6), "{:?} {:?}", best, other);
            }
        }
        prop_assert!(tried > 0);
    }

    #[test]
    fn prop_what_no_weight_has_is_told((task, _, _) in any_task(), beyond in 1.001..3.0f64) {
        let outcome = ShaftWeightTask { unbalance: 1e6, ..task }.best().unwrap();
        let ShaftWeightOutcome::Infeasible { least, most } = outcome else {
            return Err(TestCaseError::fail("a ton at a metre"));
        };
        prop_assert!(least <= task.unbalance * (1.0 + 1e-9) && task.unbalance <= most * (1.0 + 1e-9));
        for (unbalance, is_possible) in [(most * 0.999_999, true), (most * beyond, false), (least / beyond, false)] {
            if is_possible && unbalance < least {
                continue;
            }
            let outcome = ShaftWeightTask { unbalance, ..task }.best().unwrap();
            prop_assert_eq!(matches!(outcome, ShaftWeightOutcome::Best(_)), is_possible);
        }
    }
}

#[test]
fn the_lightest_fills_radius_and_length() {
    let task = ShaftWeightTask {
        unbalance: 0.004,
        density: 7850.0,
        shaft_radius: 0.012,
        radius: Range::new(0.02, 0.04),
        chord: Range::new(-0.015, 0.011),
        length: Range::new(0.01, 0.03),
        aim: ShaftWeightAim::Mass,
    };
    let ShaftWeightOutcome::Best(best) = task.best().unwrap() else { panic!("it is possible") };
    assert_eq!(best.shape.radius, 0.04);
    assert!((best.unbalance - 0.004).abs() < 1e-14);
    let part = best.part().unwrap();
    assert!((part.moments().unbalance().x - 0.004).abs() < 1e-14);
    let error = ShaftWeightTask { chord: Range::new(0.0, 0.012), ..task }.best().unwrap_err();
    assert!(error.to_string().contains("no hold"));
}
