//! Orbits whose films are solved at every instant: against the table, with grooves, and with the oil kept.

use lanchester_film::{
    Cavitation, DirectOrbit, DirectRequest, Feed, FilmOrbit, FilmTable, JournalBearing, JournalCycle,
    OrbitOutcome, OrbitRequest, journal_orbit,
};
use std::f64::consts::TAU;

const SPEED: f64 = 400.0;
const INSTANTS: u32 = 360;

fn bearing() -> JournalBearing {
    JournalBearing::new(0.025, 0.025, 2.5e-5).expect("plausible")
}

/// A load that swings in size and direction, once and twice a turn.
fn shaken(sliding: f64) -> JournalCycle {
    let load = |a: f64| [3500.0 * (1.0 + 0.8 * a.cos()), 2500.0 * (2.0 * a + 1.0).sin()];
    let n = INSTANTS as usize;
    JournalCycle {
        duration: TAU / SPEED,
        load: (0..INSTANTS).map(|i| load(TAU * f64::from(i) / f64::from(INSTANTS))).collect(),
        entrainment: vec![0.5 * sliding; n],
        sliding: vec![sliding; n],
    }
}

fn direct(cavitation: Cavitation, cycle: &JournalCycle, feeds: &[Feed]) -> FilmOrbit {
    let request = DirectRequest { bearing: bearing(), cavitation, cycle, shell: &[], feeds, roughness: 0.0 };
    DirectOrbit::new(&request).expect("a film").run(0.01).expect("an orbit")
}

fn groove(from: f64, to: f64, pressure: f64) -> Feed {
    Feed::Groove { from, to, middle: 0.0, width: 0.006, pressure }
}

/// Without grooves the orbit is that of the table, to the error of the table and of the steps.
#[test]
fn without_grooves_it_is_the_orbit_of_the_table() {
    let cycle = shaken(SPEED);
    for cavitation in [Cavitation::Gumbel, Cavitation::Reynolds] {
        let table = FilmTable::new(0.5, cavitation).expect("a table");
        let request = OrbitRequest {
            bearing: bearing(),
            table: &table,
            viscosity: 0.01,
            cycle: &cycle,
            roughness: 0.0,
            mass: None,
        };
        let by_table = journal_orbit(&request).expect("an orbit");
        let found = direct(cavitation, &cycle, &[]);
        assert_eq!(found.outcome, OrbitOutcome::Periodic);
        let off = found.eccentricity.iter().zip(&by_table.eccentricity);
        let off = off.map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1])).fold(0.0, f64::max);
        assert!(off < 0.01 * 2.5e-5, "{cavitation:?}: {off:e}");
        let near = |a: f64, b: f64| (a / b - 1.0).abs();
        assert!(
            near(found.least_film, by_table.least_film) < 0.01,
            "{} {}",
            found.least_film,
            by_table.least_film
        );
        assert!(near(found.friction_power, by_table.friction_power) < 0.01, "{found:?}");
        assert!(
            near(found.side_flow, by_table.side_flow) < 0.03,
            "{} {}",
            found.side_flow,
            by_table.side_flow
        );
        assert_eq!(found.feed_flow, 0.0);
    }
}

/// A groove where the film carries takes its pressure away and raises the flow; one where it does not carry changes little.
#[test]
fn a_groove_under_the_load_thins_the_film() {
    let cycle = shaken(SPEED);
    let plain = direct(Cavitation::Reynolds, &cycle, &[]);
    let at = plain.least_film_angle;
    let under = direct(Cavitation::Reynolds, &cycle, &[groove(at - 0.5, at + 0.5, 3e5)]);
    let behind = direct(Cavitation::Reynolds, &cycle, &[groove(at + 2.6, at + 3.6, 3e5)]);
    assert!(under.least_film < 0.8 * plain.least_film, "{} {}", under.least_film, plain.least_film);
    assert!(behind.least_film > 0.95 * plain.least_film, "{} {}", behind.least_film, plain.least_film);
    assert!(behind.feed_flow > 0.0 && behind.side_flow > plain.side_flow, "{behind:?}");
    let more = direct(Cavitation::Reynolds, &cycle, &[groove(at + 2.6, at + 3.6, 6e5)]);
    assert!(more.feed_flow > 1.2 * behind.feed_flow, "{} {}", more.feed_flow, behind.feed_flow);
}

/// A film that keeps its oil gives at its ends what its groove gave, over a period; Reynolds' condition makes oil where the film forms again.
#[test]
fn a_mass_conserving_film_keeps_its_oil() {
    let cycle = shaken(SPEED);
    let feeds = [groove(2.0, 4.2, 4e5)];
    let kept = direct(Cavitation::MassConserving, &cycle, &feeds);
    assert_eq!(kept.outcome, OrbitOutcome::Periodic, "{}", kept.change);
    assert!((kept.side_flow / kept.feed_flow - 1.0).abs() < 2e-3, "{} {}", kept.side_flow, kept.feed_flow);
    let made = direct(Cavitation::Reynolds, &cycle, &feeds);
    assert!((made.side_flow / made.feed_flow - 1.0).abs() > 0.05, "{} {}", made.side_flow, made.feed_flow);
    // Less oil carries no more.
    assert!(kept.least_film < 1.02 * made.least_film, "{} {}", kept.least_film, made.least_film);
    let starved = direct(Cavitation::MassConserving, &cycle, &[groove(2.0, 2.1, 0.0)]);
    assert!(starved.feed_flow < kept.feed_flow && starved.least_film < kept.least_film, "{starved:?}");
}

/// The frame does not matter: all turned by an angle gives the orbit turned by it, also where the shell turns with the load.
#[test]
fn a_turned_bearing_has_the_turned_orbit() {
    let cycle = shaken(SPEED);
    let feeds = [groove(2.0, 3.2, 4e5)];
    let plain = direct(Cavitation::Reynolds, &cycle, &feeds);
    // A quarter is a whole number of cells.
    let turn = |[x, y]: [f64; 2]| [-y, x];
    let turned = JournalCycle { load: cycle.load.iter().map(|load| turn(*load)).collect(), ..cycle.clone() };
    let shell = vec![0.25 * TAU; INSTANTS as usize];
    let request = DirectRequest {
        bearing: bearing(),
        cavitation: Cavitation::Reynolds,
        cycle: &turned,
        shell: &shell,
        feeds: &feeds,
        roughness: 0.0,
    };
    let other = DirectOrbit::new(&request).expect("a film").run(0.01).expect("an orbit");
    for (a, b) in plain.eccentricity.iter().zip(&other.eccentricity) {
        let a = turn(*a);
        assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 1e-5 * 2.5e-5, "{a:?} {b:?}");
    }
}
