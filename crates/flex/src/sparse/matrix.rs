//! A sparse symmetric matrix by the columns of its lower triangle.

use lanchester_numerics::{Kernel, dispatch};
use std::ops::Range;
use std::sync::Arc;

/// Vectors that share each entry of the matrix that is read: a few, and more than a few.
const NARROW: usize = 4;
const WIDEST: usize = 8;
/// Sums that a scalar product runs side by side.
const LANES: usize = 8;

/// Where the entries of the lower triangle are.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Pattern {
    /// First entry of each column, and the number of all.
    pub starts: Vec<u32>,
    /// Row of each entry, rising within a column, from the diagonal on.
    pub rows: Vec<u32>,
}

/// A symmetric matrix, of which the lower triangle is stored column by column.
#[derive(Debug, Clone, PartialEq)]
pub struct SymmetricMatrix {
    /// Where the entries are; matrices of one mesh share it.
    pub pattern: Arc<Pattern>,
    /// The entries.
    pub values: Vec<f64>,
}

impl SymmetricMatrix {
    /// Rows and columns.
    pub fn size(&self) -> usize {
        self.pattern.starts.len() - 1
    }

    /// `y = A x`.
    pub fn multiply(&self, x: &[f64], y: &mut [f64]) {
        self.multiply_of(x, y, |value| value);
    }

    /// `y = |A| |x|`, of the sizes of all entries: what the sums of `A x` are rounded against.
    pub fn multiply_sizes(&self, x: &[f64], y: &mut [f64]) {
        let sizes: Vec<f64> = x.iter().map(|value| value.abs()).collect();
        self.multiply_of(&sizes, y, f64::abs);
    }

    fn multiply_of(&self, x: &[f64], y: &mut [f64], of: impl Fn(f64) -> f64) {
        assert_eq!(x.len(), self.size(), "invariant: a vector has as many entries as the matrix has columns");
        y.fill(0.0);
        for column in 0..self.size() {
            let range = self.pattern.starts[column] as usize..self.pattern.starts[column + 1] as usize;
            let (rows, values) = (&self.pattern.rows[range.clone()], &self.values[range]);
            let mut sum = of(values[0]) * x[column];
            let factor = x[column];
            for (row, value) in rows[1..].iter().zip(&values[1..]) {
                y[*row as usize] += of(*value) * factor;
                sum += of(*value) * x[*row as usize];
            }
            y[column] += sum;
        }
    }

    /// `A x` of several vectors: some of them share each entry of the matrix that is read.
    pub fn multiply_all<V: AsRef<[f64]>>(&self, vectors: &[V]) -> Vec<Vec<f64>> {
        let products = vectors.chunks(WIDEST).map(|some| {
            if some.len() <= NARROW {
                self.multiply_some::<NARROW, V>(some)
            } else {
                self.multiply_some::<WIDEST, V>(some)
            }
        });
        products.flatten().collect()
    }

    /// At most `WIDTH` vectors, their entries of one row side by side; two halves of the entries on two threads.
    fn multiply_some<const WIDTH: usize, V: AsRef<[f64]>>(&self, vectors: &[V]) -> Vec<Vec<f64>> {
        let size = self.size();
        let mut x = vec![[0.0; WIDTH]; size];
        for (k, vector) in vectors.iter().enumerate() {
            let vector = vector.as_ref();
            assert_eq!(
                vector.len(),
                size,
                "invariant: a vector has as many entries as the matrix has columns"
            );
            x.iter_mut().zip(vector).for_each(|(x, value)| x[k] = *value);
        }
        let half =
            self.pattern.starts.partition_point(|start| *start < self.values.len() as u32 / 2).min(size);
        let part = |columns: Range<usize>| {
            let mut y = vec![[0.0; WIDTH]; size];
            dispatch(Product { matrix: self, columns, x: &x, y: &mut y });
            y
        };
        let (y, other) = rayon::join(|| part(0..half), || part(half..size));
        (0..vectors.len()).map(|k| y.iter().zip(&other).map(|(y, other)| y[k] + other[k]).collect()).collect()
    }

