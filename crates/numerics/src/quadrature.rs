//! Gauss-Legendre rules on an interval of length 1 about its middle.
//!
//! A rule of `n` points is exact for polynomials of degree `2 n - 1`. Points come in pairs: each entry has the distance from the middle and
//! the weight of each of the two; the weights of a rule, both of a pair counted, add up to 1.
//!
//! ```
//! use lanchester_numerics::{GAUSS_4, gauss};
//! // The integral of x^7 from 0 to 2 is 32.
//! assert!((gauss(&GAUSS_4, 0.0, 2.0, |x: f64| x.powi(7)) - 32.0).abs() < 1e-13);
//! ```
//!
//! Source: Abramowitz, Stegun, Handbook of Mathematical Functions, Table 25.4, halved.

/// One pair of points: distance from the middle and weight of each.
pub type GaussPair = (f64, f64);

/// Four points, exact to degree 7.
pub const GAUSS_4: [GaussPair; 2] = [
    (0.169_990_521_792_428_14, 0.326_072_577_431_273_1),
    (0.430_568_155_797_026_3, 0.173_927_422_568_726_93),
];

/// Eight points, exact to degree 15.
pub const GAUSS_8: [GaussPair; 4] = [
    (0.091_717_321_247_824_9, 0.181_341_891_689_181),
    (0.262_766_204_958_164_5, 0.156_853_322_938_943_64),
    (0.398_333_238_706_813_4, 0.111_190_517_226_687_24),
    (0.480_144_928_248_768_1, 0.050_614_268_145_188_13),
];

/// Sixteen points, exact to degree 31.
pub const GAUSS_16: [GaussPair; 8] = [
    (0.047_506_254_918_818_72, 0.094_725_305_227_534_25),
    (0.140_801_775_389_629_45, 0.091_301_707_522_461_8),
    (0.229_008_388_828_613_7, 0.084_578_259_697_501_27),
    (0.308_938_122_201_321_85, 0.074_797_994_408_288_37),
    (0.377_702_204_177_501_5, 0.062_314_485_627_766_94),
    (0.432_815_601_193_915_9, 0.047_579_255_841_246_39),
    (0.472_287_511_536_616_3, 0.031_126_761_969_323_946),
    (0.494_700_467_495_824_96, 0.013_576_229_705_877_047),
];

/// Places in `[0, 1]` of the points of a rule, with their weights.
pub fn unit_points(rule: &[GaussPair]) -> impl Iterator<Item = (f64, f64)> {
    rule.iter().flat_map(|&(x, weight)| [(0.5 - x, weight), (0.5 + x, weight)])
}

/// Integral of `function` from `from` to `to` by a rule of pairs.
pub fn gauss(rule: &[GaussPair], from: f64, to: f64, mut function: impl FnMut(f64) -> f64) -> f64 {
    let (middle, length) = (0.5 * (from + to), to - from);
    let pair =
        |&(x, weight): &GaussPair| weight * (function(middle - x * length) + function(middle + x * length));
    length * rule.iter().map(pair).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rules_are_exact_to_their_degree_and_no_further() {
        for (rule, points) in [(&GAUSS_4[..], 4), (&GAUSS_8[..], 8), (&GAUSS_16[..], 16)] {
            let integral = |degree: i32| gauss(rule, -0.4, 1.0, |x| x.powi(degree));
            let exact = |degree: i32| (1.0 - (-0.4_f64).powi(degree + 1)) / f64::from(degree + 1);
            for degree in 0..2 * points {
                assert!((integral(degree) - exact(degree)).abs() < 1e-15, "{points} points, degree {degree}");
            }
            let weights: f64 = unit_points(rule).map(|(_, weight)| weight).sum();
            assert!((weights - 1.0).abs() < 4e-16, "{points} points");
            if points < 16 {
                assert!((integral(2 * points) - exact(2 * points)).abs() > 1e-10, "{points} points");
            }
        }
    }
}
