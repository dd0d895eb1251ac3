//! Films that feel the tilt of their journals, and shells on housings that yield.

use super::{LENGTH, SPEED, body, cylinder, film, options, periodic, pusher, swinging, tilted, train};
use lanchester_film::{Cavitation, FilmGrid, FilmProblem, FilmSolver, JournalMotion};
use lanchester_flex::FlexError;
use lanchester_flex::train::{CycleInstant, CycleOptions, TrainCycles, TrainLaw, run_cycles};

fn largest(found: &TrainCycles, of: impl Fn(&CycleInstant) -> [f64; 2]) -> f64 {
    found.recorded[0].instants.iter().map(of).map(|[x, y]| x.hypot(y)).fold(0.0, f64::max)
}

fn off(a: &TrainCycles, b: &TrainCycles, of: impl Fn(&CycleInstant) -> [f64; 2]) -> f64 {
    let pairs = a.recorded[0].instants.iter().zip(&b.recorded[0].instants);
    pairs.map(|(a, b)| (of(a), of(b))).map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1])).fold(0.0, f64::max)
}

#[test]
fn a_tilted_film_of_an_upright_journal_is_that_of_the_table() {
    let rigid = body().0.rigid();
    let run =
        |law: TrainLaw| periodic(&train(rigid.clone(), law, pusher(swinging(2000.0, 0.5), TrainLaw::Rigid)));
    let (table, solved) = (run(film(20e-6)), run(tilted(20e-6)));
    let place = |own: &CycleInstant| own.main_places[0];
    // The table's films are up to 0.4 % off in force; the load in the middle tilts nothing.
    assert!(off(&table, &solved, place) < 2e-3 * 20e-6, "{}", off(&table, &solved, place));
    assert!(largest(&solved, |own| own.tilts[0][0]) < 1e-4 * 20e-6);
    assert!(largest(&table, |own| own.tilts[0][0]) == 0.0);
}

#[test]
fn xcheck_the_couple_of_a_bent_shafts_film_is_that_of_cells() {
    let (body, _) = body();
    let mut own = train(body.clone(), tilted(20e-6), pusher(vec![300.0], TrainLaw::Rigid));
    own.mains[1].law = TrainLaw::bushing(2e8, 5e3);
    let found = periodic(&own);
    let last = found.recorded[0].instants.last().unwrap();
    let TrainLaw::TiltedFilm { bearing, viscosity, .. } = tilted(20e-6) else { unreachable!() };
    let [tilt, tilt_rate] = last.tilts[0];
    assert!(tilt[0].hypot(tilt[1]) > 0.1 * 20e-6, "the journal tilts: {tilt:?}");
    // The shaft is round: all stands still but what it turns by.
    assert!(tilt_rate[0].hypot(tilt_rate[1]) < 1e-3 * SPEED * 20e-6, "{tilt_rate:?}");
    let problem = FilmProblem {
        bearing,
        viscosity,
        motion: JournalMotion {
            eccentricity: last.main_places[0],
            velocity: last.rates[0],
            entrainment: 0.5 * SPEED,
            sliding: 0.0,
        },
        tilt,
        cavitation: Cavitation::Gumbel,
        feeds: Vec::new(),
    };
    let mut solver = FilmSolver::new(FilmGrid::uniform(240, 48, false, 0.0).unwrap()).unwrap();
    let film = solver.solve(&problem).unwrap();
    let [x, y] = last.main_forces[0];
    let size = x.hypot(y);
    assert!((film.force[0] - x).hypot(film.force[1] - y) < 6e-3 * size, "{:?} {x} {y}", film.force);
    // Moments about the other main: half the load is the first main's, and what its couple takes over the distance of both. Along the slope of x acts the moment about y, along
    // that of y the negative one about x.
    let span = LENGTH - 0.08;
    let wanted = [span * (0.5 * 300.0 - x), -span * y];
    let couple = [-film.moment[1], film.moment[0]];
    let size = wanted[0].hypot(wanted[1]);
    assert!(
        (couple[0] - wanted[0]).hypot(couple[1] - wanted[1]) < 2e-2 * size && size > 0.05,
        "{couple:?} {wanted:?}"
    );
}

