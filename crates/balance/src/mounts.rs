//! Forces at the mounts of a rigid block on equal isotropic springs.
//!
//! Of all forces at the mounts that carry the load the springs take those with the least sum of squares. What the
//! mounts cannot carry is the moment about a line through all of them (about any line for a single mount): the block
//! would turn there. That moment is left out, the force is kept whole.
//!
//! ```text
//! SUM f_k = F        SUM r_k x f_k = M - mu        mu: the shortest moment that makes both possible
//! ```

use crate::convex::dense::{Matrix, RowFactors, dot};
use lanchester_model::Mount;

/// Directions that carry less than this share count as not carried.
const NOT_CARRIED: f64 = 1e-9;

/// Forces at each mount for a unit of F_x, F_y, M_x, M_y, M_z about the origin: `[mount][component][channel]`.
pub(crate) fn shares(mounts: &[Mount]) -> Vec<[[f64; 5]; 3]> {
    let mut result = vec![[[0.0; 5]; 3]; mounts.len()];
    let reach = mounts.iter().flat_map(|m| [m.x.abs(), m.y.abs(), m.z.abs()]).fold(0.0, f64::max);
    let unit = if reach > 0.0 { reach } else { 1.0 };
    // Rows: F_x, F_y, F_z, M_x, M_y, M_z over the unit of length.
    let mut equilibrium = Matrix::zeros(6, 3 * mounts.len());
    for (k, mount) in mounts.iter().enumerate() {
        let [x, y, z] = [mount.x / unit, mount.y / unit, mount.z / unit];
        for j in 0..3 {
            equilibrium[(j, 3 * k + j)] = 1.0;
        }
        for (row, column, value) in [(3, 2, y), (3, 1, -z), (4, 0, z), (4, 2, -x), (5, 1, x), (5, 0, -y)] {
            equilibrium[(row, 3 * k + column)] = value;
        }
    }
    // Small motions of the block that move no mount: (translation, rotation).
    let (_, free) = RowFactors::of(&equilibrium.transposed(), NOT_CARRIED).bases();
    let factors = RowFactors::of(&equilibrium, NOT_CARRIED);
    for channel in 0..5 {
        let mut load = [0.0; 6];
        load[if channel < 2 { channel } else { channel + 1 }] = if channel < 2 { 1.0 } else { 1.0 / unit };
        let load = carried(load, &free);
        let forces = factors.shortest(&load);
        for (k, result) in result.iter_mut().enumerate() {
            for j in 0..3 {
                result[j][channel] = forces[3 * k + j];
            }
        }
    }
    result
}

/// The load without the shortest moment that would set the block free.
fn carried(mut load: [f64; 6], free: &Matrix) -> Vec<f64> {
    let twists = free.transposed();
    if twists.rows == 0 {
        return load.to_vec();
    }
    let rotations = Matrix::from_rows(3, (0..twists.rows).map(|i| &twists.row(i)[3..]));
    let work: Vec<f64> = (0..twists.rows).map(|i| dot(twists.row(i), &load)).collect();
    let moment = RowFactors::of(&rotations, NOT_CARRIED).shortest(&work);
    for j in 0..3 {
        load[3 + j] -= moment[j];
    }
    load.to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mount(x: f64, y: f64, z: f64) -> Mount {
        Mount { name: String::new(), x, y, z, spring: None }
    }

    /// What the mounts' forces add up to: force and moment about the origin.
    fn resultant(mounts: &[Mount], shares: &[[[f64; 5]; 3]], channel: usize) -> [f64; 6] {
        let mut sum = [0.0; 6];
        for (mount, share) in mounts.iter().zip(shares) {
            let f = [share[0][channel], share[1][channel], share[2][channel]];
            for j in 0..3 {
                sum[j] += f[j];
            }
            sum[3] += mount.y * f[2] - mount.z * f[1];
            sum[4] += mount.z * f[0] - mount.x * f[2];
            sum[5] += mount.x * f[1] - mount.y * f[0];
        }
        sum
    }

    #[test]
    fn three_mounts_carry_every_load() {
        let mounts = [mount(0.1, -0.2, -0.15), mount(0.1, 0.25, -0.1), mount(-0.05, 0.0, 0.6)];
        let shares = shares(&mounts);
        for channel in 0..5 {
            let mut want = [0.0; 6];
            want[if channel < 2 { channel } else { channel + 1 }] = 1.0;
            let got = resultant(&mounts, &shares, channel);
            assert!((0..6).all(|j| (got[j] - want[j]).abs() < 1e-12), "{channel}: {got:?}");
        }
    }

    #[test]
    fn two_mounts_on_the_axis_leave_the_roll_moment_out() {
        let mounts = [mount(0.0, 0.0, -0.088), mount(0.0, 0.0, 0.088)];
        let shares = shares(&mounts);
        for k in 0..2 {
            assert!((shares[k][0][0] - 0.5).abs() < 1e-14);
            assert!((0..3).all(|j| shares[k][j][4].abs() < 1e-14));
            // M_y = SUM z f_x.
            let sign = if k == 0 { -1.0 } else { 1.0 };
            assert!((shares[k][0][3] - sign * 0.5 / 0.088).abs() < 1e-11);
        }
    }

    #[test]
    fn one_mount_takes_the_force_alone() {
        let shares = shares(&[mount(0.3, 0.1, 0.2)]);
        assert!((shares[0][0][0] - 1.0).abs() < 1e-13 && shares[0][1][0].abs() < 1e-13);
        assert!((2..5).all(|channel| (0..3).all(|j| shares[0][j][channel].abs() < 1e-12)));
    }
}
