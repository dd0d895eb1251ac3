//! Clearances of whole engines: shapes of one room against the exact linkages of another.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester::geometry::clearance::{ClearanceError, Obstacle};
use lanchester::geometry::{Contour, Outline, Part, Point};
use lanchester::mechanism::{LoadRequest, motion};
use lanchester::model::{
    Counterweight, CounterweightForm, CounterweightPart, Engine, Envelope, RodEnvelope, RodJoint, Skirt,
};
use lanchester::{EngineClearanceError, clearance_curve, clearances, largest_swept_radius};
use std::f64::consts::{PI, TAU};

/// An engine of the gallery without its counterweights, every cylinder with a bore.
fn gallery(name: &str) -> Engine {
    let template = lanchester::file::template(name).unwrap();
    let mut engine = lanchester::file::read(template.text).engine().unwrap();
    engine = engine
        .with(|engine| {
            engine.counterweights.clear();

            for cylinder in &mut engine.cylinders {
                cylinder.bore = Some(0.1);
            }
        })
        .unwrap();
    engine
}

/// A disc about `centre` in its own directions, which stand at `angle` on a crankshaft, 4 mm thick about the plane `z`.
fn disc(centre: Point, radius: f64, crankshaft: usize, z: f64, angle: f64) -> Counterweight {
    let outline: Outline = Contour::circle(centre, radius).unwrap().into();
    let part = Part::new(outline, 0.004, 7850.0).unwrap();
    let form = CounterweightForm::Counterweight;
    let part = CounterweightPart { form, part, web: None, z, angle, wanted: None };
    let name = format!("disc on crankshaft {}", crankshaft + 1);
    Counterweight { name, crankshaft, z, unbalance: 0.0, angle, part: Some(Box::new(part)) }
}

/// A disc about the crank axis in the plane of a cylinder is nearest to its piston at bottom dead centre, which the motion of
/// the linkage finds by itself: `s_bdc - skirt - radius`, at every cylinder of plain, offset, articulated and geared engines.
#[test]
fn pistons_come_down_to_their_own_dead_centres() {
    for name in ["radial-9", "v2-90", "vr6-15", "square-4", "opposed-piston-3"] {
        let base = gallery(name);
        let motions = motion(&base, &LoadRequest::default()).unwrap();
        for (cylinder, moved) in base.cylinders.iter().zip(&motions) {
            let shaft = base.throws[cylinder.throw].crankshaft;
            let bottom = moved.top - moved.stroke;
            let (skirt, radius) = (0.2 * bottom, 0.3 * bottom);
            let mut engine = base.clone();
            engine = engine
                .with(|engine| {
                    engine.counterweights = vec![disc(Point::ORIGIN, radius, shaft, cylinder.z, 0.3)];

                    engine.envelope = Some(Envelope {
                        skirt: Some(Skirt { length: skirt, width: None }),
                        ..Envelope::default()
                    });
                })
                .unwrap();
            let found = clearances(&engine).unwrap();
            let obstacle = Obstacle::Piston { cylinder: moved.cylinder };
            let one = found.bodies[0].clearances.iter().find(|c| c.obstacle == obstacle).unwrap();
            if name == "opposed-piston-3" {
                // What comes from the other crankshaft is the far side of the same cylinder.
                assert!(found.bodies[0].clearances.iter().all(|c| {
                    let Obstacle::Piston { cylinder } = c.obstacle else { return false };
                    base.throws[base.cylinders[cylinder - 1].throw].crankshaft == shaft
                }));
            }
            let wanted = bottom - skirt - radius;
            // A search ends 1e-7 m above its bound.
            assert!(
                (one.distance - wanted).abs() < 1.001e-7,
                "{name} {}: {} for {wanted}",
                moved.cylinder,
                one.distance
            );
            // The travel is quadratic about its lowest point: 1e-7 m are about 2e-3 rad.
            let turn = TAU / base.crankshafts[shaft].ratio.value().abs();
            let off = (one.theta.unwrap() - moved.bottom_dead_centre).rem_euclid(turn);
            assert!(off.min(turn - off) < 5e-3, "{name} {}: {off}", moved.cylinder);
            // The room that the engine has for any shape ends at the skirt, too.
            let room =
                largest_swept_radius(&engine, shaft, [cylinder.z - 0.002, cylinder.z + 0.002]).unwrap();
            let room = room.unwrap();
            assert!(room.radius <= bottom - skirt + 1e-12, "{name}: {}", room.radius);
        }
    }
}

