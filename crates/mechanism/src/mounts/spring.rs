//! One mount, ready for use: its directions, its stiffness over frequency, what it does to the block.

use crate::mounts::error::MountError;
use lanchester_model::{MAX_LOSS_FACTOR, Mount, MountPoint, MountSpring};
use nalgebra::{Cholesky, Matrix3, Matrix3x6, Matrix6, U6, Vector3, Vector6};
use num_complex::Complex64;

/// A matrix of the block that is complex.
pub(crate) type Complex6x6 = Matrix6<Complex64>;

/// One mount, ready for use.
#[derive(Debug, Clone)]
pub(crate) struct Spring {
    pub name: String,
    pub spring: MountSpring,
    /// Its directions as rows.
    pub axes: Matrix3<f64>,
    /// Motion of the centre to displacement along each direction: `B_j^T a`.
    pub along: [Vector6<f64>; 3],
}

impl Spring {
    pub fn new(mount: &Mount, centre: [f64; 3]) -> Result<Spring, MountError> {
        let spring = mount.spring.as_ref().ok_or(MountError::NoStiffness { mount: mount.name.clone() })?;
        check(mount, spring)?;
        let axes = Matrix3::from_fn(|i, j| spring.axes[i][j]);
        let rho = Vector3::new(mount.x, mount.y, mount.z) - Vector3::from(centre);
        // a . (u + phi x rho) = a . u + (rho x a) . phi
        let along = spring.axes.map(|a| {
            let turn = rho.cross(&Vector3::from(a));
            Vector6::new(a[0], a[1], a[2], turn.x, turn.y, turn.z)
        });
        Ok(Spring { name: mount.name.clone(), spring: spring.clone(), axes, along })
    }

    /// Complex stiffness along its directions at an angular frequency [rad/s].
    pub fn stiffness(&self, frequency: f64) -> [Complex64; 3] {
        let (stiffness, loss_factor) = if self.spring.table.is_empty() {
            (self.spring.stiffness, self.spring.loss_factor)
        } else {
            let point = between(&self.spring.table, frequency);
            (point.stiffness, point.loss_factor)
        };
        [0, 1, 2].map(|k| stiffness[k] * Complex64::new(1.0, loss_factor[k]))
    }

    /// Displacement of the mount for a motion of the centre.
    pub fn displacement(&self, motion: &Vector6<f64>) -> Vector3<f64> {
        self.along_frame([0, 1, 2].map(|k| self.along[k].dot(motion)))
    }

    /// Force on the mount at rest for a motion of the centre.
    pub fn force_at_rest(&self, motion: &Vector6<f64>) -> Vector3<f64> {
        self.along_frame([0, 1, 2].map(|k| self.spring.stiffness[k] * self.along[k].dot(motion)))
    }

    /// Force on the mount at rest for a unit of each load at the centre: `K_j B_j K^{-1}`, with the factors of K.
    pub fn share(&self, held: &Cholesky<f64, U6>) -> Matrix3x6<f64> {
        let mut share = Matrix3x6::zeros();
        for k in 0..3 {
            let force = self.axes.row(k).transpose() * self.spring.stiffness[k];
            share += force * held.solve(&self.along[k]).transpose();
        }
        share
    }

    /// A vector from its components along the mount's directions.
    fn along_frame(&self, own: [f64; 3]) -> Vector3<f64> {
        self.axes.transpose() * Vector3::from(own)
    }

    /// These values along its directions as a matrix of the block.
    pub fn on_block(&self, values: [f64; 3]) -> Matrix6<f64> {
        (0..3).map(|k| values[k] * self.along[k] * self.along[k].transpose()).sum()
    }

    /// The same for complex values, added to `matrix`.
    pub fn add_to(&self, matrix: &mut Complex6x6, values: [Complex64; 3]) {
        for (value, along) in values.into_iter().zip(&self.along) {
            for j in 0..6 {
                let column = value * along[j];
                for i in 0..j {
                    let element = column * along[i];
                    matrix[(i, j)] += element;
                    matrix[(j, i)] += element;
                }
                matrix[(j, j)] += column * along[j];
            }
        }
    }
}

/// Stiffness and loss between the points of a table, on straight lines; beyond its ends those of the end.
fn between(table: &[MountPoint], frequency: f64) -> MountPoint {
    let after = table.partition_point(|p| p.angular_frequency <= frequency);
    if after == 0 || after == table.len() {
        return table[after.min(table.len() - 1)];
    }
    let (low, high) = (&table[after - 1], &table[after]);
    let share = (frequency - low.angular_frequency) / (high.angular_frequency - low.angular_frequency);
    let mix = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|k| a[k] + share * (b[k] - a[k]));
    // Storage and loss stiffness are interpolated, so that the force is on a straight line too.
    let loss = |p: &MountPoint| [0, 1, 2].map(|k| p.stiffness[k] * p.loss_factor[k]);
    let (stiffness, lost) = (mix(low.stiffness, high.stiffness), mix(loss(low), loss(high)));
    let loss_factor = [0, 1, 2].map(|k| if stiffness[k] > 0.0 { lost[k] / stiffness[k] } else { 0.0 });
    MountPoint { angular_frequency: frequency, stiffness, loss_factor }
}

/// Refuses a mount whose numbers are impossible.
fn check(mount: &Mount, spring: &MountSpring) -> Result<(), MountError> {
    let name = &mount.name;
    let number = |quantity: &str, needed, got| {
        Err(MountError::Number { quantity: format!("{quantity} of mount `{name}`"), needed, got })
    };
    if let Some(bad) = [mount.x, mount.y, mount.z].into_iter().find(|p| !p.is_finite()) {
        return number("place [m]", "finite", bad);
    }
    let axes = Matrix3::from_fn(|i, j| spring.axes[i][j]);
    let off = (axes * axes.transpose() - Matrix3::identity()).amax();
    if off > 1e-9 || off.is_nan() {
        return number("departure of the directions from a right angle", "0", off);
    }
    if !spring.preload.is_finite() {
        return number("preload [N]", "finite", spring.preload);
    }
    let points = spring.table.iter().map(|p| (p.stiffness, p.loss_factor));
    for (stiffness, loss_factor) in [(spring.stiffness, spring.loss_factor)].into_iter().chain(points) {
        if let Some(bad) = stiffness.into_iter().find(|k| !(*k >= 0.0 && k.is_finite())) {
            return number("stiffness [N/m]", "0 or more", bad);
        }
        if stiffness.iter().all(|&k| k == 0.0) {
            return number("stiffness [N/m]", "positive in at least one direction", 0.0);
        }
        if let Some(bad) = loss_factor.into_iter().find(|l| !(0.0..=MAX_LOSS_FACTOR).contains(l)) {
            return number("loss factor", "from 0 to 3", bad);
        }
    }
    if let Some(bad) = spring.damping.into_iter().find(|c| !(*c >= 0.0 && c.is_finite())) {
        return number("damping [N s/m]", "0 or more", bad);
    }
    if let Some(bad) =
        spring.table.iter().map(|p| p.angular_frequency).find(|f| !(*f >= 0.0 && f.is_finite()))
    {
        return number("frequency in the table [rad/s]", "0 or more", bad);
    }
    match spring.table.windows(2).find(|w| w[1].angular_frequency <= w[0].angular_frequency) {
        None => Ok(()),
        Some(pair) => Err(MountError::Table {
            mount: name.clone(),
            before: pair[0].angular_frequency,
            got: pair[1].angular_frequency,
        }),
    }
}
