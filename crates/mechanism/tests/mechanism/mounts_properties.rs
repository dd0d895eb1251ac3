//! What must hold for every block on mounts.
use crate::support::mounted::{Complex6x6, any_mounted, matrices, reach};
use crate::support::vee;
use lanchester_mechanism::{MountSystem, inertia_excitations, merged_orders, vector_amplitude};
use lanchester_model::Engine;
use nalgebra::{DMatrix, DVector, Matrix6, Vector3, Vector6};
use num_complex::Complex64;
use proptest::prelude::*;
use std::f64::consts::TAU;

fn engines() -> impl Strategy<Value = Engine> {
    any_mounted(vee(90.0, &[0.0, 180.0]))
}

fn system(engine: &Engine) -> MountSystem {
    MountSystem::new(engine).expect("random mounts hold the block")
}

fn size(vector: &[Complex64; 6]) -> f64 {
    vector.iter().map(|c| c.norm_sqr()).sum::<f64>().sqrt()
}

/// The engine with one loss factor everywhere and no dampers.
fn evenly_damped(mut engine: Engine, loss: f64) -> Engine {
    engine = engine
        .with(|engine| {
            for spring in engine.mounts.iter_mut().filter_map(|m| m.spring.as_mut()) {
                (spring.damping, spring.loss_factor) = ([0.0; 3], [loss; 3]);
            }
        })
        .unwrap();
    engine
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn prop_energy_shares_add_up_and_modes_solve_their_equation(engine in engines()) {
        let found = system(&engine).modes().expect("it has modes");
        let (mass, stiffness, _) = matrices(&engine);
        let stiffness = stiffness.map(|k| k.re);
        for mode in &found.modes {
            let sum: f64 = mode.energy.iter().sum();
            prop_assert!((sum - 1.0).abs() < 1e-11, "{sum}");
            let elastic: f64 = mode.mount_energy.iter().sum();
            prop_assert!((elastic - 1.0).abs() < 1e-11 && mode.mount_energy.iter().all(|e| *e > -1e-12));
            let shape = Vector6::from(mode.shape);
            let miss = stiffness * shape - mode.angular_frequency.powi(2) * (mass * shape);
            prop_assert!(miss.norm() <= 1e-9 * (stiffness * shape).norm(), "{}", miss.norm());
            prop_assert!(mode.energy.iter().all(|e| *e <= mode.energy[mode.main]));
            prop_assert!((mode.coupling - 1.0 + mode.energy[mode.main]).abs() < 1e-15);
        }
        for (i, a) in found.modes.iter().enumerate() {
            for (j, b) in found.modes.iter().enumerate() {
                let product = Vector6::from(a.shape).dot(&(mass * Vector6::from(b.shape)));
                prop_assert!((product - f64::from(u8::from(i == j))).abs() < 1e-9, "{i} {j} {product}");
            }
        }
    }

    #[test]
    fn prop_damped_modes_solve_their_equation(engine in engines()) {
        let (mass, stiffness, damping) = matrices(&engine);
        let found = system(&engine).modes().expect("it has modes");
        prop_assert!(found.damped.len() >= 6);
        for mode in &found.damped {
            let shape = Vector6::from(mode.shape);
            let p = mode.root;
            let matrix: Complex6x6 =
                mass.map(|m| p * p * m) + damping.map(|c| p * c) + stiffness;
            let scale = (stiffness * shape).norm() + (mass.map(|m| p * p * m) * shape).norm();
            prop_assert!((matrix * shape).norm() <= 1e-8 * scale, "{p}: {}", (matrix * shape).norm() / scale);
            prop_assert!(p.re < 0.0, "damping takes energy: {p}");
        }
    }

    #[test]
    fn prop_forces_inertia_and_load_are_in_equilibrium(engine in engines(), speed in 20.0..700.0f64) {
        let excitations = inertia_excitations(&engine, &[speed], 6).expect("valid");
        let found = system(&engine).response(&excitations).expect("it is damped");
        let (mass, _, _) = matrices(&engine);
        let centre = engine.block.as_ref().expect("it has a block").centre;
        for order in &found.speeds[0].orders {
            // Forces on the mounts, summed with their levers, are the load less mass times acceleration.
            let mut sum = [Complex64::ZERO; 6];
            for (mount, force) in engine.mounts.iter().zip(&order.forces) {
                let lever = reach(centre, [mount.x, mount.y, mount.z]);
                for i in 0..6 {
                    sum[i] += (0..3).map(|j| force[j] * lever[(j, i)]).sum::<Complex64>();
                }
            }
            let w2 = (order.order * speed).powi(2);
            let inertia = mass.map(|m| Complex64::from(-w2 * m)) * Vector6::from(order.motion);
            let scale = size(&order.load) + size(&inertia.into()) + size(&sum);
            for c in 0..6 {
                prop_assert!((sum[c] + inertia[c] - order.load[c]).norm() <= 1e-10 * scale);
                prop_assert!((sum[c] - order.transmitted[c]).norm() <= 1e-12 * scale);
            }
        }
    }

    #[test]
    fn prop_modal_superposition_equals_the_direct_solution(
        engine in engines(), speed in 20.0..700.0f64, loss in 0.01..0.4f64,
    ) {
        let engine = evenly_damped(engine, loss);
        let system = system(&engine);
        let modes = system.modes().expect("it has modes").modes;
        let excitations = inertia_excitations(&engine, &[speed], 4).expect("valid");
        let found = system.response(&excitations).expect("it is damped");
        for order in &found.speeds[0].orders {
            let w2 = (order.order * speed).powi(2);
            let mut sum = [Complex64::ZERO; 6];
            for mode in &modes {
                let into: Complex64 = (0..6).map(|c| order.load[c] * mode.shape[c]).sum();
                let own = mode.angular_frequency.powi(2) * Complex64::new(1.0, loss);
                (0..6).for_each(|c| sum[c] += into / (own - w2) * mode.shape[c]);
            }
            for c in 0..6 {
                prop_assert!((sum[c] - order.motion[c]).norm() <= 1e-9 * size(&order.motion));
            }
        }
        // The damped roots of even loss: w sqrt(1 + i loss), turned to decay.
        let damped = system.modes().expect("it has modes").damped;
        for (mode, root) in modes.iter().zip(&damped) {
            let wanted = Complex64::I * mode.angular_frequency * Complex64::new(1.0, loss).sqrt();
            prop_assert!((root.root - wanted).norm() <= 1e-9 * wanted.norm(), "{root:?} {wanted}");
        }
    }

    #[test]
    fn prop_equal_isotropic_springs_share_a_slow_load_by_least_squares(engine in engines(), load in any_load()) {
        let mut engine = evenly_damped(engine, 0.0);
        engine = engine.with(|engine| { for spring in engine.mounts.iter_mut().filter_map(|m| m.spring.as_mut()) {
            spring.stiffness = [3e5; 3];
        } }).unwrap();
        let system = system(&engine);
        let centre = engine.block.as_ref().expect("it has a block").centre;
        let count = engine.mounts.len();
        // Of all forces that carry the load those with the least sum of squares: A^T (A A^T)^-1 load.
        let mut carry = DMatrix::zeros(6, 3 * count);
        for (k, mount) in engine.mounts.iter().enumerate() {
            carry.view_mut((0, 3 * k), (6, 3)).copy_from(&reach(centre, [mount.x, mount.y, mount.z]).transpose());
        }
        let wanted = carry.transpose()
            * (&carry * carry.transpose()).lu().solve(&DVector::from_column_slice(&load)).expect("it is held");
        let got = system.rigid_share(load);
        let scale = wanted.norm();
        for k in 0..count {
            (0..3).try_for_each(|j| {
                prop_assert!((got[k][j] - wanted[3 * k + j]).abs() <= 1e-8 * scale);
                Ok(())
            })?;
        }
    }

    #[test]
    fn prop_slow_loads_are_shared_as_at_rest_and_the_transfer_is_linear(engine in engines(), speed in 50.0..600.0f64) {
        let system = system(&engine);
        let block = engine.block.clone().expect("it has a block");
        let slow = system.transfer(1e-7, 0.0).expect("held");
        let still = system.transfer(0.0, 0.0).expect("held");
        let stiff = evenly_damped(engine.clone(), 0.0);
        let undamped = MountSystem::new(&stiff).expect("held").transfer(1e-7, 0.0).expect("held");
        for (mount, (a, b)) in still.iter().zip(&undamped).enumerate() {
            for j in 0..3 {
                for c in 0..6 {
                    prop_assert!((a[j][c] - b[j][c]).norm() <= 1e-9 * (1.0 + a[j][c].norm()), "{mount} {j} {c}");
                }
            }
        }
        prop_assert_eq!(slow.len(), engine.mounts.len());
        // The response is the transfer of the load about the origin.
        let excitations = inertia_excitations(&engine, &[speed], 3).expect("valid");
        let found = system.response(&excitations).expect("it is damped");
        for order in &found.speeds[0].orders {
            let transfer = system.transfer(order.order * speed, speed).expect("it is damped");
            let [fx, fy, fz, mx, my, mz] = order.load;
            let [x, y, z] = block.centre;
            // Moments about the origin.
            let load = [fx, fy, fz, mx + y * fz - z * fy, my + z * fx - x * fz, mz + x * fy - y * fx];
            let largest = order.forces.iter().map(vector_amplitude).fold(0.0, f64::max);
            for (share, force) in transfer.iter().zip(&order.forces) {
                for j in 0..3 {
                    let sum: Complex64 = (0..6).map(|c| share[j][c] * load[c]).sum();
                    prop_assert!((sum - force[j]).norm() <= 1e-9 * largest);
                }
            }
        }
    }

    #[test]
    fn prop_the_peak_is_the_largest_force_over_the_cycle(engine in engines(), speed in 50.0..600.0f64) {
        let mut excitation = inertia_excitations(&engine, &[speed], 5).expect("valid").remove(0);
        // A half order, as gas brings it.
        let mut half = excitation.orders[2];
        half.order = 1.5;
        excitation.orders = merged_orders(&excitation.orders, &[half]);
        let found = system(&engine).response(&[excitation]).expect("it is damped");
        let at = &found.speeds[0];
        let force = |mount: usize, theta: f64| -> f64 {
            let mut sum = Vector3::zeros();
            for order in &at.orders {
                let turn = Complex64::cis(order.order * theta);
                sum += Vector3::from(order.forces[mount]).map(|f| (f * turn).re);
            }
            sum.norm()
        };
        for (mount, peak) in at.peaks.iter().enumerate() {
            let brute = (0..3000).map(|j| force(mount, 2.0 * TAU * f64::from(j) / 3000.0)).fold(0.0, f64::max);
            prop_assert!(peak.value >= brute * (1.0 - 1e-12), "{} {brute}", peak.value);
            prop_assert!(peak.value <= brute * 1.001);
            prop_assert!((force(mount, peak.theta) - peak.value).abs() <= 1e-10 * peak.value);
            let alone = at.orders.iter().map(|o| vector_amplitude(&o.forces[mount]));
            prop_assert!(peak.value <= alone.clone().sum::<f64>() * (1.0 + 1e-12));
        }
    }

    #[test]
    fn prop_rest_carries_weight_torque_and_preload(engine in engines()) {
        let system = system(&engine);
        let rest = system.at_rest();
        let block = engine.block.as_ref().expect("it has a block");
        let (_, stiffness, _) = matrices(&engine);
        let stiffness: Matrix6<f64> = stiffness.map(|k| k.re);
        let mut wanted = Vector6::zeros();
        for k in 0..3 {
            wanted[k] = 9.80665 * block.mass * block.gravity[k];
            wanted[3 + k] = -block.driveline_torque[k];
        }
        let mut sum = Vector6::zeros();
        let mut pushes = Vector6::zeros();
        for (mount, at) in engine.mounts.iter().zip(&rest.mounts) {
            let lever = reach(block.centre, [mount.x, mount.y, mount.z]).transpose();
            let spring = mount.spring.as_ref().expect("it has a spring");
            sum += lever * Vector3::from(at.force);
            pushes += lever * Vector3::from(spring.axes[0]) * spring.preload;
            let shares = Vector3::from(at.gravity) + Vector3::from(at.torque) + Vector3::from(at.preload);
            prop_assert!((shares - Vector3::from(at.force)).norm() <= 1e-9 * wanted.norm());
        }
        prop_assert!((sum - wanted).norm() <= 1e-8 * wanted.norm(), "{sum} {wanted}");
        let carried = stiffness * Vector6::from(rest.motion);
        prop_assert!((carried - wanted - pushes).norm() <= 1e-8 * (wanted.norm() + pushes.norm()));
    }
}

fn any_load() -> impl Strategy<Value = [f64; 6]> {
    let one = -1000.0..1000.0f64;
    [one.clone(), one.clone(), one.clone(), one.clone(), one.clone(), one]
}
