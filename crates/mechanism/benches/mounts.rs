//! How long the block on its mounts takes: four mounts, 200 speeds, 12 orders.
use criterion::{Criterion, criterion_group, criterion_main};
use lanchester_file::{read, template};
use lanchester_mechanism::{Excitation, MountSystem};
use lanchester_model::*;
use lanchester_results::OrderLoads;
use num_complex::Complex64;
use std::hint::black_box;

/// A block of 150 kg on four mounts that stand askew, the rear ones with a table.
fn engine() -> Engine {
    let template = template("in-line-4").expect("the gallery has it");
    let mut engine = read(template.text).engine().expect("the gallery's files are valid");
    engine = engine
        .with(|engine| {
            engine.block = Some(Block {
                mass: 150.0,
                centre: [0.08, 0.01, 0.05],
                inertia: [9.0, 8.0, 5.0],
                products: [0.1, -0.2, 0.5],
                moving_parts: MovingParts::Included,
                gravity: [-1.0, 0.0, 0.0],
                driveline_torque: [0.0, 0.0, 120.0],
            });
        })
        .expect("an engine");
    let point =
        |f, k| MountPoint { angular_frequency: f, stiffness: [k, 0.5 * k, 0.4 * k], loss_factor: [0.2; 3] };
    let mount = |(k, (y, z)): (usize, (f64, f64))| {
        let (sin, cos) = (0.3 * k as f64).sin_cos();
        let spring = MountSpring {
            axes: [[cos, sin, 0.0], [-sin, cos, 0.0], [0.0, 0.0, 1.0]],
            stiffness: [2e5, 1e5, 8e4],
            damping: [150.0, 80.0, 80.0],
            loss_factor: if z > 0.0 { [0.0; 3] } else { [0.1; 3] },
            preload: 0.0,
            table: if z > 0.0 {
                vec![point(30.0, 2e5), point(600.0, 3e5), point(2000.0, 4e5)]
            } else {
                Vec::new()
            },
        };
        Mount { name: format!("mount {}", k + 1), x: -0.05, y, z, spring: Some(spring) }
    };
    let places = [(-0.25, -0.2), (0.25, -0.2), (-0.2, 0.35), (0.2, 0.35)];
    engine = engine
        .with(|engine| {
            engine.mounts = places.into_iter().enumerate().map(mount).collect();
        })
        .expect("an engine");
    engine
}

/// 200 speeds from 800 to 6000 rpm with orders 0.5 to 6 in all components.
fn excitations() -> Vec<Excitation> {
    let load = |speed: f64, k: u32| {
        let order = 0.5 * f64::from(k);
        let size = |share: f64| Complex64::from_polar(share * speed * speed, order);
        OrderLoads {
            order,
            force_forward: size(0.01),
            force_backward: size(0.02),
            couple_forward: size(0.001),
            couple_backward: size(0.002),
            roll_moment: size(0.003),
            shaft_torque: size(0.003),
        }
    };
    (0..200)
        .map(|j| {
            let speed = 80.0 + 2.7 * f64::from(j);
            Excitation { speed, orders: (1..=12).map(|k| load(speed, k)).collect() }
        })
        .collect()
}

fn mounts(criterion: &mut Criterion) {
    let tabled = engine();
    let mut plain = tabled.clone();
    plain = plain
        .with(|plain| {
            plain.mounts.iter_mut().filter_map(|m| m.spring.as_mut()).for_each(|s| s.table.clear());
        })
        .expect("an engine");
    let excitations = excitations();
    let mut group = criterion.benchmark_group("mounts");
    for (name, engine) in [("no table", &plain), ("two mounts with a table", &tabled)] {
        let system = MountSystem::new(engine).expect("the mounts hold the block");
        group.bench_function(format!("200 speeds x 12 orders, {name}"), |b| {
            b.iter(|| system.response(black_box(&excitations)));
        });
        group.bench_function(format!("modes, {name}"), |b| b.iter(|| black_box(&system).modes()));
    }
    group.bench_function("prepare", |b| b.iter(|| MountSystem::new(black_box(&plain))));
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(30).measurement_time(std::time::Duration::from_secs(2));
    targets = mounts
}
criterion_main!(benches);
