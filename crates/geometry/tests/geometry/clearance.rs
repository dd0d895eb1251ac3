//! Clearances against closed forms, and against dense samples in space.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::support::hand_made::{
    BORE, LENGTH, RADIUS, Slider, TURN, counterweight, crankshaft, cylinder, distance_in_space, engine,
    liner, parts, rod_envelope, sampled, sector, skirt, throw,
};
use lanchester_geometry::clearance::{
    CLEARANCE_GAP, Clearance, ClearanceError, ClearanceModel, Clearances, DepthAlong, Obstacle,
};
use lanchester_geometry::{Chamfer, Contour, Corner, Cut, Face, Outline, Point};
use lanchester_model::{CrankBody, Engine, Envelope};
use lanchester_testkit::{Within, assert_close};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

fn model(engine: &Engine) -> ClearanceModel<'_, Slider> {
    ClearanceModel::new(engine, Slider::all(engine)).unwrap()
}

fn all(engine: &Engine) -> Clearances {
    model(engine).clearances().unwrap()
}

fn to(found: &Clearances, obstacle: Obstacle) -> Clearance {
    found.bodies[0].clearances.iter().find(|c| c.obstacle == obstacle).unwrap().clone()
}

const PISTON: Obstacle = Obstacle::Piston { cylinder: 1 };
const LINER: Obstacle = Obstacle::Liner { cylinder: 1 };
const ROD: Obstacle = Obstacle::Rod { cylinder: 1 };
const SIDE: Obstacle = Obstacle::BigEndSide { cylinder: 1 };

/// A search ends this far above its bound, which rounding may pass by some more [m].
const GAP: f64 = CLEARANCE_GAP + 1e-12;

#[track_caller]
fn near(quantity: &str, got: f64, wanted: f64, tolerance: f64) {
    assert_close(
        quantity,
        got,
        wanted,
        Within::absolute(tolerance, "the gap that the search proves, or rounding"),
    );
}

/// One cylinder with a sector against its crankpin beside the rod.
fn single(radius: f64, envelope: Envelope) -> Engine {
    let weight = counterweight(sector(radius, 1.2), [0.012, 0.028], Some(1));
    engine(vec![cylinder(0, 0.0, 0.0)], vec![weight]).with(|parts| parts.envelope = Some(envelope)).unwrap()
}

#[test]
fn a_round_counterweight_is_nearest_to_the_skirt_at_bottom_dead_centre() {
    let envelope = Envelope { least: Some(0.001), skirt: skirt(0.03, None), ..Envelope::default() };
    let engine = single(0.065, envelope);
    let found = to(&all(&engine), PISTON);
    let wanted = LENGTH - RADIUS - 0.03 - 0.065;
    near("distance", found.distance, wanted, GAP);
    near("bound", found.bound, wanted, GAP);
    assert!(found.bound <= found.distance && found.distance - found.bound <= GAP);
    // The distance grows with the square of the angle: s'' = r (1 - r/l ..), 1e-7 m are less than 3e-3 rad.
    near("angle", found.theta.unwrap(), PI, 3e-3);
    near("height on the counterweight", found.on_body[0], 0.065, 1e-6);
    near("height on the skirt", found.on_obstacle[0], LENGTH - RADIUS - 0.03, 1e-6);
    assert!(found.is_kept && found.overlap.is_none());
    assert!(!all(&single(0.0692, envelope)).is_kept);
}

#[test]
fn an_offset_moves_the_nearest_place_to_the_true_bottom_dead_centre() {
    let envelope = Envelope { skirt: skirt(0.03, None), ..Envelope::default() };
    let mut engine = single(0.065, envelope);
    engine = engine
        .with(|engine| {
            engine.cylinders[0].offset = 0.008;

            engine.cylinders[0].pin_offset = -0.002;
        })
        .unwrap();
    let found = to(&all(&engine), PISTON);
    let bottom = ((LENGTH - RADIUS).powi(2) - 0.006f64.powi(2)).sqrt();
    // The crown passes straight below the lower edge, since the skirt reaches over the axis.
    near("distance", found.distance, bottom - 0.03 - 0.065, GAP);
    near("angle", found.theta.unwrap(), PI + (0.006f64 / (LENGTH - RADIUS)).asin(), 4e-3);
}

