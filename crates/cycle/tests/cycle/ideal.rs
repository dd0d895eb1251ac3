//! Ideal cycles against the textbook's closed forms.

use crate::support;
use crate::support::{cycle_of, engine, volume_of};
use lanchester_cycle::{CycleError, IdealCycle, ideal_cycle, indicated};
use lanchester_model::Engine;

fn ideal(engine: &Engine) -> Result<IdealCycle, CycleError> {
    ideal_cycle(cycle_of(engine), &volume_of(engine))
}

fn gas(ratio: f64, cycle: &str, rest: &str) -> String {
    format!(
        "[gas]\ncompression_ratio = {ratio}\n[gas.cycle]\nheat_capacity_ratio = 1.4\n{cycle}\n[gas.intake]\npressure = \"0.9 bar\"\ntemperature = \"310 K\"\n\
         [gas.exhaust]\npressure = \"1.1 bar\"\n{rest}"
    )
}

#[test]
fn otto_has_the_efficiency_of_the_textbook_whatever_the_linkage() {
    for strokes in [2, 4] {
        for offset in ["0 mm", "14 mm", "-9 mm"] {
            for ratio in [4.0, 10.5, 23.0] {
                let file = gas(ratio, "type = \"otto\"", "[gas.fuel]\nenergy = \"900 J\"\n");
                let engine = engine(strokes, offset, &file);
                let (cycle, volume) = (ideal(&engine).expect("a cycle"), volume_of(&engine));
                let textbook = 1.0 - ratio.powf(1.0 - 1.4);
                assert!((cycle.efficiency - textbook).abs() < 1e-12, "{ratio}: {}", cycle.efficiency);
                // The integral over the curve has the error of its pieces, some 1e-11 of the pressure.
                let done = indicated(&cycle.pressure, &volume);
                assert!(
                    (done.gross_work / 900.0 - textbook).abs() < 1e-9,
                    "{strokes} {offset} {ratio}: {done:?}"
                );
                let exchange = if strokes == 4 { -0.2e5 * volume.displaced() } else { 0.0 };
                assert!((done.exchange_work - exchange).abs() < 1e-9, "{done:?}");
                assert!((done.work - done.gross_work - done.exchange_work).abs() < 1e-12 * 900.0);
            }
        }
    }
}

#[test]
fn a_closed_cylinder_keeps_p_v_n_in_every_revolution() {
    for strokes in [2, 4] {
        let file = "[gas]\ncompression_ratio = 8\n[gas.cycle]\ntype = \"sealed\"\nheat_capacity_ratio = 1.3\npressure = \"0.8 bar\"\n";
        let engine = engine(strokes, "9 mm", file);
        let (cycle, volume) = (ideal(&engine).expect("a cycle"), volume_of(&engine));
        let kept = 0.8e5 * volume.at(volume.bottom_angle())[0].powf(1.3);
        for k in 0..1009 {
            let psi = volume.cycle() * f64::from(k) / 1009.0;
            let pressure = cycle.pressure.at(psi);
            assert!(
                (pressure * volume.at(psi)[0].powf(1.3) / kept - 1.0).abs() < 1e-10,
                "{strokes} {psi}: {pressure}"
            );
        }
        // Nothing is gained or lost.
        let done = indicated(&cycle.pressure, &volume);
        assert!(done.work.abs() < 1e-9 * 0.8e5 * volume.displaced(), "{done:?}");
        assert!(cycle.heat == 0.0 && cycle.closed_work.abs() < 1e-12 && cycle.efficiency == 0.0);
    }
}

