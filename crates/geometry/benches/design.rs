//! How long the best counterweight, its proof and a front take, on one thread: the ranges of the tool paper's table 3.
use criterion::{Criterion, criterion_group, criterion_main};
use lanchester_geometry::{
    DesignLimits, DesignSettings, DesignTask, Objective, Range, ShaftWeightAim, ShaftWeightTask, Shoulder,
    best_shaft_weight, design, front,
};
use std::hint::black_box;

/// All dimensions free, as in the tool paper, with a crankcase of 75 mm around it.
fn task() -> DesignTask {
    DesignTask {
        unbalance: 8.0e-3,
        least_balance: 1.0,
        most_balance: None,
        density: 8000.0,
        web_radius: Range::new(0.01, 0.02),
        rectangle_height: Range::new(0.02, 0.03),
        shoulder: Shoulder::Angle(Range::new(0.0, 1.46)),
        arc_radius: Range::new(0.05, 0.07),
        arc_angle: Range::new(0.79, 3.13),
        thickness: Range::new(0.005, 0.03),
        limits: DesignLimits { swept_radius: Some(0.075), ..DesignLimits::default() },
        settings: DesignSettings::default(),
    }
}

/// Half a second-order pair of a two-litre in-line four, with every dimension free.
fn shaft_weight(minimise: ShaftWeightAim) -> ShaftWeightTask {
    ShaftWeightTask {
        minimise,
        density: 7850.0,
        shaft_radius: 0.012,
        radius: Range::new(0.02, 0.036),
        chord: Range::new(-0.01, 0.01),
        length: Range::new(0.01, 0.06),
    }
}

fn bench(criterion: &mut Criterion) {
    let task = task();
    let objectives = [Objective::Mass, Objective::SweptRadius, Objective::Inertia, Objective::Thickness];
    for objective in objectives {
        criterion.bench_function(&format!("least {objective:?}"), |b| {
            b.iter(|| design(black_box(&task), objective))
        });
    }
    let web = DesignTask { web_radius: Range::fixed(0.015), ..task };
    for objective in objectives {
        let name = format!("least {objective:?}, web given");
        criterion.bench_function(&name, |b| b.iter(|| design(black_box(&web), objective)));
    }
    for minimise in
        [ShaftWeightAim::Mass, ShaftWeightAim::Length, ShaftWeightAim::Radius, ShaftWeightAim::Inertia]
    {
        let weight = shaft_weight(minimise);
        let name = format!("least {minimise:?} of a balance shaft's weight");
        criterion.bench_function(&name, |b| b.iter(|| best_shaft_weight(black_box(1.2e-3), &weight)));
    }
    let pair = [Objective::Mass, Objective::SweptRadius];
    let mut slow = criterion.benchmark_group("front");
    slow.sample_size(10);
    slow.bench_function("mass against swept radius, 100 designs", |b| {
        b.iter(|| front(black_box(&task), pair, 100))
    });
}

criterion_group!(benches, bench);
criterion_main!(benches);
