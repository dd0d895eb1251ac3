//! Order coefficients by quadrature, for motions without a closed series (articulated rods, truncated products).

use num_complex::Complex64;
use std::f64::consts::TAU;

/// Most angles of a quadrature: reached only where a linkage nearly locks.
const MAX_ANGLES: usize = 1 << 16;

/// Change between two quadratures, relative to the largest value of the function, below which they agree.
const AGREEMENT: f64 = 1e-15;

/// Fourier coefficients of real functions of period 2 pi, n = 0..=highest, by the trapezoidal rule.
///
/// ```text
/// f_n = (1/N) SUM over j of f(2 pi j / N) e^{-2 pi i n j / N}
/// ```
/// The rule is spectral on periodic analytic functions: its error is the sum of the orders n + N, n + 2 N, .. that
/// alias into n. N doubles until two results agree to 1e-15 of the largest value. `band` is the highest order of the
/// functions where they are known to be band-limited (0 if not): with N > highest + band the sum is exact.
pub(crate) fn sampled_orders<const M: usize>(
    highest: usize,
    band: usize,
    function: impl Fn(f64) -> [f64; M],
) -> Vec<[Complex64; M]> {
    let mut count = (highest + band + 1).max(32).next_power_of_two();
    let mut values: Vec<[f64; M]> = (0..count).map(|j| function(TAU * j as f64 / count as f64)).collect();
    let mut orders = transform(&values, highest);
    while count < MAX_ANGLES {
        let between = (0..count).map(|j| function(TAU * (j as f64 + 0.5) / count as f64));
        values = values.into_iter().zip(between).flat_map(|(a, b)| [a, b]).collect();
        count *= 2;
        let finer = transform(&values, highest);
        let agrees = (0..M).all(|m| {
            let largest = values.iter().fold(0.0f64, |largest, v| largest.max(v[m].abs()));
            orders.iter().zip(&finer).all(|(a, b)| (a[m] - b[m]).norm() <= AGREEMENT * largest)
        });
        orders = finer;
        if agrees {
            break;
        }
    }
    orders
}

/// The sums of the trapezoidal rule; the angles of the exponentials are reduced exactly.
fn transform<const M: usize>(values: &[[f64; M]], highest: usize) -> Vec<[Complex64; M]> {
    let count = values.len();
    let turns: Vec<Complex64> = (0..count).map(|j| Complex64::cis(-TAU * j as f64 / count as f64)).collect();
    (0..=highest)
        .map(|n| {
            let mut sum = [Complex64::ZERO; M];
            for (j, value) in values.iter().enumerate() {
                let turn = turns[n * j % count];
                for m in 0..M {
                    sum[m] += value[m] * turn;
                }
            }
            sum.map(|s| s / count as f64)
        })
        .collect()
}
