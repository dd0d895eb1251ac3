//! Order coefficients of a plain rod's motion: exact to any order without sampling, and the literature's series.
//!
//! With `x = phi - pi/2` (so that `sin phi = cos x`) the root of the exact travel factors,
//!
//! ```text
//! W = sqrt(l^2 - (r cos x - e)^2) = sqrt(A1 - r cos x) sqrt(A2 + r cos x),   A1 = l + e,  A2 = l - e
//! A -+ r cos x = (D / 2) |1 -+ rho w|^2,   w = e^{i x},  D = A + sigma,  sigma = sqrt(A^2 - r^2),  rho = r / D
//! W = C g(w) g(1/w),   g = sqrt(1 - rho1 w) sqrt(1 + rho2 w),   C = sqrt(D1 D2) / 2
//! (k + 1) g_{k+1} = d (1/2 - k) g_k + p (k - 2) g_{k-1},   d = rho2 - rho1,  p = rho1 rho2
//! W_n = C SUM over k of g_k g_{k+n}
//! ```
//! `1/W = h(w) h(1/w) / C` likewise with `(k + 1) h_{k+1} = -d (1/2 + k) h_k + p k h_{k-1}`. All terms of `W_n` fall
//! geometrically, so that high orders keep their relative accuracy. `sigma`, `rho` and `d` are computed without
//! differences of nearly equal numbers, so that `r -> 0`, `e = 0` and tiny offsets are no special cases.

use crate::inertia::request::LoadError;
use crate::train::linkage::Slider;
use num_complex::Complex64;

/// Most terms of a root's series: reached only where rod and crank nearly lock.
const MAX_TERMS: usize = 1 << 14;

/// `i^n`.
pub(crate) fn power_of_i(n: i64) -> Complex64 {
    match n.rem_euclid(4) {
        0 => Complex64::ONE,
        1 => Complex64::I,
        2 => -Complex64::ONE,
        _ => -Complex64::I,
    }
}

/// The two factors of the root of a plain rod.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RootFactors {
    /// `rho1`, `rho2`: both below 1.
    pub rho: [f64; 2],
    /// `sigma1`, `sigma2` [m].
    pub sigma: [f64; 2],
    /// `d = rho2 - rho1`.
    pub difference: f64,
    /// `C` [m].
    pub scale: f64,
}

impl RootFactors {
    /// Factors of the root of `slider`.
    pub fn of(slider: &Slider) -> RootFactors {
        let Slider { radius: r, length: l, offset: e } = *slider;
        let sigma = [e, -e].map(|e| ((l + e - r) * (l + e + r)).sqrt());
        let d = [l + e + sigma[0], l - e + sigma[1]];
        let difference = r * (2.0 * e + 4.0 * l * e / (sigma[0] + sigma[1])) / (d[0] * d[1]);
        RootFactors { rho: [r / d[0], r / d[1]], sigma, difference, scale: 0.5 * (d[0] * d[1]).sqrt() }
    }

    /// Terms after which a series lies below the last digit of every sum it enters.
    pub fn terms(&self) -> usize {
        let rho = self.rho[0].max(self.rho[1]).max(1e-3);
        // rho^(2 K) <= 2^-56: what follows is lost in the rounding of the sum.
        let needed = (-0.5 * 56.0 * std::f64::consts::LN_2 / rho.ln()).ceil();
        if needed.is_finite() { (needed as usize).clamp(4, MAX_TERMS) } else { MAX_TERMS }
    }
}

/// Fourier coefficients in `x` (real, even): `W_n` with `sign = 1`, those of `1/W` with `sign = -1`, n = 0..=highest.
fn root_coefficients(factors: &RootFactors, highest: usize, sign: f64) -> Vec<f64> {
    let (d, p) = (factors.difference, factors.rho[0] * factors.rho[1]);
    let count = factors.terms();
    let mut g = Vec::with_capacity(count + highest + 1);
    g.push(1.0);
    let mut before = 0.0;
    for k in 0..count + highest {
        let at = k as f64;
        let next = if sign > 0.0 {
            d * (0.5 - at) * g[k] + p * (at - 2.0) * before
        } else {
            p * at * before - d * (0.5 + at) * g[k]
        } / (at + 1.0);
        before = g[k];
        g.push(next);
    }
    let scale = if sign > 0.0 { factors.scale } else { 1.0 / factors.scale };
    (0..=highest).map(|n| scale * g[..=count].iter().zip(&g[n..]).map(|(a, b)| a * b).sum::<f64>()).collect()
}

/// Order coefficients of a motion: of a function `f = SUM over n of f_n e^{i n phi}`, real `f`, n = 0..=highest.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct MotionOrders {
    /// Travel `s` [m].
    pub travel: Vec<Complex64>,
    /// Rod rate `beta'` [-].
    pub swing_rate: Vec<Complex64>,
    /// `(s')^2` [m^2].
    pub travel_rate_squared: Vec<Complex64>,
    /// `(beta')^2` [-].
    pub swing_rate_squared: Vec<Complex64>,
}

