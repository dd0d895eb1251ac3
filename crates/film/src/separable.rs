//! The full film without tilt and feeds: cosines along the axis are exact modes of the cells, each a tridiagonal ring.

use crate::cells::Cells;
use crate::grid::FilmGrid;
use std::f64::consts::PI;

/// Modes of the axis and work of the rings, all modes side by side so that the machine's vectors hold them.
#[derive(Debug, Clone, Default)]
pub(crate) struct Separable {
    axial: usize,
    /// Mode k at cell j, k m + j; its eigenvalue; share of a constant in it.
    shape: Vec<f64>,
    value: Vec<f64>,
    share: Vec<f64>,
    /// Elimination: multiplier to the next column, right side, and the column that closes the ring.
    upper: Vec<f64>,
    right: Vec<f64>,
    ring: Vec<f64>,
    squeeze: Vec<f64>,
}

impl Separable {
    /// Modes for so many cells on half the length.
    pub fn place(&mut self, grid: &FilmGrid) {
        let m = grid.axial;
        self.axial = m;
        let cells = m as f64;
        self.shape.clear();
        self.value.clear();
        self.share.clear();
        for k in 0..m {
            let wave = (k as f64 + 0.5) * PI / cells;
            self.value.push((2.0 - 2.0 * wave.cos()) * cells * cells);
            let shape: Vec<f64> = (0..m).map(|j| (wave * (j as f64 + 0.5)).cos()).collect();
            self.share.push(2.0 / cells * shape.iter().sum::<f64>());
            self.shape.extend(shape);
        }
        let n = grid.around();
        for buffer in [&mut self.upper, &mut self.right, &mut self.ring] {
            buffer.resize(n * m, 0.0);
        }
        self.squeeze.resize(n, 0.0);
    }

    /// Solves for P in all cells from the sources of the columns.
    pub fn solve(&mut self, cells: &Cells, slenderness: f64, p: &mut [f64]) {
        let (n, m) = (cells.around, self.axial);
        let kappa = slenderness.powi(-2);
        for i in 0..n {
            self.squeeze[i] = kappa * cells.thickness[i * m].powi(3) * cells.width[i];
        }
        // The last column is set apart: x_i = r_i + s_i x_last for the others.
        for i in 0..n - 1 {
            let west = cells.east[(i + n - 1) % n * m];
            let east = cells.east[i * m];
            let source = cells.source[i * m];
            let (before, now) = (i.saturating_sub(1) * m, i * m);
            for k in 0..m {
                let mut diagonal = west + east + self.squeeze[i] * self.value[k];
                let mut right = source * self.share[k];
                let mut ring = 0.0;
                if i == 0 {
                    ring = west;
                } else {
                    diagonal -= west * self.upper[before + k];
                    right += west * self.right[before + k];
                    ring += west * self.ring[before + k];
                }
                if i == n - 2 {
                    ring += east;
                }
                let inverse = 1.0 / diagonal;
                self.upper[now + k] = east * inverse;
                self.right[now + k] = right * inverse;
                self.ring[now + k] = ring * inverse;
            }
        }
        for i in (0..n - 2).rev() {
            let now = i * m;
            for k in 0..m {
                self.right[now + k] += self.upper[now + k] * self.right[now + m + k];
                self.ring[now + k] += self.upper[now + k] * self.ring[now + m + k];
            }
        }
        let last = n - 1;
        let (west, east) = (cells.east[(n - 2) * m], cells.east[last * m]);
        for k in 0..m {
            let before = (n - 2) * m + k;
            let diagonal = west + east + self.squeeze[last] * self.value[k]
                - west * self.ring[before]
                - east * self.ring[k];
            let right =
                cells.source[last * m] * self.share[k] + west * self.right[before] + east * self.right[k];
            self.right[last * m + k] = right / diagonal;
        }
        for i in 0..n {
            let row = &mut p[i * m..(i + 1) * m];
            row.fill(0.0);
            for k in 0..m {
                let mut amplitude = self.right[i * m + k];
                if i < last {
                    amplitude += self.ring[i * m + k] * self.right[last * m + k];
                }
                for (value, shape) in row.iter_mut().zip(&self.shape[k * m..(k + 1) * m]) {
                    *value += amplitude * shape;
                }
            }
        }
    }
}
