//! Periodic functions of an angle in cubic pieces: pressures, and all that is integrated from them.
//!
//! ```text
//! y(t) = a_i + b_i u + c_i u^2 + d_i u^3,   u = t - t_i,   t_i <= t < t_(i+1)            (23.1)
//! ```
//! The last piece reaches to the first knot of the next period. Neighbouring pieces may jump: a cycle with heat released at
//! constant volume does.

use crate::spline;
use lanchester_numerics::GAUSS_8;
use num_complex::Complex64;
use serde::Serialize;
use std::f64::consts::TAU;

/// A periodic function of an angle [rad], cubic from knot to knot.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PeriodicCurve {
    period: f64,
    knots: Vec<f64>,
    pieces: Vec<[f64; 4]>,
    /// By equal parts of the period, as many as there are knots: the piece in which each begins.
    #[serde(skip)]
    begins_in: Vec<u32>,
}

/// Why there is no such curve.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{quantity} must be {needed}, got {got}")]
pub struct CurveError {
    /// Which quantity.
    pub quantity: &'static str,
    /// What is possible.
    pub needed: &'static str,
    /// What it was.
    pub got: f64,
}

/// Value and slope at one end of a piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct End {
    /// Value.
    pub value: f64,
    /// Derivative with respect to the angle [1/rad].
    pub slope: f64,
}

impl PeriodicCurve {
    /// The same value everywhere.
    ///
    /// # Errors
    /// Period not positive or a value that is not finite.
    pub fn constant(period: f64, value: f64) -> Result<PeriodicCurve, CurveError> {
        PeriodicCurve::new(period, vec![0.0], vec![[value, 0.0, 0.0, 0.0]])
    }

    /// Through `values` at `knots`, twice continuously differentiable: the periodic cubic spline.
    ///
    /// # Errors
    /// Fewer than three knots, knots that do not rise or span a whole period, values that are not finite.
    pub fn through(period: f64, knots: Vec<f64>, values: &[f64]) -> Result<PeriodicCurve, CurveError> {
        let refuse = |quantity, needed, got| Err(CurveError { quantity, needed, got });
        if knots.len() < 3 {
            return refuse("number of knots", "at least 3", knots.len() as f64);
        }
        if values.len() != knots.len() {
            return refuse("number of values", "that of the knots", values.len() as f64);
        }
        check(period, &knots, values.iter())?;
        let pieces = spline::pieces(period, &knots, values);
        PeriodicCurve::new(period, knots, pieces)
    }

    /// Each piece from the values and slopes at its two ends; neighbours may jump.
    ///
    /// # Errors
    /// As for [`PeriodicCurve::through`], but one knot is enough.
    pub fn from_ends(period: f64, knots: Vec<f64>, ends: &[[End; 2]]) -> Result<PeriodicCurve, CurveError> {
        if ends.len() != knots.len() {
            let got = ends.len() as f64;
            return Err(CurveError { quantity: "number of pieces", needed: "that of the knots", got });
        }
        let pieces = ends.iter().enumerate().map(|(i, [from, to])| {
            let h = step(period, &knots, i);
            let mean = (to.value - from.value) / h;
            let c = (3.0 * mean - 2.0 * from.slope - to.slope) / h;
            let d = (from.slope + to.slope - 2.0 * mean) / (h * h);
            [from.value, from.slope, c, d]
        });
        let pieces = pieces.collect();
        PeriodicCurve::new(period, knots, pieces)
    }

    fn new(period: f64, knots: Vec<f64>, pieces: Vec<[f64; 4]>) -> Result<PeriodicCurve, CurveError> {
        check(period, &knots, pieces.iter().flatten())?;
        let parts = knots.len();
        let mut piece = 0;
        let begins_in = (0..parts).map(|part| {
            let begin = knots[0] + period * part as f64 / parts as f64;
            while knots.get(piece + 1).is_some_and(|next| *next <= begin) {
                piece += 1;
            }
            piece as u32
        });
        let begins_in = begins_in.collect();
        Ok(PeriodicCurve { period, knots, pieces, begins_in })
    }

    /// Its period [rad].
    pub fn period(&self) -> f64 {
        self.period
    }

