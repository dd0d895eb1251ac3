use super::*;
use lanchester_file::{read, template};
use proptest::prelude::*;
use std::f64::consts::FRAC_PI_2;

fn gallery(name: &str) -> Engine {
    read(template(name).unwrap().text).engine().unwrap()
}

/// 90-degree V on shared pins: 50 % leaves nothing. Even-firing V6 on 30-degree split pins: 36.6 % = (1 - tan 15)/2
/// leaves a swing across the bisector, 63.4 % along it.
#[test]
fn the_factors_of_a_pin_pair() {
    let odd = pin_pair_effect(90f64.to_radians(), 0.0);
    assert!((odd.least_peak().unwrap() - 0.5).abs() < 1e-15 && odd.peak(0.5) == 0.0);
    assert_eq!(odd.one_plane(), None);
    let even = pin_pair_effect(90f64.to_radians(), -30f64.to_radians());
    let [low, high] = even.one_plane().unwrap();
    let by_hand = 0.5 * (1.0 - 15f64.to_radians().tan());
    assert!((low.share - by_hand).abs() < 1e-14 && (by_hand - 0.366_025_403_784_438_6).abs() < 1e-15);
    assert!((low.direction - FRAC_PI_2).abs() < 1e-12 && high.direction.abs() < 1e-12);
    // 50 % leaves a circle of half the size of the swing.
    assert!((even.peak(0.5) - 0.5 * even.peak(by_hand)).abs() < 1e-15);
    assert!((even.peak(0.5) - 15f64.to_radians().sin()).abs() < 1e-15);
}

/// The whole engines say what the pair says: the V6's couple, the V8's couple; an in-line four does not mind.
#[test]
fn engines_of_the_gallery() {
    let even = common_factor(&gallery("v6-90"), 0).unwrap();
    // The stagger of the banks moves the planes of the pistons away from those of the pins.
    let [low, _] = even.couple.one_plane().unwrap();
    assert!((low.share - 0.366_025_403_784_438_6).abs() < 2e-3, "{}", low.share);
    assert!(even.force.indifferent());
    for name in ["v8-crossplane", "v6-90-odd"] {
        let factor = common_factor(&gallery(name), 0).unwrap();
        assert!((factor.couple.least_peak().unwrap() - 0.5).abs() < 1e-12, "{name}");
    }
    let four = common_factor(&gallery("in-line-4"), 0).unwrap();
    assert!(four.force.indifferent() && four.couple.indifferent());
    assert_eq!(four.couple.least_peak(), None);
}

/// In-line three at 120 degrees, spacing a: SUM z P e^{ia} is sqrt(3) a P; at 50 % the couple is half of it, backward.
#[test]
fn in_line_three_by_formula() {
    let engine = gallery("in-line-3");
    let factor = common_factor(&engine, 0).unwrap().couple;
    let whole = 3f64.sqrt() * 0.078 * 0.041 * (0.32 + 0.12);
    assert!((factor.per_share.norm() - whole).abs() < 1e-15);
    assert!((factor.peak(0.0) - whole).abs() < 1e-15);
    assert!((factor.peak(0.5) - 0.5 * whole).abs() < 1e-15);
    assert!((factor.peak(1.0) - whole).abs() < 1e-15);
    let [low, high] = factor.one_plane().unwrap();
    assert!(low.share.abs() < 1e-12 && (high.share - 1.0).abs() < 1e-12);
}

#[test]
fn a_crankshaft_that_is_not_there() {
    let error = common_factor(&gallery("single"), 3).unwrap_err().to_string();
    assert!(error.starts_with("there is no crankshaft 4") && error.contains("hint:"), "{error}");
}

proptest! {
    /// No factor beats the least peak; at the one-plane factors both parts are equal.
    #[test]
    fn prop_least_peak_is_least(bank in 0.0f64..3.1, split in -1.0f64..1.0, other in -2.0f64..2.0) {
        let effect = pin_pair_effect(bank, split);
        let best = effect.least_peak().unwrap();
        prop_assert!((best - 0.5).abs() < 1e-12);
        prop_assert!(effect.peak(other) >= effect.peak(best) - 1e-15);
        if let Some(pair) = effect.one_plane() {
            for plane in pair {
                let forward = (effect.forward - plane.share * effect.per_share).norm();
                prop_assert!((forward - effect.backward.norm()).abs() < 1e-12);
            }
        }
    }
}
