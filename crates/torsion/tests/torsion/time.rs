//! Time domain against frequency domain.

use lanchester_torsion::{
    Chain, Excitation, Shaft, ShaftKind, Source, Station, StationKind, TorqueAt, as_viscous, periodic_motion,
    sweep,
};
use num_complex::Complex64;

fn engine() -> (Chain, Excitation) {
    let kinds = [
        (StationKind::Ring, 0.006),
        (StationKind::Nose, 0.004),
        (StationKind::Throw(0), 0.01),
        (StationKind::Throw(1), 0.01),
        (StationKind::Flywheel, 0.15),
    ];
    let stations = kinds.map(|(kind, inertia)| Station::new("s", kind, inertia)).to_vec();
    let shafts = (0..4)
        .map(|i| Shaft {
            kind: if i == 0 { ShaftKind::Damper } else { ShaftKind::Shaft },
            damping: if i == 0 { 5.0 } else { 1.0 },
            loss_factor: if i == 0 { 0.0 } else { 0.02 },
            ..Shaft::new("k", i, i + 1, if i == 0 { 0.0 } else { 1.5e5 })
        })
        .collect();
    let chain = Chain::new(stations, shafts).unwrap();
    let source = |station: usize, firing: f64| {
        let order =
            |k: u32| Complex64::from_polar(250.0 / f64::from(k + 1), -f64::from(k + 1) * 0.5 * firing);
        let orders: Vec<Complex64> = (0..12).map(order).collect();
        // Masses: J = J_0 + m r^2 (...) has orders 1 and 2 of the revolution, here 4 and 2 of the half orders.
        let mut inertia = vec![Complex64::default(); 12];
        inertia[3] = Complex64::new(0.0, 1.2e-3) * Complex64::cis(-2.0 * firing);
        inertia[1] = Complex64::new(0.0, -3e-4) * Complex64::cis(-firing);
        Source { station, gas: vec![TorqueAt { speed: 1.0, mean: 60.0, orders }], inertia }
    };
    let excitation =
        Excitation { step: 0.5, count: 12, sources: vec![source(2, 0.0), source(3, std::f64::consts::TAU)] };
    (chain, excitation)
}

#[test]
fn linear_motion_in_time_is_that_of_the_orders() {
    let (chain, excitation) = engine();
    let chain = as_viscous(&chain, 1500.0).unwrap();
    for speed in [150.0, 310.0] {
        let orders = sweep(&chain, &excitation, &[speed]).unwrap();
        let time = periodic_motion(&chain, &excitation, speed, false).unwrap();
        assert!(time.closure < 1e-7, "{}", time.closure);
        for (shaft, torque) in orders.shafts.iter().zip(&time.torques) {
            // 960 samples of a period, orders up to 6: a peak is missed by at most (pi 12/960)^2/2.
            assert!(
                (shaft.total[0] - torque).abs() < 1e-3 * torque,
                "{} by orders, {torque} in time",
                shaft.total[0]
            );
        }
        assert!((time.load - 120.0).abs() < 1e-6 * 120.0, "the load is the mean torque: {}", time.load);
        assert!((orders.twist.total[0] - time.twist).abs() < 1e-3 * time.twist);
    }
}

#[test]
fn single_orders_in_time_are_exact() {
    let (chain, mut excitation) = engine();
    let chain = as_viscous(&chain, 1500.0).unwrap();
    for source in &mut excitation.sources {
        source.inertia.fill(Complex64::default());
        for (k, order) in source.gas[0].orders.iter_mut().enumerate() {
            if k != 5 {
                *order = Complex64::default();
            }
        }
    }
    let orders = lanchester_torsion::response(&chain, &excitation, 240.0).unwrap();
    let time = periodic_motion(&chain, &excitation, 240.0, false).unwrap();
    for (station, samples) in time.angles.iter().enumerate() {
        let (mean, found) = lanchester_torsion::orders_of(samples, 6);
        let wanted = orders.angles[station][5];
        assert!(
            (found[5] - wanted).norm() < 1e-6 * wanted.norm(),
            "station {station}: {} and {wanted}; mean {mean}",
            found[5]
        );
    }
}

#[test]
fn energies_of_a_period_balance() {
    let (chain, excitation) = engine();
    let chain = as_viscous(&chain, 1500.0).unwrap();
    for (speed, varies) in [(150.0, false), (310.0, false), (200.0, true), (310.0, true)] {
        let time = periodic_motion(&chain, &excitation, speed, varies).unwrap();
        let energy = time.energy;
        assert!(energy.error() < 1e-9, "{speed} {varies}: {energy:?}");
        // The dampers' loss is a small part of what the gas gives: it is balanced by itself too.
        assert!(energy.damping > 0.0 && energy.missing.abs() < 1e-4 * energy.damping, "{energy:?}");
        // Were it forgotten, the balance would say so.
        assert!((energy.missing + energy.damping).abs() > 1e-4 * energy.turnover, "{energy:?}");
        // Load and gas are those of the result: the load holds over the angle of a period, two revolutions.
        assert!((energy.load - time.load * 2.0 * std::f64::consts::TAU).abs() < 1e-6 * energy.load);
        assert_eq!(energy.masses == 0.0, varies);
    }
}

#[test]
fn varying_inertia_changes_little_and_keeps_the_mean_power() {
    let (chain, excitation) = engine();
    let chain = as_viscous(&chain, 1500.0).unwrap();
    let linear = periodic_motion(&chain, &excitation, 200.0, false).unwrap();
    let varying = periodic_motion(&chain, &excitation, 200.0, true).unwrap();
    assert!(varying.closure < 1e-4);
    for (a, b) in linear.torques.iter().zip(&varying.torques) {
        // An inertia that varies by 2 J_2/J: parts of a tenth of each throw here.
        assert!((a - b).abs() < 0.25 * a && a != b, "{a} and {b}");
    }
    // What dampers take is not there for the load: work of the gas = load + losses.
    assert!(varying.load < 120.0 && varying.load > 60.0, "{}", varying.load);
}