    /// Its knots [rad], rising, within one period. Between them it has all derivatives.
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// Its pieces: angle of the first end, length, coefficients of eq. (23.1).
    pub fn pieces(&self) -> impl Iterator<Item = (f64, f64, [f64; 4])> + '_ {
        let ends = self.knots.iter().zip(&self.pieces).enumerate();
        ends.map(|(i, (knot, piece))| (*knot, step(self.period, &self.knots, i), *piece))
    }

    /// The piece in which `t` lies, and how far beyond its first knot.
    fn place(&self, t: f64) -> (usize, f64) {
        let from = self.knots[0];
        let ahead = t - from;
        let beyond = if (0.0..self.period).contains(&ahead) { ahead } else { ahead.rem_euclid(self.period) };
        let turned = if beyond < self.period { beyond + from } else { from };
        let parts = self.knots.len();
        let part = (((turned - from) / self.period * parts as f64) as usize).min(parts - 1);
        let mut piece = self.begins_in[part] as usize;
        // The part may be one off by rounding; what is no number stays where it is.
        while piece > 0 && turned < self.knots[piece] {
            piece -= 1;
        }
        while self.knots.get(piece + 1).is_some_and(|next| *next <= turned) {
            piece += 1;
        }
        (piece, turned - self.knots[piece])
    }

    /// Value at `t`; at a jump the value after it.
    pub fn at(&self, t: f64) -> f64 {
        let (i, u) = self.place(t);
        let [a, b, c, d] = self.pieces[i];
        a + u * (b + u * (c + u * d))
    }

    /// Values at `from`, `from + step` and on, with `step` not negative: one walk along the pieces.
    pub fn samples(&self, from: f64, step: f64) -> CurveSamples<'_> {
        let (piece, u) = self.place(from);
        CurveSamples { curve: self, piece, u, step, length: self::step(self.period, &self.knots, piece) }
    }

    /// Derivative at `t`; at a knot that of the piece after it.
    pub fn slope(&self, t: f64) -> f64 {
        let (i, u) = self.place(t);
        let [_, b, c, d] = self.pieces[i];
        b + u * (2.0 * c + u * 3.0 * d)
    }

    /// Mean over the period, exact.
    pub fn mean(&self) -> f64 {
        let piece = |(_, h, [a, b, c, d]): (f64, f64, [f64; 4])| {
            h * (a + h * (b / 2.0 + h * (c / 3.0 + h * d / 4.0)))
        };
        self.pieces().map(piece).sum::<f64>() / self.period
    }

    /// Coefficient of `exp(i n 2 pi t / period)`; the mean for `n = 0`.
    ///
    /// ```text
    /// y_n = 1/P INTEGRAL over a period of y(t) exp(-i n 2 pi t/P) dt                     (23.2)
    /// ```
    pub fn coefficient(&self, n: i32) -> Complex64 {
        let rate = TAU * f64::from(n) / self.period;
        // Points of the rule lie in pairs about the middle of a part; their turns from there are those of the part before, as a rule.
        let (mut turned, mut turns) = (f64::NAN, [Complex64::ONE; 4]);
        let mut sum = Complex64::ZERO;
        for (from, h, [a, b, c, d]) in self.pieces() {
            let parts = (rate.abs() * h / 2.0).ceil().max(1.0);
            let width = h / parts;
            if width != turned {
                (turned, turns) = (width, GAUSS_8.map(|(x, _)| Complex64::cis(rate * width * x)));
            }
            for k in 0..parts as usize {
                let middle = width * (k as f64 + 0.5);
                let value = |u: f64| a + u * (b + u * (c + u * d));
                let pair = |((x, weight), turn): (&(f64, f64), &Complex64)| {
                    let (before, after) = (value(middle - width * x), value(middle + width * x));
                    weight * (turn * before + turn.conj() * after)
                };
                let part: Complex64 = GAUSS_8.iter().zip(&turns).map(pair).sum();
                sum += width * part * Complex64::cis(-rate * (from + middle));
            }
        }
        sum / self.period
    }

    /// Smallest and largest value, each with an angle where it is attained, exact for the pieces.
    pub fn extremes(&self) -> [(f64, f64); 2] {
        let mut smallest = (f64::INFINITY, 0.0);
        let mut largest = (f64::NEG_INFINITY, 0.0);
        for (from, h, [a, b, c, d]) in self.pieces() {
            for u in stationary(b, c, d).into_iter().filter(|u| *u > 0.0 && *u < h).chain([0.0, h]) {
                let value = a + u * (b + u * (c + u * d));
                let angle = (from + u).rem_euclid(self.period);
                if value < smallest.0 {
                    smallest = (value, angle);
                }
                if value > largest.0 {
                    largest = (value, angle);
                }
            }
        }
        [smallest, largest]
    }

    /// Weighted sum of curves of one period: exact, on the knots of all.
    ///
    /// # Errors
    /// No curve, or different periods.
    pub fn sum(terms: &[(f64, &PeriodicCurve)]) -> Result<PeriodicCurve, CurveError> {
        let Some((_, first)) = terms.first() else {
            return Err(CurveError { quantity: "number of curves", needed: "at least 1", got: 0.0 });
        };
        let period = first.period;
        if let Some((_, other)) = terms.iter().find(|(_, curve)| curve.period != period) {
            let got = other.period;
            return Err(CurveError { quantity: "period [rad]", needed: "the same for all curves", got });
        }
        let turned =
            terms.iter().flat_map(|(_, curve)| curve.knots.iter().map(|knot| knot.rem_euclid(period)));
        let mut knots: Vec<f64> = turned.filter(|knot| *knot < period).collect();
        knots.sort_by(f64::total_cmp);
        // Knots that differ by rounding alone are one.
        knots.dedup_by(|next, knot| *next - *knot <= 1e-12 * period);
        let pieces: Vec<[f64; 4]> = (0..knots.len())
            .map(|i| {
                // The middle of the piece tells which piece of each term it lies in.
                let middle = knots[i] + step(period, &knots, i) / 2.0;
                let mut sum = [0.0; 4];
                for (weight, curve) in terms {
                    let (piece, beyond) = curve.place(middle);
                    let u = beyond - step(period, &knots, i) / 2.0;
                    for (sum, value) in sum.iter_mut().zip(moved(curve.pieces[piece], u)) {
                        *sum += weight * value;
                    }
                }
                sum
            })
            .collect();
        PeriodicCurve::new(period, knots, pieces)
    }

    /// The same curve, `by` later: its value at `t + by` is that of this curve at `t`.
    pub fn delayed(&self, by: f64) -> PeriodicCurve {
        PeriodicCurve { knots: self.knots.iter().map(|knot| knot + by).collect(), ..self.clone() }
    }
}

