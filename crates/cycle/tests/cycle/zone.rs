//! The single zone against closed forms, conservation and its own settings.

use crate::support::{cycle_of, engine, volume_of};
use lanchester_cycle::{
    Contents, CycleError, ZoneCycle, ZoneSettings, fill, indicated, mass_flow, piston_gap, single_zone,
};
use lanchester_model::{Engine, GasProcess, Reservoir, SingleZone};
use std::f64::consts::PI;

const SPEED: f64 = 3000.0 * PI / 30.0;
/// As tight as doubles allow.
const TIGHT: ZoneSettings =
    ZoneSettings { step_tolerance: 1e-13, cycle_tolerance: 1e-11, most_cycles: 300, piece: PI / 720.0 };

const VALVES: &str = "[gas.intake]\npressure = \"0.95 bar\"\ntemperature = \"310 K\"\nopens = \"345 deg\"\ncloses = \"590 deg\"\nlift = \"9 mm\"\ndiameter = \"34 mm\"\n\
    [gas.exhaust]\npressure = \"1.05 bar\"\nopens = \"130 deg\"\ncloses = \"375 deg\"\nlift = \"8 mm\"\ndiameter = \"30 mm\"\n";
const BURNING: &str = "[gas.fuel]\nequivalence_ratio = 0.98\nefficiency = \"97 %\"\n[gas.heat_release]\nstart = \"-18 deg\"\nduration = \"60 deg\"\n\
    [gas.heat_release.second]\nshare = \"25 %\"\nstart = \"5 deg\"\nduration = \"80 deg\"\nexponent = 1.3\n";
const WALLS: &str = "[gas.walls]\nmodel = \"woschni\"\n";

fn file(rest: &[&str]) -> String {
    let head =
        "[gas]\ncompression_ratio = 10.5\n[gas.cycle]\ntype = \"single-zone\"\nheat_capacity_ratio = 1.33\n";
    format!("{head}{}", rest.concat())
}

fn zone_of(engine: &Engine) -> &SingleZone {
    match &cycle_of(engine).process {
        GasProcess::SingleZone(zone) => zone,
        other => panic!("no single zone: {other:?}"),
    }
}

fn run(engine: &Engine, speed: f64, settings: &ZoneSettings) -> Result<ZoneCycle, CycleError> {
    single_zone(cycle_of(engine), zone_of(engine), &volume_of(engine), speed, settings)
}

#[test]
fn flow_is_that_of_the_textbook_choked_and_not() {
    let (gamma, r) = (1.4_f64, 287.05);
    let upstream = [2e5, 400.0];
    let exact = |ratio: f64| {
        let y = ratio.powf(2.0 / gamma) - ratio.powf((gamma + 1.0) / gamma);
        1e-4 * 2e5 / (r * 400.0_f64).sqrt() * (2.0 * gamma / (gamma - 1.0) * y).sqrt()
    };
    let critical = (2.0 / 2.4_f64).powf(3.5);
    for ratio in [0.99, 0.9, 0.7, 0.55, critical] {
        let flow = mass_flow(1e-4, upstream, ratio * 2e5, gamma, r);
        // What makes the slope at rest finite costs (y_0/y)^2/4.
        let y = ratio.powf(2.0 / gamma) - ratio.powf((gamma + 1.0) / gamma);
        let bound = 1.01 * (1e-4 * (gamma - 1.0) / gamma / y).powi(2) / 4.0;
        assert!((flow / exact(ratio) - 1.0).abs() < bound, "{ratio}: {flow} {}", exact(ratio));
    }
    let choked = mass_flow(1e-4, upstream, critical * 2e5, gamma, r);
    assert_eq!(mass_flow(1e-4, upstream, 1.0, gamma, r), choked);
    // Heywood, eq. C.9: choked flow.
    let textbook = 1e-4 * 2e5 / (r * 400.0_f64).sqrt() * gamma.sqrt() * (2.0 / 2.4_f64).powf(3.0);
    assert!((choked / textbook - 1.0).abs() < 1e-7);
    assert_eq!(mass_flow(1e-4, upstream, 2e5, gamma, r), 0.0);
}

