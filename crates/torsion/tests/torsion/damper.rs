//! Dampers of one mass against Den Hartog's closed forms.

use crate::forced::unit;
use lanchester_torsion::{
    Chain, Shaft, ShaftKind, Station, StationKind, TuneAim, TuneFree, TuneRequest, best_tuned, best_untuned,
    fixed_points, response, tune,
};

const J: f64 = 0.2;
const K: f64 = 5e4;

/// A ring of the share `mu` on a mass on a spring to what does not move.
fn one_mass(mu: f64, damping: f64, stiffness: f64) -> Chain {
    let stations = vec![
        Station::new("ring", StationKind::Ring, mu * J),
        Station::new("mass", StationKind::Nose, J),
        // So large that the rest does not move it: one part in 10^14.
        Station::new("ground", StationKind::Flywheel, J * 1e14),
    ];
    let damper = Shaft { kind: ShaftKind::Damper, damping, ..Shaft::new("damper", 0, 1, stiffness) };
    Chain::new(stations, vec![damper, Shaft::new("spring", 1, 2, K)]).unwrap()
}

fn request(free: TuneFree, natural: f64) -> TuneRequest {
    let speeds = (1..=120).map(|i| natural * (0.3 + 0.015 * f64::from(i))).collect();
    TuneRequest { aim: TuneAim::Twist, free, speeds, damping: None, stiffness: None, points: 41 }
}

#[test]
fn lit_den_hartog_untuned_damper() {
    let natural = (K / J).sqrt();
    for mu in [0.05, 0.1, 0.4, 1.0] {
        let exact = best_untuned(mu);
        let chain = one_mass(mu, 1.0, 0.0);
        let found = tune(&chain, &unit(&chain, 1, 0, 1), &request(TuneFree::Damping, natural)).unwrap();
        let damping = exact.damping * 2.0 * mu * J * natural;
        assert!(
            (found.damping / damping - 1.0).abs() < 1e-6,
            "mu {mu}: {} instead of {damping}",
            found.damping
        );
        assert!(
            (found.peak * K / exact.peak - 1.0).abs() < 1e-9,
            "mu {mu}: {} instead of {}",
            found.peak * K,
            exact.peak
        );
        let at = (2.0 / (2.0 + mu)).sqrt() * natural;
        assert!(
            (found.speed / at - 1.0).abs() < 1e-5,
            "mu {mu}: at {} instead of {at}: a flat top",
            found.speed
        );
        assert_eq!(found.minima, 1, "one minimum on the curve");
        assert!(!found.is_at_end && found.curve.iter().all(|point| point.peak >= found.peak));
        assert!(found.locked > 100.0 * found.peak, "without damping the mass swings without bound");
    }
}

#[test]
fn lit_den_hartog_fixed_points_of_a_tuned_damper() {
    let natural = (K / J).sqrt();
    for mu in [0.05, 0.2, 0.5] {
        let best = best_tuned(mu);
        let ring = mu * J * (best.tuning * natural).powi(2);
        for place in fixed_points(mu, best.tuning) {
            for share in [0.2, 1.0, 7.0] {
                let damping = share * best.damping * 2.0 * mu * J * natural;
                let chain = one_mass(mu, damping, ring);
                let found = response(&chain, &unit(&chain, 1, 0, 1), place * natural).unwrap();
                let height = K * (found.angles[1][0] - found.angles[2][0]).norm();
                assert!(
                    (height / best.peak - 1.0).abs() < 1e-6,
                    "mu {mu}: {height} instead of {} whatever the damping",
                    best.peak
                );
            }
        }
    }
}

#[test]
fn tuned_damper_found_is_a_little_above_the_fixed_points() {
    let natural = (K / J).sqrt();
    for mu in [0.1, 0.3] {
        let best = best_tuned(mu);
        let chain = one_mass(mu, 1.0, 1.0);
        let found = tune(&chain, &unit(&chain, 1, 0, 1), &request(TuneFree::Both, natural)).unwrap();
        let share = found.peak * K / best.peak;
        // The peaks lie 0.2 to 0.5 % above the fixed points.
        assert!(share > 1.0 && share < 1.005, "mu {mu}: {share}");
        let tuning = (found.stiffness / (mu * J)).sqrt() / natural;
        assert!((tuning / best.tuning - 1.0).abs() < 0.01, "mu {mu}: {tuning} near {}", best.tuning);
        let damping = found.damping / (2.0 * mu * J * natural);
        assert!((damping / best.damping - 1.0).abs() < 0.05, "mu {mu}: {damping} near {}", best.damping);
    }
}
