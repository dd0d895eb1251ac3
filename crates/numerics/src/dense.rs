//! Dense linear systems by LU factors with partial pivoting.

use num_complex::Complex64;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Numbers that a matrix may hold: real or complex.
pub trait Scalar:
    Copy
    + Default
    + PartialEq
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Absolute value.
    fn size(self) -> f64;
}

impl Scalar for f64 {
    fn size(self) -> f64 {
        self.abs()
    }
}

impl Scalar for Complex64 {
    fn size(self) -> f64 {
        self.norm()
    }
}

/// Factors of a square matrix, `P A = L U`.
#[derive(Debug, Clone)]
pub struct Lu<T> {
    size: usize,
    factors: Vec<T>,
    pivots: Vec<usize>,
}

/// Factors of a complex matrix.
pub type ComplexLu = Lu<Complex64>;

impl<T: Scalar> Lu<T> {
    /// Factors of the `size` by `size` matrix given row by row. The error is the column in which no pivot is left: the
    /// matrix is singular, or holds a number that is none.
    pub fn new(size: usize, matrix: Vec<T>) -> Result<Lu<T>, usize> {
        assert_eq!(matrix.len(), size * size, "a matrix of {size} rows");
        let (mut a, mut pivots) = (matrix, vec![0; size]);
        for column in 0..size {
            let mut pivot = column;
            for row in column + 1..size {
                if a[row * size + column].size() > a[pivot * size + column].size() {
                    pivot = row;
                }
            }
            let largest = a[pivot * size + column];
            if !(largest.size() > 0.0 && largest.size().is_finite()) {
                return Err(column);
            }
            pivots[column] = pivot;
            if pivot != column {
                for k in 0..size {
                    a.swap(pivot * size + k, column * size + k);
                }
            }
            let (above, below) = a.split_at_mut((column + 1) * size);
            let top = &above[column * size..];
            for row in below.chunks_exact_mut(size) {
                if row[column] != T::default() {
                    let factor = row[column] / largest;
                    row[column] = factor;
                    for k in column + 1..size {
                        row[k] = row[k] - factor * top[k];
                    }
                }
            }
        }
        Ok(Lu { size, factors: a, pivots })
    }

    /// Solves `A x = b` in place.
    pub fn solve(&self, b: &mut [T]) {
        let (n, a) = (self.size, &self.factors);
        for i in 0..n {
            b.swap(i, self.pivots[i]);
        }
        for i in 1..n {
            let mut sum = b[i];
            for k in 0..i {
                sum = sum - a[i * n + k] * b[k];
            }
            b[i] = sum;
        }
        for i in (0..n).rev() {
            let mut sum = b[i];
            for k in i + 1..n {
                sum = sum - a[i * n + k] * b[k];
            }
            b[i] = sum / a[i * n + i];
        }
    }

    /// Smallest over largest pivot: a rough measure of how near the matrix is to a singular one.
    pub fn pivot_ratio(&self) -> f64 {
        let pivots = (0..self.size).map(|i| self.factors[i * self.size + i].size());
        let (small, large) = pivots.fold((f64::INFINITY, 0.0f64), |(s, l), p| (s.min(p), l.max(p)));
        if large > 0.0 { small / large } else { 1.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hilbert_system_is_solved_and_a_singular_matrix_named() {
        let n = 5;
        let hilbert: Vec<f64> = (0..n * n).map(|k| 1.0 / ((k / n + k % n + 1) as f64)).collect();
        let exact: Vec<f64> = (0..n).map(|i| i as f64 - 1.5).collect();
        let mut b: Vec<f64> = (0..n).map(|i| (0..n).map(|j| hilbert[i * n + j] * exact[j]).sum()).collect();
        Lu::new(n, hilbert).expect("regular").solve(&mut b);
        for (got, want) in b.iter().zip(&exact) {
            assert!((got - want).abs() < 1e-10, "{got} instead of {want}: condition 5e5 times rounding");
        }
        assert_eq!(Lu::new(2, vec![1.0, 2.0, 2.0, 4.0]).err(), Some(1));
        assert_eq!(Lu::new(2, vec![0.0, 0.0, 0.0, f64::NAN]).err(), Some(0));
    }

    #[test]
    fn complex_system_with_exchanged_rows() {
        let i = Complex64::i();
        let matrix = vec![Complex64::default(), 2.0 * i, 1.0 - i, 3.0.into()];
        let x = [Complex64::new(1.0, 2.0), Complex64::new(-0.5, 4.0)];
        let mut b = vec![matrix[1] * x[1], matrix[2] * x[0] + matrix[3] * x[1]];
        Lu::new(2, matrix).expect("regular").solve(&mut b);
        assert!((b[0] - x[0]).norm() + (b[1] - x[1]).norm() < 1e-14, "{b:?}");
    }
}
