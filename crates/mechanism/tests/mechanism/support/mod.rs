//! What these tests of loads share.
#![allow(dead_code)]

pub mod brute;
pub mod mounted;
pub mod pressure;

use lanchester_mechanism::{LoadRequest, Mechanism, Part, Selection};
use lanchester_model::*;
use lanchester_results::Components;
use lanchester_testkit::Within;
pub use lanchester_testkit::hand_made::*;
pub use lanchester_testkit::random;
use std::f64::consts::{PI, TAU};

/// Asserts that `got` is `wanted` within `absolute + relative * |wanted|`.
///
/// `reason` says why that tolerance and no other. Fails also on anything that is not a number.
#[track_caller]
pub fn assert_close(quantity: &str, got: f64, wanted: f64, absolute: f64, relative: f64, reason: &str) {
    lanchester_testkit::assert_close(quantity, got, wanted, Within::share(relative, reason).and(absolute));
}

/// Angles for a search: `count` of them over a turn, off every symmetric place.
pub fn odd_angles(count: usize) -> impl Iterator<Item = f64> {
    (0..count).map(move |j| TAU * (j as f64 + 0.37) / count as f64 - PI)
}

/// The six components in the order of tables.
pub fn list(c: Components) -> [f64; 6] {
    [c.force_x, c.force_y, c.couple_x, c.couple_y, c.roll_moment, c.shaft_torque]
}

/// Largest value of each component of all parts, forces and moments apart: what rounding is measured against.
pub fn scales(engine: &Engine) -> [f64; 6] {
    let mut scale = [1e-6f64; 2];
    for part in Part::ALL {
        let mechanism = Mechanism::of(engine, &LoadRequest::default(), Selection::Part(part))
            .expect("the engine is valid");
        for theta in odd_angles(24) {
            let values = list(mechanism.components(theta)).map(f64::abs);
            scale[0] = scale[0].max(values[0]).max(values[1]);
            scale[1] = values[2..].iter().fold(scale[1], |s, v| s.max(*v));
        }
    }
    [scale[0], scale[0], scale[1], scale[1], scale[1], scale[1]]
}
