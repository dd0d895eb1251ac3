//! Order coefficients of a slider-crank within a small range of its geometry, as polynomials.
//!
//! `c_n` depends on the rod ratio `r/l` and on `e/l` alone (book, chapter 3). Within tolerances both move little, so that a
//! polynomial through a few points (of Chebyshev, in each direction) is as exact as the coefficients themselves; its
//! degree rises until it is, checked between the points.

use lanchester_mechanism::{LoadError, exact_coefficients};
use lanchester_numerics::{ComplexLanes, Lanes};
use num_complex::Complex64;

/// Largest error that is let stand, over `c_1 = 1`.
const EXACT: f64 = 2e-14;

/// Highest degree in one direction: reached only where tolerances are no small change.
const MOST: usize = 12;

/// Middle and half width of a range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Span {
    pub middle: f64,
    pub half: f64,
}

impl Span {
    fn at(self, unit: f64) -> f64 {
        self.middle + self.half * unit
    }

    fn unit(self, value: f64) -> f64 {
        if self.half > 0.0 { (value - self.middle) / self.half } else { 0.0 }
    }
}

/// Polynomials of the coefficients of some orders.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct CoefficientRange {
    ratio: Span,
    offset: Span,
    /// Number of powers of ratio and offset.
    powers: [usize; 2],
    /// By order, then power of the offset, then power of the ratio.
    terms: Vec<Complex64>,
    /// By order: whether it has an imaginary part.
    complex: Vec<bool>,
}

/// Powers of the polynomial through Chebyshev's points with these values: the inverse of their Vandermonde matrix.
fn powers_from_values(count: usize) -> Vec<Vec<f64>> {
    let points = points(count);
    // Lagrange's polynomials multiplied out.
    let mut rows = vec![vec![0.0; count]; count];
    for (k, &point) in points.iter().enumerate() {
        let mut product = vec![1.0];
        let mut scale = 1.0;
        for (j, &other) in points.iter().enumerate() {
            if j == k {
                continue;
            }
            scale *= point - other;
            let mut next = vec![0.0; product.len() + 1];
            for (power, value) in product.iter().enumerate() {
                next[power + 1] += value;
                next[power] -= other * value;
            }
            product = next;
        }
        for (power, value) in product.iter().enumerate() {
            rows[power][k] = value / scale;
        }
    }
    rows
}

fn points(count: usize) -> Vec<f64> {
    (0..count).map(|k| (std::f64::consts::PI * (k as f64 + 0.5) / count as f64).cos()).collect()
}

impl CoefficientRange {
    /// Polynomials of `orders` for a rod ratio and an offset over rod length in these ranges.
    pub fn new(ratio: Span, offset: Span, orders: &[u32]) -> Result<CoefficientRange, LoadError> {
        let counts = |span: Span, count: usize| if span.half > 0.0 { count } else { 1 };
        let mut count = 3;
        loop {
            let range =
                CoefficientRange::with(ratio, offset, orders, [counts(ratio, count), counts(offset, count)])?;
            if count == MOST || range.error(orders)? <= EXACT {
                return Ok(range);
            }
            count += 1;
        }
    }

    fn with(
        ratio: Span,
        offset: Span,
        orders: &[u32],
        powers: [usize; 2],
    ) -> Result<CoefficientRange, LoadError> {
        let highest = orders.iter().copied().max().unwrap_or(1);
        let mut values = Vec::new();
        for &v in &points(powers[1]) {
            for &u in &points(powers[0]) {
                values.push(exact_coefficients(ratio.at(u), 1.0, offset.at(v), highest)?);
            }
        }
        let (by_ratio, by_offset) = (powers_from_values(powers[0]), powers_from_values(powers[1]));
        let mut terms = Vec::with_capacity(orders.len() * powers[0] * powers[1]);
        for &order in orders {
            for q in 0..powers[1] {
                for p in 0..powers[0] {
                    let mut sum = Complex64::ZERO;
                    for j in 0..powers[1] {
                        for k in 0..powers[0] {
                            let weight = by_offset[q][j] * by_ratio[p][k];
                            sum += weight * values[j * powers[0] + k][order as usize];
                        }
                    }
                    terms.push(sum);
                }
            }
        }
        let complex = terms.chunks(powers[0] * powers[1]).map(|t| t.iter().any(|c| c.im != 0.0)).collect();
        Ok(CoefficientRange { ratio, offset, powers, terms, complex })
    }

    /// Largest error at places between the points, corners included.
    fn error(&self, orders: &[u32]) -> Result<f64, LoadError> {
        let highest = orders.iter().copied().max().unwrap_or(1);
        let mut worst = 0.0f64;
        for u in [-1.0, -0.6, 0.1, 0.7, 1.0] {
            for v in [-1.0, -0.3, 0.4, 1.0] {
                let (ratio, offset) = (self.ratio.at(u), self.offset.at(v));
                let exact = exact_coefficients(ratio, 1.0, offset, highest)?;
                for (place, &order) in orders.iter().enumerate() {
                    let got = self.at(place, &Lanes::all(ratio), &Lanes::all(offset));
                    let off = Complex64::new(got.re[0], got.im[0]) - exact[order as usize];
                    worst = worst.max(off.norm());
                }
            }
        }
        Ok(worst)
    }

    /// Size of the coefficient of the order at `place` in the middle of the ranges, and how far any two within the
    /// ranges may be apart at most.
    pub fn size_and_spread(&self, place: usize) -> [f64; 2] {
        let terms = &self.terms[place * self.powers[0] * self.powers[1]..][..self.powers[0] * self.powers[1]];
        // Every power of a place in the ranges lies between -1 and 1.
        [terms[0].norm(), 2.0 * terms[1..].iter().map(|term| term.norm()).sum::<f64>()]
    }

    /// Coefficient of the order at `place` in the middle of the ranges.
    pub fn middle(&self, place: usize) -> Complex64 {
        self.terms[place * self.powers[0] * self.powers[1]]
    }

    /// Coefficient of the order at `place` in the list.
    #[inline]
    pub fn at(&self, place: usize, ratio: &Lanes, offset: &Lanes) -> ComplexLanes {
        let u = Lanes::each(|i| self.ratio.unit(ratio[i]));
        let v = Lanes::each(|i| self.offset.unit(offset[i]));
        let [across, along] = self.powers;
        let terms = &self.terms[place * across * along..][..across * along];
        let mut sum = ComplexLanes::ZERO;
        for row in terms.chunks_exact(across).rev() {
            let mut re = Lanes::ZERO;
            for term in row.iter().rev() {
                re = Lanes::each(|i| re[i] * u[i] + term.re);
            }
            sum.re = Lanes::each(|i| sum.re[i] * v[i] + re[i]);
            if self.complex[place] {
                let mut im = Lanes::ZERO;
                for term in row.iter().rev() {
                    im = Lanes::each(|i| im[i] * u[i] + term.im);
                }
                sum.im = Lanes::each(|i| sum.im[i] * v[i] + im[i]);
            }
        }
        sum
    }
}
