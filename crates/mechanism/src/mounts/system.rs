//! Mass, stiffness and damping of the block on its mounts, prepared once.

use crate::mounts::body::mounted_body;
use crate::mounts::error::MountError;
use crate::mounts::free_motion::free_motion;
use crate::mounts::result::MountedBody;
use crate::mounts::rotors::rotor_inertia_about_z;
use lanchester_model::{Block, Engine, MAX_LOSS_FACTOR, Mount, MountPoint, MountSpring};
use nalgebra::{Cholesky, Matrix3, Matrix3x6, Matrix6, U6, Vector3, Vector6};
use num_complex::Complex64;

pub(crate) type Complex6x6 = Matrix6<Complex64>;

/// The block of an engine on its mounts.
#[derive(Debug, Clone)]
pub struct MountSystem {
    body: MountedBody,
    block: Block,
    pub(crate) mounts: Vec<Spring>,
    /// Mass matrix about the centre.
    pub(crate) mass: Matrix6<f64>,
    /// Static stiffness about the centre.
    pub(crate) stiffness: Matrix6<f64>,
    /// Its factors.
    pub(crate) held: Cholesky<f64, U6>,
    /// Force on each mount at rest for a unit of each load at the centre.
    pub(crate) shares: Vec<Matrix3x6<f64>>,
    /// Viscous damping about the centre.
    pub(crate) damping: Matrix6<f64>,
    /// Complex stiffness of the mounts without a table.
    fixed: Complex6x6,
    /// Angular momentum of the rotors over the speed of crankshaft 1 [kg m^2].
    pub(crate) rotors: f64,
}

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

impl MountSystem {
    /// The block of `engine` on its mounts.
    ///
    /// # Errors
    /// [`MountError`] where the engine has no block or no mounts with stiffness, where a number lies outside what is
    /// possible, and where the mounts leave the block free.
    pub fn new(engine: &Engine) -> Result<MountSystem, MountError> {
        let block = engine.block.as_ref().ok_or(MountError::NoBlock)?;
        if engine.mounts.is_empty() {
            return Err(MountError::NoMounts);
        }
        let body = mounted_body(engine, block)?;
        let mounts =
            engine.mounts.iter().map(|m| Spring::new(m, body.centre)).collect::<Result<Vec<_>, _>>()?;
        if let Some(motion) = free_motion(&engine.mounts, &mounts, body.centre) {
            return Err(MountError::Free { motion });
        }
        let mut mass = Matrix6::zeros();
        for i in 0..3 {
            mass[(i, i)] = body.mass;
            for j in 0..3 {
                mass[(3 + i, 3 + j)] = body.inertia[i][j];
            }
        }
        let sum = |part: fn(&Spring) -> [f64; 3]| -> Matrix6<f64> {
            mounts.iter().map(|m| m.on_block(part(m))).sum()
        };
        let mut fixed = Complex6x6::zeros();
        mounts
            .iter()
            .filter(|m| m.spring.table.is_empty())
            .for_each(|m| m.add_to(&mut fixed, m.stiffness(0.0)));
        let stiffness = sum(|m| m.spring.stiffness);
        let held = stiffness.cholesky().ok_or_else(|| MountError::Free {
            motion: "one of its motions is held too weakly beside the others to tell it from free".to_owned(),
        })?;
        let shares = mounts.iter().map(|m| m.share(&held)).collect();
        Ok(MountSystem {
            shares,
            block: block.clone(),
            mass,
            stiffness,
            held,
            damping: sum(|m| m.spring.damping),
            fixed,
            mounts,
            body,
            rotors: rotor_inertia_about_z(engine, None),
        })
    }

    /// The body that moves.
    pub fn body(&self) -> &MountedBody {
        &self.body
    }

    /// Number of mounts.
    pub fn mount_count(&self) -> usize {
        self.mounts.len()
    }

    /// What the file says of it.
    pub(crate) fn block(&self) -> &Block {
        &self.block
    }

    /// Names of the mounts.
    pub(crate) fn names(&self) -> Vec<String> {
        self.mounts.iter().map(|m| m.name.clone()).collect()
    }

    /// Whether the stiffness depends on frequency.
    pub(crate) fn has_table(&self) -> bool {
        self.mounts.iter().any(|m| !m.spring.table.is_empty())
    }

    /// Complex stiffness of each mount along its directions at an angular frequency [rad/s].
    pub(crate) fn mount_stiffness(&self, frequency: f64) -> Vec<[Complex64; 3]> {
        self.mounts.iter().map(|m| m.stiffness(frequency)).collect()
    }

    /// Complex stiffness about the centre, without viscous damping, with these of the mounts.
    pub(crate) fn complex_stiffness(&self, mounts: &[[Complex64; 3]]) -> Complex6x6 {
        let mut sum = self.fixed;
        for (mount, stiffness) in self.mounts.iter().zip(mounts).filter(|(m, _)| !m.spring.table.is_empty()) {
            mount.add_to(&mut sum, *stiffness);
        }
        sum
    }
}

impl Spring {
    fn new(mount: &Mount, centre: [f64; 3]) -> Result<Spring, MountError> {
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
    fn share(&self, held: &Cholesky<f64, U6>) -> Matrix3x6<f64> {
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
    fn add_to(&self, matrix: &mut Complex6x6, values: [Complex64; 3]) {
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