impl MotionOrders {
    /// Orders 0..=highest of a motion that has these orders of travel and rod rate and no others: the squares are
    /// finite sums of their products.
    ///
    /// ```text
    /// (f'^2)_n = SUM over k of f'_k f'_{n-k}        f'_k = i k f_k,  f_{-k} = conj(f_k)
    /// ```
    pub fn of_finite(&self, highest: usize) -> MotionOrders {
        let padded = |orders: &[Complex64]| {
            let all = orders.iter().copied().chain(std::iter::repeat(Complex64::ZERO));
            all.take(highest + 1).collect::<Vec<_>>()
        };
        let speed: Vec<Complex64> =
            self.travel.iter().enumerate().map(|(n, s)| Complex64::new(0.0, n as f64) * s).collect();
        MotionOrders {
            travel: padded(&self.travel),
            swing_rate: padded(&self.swing_rate),
            travel_rate_squared: padded(&square(&speed)),
            swing_rate_squared: padded(&square(&self.swing_rate)),
        }
    }
}

/// Orders of the square of a real function with these orders.
fn square(orders: &[Complex64]) -> Vec<Complex64> {
    let highest = orders.len() as i64 - 1;
    let order = |n: i64| if n < 0 { orders[-n as usize].conj() } else { orders[n as usize] };
    let product = |n: i64| (n - highest..=highest).map(|k| order(k) * order(n - k)).sum();
    (0..=2 * highest).map(product).collect()
}

/// Orders of a plain rod's exact motion, n = 0..=highest, phases counted in `phi`.
///
/// ```text
/// s       = r cos phi + W
/// beta'   = r cos phi / W
/// beta'^2 = 1 - ( sigma1 / |1 - rho1 w|^2 + sigma2 / |1 + rho2 w|^2 ) / ..  :  order n is
///           delta_n0 - ( sigma1 rho1^n + sigma2 (-rho2)^n ) / (2 l)
/// s'^2    = (r sin phi)^2 - 2 r sin phi W' + W'^2,   W'^2 = l^2 beta'^2 - (r cos phi)^2
/// ```
/// so that the products which torque needs are closed forms too. (Partial fractions of `cos^2 / (l^2 - q^2)`.)
pub(crate) fn slider_orders(slider: &Slider, highest: usize) -> MotionOrders {
    let factors = RootFactors::of(slider);
    let (r, l) = (slider.radius, slider.length);
    let root = root_coefficients(&factors, highest + 1, 1.0);
    let inverse = root_coefficients(&factors, highest + 1, -1.0);
    let mut orders = MotionOrders::default();
    let (mut rho1, mut rho2) = (1.0, 1.0);
    for n in 0..=highest {
        let order = n as f64;
        let phase = power_of_i(-(n as i64));
        let before = if n == 0 { 1 } else { n - 1 };
        let first = if n == 1 { 0.5 * r } else { 0.0 };
        orders.travel.push(phase * root[n] + first);
        let rate = if n == 0 { 0.0 } else { 0.5 * r * (inverse[before] - inverse[n + 1]) };
        orders.swing_rate.push(phase * Complex64::new(0.0, rate));
        let mean = if n == 0 { 1.0 } else { 0.0 };
        let swing = mean - (factors.sigma[0] * rho1 + factors.sigma[1] * rho2) / (2.0 * l);
        orders.swing_rate_squared.push(phase * swing);
        // (r sin)^2 - (r cos)^2 = r^2 cos 2x.
        let pin = if n == 2 { 0.5 * r * r } else { 0.0 };
        let slope = if n == 0 { -root[1] } else { (order - 1.0) * root[before] };
        let cross = r * (slope + (order + 1.0) * root[n + 1]);
        orders.travel_rate_squared.push(phase * Complex64::new(pin + l * l * swing, -cross));
        rho1 *= factors.rho[0];
        rho2 *= -factors.rho[1];
    }
    orders
}

/// Exact order coefficients `c_n` of the piston acceleration over `r omega^2`, n = 0..=max_order.
///
/// ```text
/// -s'' / r = Re SUM over n > 0 of c_n e^{i n phi}          phi: crank from the cylinder axis
/// ```
/// Centred (`offset = 0`): real, `c_1 = 1`, `c_2 = A2 > 0`, `c_4 = A4 < 0`, odd orders above 1 vanish. With an offset:
/// complex, with odd orders. No sampling: see the module's equations.
///
/// | symbol | name                       | unit |
/// |--------|----------------------------|------|
/// | r      | `crank_radius`             | m    |
/// | l      | `rod_length`               | m    |
/// | e      | `offset`, net, along +v    | m    |
///
/// # Errors
/// [`LoadError::RodTooShort`] (cylinder 1) unless `l > r + |e|` and `r > 0`.
pub fn exact_coefficients(
    crank_radius: f64,
    rod_length: f64,
    offset: f64,
    max_order: u32,
) -> Result<Vec<Complex64>, LoadError> {
    let slider = Slider { radius: crank_radius, length: rod_length, offset };
    slider.check(1)?;
    let factors = RootFactors::of(&slider);
    let root = root_coefficients(&factors, max_order as usize, 1.0);
    Ok((0..=max_order as usize)
        .map(|n| {
            let first = if n == 1 { 1.0 } else { 0.0 };
            let square = (n * n) as f64;
            power_of_i(-(n as i64)) * (2.0 * square * root[n] / crank_radius) + first
        })
        .collect())
}

