//! The crankshaft in few coordinates: natural modes and static shapes, orthonormal in the mass, in the frame that turns with it.
//!
//! ```text
//! q'' + (D + 2 W G) q' + (K - W^2 (N - S) + W' G) q = W^2 f_c - W' f_e + SUM (R E C)^T f  (book, eq. 51.4)
//! L = q'.(f_e + G q) + W (J + 2 f_c.q + q.(N - S) q)                                     (book, eq. 51.5)
//! ```
//! `L` is the moment of momentum about the crank axis: its rate less the moments of all forces is the torque that drives.

use super::plane::Plane;
use crate::eigen::symmetric_eigen;
use crate::sparse::dot;
use lanchester_numerics::Lu;

/// A body in coordinates that are orthonormal in its mass.
#[derive(Debug, Clone, PartialEq)]
pub struct CrankBody {
    /// Squares of the natural frequencies [rad^2/s^2], zero of rigid motions.
    pub stiffness: Vec<f64>,
    /// Damping `D`, by rows [1/s].
    pub damping: Vec<f64>,
    /// `G`, by rows: skew.
    pub gyroscopic: Vec<f64>,
    /// `N - S`, by rows: half its form is what deformation adds to half the inertia about the axis.
    pub centrifugal: Vec<f64>,
    /// `f_c`.
    pub centrifugal_load: Vec<f64>,
    /// `f_e`.
    pub euler_load: Vec<f64>,
    /// Polar moment of inertia about the crank axis [kg m^2].
    pub polar: f64,
    /// Displacement of each bearing surface in the crankshaft's frame: rows of x and y.
    pub rows: Vec<[Vec<f64>; 2]>,
    /// Mean rotation of each bearing surface about the bar's own axis.
    pub turns: Vec<Vec<f64>>,
    /// Slope along z of each bearing surface: rows of x and y.
    pub slopes: Vec<[Vec<f64>; 2]>,
    /// Mean rotation of the flywheel's end face.
    pub turning: Vec<f64>,
}

/// What a body is held by, and how its coordinates follow from those that are left.
#[derive(Debug, Clone)]
pub(crate) struct Held {
    /// Held rows, in the coordinates of the whole body.
    rows: Vec<Vec<f64>>,
    /// Coordinates of the whole body for a unit of each that is left.
    transform: Vec<Vec<f64>>,
    /// Factors of `C C^T`.
    gram: Option<Lu<f64>>,
    size: usize,
}

impl Held {
    /// Coordinates of the whole body.
    pub fn whole(&self, left: &[f64]) -> Vec<f64> {
        let mut q = vec![0.0; self.size];
        for (column, z) in self.transform.iter().zip(left) {
            for (q, t) in q.iter_mut().zip(column) {
                *q += z * t;
            }
        }
        q
    }

    /// Forces of what holds, from the rest of the equations of motion of the whole body: `C^T f = rest`.
    pub fn forces(&self, rest: &[f64]) -> Vec<f64> {
        let mut side: Vec<f64> = self.rows.iter().map(|row| dot(row, rest)).collect();
        if let Some(gram) = &self.gram {
            gram.solve(&mut side);
        }
        side
    }
}

impl CrankBody {
    /// Number of coordinates.
    pub fn size(&self) -> usize {
        self.stiffness.len()
    }

    /// Displacement of a bearing surface.
    pub fn displacement(&self, bearing: usize, q: &[f64]) -> Plane {
        [0, 1].map(|k| dot(&self.rows[bearing][k], q))
    }

    /// Slope of a bearing surface.
    pub fn slope(&self, bearing: usize, q: &[f64]) -> Plane {
        [0, 1].map(|k| dot(&self.slopes[bearing][k], q))
    }

    /// The same body so many times as stiff, at the same share of critical damping.
    pub fn stiffened(&self, factor: f64) -> CrankBody {
        let mut body = self.clone();
        body.stiffness.iter_mut().for_each(|k| *k *= factor);
        body.damping.iter_mut().for_each(|d| *d *= factor.sqrt());
        body
    }

    /// The rigid body: its rigid motions alone.
    pub fn rigid(&self) -> CrankBody {
        let kept: Vec<usize> = (0..self.size()).filter(|k| self.stiffness[*k] == 0.0).collect();
        let unit = |k: &usize| {
            let mut column = vec![0.0; self.size()];
            column[*k] = 1.0;
            column
        };
        self.transformed(&kept.iter().map(unit).collect::<Vec<_>>(), vec![0.0; kept.len()])
    }

