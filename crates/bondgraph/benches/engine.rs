//! How long the bond graph of an engine takes: causality and equations of a V8, and a run of the three-cylinder with its gas.
use criterion::{Criterion, criterion_group, criterion_main};
use lanchester_bondgraph::*;
use lanchester_file::{read, template};
use lanchester_model::Engine;
use std::hint::black_box;

/// A V8 of the gallery, its block in space with the numbers and mounts of the three-cylinder, scaled by its size.
fn v8(donor: &Engine) -> Engine {
    let text = template("v8-crossplane").expect("it is in the gallery").text;
    let engine = read(text).engine().expect("it is valid").with(|engine| {
        engine.block.clone_from(&donor.block);
        if let Some(block) = &mut engine.block {
            block.mass *= 3.0;
            block.inertia = block.inertia.map(|inertia| 3.0 * inertia);
        }
        engine.mounts.clone_from(&donor.mounts);
    });
    engine.unwrap_or_else(|faults| panic!("{faults:?}"))
}

fn bench(criterion: &mut Criterion) {
    let text = include_str!("../../../examples/three-cylinder.toml");
    let engine = read(text).engine().expect("it is valid");
    let mut group = criterion.benchmark_group("bond graph");
    let large = v8(&engine);
    let request = EngineRequest {
        block: EngineBlock::Space,
        mounts: true,
        gravity: 9.80665,
        crankshaft_inertia: vec![0.3],
        ..EngineRequest::free(209.0, 1.0)
    };
    group.bench_function("V8: graph, causality and equations", |b| {
        b.iter(|| {
            let description = engine_graph(black_box(&large), &request).expect("it has what it needs");
            equations(&Graph::new(&description).expect("units fit")).expect("no conflict")
        });
    });
    let request = EngineRequest {
        crankshaft_inertia: vec![3.009],
        gas_states: Some(GasStates::of(&engine).expect("a single zone")),
        load: EngineLoad { torque: LoadLaw::Quadratic { torque: 190.0, at: 209.0 }, reacts_on_block: false },
        duration: 2.0,
        ..request
    };
    let description = engine_graph(&engine, &request).expect("it has what it needs");
    let found = equations(&Graph::new(&description).expect("units fit")).expect("no conflict");
    let asked = SimulationRequest { tolerance: 1e-7, samples: 1, ..found.request() };
    let run = found.simulate(&asked);
    assert!(run.complete, "{}", run.ended);
    println!("three-cylinder, 2 s: {:?}, {} operations an evaluation", run.statistics, run.operations);
    group.bench_function("three-cylinder with gas, block and shaft, 2 s at 209 rad/s", |b| {
        b.iter(|| black_box(&found).simulate(&asked));
    });
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10).measurement_time(std::time::Duration::from_secs(5));
    targets = bench
}
criterion_main!(benches);