/// `binom(2k, k - m) / 4^k` for k = m, m + 1, ..
fn central_weights(m: u32) -> impl Iterator<Item = (u32, f64)> {
    let first = 0.25f64.powi(m as i32);
    std::iter::successors(Some((m, first)), move |&(k, weight)| {
        let (kf, mf) = (f64::from(k), f64::from(m));
        let factor = (2.0 * kf + 2.0) * (2.0 * kf + 1.0) / (4.0 * (kf + 1.0 - mf) * (kf + 1.0 + mf));
        Some((k + 1, weight * factor))
    })
}

/// `binom(a, k) (-1)^k` for `a = +-1/2`, k = 0..=highest.
fn half_binomials(a: f64, highest: u32) -> Vec<f64> {
    let next = |value: &f64, k: u32| value * (f64::from(k) - a) / (f64::from(k) + 1.0);
    std::iter::successors(Some((0, 1.0)), |(k, value)| Some((k + 1, next(value, *k))))
        .map(|(_, value)| value)
        .take(highest as usize + 1)
        .collect()
}

/// The literature's order coefficients of a centred slider-crank, n = 0..=max_order: power series in the rod ratio
/// `r/l`, truncated after `max_power`.
///
/// ```text
/// c_1 = 1,   c_{2m} = (2m)^2 SUM over k >= m of binom(1/2, k) (-1)^k R^{2k-1} 2 (-1)^m binom(2k, k-m) / 4^k
/// A2 = R + R^3/4 + 15 R^5/128 + ..,   A4 = -R^3/4 - 3 R^5/16 - ..,   A6 = 9 R^5/128 + ..
/// ```
/// | symbol | name        | unit |
/// |--------|-------------|------|
/// | R      | `rod_ratio` | -    |
///
/// # Source
/// Louvigny, Preliminary design of twin-cylinder engines (2008), eq. 6 to 8.
pub fn series_coefficients(rod_ratio: f64, max_order: u32, max_power: u32) -> Vec<f64> {
    let mut coefficients = vec![0.0; max_order as usize + 1];
    if max_order >= 1 {
        coefficients[1] = 1.0;
    }
    let binomials = half_binomials(0.5, max_power / 2 + 1);
    for m in 1..=max_order / 2 {
        let sign = if m % 2 == 0 { 2.0 } else { -2.0 };
        let sum: f64 = central_weights(m)
            .take_while(|(k, _)| 2 * k - 1 <= max_power)
            .map(|(k, weight)| binomials[k as usize] * rod_ratio.powi(2 * k as i32 - 1) * weight)
            .sum();
        coefficients[2 * m as usize] = f64::from(4 * m * m) * sign * sum;
    }
    coefficients
}

/// The motion that goes with [`series_coefficients`]: travel and rod rate, n = 0..=max_order.
pub(crate) fn series_orders(slider: &Slider, max_order: u32, max_power: u32) -> MotionOrders {
    let ratio = slider.radius / slider.length;
    let mut travel: Vec<Complex64> = series_coefficients(ratio, max_order, max_power)
        .iter()
        .enumerate()
        .map(|(n, c)| Complex64::from(slider.radius * c / (2.0 * (n.max(1) * n.max(1)) as f64)))
        .collect();
    // The mean travel moves no load.
    travel[0] = Complex64::from(slider.length);
    let binomials = half_binomials(-0.5, max_power / 2 + 1);
    let inverse: Vec<f64> = (0..=max_order / 2 + 1)
        .map(|m| {
            let sign = if m % 2 == 0 { 1.0 } else { -1.0 };
            central_weights(m)
                .take_while(|(k, _)| 2 * k < max_power)
                .map(|(k, weight)| sign * binomials[k as usize] * ratio.powi(2 * k as i32) * weight)
                .sum()
        })
        .collect();
    let swing_rate = (0..=max_order as usize)
        .map(|n| {
            let even = n % 2 == 1;
            Complex64::from(if even { 0.5 * ratio * (inverse[n / 2] + inverse[n / 2 + 1]) } else { 0.0 })
        })
        .collect();
    MotionOrders { travel, swing_rate, ..MotionOrders::default() }
}
