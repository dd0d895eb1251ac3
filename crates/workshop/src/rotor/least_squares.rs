//! Complex least squares by the singular value decomposition of the matrix with its columns at unit length.
//!
//! One-sided Jacobi rotations: slow for large matrices and the most accurate there is for small ones, where a few runs
//! meet a few planes (J. Demmel and K. Veselic, Jacobi's method is more accurate than QR, 1992).

use num_complex::Complex64;

/// Singular values below this share of the largest count as 0.
const RANK: f64 = 1e-11;
/// Two columns whose cosine is below this are orthogonal.
const ORTHOGONAL: f64 = 1e-15;
/// Each sweep squares what is left: a dozen reach rounding from anywhere.
const MOST_SWEEPS: usize = 60;

/// A decomposed matrix: `A = U S V^H D`, with D the lengths of the columns.
#[derive(Debug, Clone)]
pub(crate) struct Decomposition {
    /// Length of each column of A.
    lengths: Vec<f64>,
    /// Columns of `U S`.
    scaled: Vec<Vec<Complex64>>,
    /// Columns of V.
    right: Vec<Vec<Complex64>>,
    /// Singular values of A with unit columns, falling; as many as columns.
    singular: Vec<f64>,
    rows: usize,
}

impl Decomposition {
    /// Decomposes the matrix of these rows, all of one length.
    pub(crate) fn of(rows: &[Vec<Complex64>]) -> Decomposition {
        let count = rows.first().map_or(0, Vec::len);
        let mut columns: Vec<Vec<Complex64>> =
            (0..count).map(|k| rows.iter().map(|row| row[k]).collect()).collect();
        let lengths: Vec<f64> = columns.iter().map(|column| norm(column)).collect();
        for (column, length) in columns.iter_mut().zip(&lengths) {
            if *length > 0.0 {
                column.iter_mut().for_each(|value| *value /= *length);
            }
        }
        let mut right: Vec<Vec<Complex64>> = (0..count)
            .map(|k| (0..count).map(|j| Complex64::from(f64::from(u8::from(j == k)))).collect())
            .collect();
        for _ in 0..MOST_SWEEPS {
            let mut rotated = false;
            for p in 0..count {
                for q in p + 1..count {
                    rotated |= rotate(&mut columns, &mut right, p, q);
                }
            }
            if !rotated {
                break;
            }
        }
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by(|a, b| norm(&columns[*b]).total_cmp(&norm(&columns[*a])));
        Decomposition {
            lengths,
            singular: order.iter().map(|k| norm(&columns[*k])).collect(),
            scaled: order.iter().map(|k| columns[*k].clone()).collect(),
            right: order.iter().map(|k| right[*k].clone()).collect(),
            rows: rows.len(),
        }
    }

    /// Whether every unknown is determined.
    pub(crate) fn is_full(&self) -> bool {
        let largest = self.singular.first().copied().unwrap_or(0.0);
        self.rows >= self.lengths.len() && self.singular.iter().all(|value| *value > RANK * largest)
    }

    /// Largest over smallest singular value of the matrix with unit columns: how much larger the error of the unknowns
    /// may be, relatively, than that of the data.
    pub(crate) fn condition(&self) -> f64 {
        match (self.singular.first(), self.singular.last()) {
            (Some(largest), Some(smallest)) => largest / smallest,
            _ => 1.0,
        }
    }

    /// The share of each column in the combination that has the least effect; their squares add up to 1.
    pub(crate) fn weakest(&self) -> Vec<f64> {
        self.right.last().map_or(Vec::new(), |column| column.iter().map(|value| value.norm()).collect())
    }

    /// The unknowns that leave the least `|A x - data|`; combinations without effect are left at 0.
    pub(crate) fn solve(&self, data: &[Complex64]) -> Vec<Complex64> {
        let largest = self.singular.first().copied().unwrap_or(0.0);
        let mut unknowns = vec![Complex64::default(); self.lengths.len()];
        for (k, singular) in self.singular.iter().enumerate().filter(|(_, value)| **value > RANK * largest) {
            let share: Complex64 =
                self.scaled[k].iter().zip(data).map(|(column, value)| column.conj() * value).sum();
            for (unknown, right) in unknowns.iter_mut().zip(&self.right[k]) {
                *unknown += right * share / (singular * singular);
            }
        }
        for (unknown, length) in unknowns.iter_mut().zip(&self.lengths) {
            if *length > 0.0 {
                *unknown /= *length;
            }
        }
        unknowns
    }

