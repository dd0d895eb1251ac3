//! Nothing to do, more equations than needed, weights that are tied, bounded, on lines or in one plane.

use crate::cancellation::support::*;
use lanchester_balance::*;
use lanchester_model::*;
use lanchester_task::*;
use std::f64::consts::{FRAC_PI_2, PI};

const FORCE_1: (Load, f64) = (Load::Force, 1.0);
const COUPLE_1: (Load, f64) = (Load::Couple, 1.0);

/// What a single cylinder's crank weight must be for the part that turns with the crank [kg m].
fn forward(engine: &Engine) -> f64 {
    let (reciprocating, big_end) = masses(engine);
    engine.throws[0].unbalance + big_end + 0.5 * reciprocating
}

/// A single cylinder with a weight on the crank and a shaft against it.
fn single(cancel: &[(Load, f64)]) -> (Engine, BalanceTask) {
    let mut task = task(on_crank(&[0.0]), cancel);
    add_shaft(&mut task, -1, 0.0, 0.0, &[0.0]);
    (stripped("single"), task)
}

#[test]
fn nothing_is_needed_where_nothing_is_there() {
    let engine = stripped("in-line-6");
    let planes: Vec<f64> = engine.throws.iter().map(|t| t.z).collect();
    let answer = optimise(&engine, &beside_crank(&planes, &[FORCE_1, COUPLE_1])).unwrap();
    assert_eq!(assert_vanishes(&engine, &answer), 0.0);
    assert!(answer.weights.iter().all(|w| !w.used), "{:?}", answer.weights);
    // An order that no part of the engine has.
    let answer = optimise(&engine, &task(on_crank(&planes), &[(Load::Force, 3.7)])).unwrap();
    assert_eq!(assert_vanishes(&engine, &answer), 0.0);
}

#[test]
fn equations_said_twice_change_nothing() {
    let (engine, once) = single(&[FORCE_1]);
    let (_, twice) = single(&[FORCE_1, FORCE_1, (Load::ForceX, 1.0), (Load::ForceY, 1.0), COUPLE_1]);
    let once = assert_vanishes(&engine, &optimise(&engine, &once).unwrap());
    let answer = optimise(&engine, &twice).unwrap();
    let CancellationVerdict::Vanish { total, lightest, .. } = &cancellation(&answer).verdict else {
        panic!("{answer:#?}")
    };
    close(*total, once, 1e-10, "total");
    close(lightest.value, once, 1e-8, "bound");
}

#[test]
fn more_planes_than_needed_take_the_longest_lever() {
    let mut engine = stripped("v2-90");
    engine = engine
        .with(|engine| {
            engine.cylinders.iter_mut().for_each(|c| c.z = engine.throws[c.throw].z);
        })
        .unwrap();
    // A couple from a weight that is set 10 mm off: only the farthest planes carry it.
    let mut off = engine.clone();
    let weight = |z| Counterweight {
        name: format!("off {z}"),
        crankshaft: 0,
        z,
        unbalance: 0.01,
        angle: 0.3,
        part: None,
    };
    off = off
        .with(|off| {
            off.counterweights.extend([weight(0.01), Counterweight { angle: 0.3 + PI, ..weight(-0.01) }]);
        })
        .unwrap();
    let planes = [-0.05, -0.02, 0.0, 0.03, 0.08];
    let answer = optimise(&off, &task(on_crank(&planes), &[COUPLE_1])).unwrap();
    let total = assert_vanishes(&off, &answer);
    close(total, 0.01 * 0.02 / 0.08, 1e-8, "all in the farthest plane");
    // With the force held at nothing too, the two ends share it.
    let mut engine_forward = off.clone();
    let crank =
        masses(&engine).0 + 2.0 * masses(&engine).1 + engine.throws.iter().map(|t| t.unbalance).sum::<f64>();
    engine_forward = engine_forward
        .with(|engine_forward| {
            engine_forward.counterweights.push(Counterweight {
                name: "classical".into(),
                crankshaft: 0,
                z: 0.0,
                unbalance: crank,
                angle: engine.throws[0].angle + PI,
                part: None,
            });
        })
        .unwrap();
    let answer = optimise(&engine_forward, &task(on_crank(&planes), &[FORCE_1, COUPLE_1])).unwrap();
    let total = assert_vanishes(&engine_forward, &answer);
    close(total, 2.0 * 0.01 * 0.02 / 0.13, 1e-8, "the ends");
}

