//! The response by orders against the equations of motion, integrated step by step from rest under the loads over the
//! crank angle.
use crate::support::mounted::{block, matrices, mount, reach};
use crate::support::pressure::{diesel_like, fired};
use crate::support::{in_line, vee};
use lanchester_mechanism::{
    GasTrain, Lever, LoadRequest, MountSystem, inertia_excitations, loads, merged_orders,
};
use lanchester_model::{Block, Engine, Mount, MountSpring, Strokes};
use nalgebra::{Matrix6, Vector3, Vector6};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Half steps in a revolution: the classical Runge-Kutta method takes two a step.
const HALF_STEPS: usize = 1440;

const SPEED: f64 = 140.0;

/// `engine` on three dampers that stand askew, its centre off the crankshaft, with all products of inertia.
fn on_dampers(engine: Engine) -> Engine {
    let damper = |name: &str, place, stiffness: [f64; 3], turn: f64| {
        let (sin, cos) = turn.sin_cos();
        let axes = [[cos, sin, 0.0], [-0.8 * sin, 0.8 * cos, 0.6], [0.6 * sin, -0.6 * cos, 0.8]];
        let spring = MountSpring {
            axes,
            damping: stiffness.map(|k| 0.004 * k + 300.0),
            ..MountSpring::along_frame(stiffness)
        };
        Mount { spring: Some(spring), ..mount(name, place, [0.0; 3]) }
    };
    engine
        .with(|parts| {
            parts.block = Some(Block {
                centre: [0.11, -0.04, 0.07],
                products: [0.5, -0.4, 0.9],
                ..block(130.0, [8.0, 7.0, 4.5])
            });
            parts.mounts = vec![
                damper("left", [-0.1, -0.3, -0.2], [3e5, 1.5e5, 1e5], 0.4),
                damper("right", [-0.05, 0.28, -0.15], [2e5, 2.5e5, 1.2e5], -0.7),
                damper("rear", [0.03, 0.05, 0.5], [4e5, 2e5, 1.4e5], 1.1),
            ];
        })
        .unwrap()
}

/// Load on the block about its centre at so many half steps: inertia, and the reaction to the gas torque.
fn load(engine: &Engine, centre: [f64; 3], gas: Option<&GasTrain>, revolutions: usize) -> Vec<Vector6<f64>> {
    let request =
        LoadRequest { speed: Some(SPEED), samples: HALF_STEPS, reference: centre, ..LoadRequest::default() };
    let trace = loads(engine, &request).expect("the engine is valid").total.trace;
    let at = |k: usize| {
        let j = k % HALF_STEPS;
        let driven = gas.map_or(0.0, |gas| gas.torque(TAU * k as f64 / HALF_STEPS as f64));
        // The mean drives the vehicle and leans the block; what is left shakes it.
        let mean = gas.map_or(0.0, |gas| gas.mean_torques().iter().sum());
        Vector6::new(
            trace.force_x[j],
            trace.force_y[j],
            0.0,
            trace.couple_x[j],
            trace.couple_y[j],
            trace.roll_moment[j] - (driven - mean),
        )
    };
    (0..revolutions * HALF_STEPS).map(at).collect()
}

/// Motion and velocity at every step of one working cycle, after so many cycles from rest.
fn integrated(engine: &Engine, load: &[Vector6<f64>], cycles: usize) -> Vec<(Vector6<f64>, Vector6<f64>)> {
    let (mass, stiffness, damping) = matrices(engine);
    let stiffness: Matrix6<f64> = stiffness.map(|k| k.re);
    let light = mass.try_inverse().expect("a body has mass");
    let rate = |load: &Vector6<f64>, q: Vector6<f64>, v: Vector6<f64>| {
        (v, light * (load - stiffness * q - damping * v))
    };
    let step = 2.0 * TAU / HALF_STEPS as f64 / SPEED;
    let (mut q, mut v) = (Vector6::zeros(), Vector6::zeros());
    let mut last = Vec::new();
    for cycle in 0..=cycles {
        for k in (0..load.len()).step_by(2) {
            if cycle == cycles {
                last.push((q, v));
            }
            let [from, middle, to] = [k, k + 1, k + 2].map(|k| &load[k % load.len()]);
            let one = rate(from, q, v);
            let two = rate(middle, q + 0.5 * step * one.0, v + 0.5 * step * one.1);
            let three = rate(middle, q + 0.5 * step * two.0, v + 0.5 * step * two.1);
            let four = rate(to, q + step * three.0, v + step * three.1);
            q += step / 6.0 * (one.0 + 2.0 * (two.0 + three.0) + four.0);
            v += step / 6.0 * (one.1 + 2.0 * (two.1 + three.1) + four.1);
        }
    }
    last
}

