//! Engines made by hand, with the masses of the twin thesis's size.

use lanchester_model::*;
use std::f64::consts::TAU;

/// A rod by its two ends.
pub fn rod(length: f64, big: f64, small: f64) -> Rod {
    Rod {
        length,
        big_end_mass: big,
        small_end_mass: small,
        inertia: None,
        axial_inertia: 0.0,
        mass_rule: RodMassRule::WeighedEnds,
        joint: RodJoint::Crankpin,
    }
}

/// A cylinder on throw `throw` at axis angle `angle`, with the masses of the twin thesis's size.
pub fn cylinder(throw: usize, angle: f64, z: f64) -> Cylinder {
    Cylinder {
        throw,
        angle,
        z,
        offset: 0.0,
        pin_offset: 0.0,
        bore: None,
        piston_mass: 0.5,
        rod: rod(0.15, 0.4, 0.2),
        firing_angle: None,
        chamber: None,
    }
}

/// A throw of 45 mm radius.
pub fn throw(angle: f64, z: f64) -> Throw {
    Throw { crankshaft: 0, angle, z, radius: 0.045, unbalance: 0.01, unbalance_offset: 0.0, webs: None }
}

/// The first crankshaft.
pub fn crankshaft() -> Crankshaft {
    Crankshaft { name: "crankshaft".into(), ratio: Ratio::ONE, phase: 0.0, x: 0.0, y: 0.0, mains: None }
}

/// An engine of these throws and cylinders at 300 rad/s.
pub fn engine(name: &str, throws: Vec<Throw>, cylinders: Vec<Cylinder>) -> Engine {
    Engine::new(parts(name, throws, cylinders)).unwrap()
}

/// As [`engine`], to be changed.
pub fn parts(name: &str, throws: Vec<Throw>, cylinders: Vec<Cylinder>) -> EngineParts {
    EngineParts {
        name: name.into(),
        strokes: Strokes::Four,
        rotation: Rotation::Clockwise,
        speed: SpeedRange { lowest: 300.0, highest: 300.0 },
        crankshafts: vec![crankshaft()],
        throws,
        cylinders,
        ..EngineParts::default()
    }
}

/// An in-line engine: throws at these angles [deg], 90 mm apart, symmetric about the origin.
pub fn in_line(angles: &[f64]) -> Engine {
    let z = |k: usize| 0.09 * (k as f64 - 0.5 * (angles.len() - 1) as f64);
    engine(
        "in-line",
        angles.iter().enumerate().map(|(k, a)| throw(a.to_radians(), z(k))).collect(),
        (0..angles.len()).map(|k| cylinder(k, 0.0, z(k))).collect(),
    )
}

/// A V engine with shared pins at these angles [deg] and this bank angle [deg]; both rods of a pin in its plane.
pub fn vee(bank: f64, pins: &[f64]) -> Engine {
    let z = |k: usize| 0.11 * (k as f64 - 0.5 * (pins.len() - 1) as f64);
    let half = 0.5 * bank.to_radians();
    engine(
        "vee",
        pins.iter().enumerate().map(|(k, a)| throw(a.to_radians(), z(k))).collect(),
        (0..2 * pins.len())
            .map(|c| cylinder(c / 2, if c % 2 == 0 { -half } else { half }, z(c / 2)))
            .collect(),
    )
}

/// A single-row radial with `count` cylinders, cylinder 1 the master, knuckle pins at `knuckle` m.
pub fn radial(count: usize, knuckle: f64) -> Engine {
    let cylinders = (0..count)
        .map(|k| {
            let angle = TAU * k as f64 / count as f64;
            let mut cylinder = cylinder(0, angle, 0.0);
            cylinder.piston_mass = 2.5;
            cylinder.rod = rod(0.35, 5.0, 1.2);
            if k > 0 {
                cylinder.rod = rod(0.35 - knuckle, 0.8, 0.6);
                cylinder.rod.joint =
                    RodJoint::Articulated { master: 0, knuckle_radius: knuckle, knuckle_angle: angle };
            }
            cylinder
        })
        .collect();
    let mut pin = throw(0.0, 0.0);
    pin.radius = 0.08;
    engine("radial", vec![pin], cylinders)
}
