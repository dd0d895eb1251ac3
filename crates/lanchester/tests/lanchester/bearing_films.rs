//! Oil films of all bearings of an engine.

use lanchester::film::{BearingFilm, BearingKind, Cavitation, OrbitOutcome};
use lanchester::mechanism::{BearingLoads, BearingRequest};
use lanchester::model::Engine;
use lanchester::{BearingFilms, FilmMethod, bearing_films, bearing_report, film_faults};

const FOUR: &str = include_str!("../../../../examples/in-line-4-crank-by-elements.toml");

fn engine(text: &str) -> Engine {
    lanchester::file::read(text).engine().expect("it has no mistakes")
}

fn loads(engine: &Engine) -> BearingLoads {
    let request = BearingRequest { speed: Some(314.0), ..BearingRequest::default() };
    bearing_report(engine, &[], &request).expect("loads")
}

fn films(text: &str) -> BearingFilms {
    let engine = engine(text);
    bearing_films(&engine, &loads(&engine), &[Cavitation::Gumbel], FilmMethod::Tables).expect("films")
}

fn of(films: &BearingFilms, kind: BearingKind) -> Vec<&BearingFilm> {
    films.films.iter().filter(|film| film.kind == kind).collect()
}

#[test]
fn every_main_and_big_end_has_a_film_and_equal_cylinders_have_equal_ones() {
    let found = films(FOUR);
    let (mains, big_ends) = (of(&found, BearingKind::Main), of(&found, BearingKind::Crankpin));
    assert_eq!((mains.len(), big_ends.len()), (5, 4));
    for film in &found.films {
        assert_eq!(film.orbit.outcome, OrbitOutcome::Periodic, "{:?} {}", film.kind, film.number);
        assert!(film.orbit.least_film > 0.0 && film.orbit.largest_pressure > film.projected_pressure[0]);
        assert!(
            film.orbit.friction_power > 0.0
                && film.orbit.side_flow > 0.0
                && film.temperature_rise.is_some_and(|rise| rise > 0.0)
        );
        // The bar of the tables holds along real orbits.
        assert!(film.orbit.table_error < 5e-3, "{:?} {}: {}", film.kind, film.number, film.orbit.table_error);
    }
    assert!(
        (mains[2].bearing.length - 0.022).abs() < 1e-12 && (mains[0].bearing.length - 0.020).abs() < 1e-12
    );
    for film in &big_ends {
        assert!((film.orbit.least_film / big_ends[0].orbit.least_film - 1.0).abs() < 5e-3);
        assert!((film.bearing.clearance - 25e-6).abs() < 1e-12);
    }
}

#[test]
fn big_ends_least_film_counts_from_the_rods_line() {
    let found = films(FOUR);
    let engine = engine(FOUR);
    let (radius, length) = (engine.throws[0].radius, engine.cylinders[0].rod.length);
    let first = of(&found, BearingKind::Crankpin)[0];
    let sin = radius * first.least_film_angle.sin();
    // Cylinder 1 stands along x, so the rod leans by -asin(r sin theta / l).
    let rod = (-sin / length).asin();
    let difference = first.orbit.least_film_angle - first.least_film_in_shell - rod;
    assert!(difference.sin().abs() < 1e-9 && difference.cos() > 0.0, "{difference}");
    let main = of(&found, BearingKind::Main)[0];
    assert!((main.orbit.least_film_angle - main.least_film_in_shell).sin().abs() < 1e-12);
}

#[test]
fn thicker_oil_makes_thicker_films_and_a_grade_finds_its_temperature() {
    let thin = films(FOUR);
    let thick = films(&FOUR.replace("viscosity = \"10 mPa s\"", "viscosity = \"20 mPa s\""));
    for (a, b) in thin.films.iter().zip(&thick.films) {
        assert!(b.orbit.least_film > a.orbit.least_film && b.orbit.friction_power > a.orbit.friction_power);
    }
    let grade =
        films(&FOUR.replace("viscosity = \"10 mPa s\"", "oil = \"SAE 5W-30\"\ntemperature = \"90 degC\""));
    for film in &grade.films {
        let temperature = film.temperature.expect("it is known");
        let rise = film.temperature_rise.expect("its flow takes the heat");
        assert!(film.heat_balanced && (temperature - 363.15 - rise).abs() < 0.1, "{temperature}");
    }
    assert!(grade.assumptions.iter().any(|said| said.contains("5W-30") && said.contains("90 degC")));
}

#[test]
fn bad_input_names_bearing_and_remedy() {
    let refused = |text: &str| {
        let engine = engine(text);
        bearing_films(&engine, &loads(&engine), &[], FilmMethod::Tables).expect_err("bad").to_string()
    };
    let olive =
        refused(&FOUR.replace("viscosity = \"10 mPa s\"", "oil = \"olive\"\ntemperature = \"90 degC\""));
    assert!(olive.contains("olive") && olive.contains("5W-30"), "{olive}");
    let loose =
        refused(&FOUR.replace("diametral_clearance = \"0.06 mm\"", "diametral_clearance = \"1.5 mm\""));
    assert!(
        loose.contains("main bearing 1")
            && loose.contains("1500.0 um")
            && loose.contains("difference of the diameters"),
        "{loose}"
    );
    let bare = refused(include_str!("../../../../examples/in-line-4.toml"));
    assert!(bare.contains("[bearings.main]"), "{bare}");
}