    /// The body in other coordinates, orthonormal combinations of its own with these squares of frequencies.
    fn transformed(&self, columns: &[Vec<f64>], stiffness: Vec<f64>) -> CrankBody {
        let line = |row: &[f64]| -> Vec<f64> { columns.iter().map(|column| dot(row, column)).collect() };
        let square = |matrix: &[f64]| -> Vec<f64> {
            let n = self.size();
            let images: Vec<Vec<f64>> = columns
                .iter()
                .map(|column| matrix.chunks(n.max(1)).map(|row| dot(row, column)).collect())
                .collect();
            columns.iter().flat_map(|left| images.iter().map(|image| dot(left, image))).collect()
        };
        let pair = |rows: &[Vec<f64>; 2]| [line(&rows[0]), line(&rows[1])];
        CrankBody {
            stiffness,
            damping: square(&self.damping),
            gyroscopic: square(&self.gyroscopic),
            centrifugal: square(&self.centrifugal),
            centrifugal_load: line(&self.centrifugal_load),
            euler_load: line(&self.euler_load),
            polar: self.polar,
            rows: self.rows.iter().map(pair).collect(),
            turns: self.turns.iter().map(|row| line(row)).collect(),
            slopes: self.slopes.iter().map(pair).collect(),
            turning: line(&self.turning),
        }
    }

    /// The body with the flywheel's end face turning with the frame and these bearings held in the middle.
    ///
    /// The rows leave an orthogonal space of shapes; in it the stiffness is made diagonal again.
    pub(crate) fn held(&self, bearings: &[usize]) -> (CrankBody, Held) {
        let n = self.size();
        let mut rows = vec![self.turning.clone()];
        for bearing in bearings {
            rows.extend(self.rows[*bearing].iter().cloned());
        }
        // Orthonormal rows; one that the others contain holds nothing more.
        let mut basis: Vec<Vec<f64>> = Vec::new();
        let mut kept: Vec<Vec<f64>> = Vec::new();
        for row in &rows {
            let mut rest = row.clone();
            for _ in 0..2 {
                for own in &basis {
                    let share = dot(own, &rest);
                    rest.iter_mut().zip(own).for_each(|(rest, own)| *rest -= share * own);
                }
            }
            let [size, before] = [dot(&rest, &rest).sqrt(), dot(row, row).sqrt()];
            if size > 1e-9 * before && size > 0.0 {
                basis.push(rest.iter().map(|value| value / size).collect());
                kept.push(row.clone());
            }
        }
        // Shapes that no row moves: eigenvectors of 1 - Q Q^T with value one.
        let projector: Vec<f64> = (0..n * n)
            .map(|k| {
                let (i, j) = (k / n, k % n);
                f64::from(u8::from(i == j)) - basis.iter().map(|row| row[i] * row[j]).sum::<f64>()
            })
            .collect();
        let (values, vectors) = symmetric_eigen(&projector, n);
        let free: Vec<&[f64]> = values
            .iter()
            .zip(vectors.chunks(n.max(1)))
            .filter(|(value, _)| **value > 0.5)
            .map(|(_, v)| v)
            .collect();
        let m = free.len();
        let reduced: Vec<f64> = (0..m * m)
            .map(|k| {
                let (a, b) = (free[k / m], free[k % m]);
                (0..n).map(|i| a[i] * self.stiffness[i] * b[i]).sum()
            })
            .collect();
        let (squares, shapes) = symmetric_eigen(&reduced, m);
        let columns: Vec<Vec<f64>> = shapes
            .chunks(m.max(1))
            .map(|shape| (0..n).map(|i| shape.iter().zip(&free).map(|(s, v)| s * v[i]).sum()).collect())
            .collect();
        let largest = self.stiffness.iter().fold(0.0f64, |most, k| most.max(*k));
        let squares = squares.into_iter().map(|k| if k < 1e-12 * largest { k.max(0.0) } else { k }).collect();
        let count = kept.len();
        let gram: Vec<f64> = (0..count * count).map(|k| dot(&kept[k / count], &kept[k % count])).collect();
        let held = Held { gram: Lu::new(count, gram).ok(), rows: kept, transform: columns.clone(), size: n };
        (self.transformed(&columns, squares), held)
    }
}
