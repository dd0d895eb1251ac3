//! Largest and least value of a sum of orders over a period, in true phase.

use num_complex::Complex64;
use std::f64::consts::TAU;

/// Samples in a wave of the highest order.
const DENSITY: usize = 12;

/// Cosines and sines of all orders over a quarter of the period, of which the other three follow by symmetry.
#[derive(Debug, Clone)]
pub(crate) struct Synthesis {
    count: usize,
    quarter: usize,
    cos: Vec<f64>,
    sin: Vec<f64>,
    sums: [Vec<f64>; 4],
    curve: Vec<f64>,
}

impl Synthesis {
    pub fn new(count: usize) -> Synthesis {
        let quarter = (DENSITY * count).div_ceil(4);
        let width = quarter + 1;
        let table = |of: fn(f64) -> f64| {
            (1..=count)
                .flat_map(|k| (0..width).map(move |j| of(TAU * (k * j) as f64 / (4 * quarter) as f64)))
                .collect()
        };
        Synthesis {
            count,
            quarter,
            cos: table(f64::cos),
            sin: table(f64::sin),
            sums: std::array::from_fn(|_| vec![0.0; width]),
            curve: vec![0.0; 4 * quarter],
        }
    }

    /// Largest and least value of `Re SUM a_k e^(i k psi)`.
    pub fn extremes(&mut self, orders: impl Iterator<Item = Complex64>) -> [f64; 2] {
        let width = self.quarter + 1;
        for sum in &mut self.sums {
            sum.fill(0.0);
        }
        let (mut only, mut several) = (0.0, 0);
        for (index, a) in orders.take(self.count).enumerate() {
            if a.re == 0.0 && a.im == 0.0 {
                continue;
            }
            (only, several) = (a.norm(), several + 1);
            let rows = index * width..(index + 1) * width;
            // Cosines of even orders, of odd ones, sines of even orders, of odd ones; order k = index + 1.
            let odd = (index + 1) % 2;
            for (sum, c) in self.sums[odd].iter_mut().zip(&self.cos[rows.clone()]) {
                *sum += a.re * c;
            }
            for (sum, s) in self.sums[2 + odd].iter_mut().zip(&self.sin[rows]) {
                *sum -= a.im * s;
            }
        }
        if several < 2 {
            return [only, -only];
        }
        let (q, n) = (self.quarter, 4 * self.quarter);
        for j in 0..=q {
            let [ce, co, se, so] = [0, 1, 2, 3].map(|which: usize| self.sums[which][j]);
            self.curve[j] = ce + co + se + so;
            self.curve[(n - j) % n] = ce + co - se - so;
            self.curve[2 * q - j] = ce - co - se + so;
            self.curve[2 * q + j] = ce - co + se - so;
        }
        let (mut top, mut bottom) = (0, 0);
        for (index, value) in self.curve.iter().enumerate() {
            if *value > self.curve[top] {
                top = index;
            }
            if *value < self.curve[bottom] {
                bottom = index;
            }
        }
        [self.vertex(top), self.vertex(bottom)]
    }

    /// Value of the parabola through a sample and its neighbours at its vertex.
    fn vertex(&self, index: usize) -> f64 {
        let n = self.curve.len();
        let [before, here, after] = [index + n - 1, index, index + 1].map(|i| self.curve[i % n]);
        let bend = before - 2.0 * here + after;
        let slope = 0.5 * (after - before);
        if bend == 0.0 { here } else { here - 0.5 * slope * slope / bend }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extremes_are_those_of_a_fine_grid() {
        let orders: Vec<Complex64> =
            (1..=24).map(|k| Complex64::from_polar(1.0 / f64::from(k), f64::from(k * k) * 0.37)).collect();
        let at = |psi: f64| {
            orders.iter().enumerate().map(|(k, a)| (a * Complex64::cis((k + 1) as f64 * psi)).re).sum::<f64>()
        };
        let grid = (0..200_000).map(|j| at(TAU * f64::from(j) / 200_000.0));
        let (top, bottom) = grid.fold((f64::MIN, f64::MAX), |(t, b), x| (t.max(x), b.min(x)));
        let found = Synthesis::new(24).extremes(orders.iter().copied());
        // A parabola through samples 1/12 of the shortest wave apart.
        assert!((found[0] - top).abs() < 1e-3 * top, "{} instead of {top}", found[0]);
        assert!((found[1] - bottom).abs() < 1e-3 * bottom.abs(), "{} instead of {bottom}", found[1]);
    }

    #[test]
    fn one_order_alone_has_its_exact_amplitude() {
        let mut orders = vec![Complex64::default(); 7];
        orders[4] = Complex64::new(0.3, -0.4);
        assert_eq!(Synthesis::new(7).extremes(orders.into_iter()), [0.5, -0.5]);
    }
}
