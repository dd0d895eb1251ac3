//! Holds computed loads against evidence and says where they differ.

use super::evidence::{Coefficient, Evidence, Range};
use lanchester_mechanism::Loads;
use lanchester_model::Engine;
use lanchester_results::{Extremes, OrderLoads};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Relative to the largest order of the quantity. Both sides are free of truncation (one closed form, the other Fourier
/// derivatives in extended precision), so that only rounding of the f64 side remains, some 1e-13; any mistake of
/// mechanics or of the layout is larger by many powers of ten.
const OF_LARGEST: f64 = 1e-11;
/// Relative to what the parts would exert if nothing cancelled: rounding where (nearly) all of it does, as in an
/// in-line six.
const OF_UNCANCELLED: f64 = 1e-13;
/// Dead centres [rad]. The kernel finds them from the motion's exact slope; 1e-6 rad is 0.00006 deg.
const ANGLE: f64 = 1e-6;

/// Everything in which `loads` differs from `evidence`.
pub fn mismatches(evidence: &Evidence, loads: &Loads) -> Vec<String> {
    let mut found = Vec::new();
    let mut expect = |what: String, ours: f64, theirs: f64, tolerance: f64| {
        let off = (ours - theirs).abs();
        if off.is_nan() || off > tolerance {
            found.push(format!(
                "{}: {what}: {ours:.12e}, independently {theirs:.12e} (off by {:.1e}, allowed {tolerance:.1e})",
                evidence.template,
                off
            ));
        }
    };
    expect("speed".into(), loads.speed, evidence.speed, 1e-12 * evidence.speed);
    expect(
        "period".into(),
        loads.period,
        TAU * f64::from(evidence.period_revolutions),
        1e-12 * evidence.period_revolutions as f64,
    );

    let force = tolerance(&evidence.force, evidence.uncancelled.force);
    let couple = tolerance(&evidence.couple, evidence.uncancelled.couple);
    // Torque and roll moment exchange what they have in common: one scale for both.
    let moment = tolerance(&evidence.roll_moment, evidence.uncancelled.moment)
        .max(tolerance(&evidence.shaft_torque, evidence.uncancelled.moment));

    for (name, theirs, tolerance, ours) in [
        (
            "force",
            &evidence.force,
            force,
            &two_sided(&loads.total.orders, |o| (o.force_forward, o.force_backward)),
        ),
        (
            "couple",
            &evidence.couple,
            couple,
            &two_sided(&loads.total.orders, |o| (o.couple_forward, o.couple_backward)),
        ),
        ("roll moment", &evidence.roll_moment, moment, &one_sided(&loads.total.orders, |o| o.roll_moment)),
        ("shaft torque", &evidence.shaft_torque, moment, &one_sided(&loads.total.orders, |o| o.shaft_torque)),
    ] {
        for coefficient in theirs {
            let value = ours.iter().find(|(order, _)| (order - coefficient.order).abs() < 1e-9);
            let value = match value {
                Some((_, value)) => *value,
                // A fraction that no part of the engine makes need not be listed; then it must vanish.
                None if coefficient.order.fract() != 0.0 => Complex64::default(),
                None => Complex64::new(f64::NAN, f64::NAN),
            };
            let off = (value - coefficient.value()).norm();
            expect(format!("{name}, order {:+}, |difference|", coefficient.order), off, 0.0, tolerance);
        }
        let unknown =
            ours.iter().filter(|(order, _)| !theirs.iter().any(|c| (order - c.order).abs() < 1e-9)).count();
        expect(format!("number of {name} orders without evidence"), unknown as f64, 0.0, 0.0);
    }

    let (ours, theirs) = (&loads.total.peaks, &evidence.peaks);
    expect("largest force".into(), ours.force.max.value, theirs.force, force);
    expect("largest couple".into(), ours.couple.max.value, theirs.couple, couple);
    let ranges: [(&str, &Extremes, &Range, f64); 6] = [
        ("F_x", &ours.force_x, &theirs.force_x, force),
        ("F_y", &ours.force_y, &theirs.force_y, force),
        ("M_x", &ours.couple_x, &theirs.couple_x, couple),
        ("M_y", &ours.couple_y, &theirs.couple_y, couple),
        ("M_z", &ours.roll_moment, &theirs.roll_moment, moment),
        ("T", &ours.shaft_torque, &theirs.shaft_torque, moment),
    ];
    for (name, ours, theirs, tolerance) in ranges {
        expect(format!("largest {name}"), ours.max.value, theirs.max, tolerance);
        expect(format!("smallest {name}"), ours.min.value, theirs.min, tolerance);
    }

    expect("number of cylinders".into(), loads.motion.len() as f64, evidence.cylinders.len() as f64, 0.0);
    for (ours, theirs) in loads.motion.iter().zip(&evidence.cylinders) {
        let what = |quantity: &str| format!("cylinder {}: {quantity}", theirs.cylinder);
        expect(what("number"), ours.cylinder as f64, theirs.cylinder as f64, 0.0);
        expect(what("TDC"), turn(ours.top_dead_centre - theirs.top_dead_centre), 0.0, ANGLE);
        expect(what("BDC"), turn(ours.bottom_dead_centre - theirs.bottom_dead_centre), 0.0, ANGLE);
        expect(what("stroke"), ours.stroke, theirs.stroke, 1e-12 * theirs.top);
        expect(what("top"), ours.top, theirs.top, 1e-12 * theirs.top);
    }
    found
}

/// Every cylinder fires where its layout says: in the order and at the intervals claimed, each at its own TDC.
pub fn firing_mismatches(evidence: &Evidence, engine: &Engine, loads: &Loads) -> Vec<String> {
    let fires: Vec<Option<f64>> = engine.cylinders.iter().map(|c| c.firing_angle).collect();
    let Some(claimed) = &evidence.firing else {
        return fires
            .iter()
            .flatten()
            .map(|f| format!("{}: fires at {f}, unclaimed", evidence.template))
            .collect();
    };
    let mut found = Vec::new();
    if engine.strokes.revolutions() * 2 != evidence.strokes {
        found.push(format!("{}: {:?} strokes", evidence.template, engine.strokes));
    }
    let cycle = TAU * f64::from(engine.strokes.revolutions());
    let Some(first) = fires[0] else {
        return vec![format!("{}: cylinder 1 does not fire", evidence.template)];
    };
    // The file's angle is the nominal one; offsets, articulation and a lead shift the true dead centre.
    let slack = 2.0 * evidence.firing_slack_deg.to_radians() + 1e-9;
    let mut order: Vec<(f64, usize)> = Vec::new();
    for (index, fires) in fires.iter().enumerate() {
        let (number, motion) = (index + 1, &loads.motion[index]);
        let (Some(fires), Some(tdc)) = (fires, motion.firing_angle) else {
            found.push(format!("{}: cylinder {number} does not fire", evidence.template));
            continue;
        };
        let claim = claimed.iter().find(|f| f.cylinder == number).expect("evidence covers every cylinder");
        let after = (fires - first).rem_euclid(cycle);
        order.push((if cycle - after < 1e-9 { 0.0 } else { after }, number));
        let off_claim = around(fires - first - claim.angle_deg.to_radians(), cycle).abs();
        // Equal pistons of one chamber enclose least half-way between their own dead centres.
        let tops: Vec<f64> = engine
            .chamber_pistons(index)
            .into_iter()
            .map(|piston| loads.motion[piston].top_dead_centre)
            .collect();
        let apart = |top: &f64| turn(top - motion.top_dead_centre);
        let top = motion.top_dead_centre + tops.iter().map(apart).sum::<f64>() / tops.len() as f64;
        let off_tdc = turn(tdc - top).abs();
        let off_nominal = around(tdc - fires, cycle).abs();
        let agrees = off_claim <= slack && off_nominal <= slack && off_tdc <= ANGLE;
        if !agrees {
            found.push(format!(
                "{}: cylinder {number} fires {:.4} deg after cylinder 1, claimed {}; its TDC is {off_nominal} rad away in \
                 the cycle, {off_tdc} rad in the revolution",
                evidence.template,
                after.to_degrees(),
                claim.angle_deg
            ));
        }
    }
    order.sort_by(|a, b| a.0.total_cmp(&b.0));
    // Cylinders that fire together (a radial's rows, a twin's pair) may stand in either order.
    let position = |number: usize| claimed.iter().find(|f| f.cylinder == number).map(|f| f.angle_deg);
    if order.windows(2).any(|pair| position(pair[0].1) > position(pair[1].1)) {
        found.push(format!("{}: fires in the order {:?}", evidence.template, order));
    }
    found
}

fn tolerance(orders: &[Coefficient], uncancelled: f64) -> f64 {
    let largest = orders.iter().map(|c| c.value().norm()).fold(0.0, f64::max);
    OF_LARGEST * largest + OF_UNCANCELLED * uncancelled
}

fn two_sided(
    orders: &[OrderLoads],
    pick: impl Fn(&OrderLoads) -> (Complex64, Complex64),
) -> Vec<(f64, Complex64)> {
    let mut list = Vec::new();
    for order in orders {
        let (forward, backward) = pick(order);
        if order.order > 0.0 {
            list.extend([(order.order, forward), (-order.order, backward)]);
        } else {
            // Order 0 has its whole mean in the forward part.
            list.push((0.0, forward + backward));
        }
    }
    list
}

fn one_sided(orders: &[OrderLoads], pick: impl Fn(&OrderLoads) -> Complex64) -> Vec<(f64, Complex64)> {
    orders.iter().map(|order| (order.order, pick(order))).collect()
}

/// The angle in (-pi, pi].
fn turn(angle: f64) -> f64 {
    around(angle, TAU)
}

/// The remainder nearest to 0.
fn around(angle: f64, period: f64) -> f64 {
    angle - period * (angle / period).round()
}
