//! How long a million samples of a V6 and a hundred thousand of a radial nine take on all cores: orders 1 and 2, and with true peaks over
//! the continuous angle.
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
    let engine =
        |name: &str| read(template(name).expect("it is in the gallery").text).engine().expect("it is valid");
    let request = |name: &str, samples: u64, outputs: &[Output]| ScatterRequest {
        engine: engine(name),
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
        outputs: outputs.to_vec(),
        limits: Vec::new(),
        percentiles: vec![0.5, 0.95, 0.99],
        samples,
        seed: 1,
    };
    let mut orders: Vec<Output> = Vec::new();
    for order in [1, 2] {
        orders.extend([Output::Force { order }, Output::Couple { order }]);
    }
    let peaks = [&orders[..], &[Output::PeakForce, Output::PeakCouple]].concat();
    for (title, name, samples) in [
        ("a million samples of a V6", "v6-60", 1_000_000),
        ("100 000 samples of a radial nine", "radial-9", 100_000),
    ] {
        let mut group = criterion.benchmark_group(title);
        for (what, outputs) in [("orders 1 and 2", &orders), ("with true peaks", &peaks)] {
            let request = request(name, samples, outputs);
            group.bench_function(what, |b| b.iter(|| black_box(scatter(&request))));
        }
        group.finish();
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10).measurement_time(std::time::Duration::from_secs(5));
    targets = bench
}
criterion_main!(benches);
