//! Eigenvalues of small dense symmetric matrices, by Jacobi's rotations.

/// Eigenvalues, rising, and their eigenvectors one after the other.
pub(crate) fn symmetric_eigen(matrix: &[f64], size: usize) -> (Vec<f64>, Vec<f64>) {
    let mut a = matrix.to_vec();
    let mut v = vec![0.0; size * size];
    for k in 0..size {
        v[k * size + k] = 1.0;
    }
    let scale = a.iter().fold(0.0f64, |sum, value| sum.max(value.abs()));
    for _ in 0..60 {
        let off = (0..size)
            .flat_map(|p| (0..p).map(move |q| (p, q)))
            .map(|(p, q)| a[p * size + q].powi(2))
            .sum::<f64>();
        if off.sqrt() <= 1e-17 * scale * size as f64 {
            break;
        }
        for p in 0..size {
            for q in p + 1..size {
                let off = a[p * size + q];
                if off.abs() <= 1e-300 {
                    continue;
                }
                let half = (a[q * size + q] - a[p * size + p]) / (2.0 * off);
                let t = half.signum() / (half.abs() + (half * half + 1.0).sqrt());
                let c = 1.0 / (t * t + 1.0).sqrt();
                let s = t * c;
                for k in 0..size {
                    let (x, y) = (a[p * size + k], a[q * size + k]);
                    a[p * size + k] = c * x - s * y;
                    a[q * size + k] = s * x + c * y;
                }
                for k in 0..size {
                    let (x, y) = (a[k * size + p], a[k * size + q]);
                    a[k * size + p] = c * x - s * y;
                    a[k * size + q] = s * x + c * y;
                }
                for k in 0..size {
                    let (x, y) = (v[p * size + k], v[q * size + k]);
                    v[p * size + k] = c * x - s * y;
                    v[q * size + k] = s * x + c * y;
                }
            }
        }
    }
    let mut order: Vec<usize> = (0..size).collect();
    order.sort_by(|p, q| a[p * size + p].total_cmp(&a[q * size + q]));
    let values = order.iter().map(|k| a[k * size + k]).collect();
    let vectors = order.iter().flat_map(|k| v[k * size..(k + 1) * size].to_vec()).collect();
    (values, vectors)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eigenvectors_solve_their_equation() {
        let size = 12;
        let matrix: Vec<f64> = (0..size * size)
            .map(|k| {
                let (row, column) = (k / size, k % size);
                ((row * column) as f64).sin()
                    + if row == column { 3.0 } else { 0.0 }
                    + ((row + column) as f64).cos()
            })
            .collect();
        let (values, vectors) = symmetric_eigen(&matrix, size);
        for k in 0..size {
            let x = &vectors[k * size..(k + 1) * size];
            for row in 0..size {
                let product: f64 = (0..size).map(|column| matrix[row * size + column] * x[column]).sum();
                assert!((product - values[k] * x[row]).abs() < 1e-12, "{k} {row}");
            }
        }
        assert!(values.windows(2).all(|pair| pair[0] <= pair[1]));
    }
}
