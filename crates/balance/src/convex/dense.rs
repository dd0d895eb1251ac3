//! Small dense matrices: what a programme with some tens of variables needs, and no more.

use std::ops::{Index, IndexMut};

/// A matrix, row by row.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Matrix {
    pub rows: usize,
    pub columns: usize,
    data: Vec<f64>,
}

impl Matrix {
    pub fn zeros(rows: usize, columns: usize) -> Matrix {
        Matrix { rows, columns, data: vec![0.0; rows * columns] }
    }

    /// The matrix with these rows, all of length `columns`.
    pub fn from_rows<'a>(columns: usize, rows: impl IntoIterator<Item = &'a [f64]>) -> Matrix {
        let mut matrix = Matrix::zeros(0, columns);
        for row in rows {
            matrix.push(row);
        }
        matrix
    }

    pub fn push(&mut self, row: &[f64]) {
        assert_eq!(row.len(), self.columns, "invariant: rows are as long as the matrix is wide");
        self.data.extend_from_slice(row);
        self.rows += 1;
    }

    pub fn row(&self, i: usize) -> &[f64] {
        &self.data[i * self.columns..(i + 1) * self.columns]
    }

    pub fn row_mut(&mut self, i: usize) -> &mut [f64] {
        &mut self.data[i * self.columns..(i + 1) * self.columns]
    }

    /// `M x`.
    pub fn times(&self, x: &[f64]) -> Vec<f64> {
        (0..self.rows).map(|i| dot(self.row(i), x)).collect()
    }

    /// `|M| |x|`: what the parts of `M x` come to if none cancels another.
    pub fn amounts(&self, x: &[f64]) -> Vec<f64> {
        let amount = |row: &[f64]| row.iter().zip(x).map(|(a, b)| (a * b).abs()).sum();
        (0..self.rows).map(|i| amount(self.row(i))).collect()
    }

    /// Adds `factor M^T y` to `to`.
    pub fn add_transposed(&self, y: &[f64], factor: f64, to: &mut [f64]) {
        for i in 0..self.rows {
            add_scaled(to, factor * y[i], self.row(i));
        }
    }

    /// `M B`.
    pub fn product(&self, b: &Matrix) -> Matrix {
        let mut result = Matrix::zeros(self.rows, b.columns);
        for i in 0..self.rows {
            for k in 0..self.columns {
                let factor = self[(i, k)];
                if factor != 0.0 {
                    add_scaled(result.row_mut(i), factor, b.row(k));
                }
            }
        }
        result
    }

    /// `factor M`.
    pub fn scaled(&self, factor: f64) -> Matrix {
        let data = self.data.iter().map(|value| factor * value).collect();
        Matrix { rows: self.rows, columns: self.columns, data }
    }

    pub fn transposed(&self) -> Matrix {
        let mut result = Matrix::zeros(self.columns, self.rows);
        for i in 0..self.rows {
            for j in 0..self.columns {
                result[(j, i)] = self[(i, j)];
            }
        }
        result
    }
}

impl Index<(usize, usize)> for Matrix {
    type Output = f64;
    fn index(&self, (i, j): (usize, usize)) -> &f64 {
        &self.data[i * self.columns + j]
    }
}

impl IndexMut<(usize, usize)> for Matrix {
    fn index_mut(&mut self, (i, j): (usize, usize)) -> &mut f64 {
        &mut self.data[i * self.columns + j]
    }
}

pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(crate) fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

pub(crate) fn add_scaled(to: &mut [f64], factor: f64, row: &[f64]) {
    for (to, value) in to.iter_mut().zip(row) {
        *to += factor * value;
    }
}

/// `M^T P = Q R` by Householder reflections with pivoting: the rows of `M` are the columns that are factored.
pub(crate) struct RowFactors {
    /// Length of a row.
    size: usize,
    /// Reflectors `v`, each from its own index on, with `Q = SUM of (1 - beta v v^T)`.
    reflectors: Vec<(Vec<f64>, f64)>,
    /// Columns of `R` in pivot order.
    triangle: Vec<Vec<f64>>,
    /// Row of `M` at each place.
    order: Vec<usize>,
}

