//! Random valid engines of many shapes: several throws and cylinders a throw, offsets, articulated rods, rods with
//! inertia, a geared second crankshaft, counterweights and shafts.

use crate::hand_made::{crankshaft, parts};
use lanchester_model::*;
use proptest::prelude::*;
use std::f64::consts::TAU;

/// What may be added to plain rods.
#[derive(Debug, Clone, Copy)]
pub struct Shape {
    /// A second, geared crankshaft.
    pub geared: bool,
    /// Articulated rods.
    pub articulated: bool,
}

/// All shapes.
pub const ALL_SHAPES: Shape = Shape { geared: true, articulated: true };

/// Plain rods on one crankshaft.
pub const PLAIN: Shape = Shape { geared: false, articulated: false };

fn share() -> impl Strategy<Value = f64> {
    0.0..1.0f64
}

fn angle() -> impl Strategy<Value = f64> {
    0.0..TAU
}

/// A rod of at least 1.5 times what it has to bridge, as `(length factor, mass, place of its centre, inertia)`.
fn any_rod() -> impl Strategy<Value = (f64, f64, f64, Option<f64>)> {
    (1.5..4.0f64, 0.2..1.0f64, 0.2..0.5f64, prop::option::of(0.05..0.4f64))
}

prop_compose! {
    fn any_throw(shape: Shape)(
        second in share(), angle in angle(), z in -0.3..0.3f64, radius in 0.03..0.06f64,
        unbalance in -0.01..0.03f64,
    ) -> Throw {
        let crankshaft = usize::from(shape.geared && second > 0.6);
        Throw { crankshaft, angle, z, radius, unbalance, unbalance_offset: 0.0, webs: None }
    }
}

prop_compose! {
    fn any_cylinder(shape: Shape)(
        angle in angle(), shift in -0.02..0.02f64, offset in -0.01..0.01f64, pin_offset in -0.002..0.002f64,
        centred in share(), piston_mass in 0.2..1.5f64, (factor, mass, centre, inertia) in any_rod(),
        slave in share(), knuckle_radius in 0.02..0.05f64, knuckle_error in -0.2..0.2f64,
    ) -> (Cylinder, f64, bool, f64, f64) {
        let offset = if centred < 0.4 { [0.0, 0.0] } else { [offset, pin_offset] };
        let rod = Rod {
            length: factor,
            big_end_mass: mass * (1.0 - centre),
            small_end_mass: mass * centre,
            inertia,
            axial_inertia: 0.0,
            mass_rule: RodMassRule::CentreOfGravity,
            joint: RodJoint::Crankpin,
        };
        let cylinder = Cylinder {
            throw: 0, angle, z: shift, offset: offset[0], pin_offset: offset[1], bore: None, piston_mass, rod,
            firing_angle: None,
            chamber: None,
        };
        (cylinder, factor, shape.articulated && slave > 0.4, knuckle_radius, knuckle_error)
    }
}

prop_compose! {
    fn any_shaft()(
        ratio in prop::sample::select(vec![(-1, 1), (1, 1), (2, 1), (-2, 1), (-3, 2), (1, 2)]),
        x in -0.2..0.2f64, y in -0.2..0.2f64,
        weights in prop::collection::vec((-0.3..0.3f64, 0.0..0.02f64, angle()), 1..3),
    ) -> BalanceShaft {
        let weights = weights.into_iter().map(|(z, unbalance, phase)| ShaftWeight::new(z, unbalance, phase)).collect();
        BalanceShaft { name: "shaft".into(), ratio: Ratio::new(ratio.0, ratio.1).expect("not 0"), x, y, weights, inertia: None }
    }
}

/// A random valid engine; every rod has `l >= 1.5 (r + |e|)`.
pub fn any_engine(shape: Shape) -> impl Strategy<Value = Engine> {
    let throws =
        prop::collection::vec((any_throw(shape), prop::collection::vec(any_cylinder(shape), 1..4)), 1..5);
    let weights = prop::collection::vec((-0.3..0.3f64, 0.0..0.03f64, angle()), 0..3);
    let second = prop::sample::select(vec![(-1, 1), (1, 1), (1, 2), (-1, 2), (3, 2), (2, 1)]);
    let gear = (second, angle(), -0.3..0.3f64, -0.3..0.3f64);
    let shafts = prop::collection::vec(any_shaft(), 0..3);
    (throws, weights, gear, shafts, 50.0..700.0f64).prop_map(move |(throws, weights, gear, shafts, speed)| {
        let mut cylinders = Vec::new();
        for (index, (throw, riders)) in throws.iter().enumerate() {
            let master = cylinders.len();
            for (place, rider) in riders.iter().enumerate() {
                let (mut cylinder, factor, slave, knuckle_radius, knuckle_error) = rider.clone();
                cylinder.throw = index;
                cylinder.z += throw.z;
                let mut bridged = throw.radius + cylinder.net_offset().abs();
                if slave && place > 0 {
                    let driver: &Cylinder = &cylinders[master];
                    // The knuckle pin swings by its own radius and shares the master's swing.
                    bridged += 1.5 * knuckle_radius;
                    let knuckle_angle = cylinder.angle - driver.angle + knuckle_error;
                    cylinder.rod.joint = RodJoint::Articulated { master, knuckle_radius, knuckle_angle };
                }
                cylinder.rod.length = factor * bridged;
                // The inertia drawn is a share of m l^2.
                let scale = cylinder.rod.mass() * cylinder.rod.length.powi(2);
                cylinder.rod.inertia = cylinder.rod.inertia.map(|share| share * scale);
                cylinders.push(cylinder);
            }
        }
        let mut engine = parts("random", throws.into_iter().map(|(throw, _)| throw).collect(), cylinders);
        engine.speed = SpeedRange { lowest: speed, highest: speed };
        if shape.geared {
            let ((numerator, denominator), phase, x, y) = gear;
            let ratio = Ratio::new(numerator, denominator).expect("not 0");
            engine.crankshafts.push(Crankshaft { name: "second".into(), ratio, phase, x, y, ..crankshaft() });
        }
        let crankshafts = engine.crankshafts.len();
        engine.counterweights = weights
            .into_iter()
            .enumerate()
            .map(|(k, (z, unbalance, angle))| Counterweight {
                name: format!("weight {k}"),
                crankshaft: k % crankshafts,
                z,
                unbalance,
                angle,
                part: None,
            })
            .collect();
        engine.shafts = shafts;
        for (index, shaft) in engine.shafts.iter_mut().enumerate() {
            shaft.name = format!("shaft {}", index + 1);
        }
        Engine::new(engine).unwrap()
    })
}
