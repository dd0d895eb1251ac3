//! Orders of what is sampled at equal steps of the crank angle, two-sided: what turns with the crank and what turns against it.
//!
//! ```text
//! F(theta) = SUM over orders ( forward e^{i n theta} + backward e^{-i n theta} )
//! c_n = (1/N) SUM over samples  F(theta_k) e^{-i n theta_k}
//! ```
//! Source: the discrete Fourier series of a periodic function; exact for orders below half the number of samples a revolution.

use num_complex::Complex64;
use std::f64::consts::TAU;

/// A vector of one order in the plane across the crank.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TwoSided {
    /// Part that turns with the crank; of order 0 the whole mean.
    pub forward: Complex64,
    /// Part that turns against the crank; 0 for order 0.
    pub backward: Complex64,
}

impl TwoSided {
    /// Of the samples of a vector `F_x + i F_y` at equal steps of the crank angle over `revolutions` from the angle `start` [rad] on, end point
    /// excluded. `order` counts cycles a revolution; with the samples it must have whole cycles in them.
    ///
    /// ```
    /// use lanchester_results::TwoSided;
    /// use num_complex::Complex64;
    /// use std::f64::consts::TAU;
    /// // 3 turns with the crank, 2 i turns twice as fast against it.
    /// let samples: Vec<Complex64> = (0..16)
    ///     .map(|k| TAU * f64::from(k) / 16.0)
    ///     .map(|theta| 3.0 * Complex64::cis(theta) + Complex64::new(0.0, 2.0) * Complex64::cis(-2.0 * theta))
    ///     .collect();
    /// let [first, second] = [1.0, 2.0].map(|order| TwoSided::of_samples(&samples, 0.0, 1.0, order));
    /// assert!((first.forward - 3.0).norm() < 1e-14 && first.backward.norm() < 1e-14);
    /// assert!((second.backward - Complex64::new(0.0, 2.0)).norm() < 1e-14 && second.forward.norm() < 1e-14);
    /// ```
    pub fn of_samples(samples: &[Complex64], start: f64, revolutions: f64, order: f64) -> TwoSided {
        let of = |order: f64| coefficient(samples.iter().copied(), samples.len(), start, revolutions, order);
        if order == 0.0 {
            TwoSided { forward: of(0.0), backward: Complex64::ZERO }
        } else {
            TwoSided { forward: of(order), backward: of(-order) }
        }
    }

    /// Largest amount over the cycle: major half axis of its ellipse.
    pub fn peak(&self) -> f64 {
        self.forward.norm() + self.backward.norm()
    }
}

impl std::ops::Sub for TwoSided {
    type Output = TwoSided;
    fn sub(self, other: TwoSided) -> TwoSided {
        TwoSided { forward: self.forward - other.forward, backward: self.backward - other.backward }
    }
}

/// The mean of `count` values at equal steps over `revolutions` from `start` [rad] on, times `e^{-i order theta}`: the coefficient of `e^{i order theta}`,
/// which for real values is half the amplitude of a positive order.
pub fn coefficient(
    values: impl Iterator<Item = Complex64>,
    count: usize,
    start: f64,
    revolutions: f64,
    order: f64,
) -> Complex64 {
    let step = TAU * revolutions / count as f64;
    let terms =
        values.enumerate().map(|(k, value)| value * Complex64::cis(-order * (start + step * k as f64)));
    terms.sum::<Complex64>() / count as f64
}

/// Complex amplitude `a` of an order of a real quantity, `Re(a e^{i order theta})`, from its samples as of [`coefficient`]; of order 0 the mean.
pub fn amplitude(
    values: impl Iterator<Item = f64>,
    count: usize,
    start: f64,
    revolutions: f64,
    order: f64,
) -> Complex64 {
    let half = coefficient(values.map(Complex64::from), count, start, revolutions, order);
    if order == 0.0 { half } else { 2.0 * half }
}
