//! Published chains.

use lanchester_torsion::{Chain, Shaft, Station, StationKind, holzer, modes};
use std::f64::consts::TAU;

/// Six masses with 1169 Hz and 2085 Hz; stiffnesses are given in N m/deg.
pub fn six_masses() -> Chain {
    let inertias = [1.99e-5, 1.6958e-3, 2.1595e-3, 1.8157e-3, 1.2602e-3, 1.54e-5];
    let per_degree = [3014.0, 2562.0, 2430.0, 2636.0, 2562.0];
    Chain::plain(&inertias, &per_degree.map(|k| k * 360.0 / TAU)).unwrap()
}

/// Gunter and Chen's marine geared set, in their units: lb in s^2, lb in/rad.
pub fn marine_set() -> Chain {
    let [first, second] = [9.4094, 9.4094];
    let [turbine_a, turbine_b] = [78.2365, 40.0424];
    let station = |name: &str, inertia: f64, ratio: f64| Station {
        ratio,
        ..Station::new(name, StationKind::Other, inertia)
    };
    let shaft = |from: usize, to: usize, stiffness: f64, ratio: f64| Shaft {
        ratio,
        ..Shaft::new("shaft", from, to, stiffness)
    };
    let stations = vec![
        station("propeller", 2_454_000.0, 1.0),
        station("main gear", 826_000.0, 1.0),
        station("gear a", 27_230.0, first),
        station("gear b", 12_830.0, second),
        station("turbine a", 261.2, turbine_a),
        station("turbine b", 15_090.0, turbine_b),
    ];
    let shafts = vec![
        shaft(0, 1, 826e6, 1.0),
        shaft(1, 2, 24.17e6, first),
        shaft(1, 3, 203.94e6, second),
        shaft(2, 4, 14.26e6, turbine_a),
        shaft(3, 5, 30.51e6, turbine_b),
    ];
    Chain::new(stations, shafts).unwrap()
}

#[test]
fn lit_six_masses() {
    let found = modes(&six_masses(), 0.0).unwrap();
    // Printed to whole hertz.
    assert!((found[0].hertz() - 1169.0).abs() < 0.5, "first mode {} Hz", found[0].hertz());
    assert!((found[1].hertz() - 2085.0).abs() < 0.5, "second mode {} Hz", found[1].hertz());
}

#[test]
fn lit_gunter_marine_geared_set() {
    let found = modes(&marine_set(), 0.0).unwrap();
    for (mode, printed) in found.iter().zip([177.7, 220.2, 1282.6]) {
        let cpm = mode.hertz() * 60.0;
        // Printed to a tenth of a cycle a minute; 1282.6 from ratios printed to four decimals.
        assert!((cpm - printed).abs() < 0.06, "{cpm} instead of {printed} cpm");
    }
}

#[test]
fn holzer_is_free_of_torque_at_natural_frequencies_and_there_alone() {
    for chain in [six_masses(), marine_set()] {
        for (index, mode) in modes(&chain, 0.0).unwrap().iter().enumerate() {
            let table = holzer(&chain, mode.frequency, 0.0);
            assert!(
                table.relative_residual.abs() < 1e-9,
                "{} at {} Hz: rounding",
                table.relative_residual,
                mode.hertz()
            );
            let scale = mode.shape[0];
            // Where a mode is alive at one end alone, the other end's angle is rounding in both.
            for row in table.rows.iter().filter(|_| index < 2) {
                let referred = mode.shape[row.station] / chain.stations()[row.station].ratio;
                let wanted = referred / (scale / chain.stations()[0].ratio);
                assert!(
                    (row.angle - wanted).abs() < 1e-8 * wanted.abs().max(1.0),
                    "angle of station {}",
                    row.station
                );
            }
            assert!(
                holzer(&chain, mode.frequency * 1.01, 0.0).relative_residual.abs() > 1e-6,
                "a percent off it is not"
            );
        }
    }
}
