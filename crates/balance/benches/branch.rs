//! How long choices take: planes, a given amount, one of several devices, against the convex optimum without them.
use criterion::{Criterion, criterion_group, criterion_main};
use lanchester_balance::optimise;
use lanchester_file::{read, template};
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Criterion as Judged, FreeWeight, Load, Place, Seat, Stage};
use std::hint::black_box;

fn engine(name: &str) -> Engine {
    let text = template(name).expect("it is in the gallery").text;
    let mut engine = read(text).engine().expect("the template is valid");
    engine = engine
        .with(|engine| {
            engine.counterweights.clear();

            engine.shafts.clear();
        })
        .expect("an engine");
    engine
}

fn weight(name: &str, z: Place) -> FreeWeight {
    FreeWeight { most: Some(0.03), ..FreeWeight::new(name, Seat::Crankshaft(0), z) }
}

fn bench(criterion: &mut Criterion) {
    let engine = engine("twin-270");
    let terms = vec![(1.0, Judged::Peak(Load::Force)), (20.0, Judged::Peak(Load::Couple))];
    let task = |weights: Vec<FreeWeight>| BalanceTask {
        weights,
        stages: vec![Stage { terms: terms.clone() }],
        ..BalanceTask::default()
    };
    let given = FreeWeight { least: 0.01, most: Some(0.01), ..weight("given", Place::At(0.02)) };
    let choices = [
        ("convex: two given planes", task([-0.1, 0.1].map(|z| weight("at", Place::At(z))).to_vec())),
        ("one plane to be found", task(vec![weight("found", Place::Between(-0.1, 0.15))])),
        (
            "a plane to be found beside a given amount",
            task(vec![given, weight("found", Place::Between(-0.1, 0.15))]),
        ),
        (
            "two of five weights",
            BalanceTask {
                most_optional: Some(2),
                ..task(
                    [-0.1, -0.05, 0.0, 0.05, 0.1]
                        .map(|z| FreeWeight { optional: true, ..weight("at", Place::At(z)) })
                        .to_vec(),
                )
            },
        ),
    ];
    for (name, task) in choices {
        criterion.bench_function(name, |b| b.iter(|| optimise(black_box(&engine), &task)));
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10).measurement_time(std::time::Duration::from_secs(3));
    targets = bench
}
criterion_main!(benches);
