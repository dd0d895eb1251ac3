//! Mass, stiffness and damping of the block on its mounts, prepared once.

use crate::mounts::body::mounted_body;
use crate::mounts::error::MountError;
use crate::mounts::free_motion::free_motion;
use crate::mounts::result::MountedBody;
use crate::mounts::rotor_effects::RotorEffects;
use crate::mounts::rotor_inertia::rotor_inertia_about_z;
use crate::mounts::spring::{Complex6x6, Spring};
use lanchester_model::{Block, Engine};
use nalgebra::{Cholesky, Matrix3x6, Matrix6, U6};
use num_complex::Complex64;

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
    pub(crate) effects: RotorEffects,
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
            rotors: rotor_inertia_about_z(&engine.rotating_bodies(&[])),
            effects: RotorEffects::default(),
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