#[test]
fn beside_the_piston_the_gap_along_the_crank_counts() {
    let envelope = Envelope { skirt: skirt(0.06, Some(0.02)), ..Envelope::default() };
    // 12 mm from the axis against a piston that is 10 mm wide to each side, which it passes.
    let found = to(&all(&single(0.065, envelope)), PISTON);
    near("distance", found.distance, 0.002, GAP);
    near("along the crank", found.on_body[2] - found.on_obstacle[2], 0.002, 1e-12);
}

#[test]
fn the_own_rod_passes_beside_the_web() {
    let envelope = Envelope { least: Some(0.004), rod: rod_envelope(), ..Envelope::default() };
    let mut engine = single(0.065, envelope);
    let found = all(&engine);
    // The shank crosses the axis: 12 mm to the plate, half of 14 mm thick.
    near("shank", to(&found, ROD).distance, 0.005, GAP);
    // The sector ends on the axis, 10 mm off the big end's disc in the plane and 2 mm along the crank, at all angles.
    let side = to(&found, SIDE);
    near("side", side.distance, 0.01f64.hypot(0.002), GAP);
    assert!(side.theta.is_none() && side.is_kept && found.is_kept);
    near("smallest", found.smallest.unwrap().clearance.distance, 0.005, GAP);
    // With a whole disc for a web, the big end lies within its outline.
    let disc: Outline = Contour::circle(Point::ORIGIN, 0.08).unwrap().into();
    engine = engine
        .with(|engine| {
            engine.counterweights[0] = counterweight(disc.clone(), [0.012, 0.028], Some(1));
        })
        .unwrap();
    near("side of a disc", to(&all(&engine), SIDE).distance, 0.002, GAP);
    // Nearer than the big end is wide, it is in the way at every angle.
    engine = engine
        .with(|engine| {
            engine.counterweights[0] = counterweight(disc, [0.009, 0.028], Some(1));
        })
        .unwrap();
    let found = all(&engine);
    let overlap = to(&found, SIDE).overlap.unwrap();
    near("depth", overlap.depth, 0.001, 1e-12);
    assert_eq!((overlap.along, overlap.angles.len(), found.is_kept), (DepthAlong::Crank, 1, false));
    near("all angles", overlap.angles[0][1] - overlap.angles[0][0], TURN, 1e-9);
    assert_eq!(found.smallest.unwrap().clearance.obstacle, SIDE);
}

#[test]
fn webs_and_big_ends_turn_within_the_crankcase() {
    let envelope = Envelope {
        crankcase_radius: Some(0.072),
        rod: rod_envelope(),
        least: Some(0.002),
        ..Envelope::default()
    };
    let mut engine = single(0.065, envelope);
    let found = all(&engine);
    near("counterweight", to(&found, Obstacle::Crankcase).distance, 0.007, 1e-15);
    near("big end", found.big_ends[0].clearance.distance, 0.002, 1e-15);
    assert!(found.is_kept && to(&found, Obstacle::Crankcase).theta.is_none());
    // The web's round end about the crankpin reaches farther than the counterweight.
    engine = engine
        .with(|engine| {
            engine.crank_body = Some(CrankBody {
                density: 7850.0,
                journal_diameter: 0.05,
                journal_bore: 0.0,
                pin_diameter: 0.045,
                pin_bore: 0.0,
                web_thickness: 0.016,
                web_radius: 0.035,
                pin_end_radius: 0.034,
                end_journals: [0.02; 2],
            });
        })
        .unwrap();
    let found = all(&engine);
    let names: Vec<&str> = found.bodies.iter().map(|body| body.name.as_str()).collect();
    assert_eq!(names, ["counterweight", "web 1"]);
    for body in &found.bodies {
        near("swept radius", body.swept_radius, 0.074, 1e-12);
        let overlap = body.clearances[0].overlap.clone().unwrap();
        near("depth", overlap.depth, 0.002, 1e-12);
        assert_eq!(overlap.along, DepthAlong::Radius);
    }
}