/// The grooves of the file, with what feeds them: the upper half of the mains' shells has one, which takes oil and pressure where the load does not press.
#[test]
fn grooves_and_the_oil_that_is_kept() {
    let engine = engine(FOUR);
    let request = BearingRequest { speed: Some(314.0), samples: 90, ..BearingRequest::default() };
    let loads = bearing_report(&engine, &[], &request).expect("loads");
    let models = [Cavitation::Reynolds, Cavitation::MassConserving];
    let plain = bearing_films(&engine, &loads, &models, FilmMethod::Tables).expect("films");
    assert_eq!(plain.films.len(), 9, "both are Reynolds' condition");
    let solved = bearing_films(&engine, &loads, &models, FilmMethod::Grooved).expect("films");
    // The crankpins have no groove.
    assert_eq!((of(&solved, BearingKind::Main).len(), of(&solved, BearingKind::Crankpin).len()), (10, 4));
    assert!(
        solved.assumptions.iter().any(|words| words.contains("fed with 4.0000 bar")),
        "{:?}",
        solved.assumptions
    );
    let mains = of(&solved, BearingKind::Main);
    for pair in mains.chunks(2) {
        let [reynolds, kept] = pair else { panic!("two models") };
        assert_eq!(
            (reynolds.cavitation, kept.cavitation),
            (Cavitation::Reynolds, Cavitation::MassConserving)
        );
        for film in pair {
            assert_eq!(film.orbit.outcome, OrbitOutcome::Periodic, "{} {}", film.number, film.orbit.change);
            assert!(film.orbit.feed_flow > 0.0, "{:?}", film.orbit);
        }
        let without = of(&plain, BearingKind::Main)[reynolds.number - 1];
        assert!(reynolds.orbit.least_film < without.orbit.least_film, "{}", reynolds.number);
        assert!(reynolds.orbit.side_flow > without.orbit.side_flow, "{}", reynolds.number);
        let balance = kept.orbit.side_flow / kept.orbit.feed_flow;
        assert!((balance - 1.0).abs() < 0.01, "{}: {balance}", kept.number);
    }
}

/// `check` tells all that no film can have, at once.
#[test]
fn implausible_clearances_and_oils_are_told_together() {
    assert_eq!(film_faults(&engine(FOUR)), Vec::<String>::new());
    let wrong = FOUR
        .replacen("diametral_clearance = \"0.06 mm\"", "diametral_clearance = \"26 mm\"", 1)
        .replace("viscosity = \"10 mPa s\"", "oil = \"SAE 99\"\ntemperature = \"100 degC\"");
    let faults = film_faults(&engine(&wrong));
    assert!(faults.iter().any(|words| words.contains("\"SAE 99\"")), "{faults:?}");
    assert!(
        faults.iter().any(|words| words.contains("main bearings: the diametral clearance")),
        "{faults:?}"
    );
}

/// A rigid crankshaft that floats in its films: what its bearings carry adds up to the load, less what its mass takes.
#[test]
fn a_rigid_crankshaft_shares_its_loads_among_its_films() {
    let engine = engine(FOUR);
    let request = BearingRequest { speed: Some(680.0), samples: 180, ..BearingRequest::default() };
    let loads = bearing_report(&engine, &[], &request).expect("loads");
    let models = [Cavitation::Gumbel];
    let alone = bearing_films(&engine, &loads, &models, FilmMethod::Tables).expect("films");
    let shared = bearing_films(&engine, &loads, &models, FilmMethod::RigidShaft).expect("films");
    assert_eq!(
        of(&alone, BearingKind::Crankpin),
        of(&shared, BearingKind::Crankpin),
        "they are as they were"
    );
    let mains = of(&shared, BearingKind::Main);
    assert_eq!(mains.iter().map(|film| film.number).collect::<Vec<_>>(), [1, 2, 3, 4, 5]);
    for film in &mains {
        assert_eq!(film.orbit.outcome, OrbitOutcome::Periodic, "{}", film.number);
        let edge = film.orbit.least_edge_film.expect("it tilts");
        assert!(edge > 0.0 && edge < film.orbit.least_film, "{} {edge}", film.number);
    }
    // At high speed the middle main carries the most where the shaft is cut at each bearing: a stiff beam on five films leaves the least to it.
    let largest = |films: &BearingFilms, number: usize| of(films, BearingKind::Main)[number - 1].largest_load;
    assert!(largest(&shared, 3) < 0.5 * largest(&alone, 3), "{} {}", largest(&shared, 3), largest(&alone, 3));
    assert!(largest(&shared, 1) > largest(&shared, 3));
    let [run] = shared.shafts[..] else { panic!("one crankshaft, one model: {:?}", shared.shafts) };
    let energy = run.energy.expect("it repeats");
    assert_eq!(
        (run.crankshaft, run.cavitation, run.outcome),
        (1, Cavitation::Gumbel, OrbitOutcome::Periodic)
    );
    assert!(run.is_balanced() && run.energy_error == Some(energy.error()) && energy.films > 0.0, "{run:?}");
    assert!(alone.shafts.is_empty(), "without mass there is no energy to balance");
    assert!(shared.assumptions.iter().any(|words| words.contains("floats in the films")));
}

#[test]
fn a_crankshaft_without_a_body_cannot_float() {
    let text = include_str!("../../../../examples/in-line-4.toml");
    let text = format!(
        "{text}\n[bearings.main]\ndiameter = \"50 mm\"\nwidth = \"20 mm\"\n[bearings.crankpin]\ndiameter = \"45 mm\"\nwidth = \"20 mm\"\n"
    );
    let engine = engine(&text);
    let refused = bearing_films(&engine, &loads(&engine), &[], FilmMethod::RigidShaft).expect_err("no body");
    assert!(refused.to_string().contains("[crank.body]"), "{refused}");
}
