//! How long a million samples of a V6 take on all cores: orders 1 and 2, and with true peaks over the continuous angle.
use criterion::{Criterion, criterion_group, criterion_main};
use lanchester_file::{read, template};
use lanchester_study::scatter::*;
use lanchester_task::{Distribution, Extent, Tolerance, Varied};
use std::hint::black_box;

fn tolerance(quantity: Varied, half_width: f64) -> Tolerance {
    let distribution = Distribution::Normal { sigmas: 3.0 };
    Tolerance { quantity, half_width, distribution, extent: Extent::PerPart }
}

fn bench(criterion: &mut Criterion) {
    let engine = read(template("v6-60").expect("it is in the gallery").text).engine().expect("it is valid");
    let request = |outputs: Vec<Output>| ScatterRequest {
        engine: engine.clone(),
        speed: None,
        tolerances: vec![
            tolerance(Varied::PistonMass, 0.002),
            tolerance(Varied::BigEndMass, 0.002),
            tolerance(Varied::SmallEndMass, 0.001),
            tolerance(Varied::RodLength, 0.00005),
            tolerance(Varied::CrankRadius, 0.00005),
            tolerance(Varied::ThrowAngle, 0.003),
            tolerance(Varied::ThrowUnbalance, 0.0002),
        ],
        outputs,
        limits: Vec::new(),
        percentiles: vec![0.5, 0.95, 0.99],
        samples: 1_000_000,
        seed: 1,
    };
    let mut orders: Vec<Output> = Vec::new();
    for order in [1, 2] {
        orders.extend([Output::Force { order }, Output::Couple { order }]);
    }
    let peaks = [&orders[..], &[Output::PeakForce, Output::PeakCouple]].concat();
    let mut group = criterion.benchmark_group("a million samples of a V6");
    for (name, outputs) in [("orders 1 and 2", orders), ("with true peaks", peaks)] {
        let request = request(outputs);
        group.bench_function(name, |b| b.iter(|| black_box(scatter(&request))));
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10).measurement_time(std::time::Duration::from_secs(5));
    targets = bench
}
criterion_main!(benches);