#[test]
fn a_plate_through_the_wall_of_the_liner_meets_its_lower_end() {
    // The plate reaches from within the tube through its wall, so that the tube's end is straight above the crank.
    let envelope = Envelope { liner: liner(0.07, 0.005), ..Envelope::default() };
    let weight = counterweight(sector(0.065, 1.2), [0.03, 0.05], None);
    let engine = engine(vec![cylinder(0, 0.0, 0.0)], vec![weight])
        .with(|parts| parts.envelope = Some(envelope))
        .unwrap();
    let found = to(&all(&engine), LINER);
    near("distance", found.distance, 0.005, GAP);
}

#[test]
fn a_skirt_in_the_way_is_told_with_angles_and_depth() {
    let envelope = Envelope { skirt: skirt(0.04, None), ..Envelope::default() };
    let engine = single(0.065, envelope);
    let found = to(&all(&engine), PISTON);
    assert_eq!((found.distance, found.bound, found.is_kept), (0.0, 0.0, false));
    let overlap = found.overlap.clone().unwrap();
    let edge = LENGTH - RADIUS - 0.04;
    near("depth", overlap.depth, 0.065 - edge, GAP);
    assert!(overlap.depth_bound >= overlap.depth && overlap.depth_bound <= overlap.depth + GAP);
    assert_eq!((overlap.along, overlap.angles.len()), (DepthAlong::Cylinder, 1));
    near("deepest", found.theta.unwrap(), PI, 3e-3);
    near("lower edge", found.on_obstacle[0], edge, 1e-6);
    // The crown stays over the axis for 1.2 rad: the edge is at the swept radius where s = 0.065 + 0.04.
    let s: f64 = 0.105;
    let from = ((s * s + RADIUS * RADIUS - LENGTH * LENGTH) / (2.0 * RADIUS * s)).acos();
    near("first angle", overlap.angles[0][0], from, 2e-6);
    near("last angle", overlap.angles[0][1], TURN - from, 2e-6);
}

#[test]
fn a_liner_in_the_way_is_told_with_angles_and_depth() {
    let envelope = Envelope { liner: liner(0.06, 0.005), ..Envelope::default() };
    let weight = counterweight(sector(0.065, 1.2), [0.03, 0.05], None);
    let engine = engine(vec![cylinder(0, 0.0, 0.0)], vec![weight])
        .with(|parts| parts.envelope = Some(envelope))
        .unwrap();
    let overlap = to(&all(&engine), LINER).overlap.unwrap();
    near("depth", overlap.depth, 0.005, GAP);
    // Some part of the arc is above the end while its middle is within 1.2 rad and acos(60/65) of the cylinder axis.
    let half = 1.2 + (0.06f64 / 0.065).acos();
    assert_eq!(overlap.angles.len(), 1);
    near("first angle", overlap.angles[0][0], PI - half, 2e-6);
    near("last angle", overlap.angles[0][1], PI + half, 2e-6);
    // Turned half a turn, the same range runs over the end of the period.
    let mut turned = engine.clone();
    turned = turned
        .with(|turned| {
            turned.counterweights[0].part.as_mut().unwrap().angle = 0.0;
        })
        .unwrap();
    let overlap = to(&all(&turned), LINER).overlap.unwrap();
    assert_eq!(overlap.angles.len(), 1);
    near("first angle", overlap.angles[0][0], TURN - half, 2e-6);
    near("last angle", overlap.angles[0][1], TURN + half, 2e-6);
}

