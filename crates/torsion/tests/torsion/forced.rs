//! Forced vibration.

use lanchester_torsion::{
    Chain, Excitation, Pendulum, Shaft, ShaftKind, Source, Station, StationKind, TorqueAt, response, sweep,
};
use num_complex::Complex64;
use proptest::prelude::*;

pub fn unit(chain: &Chain, station: usize, order: usize, count: usize) -> Excitation {
    let _ = chain;
    let mut orders = vec![Complex64::default(); count];
    orders[order] = Complex64::new(1.0, 0.0);
    let gas = vec![TorqueAt { speed: 1.0, mean: 0.0, orders }];
    Excitation {
        step: 1.0,
        count,
        sources: vec![Source { station, gas, inertia: vec![Complex64::default(); count] }],
    }
}

/// A random tree with gears, all kinds of damping.
fn any_chain() -> impl Strategy<Value = Chain> {
    (2_usize..9).prop_flat_map(|n| {
        let stations =
            proptest::collection::vec((1e-4..1.0_f64, 0.0..0.5_f64, 0.3..4.0_f64, any::<bool>()), n);
        let shafts = proptest::collection::vec(
            (1e3..1e6_f64, 0.0..5.0_f64, 0.0..0.2_f64, 0.3..4.0_f64, any::<prop::sample::Index>()),
            n - 1,
        );
        (stations, shafts).prop_map(|(stations, shafts)| {
            let sign = |is: bool| if is { -1.0 } else { 1.0 };
            let stations = stations
                .into_iter()
                .map(|(inertia, damping, ratio, back)| Station {
                    damping,
                    ratio: ratio * sign(back),
                    ..Station::new("s", StationKind::Other, inertia)
                })
                .collect();
            let shafts = shafts
                .into_iter()
                .enumerate()
                .map(|(i, (stiffness, damping, loss_factor, ratio, at))| Shaft {
                    damping,
                    loss_factor,
                    ratio,
                    ..Shaft::new("k", i + 1, at.index(i + 1), stiffness)
                })
                .collect();
            Chain::new(stations, shafts).unwrap()
        })
    })
}

proptest! {
    /// Maxwell and Betti: angle of a under a unit torque on b = angle of b under a unit torque on a, both at their own speeds.
    #[test]
    fn prop_reciprocity(chain in any_chain(), a in any::<prop::sample::Index>(), b in any::<prop::sample::Index>(), speed in 1.0..3000.0_f64) {
        let n = chain.stations().len();
        let (a, b) = (a.index(n), b.index(n));
        let forward = response(&chain, &unit(&chain, a, 0, 1), speed).unwrap().angles[b][0];
        let back = response(&chain, &unit(&chain, b, 0, 1), speed).unwrap().angles[a][0];
        prop_assert!((forward - back).norm() <= 1e-9 * forward.norm(), "{forward} and {back}: rounding of two eliminations");
    }

    /// Torques put in what dampers take, and every station is in balance.
    #[test]
    fn prop_energy_and_moment_balance(chain in any_chain(), at in any::<prop::sample::Index>(), speed in 1.0..3000.0_f64) {
        let at = at.index(chain.stations().len());
        let excitation = unit(&chain, at, 1, 2);
        let found = response(&chain, &excitation, speed).unwrap();
        let taken: f64 = found.angles.iter().enumerate().map(|(i, angle)| 0.5 * chain.stations()[i].damping * (2.0 * speed * angle[1].norm()).powi(2)).sum();
        prop_assert!((found.input - found.loss).abs() <= 1e-9 * found.input.abs() + 1e-12 * found.angles[at][1].norm() * speed);
        prop_assert!(taken <= found.loss * (1.0 + 1e-9) + 1e-300);
        let w = 2.0 * speed;
        for (i, station) in chain.stations().iter().enumerate() {
            let own = found.angles[i][1] * Complex64::new(-w * w * station.inertia, w * station.damping);
            let mut sum = if i == at { Complex64::new(1.0, 0.0) } else { Complex64::default() } - own;
            let mut size = own.norm() + 1.0;
            for (index, shaft) in chain.shafts().iter().enumerate() {
                // A shaft's torque at a station counts by the ratio of the two speeds.
                let seen = found.torques[index][1] * shaft.ratio / station.ratio;
                if shaft.from == i { sum -= seen; size += seen.norm(); }
                if shaft.to == i { sum += seen; size += seen.norm(); }
            }
            prop_assert!(sum.norm() <= 1e-8 * size, "station {i}: {sum} is left of {size}");
        }
    }
}