#[test]
fn tilted_films_keep_the_energy_and_their_bits() {
    let (body, _) = body();
    // As it is its journals bend so far that their ends touch: there the film goes on as that of the tilt that it can have.
    for (stiffness, touches) in [(15.0, false), (1.0, true)] {
        let own =
            train(body.stiffened(stiffness), tilted(20e-6), pusher(swinging(400.0, 0.6), TrainLaw::Rigid));
        let found = periodic(&own);
        let reach =
            |own: &CycleInstant| [0, 1].map(|k| own.main_places[0][k].abs() + own.tilts[0][0][k].abs());
        assert!(largest(&found, |own| own.tilts[0][0]) > 0.02 * 20e-6);
        assert_eq!(largest(&found, reach) > 20e-6, touches, "{}", largest(&found, reach));
    }
    let own = train(body.stiffened(15.0), tilted(20e-6), pusher(swinging(400.0, 0.6), TrainLaw::Rigid));
    let run = || run_cycles(&own, CycleOptions { most_cycles: 1, ..options() }).unwrap();
    assert_eq!(run(), run(), "the same bits");
}

#[test]
fn a_shell_gives_way_by_its_load_over_the_stiffness_of_its_housing() {
    let rigid = body().0.rigid();
    for law in [film(20e-6), tilted(20e-6)] {
        let run = |housing: Option<f64>| {
            let mut own = train(rigid.clone(), law.clone(), pusher(vec![2000.0], TrainLaw::Rigid));
            own.mains.iter_mut().for_each(|main| main.housing = housing);
            (periodic(&own), own)
        };
        let ((firm, _), (soft, own)) = (run(None), run(Some(2e8)));
        // The film under a given load is the same; journal and shell go along together.
        let place = |own: &CycleInstant| own.main_places[0];
        assert!(off(&firm, &soft, place) < 1e-4 * 20e-6, "{}", off(&firm, &soft, place));
        let last = soft.recorded[0].instants.last().unwrap();
        let (sin, cos) = last.own_angle.sin_cos();
        let [x, y] = own.body.displacement(0, &last.coordinates);
        let journal = [cos * x - sin * y, sin * x + cos * y];
        for axis in 0..2 {
            let shell = journal[axis] - last.main_places[0][axis];
            let wanted = -last.main_forces[0][axis] / 2e8;
            assert!((shell - wanted).abs() < 1e-4 * 5e-6, "{axis}: {shell} {wanted}");
        }
    }
}

#[test]
fn a_housing_of_any_stiffness_keeps_the_energy_and_a_stiff_one_is_rigid() {
    let (body, _) = body();
    let law = film(20e-6);
    let run = |housing: Option<f64>| {
        let mut own = train(body.clone(), law.clone(), cylinder(law.clone()));
        own.mains.iter_mut().for_each(|main| main.housing = housing);
        own.cylinders[0].housing = housing;
        periodic(&own)
    };
    let (rigid, stiff, soft) = (run(None), run(Some(1e13)), run(Some(3e7)));
    let load = |own: &CycleInstant| own.main_forces[0];
    let size = largest(&rigid, load);
    assert!(off(&rigid, &stiff, load) < 2e-3 * size, "{} of {size}", off(&rigid, &stiff, load));
    assert!(off(&rigid, &soft, load) > 1e-2 * size, "{} of {size}", off(&rigid, &soft, load));
}

#[test]
fn housings_that_no_shell_stands_on_are_refused() {
    let (body, _) = body();
    for (law, housing) in [(film(20e-6), -1.0), (TrainLaw::bushing(1e8, 1e3), 1e9)] {
        let mut own = train(body.clone(), law, cylinder(TrainLaw::Rigid));
        own.mains[0].housing = Some(housing);
        assert!(matches!(run_cycles(&own, options()), Err(FlexError::Number { .. })));
    }
}
