//! How long the bearing loads of a V8 take over 720 angles, with its gas and without, and its torque with all that belongs to it.
use criterion::{Criterion, criterion_group, criterion_main};
use lanchester_file::{read, template};
use lanchester_mechanism::*;
use lanchester_model::Engine;
use lanchester_results::PeriodicCurve;
use std::f64::consts::TAU;
use std::hint::black_box;

/// A V8 of the gallery with a bore, and a pressure every degree.
fn v8() -> (Engine, Vec<CylinderGas>) {
    let text = template("v8-crossplane").expect("it is in the gallery").text;
    let mut engine = read(text).engine().expect("it is valid");
    engine = engine
        .with(|engine| {
            for cylinder in &mut engine.cylinders {
                cylinder.bore = Some(0.09);
            }
        })
        .expect("an engine");
    let knots: Vec<f64> = (0..720).map(|j| 2.0 * TAU * f64::from(j) / 720.0).collect();
    let values: Vec<f64> = knots.iter().map(|t| 1e5 + 6e6 * (-2.0 * (t - 0.3).powi(2)).exp()).collect();
    let gas = CylinderGas {
        cylinder: PeriodicCurve::through(2.0 * TAU, knots, &values).expect("knots rise"),
        crankcase: PeriodicCurve::constant(2.0 * TAU, 1e5).expect("it is finite"),
    };
    let gas = vec![gas; engine.cylinders.len()];
    (engine, gas)
}

fn bench(criterion: &mut Criterion) {
    let (engine, gas) = v8();
    let request = BearingRequest { samples: 360, ..BearingRequest::default() };
    let mut plan = BearingPlan::new(&engine, Some(&gas), &request).expect("the engine is valid");
    assert_eq!(plan.angles(), 720);
    let train = GasTrain::new(&engine, &gas, Lever::Exact).expect("the engine is valid");
    let mut trace = BearingTrace::default();
    let mut group = criterion.benchmark_group("V8 bearings");
    group.bench_function("loads over 720 angles", |b| b.iter(|| plan.loads_into(black_box(&mut trace))));
    group.bench_function("gas and loads over 720 angles", |b| {
        b.iter(|| {
            plan.set_gas(black_box(&train));
            plan.loads_into(black_box(&mut trace));
        });
    });
    group.bench_function("all results with their peaks", |b| {
        b.iter(|| bearing_loads(black_box(&engine), Some(&gas), &request));
    });
    group.bench_function("torque, work, orders and energy", |b| {
        b.iter(|| torque(black_box(&engine), &gas, &TorqueRequest::default()));
    });
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20).measurement_time(std::time::Duration::from_secs(2));
    targets = bench
}
criterion_main!(benches);