/// Two discs, one driven: phi = -T/(J w^2) of the whole far below resonance, and the closed form everywhere.
#[test]
fn two_discs_in_closed_form() {
    let (j, k) = ([0.03, 0.4], 5e4);
    let chain = Chain::plain(&j, &[k]).unwrap();
    let excitation = unit(&chain, 0, 0, 1);
    for w in [1.0, 300.0, 1300.0, 5000.0] {
        let found = response(&chain, &excitation, w).unwrap();
        let square = w * w;
        let determinant = (k - square * j[0]) * (k - square * j[1]) - k * k;
        let exact = (k - square * j[1]) / determinant;
        let angle = found.angles[0][0];
        assert!(
            (angle.re - exact).abs() < 1e-9 * exact.abs() && angle.im == 0.0,
            "{angle} instead of {exact}"
        );
    }
}

/// A pendulum of the order of the torque holds its carrier still.
#[test]
fn pendulum_takes_its_order_away() {
    let chain = Chain::plain(&[0.05, 0.5], &[1e5]).unwrap();
    let pendulum =
        Pendulum { station: 0, mass: 0.5, pivot_radius: 0.08, length: 0.02, number: 1, damping: 0.0 };
    let with = pendulum.on(&chain).unwrap();
    let excitation = unit(&with, 0, 1, 3);
    for speed in [50.0, 200.0, 900.0] {
        let found = response(&with, &excitation, speed).unwrap();
        let swing = 1.0 / (pendulum.mass * 0.08 * 0.02 * speed * speed) * 0.02 / 0.1;
        assert!(found.angles[0][1].norm() < 1e-10 * swing, "the carrier stands still at {speed} rad/s");
        // Of order 1 and others it is an inertia.
        let other = response(&with, &unit(&with, 0, 0, 3), speed).unwrap().angles[0][0];
        let inertia = pendulum.response(1.0)[1];
        let as_inertia = chain.with(|stations, _| stations[0].inertia += inertia).unwrap();
        let wanted = response(&as_inertia, &unit(&chain, 0, 0, 3), speed).unwrap().angles[0][0];
        assert!((other - wanted).norm() < 1e-9 * wanted.norm(), "{other} instead of {wanted}");
    }
}

/// Over speed: totals in true phase lie between the largest order and the sum of amplitudes; the balance holds.
#[test]
fn synthesis_is_between_largest_order_and_sum() {
    let stations: Vec<Station> = [
        (StationKind::Ring, 0.004),
        (StationKind::Nose, 0.003),
        (StationKind::Throw(0), 0.01),
        (StationKind::Throw(1), 0.01),
        (StationKind::Flywheel, 0.2),
    ]
    .into_iter()
    .map(|(kind, inertia)| Station { damping: 0.05, ..Station::new("s", kind, inertia) })
    .collect();
    let shafts = (0..4)
        .map(|i| Shaft {
            kind: if i == 0 { ShaftKind::Damper } else { ShaftKind::Shaft },
            damping: if i == 0 { 4.0 } else { 0.0 },
            loss_factor: if i == 0 { 0.0 } else { 0.01 },
            ..Shaft::new("k", i, i + 1, if i == 0 { 0.0 } else { 3e5 })
        })
        .collect();
    let chain = Chain::new(stations, shafts).unwrap();
    let source = |station: usize| {
        let orders: Vec<Complex64> = (0..12)
            .map(|k| Complex64::from_polar(200.0 / f64::from(k + 1), f64::from(k * k) + station as f64))
            .collect();
        Source {
            station,
            inertia: orders.iter().map(|t| t * 1e-5).collect(),
            gas: vec![TorqueAt { speed: 10.0, mean: 55.0, orders }],
        }
    };
    let excitation = Excitation { step: 0.5, count: 12, sources: vec![source(2), source(3)] };
    let speeds: Vec<f64> = (1..60).map(|i| 10.0 * f64::from(i)).collect();
    let found = sweep(&chain, &excitation, &speeds).unwrap();
    assert!(found.balance < 1e-9, "work in = work lost: {}", found.balance);
    for shaft in &found.shafts {
        for i in 0..speeds.len() {
            let largest = shaft.by_order.iter().map(|row| row[i]).fold(0.0, f64::max);
            assert!(shaft.total[i] <= shaft.sum[i] * (1.0 + 1e-9), "no more than the sum of amplitudes");
            // Half the spread of a periodic curve is at least pi/4 of any of its orders.
            assert!(shaft.total[i] >= 0.78 * largest, "{} against {largest}", shaft.total[i]);
        }
    }
    // All mean torque passes the last shaft, none the damper's.
    assert!((found.shafts[3].mean[5] - 110.0).abs() < 1e-9 && found.shafts[0].mean[5].abs() < 1e-9);
    let damper = found.damper.unwrap();
    assert_eq!(damper.power, found.shafts[0].loss);
    // The heat of the damper is c times the mean square of the relative speed.
    for (i, speed) in speeds.iter().enumerate() {
        let heat: f64 = damper
            .by_order
            .iter()
            .enumerate()
            .map(|(k, row)| 0.5 * 4.0 * (0.5 * (k + 1) as f64 * speed * row[i]).powi(2))
            .sum();
        assert!((heat - damper.power[i]).abs() < 1e-9 * heat, "heat at {speed} rad/s");
    }
}
