//! Direct solution of banded systems without pivoting, for matrices that are diagonally dominant or positive definite.

use lanchester_numerics::{Kernel, dispatch};

/// Entries of the widest vectors: rows are padded to a multiple of it, and the first is put where vectors are read in one piece.
const LANES: usize = 8;

/// A band with its right side: row i holds columns i - width ..= i + width.
///
/// Column j of every row lies in lane `j mod (2 width + 1)`, so that rows meet one another in the same lanes and no vector is shifted. The lane behind them holds
/// the right side, which is eliminated as if it were a column.
#[derive(Debug, Clone, Default)]
pub(crate) struct Band {
    size: usize,
    width: usize,
    stride: usize,
    /// Lane of every column.
    lane: Vec<usize>,
    /// Where the rows begin.
    start: usize,
    entries: Vec<f64>,
}

impl Band {
    /// All zero.
    pub fn reset(&mut self, size: usize, width: usize) {
        (self.size, self.width) = (size, width);
        let lanes = 2 * width + 1;
        self.stride = (lanes + 1).next_multiple_of(LANES);
        self.lane.clear();
        self.lane.extend((0..lanes).cycle().take(size));
        self.entries.clear();
        self.entries.resize(size * self.stride + LANES, 0.0);
        self.start = self.entries.as_ptr().align_offset(LANES * size_of::<f64>()).min(LANES);
    }

    /// Adds to entry (i, j).
    #[inline]
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        self.entries[self.start + i * self.stride + self.lane[j]] += value;
    }

    /// Adds to the right side of row i.
    #[inline]
    pub fn add_right(&mut self, i: usize, value: f64) {
        self.entries[self.start + i * self.stride + 2 * self.width + 1] += value;
    }

    /// Eliminates in place and puts the solution into `x`.
    pub fn solve(&mut self, x: &mut Vec<f64>) {
        x.clear();
        x.resize(self.size, 0.0);
        // Rows of common films have a constant length: the one that eliminates stays in vectors.
        match self.stride {
            16 => dispatch(Elimination::<16> { band: self, x }),
            24 => dispatch(Elimination::<24> { band: self, x }),
            32 => dispatch(Elimination::<32> { band: self, x }),
            40 => dispatch(Elimination::<40> { band: self, x }),
            48 => dispatch(Elimination::<48> { band: self, x }),
            _ => self.solve_any(x),
        }
    }

    fn rows(&mut self) -> &mut [f64] {
        let count = self.size * self.stride;
        &mut self.entries[self.start..][..count]
    }

    fn solve_any(&mut self, x: &mut [f64]) {
        let (width, stride, lanes) = (self.width, self.stride, std::mem::take(&mut self.lane));
        let rows = self.rows();
        for (k, &lane) in lanes.iter().enumerate() {
            let (pivot, rows) = rows[k * stride..].split_at_mut(stride);
            let inverse = 1.0 / pivot[lane];
            for row in rows.chunks_exact_mut(stride).take(width) {
                let factor = row[lane] * inverse;
                for (entry, above) in row.iter_mut().zip(&*pivot) {
                    *entry -= factor * above;
                }
            }
            pivot[lane] = inverse;
        }
        for (k, &lane) in lanes.iter().enumerate().rev() {
            let (rows, own) = rows.split_at_mut(k * stride);
            x[k] = own[2 * width + 1] * own[lane];
            for row in rows.rchunks_exact_mut(stride).take(width) {
                row[2 * width + 1] -= row[lane] * x[k];
            }
        }
        self.lane = lanes;
    }
}

struct Elimination<'a, const S: usize> {
    band: &'a mut Band,
    x: &'a mut [f64],
}

impl<const S: usize> Kernel for Elimination<'_, S> {
    #[inline(always)]
    fn run<const FMA: bool>(self) {
        let less = |value: f64, factor: f64, by: f64| {
            if FMA { factor.mul_add(-by, value) } else { value - factor * by }
        };
        let (width, right) = (self.band.width, (2 * self.band.width + 1) % S);
        let lanes = std::mem::take(&mut self.band.lane);
        let rows = self.band.rows().as_chunks_mut::<S>().0;
        for (k, lane) in lanes.iter().enumerate() {
            let lane = lane % S;
            let (pivot, rows) = rows[k..].split_first_mut().expect("as many rows as lanes");
            let inverse = 1.0 / pivot[lane];
            // Copies: what lies in vectors is not read again for every row.
            let above = *pivot;
            for row in rows.iter_mut().take(width) {
                let (entries, factor) = (*row, row[lane] * inverse);
                *row = std::array::from_fn(|l| less(entries[l], factor, above[l]));
            }
            pivot[lane] = inverse;
        }
        for (k, lane) in lanes.iter().enumerate().rev() {
            let lane = lane % S;
            let (rows, own) = rows.split_at_mut(k);
            let value = own[0][right] * own[0][lane];
            self.x[k] = value;
            for row in rows.iter_mut().rev().take(width) {
                row[right] = less(row[right], row[lane], value);
            }
        }
        self.band.lane = lanes;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_band_solves_what_it_holds() {
        for (size, width) in [(1, 1), (9, 3), (17, 10), (5, 4), (20, 6), (60, 20), (90, 35)] {
            for skew in [0.0, 0.3] {
                check(size, width, skew);
            }
        }
    }

    fn check(size: usize, width: usize, skew: f64) {
        let value = |i: usize, j: usize| {
            let even = if i == j { 2.0 * width as f64 + i as f64 } else { -1.0 / (1.0 + (i + j) as f64) };
            even + if j > i { skew } else { 0.0 }
        };
        let mut band = Band::default();
        // What was there before leaves no trace.
        band.reset(size + 3, width + 1);
        band.reset(size, width);
        let wanted: Vec<f64> = (0..size).map(|i| 1.0 + (i as f64).sin()).collect();
        for i in 0..size {
            for j in i.saturating_sub(width)..(i + width + 1).min(size) {
                band.add(i, j, value(i, j));
                band.add_right(i, value(i, j) * wanted[j]);
            }
        }
        let mut x = vec![7.0];
        band.solve(&mut x);
        assert_eq!(x.len(), size);
        for (x, wanted) in x.iter().zip(&wanted) {
            assert!((x - wanted).abs() < 1e-13, "{size} {width}: {x} for {wanted}");
        }
    }
}
