//! Chains with closed solutions.

use lanchester_torsion::{Chain, Pendulum, Shaft, ShaftKind, Station, StationKind, damped_modes, modes};
use std::f64::consts::PI;

/// Equal discs on equal shafts, free ends: w = 2 sqrt(k/J) sin(r pi / (2 n)).
#[test]
fn uniform_chain() {
    for n in [2_usize, 3, 8, 40] {
        let chain = Chain::plain(&vec![0.3; n], &vec![5e4; n - 1]).unwrap();
        let found = modes(&chain, 0.0).unwrap();
        assert_eq!(found.len(), n - 1, "rigid turning is left out");
        for (r, mode) in found.iter().enumerate() {
            let r = r + 1;
            let exact = 2.0 * (5e4_f64 / 0.3).sqrt() * (r as f64 * PI / (2 * n) as f64).sin();
            assert!((mode.frequency - exact).abs() < 1e-12 * exact * n as f64, "mode {r} of {n}: rounding");
            assert_eq!(mode.nodes, r, "mode {r} of {n} has {r} nodes");
        }
    }
}

/// A geared pair is two discs on a shaft with the squares of the ratio.
#[test]
fn gears_count_by_the_square_of_their_ratio() {
    let (ratio, k) = (-3.5, 800.0);
    let stations = vec![
        Station::new("engine", StationKind::Other, 2.0),
        Station { ratio, ..Station::new("fan", StationKind::Other, 0.1) },
    ];
    let chain = Chain::new(stations, vec![Shaft { ratio, ..Shaft::new("drive", 0, 1, k) }]).unwrap();
    let exact = (k * ratio * ratio * (1.0 / 2.0 + 1.0 / (0.1 * ratio * ratio))).sqrt();
    let mode = &modes(&chain, 0.0).unwrap()[0];
    assert!((mode.frequency - exact).abs() < 1e-12 * exact, "w^2 = k rho^2 (1/J + 1/(rho^2 J_2))");
    // Shape: J_1 phi_1 + J_2 rho^2 phi_2 = 0, own angle rho phi_2.
    let expected = -2.0 / (0.1 * ratio);
    assert!((mode.shape[1] / mode.shape[0] - expected).abs() < 1e-12 * expected.abs(), "momentum");
}

/// A soft coupling holds the strain of the lowest mode, the shaft before it that of the next; the twists of equal torque are as the flexibilities.
#[test]
fn strain_is_where_the_chain_gives_way() {
    let station = |name: &str, inertia: f64| Station::new(name, StationKind::Other, inertia);
    let stations = vec![station("nose", 0.02), station("flywheel", 0.2), station("load", 1.0)];
    let shafts = vec![
        Shaft::new("crank", 0, 1, 1e5),
        Shaft { kind: ShaftKind::Coupling, ..Shaft::new("clutch", 1, 2, 1e3) },
    ];
    let chain = Chain::new(stations, shafts).unwrap();
    let found = modes(&chain, 0.0).unwrap();
    let share = |mode: usize, kind| chain.strain_share(&found[mode].shape, kind, 0.0);
    assert!(share(0, ShaftKind::Coupling) > 0.99 && share(1, ShaftKind::Shaft) > 0.99);
    for mode in 0..2 {
        let both = share(mode, ShaftKind::Coupling) + share(mode, ShaftKind::Shaft);
        assert!((both - 1.0).abs() < 1e-12, "{both}");
        // k times the square of the twist, of the shape itself.
        let shape = &found[mode].shape;
        let [crank, clutch] = [1e5 * (shape[1] - shape[0]).powi(2), 1e3 * (shape[2] - shape[1]).powi(2)];
        assert!((share(mode, ShaftKind::Shaft) - crank / (crank + clutch)).abs() < 1e-12);
    }
    assert_eq!(chain.strain_share(&[1.0; 3], ShaftKind::Shaft, 0.0), 0.0);
}