impl RowFactors {
    /// Factors the rows until what is left of every row is below `tolerance` times the longest row.
    pub fn of(matrix: &Matrix, tolerance: f64) -> RowFactors {
        let size = matrix.columns;
        let mut columns: Vec<Vec<f64>> = (0..matrix.rows).map(|i| matrix.row(i).to_vec()).collect();
        let mut order: Vec<usize> = (0..matrix.rows).collect();
        let mut reflectors: Vec<(Vec<f64>, f64)> = Vec::new();
        let mut longest = 0.0;
        for k in 0..size.min(matrix.rows) {
            let rest = |column: &Vec<f64>| norm(&column[k..]);
            let (best, length) = (k..columns.len())
                .map(|j| (j, rest(&columns[j])))
                .fold((k, -1.0), |best, one| if one.1 > best.1 { one } else { best });
            if k == 0 {
                longest = length;
            }
            if length <= tolerance * longest || length == 0.0 {
                break;
            }
            columns.swap(k, best);
            order.swap(k, best);
            let head = columns[k][k];
            let pivot = if head > 0.0 { -length } else { length };
            let mut v = columns[k][k..].to_vec();
            v[0] -= pivot;
            let square = dot(&v, &v);
            let beta = if square > 0.0 { 2.0 / square } else { 0.0 };
            for column in &mut columns[k..] {
                let factor = -beta * dot(&v, &column[k..]);
                add_scaled(&mut column[k..], factor, &v);
            }
            reflectors.push((v, beta));
        }
        RowFactors { size, reflectors, triangle: columns, order }
    }

    pub fn rank(&self) -> usize {
        self.reflectors.len()
    }

    /// `Q w`.
    fn rotate(&self, mut w: Vec<f64>) -> Vec<f64> {
        for (k, (v, beta)) in self.reflectors.iter().enumerate().rev() {
            let factor = -beta * dot(v, &w[k..]);
            add_scaled(&mut w[k..], factor, v);
        }
        w
    }

    /// `Q^T w`.
    fn turned(&self, w: &[f64]) -> Vec<f64> {
        let mut w = w.to_vec();
        for (k, (v, beta)) in self.reflectors.iter().enumerate() {
            let factor = -beta * dot(v, &w[k..]);
            add_scaled(&mut w[k..], factor, v);
        }
        w
    }

    /// Orthonormal bases as columns: of the space that the rows span, and of what they leave.
    pub fn bases(&self) -> (Matrix, Matrix) {
        let column = |k: usize| {
            let mut unit = vec![0.0; self.size];
            unit[k] = 1.0;
            self.rotate(unit)
        };
        let matrix = |range: std::ops::Range<usize>| {
            let columns: Vec<_> = range.map(column).collect();
            Matrix::from_rows(self.size, columns.iter().map(Vec::as_slice)).transposed()
        };
        (matrix(0..self.rank()), matrix(self.rank()..self.size))
    }

    /// The shortest `x` with `M x = b`, rows beyond the rank left aside.
    pub fn shortest(&self, b: &[f64]) -> Vec<f64> {
        let mut w = vec![0.0; self.size];
        for k in 0..self.rank() {
            let column = &self.triangle[k];
            w[k] = (b[self.order[k]] - dot(&column[..k], &w[..k])) / column[k];
        }
        self.rotate(w)
    }

    /// A lower bound of the smallest singular value of the factored rows.
    pub fn least_singular_value(&self) -> f64 {
        let rank = self.rank();
        // || R^-1 || column by column.
        let mut square = 0.0;
        for j in 0..rank {
            let mut x = vec![0.0; rank];
            x[j] = 1.0;
            for i in (0..=j).rev() {
                x[i] /= self.triangle[i][i];
                for above in 0..i {
                    x[above] -= self.triangle[i][above] * x[i];
                }
            }
            square += dot(&x, &x);
        }
        if square > 0.0 { 1.0 / square.sqrt() } else { 0.0 }
    }
}

/// The `x` with the smallest `|M x - b|`, for independent columns (dependent ones get 0).
pub(crate) fn least_squares(matrix: &Matrix, b: &[f64], tolerance: f64) -> Vec<f64> {
    let factors = RowFactors::of(&matrix.transposed(), tolerance);
    let right = factors.turned(b);
    let mut x = vec![0.0; matrix.columns];
    let mut solved = vec![0.0; factors.rank()];
    for k in (0..factors.rank()).rev() {
        let sum: f64 = (k + 1..factors.rank()).map(|j| factors.triangle[j][k] * solved[j]).sum();
        solved[k] = (right[k] - sum) / factors.triangle[k][k];
        x[factors.order[k]] = solved[k];
    }
    x
}

/// Fewer rows with the same length: `|R x + c| = |M x + b|` for every `x`, but for parts of `M` below `tolerance` times its
/// longest column. The last row of `R` is 0.
pub(crate) fn shortened(matrix: &Matrix, b: &[f64], tolerance: f64) -> (Matrix, Vec<f64>) {
    let factors = RowFactors::of(&matrix.transposed(), tolerance);
    let right = factors.turned(b);
    let rank = factors.rank();
    let mut short = Matrix::zeros(rank + 1, matrix.columns);
    for k in 0..rank {
        for j in k..matrix.columns {
            short[(k, factors.order[j])] = factors.triangle[j][k];
        }
    }
    let mut constant = right[..rank].to_vec();
    constant.push(norm(&right[rank..]));
    (short, constant)
}