#[test]
fn both_pistons_of_a_v_engine_are_seen() {
    let banks = vec![cylinder(0, -PI / 4.0, -0.012), cylinder(0, PI / 4.0, 0.012)];
    let weight = counterweight(sector(0.065, 1.2), [0.024, 0.04], Some(1));
    let envelope = Envelope { skirt: skirt(0.03, None), ..Envelope::default() };
    let engine = engine(banks, vec![weight]).with(|parts| parts.envelope = Some(envelope)).unwrap();
    let found = all(&engine);
    // The plate's near face is 36 mm and 12 mm from the two cylinder axes: both within the bore's radius.
    for (number, angle) in [(1, PI - PI / 4.0), (2, PI + PI / 4.0)] {
        let one = to(&found, Obstacle::Piston { cylinder: number });
        near("distance", one.distance, LENGTH - RADIUS - 0.03 - 0.065, GAP);
        near("angle", one.theta.unwrap(), angle, 3e-3);
    }
}

#[test]
fn an_obstacle_farther_along_the_crank_than_another_of_its_kind_is_left_out() {
    let envelope = Envelope { skirt: skirt(0.03, None), rod: rod_envelope(), ..Envelope::default() };
    let weight = counterweight(sector(0.065, 1.2), [0.012, 0.028], Some(1));
    let row = vec![cylinder(0, 0.0, 0.0), cylinder(1, 0.0, 0.095)];
    let mut parts = parts(row, vec![weight]);
    parts.envelope = Some(envelope);
    parts.throws.push(throw(0, PI, 0.095));
    let engine = Engine::new(parts).unwrap();
    let found = all(&engine);
    let seen: Vec<Obstacle> = found.bodies[0].clearances.iter().map(|c| c.obstacle).collect();
    // The second piston begins 27 mm off, the neighbour's rod is of another kind than the own one.
    assert_eq!(seen, [PISTON, ROD, Obstacle::Rod { cylinder: 2 }, SIDE]);
    near(
        "neighbour's big end",
        to(&found, Obstacle::Rod { cylinder: 2 }).distance,
        0.095 - 0.01 - 0.028,
        GAP,
    );
}

#[test]
fn chamfers_are_ignored_and_that_is_said() {
    let envelope = Envelope { crankcase_radius: Some(0.07), ..Envelope::default() };
    let mut engine = single(0.065, envelope);
    assert!(!all(&engine).bodies[0].chamfers_ignored);
    let mut weight = engine.counterweights[0].clone();
    let part = weight.part.as_mut().unwrap();
    let cut = Cut::Turned { radius: 0.062 };
    let chamfer = Chamfer { cut, angle: FRAC_PI_2 / 2.0, face: Face::Front };
    part.part = part.part.clone().with_chamfer(chamfer).unwrap();
    engine = engine.with(|parts| parts.counterweights[0] = weight).unwrap();
    assert!(all(&engine).bodies[0].chamfers_ignored);
}

#[test]
fn a_swept_radius_with_room_keeps_the_wanted_clearance() {
    let envelope = Envelope {
        least: Some(0.0015),
        crankcase_radius: Some(0.08),
        skirt: skirt(0.03, None),
        liner: liner(0.075, 0.004),
        ..Envelope::default()
    };
    let engine = single(0.065, envelope);
    let faces = [0.012, 0.028];
    let room = model(&engine).largest_swept_radius(0, faces).unwrap().unwrap();
    near("radius", room.radius, LENGTH - RADIUS - 0.03 - 0.0015, GAP);
    assert_eq!(room.limit, PISTON);
    // A whole disc of that radius does keep it, and a larger one does not.
    for (more, is_kept) in [(0.0, true), (1e-5, false)] {
        let disc: Outline = Contour::circle(Point::ORIGIN, room.radius + more).unwrap().into();
        let weight = counterweight(disc, faces, Some(1));
        let with = engine.with(|parts| parts.counterweights = vec![weight]).unwrap();
        assert_eq!(all(&with).is_kept, is_kept, "{more}");
    }
    let wide = engine
        .with(|parts| parts.envelope = Some(Envelope { skirt: None, liner: None, ..envelope }))
        .unwrap();
    let room = model(&wide).largest_swept_radius(0, faces).unwrap().unwrap();
    assert_eq!((room.radius, room.limit), (0.08 - 0.0015, Obstacle::Crankcase));
    assert!(matches!(model(&wide).largest_swept_radius(1, faces), Err(ClearanceError::Unknown { .. })));
    assert!(matches!(model(&wide).largest_swept_radius(0, [0.1, 0.1]), Err(ClearanceError::Number { .. })));
}

