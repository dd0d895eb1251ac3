//! How long an optimum takes, on one thread: the counterweights of a twin, and four balance shafts of a V6.
use criterion::{Criterion, criterion_group, criterion_main};
use lanchester_balance::optimise;
use lanchester_file::{read, template};
use lanchester_model::{Engine, Ratio};
use lanchester_task::{BalanceTask, FreeShaft, FreeWeight, Place, Seat, default_task};
use std::hint::black_box;

/// The engine without counterweights and shafts.
fn bare(name: &str) -> Engine {
    let mut engine = read(template(name).expect("it is in the gallery").text).engine().expect("it is valid");
    engine = engine
        .with(|engine| {
            engine.counterweights.clear();

            engine.shafts.clear();
        })
        .expect("an engine");
    engine
}

fn weight(name: String, seat: Seat, z: f64) -> FreeWeight {
    FreeWeight::new(name, seat, Place::At(z))
}

/// A weight at each end of the crankshaft, and two on each shaft of these ratios.
fn task(engine: &Engine, ratios: &[i32]) -> BalanceTask {
    let reach = engine.throws.iter().map(|t| t.z.abs()).fold(0.05, f64::max);
    let ends = [("front", -reach), ("rear", reach)];
    let mut task = BalanceTask::default();
    task.weights.extend(ends.map(|(end, z)| weight(format!("crank {end}"), Seat::Crankshaft(0), z)));
    for (index, ratio) in ratios.iter().enumerate() {
        let side = if index % 2 == 0 { 0.1 } else { -0.1 };
        task.shafts.push(FreeShaft {
            name: format!("shaft {ratio}"),
            ratio: Ratio::whole(*ratio).expect("it is not 0"),
            x: Place::At(0.0),
            y: Place::At(side),
            optional: false,
        });
        task.weights
            .extend(ends.map(|(end, z)| weight(format!("shaft {ratio} {end}"), Seat::Shaft(index), 0.8 * z)));
    }
    task
}

fn bench(criterion: &mut Criterion) {
    let twin = bare("twin-270");
    let crank = task(&twin, &[]);
    criterion.bench_function("counterweights of a twin", |b| b.iter(|| optimise(black_box(&twin), &crank)));
    // Force and couple leave all eight open: this is the time of the main-bearing loads.
    let four = read(template("in-line-4").expect("it is in the gallery").text).engine().expect("it is valid");
    let eight = default_task(&four);
    criterion.bench_function("eight counterweights of a four", |b| {
        b.iter(|| optimise(black_box(&four), &eight));
    });
    let six = bare("v6-60");
    let shafts = task(&six, &[1, -1, 2, -2]);
    criterion.bench_function("four shafts of a V6", |b| b.iter(|| optimise(black_box(&six), &shafts)));
    let mut limited = shafts;
    let free = optimise(&six, &limited).expect("the task has a meaning");
    for (weight, found) in limited.weights.iter_mut().zip(&free.weights) {
        weight.most = Some(0.7 * found.unbalance.norm()).filter(|most| *most > 0.0);
    }
    criterion.bench_function("four shafts of a V6, each weight at most 0.7 of its best", |b| {
        b.iter(|| optimise(black_box(&six), &limited));
    });
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20).measurement_time(std::time::Duration::from_secs(3));
    targets = bench
}
criterion_main!(benches);