#[test]
fn weights_that_are_too_small_are_named_in_the_proof() {
    let (engine, mut bounded) = single(&[FORCE_1]);
    let needed = forward(&engine);
    bounded.weights[0].most = Some(0.6 * needed);
    let answer = optimise(&engine, &bounded).unwrap();
    let proofs = assert_cannot(&engine, &answer);
    assert_eq!(proofs.len(), 1);
    let charges = &proofs[0].functional.charges;
    assert_eq!(charges.len(), 1);
    assert_eq!(charges[0].0, "crank 1");
    // The functional is what stays: 40 % of the part with the crank, over itself.
    close(charges[0].1, 0.6 / 0.4, 1e-6, "charge");
    assert!(proofs[0].reason.contains("`crank 1` no larger than allowed"), "{}", proofs[0].reason);
    let left = cancellation(&answer).orders[0].left;
    close(left, 0.4 * needed * engine.speed.highest.powi(2), 1e-7, "left");
    // A largest amount that is just enough is no obstacle; its price is nothing where it does not press.
    bounded.weights[0].most = Some(1.001 * needed);
    assert_vanishes(&engine, &optimise(&engine, &bounded).unwrap());
}

#[test]
fn a_largest_amount_has_a_price_in_the_total() {
    // The couple of an in-line three goes to the outer planes; bounded ones leave the rest to a shorter lever.
    let engine = stripped("in-line-3");
    let make = |most: f64| {
        let mut task = beside_crank(&[-0.1, -0.06, 0.06, 0.1], &[FORCE_1, COUPLE_1]);
        for weight in [0, 3] {
            task.weights[weight].most = Some(most);
        }
        add_shaft(&mut task, -1, 0.0, 0.1, &[-0.1, 0.1]);
        task
    };
    let free = optimise(&engine, &make(10.0)).unwrap();
    let whole = free.weights[0].unbalance.norm();
    let at = |most: f64| optimise(&engine, &make(most)).unwrap();
    let tight = at(0.7 * whole);
    let total = assert_vanishes(&engine, &tight);
    assert!(total > assert_vanishes(&engine, &free));
    let step = 1e-3 * whole;
    let slope = (assert_vanishes(&engine, &at(0.7 * whole - step)) - total) / step;
    // Both ends are bounded alike: their prices together.
    let prices: f64 = tight.limits.iter().map(|l| l.price).sum();
    close(prices, slope, 1e-5, "price");
    // Two inner weights carry 10 / 6 of what an outer pair gives up.
    close(prices, 2.0 * (10.0 / 6.0 - 1.0), 1e-6, "by levers");
}

#[test]
fn lines_and_directions_are_kept_or_refused() {
    let (engine, free) = single(&[FORCE_1]);
    let best = optimise(&engine, &free).unwrap();
    let total = assert_vanishes(&engine, &best);
    let directions: Vec<f64> = best.weights.iter().map(|w| w.unbalance.arg()).collect();
    let with = |phase: fn(f64) -> Phase| {
        let mut task = free.clone();
        task.weights.iter_mut().zip(&directions).for_each(|(w, d)| w.phase = phase(*d));
        optimise(&engine, &task).unwrap()
    };
    close(assert_vanishes(&engine, &with(Phase::Direction)), total, 1e-9, "along the right direction");
    close(assert_vanishes(&engine, &with(Phase::Line)), total, 1e-9, "along the right line");
    close(assert_vanishes(&engine, &with(|d| Phase::Line(d + PI))), total, 1e-9, "line turned by half");
    for wrong in [with(|d| Phase::Direction(d + PI)), with(|d| Phase::Line(d + FRAC_PI_2))] {
        assert_cannot(&engine, &wrong);
        // The wrong directions are no help at all.
        let order = &cancellation(&wrong).orders[0];
        close(order.left, order.without, 1e-7, "left");
    }
}

#[test]
fn tied_weights_move_together() {
    let engine = stripped("in-line-3");
    let mut tied = task(on_crank(&[-0.1, 0.1]), &[COUPLE_1, FORCE_1]);
    add_shaft(&mut tied, -1, 0.0, 0.1, &[-0.15, 0.15]);
    let free = assert_vanishes(&engine, &optimise(&engine, &tied).unwrap());
    tied.ties = vec![Tie { first: 2, second: 3, factor: -1.0, mirrored: false }];
    close(assert_vanishes(&engine, &optimise(&engine, &tied).unwrap()), free, 1e-9, "opposed as they are");
    tied.ties[0].factor = 1.0;
    let answer = optimise(&engine, &tied).unwrap();
    let proofs = assert_cannot(&engine, &answer);
    let sense = |p: &Obstruction| p.functional.terms.iter().all(|t| t.sense == OrderSense::Backward);
    assert!(proofs.iter().all(sense), "{proofs:#?}");
}

