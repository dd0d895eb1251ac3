//! How long a run takes: ten revolutions at free speed, tolerance 1e-9, of a single and a V6 with a sealed gas; with every reaction, on mounts, and the periodic motion.
use criterion::{Criterion, criterion_group, criterion_main};
use lanchester_file::{read, template};
use lanchester_model::*;
use lanchester_multibody::{BlockMotion, GasPressure, LoadLaw, RotorInertia, Simulation, Train};
use std::f64::consts::TAU;
use std::hint::black_box;

/// A closed cylinder of compression ratio 9, fired by a factor on the expansion.
struct Sealed;

impl GasPressure for Sealed {
    fn pressure(&self, _: usize, own: f64, _: f64) -> f64 {
        let own = own.rem_euclid(2.0 * TAU);
        // Two revolutions: expansion, exhaust, intake, compression.
        let volume = |angle: f64| 1.0 + 4.0 * (1.0 - angle.cos());
        match own {
            own if own < TAU / 2.0 => 1e5 * (2.0 * (9.0f64 / volume(own)).powf(1.35) - 1.0),
            own if own < 1.5 * TAU => 0.0,
            own => 1e5 * ((9.0f64 / volume(own)).powf(1.35) - 1.0),
        }
    }

    fn cycle(&self) -> f64 {
        2.0 * TAU
    }

    fn kinks(&self, _: usize) -> Vec<f64> {
        vec![0.0, TAU / 2.0, 1.5 * TAU]
    }
}

/// An engine of the gallery with bores, firing angles and a block on four mounts.
fn engine(name: &str) -> Engine {
    let template = template(name).expect("the gallery has it");
    let file = read(template.text).file.expect("the gallery's files are valid");
    let mut engine = file.engine.into_parts();
    let count = engine.cylinders.len();
    for (index, cylinder) in engine.cylinders.iter_mut().enumerate() {
        cylinder.bore.get_or_insert(0.086);
        cylinder.firing_angle.get_or_insert(2.0 * TAU * index as f64 / count as f64);
    }
    engine.block = Some(Block {
        mass: 180.0,
        centre: [0.05, 0.01, 0.02],
        inertia: [12.0, 11.0, 6.0],
        products: [0.1, -0.2, 0.15],
        moving_parts: MovingParts::Included,
        gravity: [-1.0, 0.0, 0.0],
        driveline_torque: [0.0; 3],
    });
    for (y, z) in [(0.25, 0.3), (-0.25, 0.28), (0.22, -0.25), (-0.25, -0.27)] {
        let spring = MountSpring { damping: [400.0; 3], ..MountSpring::along_frame([2e5, 1.2e5, 1e5]) };
        engine.mounts.push(Mount { name: format!("mount {y} {z}"), x: -0.1, y, z, spring: Some(spring) });
    }
    Engine::new(engine).expect("it is valid")
}

fn runs(c: &mut Criterion) {
    let mut group = c.benchmark_group("ten revolutions");
    for (name, template) in [("single", "single"), ("V6", "v6-60")] {
        let engine = engine(template);
        let inertia = RotorInertia {
            crankshafts: vec![Some(0.2); engine.crankshafts.len()],
            shafts: vec![Some(1e-3); engine.shafts.len()],
            ..RotorInertia::default()
        };
        let train = Train::new(&engine, &inertia).expect("it turns");
        let mut plain = Simulation::free(200.0, 10.0);
        plain.load.law = LoadLaw::Viscous { torque: 15.0 * engine.cylinders.len() as f64, at: 200.0 };
        plain.step = TAU;
        let sampled = Simulation { step: TAU / 360.0, reactions: true, ..plain.clone() };
        let on_mounts = Simulation { block: BlockMotion::Mounts, gravity: 9.81, ..sampled.clone() };
        let run = |simulation: &Simulation| train.run(black_box(simulation), Some(&Sealed));
        group.bench_function(format!("{name}, trajectory"), |b| b.iter(|| run(&plain)));
        group.bench_function(format!("{name}, reactions at every degree"), |b| b.iter(|| run(&sampled)));
        group.bench_function(format!("{name}, on mounts, reactions at every degree"), |b| {
            b.iter(|| run(&on_mounts))
        });
        if name == "V6" {
            let quiet = Simulation { reactions: false, ..on_mounts.clone() };
            group.sample_size(10);
            group.bench_function("V6, on mounts, periodic", |b| {
                b.iter(|| train.periodic(black_box(&quiet), Some(&Sealed)))
            });
        }
    }
    group.finish();
}

criterion_group!(benches, runs);
criterion_main!(benches);
