//! How long loads take: orders and the exact trace of an in-line four and a V12 in which nothing is shared.
use criterion::{Criterion, criterion_group, criterion_main};
use lanchester_mechanism::{LoadRequest, Mechanism, loads};
use lanchester_model::*;
use lanchester_results::Trace;
use std::hint::black_box;

/// An engine of which every cylinder has its own rod, masses and offset.
fn engine(axes: &[f64], pins: &[f64], riders: usize) -> Engine {
    let throws = pins
        .iter()
        .enumerate()
        .map(|(k, angle)| Throw {
            crankshaft: 0,
            angle: angle.to_radians(),
            z: 0.1 * k as f64,
            radius: 0.045 + 0.0001 * k as f64,
            unbalance: 0.01,
            unbalance_offset: 0.0,
            webs: None,
        })
        .collect();
    let cylinders = (0..riders * pins.len())
        .map(|k| {
            let own = k as f64;
            Cylinder {
                throw: k / riders,
                angle: axes[k % riders].to_radians(),
                z: 0.1 * (k / riders) as f64 + 0.01 * (k % riders) as f64,
                offset: 0.001 * (own - 1.5),
                pin_offset: 0.0005,
                bore: None,
                piston_mass: 0.5 + 0.01 * own,
                rod: Rod {
                    length: 0.15 + 0.001 * own,
                    big_end_mass: 0.4 + 0.01 * own,
                    small_end_mass: 0.2 + 0.005 * own,
                    inertia: Some(0.002 + 1e-5 * own),
                    axial_inertia: 0.0,
                    mass_rule: RodMassRule::WeighedEnds,
                    joint: RodJoint::Crankpin,
                },
                firing_angle: None,
                chamber: None,
            }
        })
        .collect();
    let crankshaft =
        Crankshaft { name: "crankshaft".into(), ratio: Ratio::ONE, phase: 0.0, x: 0.0, y: 0.0, mains: None };
    Engine::new(EngineParts {
        name: "bench".into(),
        strokes: Strokes::Four,
        rotation: Rotation::Clockwise,
        speed: SpeedRange { lowest: 400.0, highest: 400.0 },
        crankshafts: vec![crankshaft],
        throws,
        cylinders,
        ..EngineParts::default()
    })
    .expect("an engine")
}

fn bench(criterion: &mut Criterion) {
    let engines = [
        ("in-line 4", engine(&[0.0], &[0.0, 180.0, 180.0, 0.0], 1)),
        ("V12", engine(&[-30.0, 30.0], &[0.0, 120.0, 240.0, 240.0, 120.0, 0.0], 2)),
    ];
    for (name, engine) in &engines {
        let request = LoadRequest::default();
        let mechanism = Mechanism::new(engine, &request).expect("the engine is valid");
        let over_angle = mechanism.trace_plan(mechanism.angle_grid(720));
        let mut trace = Trace::default();
        let mut group = criterion.benchmark_group(*name);
        group.bench_function("trace of 720 angles", |b| {
            b.iter(|| over_angle.trace_into(black_box(&mut trace)))
        });
        group.bench_function("trace of 720 angles, portable", |b| {
            b.iter(|| over_angle.trace_into_portable(black_box(&mut trace)));
        });
        let plan = mechanism.order_plan();
        let mut orders = Vec::new();
        group.bench_function("orders to 8", |b| b.iter(|| plan.orders_into(black_box(&mut orders))));
        group.bench_function("orders to 8, portable", |b| {
            b.iter(|| plan.orders_into_portable(black_box(&mut orders)));
        });
        group.bench_function("prepare", |b| b.iter(|| Mechanism::new(black_box(engine), &request)));
        group.bench_function("all loads", |b| b.iter(|| loads(black_box(engine), &request)));
        group.finish();
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(30).measurement_time(std::time::Duration::from_secs(2));
    targets = bench
}
criterion_main!(benches);