#[test]
fn what_is_missing_is_told() {
    let bare = single(0.065, Envelope::default());
    let refused = ClearanceModel::new(&bare, Slider::all(&bare)).err();
    assert_eq!(refused, Some(ClearanceError::NoEnvelope));
    let mut engine = single(0.065, Envelope { skirt: skirt(0.03, None), ..Envelope::default() });
    let short = ClearanceModel::new(&engine, Vec::<Slider>::new()).err();
    assert_eq!(short, Some(ClearanceError::Motions { needed: 1, got: 0 }));
    engine = engine
        .with(|engine| {
            engine.cylinders[0].bore = None;
        })
        .unwrap();
    let refused = ClearanceModel::new(&engine, Slider::all(&engine)).err();
    assert_eq!(refused, Some(ClearanceError::NoBore { cylinder: 1 }));
    engine = engine
        .with(|engine| {
            engine.cylinders[0].bore = Some(BORE);

            engine.counterweights.clear();
        })
        .unwrap();
    assert_eq!(model(&engine).clearances().err(), Some(ClearanceError::NoShape));
    let long = single(0.065, Envelope { rod: rod_envelope(), ..Envelope::default() })
        .with(|parts| {
            parts.crankshafts = vec![crankshaft((1, 1), 0.0, 0.0), crankshaft((997, 991), 0.0, 0.3)];
            parts.throws = vec![throw(0, 0.0, 0.0), throw(1, 0.0, 0.0)];
            parts.cylinders = vec![cylinder(0, 0.0, 0.0), cylinder(1, 0.0, 0.0)];
        })
        .unwrap();
    assert!(matches!(model(&long).clearances(), Err(ClearanceError::PeriodTooLong { .. })));
}

/// The curve over the angle lies above the proved bound and comes near it; the sampled distances in space likewise.
fn check(engine: &Engine, obstacle: Obstacle, period: f64) {
    let found = model(engine);
    let clearance = to(&found.clearances().unwrap(), obstacle);
    let angles = (120.0 * period / TURN) as usize;
    let samples = sampled(engine, obstacle, period, angles);
    assert!(clearance.bound <= clearance.distance);
    assert!(clearance.distance - clearance.bound <= GAP, "{} {}", clearance.distance, clearance.bound);
    assert!(clearance.bound <= samples + 1e-12, "{} above a sample {samples}", clearance.bound);
    // Samples are some millimetres apart: a distance that is far below them would be one of nothing.
    assert!(samples <= clearance.distance + 0.006, "{} for {samples}", clearance.distance);
    let curve = found.curve(0, obstacle, 180).unwrap();
    assert!((curve.period - period).abs() < 1e-12);
    let lowest = curve.distance.iter().fold(f64::INFINITY, |a, b| a.min(*b));
    assert!(lowest >= clearance.bound - 1e-12 && lowest <= clearance.distance + 0.004 * period / TURN);
    match &clearance.overlap {
        None => {
            let [a, b] = [clearance.on_body, clearance.on_obstacle];
            let apart = (a[0] - b[0]).hypot(a[1] - b[1]).hypot(a[2] - b[2]);
            assert!((apart - clearance.distance).abs() < 1e-9, "{apart} for {}", clearance.distance);
            if let Some(theta) = clearance.theta {
                let of_body = distance_in_space(engine, obstacle, theta, a);
                assert!((of_body - clearance.distance).abs() < 1e-9, "{of_body} for {}", clearance.distance);
                assert!(distance_in_space(engine, obstacle, theta, b) < 1e-9);
            }
        }
        Some(overlap) => {
            assert_eq!(clearance.distance, 0.0);
            // At every angle of the curve: overlapping within the ranges, clear outside.
            for (theta, distance) in curve.theta.iter().zip(&curve.distance) {
                let within = |slack: f64| {
                    overlap.angles.iter().any(|[from, to]| {
                        [*theta, theta + period].iter().any(|t| *t >= from - slack && *t <= to + slack)
                    })
                };
                assert!(*distance > 0.0 || within(1e-5), "overlap at {theta} not in {:?}", overlap.angles);
                assert!(
                    *distance < 1e-6 || !within(-1e-5),
                    "no overlap at {theta}: {distance}, {:?}",
                    overlap.angles
                );
            }
        }
    }
}

