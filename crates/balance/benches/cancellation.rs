//! How long exact cancellation takes: where the orders vanish, and where they cannot.
use criterion::{Criterion, criterion_group, criterion_main};
use lanchester_balance::{Outcome, optimise};
use lanchester_file::{read, template};
use lanchester_model::{Engine, Ratio};
use lanchester_task::{BalanceTask, FreeShaft, FreeWeight, Load, Place, Seat};
use std::hint::black_box;

fn engine(name: &str) -> Engine {
    let mut engine =
        read(template(name).expect("it is in the gallery").text).engine().expect("the engine is valid");
    engine = engine
        .with(|engine| {
            engine.counterweights.clear();

            engine.shafts.clear();
        })
        .expect("an engine");
    engine
}

/// A weight on every throw and shafts (ratio and y) with weights 150 mm either side of the middle.
fn task(engine: &Engine, shafts: &[(i32, f64)], cancel: &[(Load, f64)]) -> BalanceTask {
    let weight = |name: String, seat: Seat, z: f64| FreeWeight::new(name, seat, Place::At(z));
    let mut task = BalanceTask { cancel: cancel.to_vec(), ..BalanceTask::default() };
    for (k, throw) in engine.throws.iter().enumerate() {
        if engine.throws[..k].iter().all(|t| t.z != throw.z) {
            task.weights.push(weight(format!("throw {}", k + 1), Seat::Crankshaft(0), throw.z));
        }
    }
    for (k, &(ratio, y)) in shafts.iter().enumerate() {
        let name = format!("shaft {}", k + 1);
        let ratio = Ratio::whole(ratio).expect("not 0");
        for z in [-0.15, 0.15] {
            task.weights.push(weight(format!("{name} at {z}"), Seat::Shaft(k), z));
        }
        task.shafts.push(FreeShaft { name, ratio, x: Place::At(0.0), y: Place::At(y), optional: false });
    }
    task
}

fn bench(criterion: &mut Criterion) {
    let first = [(Load::Force, 1.0), (Load::Couple, 1.0)];
    let both = [(Load::Force, 1.0), (Load::Couple, 1.0), (Load::Force, 2.0), (Load::Couple, 2.0)];
    let four: [(i32, f64); 4] = [(-1, 0.1), (1, -0.1), (2, 0.15), (-2, -0.15)];
    let mut time = |name: &str, layout: &str, shafts: usize, cancel: &[(Load, f64)], vanishes: bool| {
        let engine = engine(layout);
        let task = task(&engine, &four[..shafts], cancel);
        let answer = optimise(&engine, &task).expect("the task suits the engine");
        assert_eq!(answer.outcome == Outcome::Optimal, vanishes, "{name}");
        criterion.bench_function(name, |b| b.iter(|| optimise(black_box(&engine), black_box(&task))));
    };
    time("in-line three, one shaft", "in-line-3", 1, &first, true);
    time("V6, four shafts, two orders", "v6-90", 4, &both, true);
    time("twin, crank weights alone", "twin-360", 0, &first, false);
    time("V6, one shaft, two orders", "v6-90", 1, &both, false);
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20).measurement_time(std::time::Duration::from_secs(2));
    targets = bench
}
criterion_main!(benches);