/// Distance of a point from a rod's rectangle, from the pins of its linkage as plane geometry has them.
fn from_rod(engine: &Engine, index: usize, theta: f64, at: (f64, f64), width: f64) -> f64 {
    let cylinder = &engine.cylinders[index];
    let throw = &engine.throws[cylinder.throw];
    let pin_angle = engine.pin_angle(cylinder.throw, theta);
    let crankpin = (throw.radius * pin_angle.cos(), throw.radius * pin_angle.sin());
    // From a lower pin to the line of the piston pin, as long as the rod.
    let piston_pin = |lower: (f64, f64), index: usize| {
        let cylinder = &engine.cylinders[index];
        let (sin, cos) = cylinder.angle.sin_cos();
        let (along, beside) = (lower.0 * cos + lower.1 * sin, -lower.0 * sin + lower.1 * cos);
        let off = beside - cylinder.net_offset();
        let travel = along + (cylinder.rod.length.powi(2) - off * off).sqrt();
        (travel * cos - cylinder.net_offset() * sin, travel * sin + cylinder.net_offset() * cos)
    };
    let lower = match cylinder.rod.joint {
        RodJoint::Articulated { master, knuckle_radius, knuckle_angle } => {
            let pin = piston_pin(crankpin, master);
            let angle = (pin.1 - crankpin.1).atan2(pin.0 - crankpin.0) + knuckle_angle;
            (crankpin.0 + knuckle_radius * angle.cos(), crankpin.1 + knuckle_radius * angle.sin())
        }
        _ => crankpin,
    };
    let upper = piston_pin(lower, index);
    let length = cylinder.rod.length;
    let (c, s) = ((upper.0 - lower.0) / length, (upper.1 - lower.1) / length);
    let (x, y) = (at.0 - lower.0, at.1 - lower.1);
    let (t, v) = (x * c + y * s, -x * s + y * c);
    (-t).max(t - length).max(0.0).hypot((v.abs() - width / 2.0).max(0.0))
}

#[test]
fn articulated_rods_stand_where_their_knuckle_pins_do() {
    let mut engine = gallery("radial-9");
    let cylinder = &engine.cylinders[3];
    assert!(matches!(cylinder.rod.joint, RodJoint::Articulated { .. }));
    let pin = engine.throws[cylinder.throw].angle;
    // Against the crankpin, far out, where rods pass it.
    let (far, radius) = (1.5 * engine.throws[cylinder.throw].radius, 0.004);
    engine = engine
        .with(|engine| {
            engine.counterweights = vec![disc(Point::new(far, 0.0), radius, 0, cylinder.z, pin + PI)];
        })
        .unwrap();
    let width = 0.02;
    let rod =
        RodEnvelope { big_end_radius: 1e-3, big_end_width: 0.01, shank_width: width, shank_thickness: 0.01 };
    engine = engine
        .with(|engine| {
            engine.envelope = Some(Envelope { rod: Some(rod), ..Envelope::default() });
        })
        .unwrap();
    for index in [1, 3, 6] {
        let at = |theta: f64| {
            let angle = theta + pin + PI;
            (from_rod(&engine, index, theta, (far * angle.cos(), far * angle.sin()), width) - radius).max(0.0)
        };
        let obstacle = Obstacle::Rod { cylinder: index + 1 };
        let curve = clearance_curve(&engine, 0, obstacle, 360).unwrap();
        for (theta, distance) in curve.theta.iter().zip(&curve.distance) {
            let wanted = at(*theta);
            assert!((distance - wanted).abs() < 1.001e-7, "rod {index} at {theta}: {distance} for {wanted}");
        }
        // Zeros on both sides would prove nothing.
        let apart = curve.distance.iter().filter(|distance| **distance > 0.001).count();
        assert!(apart > 180, "rod {index}: {apart} of 360 angles");
    }
}

#[test]
fn an_engine_that_names_nothing_to_stay_clear_of_is_told_so() {
    let engine = gallery("in-line-4").with(|parts| parts.envelope = None).unwrap();
    let error = clearances(&engine).unwrap_err();
    assert_eq!(error, EngineClearanceError::Clearance(ClearanceError::NoEnvelope));
    assert!(error.to_string().contains("hint: add a section [clearance]"));
}
