//! How long the twin-cylinder thesis takes: five engines, two strokes, nine arrangements, each with its sizes, the
//! engine's loads on the 1-degree grid of the tables, and its true optima, on one thread.
use criterion::{Criterion, criterion_group, criterion_main};
use lanchester_balance::{Answer, optimise_with};
use lanchester_file::read;
use lanchester_literature::{ArrangementOptions, TwinArrangement, arranged, arrangement_task, crank_task};
use lanchester_mechanism::{LoadRequest, PeakMode, total_loads};
use lanchester_model::Engine;
use lanchester_results::LoadSet;
use std::hint::black_box;

const FILES: [&str; 5] = [
    include_str!("../../../validation/twin-cylinder-thesis/single.toml"),
    include_str!("../../../validation/twin-cylinder-thesis/in-line-in-phase.toml"),
    include_str!("../../../validation/twin-cylinder-thesis/in-line-out-of-phase.toml"),
    include_str!("../../../validation/twin-cylinder-thesis/boxer-in-phase.toml"),
    include_str!("../../../validation/twin-cylinder-thesis/boxer-out-of-phase.toml"),
];
/// What the shorter stroke of the thesis's Table 1 changes in the files of the longer one.
const SHORTER: [(&str, &str); 4] = [
    ("stroke = \"95.5 mm\"", "stroke = \"86.4 mm\""),
    ("length = \"144 mm\"", "length = \"136 mm\""),
    ("mass = \"0.7754 kg\"", "mass = \"0.7172 kg\""),
    ("mass = \"0.6287 kg\"", "mass = \"0.7131 kg\""),
];

fn engines() -> Vec<Engine> {
    let engine = |text: &str| read(text).engine().expect("the engine is valid");
    let longer = FILES.iter().map(|text| engine(text));
    let shorter = FILES.iter().map(|text| {
        engine(&SHORTER.iter().fold((*text).to_owned(), |text, (old, new)| {
            assert!(text.contains(old), "{old} is gone from the file");
            text.replace(old, new)
        }))
    });
    longer.chain(shorter).collect()
}

/// Every engine in every arrangement.
fn cases(engines: &[Engine]) -> impl Iterator<Item = (&Engine, TwinArrangement)> {
    engines.iter().flat_map(|engine| TwinArrangement::ALL.map(|arrangement| (engine, arrangement)))
}

fn fitted(engine: &Engine, arrangement: TwinArrangement, options: &ArrangementOptions) -> Engine {
    arranged(engine, arrangement, options).expect("the engine has one crankshaft")
}

fn on_the_grid(fitted: &Engine, options: &ArrangementOptions) -> LoadSet {
    let request = LoadRequest {
        kinematics: options.kinematics,
        peaks: PeakMode::Grid(360),
        samples: 360,
        ..LoadRequest::default()
    };
    total_loads(fitted, &request).expect("its loads can be computed")
}

/// The crank alone, then all devices; none where an arrangement has nothing to choose.
fn optima(
    engine: &Engine,
    fitted: &Engine,
    arrangement: TwinArrangement,
    options: &ArrangementOptions,
) -> Vec<Answer> {
    [crank_task, arrangement_task]
        .into_iter()
        .map(|task| task(engine, arrangement, options).expect("the engine has one crankshaft"))
        .filter(|task| !task.stages.is_empty())
        .map(|task| optimise_with(fitted, &task, options.kinematics).expect("the task is one of the engine"))
        .collect()
}

fn bench(criterion: &mut Criterion) {
    let engines = engines();
    let options = ArrangementOptions::of_thesis();
    let ready: Vec<Engine> = cases(&engines).map(|(e, a)| fitted(e, a, &options)).collect();
    assert_eq!(ready.len(), 90);
    criterion.bench_function("90 cases: sizes, with 20 sweeps", |b| {
        b.iter(|| cases(black_box(&engines)).map(|(e, a)| fitted(e, a, &options)).collect::<Vec<_>>());
    });
    criterion.bench_function("90 cases: loads on the grid", |b| {
        b.iter(|| black_box(&ready).iter().map(|e| on_the_grid(e, &options)).collect::<Vec<_>>());
    });
    criterion.bench_function("90 cases: true optima", |b| {
        b.iter(|| {
            let optima =
                cases(black_box(&engines)).zip(&ready).map(|((e, a), fitted)| optima(e, fitted, a, &options));
            optima.collect::<Vec<_>>()
        });
    });
    criterion.bench_function("90 cases: all", |b| {
        b.iter(|| {
            let all = cases(black_box(&engines)).map(|(engine, arrangement)| {
                let fitted = fitted(engine, arrangement, &options);
                let loads = on_the_grid(&fitted, &options);
                (loads, optima(engine, &fitted, arrangement, &options))
            });
            all.collect::<Vec<_>>()
        });
    });
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10).measurement_time(std::time::Duration::from_secs(5));
    targets = bench
}
criterion_main!(benches);
