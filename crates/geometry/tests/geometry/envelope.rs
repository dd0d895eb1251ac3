//! The best counterweight within an envelope that is a radius by direction: against random designs and against a circle.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::support::random_design::{Stream, paper, random_design, violation};
use lanchester_geometry::clearance::RadialEnvelope;
use lanchester_geometry::{
    Design, DesignLimits, DesignOutcome, DesignSettings, DesignTask, Objective, Optimum, Range, Shoulder,
    design, design_within, front_within, largest_balance,
};
use std::f64::consts::FRAC_PI_2;

fn task() -> DesignTask {
    DesignTask {
        unbalance: 8.876e-2,
        least_balance: 1.0,
        most_balance: None,
        density: 7850.0,
        web_radius: Range::fixed(0.046),
        rectangle_height: Range::new(0.0, 0.04),
        shoulder: Shoulder::Height(Range::new(0.0, 0.04)),
        arc_radius: Range::new(0.06, 0.12),
        arc_angle: Range::new(1.0, 3.5),
        thickness: Range::new(0.015, 0.03),
        limits: DesignLimits::default(),
        settings: DesignSettings::default(),
    }
}

/// Radii at 46 directions.
fn envelope(radius: impl Fn(f64) -> f64) -> RadialEnvelope {
    let directions: Vec<f64> = (0..46).map(|at| FRAC_PI_2 * f64::from(at) / 45.0).collect();
    let radii = directions.iter().map(|at| radius(*at)).collect();
    RadialEnvelope { directions, radii, least: 0.0, limit: None }
}

/// A dip beside the middle, as a piston makes it that meets a counterweight off its line, then more and more room.
fn dipped() -> RadialEnvelope {
    envelope(|at| 0.0925 + 0.004 * (at - 0.5).abs().min(0.6))
}

/// How far a design passes the envelope at most [m], by many points of its arc.
fn beyond(envelope: &RadialEnvelope, design: &Design) -> f64 {
    let shape = &design.shape;
    let mut most = f64::NEG_INFINITY;
    for part in 0..=100 {
        let angle = shape.arc_angle / 2.0 * f64::from(part) / 100.0;
        let x = shape.centre_distance() + shape.arc_radius * angle.cos();
        let y = shape.arc_radius * angle.sin();
        let at = y.atan2(x).min(FRAC_PI_2);
        let step = envelope.directions[1];
        let left = ((at / step) as usize).min(44);
        let share = at / step - left as f64;
        let allowed = envelope.radii[left] * (1.0 - share) + envelope.radii[left + 1] * share;
        most = most.max(x.hypot(y) - allowed);
    }
    most
}

fn found(outcome: DesignOutcome) -> Optimum {
    match outcome {
        DesignOutcome::Found(best) => *best,
        DesignOutcome::Infeasible(why) => panic!("{why:?}"),
    }
}

#[test]
fn xcheck_a_round_envelope_is_a_limit_of_the_swept_radius() {
    let round = envelope(|_| 0.07);
    let limits = DesignLimits { swept_radius: Some(0.07), ..DesignLimits::default() };
    let by_limit = found(design(&DesignTask { limits, ..paper() }, Objective::Mass).unwrap());
    let by_envelope = found(design_within(&paper(), Objective::Mass, Some(&round)).unwrap());
    assert!(
        by_envelope.proved && (by_limit.value / by_envelope.value - 1.0).abs() < DesignSettings::PROVED_GAP
    );
    let round = envelope(|_| 0.0925);
    let limits = DesignLimits { swept_radius: Some(0.0925), ..DesignLimits::default() };
    for objective in [Objective::Mass, Objective::Inertia, Objective::Thickness] {
        let by_limit = found(design(&DesignTask { limits, ..task() }, objective).unwrap());
        let by_envelope = found(design_within(&task(), objective, Some(&round)).unwrap());
        assert!(by_envelope.proved && by_limit.proved);
        assert!(
            (by_limit.value / by_envelope.value - 1.0).abs() < DesignSettings::PROVED_GAP,
            "{objective:?}"
        );
    }
}

#[test]
fn prop_no_random_design_within_the_envelope_is_better() {
    let envelope = dipped();
    // A shape keeps the envelope between its directions to within the bend over two degrees.
    let between = 2e-5;
    for objective in [Objective::Mass, Objective::Inertia, Objective::Thickness] {
        let best = found(design_within(&task(), objective, Some(&envelope)).unwrap());
        assert!(best.proved, "{best:?}");
        assert!(violation(&task(), &best.design) < 1e-9);
        assert!(beyond(&envelope, &best.design) < between, "{}", beyond(&envelope, &best.design));
        // It uses what a circle would not give.
        let round = self::envelope(|_| envelope.smallest());
        let by_circle = found(design_within(&task(), objective, Some(&round)).unwrap());
        assert!(best.value < by_circle.value * (1.0 - 1e-3), "{} {}", best.value, by_circle.value);
        let (mut stream, mut feasible, mut closest) = (Stream(17), 0, f64::INFINITY);
        for _ in 0..150_000 {
            let Some(random) = random_design(&task(), &mut stream) else { continue };
            if violation(&task(), &random) > 0.0 || beyond(&envelope, &random) > -between {
                continue;
            }
            feasible += 1;
            closest = closest.min(random.value(objective) / best.value);
        }
        assert!(feasible > 100, "{feasible}");
        assert!(closest > 1.0 - DesignSettings::PROVED_GAP && closest < 1.2, "{objective:?} {closest}");
    }
}

#[test]
fn a_front_is_found_within_the_envelope_for_every_pair() {
    let envelope = dipped();
    for against in [Objective::SweptRadius, Objective::Inertia, Objective::Thickness] {
        let front = front_within(&task(), [Objective::Mass, against], 12, Some(&envelope)).unwrap();
        assert!(front.proved && !front.designs.is_empty(), "{against:?} {front:?}");
        for design in &front.designs {
            assert!(beyond(&envelope, design) < 2e-5, "{against:?} {design:?}");
            assert!((design.balance - 1.0).abs() < 1e-9);
        }
    }
}

#[test]
fn the_largest_unbalance_is_the_most_that_can_be_asked_for() {
    for envelope in [Some(dipped()), Some(envelope(|_| 0.08)), None] {
        let most = largest_balance(&task(), envelope.as_ref()).unwrap().unwrap();
        let asked = |part: f64| {
            let task = DesignTask { unbalance: part * most.unbalance, ..task() };
            design_within(&task, Objective::Mass, envelope.as_ref()).unwrap()
        };
        assert!(matches!(asked(1.0 - 1e-5), DesignOutcome::Found(_)), "{most:?}");
        let DesignOutcome::Infeasible(why) = asked(1.0 + 1e-5) else { panic!("{most:?}") };
        assert!(why.proved);
    }
    // Nothing is within a web's own radius.
    assert!(largest_balance(&task(), Some(&envelope(|_| 0.04))).unwrap().is_none());
}
