//! Imposed speed, fixed block, no gravity: every load against the closed form, for every engine of the gallery.

use crate::support::random::{ALL_SHAPES, any_engine};
use lanchester_file::{read, templates};
use lanchester_mechanism::{BearingRequest, CylinderGas, LoadRequest, Mechanism, bearing_loads, motion};
use lanchester_model::{Engine, EngineParts};
use lanchester_multibody::{Guidance, Instant, Motion, Place, Reactions, RotorInertia, Train};
use lanchester_results::PeriodicCurve;
use nalgebra::Vector3;
use proptest::prelude::*;
use std::f64::consts::TAU;

/// Both sides are exact in every digit but the last: what is left is rounding.
const AGREES: f64 = 1e-10;

/// The gallery and what its engines need to be fired: a bore, and an angle for each cylinder.
fn gallery() -> Vec<Engine> {
    let engine = |text: &str| read(text).engine().expect("the gallery has no mistakes");
    templates().iter().map(|template| fired(&engine(template.text))).collect()
}

/// The engine with a bore and a firing angle for every cylinder.
fn fired(engine: &Engine) -> Engine {
    let moved = motion(engine, &LoadRequest::default()).expect("it turns");
    let fire = |parts: &mut EngineParts| {
        for (cylinder, motion) in parts.cylinders.iter_mut().zip(moved) {
            cylinder.bore = cylinder.bore.or(Some(0.08));
            cylinder.firing_angle = cylinder.firing_angle.or(Some(motion.top_dead_centre));
        }
    };
    engine.with(fire).unwrap()
}

/// Reactions at `theta` and constant `speed` with these gas forces.
fn reactions(train: &Train, theta: f64, speed: f64, gas: &[f64]) -> Reactions {
    let motion = Motion::fixed(theta, speed);
    let mut places: Vec<Place> = Vec::new();
    train.places_into(theta, &mut places);
    let instant = Instant {
        motion: &motion,
        places: &places,
        rates: [0.0; 7],
        gas,
        gravity: Vector3::zeros(),
        piston_damping: 0.0,
        guidance: Guidance::Crankpin,
    };
    train.reactions(&instant, &train.main_shares(&[]))
}

/// A smooth pressure that differs from cylinder to cylinder.
fn gas(engine: &Engine) -> Vec<CylinderGas> {
    let period = TAU * f64::from(engine.strokes.revolutions());
    let curve = |mean: f64, swing: f64| {
        let knots: Vec<f64> = (0..48).map(|k| period * f64::from(k) / 48.0).collect();
        let values = knots.iter().map(|at| mean + swing * (0.5 * at).cos().powi(6)).collect::<Vec<_>>();
        PeriodicCurve::through(period, knots, &values).expect("knots rise")
    };
    let of = |index: usize| CylinderGas {
        cylinder: curve(1.1e5, 4e6 + 1e5 * index as f64),
        crankcase: curve(1e5, 0.0),
    };
    (0..engine.cylinders.len()).map(of).collect()
}

/// Force, couple, roll moment and shaft torque of inertia alone.
fn check_block(engine: &Engine) {
    let speed = engine.speed.highest;
    let train = Train::new(engine, &RotorInertia::of(&engine.rotating_bodies(&[]))).expect("it turns");
    let closed = Mechanism::new(engine, &LoadRequest::default()).expect("it is valid");
    let none = vec![0.0; engine.cylinders.len()];
    let mut off = [0.0f64; 6];
    let (mut force, mut reach) = (0.0f64, 0.0f64);
    for k in 0..97 {
        let theta = TAU * f64::from(train.revolutions) * f64::from(k) / 97.0;
        let ours = reactions(&train, theta, speed, &none);
        let theirs = closed.components(theta);
        let [x, y, z] = ours.on_block.force;
        let [mx, my, mz] = ours.on_block.moment;
        let pairs = [
            (x, theirs.force_x),
            (y, theirs.force_y),
            (mx, theirs.couple_x),
            (my, theirs.couple_y),
            (mz, theirs.roll_moment),
            (ours.shaft_torque, theirs.shaft_torque),
        ];
        assert_eq!(z, 0.0);
        for (off, (ours, theirs)) in off.iter_mut().zip(pairs) {
            *off = off.max((ours - theirs).abs());
        }
        for (own, cylinder) in ours.cylinders.iter().zip(&train.cylinders) {
            let [x, y, _] = own.lower_pin.force;
            force = force.max(x.hypot(y));
            reach = reach.max(cylinder.z.abs()).max(cylinder.crankpin.norm());
        }
    }
    for (k, off) in off.into_iter().enumerate() {
        let scale = if k < 2 { force } else { force * reach };
        assert!(off <= AGREES * scale, "{}: component {k} off by {off:e} of {scale:e}", engine.name);
    }
}

