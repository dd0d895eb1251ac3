//! Eigenvalues of small dense symmetric matrices.

use lanchester_numerics::SymmetricEigen;

/// Eigenvalues, rising, and their eigenvectors one after the other; none is a number where an entry of the matrix is none.
pub(crate) fn symmetric_eigen(matrix: &[f64], size: usize) -> (Vec<f64>, Vec<f64>) {
    match SymmetricEigen::new(size, matrix.to_vec()) {
        Some(eigen) => (eigen.values, eigen.vectors),
        None => (vec![f64::NAN; size], vec![f64::NAN; size * size]),
    }
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
