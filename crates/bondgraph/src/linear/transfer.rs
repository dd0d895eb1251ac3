//! Transfer functions `C adj(s - A) B / det(s - A) + D`.

use crate::linear::exact::Double;
use crate::linear::result::{Linear, ROUNDINGS, Transfer};

/// More states than these have no transfer functions: nobody reads so many powers.
const MOST_STATES: usize = 12;

/// `det(s - A)` and `adj(s - A)` as polynomials in s.
struct Pencil {
    /// Coefficients of rising powers, the last 1.
    determinant: Vec<Double>,
    /// Matrices of rising powers, row by row.
    adjoint: Vec<Vec<Double>>,
}

/// Faddeev's and Leverrier's recursion: `M_1 = 1`, `c_{n-k} = -tr(A M_k) / k`, `M_{k+1} = A M_k + c_{n-k}`.
fn pencil(a: &[Vec<f64>]) -> Pencil {
    let n = a.len();
    let zero = Double::default();
    let mut determinant = vec![zero; n + 1];
    determinant[n] = 1.0.into();
    let mut adjoint = vec![Vec::new(); n];
    let mut moved = vec![zero; n * n];
    for k in 1..=n {
        let mut m = moved;
        for i in 0..n {
            m[i * n + i] = m[i * n + i] + determinant[n - k + 1];
        }
        moved = vec![zero; n * n];
        let mut trace = zero;
        for i in 0..n {
            for (l, entry) in a[i].iter().enumerate().filter(|(_, entry)| **entry != 0.0) {
                for j in 0..n {
                    moved[i * n + j] = moved[i * n + j] + Double::from(*entry) * m[l * n + j];
                }
            }
            trace = trace + moved[i * n + i];
        }
        determinant[n - k] = trace.over(-(k as f64));
        adjoint[n - k] = m;
    }
    Pencil { determinant, adjoint }
}

/// From each input to each output.
///
/// The recursion itself has twice the digits of what is given. What the rounding of A, B, C and D can make of a coefficient is
/// `sum |∂c/∂a| |a|` times that rounding: a coefficient below is 0. With `∂det/∂A = -adj`, and the numerator `det(s - A + B C) - det(s - A)`,
/// adjoints give all slopes.
pub(crate) fn transfers(linear: &Linear) -> Vec<Transfer> {
    let a = &linear.a;
    let n = a.len();
    if n == 0 || n > MOST_STATES {
        return Vec::new();
    }
    let rounding = ROUNDINGS * f64::EPSILON;
    let free = pencil(a);
    let moves = |adjoint: &dyn Fn(usize) -> f64| -> f64 {
        let entries = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
        entries.map(|(i, j)| (a[j][i] * adjoint(i * n + j)).abs()).sum::<f64>() * rounding
    };
    // Coefficient and its bound, of rising powers.
    let below: Vec<[f64; 2]> = (free.determinant.iter().enumerate())
        .map(|(power, own)| {
            let bound = free.adjoint.get(power).map_or(0.0, |adjoint| moves(&|at| adjoint[at].value()));
            [own.value(), bound]
        })
        .collect();
    let clean = |[value, bound]: [f64; 2]| if value.abs() <= bound { 0.0 } else { value };
    let mut found = Vec::new();
    for (k, input) in linear.inputs.iter().enumerate() {
        for (row, output) in linear.outputs.iter().enumerate() {
            let (c, direct) = (&linear.c[row], linear.d[row][k]);
            let b: Vec<f64> = linear.b.iter().map(|own| own[k]).collect();
            let closed: Vec<Vec<f64>> =
                (0..n).map(|i| (0..n).map(|j| a[i][j] - b[i] * c[j]).collect()).collect();
            let closed = pencil(&closed);
            let mut numerator: Vec<[f64; 2]> = (below.iter())
                .map(|[value, bound]| [value * direct, (bound + value.abs() * rounding) * direct.abs()])
                .collect();
            for power in 0..n {
                let (own, other) = (&free.adjoint[power], &closed.adjoint[power]);
                let (mut sum, mut sizes) = (Double::from(numerator[power][0]), 0.0);
                for i in 0..n {
                    for j in 0..n {
                        let term = Double::from(c[i]) * own[i * n + j] * Double::from(b[j]);
                        sum = sum + term;
                        sizes += term.value().abs();
                    }
                }
                let by_a = moves(&|at| (other[at] + own[at] * Double::from(-1.0)).value());
                let [value, bound] = &mut numerator[power];
                *value = sum.value();
                *bound += 2.0 * rounding * sizes + by_a;
            }
            let mut numerator: Vec<f64> = numerator.into_iter().map(clean).collect();
            while numerator.len() > 1 && numerator.last() == Some(&0.0) {
                numerator.pop();
            }
            found.push(Transfer {
                input: input.clone(),
                output: output.clone(),
                numerator,
                denominator: below.iter().copied().map(clean).collect(),
            });
        }
    }
    found
}
