//! How long the search over arrangements takes: a twin at four cylinder spacings against half a four, and a V6.
use criterion::{Criterion, criterion_group, criterion_main};
use lanchester_balance::{ArrangementRequest, Judged, MountPlaces, Target, arrangements};
use lanchester_file::{read, template};
use lanchester_model::Engine;
use std::hint::black_box;

const BOXER: &str = include_str!("../../../validation/twin-cylinder-thesis/boxer-in-phase.toml");
const FOUR: &str = include_str!("../../../validation/twin-cylinder-thesis/in-line-four.toml");

fn engine(text: &str) -> Engine {
    read(text).engine().expect("the engine is valid")
}

fn bench(criterion: &mut Criterion) {
    let boxer = engine(BOXER);
    let reference = Target::Reference { engine: Box::new(engine(FOUR)), share: 0.5 };
    let thesis = ArrangementRequest {
        criterion: Judged::MountForce,
        mounts: MountPlaces::Spacing(0.176),
        target: reference,
        spacings: vec![0.088, 0.060, 0.015, 0.0],
        ..ArrangementRequest::default()
    };
    criterion.bench_function("boxer twin, four spacings", |b| {
        b.iter(|| arrangements(black_box(&boxer), &thesis));
    });
    let six = engine(template("v6-60").expect("it is in the gallery").text);
    let mounts = ArrangementRequest {
        criterion: Judged::MountForce,
        mounts: MountPlaces::Spacing(0.4),
        ..ArrangementRequest::default()
    };
    criterion.bench_function("V6 at 60 deg", |b| b.iter(|| arrangements(black_box(&six), &mounts)));
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10).measurement_time(std::time::Duration::from_secs(3));
    targets = bench
}
criterion_main!(benches);
