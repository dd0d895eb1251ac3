//! Eigenvalues and eigenvectors of small dense symmetric matrices.

/// Sweeps after which a matrix counts as not converging: some six are usual.
const MOST_SWEEPS: usize = 60;

/// Eigenvalues of a symmetric matrix, rising, with orthonormal eigenvectors.
#[derive(Debug, Clone, PartialEq)]
pub struct SymmetricEigen {
    /// Eigenvalues, rising.
    pub values: Vec<f64>,
    /// Eigenvector of each, one after the other: component `i` of vector `k` is `vectors[k * size + i]`.
    pub vectors: Vec<f64>,
}

impl SymmetricEigen {
    /// By cyclic Jacobi rotations of the `size` by `size` matrix given row by row, of which the upper triangle counts. `None` where it holds a
    /// number that is none.
    ///
    /// # Source
    /// Golub, Van Loan, "Matrix Computations", 4th ed. (2013), section 8.5.
    pub fn new(size: usize, mut matrix: Vec<f64>) -> Option<SymmetricEigen> {
        assert_eq!(matrix.len(), size * size, "a matrix of {size} rows");
        let (n, a) = (size, &mut matrix);
        for row in 1..n {
            for column in 0..row {
                a[row * n + column] = a[column * n + row];
            }
        }
        if a.iter().any(|entry| !entry.is_finite()) {
            return None;
        }
        let mut v = vec![0.0; n * n];
        for i in 0..n {
            v[i * n + i] = 1.0;
        }
        for _ in 0..MOST_SWEEPS {
            let mut is_done = true;
            for p in 0..n {
                for q in p + 1..n {
                    let off = a[p * n + q];
                    // Relative to both diagonals, so that small eigenvalues of graded matrices keep their digits.
                    let small = f64::EPSILON * (a[p * n + p].abs() * a[q * n + q].abs()).sqrt();
                    if off == 0.0 || off.abs() <= small * 0.01 {
                        continue;
                    }
                    is_done = false;
                    let half = (a[q * n + q] - a[p * n + p]) / (2.0 * off);
                    let t = half.signum() / (half.abs() + (1.0 + half * half).sqrt());
                    let c = 1.0 / (1.0 + t * t).sqrt();
                    let s = t * c;
                    a[p * n + p] -= t * off;
                    a[q * n + q] += t * off;
                    a[p * n + q] = 0.0;
                    for k in 0..n {
                        if k != p && k != q {
                            // Only the upper triangle is kept.
                            let at_p = if k < p { k * n + p } else { p * n + k };
                            let at_q = if k < q { k * n + q } else { q * n + k };
                            let (x, y) = (a[at_p], a[at_q]);
                            a[at_p] = c * x - s * y;
                            a[at_q] = s * x + c * y;
                        }
                    }
                    let (head, tail) = v.split_at_mut(q * n);
                    for (x, y) in head[p * n..(p + 1) * n].iter_mut().zip(&mut tail[..n]) {
                        (*x, *y) = (c * *x - s * *y, s * *x + c * *y);
                    }
                }
            }
            if is_done {
                break;
            }
        }
        let mut order: Vec<usize> = (0..n).collect();
        order.sort_by(|i, j| a[i * n + i].total_cmp(&a[j * n + j]));
        Some(SymmetricEigen {
            values: order.iter().map(|i| a[i * n + i]).collect(),
            vectors: order.iter().flat_map(|i| v[i * n..(i + 1) * n].to_vec()).collect(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// The second difference with free ends has the eigenvalues 2 - 2 cos(k pi / n), and cosines for vectors.
    #[test]
    fn second_difference_with_free_ends() {
        let n = 9;
        let mut matrix = vec![0.0; n * n];
        for i in 0..n - 1 {
            matrix[i * n + i] += 1.0;
            matrix[(i + 1) * n + i + 1] += 1.0;
            matrix[i * n + i + 1] -= 1.0;
        }
        let eigen = SymmetricEigen::new(n, matrix).expect("finite");
        for (k, value) in eigen.values.iter().enumerate() {
            let exact = 2.0 - 2.0 * (k as f64 * PI / n as f64).cos();
            assert!((value - exact).abs() < 1e-14, "{k}: {value} instead of {exact}, to rounding");
            let vector = &eigen.vectors[k * n..(k + 1) * n];
            let shape = |i: usize| (k as f64 * PI * (i as f64 + 0.5) / n as f64).cos();
            let scale = vector[0] / shape(0);
            for i in 0..n {
                assert!((vector[i] - scale * shape(i)).abs() < 1e-13, "vector {k}, component {i}");
            }
        }
        assert!(SymmetricEigen::new(1, vec![f64::NAN]).is_none());
        assert_eq!(SymmetricEigen::new(0, Vec::new()).map(|none| none.values.len()), Some(0));
    }
}
