//! Rigid-body modes of the block: undamped and damped (book, eq. 27.5 to 27.7).
//!
//! ```text
//! undamped   K s = w^2 M s                           M = L L^T,  A = L^{-1} K L^{-T},  s = L^{-T} y
//! damped     ( p^2 M + p C + K (1 + i eta) ) s = 0    as a first-order system of 12 in (y, y'/w0)
//! ```

use crate::mounts::error::MountError;
use crate::mounts::result::{DampedMode, MountMode, MountModes};
use crate::mounts::spring::Spring;
use crate::mounts::symmetric::symmetric_eigen;
use crate::mounts::system::MountSystem;
use lanchester_numerics::illinois;
use nalgebra::{Matrix6, SMatrix, Schur, Vector6};
use num_complex::Complex64;

/// Iterations that the roots may take.
const MAX_ITERATIONS: usize = 10_000;

/// Roots whose imaginary part is above minus this share of their size turn in the positive sense, or not at all.
const NOT_MIRRORED: f64 = 1e-9;

type Complex12x12 = SMatrix<Complex64, 12, 12>;

impl MountSystem {
    /// Modes, torque-roll axis and centre of stiffness.
    ///
    /// # Errors
    /// [`MountError::Roots`] where the iteration for the damped modes does not end.
    pub fn modes(&self) -> Result<MountModes, MountError> {
        let factor =
            self.mass.cholesky().expect("invariant: the mass matrix of a body is positive definite").l();
        let inverse = factor.try_inverse().expect("invariant: a Cholesky factor has a positive diagonal");
        let modes: Vec<MountMode> = (0..6).map(|index| self.mode(&inverse, index)).collect();
        Ok(MountModes {
            damped: self.damped_modes(&inverse, &modes)?,
            modes,
            torque_roll_axis: self.torque_roll_axis(),
            stiffness_centre: self.stiffness_centre(),
        })
    }

    /// Storage stiffness in mass-normalised coordinates.
    fn normalised(&self, inverse: &Matrix6<f64>, frequency: f64) -> Matrix6<f64> {
        let stiffness = if self.has_table() {
            self.complex_stiffness(&self.mount_stiffness(frequency)).map(|k| k.re)
        } else {
            self.stiffness
        };
        let normal = inverse * stiffness * inverse.transpose();
        0.5 * (normal + normal.transpose())
    }

    /// Undamped mode `index`, counted from the lowest.
    fn mode(&self, inverse: &Matrix6<f64>, index: usize) -> MountMode {
        let squared = |frequency: f64| symmetric_eigen(&self.normalised(inverse, frequency))[index].0;
        let frequency = if self.has_table() {
            // The squared frequency of the mode lies above the square of the trial at 0, and below it at the highest.
            let points = self.mounts.iter().flat_map(|m| m.spring.table.iter().map(|p| p.angular_frequency));
            let reach = points.fold(0.0, f64::max);
            let mut high = squared(0.0).max(squared(reach)).sqrt().max(1.0);
            while squared(high) >= high * high {
                high *= 2.0;
            }
            let miss = |frequency: f64| frequency * frequency - squared(frequency);
            illinois(0.0, miss(0.0), high, miss(high), 0.0, miss)
        } else {
            squared(0.0).max(0.0).sqrt()
        };
        let (_, y) = symmetric_eigen(&self.normalised(inverse, frequency))[index];
        let mut shape: Vector6<f64> = inverse.transpose() * y;
        let momentum = self.mass * shape;
        let energy: [f64; 6] = std::array::from_fn(|k| shape[k] * momentum[k]);
        let main = (0..6).max_by(|&a, &b| energy[a].total_cmp(&energy[b])).unwrap_or(0);
        if shape[main] < 0.0 {
            shape = -shape;
        }
        let stiffness = |m: &Spring| {
            if self.has_table() { m.stiffness(frequency).map(|k| k.re) } else { m.spring.stiffness }
        };
        let energy_of = |m: &Spring| {
            let each = m.along.iter().zip(stiffness(m)).map(|(along, k)| k * along.dot(&shape).powi(2));
            each.sum::<f64>()
        };
        let elastic: Vec<f64> = self.mounts.iter().map(energy_of).collect();
        let total: f64 = elastic.iter().sum();
        MountMode {
            angular_frequency: frequency,
            shape: shape.into(),
            energy,
            mount_energy: elastic.into_iter().map(|e| e / total).collect(),
            main,
            coupling: 1.0 - energy[main],
        }
    }

