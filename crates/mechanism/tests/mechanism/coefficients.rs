//! Order coefficients of the slider-crank: the literature's series, and the exact ones beside quadrature.
use crate::support::assert_close;
use lanchester_mechanism::{LoadError, exact_coefficients, series_coefficients};
use num_complex::Complex64;
use proptest::prelude::*;
use std::f64::consts::TAU;

#[test]
fn lit_louvigny_2008_equations_6_to_8() {
    let ratio = 0.3f64;
    let series = series_coefficients(ratio, 8, 5);
    let close = |name: &str, got: f64, wanted: f64| {
        assert_close(name, got, wanted, 0.0, 1e-14, "the same polynomial, rounding");
    };
    close("order 1", series[1], 1.0);
    close("A2", series[2], ratio + ratio.powi(3) / 4.0 + 15.0 * ratio.powi(5) / 128.0);
    close("A4", series[4], -ratio.powi(3) / 4.0 - 3.0 * ratio.powi(5) / 16.0);
    close("A6", series[6], 9.0 * ratio.powi(5) / 128.0);
    close("A2 to the first power", series_coefficients(ratio, 2, 1)[2], ratio);
    assert!(series[8] == 0.0 && series[3] == 0.0, "order 8 starts at the seventh power, odd orders vanish");
}

#[test]
fn series_tends_to_the_exact_coefficients() {
    let exact = exact_coefficients(0.3, 1.0, 0.0, 10).unwrap();
    let series = series_coefficients(0.3, 10, 60);
    for n in 0..=10 {
        // What is left out is below 0.3^61; rounding is relative to each coefficient, also the smallest.
        assert_close("coefficient", exact[n].re, series[n], 1e-30, 1e-13, "both exact to rounding");
        assert_close("imaginary part", exact[n].im, 0.0, 1e-30, 0.0, "a centred crank is symmetric");
    }
}

#[test]
fn high_orders_keep_their_relative_accuracy() {
    let exact = exact_coefficients(0.2, 1.0, 0.0, 30).unwrap();
    let series = series_coefficients(0.2, 30, 120);
    assert!(exact[30].norm() < 1e-20, "order 30 is far below the rounding of order 1");
    assert_close("order 30", exact[30].re, series[30], 0.0, 1e-12, "rounding");
}

#[test]
fn tiny_offsets_and_cranks_are_no_special_cases() {
    let tiny = exact_coefficients(0.3, 1.0, 1e-12, 5).unwrap();
    let small = exact_coefficients(0.3, 1.0, 1e-6, 5).unwrap();
    for n in [1, 3, 5] {
        let (a, b) = (tiny[n].im, small[n].im);
        assert_close(
            "odd orders grow with the offset",
            a * 1e6,
            b,
            0.0,
            1e-9,
            "cubic terms of the offset, 1e-12",
        );
    }
    let crank = exact_coefficients(1e-8, 1.0, 0.0, 4).unwrap();
    assert_close("A2 of a tiny crank", crank[2].re, 1e-8, 0.0, 1e-14, "A2 tends to r/l");
    assert_close("A4 of a tiny crank", crank[4].re, -0.25e-24, 0.0, 1e-14, "A4 tends to -(r/l)^3/4");
}

#[test]
fn a_rod_that_is_too_short_is_an_error() {
    assert!(matches!(exact_coefficients(0.05, 0.06, 0.02, 4), Err(LoadError::RodTooShort { .. })));
    assert!(
        exact_coefficients(0.0, 0.06, 0.0, 4).is_err() && exact_coefficients(f64::NAN, 1.0, 0.0, 4).is_err()
    );
    let text = exact_coefficients(0.05, 0.06, 0.02, 4).unwrap_err().to_string();
    assert!(text.starts_with("rod of cylinder 1 must be longer") && text.contains("hint: "), "{text}");
}

proptest! {
    #[test]
    fn prop_exact_coefficients_are_those_of_the_acceleration(
        radius in 0.01..0.1f64, factor in 1.2..5.0f64, offset in -0.03..0.03f64,
    ) {
        let length = factor * (radius + offset.abs());
        let coefficients = exact_coefficients(radius, length, offset, 12).unwrap();
        // Acceleration from the second derivative of the root, written out another way.
        let acceleration = |phi: f64| {
            let (sin, cos) = phi.sin_cos();
            let q = radius * sin - offset;
            let w2 = length * length - q * q;
            let slope = radius * cos;
            let bend = (slope * slope - q * radius * sin) / w2.sqrt() + q * q * slope * slope / w2.powf(1.5);
            (radius * cos + bend) / radius
        };
        let count = 1024;
        for (n, coefficient) in coefficients.iter().enumerate().skip(1) {
            let sum: Complex64 = (0..count)
                .map(|j| {
                    let phi = TAU * j as f64 / count as f64;
                    acceleration(phi) * Complex64::cis(-TAU * ((n * j) % count) as f64 / count as f64)
                })
                .sum();
            let wanted = sum * (2.0 / count as f64);
            let off = (coefficient - wanted).norm();
            assert_close("coefficient", off, 0.0, 1e-13, 0.0, "quadrature of 1024 angles, rounding of order 1");
        }
    }
}