#[test]
fn diesel_and_seiliger_have_the_efficiencies_of_the_textbook() {
    let ratio: f64 = 18.0;
    let gamma = 1.4;
    for share in [0.0, 0.3, 0.7, 1.0] {
        let kind = if share == 0.0 {
            "type = \"diesel\"".to_string()
        } else {
            format!("type = \"seiliger\"\nconstant_volume_share = {share}")
        };
        let engine = engine(4, "5 mm", &gas(ratio, &kind, "[gas.fuel]\nenergy = \"1100 J\"\n"));
        let (cycle, volume) = (ideal(&engine).expect("a cycle"), volume_of(&engine));
        let [_, compressed, at_top, hot, _] = cycle.states;
        // Heywood, eq. 5.32: pressure ratio a, cut-off ratio b.
        let (a, b) = (at_top.pressure / compressed.pressure, hot.volume / at_top.volume);
        let textbook =
            1.0 - ratio.powf(1.0 - gamma) * (a * b.powf(gamma) - 1.0) / (a * gamma * (b - 1.0) + a - 1.0);
        assert!((cycle.efficiency - textbook).abs() < 1e-12, "{share}: {} {textbook}", cycle.efficiency);
        let done = indicated(&cycle.pressure, &volume);
        assert!((done.gross_work / 1100.0 - textbook).abs() < 1e-9, "{share}: {done:?}");
        assert!((done.peak_pressure - hot.pressure).abs() < 1e-9 * hot.pressure);
        // The cut-off lies where the volume says.
        assert!((volume.at(cycle.cut_off_angle)[0] - hot.volume).abs() < 1e-12 * hot.volume);
    }
}

#[test]
fn the_pieces_follow_the_isentrope_far_below_a_billionth() {
    let engine = engine(4, "14 mm", &gas(21.0, "type = \"otto\"\npeak_pressure = \"150 bar\"", ""));
    let (cycle, volume) = (ideal(&engine).expect("a cycle"), volume_of(&engine));
    assert!((indicated(&cycle.pressure, &volume).peak_pressure - 150e5).abs() < 1e-3);
    let hot = cycle.states[3];
    for k in 1..9973 {
        let psi = volume.bottom_angle() * f64::from(k) / 9973.0;
        let exact = hot.pressure * (hot.volume / volume.at(psi)[0]).powf(1.4);
        let error = (cycle.pressure.at(psi) / exact - 1.0).abs();
        assert!(error < 5e-11, "{psi}: {error:e}");
    }
    assert!(cycle.pressure.pieces().count() < 4000, "{}", cycle.pressure.pieces().count());
}

#[test]
fn heat_of_a_mixture_is_that_of_its_air() {
    let rest = "[gas.fuel]\nequivalence_ratio = 0.8\nair_fuel_ratio = 14.6\nheating_value = \"42.7 MJ/kg\"\nefficiency = \"95 %\"\n";
    let engine = engine(4, "0 mm", &gas(9.0, "type = \"otto\"", rest));
    let (cycle, volume) = (ideal(&engine).expect("a cycle"), volume_of(&engine));
    let mass = 0.9e5 * volume.displaced() * 9.0 / 8.0 / (287.05 * 310.0);
    assert!((cycle.mass - mass).abs() < 1e-12 * mass, "{} {mass}", cycle.mass);
    assert!((cycle.heat - 0.95 * 0.8 * mass / 14.6 * 42.7e6).abs() < 1e-9 * cycle.heat);
    // More fuel than air burns as much as the air allows.
    let rich = |ratio: f64| {
        let rest = rest.replace("0.8", &ratio.to_string());
        ideal(&support::engine(4, "0 mm", &gas(9.0, "type = \"otto\"", &rest))).expect("a cycle").heat
    };
    assert_eq!(rich(1.0), rich(1.3));
}

#[test]
fn what_cannot_be_is_told() {
    let refused = |ratio: f64, cycle: &str, rest: &str| {
        ideal(&engine(4, "0 mm", &gas(ratio, cycle, rest))).expect_err("it cannot be").to_string()
    };
    let low = refused(10.0, "type = \"otto\"\npeak_pressure = \"10 bar\"", "");
    assert!(low.contains("2.2607e6 Pa that compression alone gives"), "{low}");
    let much = refused(5.0, "type = \"diesel\"", "[gas.fuel]\nenergy = \"9 kJ\"\n");
    assert!(much.contains("before bottom dead centre"), "{much}");
    let split =
        refused(15.0, "type = \"seiliger\"\npeak_pressure = \"100 bar\"", "[gas.fuel]\nenergy = \"100 J\"\n");
    assert!(split.contains("that the peak pressure takes"), "{split}");
}