/// A star about the axis: corners at rising angles, edges with small bulges.
fn any_star() -> impl Strategy<Value = Outline> {
    let corner = (0.02..0.07f64, -0.25..0.25f64);
    proptest::collection::vec(corner, 4..9).prop_filter_map("it crosses itself", |corners| {
        let count = corners.len() as f64;
        let corner = |(at, (radius, bulge)): (usize, &(f64, f64))| Corner {
            at: Point::polar(*radius, TURN * at as f64 / count),
            bulge: *bulge,
        };
        Contour::new(&corners.iter().enumerate().map(corner).collect::<Vec<_>>()).ok().map(Outline::from)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn prop_no_sample_is_nearer_than_what_is_proved(
        star in any_star(),
        face in -0.05..0.045f64,
        thickness in 0.004..0.02f64,
        offsets in (-0.015..0.015f64, -0.003..0.003f64),
        angle in -3.0..3.0f64,
        lengths in (0.01..0.05f64, 0.02..0.1f64, 0.05..0.11f64, 0.003..0.01f64),
    ) {
        let (length, width, end, wall) = lengths;
        let mut one = cylinder(0, angle, 0.0);
        (one.offset, one.pin_offset) = offsets;
        let weight = counterweight(star, [face, face + thickness], None);
        let envelope = Envelope {
            skirt: skirt(length, Some(width)),
            liner: liner(end, wall),
            rod: rod_envelope(),
            ..Envelope::default()
        };
        let engine = engine(vec![one], vec![weight]).with(|parts| parts.envelope = Some(envelope)).unwrap();
        for obstacle in [PISTON, LINER, ROD] {
            check(&engine, obstacle, TURN);
        }
    }

    #[test]
    fn prop_geared_crankshafts_meet_at_their_own_ratio(
        star in any_star(),
        ratio in prop_oneof![Just(((-1, 1), 1.0)), Just(((2, 1), 1.0)), Just(((1, 2), 2.0)), Just(((3, 2), 2.0))],
        place in (-0.1..0.02f64, 0.09..0.16f64),
        angle in -0.5..0.5f64,
        face in -0.03..0.02f64,
    ) {
        let ((numerator, denominator), turns) = ratio;
        let weight = counterweight(star, [face, face + 0.012], None);
        let cylinders = vec![cylinder(0, 0.0, 0.2), cylinder(1, angle, 0.0)];
        let envelope = Envelope { skirt: skirt(0.03, None), rod: rod_envelope(), ..Envelope::default() };
        let mut parts = parts(cylinders, vec![weight]);
        parts.envelope = Some(envelope);
        parts.throws = vec![throw(0, 0.0, 0.2), throw(1, 0.4, 0.0)];
        parts.crankshafts.push(crankshaft((numerator, denominator), place.0, place.1));
        parts.crankshafts[1].phase = 0.3;
        let engine = Engine::new(parts).unwrap();
        for obstacle in [Obstacle::Piston { cylinder: 2 }, Obstacle::Rod { cylinder: 2 }] {
            // A piston that stands behind another one along the crank alone is left out.
            if all(&engine).bodies[0].clearances.iter().any(|c| c.obstacle == obstacle) {
                check(&engine, obstacle, turns * TURN);
            }
        }
    }
}
