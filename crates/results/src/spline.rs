//! Periodic cubic splines on knots of any spacing.
//!
//! ```text
//! h_i = t_(i+1) - t_i,   s_i = (y_(i+1) - y_i)/h_i,   M_i = y''(t_i)
//! h_(i-1) M_(i-1) + 2 (h_(i-1) + h_i) M_i + h_i M_(i+1) = 6 (s_i - s_(i-1))       all indices periodic (23.3)
//! ```
//! The cyclic system is tridiagonal but for two corners, which a rank-one correction takes care of (Sherman and Morrison); it
//! is diagonally dominant, so that elimination without pivoting is stable.

/// Coefficients of the pieces of the periodic spline through at least three values at rising knots within one period.
pub(crate) fn pieces(period: f64, knots: &[f64], values: &[f64]) -> Vec<[f64; 4]> {
    let count = knots.len();
    let next = |i: usize| (i + 1) % count;
    let before = |i: usize| (i + count - 1) % count;
    let step = |i: usize| if i + 1 == count { knots[0] + period - knots[i] } else { knots[i + 1] - knots[i] };
    let steps: Vec<f64> = (0..count).map(step).collect();
    let slope = |i: usize| (values[next(i)] - values[i]) / steps[i];
    let rest: Vec<f64> = (0..count).map(|i| 6.0 * (slope(i) - slope(before(i)))).collect();
    let diagonal: Vec<f64> = (0..count).map(|i| 2.0 * (steps[before(i)] + steps[i])).collect();
    let bends = cyclic(&steps, &diagonal, &rest);
    let piece = |i: usize| {
        let (h, m, n) = (steps[i], bends[i], bends[next(i)]);
        [values[i], slope(i) - h * (2.0 * m + n) / 6.0, m / 2.0, (n - m) / (6.0 * h)]
    };
    (0..count).map(piece).collect()
}

/// Solves the symmetric cyclic system with `steps` beside the `diagonal`: row i has `steps[i-1]`, `diagonal[i]`, `steps[i]`.
fn cyclic(steps: &[f64], diagonal: &[f64], rest: &[f64]) -> Vec<f64> {
    let count = steps.len();
    let corner = steps[count - 1];
    let gamma = -diagonal[0];
    let mut main = diagonal.to_vec();
    main[0] -= gamma;
    main[count - 1] -= corner * corner / gamma;
    let first = tridiagonal(steps, &main, rest);
    let mut unit = vec![0.0; count];
    unit[0] = gamma;
    unit[count - 1] = corner;
    let second = tridiagonal(steps, &main, &unit);
    let product = |x: &[f64]| x[0] + corner * x[count - 1] / gamma;
    let factor = product(&first) / (1.0 + product(&second));
    first.iter().zip(&second).map(|(x, z)| x - factor * z).collect()
}

/// Solves the tridiagonal system of the same rows without the corners.
fn tridiagonal(steps: &[f64], diagonal: &[f64], rest: &[f64]) -> Vec<f64> {
    let count = diagonal.len();
    let mut beyond = vec![0.0; count];
    let mut solution = rest.to_vec();
    let mut pivot = diagonal[0];
    solution[0] /= pivot;
    for i in 1..count {
        beyond[i - 1] = steps[i - 1] / pivot;
        pivot = diagonal[i] - steps[i - 1] * beyond[i - 1];
        solution[i] = (solution[i] - steps[i - 1] * solution[i - 1]) / pivot;
    }
    for i in (0..count - 1).rev() {
        solution[i] -= beyond[i] * solution[i + 1];
    }
    solution
}