    /// `x^T A x`.
    pub fn form(&self, x: &[f64]) -> f64 {
        let mut y = vec![0.0; x.len()];
        self.multiply(x, &mut y);
        dot(x, &y)
    }

    /// `A + s B`, both of one pattern.
    pub fn plus(&self, factor: f64, other: &SymmetricMatrix) -> SymmetricMatrix {
        assert_eq!(self.values.len(), other.values.len(), "invariant: matrices of one mesh have one pattern");
        let values = self.values.iter().zip(&other.values).map(|(a, b)| a + factor * b).collect();
        SymmetricMatrix { pattern: self.pattern.clone(), values }
    }

    /// Rows and columns that are kept, numbered anew in their order.
    pub fn restricted(&self, kept: &[bool]) -> SymmetricMatrix {
        let mut number = vec![u32::MAX; kept.len()];
        for (count, index) in (0..kept.len()).filter(|index| kept[*index]).enumerate() {
            number[index] = count as u32;
        }
        let mut pattern = Pattern { starts: vec![0], rows: Vec::with_capacity(self.pattern.rows.len()) };
        let mut values = Vec::with_capacity(self.values.len());
        for column in (0..kept.len()).filter(|column| kept[*column]) {
            for place in self.pattern.starts[column] as usize..self.pattern.starts[column + 1] as usize {
                let row = number[self.pattern.rows[place] as usize];
                if row != u32::MAX {
                    pattern.rows.push(row);
                    values.push(self.values[place]);
                }
            }
            pattern.starts.push(pattern.rows.len() as u32);
        }
        SymmetricMatrix { pattern: Arc::new(pattern), values }
    }

    /// The diagonal.
    pub fn diagonal(&self) -> Vec<f64> {
        (0..self.size()).map(|column| self.values[self.pattern.starts[column] as usize]).collect()
    }
}

/// What some columns, and the rows that mirror them, give to `A x`.
struct Product<'a, const WIDTH: usize> {
    matrix: &'a SymmetricMatrix,
    columns: Range<usize>,
    x: &'a [[f64; WIDTH]],
    y: &'a mut [[f64; WIDTH]],
}

impl<const WIDTH: usize> Kernel for Product<'_, WIDTH> {
    /// Never fused: the same bits on every machine.
    #[inline(always)]
    fn run<const FMA: bool>(self) {
        let Product { matrix, columns, x, y } = self;
        for column in columns {
            let range = matrix.pattern.starts[column] as usize..matrix.pattern.starts[column + 1] as usize;
            let (rows, values) = (&matrix.pattern.rows[range.clone()], &matrix.values[range]);
            let factors = x[column];
            let mut sums = factors.map(|factor| values[0] * factor);
            for (row, value) in rows[1..].iter().zip(&values[1..]) {
                let (mut to, from) = (y[*row as usize], x[*row as usize]);
                for k in 0..WIDTH {
                    to[k] += value * factors[k];
                    sums[k] += value * from[k];
                }
                y[*row as usize] = to;
            }
            for (to, sum) in y[column].iter_mut().zip(sums) {
                *to += sum;
            }
        }
    }
}

/// Scalar product.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (wholes, rest) = (a.chunks_exact(LANES), b.chunks_exact(LANES));
    let tail: f64 = wholes.remainder().iter().zip(rest.remainder()).map(|(a, b)| a * b).sum();
    let mut sums = [0.0; LANES];
    for (a, b) in wholes.zip(rest) {
        for k in 0..LANES {
            sums[k] += a[k] * b[k];
        }
    }
    sums.iter().sum::<f64>() + tail
}

/// `y += a x`.
pub(crate) fn add(y: &mut [f64], a: f64, x: &[f64]) {
    y.iter_mut().zip(x).for_each(|(y, x)| *y += a * x);
}

/// Euclidean norm.
pub(crate) fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}
