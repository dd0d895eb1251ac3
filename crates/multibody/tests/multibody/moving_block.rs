//! The block on its mounts at imposed speed: the linear response of the closed form, and the three causes by which it differs.

use crate::support;
use lanchester_mechanism::{MountSystem, inertia_excitations};
use lanchester_model::{Block, Engine, Mount, MountSpring, MovingParts};
use lanchester_multibody::*;
use nalgebra::{Matrix6, Vector3, Vector6};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// A three-cylinder engine, which shakes by couples and forces of a few orders, in a block on four soft mounts; its pistons and rods are a share of their mass.
fn engine(share: f64) -> Engine {
    let mut engine = support::in_line(&[0.0, TAU / 3.0, 2.0 * TAU / 3.0]);
    engine = engine
        .with(|engine| {
            for cylinder in &mut engine.cylinders {
                cylinder.piston_mass *= share;
                cylinder.rod.big_end_mass *= share;
                cylinder.rod.small_end_mass *= share;
            }

            for throw in &mut engine.throws {
                throw.unbalance *= share;
            }

            engine.speed.lowest = 120.0;

            engine.speed.highest = 120.0;

            engine.block = Some(Block {
                mass: 150.0,
                centre: [0.05, 0.01, 0.02],
                inertia: [9.0, 8.0, 4.0],
                products: [0.1, -0.2, 0.15],
                moving_parts: MovingParts::Included,
                gravity: [-1.0, 0.0, 0.0],
                driveline_torque: [0.0; 3],
            });
        })
        .unwrap();
    for (y, z) in [(0.25, 0.3), (-0.25, 0.28), (0.22, -0.25), (-0.25, -0.27)] {
        let spring = MountSpring { damping: [400.0; 3], ..MountSpring::along_frame([2e5, 1.2e5, 1e5]) };
        engine = engine
            .with(|engine| {
                engine.mounts.push(Mount {
                    name: format!("at {y} {z}"),
                    x: -0.1,
                    y,
                    z,
                    spring: Some(spring),
                });
            })
            .unwrap();
    }
    engine
}

/// Inertia of the rotor: a large one, so that its causes show.
const J: f64 = 0.8;

/// Orders of displacement of the block's centre and of its rotation in the periodic motion, by component.
fn simulated(engine: &Engine, orders: usize) -> Vec<[Complex64; 6]> {
    let inertia = RotorInertia { crankshafts: vec![Some(J)], ..RotorInertia::default() };
    let train = Train::new(engine, &inertia).expect("it turns");
    let simulation = Simulation { block: BlockMotion::Mounts, ..Simulation::imposed(120.0, 1.0) };
    let found = train.periodic(&simulation, None).expect("it runs");
    assert!(found.residual < 1e-10, "{:?}", found.residual);
    let samples = &found.run.samples;
    let count = samples.theta.len() - 1;
    let centre = Vector3::from(engine.block.as_ref().expect("it has one").centre);
    let at = |k: usize| -> Vector6<f64> {
        let motion = Motion {
            position: samples.position[k].into(),
            orientation: samples.orientation[k],
            ..Motion::fixed(0.0, 0.0)
        };
        let rotation = motion.rotation();
        let moved = motion.position + rotation * centre - centre;
        let turn = nalgebra::Rotation3::from_matrix_unchecked(rotation).scaled_axis();
        Vector6::new(moved.x, moved.y, moved.z, turn.x, turn.y, turn.z)
    };
    let all: Vec<Vector6<f64>> = (0..count).map(at).collect();
    (0..orders)
        .map(|order| {
            let by = |c: usize| -> Complex64 {
                let terms = all.iter().enumerate().map(|(k, q)| {
                    q[c] * Complex64::cis(
                        -TAU * (order * k) as f64 * f64::from(train.revolutions) / count as f64,
                    )
                });
                terms.sum::<Complex64>() * (2.0 / count as f64)
            };
            std::array::from_fn(by)
        })
        .collect()
}

