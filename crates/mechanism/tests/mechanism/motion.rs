//! Dead centres, strokes, speeds and articulated rods.
use crate::support::random::{ALL_SHAPES, any_engine};
use crate::support::{assert_close, brute, in_line, odd_angles, radial};
use lanchester_mechanism::{CylinderMotion, Kinematics, LoadError, LoadRequest, PeakMode, loads, motion};
use lanchester_model::{Engine, RodJoint};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

fn of(engine: &Engine) -> Vec<CylinderMotion> {
    motion(engine, &LoadRequest::default()).expect("the engine is valid")
}

/// Distance of the piston pin from the crankshaft's axis along the cylinder.
fn travel(engine: &Engine, cylinder: usize, theta: f64) -> f64 {
    let [_, pin, _] = brute::joints(engine, cylinder, theta);
    let crankshaft = &engine.crankshafts[engine.throws[engine.cylinders[cylinder].throw].crankshaft];
    let angle = engine.cylinders[cylinder].angle;
    (pin[0] - crankshaft.x) * angle.cos() + (pin[1] - crankshaft.y) * angle.sin()
}

#[test]
fn centred_cylinder() {
    let motion = &of(&in_line(&[0.0, 180.0]))[1];
    let close =
        |name: &str, got: f64, wanted: f64| assert_close(name, got, wanted, 1e-15, 1e-13, "closed form");
    close("top dead centre", motion.top_dead_centre, PI);
    close("bottom dead centre", motion.bottom_dead_centre, 0.0);
    close("stroke", motion.stroke, 0.09);
    close("top", motion.top, 0.195);
    // At TDC r w^2 (1 + r/l), the largest towards the crank.
    close("deceleration", motion.max_deceleration, 0.045 * 9e4 * (1.0 + 0.3));
    close("rod angle", motion.max_rod_angle, 0.3f64.asin());
}

#[test]
fn offset_lengthens_the_stroke_and_moves_the_dead_centres() {
    let mut engine = in_line(&[0.0]);
    engine = engine
        .with(|engine| {
            engine.cylinders[0].offset = 0.02;

            engine.cylinders[0].firing_angle = Some(TAU);
        })
        .unwrap();
    let motion = &of(&engine)[0];
    let (r, l, e) = (0.045f64, 0.15f64, 0.02f64);
    let stroke = ((l + r).powi(2) - e * e).sqrt() - ((l - r).powi(2) - e * e).sqrt();
    assert_close("stroke", motion.stroke, stroke, 0.0, 1e-13, "closed form");
    assert_close("top dead centre", motion.top_dead_centre, (e / (l + r)).asin(), 0.0, 1e-13, "closed form");
    let bottom = PI + (e / (l - r)).asin();
    assert_close("bottom dead centre", motion.bottom_dead_centre, bottom, 0.0, 1e-13, "closed form");
    let firing = motion.firing_angle.unwrap();
    assert_close("firing angle", firing, TAU + (e / (l + r)).asin(), 0.0, 1e-13, "the true TDC nearest");
}

