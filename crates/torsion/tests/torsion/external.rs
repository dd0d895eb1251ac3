//! openTorsion's chain: `validation/external/opentorsion`.

use lanchester_torsion::{
    Chain, Excitation, Shaft, Source, Station, StationKind, TorqueAt, damped_modes, modes, response,
};
use num_complex::Complex64;
use serde_json::Value;

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|one| one.as_f64().unwrap()).collect()
}

fn complex(value: &Value) -> Complex64 {
    let [re, im] = numbers(value)[..] else { panic!("two numbers") };
    Complex64::new(re, im)
}

#[test]
fn ext_opentorsion() {
    let run: Value =
        serde_json::from_str(include_str!("../../../../validation/external/opentorsion/chain.json")).unwrap();
    let [inertias, stiffnesses, relative, absolute] =
        ["inertias", "stiffnesses", "relative", "absolute"].map(|key| numbers(&run[key]));
    let stations = inertias
        .iter()
        .zip(&absolute)
        .map(|(inertia, damping)| Station {
            damping: *damping,
            ..Station::new("s", StationKind::Other, *inertia)
        })
        .collect();
    let shafts = stiffnesses
        .iter()
        .zip(&relative)
        .enumerate()
        .map(|(i, (k, c))| Shaft { damping: *c, ..Shaft::new("k", i, i + 1, *k) })
        .collect();
    let chain = Chain::new(stations, shafts).unwrap();
    for (mode, other) in modes(&chain, 0.0).unwrap().iter().zip(numbers(&run["undamped"])) {
        assert!(
            (mode.frequency - other).abs() < 1e-8 * other,
            "{} and {other}: LAPACK's general solver",
            mode.frequency
        );
    }
    let damped = damped_modes(&chain, 0.0).unwrap();
    let theirs = run["damped"].as_array().unwrap();
    assert_eq!(damped.iter().filter(|mode| mode.frequency > 0.0).count(), theirs.len());
    for (mode, other) in damped.iter().zip(theirs) {
        let other = numbers(other);
        assert!((mode.frequency - other[0]).abs() < 1e-8 * other[0], "{} and {}", mode.frequency, other[0]);
        assert!((mode.damping_ratio - other[1]).abs() < 1e-8, "{} and {}", mode.damping_ratio, other[1]);
    }
    for (column, w) in numbers(&run["omegas"]).into_iter().enumerate() {
        let source = |station: usize| {
            let orders = vec![complex(&run["torques"][station][column])];
            Source {
                station,
                gas: vec![TorqueAt { speed: 1.0, mean: 0.0, orders }],
                inertia: vec![Complex64::default()],
            }
        };
        let excitation = Excitation { step: 1.0, count: 1, sources: (0..7).map(source).collect() };
        let found = response(&chain, &excitation, w).unwrap();
        for (station, angles) in found.angles.iter().enumerate() {
            let other = complex(&run["angles"][station][column]);
            assert!(
                (angles[0] - other).norm() < 1e-9 * other.norm(),
                "station {station} at {w}: {} and {other}",
                angles[0]
            );
        }
    }
    // Five times as fast behind the gears.
    let ratio = 5.0;
    let stations = vec![
        Station::new("a", StationKind::Other, 1.5),
        Station::new("gears", StationKind::Other, 0.4 + 0.002 * ratio * ratio),
        Station { ratio, ..Station::new("b", StationKind::Other, 0.012) },
    ];
    let shafts = vec![Shaft::new("slow", 0, 1, 3e4), Shaft { ratio, ..Shaft::new("fast", 1, 2, 900.0) }];
    let geared = Chain::new(stations, shafts).unwrap();
    for (mode, other) in modes(&geared, 0.0).unwrap().iter().zip(numbers(&run["geared"])) {
        assert!((mode.frequency - other).abs() < 1e-8 * other, "{} and {other}", mode.frequency);
    }
}
