//! The equations of the crank train and its reactions against the referee's bodies and joints, for random engines in random motion.

use crate::support;
use lanchester_model::{Block, Engine, MovingParts};
use lanchester_multibody::referee::{BodyLoad, GROUND, Joint};
use lanchester_multibody::{Guidance, Instant, Loads, Motion, Rotor, RotorInertia, Train, Wrench};
use nalgebra::Vector3;
use num_complex::Complex64;
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};
use support::random::{ALL_SHAPES, any_engine};

type Three = [f64; 3];

fn three(size: f64) -> impl Strategy<Value = Three> {
    [-size..size, -size..size, -size..size]
}

/// A block that is heavy enough for all that moves in it.
fn block(centre: Three, skew: Three) -> Block {
    Block {
        mass: 400.0,
        centre,
        inertia: [60.0, 55.0, 40.0],
        products: skew,
        moving_parts: MovingParts::Included,
        gravity: [-1.0, 0.0, 0.0],
        driveline_torque: [0.0; 3],
    }
}

#[derive(Debug, Clone)]
struct Case {
    engine: Engine,
    inertia: RotorInertia,
    motion: Motion,
    gas: Vec<f64>,
    gravity: Vector3<f64>,
    force: Vector3<f64>,
    moment: Vector3<f64>,
    torques: [f64; 2],
    guidance: Guidance,
    axial: f64,
}

fn any_case() -> impl Strategy<Value = Case> {
    let place = (three(0.05), three(1.0), 0.0..TAU, 10.0..400.0f64);
    let moved = (three(1.0), three(3.0), three(0.05), three(2.0));
    let loads = (three(9.81), three(3e3), three(3e3), -300.0..300.0f64, -300.0..300.0f64);
    let inertia = prop::collection::vec(0.01..0.5f64, 8);
    let gas = prop::collection::vec(-2e3..6e4f64, 12);
    (any_engine(ALL_SHAPES), place, moved, loads, inertia, gas, any::<bool>(), 0.0..0.01f64).prop_map(
        |(
            mut engine,
            (position, turn, theta, speed),
            (velocity, spin, centre, skew),
            loads,
            inertia,
            gas,
            piston,
            axial,
        )| {
            engine = engine
                .with(|engine| {
                    engine.block = Some(block(centre, skew));
                })
                .unwrap();
            let mut inertia = inertia.into_iter().map(Some);
            let inertia = RotorInertia {
                crankshafts: engine.crankshafts.iter().map(|_| inertia.next().flatten()).collect(),
                flywheel: 0.005,
                shafts: engine.shafts.iter().map(|_| inertia.next().flatten()).collect(),
            };
            let size = Vector3::from(turn).norm();
            let axis = if size > 0.0 { Vector3::from(turn) / size } else { Vector3::z() };
            let (sin, cos) = (0.5 * size).sin_cos();
            let motion = Motion {
                theta,
                speed,
                position: position.into(),
                orientation: [cos, sin * axis.x, sin * axis.y, sin * axis.z],
                velocity: velocity.into(),
                spin: spin.into(),
            };
            let (gravity, force, moment, outer, inner) = loads;
            Case {
                gas: gas[..engine.cylinders.len()].to_vec(),
                engine,
                inertia,
                motion,
                gravity: gravity.into(),
                force: force.into(),
                moment: moment.into(),
                torques: [outer, inner],
                guidance: if piston { Guidance::Piston } else { Guidance::Crankpin },
                axial,
            }
        },
    )
}