#[test]
fn articulated_radial_has_unequal_strokes_and_turning_loads() {
    let engine = radial(9, 0.06);
    let motions = of(&engine);
    assert_close("master's stroke", motions[0].stroke, 0.16, 0.0, 1e-13, "twice the crank radius");
    for k in 1..9 {
        let articulation = motions[k].articulation.as_ref().unwrap();
        assert_eq!(articulation.master, 1);
        // Mirror images about the master's axis.
        assert_close("mirrored stroke", motions[k].stroke, motions[9 - k].stroke, 0.0, 1e-12, "symmetry");
        let mirrored = motions[9 - k].articulation.as_ref().unwrap().top_dead_centre_shift;
        assert_close("mirrored shift", articulation.top_dead_centre_shift, -mirrored, 1e-12, 0.0, "symmetry");
        // Knuckle pins at the cylinders' own angles lengthen every slave's stroke, least beside the master.
        assert!(articulation.stroke_difference > 1e-6, "{articulation:?}");
        assert!(articulation.max_reach > articulation.min_reach && articulation.min_reach > 0.28);
    }
    let longest = motions[3].stroke;
    assert!(motions.iter().all(|m| m.stroke <= longest + 1e-12) && longest > motions[0].stroke + 3e-4);
    let total = loads(&engine, &LoadRequest::default()).unwrap().total;
    let (forward, backward) = (total.orders[1].force_forward.norm(), total.orders[1].force_backward.norm());
    assert!(
        forward > 50.0 * backward && backward > 1.0,
        "turns with the crank: {forward} N, against: {backward} N"
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn prop_dead_centres_are_the_extremes_of_travel(engine in any_engine(ALL_SHAPES)) {
        for (k, motion) in of(&engine).iter().enumerate() {
            let reason = "plane geometry, rounding";
            let top = travel(&engine, k, motion.top_dead_centre);
            let bottom = travel(&engine, k, motion.bottom_dead_centre);
            assert_close("travel at top", top, motion.top, 1e-13, 1e-12, reason);
            assert_close("stroke", top - bottom, motion.stroke, 1e-13, 1e-12, reason);
            let throw = &engine.throws[engine.cylinders[k].throw];
            let turn = TAU / engine.crankshafts[throw.crankshaft].ratio.value().abs();
            prop_assert!((0.0..turn).contains(&motion.top_dead_centre));
            prop_assert!((0.0..turn).contains(&motion.bottom_dead_centre));
            for theta in odd_angles(50) {
                let here = travel(&engine, k, theta * turn / TAU);
                prop_assert!(here <= top + 1e-12 && here >= bottom - 1e-12, "cylinder {k} at {theta}");
            }
        }
    }

    #[test]
    fn prop_everything_is_a_number(
        engine in any_engine(ALL_SHAPES), lengths in -5..5i32, masses in -60..60i32, speed in -30..30i32, cap in 0..4u32,
    ) {
        let mut engine = engine;
        let (length, mass) = (10f64.powi(lengths), 10f64.powi(masses));
        engine = engine.with(|engine| { for throw in &mut engine.throws {
            throw.radius *= length;
            throw.unbalance *= mass;
        }
 for cylinder in &mut engine.cylinders {
            for value in [&mut cylinder.offset, &mut cylinder.pin_offset, &mut cylinder.rod.length] {
                *value *= length;
            }
            if let RodJoint::Articulated { knuckle_radius, .. } = &mut cylinder.rod.joint {
                *knuckle_radius *= length;
            }
            cylinder.piston_mass *= mass;
            cylinder.rod.inertia = None;
        }
}).unwrap();
        let kinematics = if cap == 0 { Kinematics::Exact } else { Kinematics::Orders(cap) };
        let request = LoadRequest {
            speed: Some(10f64.powi(speed)),
            kinematics,
            samples: 16,
            peaks: PeakMode::Grid(16),
            ..LoadRequest::default()
        };
        match loads(&engine, &request) {
            Ok(loads) => {
                let text = serde_json::to_string(&loads).unwrap();
                prop_assert!(!text.contains("null,\"theta") && !text.contains("[null") && !text.contains(",null,"));
                for order in &loads.total.orders {
                    prop_assert!(order.force_peak().is_finite() && order.roll_moment.norm().is_finite());
                }
            }
            Err(LoadError::NotFinite { .. } | LoadError::Length { .. }) => {}
            Err(other) => prop_assert!(false, "{other}"),
        }
    }
}

#[test]
fn a_locked_rod_is_an_error_and_a_nearly_locked_one_is_not() {
    let single = in_line(&[0.0]);
    let with_rod =
        |share: f64| single.with(|parts| parts.cylinders[0].rod.length = share * parts.throws[0].radius);
    let locked = with_rod(1.0).unwrap_err();
    assert!(locked[0].to_string().contains("length [m] must be more than 0.045"), "{}", locked[0]);
    let engine = with_rod(1.0 + 2e-9).unwrap();
    let loads = loads(&engine, &LoadRequest::default()).unwrap();
    assert!(loads.total.peaks.force.max.value.is_finite());
    assert!(
        loads.total.orders.iter().all(|o| o.force_peak().is_finite() && o.shaft_torque.norm().is_finite())
    );
}

proptest! {
    #[test]
    fn prop_velocity_and_acceleration_are_the_slopes_of_position(engine in any_engine(ALL_SHAPES)) {
        let speed = engine.speed.highest;
        for motion in of(&engine) {
            let trace = &motion.trace;
            let count = trace.theta.len();
            let step = trace.theta[1] / speed;
            let slope = |values: &[f64], j: usize| {
                let at = |k: usize| values[(j + count + k - 2) % count];
                (8.0 * (at(3) - at(1)) - (at(4) - at(0))) / (12.0 * step)
            };
            for j in 0..count {
                prop_assert!((trace.position[j] - travel(&engine, motion.cylinder - 1, trace.theta[j])).abs() < 1e-12);
                // Fourth-order differences at half a degree: 1e-6 of the largest value where the rod is near its limit.
                prop_assert!((slope(&trace.position, j) - trace.velocity[j]).abs() < 2e-6 * motion.max_speed);
                let largest = motion.max_acceleration.max(motion.max_deceleration);
                prop_assert!((slope(&trace.velocity, j) - trace.acceleration[j]).abs() < 2e-6 * largest);
            }
        }
    }
}
