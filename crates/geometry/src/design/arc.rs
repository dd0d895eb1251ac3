//! Integrals over a circular segment whose chord is 2, and their derivatives by half its angle.
//!
//! With `a` half the angle, `c = cot a`, `q = 1/sin^2 a`, `u = 1 - a c`:
//!
//! ```text
//! area e1 = a q - c     first moment about the chord e2 = u q - 1/3     polar moment about its middle e3 = q (3/2 e1 - a)
//! ```
//! The power series of `1 - a cot a` and of `1/sin^2 a` have positive coefficients only, and so have these three: each of their derivatives
//! grows with `a`, so that over an interval of angles it is largest and smallest at its ends (book, eq. 22.31).

/// Half angle [rad] below which the series are summed: the first term left out is below 1e-17 there, in the third derivative too.
const SERIES_BELOW: f64 = 0.8;
/// Coefficients of `1 - a cot a = SUM p_n a^2n`, n from 1: `2 zeta(2n)/pi^2n`.
const COTANGENT: [f64; 18] = [
    0.333_333_333_333_333_3,
    0.022_222_222_222_222_223,
    0.002_116_402_116_402_116_5,
    0.000_211_640_211_640_211_65,
    2.137_779_915_557_693_5e-5,
    2.164_404_280_806_397_2e-6,
    2.192_594_785_187_377_8e-7,
    2.221_460_878_997_967_8e-8,
    2.250_784_651_680_899_4e-9,
    2.280_515_120_459_218_3e-10,
    2.310_643_259_900_262_4e-11,
    2.341_170_681_982_488_2e-12,
    2.372_101_740_023_365_3e-13,
    2.403_441_533_330_770_5e-14,
    2.435_195_402_918_336_7e-15,
    2.467_368_804_517_207_5e-16,
    2.499_967_277_122_081e-17,
    2.532_996_435_740_635e-18,
];

/// Derivatives of an order from 0 to 2 of area, first moment and polar moment. The angle lies within [0, pi[.
pub(super) fn segment(angle: f64, order: usize) -> [f64; 3] {
    let (sine, cosine) = angle.sin_cos();
    if angle == 0.0 {
        // The cubic parabola's segment: 2 a/3, 2 a^2/15, 2 a/15.
        return [[0.0, 0.0, 0.0], [2.0 / 3.0, 0.0, 2.0 / 15.0], [0.0, 4.0 / 15.0, 0.0]][order];
    }
    let (c, q) = (cosine / sine, 1.0 / (sine * sine));
    let [area, lever] = if angle < SERIES_BELOW { series(angle) } else { closed(angle, c, q) };
    // lever: v = 3/2 e1 - a, of which e2 is a third of the derivative.
    let [v, v1, v2, _] = lever;
    let polar = match order {
        0 => q * v,
        1 => q * (v1 - 2.0 * c * v),
        _ => q * (v2 + 2.0 * q * v - 4.0 * c * v1 + 4.0 * c * c * v),
    };
    [area[order], lever[order + 1] / 3.0, polar]
}

/// Area and `3/2 area - a`, each with three derivatives, by their power series.
fn series(angle: f64) -> [[f64; 4]; 2] {
    let square = angle * angle;
    let mut sums = [0.0; 4];
    // SUM of 2 n p_n a^(2n-1) from n = 2, Horner's rule from the last.
    for n in (1..COTANGENT.len()).rev() {
        let power = 2.0 * n as f64 + 1.0;
        let mut coefficient = (power + 1.0) * COTANGENT[n];
        for (order, sum) in sums.iter_mut().enumerate() {
            *sum = *sum * square + coefficient;
            coefficient *= power - order as f64;
        }
    }
    let cube = square * angle;
    let [d0, d1, d2, d3] = [sums[0] * cube, sums[1] * square, sums[2] * angle, sums[3]];
    let first = 2.0 * COTANGENT[0];
    [[d0 + first * angle, d1 + first, d2, d3], [d0, d1, d2, d3].map(|d| 1.5 * d)]
}

/// The same by closed forms.
fn closed(angle: f64, c: f64, q: f64) -> [[f64; 4]; 2] {
    let u = 1.0 - angle * c;
    let e = angle * q - c;
    let e1 = 2.0 * q * u;
    let e2 = 2.0 * q * (e - 2.0 * c * u);
    let e3 = 8.0 * q * (q * u + c * c * u - c * e);
    [[e, e1, e2, e3], [1.5 * e - angle, 1.5 * e1 - 1.0, 1.5 * e2, 1.5 * e3]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn conv_integrals_are_those_of_the_circle() {
        // Simpson's rule over the segment's height in an angle that smooths its ends.
        for angle in [0.05, 0.4, 0.799, 0.801, 1.6, 2.5, 3.0f64] {
            let (radius, depth) = (1.0 / angle.sin(), angle.cos() / angle.sin());
            let steps = 4000;
            let mut sums = [0.0; 3];
            for k in 0..=steps {
                let weight = if k == 0 || k == steps { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
                let theta = angle * f64::from(k) / f64::from(steps);
                let (half, height) = (radius * theta.sin(), radius * theta.cos() - depth);
                // Strip of width 2 half and thickness radius sin(theta) dtheta.
                let strip = weight * 2.0 * half * radius * theta.sin();
                sums[0] += strip;
                sums[1] += strip * height;
                sums[2] += strip * (height * height + half * half / 3.0);
            }
            let exact = segment(angle, 0);
            for (sum, exact) in sums.iter().zip(exact) {
                let sum = sum * angle / f64::from(steps) / 3.0;
                assert!((sum / exact - 1.0).abs() < 1e-10, "{angle}: {sum} {exact}");
            }
        }
    }

    #[test]
    fn derivatives_are_finite_differences_and_both_ways_meet() {
        for order in 0..2 {
            for angle in [0.02, 0.3, 0.9, 1.2, 2.0, 2.9] {
                let step = 1e-5;
                let (plus, minus) = (segment(angle + step, order), segment(angle - step, order));
                let exact = segment(angle, order + 1);
                for k in 0..3 {
                    let difference = (plus[k] - minus[k]) / (2.0 * step);
                    assert!(
                        (difference - exact[k]).abs() < 1e-5 * (1.0 + exact[k].abs()),
                        "{order} {angle} {k}"
                    );
                }
            }
        }
        let (below, above) = (SERIES_BELOW.next_down(), SERIES_BELOW);
        for order in 0..3 {
            for (a, b) in segment(below, order).iter().zip(segment(above, order)) {
                assert!((a - b).abs() < 1e-13, "{order}: {a} {b}");
            }
        }
    }

    #[test]
    fn every_derivative_grows_with_the_angle() {
        for order in 0..3 {
            let mut last = segment(0.0, order);
            for k in 1..3000 {
                let next = segment(f64::from(k) * 1e-3, order);
                for (last, next) in last.iter().zip(next) {
                    assert!(next > last - 1e-11, "{order} {k}");
                }
                last = next;
            }
        }
    }
}