/// Compares motion and forces at the mounts over a cycle; returns the largest sums of orders 0.5, 1.5 and so on.
fn compare(engine: &Engine, gas: Option<&GasTrain>, max_order: u32, tolerance: f64) -> f64 {
    let system = MountSystem::new(engine).expect("the mounts hold the block");
    let mut excitation =
        inertia_excitations(engine, &[SPEED], max_order).expect("the engine is valid").remove(0);
    if let Some(gas) = gas {
        excitation.orders = merged_orders(&excitation.orders, &gas.orders(max_order));
    }
    let found = system.response(&[excitation]).expect("it is damped").speeds.remove(0);
    let revolutions = if gas.is_some() { 2 } else { 1 };
    let centre = engine.block.as_ref().expect("it has a block").centre;
    let load = load(engine, centre, gas, revolutions);
    let in_time = integrated(engine, &load, 80);
    // The mean of the inertia loads leans the block too, and belongs to the block at rest: it is taken out of both.
    let mean = in_time.iter().map(|(q, _)| q).sum::<Vector6<f64>>() / in_time.len() as f64;
    let turned = |list: &[Complex64], order: f64, theta: f64| -> Vec<f64> {
        list.iter().map(|c| (c * Complex64::cis(order * theta)).re).collect()
    };
    let (mut halves, mut misses, mut sizes) = (0.0f64, [0.0f64; 2], [0.0f64; 2]);
    for (k, (q, v)) in in_time.iter().enumerate() {
        let theta = TAU * 2.0 * k as f64 / HALF_STEPS as f64;
        let sum = found.orders.iter().fold(Vector6::zeros(), |sum: Vector6<f64>, o| {
            sum + Vector6::from_vec(turned(&o.motion, o.order, theta))
        });
        misses[0] = misses[0].max((sum - (q - mean)).norm());
        sizes[0] = sizes[0].max((q - mean).norm());
        for (number, mount) in engine.mounts.iter().enumerate() {
            let spring = mount.spring.as_ref().expect("it has a spring");
            let reach = reach(centre, [mount.x, mount.y, mount.z]);
            let (yielding, rate): (Vector3<f64>, Vector3<f64>) = (reach * (q - mean), reach * v);
            let force: Vector3<f64> = (0..3)
                .map(|k| {
                    let axis = Vector3::from(spring.axes[k]);
                    axis * (spring.stiffness[k] * axis.dot(&yielding) + spring.damping[k] * axis.dot(&rate))
                })
                .sum();
            let of = |fraction: bool| {
                let orders = found.orders.iter().filter(|o| !fraction || o.order.fract() != 0.0);
                orders.fold(Vector3::zeros(), |sum: Vector3<f64>, o| {
                    sum + Vector3::from_vec(turned(&o.forces[number], o.order, theta))
                })
            };
            misses[1] = misses[1].max((of(false) - force).norm());
            sizes[1] = sizes[1].max(force.norm());
            halves = halves.max(of(true).norm());
        }
    }
    for (what, (miss, size)) in ["motion", "force at a mount"].into_iter().zip(misses.into_iter().zip(sizes))
    {
        assert!(miss <= tolerance * size, "{what}: off by {:e} of {size:e}", miss / size);
    }
    halves
}

#[test]
fn steady_motion_under_inertia_loads_is_that_of_the_equations_in_time() {
    // Both methods are exact but for rounding and the steps, (0.004)^4 of a revolution.
    compare(&on_dampers(vee(70.0, &[0.0, 150.0])), None, 30, 1e-8);
}

#[test]
fn steady_motion_under_gas_is_that_of_the_equations_in_time_with_half_orders() {
    let engine = fired(on_dampers(in_line(&[0.0, 120.0, 240.0])), 0.08, Strokes::Four);
    let gas: Vec<_> = [2.4, 2.0, 2.2].map(|peak| diesel_like(&engine, peak)).into();
    let gas = GasTrain::new(&engine, &gas, Lever::Exact).expect("it has pressures");
    // What is left out above order 60 falls as its fifth power.
    let halves = compare(&engine, Some(&gas), 60, 1e-6);
    assert!(halves > 10.0, "{halves} N");
}