/// Angles closer than this [rad] are one on a walk.
const ROUNDING: f64 = 1e-10;

/// A walk along a curve in equal steps.
pub struct CurveSamples<'a> {
    curve: &'a PeriodicCurve,
    piece: usize,
    u: f64,
    step: f64,
    length: f64,
}

impl CurveSamples<'_> {
    /// The value here; then a step further.
    #[inline]
    pub fn advance(&mut self) -> f64 {
        // A knot that is missed by rounding is reached: all cylinders that fire alike see a jump on the same side.
        while self.u >= self.length - ROUNDING {
            self.u -= self.length;
            self.piece = if self.piece + 1 == self.curve.knots.len() { 0 } else { self.piece + 1 };
            self.length = step(self.curve.period, &self.curve.knots, self.piece);
        }
        let [a, b, c, d] = self.curve.pieces[self.piece];
        let u = self.u;
        self.u += self.step;
        a + u * (b + u * (c + u * d))
    }
}

/// The same cubic about a point `u` further on.
fn moved([a, b, c, d]: [f64; 4], u: f64) -> [f64; 4] {
    [a + u * (b + u * (c + u * d)), b + u * (2.0 * c + 3.0 * u * d), c + 3.0 * u * d, d]
}

/// Where a cubic with these coefficients has no slope.
fn stationary(b: f64, c: f64, d: f64) -> Vec<f64> {
    let root = c * c - 3.0 * b * d;
    if root < 0.0 {
        return Vec::new();
    }
    // Without cancellation; a quotient without sense is no root.
    let q = -(c + c.signum() * root.sqrt());
    [q / (3.0 * d), b / q].into_iter().filter(|u| u.is_finite()).collect()
}