/// Walls, pins and main bearings with gas.
fn check_joints(engine: &Engine) {
    let speed = engine.speed.highest;
    let train = Train::new(engine, &RotorInertia::of(&engine.rotating_bodies(&[]))).expect("it turns");
    let gas = gas(engine);
    let request = BearingRequest { samples: 41, ..BearingRequest::default() };
    let closed = bearing_loads(engine, Some(&gas), &request).expect("it is valid");
    let mut off = [0.0f64; 4];
    let mut scale = 0.0f64;
    for (j, &theta) in closed.theta.iter().enumerate() {
        let forces: Vec<f64> = (0..engine.cylinders.len())
            .map(|index| {
                let own = train.own_angle(index, theta);
                let area = train.cylinders[index].area.expect("bores are given");
                area * (gas[index].cylinder.at(own) - gas[index].crankcase.at(own))
            })
            .collect();
        let ours = reactions(&train, theta, speed, &forces);
        for (index, (own, theirs)) in ours.cylinders.iter().zip(&closed.cylinders).enumerate() {
            let axis = train.cylinders[index].axis;
            let across = |force: [f64; 3]| num_complex::Complex64::new(force[0], force[1]);
            let pin = across(own.piston_pin.force) * axis.conj();
            off[0] = off[0].max((own.side_thrust - theirs.side_thrust[j]).abs());
            off[1] = off[1].max((pin - theirs.piston_pin.load[j]).norm());
            off[2] = off[2].max((across(own.lower_pin.force) - theirs.lower_pin.load[j]).norm());
            let frame = num_complex::Complex64::new(own.rod_frame[0], own.rod_frame[1]);
            off[2] = off[2].max((frame - theirs.rod_frame[j]).norm());
            if let Some(radial) = theirs.radial.get(j) {
                let [along, drive] = own.throw_frame;
                off[2] = off[2].max((along - radial).abs()).max((drive - theirs.tangential[j]).abs());
            }
            scale = scale.max(theirs.lower_pin.load[j].norm());
        }
        for theirs in &closed.mains {
            let [x, y] = ours.rotors[theirs.crankshaft - 1].mains[0][theirs.main - 1];
            let load = theirs.load.load[j];
            off[3] = off[3].max((x - load.re).hypot(y - load.im));
        }
    }
    for (off, name) in off.into_iter().zip(["side thrust", "piston pin", "lower pin", "main bearings"]) {
        assert!(off <= AGREES * scale, "{}: {name} off by {off:e} of {scale:e}", engine.name);
    }
}

#[test]
fn xcheck_loads_on_the_block_and_shaft_torque() {
    gallery().iter().for_each(check_block);
}

#[test]
fn xcheck_walls_pins_and_mains_with_gas() {
    gallery().iter().for_each(check_joints);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// Articulated rods beside the planes of their masters among them: what they hand on reaches the mains in the plane in which it acts.
    #[test]
    fn prop_every_load_of_any_engine_is_that_of_the_closed_form(engine in any_engine(ALL_SHAPES)) {
        let engine = fired(&engine);
        check_block(&engine);
        check_joints(&engine);
    }
}