    /// All damped modes; with a table one for each undamped mode, with the stiffness and loss at its frequency.
    fn damped_modes(
        &self,
        inverse: &Matrix6<f64>,
        modes: &[MountMode],
    ) -> Result<Vec<DampedMode>, MountError> {
        if !self.has_table() {
            return self.roots(inverse, 0.0);
        }
        let one = |(index, mode): (usize, &MountMode)| {
            let mut roots = self.roots(inverse, mode.angular_frequency)?;
            // Both lists rise; where a motion does not oscillate it has two roots, and the nearest is taken.
            let miss = |m: &DampedMode| (m.root - Complex64::new(0.0, mode.angular_frequency)).norm();
            let nearest = (0..roots.len()).min_by(|&a, &b| miss(&roots[a]).total_cmp(&miss(&roots[b])));
            let place = if roots.len() == modes.len() { index } else { nearest.unwrap_or(0) };
            Ok(roots.swap_remove(place))
        };
        modes.iter().enumerate().map(one).collect()
    }

    /// Roots of the block with the stiffness and loss at one frequency, without the mirrored ones.
    fn roots(&self, inverse: &Matrix6<f64>, frequency: f64) -> Result<Vec<DampedMode>, MountError> {
        let normal = inverse.map(Complex64::from);
        let stiffness =
            normal * self.complex_stiffness(&self.mount_stiffness(frequency)) * normal.transpose();
        let damping = inverse * self.damping * inverse.transpose();
        let unit = (stiffness.trace().re / 6.0).sqrt();
        let mut matrix = Complex12x12::zeros();
        for i in 0..6 {
            matrix[(i, 6 + i)] = Complex64::from(unit);
            for j in 0..6 {
                matrix[(6 + i, j)] = -stiffness[(i, j)] / unit;
                matrix[(6 + i, 6 + j)] = Complex64::from(-damping[(i, j)]);
            }
        }
        let schur = Schur::try_new(matrix, f64::EPSILON, MAX_ITERATIONS).ok_or(MountError::Roots)?;
        let (turn, upper) = schur.unpack();
        let mut found: Vec<DampedMode> = (0..12)
            .filter(|&k| upper[(k, k)].im >= -NOT_MIRRORED * upper[(k, k)].norm())
            .map(|k| {
                let root = upper[(k, k)];
                let full = turn * eigenvector(&upper, k);
                let y = full.fixed_rows::<6>(0).into_owned();
                let turned = y[y.icamax()].conj();
                let y = y * (turned / turned.norm()) / Complex64::from(y.norm());
                let shape = normal.transpose() * y;
                DampedMode { root, damping_ratio: -root.re / root.norm(), shape: shape.into() }
            })
            .collect();
        found.sort_by(|a, b| a.root.norm().total_cmp(&b.root.norm()));
        Ok(found)
    }
}

/// Eigenvector of an upper triangular matrix for the root on its diagonal, by back substitution. Roots that fall together
/// are held apart by rounding, so that each has a vector of its own where there is one.
fn eigenvector(upper: &Complex12x12, index: usize) -> SMatrix<Complex64, 12, 1> {
    let floor = f64::EPSILON * upper.iter().map(|c| c.norm()).fold(0.0, f64::max);
    let root = upper[(index, index)];
    let mut vector = SMatrix::<Complex64, 12, 1>::zeros();
    vector[index] = Complex64::ONE;
    for row in (0..index).rev() {
        let sum: Complex64 = (row + 1..=index).map(|k| upper[(row, k)] * vector[k]).sum();
        let gap = upper[(row, row)] - root;
        vector[row] = -sum / if gap.norm() < floor { Complex64::from(floor) } else { gap };
    }
    vector
}
