//! The block at rest: shares of gravity, of the driveline's torque and of preloads (book, eq. 27.4).
//!
//! ```text
//! K q = ( m g , -T ) + SUM B_j^T p_j        force on mount j:  K_j B_j q - p_j
//! ```
//! `p_j` is the preload, with which the mount pushes the block in the position of the file.

use crate::mounts::result::{MountAtRest, MountStatics};
use crate::mounts::spring::Spring;
use crate::mounts::system::MountSystem;
use nalgebra::{Vector3, Vector6};

/// Standard acceleration of gravity [m/s^2].
const GRAVITY: f64 = 9.80665;

impl MountSystem {
    /// Deflections and forces at rest.
    pub fn at_rest(&self) -> MountStatics {
        let (block, body) = (self.block(), self.body());
        let mut gravity = Vector6::zeros();
        let mut torque = Vector6::zeros();
        for k in 0..3 {
            gravity[k] = body.mass * GRAVITY * block.gravity[k];
            torque[3 + k] = -block.driveline_torque[k];
        }
        let preload: Vector6<f64> = self.mounts.iter().map(|m| m.along[0] * m.spring.preload).sum();
        let [by_gravity, by_torque, by_preload] = [gravity, torque, preload].map(|load| self.rest(&load));
        let motion = by_gravity + by_torque + by_preload;
        let one = |mount: &Spring| {
            let share = |motion: &Vector6<f64>| mount.force_at_rest(motion);
            let [gravity, torque] = [share(&by_gravity), share(&by_torque)];
            let preload = share(&by_preload) - push(mount);
            let force = gravity + torque + preload;
            let deflection = mount.displacement(&motion);
            MountAtRest {
                name: mount.name.clone(),
                deflection: deflection.into(),
                own_deflection: (mount.axes * deflection).into(),
                force: force.into(),
                own_force: (mount.axes * force).into(),
                gravity: gravity.into(),
                torque: torque.into(),
                preload: preload.into(),
            }
        };
        MountStatics { motion: motion.into(), mounts: self.mounts.iter().map(one).collect() }
    }

    /// Forces on the mounts under a constant load at the centre: what stiff mounts would carry at any frequency.
    ///
    /// `load`: force [N] and moment about the block's centre [N m].
    pub fn rigid_share(&self, load: [f64; 6]) -> Vec<[f64; 3]> {
        let load = Vector6::from(load);
        self.shares.iter().map(|share| (share * load).into()).collect()
    }

    /// Motion of the centre under a constant load.
    fn rest(&self, load: &Vector6<f64>) -> Vector6<f64> {
        self.held.solve(load)
    }
}

/// Force of the mount on the block in the position of the file.
fn push(mount: &Spring) -> Vector3<f64> {
    mount.axes.row(0).transpose() * mount.spring.preload
}
