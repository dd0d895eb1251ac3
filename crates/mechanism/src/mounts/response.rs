//! Steady motion of the block and forces at the mounts, by order and speed (book, eq. 27.10).
//!
//! ```text
//! ( K(w) + i w C - w^2 M ) Q = F        w = n times the speed        force on mount j = ( K_j(w) + i w C_j ) B_j Q
//! ```
//! C and M with what the rotors do at the speed (27.12, 27.13).

use crate::mounts::error::MountError;
use crate::mounts::excitation::{Excitation, amplitudes};
use crate::mounts::peaks::Cycle;
use crate::mounts::result::{BeyondTable, MOUNT_RESULT_VERSION, MountResponse, OrderResponse, SpeedResponse};
use crate::mounts::spring::{Complex6x6, Spring};
use crate::mounts::system::MountSystem;
use lanchester_results::OrderLoads;
use nalgebra::{Matrix3x6, Vector3, Vector6};
use num_complex::Complex64;

impl MountSystem {
    /// Forces at the mounts and motion of the block at each speed, order by order, with the largest resultant over the cycle.
    ///
    /// # Errors
    /// [`MountError`] where orders have no common period, a number is not finite, or an undamped block is excited at
    /// a natural frequency.
    pub fn response(&self, excitations: &[Excitation]) -> Result<MountResponse, MountError> {
        let mut cycle = Cycle::default();
        let speeds = excitations
            .iter()
            .map(|e| self.at_speed(e, &mut cycle))
            .collect::<Result<Vec<_>, MountError>>()?;
        Ok(MountResponse {
            version: MOUNT_RESULT_VERSION,
            mounts: self.names(),
            centre: self.body().centre,
            beyond_table: self.beyond_table(&speeds),
            speeds,
        })
    }

    fn at_speed(&self, excitation: &Excitation, cycle: &mut Cycle) -> Result<SpeedResponse, MountError> {
        let speed = excitation.speed;
        if !(speed > 0.0 && speed.is_finite()) {
            return Err(MountError::Number {
                quantity: "speed [rad/s]".to_owned(),
                needed: "positive and finite",
                got: speed,
            });
        }
        let turning = excitation.orders.iter().filter(|o| o.order > 0.0);
        let orders = turning.map(|o| self.at_order(speed, o)).collect::<Result<Vec<_>, MountError>>()?;
        let peaks = cycle.peaks(&orders, self.mounts.len())?;
        Ok(SpeedResponse { speed, orders, peaks })
    }

    fn at_order(&self, speed: f64, load: &OrderLoads) -> Result<OrderResponse, MountError> {
        let frequency = load.order * speed;
        let exciting = amplitudes(load, self.body().centre);
        let resonance = || MountError::Resonance { order: load.order, speed };
        let stiffness = self.mount_stiffness(frequency);
        let motion = self.solve(frequency, speed, &stiffness, &exciting).ok_or_else(resonance)?;
        let mut transmitted = Vector6::zeros();
        let forces = self.mounts.iter().zip(&stiffness).map(|(mount, stiffness)| {
            let force = mount.force(frequency, stiffness, &motion);
            transmitted += mount.on_centre(&force);
            force.into()
        });
        Ok(OrderResponse {
            order: load.order,
            load: exciting.into(),
            motion: motion.into(),
            forces: forces.collect(),
            stiff_forces: self.shares.iter().map(|share| shared(share, &exciting)).collect(),
            transmitted: transmitted.into(),
        })
    }

    /// Motion of the centre under a harmonic load; `None` where there is none.
    fn solve(
        &self,
        frequency: f64,
        speed: f64,
        stiffness: &[[Complex64; 3]],
        load: &Vector6<Complex64>,
    ) -> Option<Vector6<Complex64>> {
        let mut matrix = self.complex_stiffness(stiffness);
        for j in 0..6 {
            for i in 0..6 {
                matrix[(i, j)] += Complex64::new(
                    -frequency * frequency * self.mass[(i, j)],
                    frequency * self.damping[(i, j)],
                );
            }
        }
        if speed > 0.0 {
            self.add_rotors(&mut matrix, frequency, speed);
        }
        solved(&matrix, load)
    }

    /// Forces on the mounts for a unit of each of F_x, F_y, F_z, M_x, M_y, M_z about the origin that turns with `e^{i w t}`, while
    /// crankshaft 1 turns at `speed` [rad/s] (0: the engine stands, its rotors with it): `[mount][component][load]`. At frequency 0 they are those at rest.
    ///
    /// # Errors
    /// [`MountError::Resonance`] where the block is undamped and this is a natural frequency.
    pub fn transfer(&self, frequency: f64, speed: f64) -> Result<Vec<[[Complex64; 6]; 3]>, MountError> {
        let mut result = vec![[[Complex64::ZERO; 6]; 3]; self.mounts.len()];
        let stiffness = self.mount_stiffness(frequency);
        let centre = Vector3::from(self.body().centre);
        for unit in 0..6 {
            let mut load = Vector6::zeros();
            load[unit] = 1.0;
            if unit < 3 {
                let moment = -centre.cross(&load.fixed_rows::<3>(0).into_owned());
                load.fixed_rows_mut::<3>(3).copy_from(&moment);
            }
            let forces: Vec<[Complex64; 3]> = if frequency == 0.0 {
                self.rigid_share(load.into()).iter().map(|f| f.map(Complex64::from)).collect()
            } else {
                let resonance = || MountError::Resonance { order: 1.0, speed: frequency };
                let motion = self
                    .solve(frequency, speed, &stiffness, &load.map(Complex64::from))
                    .ok_or_else(resonance)?;
                let pairs = self.mounts.iter().zip(&stiffness);
                pairs.map(|(m, stiffness)| m.force(frequency, stiffness, &motion).into()).collect()
            };
            for (share, force) in result.iter_mut().zip(forces) {
                for j in 0..3 {
                    share[j][unit] = force[j];
                }
            }
        }
        Ok(result)
    }

