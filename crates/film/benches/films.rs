//! Time of films.
use criterion::{Criterion, criterion_group, criterion_main};
use lanchester_film::{
    Cavitation, DirectOrbit, DirectRequest, Feed, FilmGrid, FilmProblem, FilmSolver, FilmTable,
    FloatingShaft, JournalBearing, JournalCycle, JournalMotion, OrbitRequest, ShaftJournal, ShaftRequest,
    TiltedMotion, journal_orbit, tilted_impedance,
};
use std::hint::black_box;

fn films(c: &mut Criterion) {
    let bearing = JournalBearing::new(0.025, 0.02, 2.5e-5).expect("plausible");
    for cavitation in Cavitation::ALL {
        let grid = FilmGrid::uniform(90, 10, true, 0.0).expect("a grid");
        let mut solver = FilmSolver::new(grid).expect("a solver");
        let mut problem = FilmProblem {
            bearing,
            viscosity: 0.01,
            motion: JournalMotion {
                eccentricity: [1.8e-5, 0.0],
                entrainment: 200.0,
                sliding: 400.0,
                ..JournalMotion::default()
            },
            tilt: [0.0, 0.0],
            cavitation,
            feeds: Vec::new(),
        };
        let mut angle = 0.0f64;
        c.bench_function(&format!("film 90 x 10 {}", cavitation.name()), |b| {
            b.iter(|| {
                // The journal moves by a fraction of a cell from call to call.
                angle += 0.01;
                problem.motion.eccentricity = [1.8e-5 * angle.cos(), 1.8e-5 * angle.sin()];
                black_box(solver.solve(&problem))
            })
        });
    }
    let table = FilmTable::new(0.4, Cavitation::Gumbel).expect("a table");
    let mut angle = 0.0f64;
    c.bench_function("table with derivatives", |b| {
        b.iter(|| {
            angle += 0.01;
            black_box(table.impedance([0.8 * angle.cos(), 0.8 * angle.sin()], [0.01, 0.02]))
        })
    });
    c.bench_function("film of a tilted journal with derivatives", |b| {
        b.iter(|| {
            angle += 0.01;
            let motion = TiltedMotion {
                eccentricity: [0.6 * angle.cos(), 0.6 * angle.sin()],
                tilt: [0.2, 0.1],
                closing: [0.01, 0.02],
                closing_by_tilt: [0.0, 0.01],
            };
            black_box(tilted_impedance(0.4, &motion))
        })
    });
    c.bench_function("mobility by table", |b| {
        b.iter(|| {
            angle += 0.01;
            black_box(table.velocity([0.8 * angle.cos(), 0.8 * angle.sin()], [1.0, 0.5]))
        })
    });
    // A main of a rigid crank with its share of the mass: 720 deg at 4000 rpm, with a firing and inertia.
    let (n, speed) = (720, 4000.0 * std::f64::consts::PI / 30.0);
    let load = |i: usize| {
        let a = 4.0 * std::f64::consts::PI * i as f64 / n as f64;
        [-8000.0 * (-8.0 * (1.0 - (0.5 * a).cos())).exp() + 2000.0 * a.cos(), 1500.0 * a.sin()]
    };
    let cycle = JournalCycle {
        duration: 4.0 * std::f64::consts::PI / speed,
        load: (0..n).map(load).collect(),
        entrainment: vec![0.5 * speed; n],
        sliding: vec![speed; n],
    };
    for mass in [None, Some(5.0)] {
        let request =
            OrbitRequest { bearing, table: &table, viscosity: 0.01, cycle: &cycle, roughness: 0.0, mass };
        let found = journal_orbit(&request).expect("an orbit");
        println!(
            "{mass:?}: {:?}, {} periods, {} steps, least film {:.2} um",
            found.outcome,
            found.periods,
            found.steps,
            found.least_film * 1e6
        );
        c.bench_function(&format!("orbit to repetition, mass {mass:?}"), |b| {
            b.iter(|| black_box(journal_orbit(&request)))
        });
    }
    // The whole crank, which may tilt, in both of its mains.
    let main = |z: f64| ShaftJournal { z, bearing, table: &table, cycle: &cycle };
    let request = ShaftRequest {
        journals: &[main(-0.05), main(0.06)],
        mass: 10.0,
        inertia: 0.05,
        polar: 0.02,
        speed,
        roughness: 0.0,
    };
    let run = || FloatingShaft::new(&request).and_then(|mut shaft| shaft.run(&[0.01, 0.01], false));
    let found = run().expect("orbits");
    println!(
        "two mains: {:?}, {} periods, {} steps",
        found.outcome, found.orbits[0].periods, found.orbits[0].steps
    );
    c.bench_function("rigid shaft in two films to repetition", |b| b.iter(|| black_box(run())));
    // A main of upper half groove under supply pressure, its film solved at every instant.
    let feeds =
        [Feed::Groove { from: 0.0, to: std::f64::consts::PI, middle: 0.0, width: 0.003, pressure: 4e5 }];
    let cavitation = Cavitation::Reynolds;
    let request =
        DirectRequest { bearing, cavitation, cycle: &cycle, shell: &[], feeds: &feeds, roughness: 0.0 };
    let run = || DirectOrbit::new(&request).and_then(|mut orbit| orbit.run(0.01));
    let found = run().expect("an orbit");
    println!("grooved: {:?}, {} periods, {} steps", found.outcome, found.periods, found.steps);
    let mut group = c.benchmark_group("direct");
    group.sample_size(10);
    group.bench_function("orbit of a grooved film to repetition", |b| b.iter(|| black_box(run())));
    group.finish();
}

criterion_group!(benches, films);
criterion_main!(benches);