#[test]
fn masses_prefer_long_radii() {
    // The same couple by two pairs of planes: lever times radius decides.
    let engine = stripped("in-line-3");
    let mut by_mass = beside_crank(&[-0.1, -0.08, 0.08, 0.1], &[FORCE_1, COUPLE_1]);
    add_shaft(&mut by_mass, -1, 0.0, 0.1, &[-0.15, 0.15]);
    by_mass.weights.iter_mut().for_each(|w| w.radius = Some(0.04));
    let outer = optimise(&engine, &by_mass).unwrap();
    assert_vanishes(&engine, &outer);
    assert!(
        outer.weights[0].used && !outer.weights[1].used && !outer.weights[2].used && outer.weights[3].used
    );
    by_mass.weights[1].radius = Some(0.06);
    by_mass.weights[2].radius = Some(0.06);
    let inner = optimise(&engine, &by_mass).unwrap();
    assert_vanishes(&engine, &inner);
    assert!(
        !inner.weights[0].used && inner.weights[1].used && inner.weights[2].used && !inner.weights[3].used
    );
}

#[test]
fn two_weights_in_one_plane_on_two_lines() {
    let engine = stripped("v2-90");
    let mut crossed = task(on_crank(&[0.0, 0.0]), &[FORCE_1]);
    crossed.weights[0].phase = Phase::Line(0.0);
    crossed.weights[1].phase = Phase::Line(FRAC_PI_2);
    let total = assert_vanishes(&engine, &optimise(&engine, &crossed).unwrap());
    let free = optimise(&engine, &task(on_crank(&[0.0]), &[FORCE_1])).unwrap();
    let whole = free.weights[0].unbalance;
    close(total, whole.re.abs() + whole.im.abs(), 1e-9, "its two components");
}

#[test]
fn what_exact_cancellation_does_not_know_is_refused() {
    let (engine, plain) = single(&[FORCE_1]);
    let refused = |change: &dyn Fn(&mut BalanceTask)| {
        let mut task = plain.clone();
        change(&mut task);
        optimise(&engine, &task).expect_err("refused").to_string()
    };
    let between = Place::Between(-0.01, 0.01);
    assert!(
        refused(&|t| (t.weights[0].z, t.weights[0].most) = (between, Some(1.0))).contains("given planes")
    );
    assert!(refused(&|t| t.shafts[0].x = between).contains("needs"));
    assert!(refused(&|t| t.weights[0].least = 1e-3).contains("least"));
    assert!(refused(&|t| t.most_optional = Some(1)).contains("optional"));
    let couple = Stage { terms: vec![(1.0, Criterion::Peak(Load::Couple))] };
    assert!(refused(&|t| t.stages = vec![couple.clone()]).contains("alone"));
    assert!(refused(&|t| t.cancel = vec![(Load::Force, 0.0)]).contains("above 0"));
    assert!(refused(&|t| t.cancel = vec![(Load::BendingMoment, 1.0)]).contains("block"));
    assert!(refused(&|t| t.cancel = vec![(Load::LargestMountForce, 1.0)]).contains("mounts"));
}

#[test]
fn an_inertia_takes_the_roll_moment_it_can() {
    // Without gas an in-line four's order 2 of the roll moment is the crank train's torque alone but for the rods.
    let engine = stripped("in-line-4");
    let mut heron = task(Vec::new(), &[(Load::RollMoment, 2.0)]);
    heron.inertias = vec![FreeInertia {
        name: "heron".into(),
        ratio: 1.0,
        crank_inertia: 0.2,
        most: None,
        optional: false,
    }];
    let answer = optimise(&engine, &heron).unwrap();
    let order = &cancellation(&answer).orders[0];
    match &cancellation(&answer).verdict {
        CancellationVerdict::Vanish { total, .. } => {
            assert_eq!(*total, 0.0);
            assert!(order.left <= 1e-9 * order.without, "{order:?}");
            assert!(answer.inertias[0].inertia > 0.0);
        }
        CancellationVerdict::CannotVanish { obstructions } => {
            panic!("{obstructions:#?} {:#?}", answer.inertias)
        }
    }
}
