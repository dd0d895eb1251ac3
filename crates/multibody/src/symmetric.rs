//! Small symmetric positive definite systems without allocation.

/// Most unknowns: block, crank and eight inertias of the driveline.
pub(crate) const MOST: usize = 15;

/// A square matrix of which the leading part counts.
pub(crate) type Matrix<const N: usize> = [[f64; N]; N];

/// Solves `matrix x = rhs` of `size` unknowns in place by Cholesky, of which the lower half alone is read; `None` where the matrix is not positive definite.
#[inline]
pub(crate) fn solve<const N: usize>(matrix: &mut Matrix<N>, rhs: &mut [f64; N], size: usize) -> Option<()> {
    // Rows of L take the place of the lower half; divisions by its diagonal once each.
    let mut by_diagonal = [0.0; N];
    for j in 0..size {
        let (above, rest) = matrix.split_at_mut(j);
        let own = &mut rest[0];
        for i in 0..j {
            let row = &above[i];
            let mut value = own[i];
            for k in 0..i {
                value -= row[k] * own[k];
            }
            own[i] = value * by_diagonal[i];
        }
        let mut square = own[j];
        let mut right = rhs[j];
        for k in 0..j {
            square -= own[k] * own[k];
            right -= own[k] * rhs[k];
        }
        // What is not a number is not positive either.
        if square.is_nan() || square <= 0.0 {
            return None;
        }
        by_diagonal[j] = 1.0 / square.sqrt();
        rhs[j] = right * by_diagonal[j];
    }
    for i in (0..size).rev() {
        rhs[i] *= by_diagonal[i];
        let value = rhs[i];
        for k in 0..i {
            rhs[k] -= matrix[i][k] * value;
        }
    }
    Some(())
}

/// Solves `matrix x = rhs + T b` for `x` and the torque `T` of a drive where the rate of the crank, row and column `crank`, is given: relative to the block
/// (or, `absolute`, with the block's roll, row 5). The drive acts on the crank, and where it stands on the ground on the roll too. `rhs` becomes `x`.
pub(crate) fn solve_given<const N: usize>(
    matrix: &mut Matrix<N>,
    rhs: &mut [f64; N],
    size: usize,
    crank: usize,
    rate: f64,
    from_ground: bool,
    absolute: bool,
) -> Option<f64> {
    let moving = crank > 0;
    let own = matrix[crank];
    let needed = rhs[crank];
    if moving && from_ground {
        // The roll row less the crank's row has no torque of the drive.
        for k in 0..size {
            matrix[5][k] -= own[k];
        }
        rhs[5] -= needed;
    }
    // The crank's row gives way to the rate.
    matrix[crank] = [0.0; N];
    matrix[crank][crank] = 1.0;
    if moving && absolute {
        matrix[crank][5] = 1.0;
    }
    rhs[crank] = rate;
    eliminate(matrix, rhs, size)?;
    Some((0..size).map(|k| own[k] * rhs[k]).sum::<f64>() - needed)
}

/// Gauss with row pivots, in place.
fn eliminate<const N: usize>(matrix: &mut Matrix<N>, rhs: &mut [f64; N], size: usize) -> Option<()> {
    for j in 0..size {
        let pivot = (j..size).max_by(|a, b| matrix[*a][j].abs().total_cmp(&matrix[*b][j].abs()))?;
        matrix.swap(j, pivot);
        rhs.swap(j, pivot);
        let top = matrix[j][j];
        if top == 0.0 || !top.is_finite() {
            return None;
        }
        for i in j + 1..size {
            let factor = matrix[i][j] / top;
            for k in j..size {
                matrix[i][k] -= factor * matrix[j][k];
            }
            rhs[i] -= factor * rhs[j];
        }
    }
    for i in (0..size).rev() {
        let sum: f64 = (i + 1..size).map(|k| matrix[i][k] * rhs[k]).sum();
        rhs[i] = (rhs[i] - sum) / matrix[i][i];
    }
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_and_refuses() {
        let mut matrix = [[0.0; MOST]; MOST];
        for (i, row) in [[4.0, 1.0, 0.5], [1.0, 3.0, -1.0], [0.5, -1.0, 2.0]].into_iter().enumerate() {
            matrix[i][..3].copy_from_slice(&row);
        }
        let mut rhs = [0.0; MOST];
        rhs[..3].copy_from_slice(&[6.5, -1.0, 7.5]);
        let full = matrix;
        solve(&mut matrix, &mut rhs, 3).expect("it is positive definite");
        for (row, wanted) in full.iter().zip([6.5, -1.0, 7.5]) {
            let got: f64 = row.iter().zip(rhs).map(|(a, x)| a * x).sum();
            assert!((got - wanted).abs() < 1e-14, "{got} {wanted}");
        }
        let mut singular = [[1.0; MOST]; MOST];
        assert!(solve(&mut singular, &mut rhs, 2).is_none());
    }
}
