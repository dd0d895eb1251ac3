//! Random contours: stars about a random centre with bulging sides.

use lanchester_shape::{Contour, Corner, Point};
use proptest::prelude::*;

/// Corners on a circle, each with a bulge.
pub fn star(count: usize, radius: f64, bulges: &[f64]) -> Vec<Corner> {
    let angle = |k: usize| std::f64::consts::TAU * k as f64 / count as f64;
    (0..count).map(|k| Corner { at: Point::polar(radius, angle(k)), bulge: bulges[k] }).collect()
}

/// Stars with unequal rays and bulges from 1e-12 to more than half a turn, that do not cross themselves.
pub fn any_star() -> impl Strategy<Value = Vec<Corner>> {
    let bulge = prop_oneof![
        Just(0.0),
        (-12.0..-1.0f64, any::<bool>()).prop_map(|(power, out)| if out {
            10f64.powf(power)
        } else {
            -10f64.powf(power)
        }),
        -0.3..0.9f64,
        1.0..3.0f64,
    ];
    let rays = prop::collection::vec((0.02..0.09f64, bulge), 3..9);
    (rays, -0.05..0.05f64, -0.05..0.05f64)
        .prop_map(|(rays, x, y)| {
            let count = rays.len() as f64;
            let corner = |(k, (ray, bulge)): (usize, (f64, f64))| Corner {
                at: Point::new(x, y) + Point::polar(ray, std::f64::consts::TAU * (k as f64) / count),
                bulge,
            };
            rays.into_iter().enumerate().map(corner).collect::<Vec<_>>()
        })
        .prop_filter("it crosses itself", |corners| Contour::new(corners).is_ok())
}
