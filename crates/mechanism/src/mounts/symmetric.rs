//! Eigenvalues of small symmetric matrices by Jacobi's rotations.
//!
//! The routine of `nalgebra` returns wrong vectors for some nearly uncoupled matrices (its issue 1109), which stiff blocks on symmetric
//! mounts have. Jacobi's is as accurate as the entries allow, and for six rows as quick as is needed.

use lanchester_numerics::SymmetricEigen;
use nalgebra::{SMatrix, SVector};

/// Eigenvalues of a symmetric matrix, rising, each with its unit vector; the lower half of the matrix is not read.
pub(crate) fn symmetric_eigen<const N: usize>(matrix: &SMatrix<f64, N, N>) -> Vec<(f64, SVector<f64, N>)> {
    let by_row: Vec<f64> = matrix.transpose().iter().copied().collect();
    let found = SymmetricEigen::new(N, by_row);
    let of = |k: usize| match &found {
        Some(eigen) => (eigen.values[k], SVector::from_column_slice(&eigen.vectors[k * N..(k + 1) * N])),
        None => (f64::NAN, SVector::repeat(f64::NAN)),
    };
    (0..N).map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::symmetric_eigen;
    use nalgebra::{SMatrix, Vector3};
    use proptest::prelude::*;

    /// `A v = w v` for each pair, vectors at right angles, values rising.
    fn solves<const N: usize>(matrix: &SMatrix<f64, N, N>) -> Result<(), TestCaseError> {
        let pairs = symmetric_eigen(matrix);
        // Rounding of a product of N terms, a few dozen rotations deep.
        let rounding = 1e-14 * matrix.norm();
        for (i, (value, vector)) in pairs.iter().enumerate() {
            prop_assert!((matrix * vector - vector * *value).norm() <= rounding, "{i} of {matrix}");
            for (j, (_, other)) in pairs.iter().enumerate() {
                let wanted = f64::from(u8::from(i == j));
                prop_assert!((vector.dot(other) - wanted).abs() <= 1e-14, "{i} {j} of {matrix}");
            }
        }
        prop_assert!(pairs.windows(2).all(|pair| pair[0].0 <= pair[1].0));
        Ok(())
    }

    /// A symmetric matrix of six rows whose entries differ by many powers of ten, some of them nothing.
    fn any_matrix() -> impl Strategy<Value = SMatrix<f64, 6, 6>> {
        let entry = (-1.0..1.0f64, -12.0..3.0f64, any::<bool>());
        proptest::collection::vec(entry, 21).prop_map(|entries| {
            let mut matrix = SMatrix::zeros();
            let mut entries = entries.into_iter();
            for i in 0..6 {
                for j in i..6 {
                    let (sign, power, there) = entries.next().expect("21 entries of the upper half");
                    let value = if there { sign * 10f64.powf(power) } else { 0.0 };
                    (matrix[(i, j)], matrix[(j, i)]) = (value, value);
                }
            }
            matrix
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1000))]

        #[test]
        fn prop_values_and_vectors_solve_their_equation(matrix in any_matrix()) {
            solves(&matrix)?;
        }
    }

    #[test]
    fn a_diagonal_matrix_is_its_own_answer() {
        let pairs = symmetric_eigen(&SMatrix::<f64, 3, 3>::from_diagonal(&Vector3::new(2.0, -1.0, 0.0)));
        assert_eq!(pairs.iter().map(|pair| pair.0).collect::<Vec<_>>(), [-1.0, 0.0, 2.0]);
        assert_eq!(pairs[0].1, Vector3::y());
    }

    #[test]
    fn rows_that_are_hardly_coupled_keep_their_vectors() {
        // Two equal stiffnesses, one far below them, couplings down to the smallest numbers.
        let matrix = SMatrix::<f64, 3, 3>::new(1.0, 1e-17, 1e-170, 1e-17, 1.0, 1e-9, 1e-170, 1e-9, 1e-12);
        solves(&matrix).expect("the pairs solve their equation");
    }
}
