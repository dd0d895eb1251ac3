//! Time of films.
use criterion::{Criterion, criterion_group, criterion_main};
use lanchester_film::{Cavitation, FilmGrid, FilmProblem, FilmSolver, JournalBearing, JournalMotion};
use std::hint::black_box;

fn films(c: &mut Criterion) {
    let bearing = JournalBearing::new(0.025, 0.02, 2.5e-5).expect("plausible");
    for cavitation in Cavitation::ALL {
        let grid = FilmGrid::uniform(90, 10, true, 0.0).expect("a grid");
        let mut solver = FilmSolver::new(grid).expect("a solver");
        let mut problem = FilmProblem {
            bearing,
            viscosity: 0.01,
            motion: JournalMotion { eccentricity: [1.8e-5, 0.0], entrainment: 200.0, sliding: 400.0, ..JournalMotion::default() },
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
}

criterion_group!(benches, films);
criterion_main!(benches);
