//! What the closed form says of the same engine, to be drawn beside a simulated run.

use num_complex::Complex64;

/// Loads of the closed form at the mean speed of a run's last period.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ClosedFormBeside {
    /// That speed [rad/s].
    pub speed: f64,
    /// Force on every main bearing over the cycle, `x` and `y` [N], cut at every main; by crankshaft, then by main. Empty where it is not known.
    pub mains: Vec<Vec<Vec<[f64; 2]>>>,
    /// Force of every rod on its crankpin along the throw and across it [N], by cylinder; empty for a knuckle pin.
    pub crankpins: Vec<Vec<[f64; 2]>>,
    /// Forces of the block on its mounts by order, without what rests: order, and amplitudes by mount along x, y, z [N].
    pub mounts: Vec<(f64, Vec<[Complex64; 3]>)>,
}

impl ClosedFormBeside {
    /// Alternating force on a mount along axis `k` at a crank angle [N].
    pub(crate) fn mount_force(&self, mount: usize, k: usize, theta: f64) -> f64 {
        let parts = self.mounts.iter().filter(|(order, _)| *order > 0.0);
        parts.map(|(order, forces)| (forces[mount][k] * Complex64::cis(order * theta)).re).sum()
    }
}