#[test]
fn a_filled_vacuum_is_gamma_times_as_hot() {
    let (gamma, r, volume) = (1.4, 287.05, 1e-3);
    let air = Reservoir { pressure: 1e5, temperature: 300.0 };
    let start = Contents { pressure: 1e-3, mass: 1e-3 * volume / (r * 300.0), fresh: 0.0 };
    let full = fill(start, volume, air, 1e-5, 5.0, [gamma, r]).expect("it fills");
    let temperature = full.pressure * volume / (full.mass * r);
    assert!((full.pressure / 1e5 - 1.0).abs() < 1e-9, "{full:?}");
    // A millionth of a hundredth of the gas was there before.
    assert!((temperature / (gamma * 300.0) - 1.0).abs() < 1e-7, "{temperature}");
    assert!((full.fresh + start.mass - full.mass).abs() < 1e-9 * full.mass, "all of it is fresh");
}

#[test]
fn closed_and_adiabatic_it_is_the_isentrope() {
    // Tiny areas: next to nothing flows.
    let tight = VALVES
        .replace("lift = \"9 mm\"", "lift = \"0.001 um\"")
        .replace("lift = \"8 mm\"", "lift = \"0.001 um\"");
    let engine = engine(4, "8 mm", &file(&[&tight]));
    let settings = ZoneSettings { most_cycles: 1, ..TIGHT };
    let (cycle, volume) = (run(&engine, SPEED, &settings).expect("a cycle"), volume_of(&engine));
    let at = |psi: f64| cycle.pressure.at(psi) * volume.at(psi)[0].powf(1.33);
    for psi in [-1.7, -1.0, -0.3, 0.0, 0.4, 1.5, 2.2] {
        let error = (at(psi) / at(cycle.closing_angle) - 1.0).abs();
        assert!(error < 1e-8, "{psi}: {error:e}");
    }
}

#[test]
fn the_adiabatic_motored_cycle_conserves_energy_and_mass() {
    let engine = engine(4, "0 mm", &file(&[VALVES]));
    let cycle = run(&engine, SPEED, &TIGHT).expect("a cycle");
    assert!(cycle.outcome.converged, "{:?}", cycle.outcome);
    assert!(cycle.balance.energy_share < 1e-10 && cycle.balance.mass_share < 1e-10, "{:?}", cycle.balance);
    // What repeats itself stores nothing: enthalpy in pays for the work.
    let paid: f64 = cycle.passed.enthalpy.iter().sum();
    assert!((paid - cycle.passed.work).abs() < 1e-8 * cycle.passed.enthalpy[0], "{:?}", cycle.passed);
    assert!(cycle.passed.work < 0.0 && cycle.passed.released == 0.0 && cycle.passed.wall_heat == 0.0);
}

#[test]
fn a_fired_cycle_closes_and_its_curve_does_the_same_work() {
    for walls in ["", WALLS, "[gas.walls]\nmodel = \"hohenberg\"\n"] {
        let engine = engine(4, "0 mm", &file(&[VALVES, BURNING, walls]));
        let usual = run(&engine, SPEED, &ZoneSettings::default()).expect("a cycle");
        let tight = run(&engine, SPEED, &TIGHT).expect("a cycle");
        assert!(usual.outcome.converged && usual.outcome.change <= 1e-7, "{:?}", usual.outcome);
        assert!(
            usual.balance.energy_share < 1e-7 && tight.balance.energy_share < 1e-10,
            "{:?}",
            tight.balance
        );
        let work = indicated(&usual.pressure, &volume_of(&engine)).work;
        assert!((work / usual.passed.work - 1.0).abs() < 1e-6, "{work} {:?}", usual.passed);
        assert!((usual.passed.work / tight.passed.work - 1.0).abs() < 1e-6);
        // Figures of a naturally aspirated engine at wide open throttle.
        assert!((0.75..1.05).contains(&usual.volumetric_efficiency), "{}", usual.volumetric_efficiency);
        assert!((0.02..0.15).contains(&usual.residual_share), "{}", usual.residual_share);
        let efficiency = usual.indicated_efficiency.expect("it is fired");
        assert!((0.28..0.48).contains(&efficiency), "{efficiency}");
        let share = usual.passed.wall_heat / usual.heat;
        assert!(if walls.is_empty() { share == 0.0 } else { (0.08..0.35).contains(&share) }, "{share}");
    }
}