/// Solves the square system in place by elimination with pivoting; `None` if it is singular.
pub(crate) fn eliminate(mut matrix: Matrix, mut b: Vec<f64>) -> Option<Vec<f64>> {
    let size = matrix.rows;
    let mut rows: Vec<usize> = (0..size).collect();
    for k in 0..size {
        let best = (k..size)
            .max_by(|&i, &j| matrix[(rows[i], k)].abs().total_cmp(&matrix[(rows[j], k)].abs()))
            .expect("invariant: k < size");
        rows.swap(k, best);
        let pivot_row = rows[k];
        let pivot = matrix[(pivot_row, k)];
        if pivot == 0.0 || !pivot.is_finite() {
            return None;
        }
        let upper: Vec<f64> = matrix.row(pivot_row)[k..].to_vec();
        for &row in &rows[k + 1..] {
            let factor = -matrix[(row, k)] / pivot;
            if factor != 0.0 {
                add_scaled(&mut matrix.row_mut(row)[k..], factor, &upper);
                b[row] += factor * b[pivot_row];
            }
        }
    }
    let mut x = vec![0.0; size];
    for k in (0..size).rev() {
        let row = rows[k];
        x[k] = (b[row] - dot(&matrix.row(row)[k + 1..], &x[k + 1..])) / matrix[(row, k)];
    }
    x.iter().all(|v| v.is_finite()).then_some(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix(columns: usize, rows: &[&[f64]]) -> Matrix {
        Matrix::from_rows(columns, rows.iter().copied())
    }

    #[test]
    fn bases_are_orthonormal_and_split_the_space() {
        let m = matrix(4, &[&[1.0, 2.0, 0.0, 1.0], &[2.0, 4.0, 0.0, 2.0], &[0.0, 1.0, 3.0, -1.0]]);
        let factors = RowFactors::of(&m, 1e-12);
        assert_eq!(factors.rank(), 2);
        let (range, null) = factors.bases();
        assert_eq!((range.columns, null.columns), (2, 2));
        let zero = m.product(&null);
        assert!((0..3).all(|i| norm(zero.row(i)) < 1e-14));
        let unit = null.transposed().product(&null);
        for i in 0..2 {
            for j in 0..2 {
                assert!((unit[(i, j)] - f64::from(u8::from(i == j))).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn shortest_and_least_squares_solutions() {
        let m = matrix(3, &[&[1.0, 1.0, 0.0], &[0.0, 1.0, 1.0]]);
        let x = RowFactors::of(&m, 1e-12).shortest(&[1.0, 1.0]);
        for (got, want) in x.iter().zip([1.0 / 3.0, 2.0 / 3.0, 1.0 / 3.0]) {
            assert!((got - want).abs() < 1e-14);
        }
        let m = matrix(2, &[&[1.0, 0.0], &[1.0, 1.0], &[1.0, 2.0]]);
        let x = least_squares(&m, &[1.0, 2.0, 4.0], 1e-12);
        assert!((x[0] - 5.0 / 6.0).abs() < 1e-14 && (x[1] - 1.5).abs() < 1e-14, "{x:?}");
    }

    #[test]
    fn fewer_rows_have_the_same_length() {
        let m = matrix(
            3,
            &[&[1.0, 2.0, 3.0], &[0.0, 1.0, 1.0], &[2.0, 4.0, 6.0], &[1.0, 0.0, 1.0], &[3.0, 1.0, 4.0]],
        );
        let b = [1.0, -2.0, 0.5, 3.0, 0.0];
        let (short, constant) = shortened(&m, &b, 1e-13);
        assert_eq!((short.rows, short.columns), (3, 3), "two of three columns are independent");
        for x in [[0.0; 3], [1.0, -2.0, 0.5], [0.3, 7.0, -4.0]] {
            let long: Vec<f64> = m.times(&x).iter().zip(&b).map(|(a, b)| a + b).collect();
            let less: Vec<f64> = short.times(&x).iter().zip(&constant).map(|(a, b)| a + b).collect();
            assert!((norm(&long) - norm(&less)).abs() < 1e-14 * norm(&long));
        }
    }

    #[test]
    fn elimination_solves_and_refuses() {
        let m = matrix(2, &[&[0.0, 2.0], &[3.0, 1.0]]);
        let x = eliminate(m, vec![4.0, 5.0]).unwrap();
        assert!((x[0] - 1.0).abs() < 1e-15 && (x[1] - 2.0).abs() < 1e-15);
        assert_eq!(eliminate(matrix(2, &[&[1.0, 1.0], &[1.0, 1.0]]), vec![1.0, 2.0]), None);
    }
}