/// Length of a piece.
fn step(period: f64, knots: &[f64], piece: usize) -> f64 {
    match knots.get(piece + 1) {
        Some(next) => next - knots[piece],
        None => knots[0] + period - knots[piece],
    }
}

fn check<'a>(
    period: f64,
    knots: &[f64],
    mut values: impl Iterator<Item = &'a f64>,
) -> Result<(), CurveError> {
    let refuse = |quantity, needed, got| Err(CurveError { quantity, needed, got });
    if !(period > 0.0 && period.is_finite()) {
        return refuse("period [rad]", "positive", period);
    }
    if knots.is_empty() {
        return refuse("number of knots", "at least 1", 0.0);
    }
    if let Some(knot) = knots.iter().find(|knot| !knot.is_finite()) {
        return refuse("knot [rad]", "finite", *knot);
    }
    let short = (0..knots.len()).map(|i| step(period, knots, i)).find(|step| step.is_nan() || *step <= 0.0);
    if let Some(step) = short {
        return refuse("distance of neighbouring knots [rad]", "positive, all within one period", step);
    }
    match values.find(|value| !value.is_finite()) {
        Some(value) => refuse("value", "finite", *value),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn uneven(count: usize) -> Vec<f64> {
        (0..count).map(|k| TAU * (k as f64 + 0.3 * (k as f64).sin()) / count as f64).collect()
    }

    fn sampled(count: usize, function: impl Fn(f64) -> f64) -> PeriodicCurve {
        let knots = uneven(count);
        let values: Vec<f64> = knots.iter().map(|t| function(*t)).collect();
        PeriodicCurve::through(TAU, knots, &values).expect("rising knots")
    }

    #[test]
    fn a_sine_is_followed_to_the_fourth_order() {
        let worst = |count: usize| {
            let curve = sampled(count, f64::sin);
            (0..997).map(|k| f64::from(k) * 0.0271).map(|t| (curve.at(t) - t.sin()).abs()).fold(0.0, f64::max)
        };
        let (coarse, fine) = (worst(40), worst(80));
        assert!(coarse < 1e-5 && fine < coarse / 12.0, "{coarse:e} {fine:e}");
    }

    proptest! {
        /// Knots that crowd anywhere within the period, near either end too; angles between any two of them, some periods away.
        #[test]
        fn prop_the_piece_is_that_between_its_knots(
            steps in proptest::collection::vec(-5.0f64..0.0, 1..40),
            first in -3.0f64..3.0,
            at in proptest::collection::vec((0usize..40, 0.001f64..0.999, -3i32..4), 20),
        ) {
            let lengths: Vec<f64> = steps.iter().map(|power| 10f64.powf(*power)).collect();
            let whole: f64 = lengths.iter().sum();
            let mut knots = vec![first];
            for length in &lengths[1..] {
                knots.push(knots[knots.len() - 1] + TAU * length / whole);
            }
            let pieces = (0..knots.len()).map(|k| [k as f64, 0.0, 0.0, 0.0]).collect();
            let curve = PeriodicCurve::new(TAU, knots.clone(), pieces).expect("knots rise");
            for (knot, share, turns) in at {
                let knot = knot % knots.len();
                let length = knots.get(knot + 1).unwrap_or(&(first + TAU)) - knots[knot];
                let t = knots[knot] + share * length + TAU * f64::from(turns);
                prop_assert_eq!(curve.at(t), knot as f64, "{} of {:?}", t, knots);
            }
        }
    }

    #[test]
    fn coefficients_of_a_sawtooth() {
        // y = t on [0, 2 pi): y_n = i/n.
        let ends = [[End { value: 0.0, slope: 1.0 }, End { value: TAU, slope: 1.0 }]];
        let curve = PeriodicCurve::from_ends(TAU, vec![0.0], &ends).expect("a curve");
        for n in 1..40 {
            let expected = Complex64::new(0.0, 1.0 / f64::from(n));
            assert!((curve.coefficient(n) - expected).norm() < 1e-13, "{n}: {}", curve.coefficient(n));
            assert!((curve.coefficient(-n) - expected.conj()).norm() < 1e-13);
        }
        assert!(
            (curve.mean() - TAU / 2.0).abs() < 1e-14 && (curve.coefficient(0) - TAU / 2.0).norm() < 1e-13
        );
        let [(least, _), (most, _)] = curve.extremes();
        assert!(least == 0.0 && (most - TAU).abs() < 1e-14, "a jump has both its ends");
    }

    #[test]
    fn bad_knots_are_refused() {
        for (period, knots) in [(TAU, vec![0.0, 1.0]), (TAU, vec![0.0, 2.0, 1.0]), (2.0, vec![0.0, 1.0, 2.0])]
        {
            let values = vec![0.0; knots.len()];
            assert!(PeriodicCurve::through(period, knots, &values).is_err());
        }
        assert!(PeriodicCurve::constant(f64::NAN, 1.0).is_err());
        assert!(PeriodicCurve::constant(1.0, f64::INFINITY).is_err());
    }

    proptest! {
        #[test]
        fn prop_values_slopes_and_bends_meet_at_every_knot(
            values in proptest::collection::vec(-5.0..5.0f64, 3..40), start in -9.0..9.0f64,
        ) {
            let knots: Vec<f64> = uneven(values.len()).into_iter().map(|t| t + start).collect();
            let curve = PeriodicCurve::through(TAU, knots.clone(), &values).expect("rising knots");
            let pieces: Vec<_> = curve.pieces().collect();
            for (i, (knot, value)) in knots.iter().zip(&values).enumerate() {
                prop_assert!((curve.at(*knot) - value).abs() < 1e-12 * 50.0);
                prop_assert!((curve.at(knot + 3.0 * TAU) - value).abs() < 1e-9);
                let (_, h, piece) = pieces[i];
                let end = moved(piece, h);
                let next = pieces[(i + 1) % pieces.len()].2;
                for k in 0..3 {
                    let scale = 1.0 + end[k].abs();
                    prop_assert!((end[k] - next[k]).abs() < 1e-9 * scale, "{k}: {} {}", end[k], next[k]);
                }
            }
        }

        /// Exact for the pieces: Simpson's rule is exact for a cubic.
        #[test]
        fn prop_the_mean_is_the_integral(values in proptest::collection::vec(-5.0..5.0f64, 3..40)) {
            let curve = PeriodicCurve::through(TAU, uneven(values.len()), &values).expect("rising knots");
            let simpson = |(_, h, piece): (f64, f64, [f64; 4])| {
                (piece[0] + 4.0 * moved(piece, h / 2.0)[0] + moved(piece, h)[0]) * h / 6.0
            };
            prop_assert!((curve.pieces().map(simpson).sum::<f64>() / TAU - curve.mean()).abs() < 1e-12 * 50.0);
            prop_assert!((curve.coefficient(0).re - curve.mean()).abs() < 1e-12 * 50.0);
        }

        #[test]
        fn prop_a_sum_is_the_sum(
            one in proptest::collection::vec(-5.0..5.0f64, 3..20),
            two in proptest::collection::vec(-5.0..5.0f64, 3..20),
            by in -9.0..9.0f64, t in -9.0..9.0f64,
        ) {
            let one = PeriodicCurve::through(TAU, uneven(one.len()), &one).expect("rising knots");
            let two = PeriodicCurve::through(TAU, uneven(two.len()), &two).expect("rising knots").delayed(by);
            let sum = PeriodicCurve::sum(&[(2.0, &one), (-0.5, &two)]).expect("one period");
            prop_assert!((sum.at(t) - (2.0 * one.at(t) - 0.5 * two.at(t))).abs() < 1e-9);
            prop_assert!((two.at(t + by) - two.delayed(-by).at(t)).abs() < 1e-9);
        }

        #[test]
        fn prop_nothing_lies_beyond_the_extremes(
            values in proptest::collection::vec(-5.0..5.0f64, 3..20), t in 0.0..TAU,
        ) {
            let curve = PeriodicCurve::through(TAU, uneven(values.len()), &values).expect("rising knots");
            let [(least, at_least), (most, at_most)] = curve.extremes();
            prop_assert!(curve.at(t) >= least - 1e-12 && curve.at(t) <= most + 1e-12);
            prop_assert!((curve.at(at_least) - least).abs() < 1e-9 && (curve.at(at_most) - most).abs() < 1e-9);
        }
    }
}
