//! Moments of a circular segment without cancellation, however flat its arc is.
//!
//! Segment of half angle `a` over a chord of half length `w`; `s = sin a`, `c = cos a`; `n` along the bisector from the chord, `t` along
//! the chord, from its middle (book, eqs. (22.3) to (22.6)):
//!
//! ```text
//! area                w^2 (a - s c)/s^2
//! INTEGRAL n   dA     w^3 (s - s^3/3 - a c)/s^3
//! INTEGRAL n^2 dA     w^4 (3a/4 + (a/2) cos 2a - (7/12) sin 2a - (1/48) sin 4a)/s^4
//! INTEGRAL t^2 dA     w^4 (a/4 - (1/6) sin 2a + (1/48) sin 4a)/s^4
//! ```
//! The numerators are of order `a^3`, `a^5`, `a^7` and `a^5`, so that all digits are lost where they are evaluated as they
//! stand for a flat arc: below one radian their power series are summed, which begin at that order.

/// Half angle [rad] below which the series are summed: from there on the closed forms lose less than two digits.
const SERIES_BELOW: f64 = 1.0;
/// Terms of the series: the first one left out is below 1e-20 of the sum at one radian.
const TERMS: i32 = 14;

/// Integrals over a circular segment of half chord 1, from the middle of the chord.
#[derive(Debug, Clone, Copy)]
pub(crate) struct UnitSegment {
    /// Area.
    pub area: f64,
    /// `INTEGRAL n dA`.
    pub n: f64,
    /// `INTEGRAL n^2 dA`.
    pub nn: f64,
    /// `INTEGRAL t^2 dA`.
    pub tt: f64,
}

impl UnitSegment {
    /// Of half angle `a` within `(0, pi/2]`.
    pub fn of(a: f64) -> UnitSegment {
        let s = a.sin();
        let (s2, s4) = (s * s, s * s * s * s);
        UnitSegment { area: excess(a) / s2, n: lever(a) / (s2 * s), nn: across(a) / s4, tt: along(a) / s4 }
    }
}

/// `a - sin a cos a`: the area of the segment over the square of its radius.
pub(crate) fn excess(a: f64) -> f64 {
    if a < SERIES_BELOW { series(a, 1, |_, four| -four) } else { a - a.sin() * a.cos() }
}

/// `sin a - sin^3 a/3 - a cos a`.
fn lever(a: f64) -> f64 {
    if a < SERIES_BELOW {
        series(a, 2, |k, _| 0.75 + 9f64.powi(k) / 4.0 - f64::from(2 * k + 1))
    } else {
        let s = a.sin();
        s - s * s * s / 3.0 - a * a.cos()
    }
}

/// `3a/4 + (a/2) cos 2a - (7/12) sin 2a - (1/48) sin 4a`.
fn across(a: f64) -> f64 {
    if a < SERIES_BELOW {
        series(a, 3, |k, four| four * (f64::from(2 * k + 1) / 2.0 - 7.0 / 6.0 - four / 12.0))
    } else {
        0.75 * a + 0.5 * a * (2.0 * a).cos() - 7.0 / 12.0 * (2.0 * a).sin() - (4.0 * a).sin() / 48.0
    }
}

/// `a/4 - (1/6) sin 2a + (1/48) sin 4a`.
fn along(a: f64) -> f64 {
    if a < SERIES_BELOW {
        series(a, 2, |_, four| four * (four / 12.0 - 1.0 / 3.0))
    } else {
        0.25 * a - (2.0 * a).sin() / 6.0 + (4.0 * a).sin() / 48.0
    }
}

/// `SUM over k >= first of (-1)^k c(k) a^(2k+1)/(2k+1)!`; `c` is given `k` and `4^k`.
fn series(a: f64, first: i32, c: impl Fn(i32, f64) -> f64) -> f64 {
    let (mut power, mut four, mut sum) = (a, 1.0, 0.0);
    for k in 0..first + TERMS {
        if k >= first {
            sum += c(k, four) * power;
        }
        power *= -a * a / f64::from((2 * k + 2) * (2 * k + 3));
        four *= 4.0;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn series_and_closed_forms_meet_at_one_radian() {
        let below = UnitSegment::of(SERIES_BELOW.next_down());
        let above = UnitSegment::of(SERIES_BELOW);
        // The closed forms lose at most two digits here.
        for (b, a) in
            [(below.area, above.area), (below.n, above.n), (below.nn, above.nn), (below.tt, above.tt)]
        {
            assert!((b / a - 1.0).abs() < 3e-14, "{b} {a}");
        }
    }

    #[test]
    fn flat_arcs_tend_to_parabolas() {
        // A parabola of height H over the half chord 1: area 4 H/3, and 8/15 H^2, 32/105 H^3, 4/15 H; an arc has H = a/2.
        let a = 1e-6;
        let (segment, height) = (UnitSegment::of(a), a / 2.0);
        let parabola = [
            4.0 / 3.0 * height,
            8.0 / 15.0 * height.powi(2),
            32.0 / 105.0 * height.powi(3),
            4.0 / 15.0 * height,
        ];
        // They differ by a^2.
        for (ours, exact) in [segment.area, segment.n, segment.nn, segment.tt].into_iter().zip(parabola) {
            assert!((ours / exact - 1.0).abs() < 1e-11, "{ours} {exact}");
        }
    }

    #[test]
    fn half_disc_is_the_textbook_one() {
        use std::f64::consts::PI;
        let half = UnitSegment::of(PI / 2.0);
        for (ours, exact) in
            [(half.area, PI / 2.0), (half.n, 2.0 / 3.0), (half.nn, PI / 8.0), (half.tt, PI / 8.0)]
        {
            assert!((ours / exact - 1.0).abs() < 1e-15);
        }
    }
}