/// Off by at most `share` of `scale`.
fn close(name: &str, ours: Three, theirs: Vector3<f64>, scale: f64, share: f64) -> Result<(), TestCaseError> {
    let off = (Vector3::from(ours) - theirs).norm();
    prop_assert!(off <= share * scale, "{name}: {ours:?} and {theirs:?}, off by {off:e} of {scale:e}");
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn prop_accelerations_and_reactions_are_the_referees(case in any_case()) {
        let Case { engine, inertia, motion, gas, gravity, force, moment, torques: [outer, inner], guidance, axial } = case;
        let mut train = Train::new(&engine, &inertia).map_err(|error| TestCaseError::reject(error.to_string()))?;
        train.cylinders.iter_mut().for_each(|cylinder| cylinder.rod.axial_inertia = axial);
        // Rotors whose inertias across their axes differ, each in a direction of its own.
        for (index, rotor) in train.rotors.iter_mut().enumerate() {
            rotor.unequal = Complex64::from_polar(2.0 * axial, 1e3 * axial + index as f64);
        }
        let mut places = Vec::new();
        train.places_into(motion.theta, &mut places);
        let equations = train.equations(&motion, &places);
        let loads = Loads { gas: &gas, gravity, piston_damping: 0.0, force, moment, outer_torque: outer, inner_torque: inner };
        let forces = train.generalised_forces(&equations, &places, motion.speed, &loads);
        let rates = equations.accelerations(&forces).expect("the mass matrix is positive definite");

        let mut judge = train.referee(&motion, &places, guidance).expect("the joints leave seven freedoms");
        prop_assert!(judge.assembly.largest_gap(&judge.poses) < 1e-13);
        let rotation = motion.rotation();
        judge.assembly.gravity = rotation * gravity;
        let z = rotation * Vector3::z();
        let zero = Vector3::zeros();
        let load = |body, force: Vector3<f64>, moment: Vector3<f64>| BodyLoad { body, force, moment };
        let mut on_bodies = vec![
            load(judge.block, rotation * force, rotation * moment - inner * z),
            load(judge.rotors[0], zero, (outer + inner) * z),
        ];
        for (index, cylinder) in train.cylinders.iter().enumerate() {
            let u = rotation * Vector3::new(cylinder.axis.re, cylinder.axis.im, 0.0);
            let [piston, _] = judge.cylinders[index];
            let push = gas[index] * u;
            let arm = judge.poses[piston].position - judge.poses[judge.block].position;
            on_bodies.push(load(piston, -push, zero));
            on_bodies.push(load(judge.block, push, arm.cross(&push)));
        }
        let answer = judge.assembly.solve(&judge.poses, &on_bodies).expect("the joints are determinate");

        let own = rotation.transpose();
        let [linear, angular] = answer.accelerations[judge.block].map(|a| own * a);
        let [v, spin] = [motion.velocity, motion.spin];
        let crank = own * answer.accelerations[judge.rotors[0]][1];
        let linear_rate = linear - spin.cross(&v);
        let crank_rate = crank.z - angular.z;
        let [a, b, c, d, e, f, w] = rates;
        let scale = rates.iter().fold(1.0f64, |most, rate| most.max(rate.abs()));
        close("acceleration", [a, b, c], linear_rate, scale, 1e-11)?;
        close("angular acceleration", [d, e, f], angular, scale, 1e-11)?;
        close("crank", [w, 0.0, 0.0], Vector3::new(crank_rate, 0.0, 0.0), scale, 1e-11)?;

        let instant = Instant { motion: &motion, places: &places, rates, gas: &gas, gravity, piston_damping: 0.0, guidance };
        let ours = train.reactions(&instant, &train.main_shares(&[]));
        let largest = ours.cylinders.iter().flat_map(|c| [c.wall, c.piston_pin, c.lower_pin]);
        let largest = largest.fold(1.0f64, |most, wrench| most.max(Vector3::from(wrench.force).norm()));
        let check = |name: &str, ours: Wrench, [force, moment]: [Vector3<f64>; 2], from: Vector3<f64>| {
            let (force, moment) = (own * force, own * (moment + from.cross(&force)));
            close(name, ours.force, force, largest, 1e-10)?;
            close(name, ours.moment, moment, largest, 1e-10)
        };
        for (index, own) in ours.cylinders.iter().enumerate() {
            let [wall, lower, upper] = judge.joints[index];
            let [piston, rod] = judge.cylinders[index];
            let (piston_at, rod_at) = (judge.poses[piston], judge.poses[rod]);
            let cylinder = &train.cylinders[index];
            let share = cylinder.rod.centre;
            let along = rod_at.rotation * Vector3::x() * cylinder.rod.length;
            let (pin, foot) = (rod_at.position + (1.0 - share) * along, rod_at.position - share * along);
            let on_wall = answer.on_b[wall].map(|w| -w);
            check("wall", own.wall, on_wall, piston_at.position - pin)?;
            let on_piston = answer.on_b[upper].map(|w| -w);
            check("piston pin", own.piston_pin, on_piston, rod_at.position - pin)?;
            let on_pin = answer.on_b[lower].map(|w| -w);
            check("lower pin", own.lower_pin, on_pin, rod_at.position - foot)?;
        }
        for (index, rotor) in ours.rotors.iter().enumerate() {
            check("bearings", rotor.bearings, answer.on_b[judge.bearings[index]].map(|w| -w), zero)?;
            if index > 0 {
                let torque = (own * answer.on_b[judge.gears[index - 1]][1]).z;
                prop_assert!((torque - rotor.gear_torque).abs() <= 1e-10 * largest, "gear {torque} {}", rotor.gear_torque);
            }
        }
        prop_assert!((ours.shaft_torque + outer + inner).abs() <= 1e-10 * largest, "{} {outer} {inner}", ours.shaft_torque);
        // What the block feels by the joints is what makes it move as it does.
        let on_block = Vector3::from(ours.on_block.force) + force;
        let body = train.block.expect("it has one");
        let point = linear_rate + spin.cross(&v);
        let needed = body.mass * (point - gravity) + angular.cross(&body.first_moment) + spin.cross(&spin.cross(&body.first_moment));
        close("block", on_block.into(), needed, largest, 1e-10)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Teeth: their force lies on the line of action, gives the torque, presses the wheels apart, and goes through the bearings into the block, which feels as much as without.
    #[test]
    fn prop_teeth_load_the_bearings_along_the_line_of_action(case in any_case(), angle in 0.0..0.6f64, z in -0.2..0.2f64) {
        let Case { engine, inertia, motion, gas, gravity, guidance, .. } = case;
        let plain = Train::new(&engine, &inertia).map_err(|error| TestCaseError::reject(error.to_string()))?;
        let mut toothed = plain.clone();
        let axis = plain.rotors[0].axis;
        for index in 1..plain.rotors.len() {
            let Rotor { ratio, axis: own, .. } = plain.rotors[index];
            // Names need not be unique in a random engine.
            toothed.rotors[index].name = format!("shaft {index}");
            let possible = ratio < 0.0 && (own - axis).norm() > 1e-3;
            let refused = toothed.set_mesh(&format!("shaft {index}"), angle, z).is_err();
            prop_assert!(refused || ratio < 0.0);
            if !possible {
                toothed.rotors[index].mesh = None;
            }
        }
        let mut places = Vec::new();
        plain.places_into(motion.theta, &mut places);
        let rates = [1.0, -2.0, 3.0, 4.0, -5.0, 6.0, 700.0];
        let instant = Instant { motion: &motion, places: &places, rates, gas: &gas, gravity, piston_damping: 0.0, guidance };
        let [without, with] = [&plain, &toothed].map(|train| train.reactions(&instant, &train.main_shares(&[])));
        let scale = without.rotors.iter().map(|r| Vector3::from(r.bearings.force).norm() + r.gear_torque.abs()).fold(1.0, f64::max);
        close("force on the block", with.on_block.force, without.on_block.force.into(), scale, 1e-11)?;
        close("moment on the block", with.on_block.moment, without.on_block.moment.into(), scale, 1e-11)?;
        let mut on_first = Vector3::zeros();
        for (index, rotor) in toothed.rotors.iter().enumerate() {
            let (own, before) = (&with.rotors[index], &without.rotors[index]);
            prop_assert_eq!(own.gear_torque, before.gear_torque);
            let force = Vector3::from(own.gear_force);
            close("bearings", own.bearings.force, Vector3::from(before.bearings.force) + force, scale, 1e-12)?;
            let moment = Vector3::from(before.bearings.moment) + z * Vector3::z().cross(&force);
            close("moment of the bearings", own.bearings.moment, moment, scale, 1e-12)?;
            for rule in own.mains.iter().filter(|rule| !rule.is_empty()) {
                let sum = rule.iter().fold(Vector3::zeros(), |sum, main| sum + Vector3::new(main[0], main[1], 0.0));
                let across = Vector3::new(own.bearings.force[0], own.bearings.force[1], 0.0);
                close("mains", sum.into(), across, scale, 1e-10)?;
            }
            if rotor.mesh.is_none() || index == 0 {
                continue;
            }
            on_first -= force;
            // The pitch point divides the line of the axes as the ratio says; base circles are smaller by the cosine.
            let line = axis - rotor.axis;
            let pitch = line / (1.0 - rotor.ratio);
            let arm = Vector3::new(pitch.re, pitch.im, 0.0);
            let torque = arm.cross(&force).z;
            prop_assert!((torque - own.gear_torque).abs() < 1e-10 * scale);
            prop_assert!((force.norm() * pitch.norm() * angle.cos() - own.gear_torque.abs()).abs() < 1e-10 * scale);
            prop_assert!(force.dot(&arm) <= 1e-10 * scale * arm.norm(), "pressed apart");
        }
        close("crankshaft 1", with.rotors[0].gear_force, on_first, scale, 1e-12)?;
    }
}

/// A meta-test: the comparison sees a mass that is off by a millionth.
#[test]
fn a_small_mistake_is_seen() {
    let engine = support::in_line(&[0.0, PI]);
    let inertia = RotorInertia { crankshafts: vec![Some(0.1)], flywheel: 0.0, shafts: Vec::new() };
    let train = Train::new(&engine, &inertia).expect("it turns");
    let motion = Motion::fixed(0.7, 200.0);
    let mut places = Vec::new();
    train.places_into(motion.theta, &mut places);
    let crank = train.crank_inertia(&places);
    let wanted = -crank.bias * motion.speed.powi(2) / crank.inertia;
    let mut judge = train.referee(&motion, &places, Guidance::Crankpin).expect("one freedom");
    let rate = |judge: &lanchester_multibody::RefereeEngine| {
        let answer = judge.assembly.solve(&judge.poses, &[]).expect("the joints are determinate");
        answer.accelerations[judge.rotors[0]][1].z
    };
    assert!((rate(&judge) - wanted).abs() < 1e-11 * wanted.abs());
    let [piston, _] = judge.cylinders[0];
    judge.assembly.bodies[piston].mass *= 1.0 + 1e-6;
    assert!((rate(&judge) - wanted).abs() > 1e-9 * wanted.abs());
    // A drive takes the last freedom.
    judge.assembly.joints.push(Joint::drive("drive", GROUND, judge.rotors[0], Vector3::z(), 5.0));
    assert!((rate(&judge) - 5.0).abs() < 1e-10);
}