    /// What the standard deviation of the data is multiplied with to give that of each unknown: the root of the
    /// diagonal of `(A^H A)^-1`.
    pub(crate) fn spread(&self) -> Vec<f64> {
        let mut squares = vec![0.0; self.lengths.len()];
        for (k, singular) in self.singular.iter().enumerate() {
            for (square, right) in squares.iter_mut().zip(&self.right[k]) {
                *square += right.norm_sqr() / (singular * singular);
            }
        }
        squares.iter().zip(&self.lengths).map(|(square, length)| square.sqrt() / length).collect()
    }
}

fn norm(column: &[Complex64]) -> f64 {
    column.iter().map(|value| value.norm_sqr()).sum::<f64>().sqrt()
}

/// Turns columns p and q so that they are orthogonal; whether there was anything to do.
fn rotate(columns: &mut [Vec<Complex64>], right: &mut [Vec<Complex64>], p: usize, q: usize) -> bool {
    let inner: Complex64 = columns[p].iter().zip(&columns[q]).map(|(a, b)| a.conj() * b).sum();
    let [length_p, length_q] = [p, q].map(|k| columns[k].iter().map(|value| value.norm_sqr()).sum::<f64>());
    let size = inner.norm();
    if size <= ORTHOGONAL * (length_p * length_q).sqrt() || size == 0.0 {
        return false;
    }
    let phase = inner / size;
    let zeta = (length_q - length_p) / (2.0 * size);
    let tangent = zeta.signum() / (zeta.abs() + zeta.hypot(1.0));
    let cosine = 1.0 / tangent.hypot(1.0);
    let sine = cosine * tangent;
    for matrix in [columns, right] {
        for row in 0..matrix[p].len() {
            let (a, b) = (matrix[p][row], matrix[q][row] * phase.conj());
            matrix[p][row] = a * cosine - b * sine;
            matrix[q][row] = a * sine + b * cosine;
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    fn c(re: f64, im: f64) -> Complex64 {
        Complex64::new(re, im)
    }

    #[test]
    fn the_residual_is_orthogonal_to_every_column() {
        let rows = vec![
            vec![c(1.0, 0.5), c(2e-6, 1e-6)],
            vec![c(-0.3, 1.0), c(1e-6, -3e-6)],
            vec![c(0.7, -0.2), c(-1e-6, 2e-6)],
            vec![c(0.1, 0.1), c(4e-6, 0.0)],
        ];
        let data = vec![c(1.0, 0.0), c(0.0, 2.0), c(-1.0, 1.0), c(0.5, -0.5)];
        let decomposition = Decomposition::of(&rows);
        let x = decomposition.solve(&data);
        for k in 0..2 {
            let inner: Complex64 = rows
                .iter()
                .zip(&data)
                .map(|(row, value)| row[k].conj() * (row[0] * x[0] + row[1] * x[1] - value))
                .sum();
            assert!(inner.norm() < 1e-14 * decomposition.lengths[k], "{inner}");
        }
        // Singular values of unit columns: sqrt(1 +- |cosine|).
        let cosine = rows.iter().map(|row| row[0].conj() * row[1]).sum::<Complex64>().norm()
            / (decomposition.lengths[0] * decomposition.lengths[1]);
        let expected = ((1.0 + cosine) / (1.0 - cosine)).sqrt();
        assert!((decomposition.condition() / expected - 1.0).abs() < 1e-12);
    }

    #[test]
    fn spread_is_the_inverse_of_the_normal_matrix() {
        let rows = vec![
            vec![c(1.0, 0.0), c(2.0, 0.0)],
            vec![c(1.0, 0.0), c(-1.0, 1.0)],
            vec![c(1.0, 0.0), c(0.0, 3.0)],
        ];
        let (a, b, d) = (3.0, c(1.0, 4.0), 15.0);
        let determinant = a * d - b.norm_sqr();
        let spread = Decomposition::of(&rows).spread();
        assert!((spread[0] - (d / determinant).sqrt()).abs() < 1e-14);
        assert!((spread[1] - (a / determinant).sqrt()).abs() < 1e-14);
    }

    #[test]
    fn what_has_no_effect_is_found() {
        let rows: Vec<Vec<Complex64>> = [c(1.0, 0.0), c(0.3, 2.0), c(-1.0, 1.0)]
            .iter()
            .map(|v| vec![*v, v * c(0.0, 2.0), c(1.0, 0.0)])
            .collect();
        let decomposition = Decomposition::of(&rows);
        assert!(!decomposition.is_full());
        let weakest = decomposition.weakest();
        assert!((weakest[0] - 0.5f64.sqrt()).abs() < 1e-12 && (weakest[1] - 0.5f64.sqrt()).abs() < 1e-12);
        assert!(weakest[2] < 1e-12);
        assert!(!Decomposition::of(&rows[..2]).is_full(), "fewer rows than unknowns");
    }
}