    /// Force transmissibility against frequency: for a unit load in each coordinate at the centre, what all mounts together
    /// pass on in the same coordinate, of the engine that stands. 1 for slow loads, above 1 near the natural frequencies, then falling.
    ///
    /// # Errors
    /// [`MountError::Resonance`] where the block is undamped and one of `frequencies` [rad/s] is natural.
    pub fn transmissibility(&self, frequencies: &[f64]) -> Result<Vec<[f64; 6]>, MountError> {
        let one = |&frequency: &f64| {
            let mut result = [0.0; 6];
            let stiffness = self.mount_stiffness(frequency);
            for (unit, result) in result.iter_mut().enumerate() {
                let mut load = Vector6::zeros();
                load[unit] = Complex64::ONE;
                let resonance = || MountError::Resonance { order: 1.0, speed: frequency };
                let motion = self.solve(frequency, 0.0, &stiffness, &load).ok_or_else(resonance)?;
                let pairs = self.mounts.iter().zip(&stiffness);
                let passed: Vector6<Complex64> =
                    pairs.map(|(m, own)| m.on_centre(&m.force(frequency, own, &motion))).sum();
                *result = passed[unit].norm();
            }
            Ok(result)
        };
        frequencies.iter().map(one).collect()
    }

    /// Mounts whose table ends before the excitation does.
    fn beyond_table(&self, speeds: &[SpeedResponse]) -> Vec<BeyondTable> {
        let all = speeds.iter().flat_map(|s| s.orders.iter().map(|o| o.order * s.speed));
        let (low, high) = all.fold((f64::INFINITY, 0.0f64), |(low, high), f| (low.min(f), high.max(f)));
        let ends = |m: &Spring| {
            Some([m.spring.table.first()?.angular_frequency, m.spring.table.last()?.angular_frequency])
        };
        let mounts = self.mounts.iter().enumerate().filter_map(|(mount, m)| Some((mount, ends(m)?)));
        mounts
            .filter(|(_, [first, last])| low < *first || high > *last)
            .map(|(mount, table)| BeyondTable { mount, table, excitation: [low, high] })
            .collect()
    }
}

impl Spring {
    /// Force on the mount for the motion of the centre.
    fn force(
        &self,
        frequency: f64,
        stiffness: &[Complex64; 3],
        motion: &Vector6<Complex64>,
    ) -> Vector3<Complex64> {
        let mut force = Vector3::zeros();
        for k in 0..3 {
            let yielding: Complex64 = (0..6).map(|i| motion[i] * self.along[k][i]).sum();
            let own = (stiffness[k] + Complex64::new(0.0, frequency * self.spring.damping[k])) * yielding;
            for i in 0..3 {
                force[i] += own * self.axes[(k, i)];
            }
        }
        force
    }

    /// A force on the mount as force and moment about the centre of the block.
    fn on_centre(&self, force: &Vector3<Complex64>) -> Vector6<Complex64> {
        let mut sum = Vector6::zeros();
        for k in 0..3 {
            let own: Complex64 = (0..3).map(|i| force[i] * self.axes[(k, i)]).sum();
            for i in 0..6 {
                sum[i] += own * self.along[k][i];
            }
        }
        sum
    }
}

/// Force on a mount for a load, from what it takes of a unit of each.
fn shared(share: &Matrix3x6<f64>, load: &Vector6<Complex64>) -> [Complex64; 3] {
    [0, 1, 2].map(|i| (0..6).map(|c| load[c] * share[(i, c)]).sum())
}

/// Solution of six linear equations by elimination with the largest pivot of each column; `None` where a pivot vanishes.
fn solved(matrix: &Complex6x6, right: &Vector6<Complex64>) -> Option<Vector6<Complex64>> {
    let mut rows: [[Complex64; 7]; 6] =
        std::array::from_fn(|i| std::array::from_fn(|j| if j < 6 { matrix[(i, j)] } else { right[i] }));
    for k in 0..6 {
        let pivot = (k + 1..6)
            .fold(k, |best, i| if rows[i][k].norm_sqr() > rows[best][k].norm_sqr() { i } else { best });
        rows.swap(pivot, k);
        let size = rows[k][k].norm_sqr();
        if !(size > 0.0 && size.is_finite()) {
            return None;
        }
        let inverse = rows[k][k].conj() / size;
        let (above, below) = rows.split_at_mut(k + 1);
        let above = &mut above[k];
        above.iter_mut().for_each(|value| *value *= inverse);
        for row in below {
            let factor = row[k];
            row.iter_mut().zip(above.iter()).skip(k + 1).for_each(|(value, above)| *value -= factor * above);
        }
    }
    let mut result = Vector6::zeros();
    for k in (0..6).rev() {
        let known: Complex64 = (k + 1..6).map(|j| rows[k][j] * result[j]).sum();
        result[k] = rows[k][6] - known;
    }
    result.iter().all(|c: &Complex64| c.is_finite()).then_some(result)
}
