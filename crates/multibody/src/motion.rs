//! The state of the block and the crank, and what follows from it: pose, speeds, kinetic energy, momenta.

use nalgebra::{Matrix3, Quaternion, Vector3};

/// Pose and speeds of block and crank at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    /// Crank angle of crankshaft 1 relative to the block [rad].
    pub theta: f64,
    /// Its rate [rad/s].
    pub speed: f64,
    /// Where the block's origin is [m], axes of the frame; 0 in the position that the file describes.
    pub position: Vector3<f64>,
    /// Turn of the block: unit quaternion `(w, x, y, z)`.
    pub orientation: [f64; 4],
    /// Velocity of the block's origin in block axes [m/s].
    pub velocity: Vector3<f64>,
    /// Angular velocity of the block in block axes [rad/s].
    pub spin: Vector3<f64>,
}

impl Motion {
    /// The crank at `theta` turning at `speed` in a block at rest in its place.
    pub fn fixed(theta: f64, speed: f64) -> Motion {
        Motion {
            theta,
            speed,
            position: Vector3::zeros(),
            orientation: [1.0, 0.0, 0.0, 0.0],
            velocity: Vector3::zeros(),
            spin: Vector3::zeros(),
        }
    }

    /// From block axes to the axes of the frame.
    pub fn rotation(&self) -> Matrix3<f64> {
        let [w, x, y, z] = self.orientation;
        // Of the quaternion over its size.
        let twice = 2.0 / (w * w + x * x + y * y + z * z);
        let [xw, yw, zw] = [x, y, z].map(|part| twice * part * w);
        let (xx, xy, xz) = (twice * x * x, twice * x * y, twice * x * z);
        let (yy, yz, zz) = (twice * y * y, twice * y * z, twice * z * z);
        Matrix3::new(
            1.0 - yy - zz,
            xy - zw,
            xz + yw,
            xy + zw,
            1.0 - xx - zz,
            yz - xw,
            xz - yw,
            yz + xw,
            1.0 - xx - yy,
        )
    }

    /// Rate of the quaternion for its spin: `q' = q (0, Omega) / 2`.
    pub fn orientation_rate(&self) -> [f64; 4] {
        let [w, x, y, z] = self.orientation;
        let rate = Quaternion::new(w, x, y, z) * Quaternion::from_imag(self.spin) * 0.5;
        [rate.w, rate.i, rate.j, rate.k]
    }

    /// The seven speeds: velocity of the origin, spin, crank.
    pub fn speeds(&self) -> [f64; 7] {
        let (v, o) = (self.velocity, self.spin);
        [v.x, v.y, v.z, o.x, o.y, o.z, self.speed]
    }
}
