//! Modes of eight masses; forced vibration of eight masses at 201 speeds in 24 orders.
#![allow(missing_docs)]

use criterion::{Criterion, criterion_group, criterion_main};
use lanchester_torsion::{
    Chain, Excitation, Shaft, ShaftKind, Source, Station, StationKind, TorqueAt, modes, sweep,
};
use num_complex::Complex64;
use std::hint::black_box;

/// Damper ring, hub, six throws less one, flywheel: eight masses of a car engine.
fn chain() -> Chain {
    let kinds = [(StationKind::Ring, 0.0045), (StationKind::Nose, 0.0025)]
        .into_iter()
        .chain((0..5).map(|throw| (StationKind::Throw(throw), 0.008)))
        .chain([(StationKind::Flywheel, 0.15)]);
    let stations: Vec<Station> =
        kinds.map(|(kind, inertia)| Station::new("station", kind, inertia)).collect();
    let shafts = (0..7)
        .map(|i| Shaft {
            loss_factor: 0.01,
            kind: if i == 0 { ShaftKind::Damper } else { ShaftKind::Shaft },
            damping: if i == 0 { 6.0 } else { 0.0 },
            ..Shaft::new("shaft", i, i + 1, if i == 0 { 0.0 } else { 0.5e6 })
        })
        .collect();
    Chain::new(stations, shafts).expect("a chain")
}

fn excitation() -> Excitation {
    let source = |throw: usize| {
        let order = |k: usize| Complex64::from_polar(300.0 / (k + 1) as f64, (k * throw) as f64 * 2.1);
        let orders: Vec<Complex64> = (0..24).map(order).collect();
        let inertia = orders.iter().map(|t| t * 1e-6).collect();
        Source { station: throw + 2, gas: vec![TorqueAt { speed: 100.0, mean: 40.0, orders }], inertia }
    };
    Excitation { step: 0.5, count: 24, sources: (0..5).map(source).collect() }
}

fn benches(c: &mut Criterion) {
    let (chain, excitation) = (chain(), excitation());
    c.bench_function("modes of 8 masses", |b| b.iter(|| modes(black_box(&chain), 0.0)));
    let speeds: Vec<f64> = (0..201).map(|i| 80.0 + 2.8 * f64::from(i)).collect();
    c.bench_function("8 masses, 201 speeds, 24 orders", |b| {
        b.iter(|| sweep(black_box(&chain), &excitation, &speeds))
    });
}

criterion_group!(all, benches);
criterion_main!(all);
