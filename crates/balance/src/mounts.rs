//! Forces at the mounts: of the block on its real springs and dampers where the file gives them, else of a block held by
//! equal isotropic springs that are stiff.
//!
//! On real mounts each order of a load reaches a mount through the complex transfer of its frequency
//! ([`MountSystem::transfer`]); forces stay linear in the devices, so the optimum stays convex.
//!
//! On stiff ones, of all forces at the mounts that carry the load the springs take those with the least sum of squares. What the
//! mounts cannot carry is the moment about a line through all of them (about any line for a single mount): the block
//! would turn there. That moment is left out, the force is kept whole.
//!
//! ```text
//! SUM f_k = F        SUM r_k x f_k = M - mu        mu: the shortest moment that makes both possible
//! ```

use crate::convex::dense::{Matrix, RowFactors, dot};
use crate::error::BalanceError;
use crate::operator::Operator;
use crate::over_speed::places::MountPlace;
use crate::wave::Wave;
use lanchester_mechanism::MountSystem;
use lanchester_model::{Engine, Mount};
use num_complex::Complex64;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::rc::Rc;

/// Directions that carry less than this share count as not carried.
const NOT_CARRIED: f64 = 1e-9;

/// Places of the channels among force and moment about x, y and z.
const PLACES: [usize; 5] = [0, 1, 3, 4, 5];

/// Forces at each mount of `engine` under the loads of `operator`, with those of the gas or without, three components each: on springs
/// at every speed that is judged, all of whose forces count.
pub(crate) fn forces(
    engine: &Engine,
    operator: &Operator,
    with_gas: bool,
) -> Result<Vec<Vec<Vec<Wave>>>, BalanceError> {
    if engine.is_on_springs() {
        let system = MountSystem::new(engine)?;
        let at = |place: &MountPlace| on_springs(&system, operator, place, with_gas);
        if operator.places.mounts.is_empty() {
            let highest = MountPlace { speed: operator.speed, weight: 1.0, gas: Rc::default() };
            return Ok(vec![at(&highest)?]);
        }
        return operator.places.mounts.iter().map(at).collect();
    }
    if with_gas {
        return Err(no_springs());
    }
    let one = |share: &[[f64; 5]; 3]| {
        let rows = share.iter().map(|row| Wave::sum(row.iter().copied().zip(&operator.channels)));
        rows.collect::<Vec<_>>()
    };
    Ok(vec![shares(&engine.mounts).iter().map(one).collect()])
}

/// Why there are no forces of the gas at mounts that are stiff.
fn no_springs() -> BalanceError {
    BalanceError::Missing {
        criterion: "mount force with gas".into(),
        needed: "mounts on springs: stiff ones pass every jump of the gas",
        hint: "give [block] and stiffness to every [[mount]], or leave \"with gas\" out",
    }
}

/// The transfer of a frequency: by mount, component and force or moment.
type Transfer = Vec<[[Complex64; 6]; 3]>;

/// The roll moment among the forces and moments of a transfer.
const ROLL: usize = PLACES[4];

/// Forces at each mount at a speed, times its weight: inertia loads grow with the square of the speed, and each order passes with the
/// transfer of its frequency. The gas is known at the speed itself:
///
/// ```text
/// F_k = SUM over orders of  T_k(n W) ( W^2 / W_0^2 L_n + (1 - s) G_n e_z ) e^{i n theta}       G_n: roll moment of the gas
/// ```
/// `s` is the share of a counter-rotating inertia in the torque, whatever drives it.
pub(crate) fn on_springs(
    system: &MountSystem,
    operator: &Operator,
    place: &MountPlace,
    with_gas: bool,
) -> Result<Vec<Vec<Wave>>, BalanceError> {
    let speed = place.speed;
    let revolutions = f64::from(operator.grid.revolutions);
    let gas: &[(f64, Complex64)] = if with_gas { &place.gas.orders } else { &[] };
    let gas: Vec<(u32, Complex64)> =
        gas.iter().map(|(order, roll)| ((order * revolutions).round() as u32, *roll)).collect();
    let mut transfers: BTreeMap<u32, Transfer> = BTreeMap::new();
    let of_channels = operator
        .channels
        .iter()
        .flat_map(|channel| channel.base.keys().copied().chain(channel.parts.iter().map(|part| part.1)));
    for key in of_channels.chain(gas.iter().map(|one| one.0)) {
        if let Entry::Vacant(free) = transfers.entry(key) {
            free.insert(system.transfer(f64::from(key) / revolutions * speed, speed)?);
        }
    }
    let growth = place.weight * (speed / operator.speed).powi(2);
    let component = |mount: usize, j: usize| {
        let mut wave = Wave::default();
        // a cos + b sin = Re( (a - i b) e^{i key phi} )
        let passed = |key: u32, load: usize, [cos, sin]: [f64; 2]| {
            let force = growth * transfers[&key][mount][j][load] * Complex64::new(cos, -sin);
            (force.re, -force.im)
        };
        for (channel, load) in operator.channels.iter().zip(PLACES) {
            for (&key, &values) in &channel.base {
                let (cos, sin) = passed(key, load, values);
                wave.add_base(key, cos, sin);
            }
            for &(variable, key, values) in &channel.parts {
                let (cos, sin) = passed(key, load, values);
                wave.add_part(variable, key, cos, sin);
            }
        }
        for &(key, roll) in &gas {
            let force = place.weight * transfers[&key][mount][j][ROLL] * roll;
            wave.add_base(key, force.re, -force.im);
            if let Some((variable, _)) = operator.inertia {
                wave.add_part(variable, key, -force.re, force.im);
            }
        }
        wave
    };
    Ok((0..system.mount_count()).map(|mount| (0..3).map(|j| component(mount, j)).collect()).collect())
}

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