#[test]
fn fast_heat_at_top_dead_centre_nears_the_otto_cycle() {
    // No losses: what is left is the shorter closed part, so the limit is taken with ports at bottom dead centre in effect closed.
    let release = "[gas.fuel]\nenergy = \"600 J\"\n[gas.heat_release]\nstart = \"-0.0005 deg\"\nduration = \"0.001 deg\"\n";
    let tight = VALVES
        .replace("lift = \"9 mm\"", "lift = \"0.001 um\"")
        .replace("lift = \"8 mm\"", "lift = \"0.001 um\"")
        .replace("130 deg", "180 deg")
        .replace("590 deg", "540 deg")
        .replace("345 deg", "360 deg")
        .replace("375 deg", "360 deg");
    let engine = engine(4, "0 mm", &file(&[&tight, release]));
    let settings = ZoneSettings { most_cycles: 1, ..TIGHT };
    let (cycle, volume) = (run(&engine, SPEED, &settings).expect("a cycle"), volume_of(&engine));
    let work = lanchester_cycle::work_between(&cycle.pressure, &volume, -PI, PI);
    // The second run of the two starts hotter: the closed cycle's efficiency does not depend on its state.
    let efficiency = work / cycle.passed.released;
    let textbook = 1.0 - 10.5_f64.powf(-0.33);
    assert!((efficiency - textbook).abs() < 1e-6, "{efficiency} {textbook}");
}

#[test]
fn more_speed_takes_in_less_when_valves_are_small() {
    let small = VALVES.replace("34 mm", "22 mm").replace("30 mm", "20 mm");
    let engine = engine(4, "0 mm", &file(&[&small, BURNING, WALLS]));
    let at = |rpm: f64| run(&engine, rpm * PI / 30.0, &ZoneSettings::default()).expect("a cycle");
    let (slow, fast) = (at(1500.0), at(7000.0));
    assert!(slow.outcome.converged && fast.outcome.converged);
    assert!(fast.volumetric_efficiency < slow.volumetric_efficiency - 0.1);
}

#[test]
fn two_strokes_scavenge_through_ports() {
    let ports = "[gas.intake]\npressure = \"1.3 bar\"\ntemperature = \"330 K\"\nopens = \"120 deg\"\narea = \"1100 mm2\"\n\
        [gas.exhaust]\npressure = \"1.05 bar\"\nopens = \"95 deg\"\narea = \"1300 mm2\"\n";
    let engine = engine(2, "6 mm", &file(&[ports, BURNING, WALLS]));
    let cycle = run(&engine, SPEED, &ZoneSettings::default()).expect("a cycle");
    assert!(cycle.outcome.converged && cycle.outcome.cycles < 60, "{:?}", cycle.outcome);
    assert!(cycle.balance.energy_share < 1e-7, "{:?}", cycle.balance);
    assert!((0.3..1.0).contains(&cycle.trapping_efficiency), "{}", cycle.trapping_efficiency);
    // Ports close where the piston covers the edge again: not mirrored where the cylinder is offset.
    let volume = volume_of(&engine);
    let edge = volume.depth(95.0_f64.to_radians())[0];
    assert!((volume.depth(cycle.closing_angle)[0] - edge).abs() < 1e-12);
}

#[test]
fn valves_that_meet_the_piston_are_told() {
    let deep =
        VALVES.replace("diameter = \"34 mm\"\n", "diameter = \"34 mm\"\npiston_clearance = \"1 mm\"\n");
    let near = engine(4, "0 mm", &file(&[&deep]));
    let gap = piston_gap(zone_of(&near), &volume_of(&near));
    assert!(gap.len() == 1 && gap[0].is_intake && (0.5e-3..0.7e-3).contains(&gap[0].gap), "{gap:?}");
    let early = deep.replace("345 deg", "310 deg");
    let hit = engine(4, "0 mm", &file(&[&early]));
    let error = run(&hit, SPEED, &ZoneSettings::default()).expect_err("they meet").to_string();
    assert!(error.contains("the intake valve meets the piston"), "{error}");
}
