//! Orbits: steady load, rotating load, contact floor, inertia.

use lanchester_film::{
    Cavitation, FilmOrbit, FilmTable, JournalBearing, JournalCycle, OrbitOutcome, OrbitRequest,
    contact_force, journal_orbit, orbit_least_film,
};
use std::f64::consts::{PI, TAU};

const SPEED: f64 = 400.0;

fn cycle(load: impl Fn(f64) -> [f64; 2], entrainment: f64) -> JournalCycle {
    let n = 180;
    JournalCycle {
        duration: TAU / SPEED,
        load: (0..n).map(|i| load(TAU * f64::from(i) / f64::from(n))).collect(),
        entrainment: vec![entrainment; n as usize],
        sliding: vec![SPEED; n as usize],
    }
}

fn orbit(table: &FilmTable, cycle: &JournalCycle, roughness: f64, mass: Option<f64>) -> FilmOrbit {
    let bearing = JournalBearing::new(0.025, 0.025, 2.5e-5).expect("plausible");
    let request = OrbitRequest { bearing, table, viscosity: 0.01, cycle, roughness, mass };
    journal_orbit(&request).expect("an orbit")
}

/// Load of the eccentricity 0.6 by the given Sommerfeld number of Guembel's film, L/D 0.5.
fn load() -> f64 {
    0.01 * SPEED / TAU * 1e6 / 0.3431 * 0.05 * 0.025
}

#[test]
fn steady_load_settles_at_the_steady_eccentricity_with_and_without_mass() {
    let table = FilmTable::new(0.5, Cavitation::Gumbel).expect("a table");
    let steady = cycle(|_| [load(), 0.0], 0.5 * SPEED);
    for mass in [None, Some(1.0)] {
        let found = orbit(&table, &steady, 0.0, mass);
        assert_eq!(found.outcome, OrbitOutcome::Periodic, "{mass:?} {}", found.change);
        let ratio = 1.0 - found.least_film / 2.5e-5;
        assert!((ratio - 0.6).abs() < 3e-3, "{mass:?}: {ratio}");
        // Attitude of the same film, by finite elements of SciPy 51.6 deg.
        assert!(
            (found.least_film_angle.to_degrees() - 51.6).abs() < 0.5,
            "{}",
            found.least_film_angle.to_degrees()
        );
        assert!(found.table_error < 5e-3 && found.friction_power > 0.0 && found.side_flow > 0.0);
    }
}

#[test]
fn load_that_turns_at_half_speed_is_carried_by_no_wedge() {
    // Turning with the mean of the surfaces the load sees no entrainment: the journal sinks until contact carries.
    let table = FilmTable::new(0.5, Cavitation::Gumbel).expect("a table");
    let turning = cycle(|a| [load() * a.cos(), load() * a.sin()], SPEED);
    let found = orbit(&table, &turning, 1e-6, None);
    assert!(
        found.least_film < 4e-6 && found.contact_time > 0.99 && found.contact_share > 0.9,
        "{} {}",
        found.least_film,
        found.contact_share
    );
    assert!(
        (contact_force(
            &JournalBearing::new(0.025, 0.025, 2.5e-5).expect("plausible"),
            1e-6,
            1.0 - found.least_film / 2.5e-5
        ) / load()
            - 1.0)
            .abs()
            < 0.1
    );
}

#[test]
fn prop_light_mass_follows_the_quasi_static_orbit() {
    let table = FilmTable::new(0.5, Cavitation::Gumbel).expect("a table");
    let shaken =
        cycle(|a| [load() * (1.0 + 0.8 * a.cos()), 0.6 * load() * (2.0 * a + 1.0).sin()], 0.5 * SPEED);
    let (still, moved) = (orbit(&table, &shaken, 0.0, None), orbit(&table, &shaken, 0.0, Some(1e-3)));
    for (a, b) in still.eccentricity.iter().zip(&moved.eccentricity) {
        assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 4e-3 * 2.5e-5, "{a:?} {b:?}");
    }
    assert!((still.least_film / moved.least_film - 1.0).abs() < 0.01);
    // The frame does not matter: the load turned by a quarter turns the orbit.
    let turned =
        cycle(|a| [-0.6 * load() * (2.0 * a + 1.0).sin(), load() * (1.0 + 0.8 * a.cos())], 0.5 * SPEED);
    let other = orbit(&table, &turned, 0.0, None);
    assert!((other.least_film / still.least_film - 1.0).abs() < 1e-3);
    let difference = (other.least_film_angle - still.least_film_angle).rem_euclid(TAU) - 0.5 * PI;
    assert!(difference.abs() < 1e-2, "{difference}");
}

#[test]
fn bad_cycles_name_what_is_needed() {
    let table = FilmTable::new(0.5, Cavitation::Gumbel).expect("a table");
    let bearing = JournalBearing::new(0.025, 0.025, 2.5e-5).expect("plausible");
    let run = |cycle: &JournalCycle| {
        let request =
            OrbitRequest { bearing, table: &table, viscosity: 0.01, cycle, roughness: 0.0, mass: None };
        journal_orbit(&request).expect_err("bad").to_string()
    };
    assert!(run(&cycle(|_| [1.0, 0.0], 0.0)).contains("a film needs a speed above 0"));
    assert!(run(&cycle(|_| [f64::NAN, 0.0], 1.0)).contains("finite"));
    let mut short = cycle(|_| [1.0, 0.0], 1.0);
    short.entrainment.truncate(3);
    assert!(run(&short).contains("180 equally spaced samples, got 3"));
    assert!(
        FilmTable::new(0.5, Cavitation::MassConserving).is_err()
            && FilmTable::new(500.0, Cavitation::Full).is_err()
    );
}

#[test]
fn the_least_film_alone_is_that_of_the_whole_orbit() {
    let table = FilmTable::new(0.5, Cavitation::Gumbel).expect("a table");
    let turning = cycle(|a| [load() * (0.4 + a.cos()), 0.7 * load() * (2.0 * a).sin()], 0.5 * SPEED);
    for (roughness, mass) in [(0.0, None), (0.5e-6, None), (0.0, Some(1.0))] {
        let whole = orbit(&table, &turning, roughness, mass);
        let bearing = JournalBearing::new(0.025, 0.025, 2.5e-5).expect("plausible");
        let request =
            OrbitRequest { bearing, table: &table, viscosity: 0.01, cycle: &turning, roughness, mass };
        let alone = orbit_least_film(&request).expect("an orbit");
        assert_eq!(
            (alone.thickness, alone.at, alone.outcome),
            (whole.least_film, whole.least_film_at, whole.outcome)
        );
        assert!(alone.thickness > 0.0 && alone.thickness < 2.5e-5);
    }
}