/// The linear model, order by order, with causes 1 and 2 where asked for.
fn linear(engine: &Engine, orders: usize, gyroscopic: bool, roll: bool) -> Vec<[Complex64; 6]> {
    let block = engine.block.as_ref().expect("it has one");
    let centre = Vector3::from(block.centre);
    let speed = engine.speed.highest;
    let excitation = &inertia_excitations(engine, &[speed], orders as u32).expect("it turns")[0];
    let mut mass = Matrix6::zeros();
    let tensor = block.tensor();
    for i in 0..3 {
        mass[(i, i)] = block.mass;
        for j in 0..3 {
            mass[(3 + i, 3 + j)] = tensor[i][j];
        }
    }
    let mut damping = Matrix6::zeros();
    if roll {
        mass[(5, 5)] -= J;
    }
    if gyroscopic {
        // J w Omega x z.
        damping[(3, 4)] += J * speed;
        damping[(4, 3)] -= J * speed;
    }
    let mut stiffness = Matrix6::zeros();
    for mount in &engine.mounts {
        let spring = mount.spring.as_ref().expect("it has one");
        let rho = Vector3::new(mount.x, mount.y, mount.z) - centre;
        for (k, axis) in spring.axes.iter().enumerate() {
            let axis = Vector3::from(*axis);
            let turn = rho.cross(&axis);
            let along = Vector6::new(axis.x, axis.y, axis.z, turn.x, turn.y, turn.z);
            stiffness += spring.stiffness[k] * along * along.transpose();
            damping += spring.damping[k] * along * along.transpose();
        }
    }
    (0..orders)
        .map(|order| {
            let Some(loads) =
                excitation.orders.iter().find(|loads| (loads.order - order as f64).abs() < 1e-9)
            else {
                return [Complex64::ZERO; 6];
            };
            let i = Complex64::I;
            let (force, back) = (loads.force_forward, loads.force_backward.conj());
            let (couple, couple_back) = (loads.couple_forward, loads.couple_backward.conj());
            let [x, y] = [force + back, -i * (force - back)];
            let [mx, my] = [couple + couple_back, -i * (couple - couple_back)];
            // About the centre of the block.
            let at = centre;
            let load = [
                x,
                y,
                Complex64::ZERO,
                mx + at.z * y,
                my - at.z * x,
                loads.roll_moment - at.x * y + at.y * x,
            ];
            let w = order as f64 * speed;
            let matrix = Matrix6::from_fn(|a, b| {
                Complex64::new(stiffness[(a, b)] - w * w * mass[(a, b)], w * damping[(a, b)])
            });
            let load = Vector6::from(load);
            let answer = matrix.lu().solve(&load).expect("it is damped");
            std::array::from_fn(|k| answer[k])
        })
        .collect()
}

/// Largest difference over orders 1 and up, over the largest translation or rotation.
fn off(a: &[[Complex64; 6]], b: &[[Complex64; 6]]) -> f64 {
    let largest = |range: std::ops::Range<usize>| {
        b[1..].iter().flat_map(|order| order[range.clone()].iter().map(|c| c.norm())).fold(0.0, f64::max)
    };
    let scales = [largest(0..3), largest(3..6)];
    let pairs = a[1..].iter().zip(&b[1..]).flat_map(|(a, b)| (0..6).map(move |k| (k, (a[k] - b[k]).norm())));
    pairs.map(|(k, off)| off / scales[k / 3]).fold(0.0, f64::max)
}

#[test]
fn xcheck_mounts_and_the_causes_of_the_difference() {
    let orders = 7;
    let whole = engine(1.0);
    // The linear model here is that of the closed form, without what the rotors do and with it.
    let excitations = inertia_excitations(&whole, &[120.0], orders as u32 - 1).expect("it turns");
    for rotors in [false, true] {
        let system = MountSystem::new(&whole).expect("it is held");
        let system = system.with_rotors(if rotors { J } else { 0.0 });
        let response = system.response(&excitations).expect("it is damped");
        let own = linear(&whole, orders, rotors, rotors);
        for order in &response.speeds[0].orders {
            let ours = own[order.order.round() as usize];
            for (ours, theirs) in ours.iter().zip(&order.motion) {
                assert!((ours - theirs).norm() < 1e-12, "order {}: {ours} {theirs}", order.order);
            }
        }
    }

    let found = simulated(&whole, orders);
    let with_both = off(&linear(&whole, orders, true, true), &found);
    let without_gyroscope = off(&linear(&whole, orders, false, true), &found);
    let without_roll = off(&linear(&whole, orders, true, false), &found);
    // Each cause matters more than all that is left.
    assert!(without_gyroscope > 2.0 * with_both && without_roll > 2.0 * with_both);
    // What is left is in proportion to the moving mass.
    let half = engine(0.5);
    let halved = off(&linear(&half, orders, true, true), &simulated(&half, orders));
    let ratio = with_both / halved;
    assert!((ratio - 2.0).abs() < 0.04, "{with_both:e} {halved:e}: {ratio}");
}
