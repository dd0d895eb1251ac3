//! Direct solution of banded systems without pivoting, for matrices that are diagonally dominant or positive definite.

/// Symmetric positive definite band: row i holds columns i ..= i + width.
#[derive(Debug, Clone, Default)]
pub(crate) struct SymmetricBand {
    size: usize,
    width: usize,
    rows: Vec<f64>,
}

impl SymmetricBand {
    /// All zero.
    pub fn reset(&mut self, size: usize, width: usize) {
        (self.size, self.width) = (size, width);
        self.rows.clear();
        self.rows.resize(size * (width + 1), 0.0);
    }

    /// Adds to entry (i, j) and its mirror.
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        let (low, high) = (i.min(j), i.max(j));
        self.rows[low * (self.width + 1) + high - low] += value;
    }

    /// Factor in place, then the solution in place of `b`.
    pub fn solve(&mut self, b: &mut [f64]) {
        // Widths of common films as constants: the compiler unrolls and vectorises their loops.
        match self.width {
            6 => self.solve_fixed::<7>(b),
            8 => self.solve_fixed::<9>(b),
            10 => self.solve_fixed::<11>(b),
            12 => self.solve_fixed::<13>(b),
            _ => self.solve_any(b),
        }
    }

    /// S = width + 1.
    fn solve_fixed<const S: usize>(&mut self, b: &mut [f64]) {
        let (rows, _) = self.rows.as_chunks_mut::<S>();
        for k in 0..rows.len() {
            let pivot = rows[k];
            let inverse = 1.0 / pivot[0];
            let last = (S - 1).min(rows.len() - 1 - k);
            let value = b[k];
            for i in 1..=last {
                let factor = pivot[i] * inverse;
                let row = &mut rows[k + i];
                for j in 0..S - i {
                    row[j] -= factor * pivot[i + j];
                }
                b[k + i] -= factor * value;
            }
        }
        for k in (0..rows.len()).rev() {
            let last = (S - 1).min(rows.len() - 1 - k);
            let sum: f64 = rows[k][1..=last].iter().zip(&b[k + 1..]).map(|(u, x)| u * x).sum();
            b[k] = (b[k] - sum) / rows[k][0];
        }
    }

    fn solve_any(&mut self, b: &mut [f64]) {
        let stride = self.width + 1;
        for k in 0..self.size {
            let last = self.width.min(self.size - 1 - k);
            let (head, tail) = self.rows.split_at_mut((k + 1) * stride);
            let pivot = &head[k * stride..];
            let inverse = 1.0 / pivot[0];
            for i in 1..=last {
                let factor = pivot[i] * inverse;
                let row = &mut tail[(i - 1) * stride..(i - 1) * stride + last + 1 - i];
                for (entry, above) in row.iter_mut().zip(&pivot[i..=last]) {
                    *entry -= factor * above;
                }
                b[k + i] -= factor * b[k];
            }
        }
        for k in (0..self.size).rev() {
            let last = self.width.min(self.size - 1 - k);
            let row = &self.rows[k * stride..k * stride + last + 1];
            let sum: f64 = row[1..].iter().zip(&b[k + 1..]).map(|(u, x)| u * x).sum();
            b[k] = (b[k] - sum) / row[0];
        }
    }
}

/// General band: row i holds columns i - width ..= i + width.
#[derive(Debug, Clone, Default)]
pub(crate) struct Band {
    size: usize,
    width: usize,
    rows: Vec<f64>,
}

impl Band {
    /// All zero.
    pub fn reset(&mut self, size: usize, width: usize) {
        (self.size, self.width) = (size, width);
        self.rows.clear();
        self.rows.resize(size * (2 * width + 1), 0.0);
    }

    /// Adds to entry (i, j).
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        self.rows[i * (2 * self.width + 1) + self.width + j - i] += value;
    }

    /// Factors in place, then the solution in place of `b`.
    pub fn solve(&mut self, b: &mut [f64]) {
        let (w, stride) = (self.width, 2 * self.width + 1);
        for k in 0..self.size {
            let last = w.min(self.size - 1 - k);
            let (head, tail) = self.rows.split_at_mut((k + 1) * stride);
            let pivot = &head[k * stride + w..k * stride + w + last + 1];
            for i in 1..=last {
                let row = &mut tail[(i - 1) * stride + w - i..(i - 1) * stride + w - i + last + 1];
                if row[0] == 0.0 {
                    continue;
                }
                let factor = row[0] / pivot[0];
                for (entry, above) in row[1..].iter_mut().zip(&pivot[1..]) {
                    *entry -= factor * above;
                }
                b[k + i] -= factor * b[k];
            }
        }
        for k in (0..self.size).rev() {
            let last = w.min(self.size - 1 - k);
            let row = &self.rows[k * stride + w..k * stride + w + last + 1];
            let sum: f64 = row[1..].iter().zip(&b[k + 1..]).map(|(u, x)| u * x).sum();
            b[k] = (b[k] - sum) / row[0];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_bands_solve_what_they_hold() {
        for (size, width) in [(9, 3), (17, 10), (5, 4), (20, 6)] {
            check(size, width);
        }
    }

    fn check(size: usize, width: usize) {
        let entry = |i: usize, j: usize| if i == j { 8.0 + i as f64 } else { -1.0 / (1.0 + (i + j) as f64) };
        let (mut symmetric, mut general) = (SymmetricBand::default(), Band::default());
        symmetric.reset(size, width);
        general.reset(size, width);
        let wanted: Vec<f64> = (0..size).map(|i| 1.0 + (i as f64).sin()).collect();
        let (mut b, mut c) = (vec![0.0; size], vec![0.0; size]);
        for i in 0..size {
            for j in i.saturating_sub(width)..(i + width + 1).min(size) {
                if j >= i {
                    symmetric.add(i, j, entry(i, j));
                }
                // The general one is made unsymmetric.
                let other = entry(i, j) + if j > i { 0.3 } else { 0.0 };
                general.add(i, j, other);
                b[i] += entry(i, j) * wanted[j];
                c[i] += other * wanted[j];
            }
        }
        symmetric.solve(&mut b);
        general.solve(&mut c);
        for i in 0..size {
            assert!((b[i] - wanted[i]).abs() < 1e-13 && (c[i] - wanted[i]).abs() < 1e-13);
        }
    }
}
