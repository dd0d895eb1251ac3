//! How many layouts a second the search evaluates, on one core: all first- and second-order components, and all objectives.
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use lanchester_model::Strokes;
use lanchester_study::explore::*;
use std::hint::black_box;

fn parts() -> Parts {
    Parts {
        strokes: Strokes::Four,
        speed: 400.0,
        crank_radius: 0.045,
        piston_mass: 0.5,
        rod_big_end_mass: 0.4,
        rod_small_end_mass: 0.2,
        rod_inertia: Some(0.002),
        throw_unbalance: 0.01,
        web_distance: 0.045,
        web_thickness: 0.02,
        pin_diameter: 0.05,
        bore: 0.085,
        end_length: 0.2,
    }
}

fn space(cylinders: usize, steps: u32, banks: Banks) -> Space {
    Space {
        parts: parts(),
        cylinders,
        banks,
        throw_angles: even_angles(steps),
        spacings: vec![0.1],
        rod_ratios: vec![0.3],
        counterweights: vec![CounterweightPattern {
            name: "full".into(),
            rotating: 1.0,
            reciprocating: 0.0,
            webs: None,
        }],
        shafts: vec![ShaftSet::default()],
        firing: false,
    }
}

fn v(angle: f64) -> Banks {
    Banks::Two { bank_angles: vec![angle.to_radians()], split_angles: vec![0.0], staggers: vec![0.02] }
}

fn bench(criterion: &mut Criterion) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("one thread");
    let loads = vec![
        Objective::Force { order: 1 },
        Objective::Couple { order: 1 },
        Objective::Force { order: 2 },
        Objective::Couple { order: 2 },
    ];
    let mut more = loads.clone();
    more.push(Objective::BendingMoment);
    let searches = [
        ("in-line six", space(6, 24, Banks::InLine), loads.clone()),
        ("V8, 4 groups", space(8, 72, v(90.0)), loads.clone()),
        ("V12, 6 groups", space(12, 24, v(60.0)), loads),
        ("V8 with bending moment", space(8, 72, v(90.0)), more),
    ];
    let mut group = criterion.benchmark_group("layouts, one core");
    for (name, space, objectives) in searches {
        let explorer = Explorer::new(ExploreRequest::new(space, objectives, Vec::new())).expect("a space");
        let cases = 300_000.min(explorer.size());
        // From the middle: not only duplicates or firsts of their kind.
        let from = (explorer.size() - cases) / 2;
        group.throughput(Throughput::Elements(cases as u64));
        group.bench_function(name, |b| {
            b.iter(|| {
                let mut exploration = explorer.start();
                pool.install(|| explorer.run(&mut exploration, Run { from, to: from + cases }))
                    .expect("it runs");
                black_box(exploration)
            });
        });
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10).measurement_time(std::time::Duration::from_secs(2));
    targets = bench
}
criterion_main!(benches);