/// Two discs on a shaft with viscous damping: s^2 + c g s + k g = 0, g = 1/J_1 + 1/J_2, beside rigid turning.
#[test]
fn damped_modes_of_two_discs() {
    for c in [0.0, 0.5, 40.0, 1000.0] {
        let stations =
            vec![Station::new("a", StationKind::Other, 0.02), Station::new("b", StationKind::Other, 0.5)];
        let chain = Chain::new(stations, vec![Shaft { damping: c, ..Shaft::new("ab", 0, 1, 3e4) }]).unwrap();
        let g = 1.0 / 0.02 + 1.0 / 0.5;
        let (half, square) = (0.5 * c * g, 3e4 * g);
        let found = damped_modes(&chain, 0.0).unwrap();
        if half * half < square {
            assert_eq!(found.len(), 1);
            let exact = (square - half * half).sqrt();
            assert!(
                (found[0].frequency - exact).abs() < 1e-9 * exact,
                "{} instead of {exact}",
                found[0].frequency
            );
            assert!(
                (found[0].decay - half).abs() < 1e-9 * square.sqrt(),
                "{} instead of {half}",
                found[0].decay
            );
            let ratio = found[0].shape[1] / found[0].shape[0];
            assert!((ratio + 0.02 / 0.5).norm() < 1e-6, "momentum: {ratio}");
        } else {
            let root = (half * half - square).sqrt();
            let decays: Vec<f64> = found.iter().map(|mode| mode.decay).collect();
            assert!(found.iter().all(|mode| mode.frequency == 0.0) && decays.len() == 2, "{decays:?}");
            assert!(
                (decays[0] - (half - root)).abs() < 1e-9 * half
                    && (decays[1] - (half + root)).abs() < 1e-9 * half,
                "{decays:?}"
            );
        }
    }
}

/// With little damping the roots are those of the undamped modes with the decay of their dissipation: c_r/(2 J_r).
#[test]
fn small_damping_is_modal_damping() {
    let mut chain = Chain::plain(&[0.01, 0.02, 0.015, 0.2], &[3e5, 2e5, 4e5]).unwrap();
    chain = chain
        .with(|stations, shafts| {
            stations[1].damping = 0.003;
            for shaft in shafts {
                shaft.damping = 0.002;
                shaft.loss_factor = 1e-4;
            }
        })
        .unwrap();
    let damped = damped_modes(&chain, 0.0).unwrap();
    let undamped = modes(&chain, 0.0).unwrap();
    for (mode, free) in damped.iter().zip(&undamped) {
        let twists: f64 = chain
            .shafts()
            .iter()
            .map(|s| {
                let twist = free.shape[s.from] - free.shape[s.to];
                (s.damping + s.loss_factor * s.stiffness / free.frequency) * twist * twist
            })
            .sum();
        let decay = (twists + 0.003 * free.shape[1].powi(2)) / (2.0 * free.inertia);
        assert!(
            (mode.frequency - free.frequency).abs() < 1e-6 * free.frequency,
            "frequency changes by the square of the damping"
        );
        assert!(
            (mode.decay - decay).abs() < 1e-4 * decay,
            "{} instead of {decay}: first order in the damping",
            mode.decay
        );
    }
    // Damping against the ground lets rigid turning run down.
    let last = damped.last().unwrap();
    assert!(
        last.frequency == 0.0 && (last.decay - 0.003 / 0.245).abs() < 1e-4 * last.decay,
        "{}",
        last.decay
    );
}

/// A pendulum on a free disc: mode at n^2 W^2 (1 + (R + l)^2 m / J), and as an inertia N m (R + l)^2/(1 - order^2 l/R) in forced motion.
#[test]
fn pendulum_is_a_branch() {
    let (j, m, r, l, speed) = (0.05, 0.4, 0.09, 0.01, 300.0);
    let chain = Chain::plain(&[j, 1e9], &[1e-9]).unwrap();
    let pendulum = Pendulum { station: 0, mass: m, pivot_radius: r, length: l, number: 2, damping: 0.0 };
    assert!((pendulum.order() - 3.0).abs() < 1e-12);
    let with = pendulum.on(&chain).unwrap();
    let found = modes(&with, speed).unwrap();
    let exact = 3.0 * speed * (1.0 + 2.0 * m * (r + l).powi(2) / j).sqrt();
    let top = found.last().unwrap();
    assert!((top.frequency - exact).abs() < 1e-9 * exact, "{} instead of {exact}", top.frequency);
}
