//! Engines for the tests of this room.

use lanchester_model::*;

/// An in-line engine of the twin's cylinders, 88 mm apart, with throws at these angles [deg].
pub(crate) fn in_line(angles: &[f64]) -> Engine {
    let z = |k: usize| 0.088 * (k as f64 - 0.5 * (angles.len() - 1) as f64);
    let throws = angles.iter().enumerate().map(|(k, angle)| Throw {
        crankshaft: 0,
        angle: angle.to_radians(),
        z: z(k),
        radius: 0.04775,
        unbalance: 0.0,
        unbalance_offset: 0.0,
        webs: None,
    });
    let cylinders = (0..angles.len()).map(|k| Cylinder {
        throw: k,
        angle: 0.0,
        z: z(k),
        offset: 0.0,
        pin_offset: 0.0,
        bore: Some(0.0795),
        piston_mass: 0.7754,
        rod: Rod {
            length: 0.144,
            big_end_mass: 0.6287 * 2.0 / 3.0,
            small_end_mass: 0.6287 / 3.0,
            inertia: None,
            axial_inertia: 0.0,
            mass_rule: RodMassRule::Thirds,
            joint: RodJoint::Crankpin,
        },
        firing_angle: None,
        chamber: None,
    });
    Engine::new(EngineParts {
        name: "sample".to_owned(),
        strokes: Strokes::Four,
        rotation: Rotation::Clockwise,
        speed: SpeedRange { lowest: 418.879, highest: 418.879 },
        crankshafts: vec![Crankshaft {
            name: "crankshaft".to_owned(),
            ratio: Ratio::ONE,
            phase: 0.0,
            x: 0.0,
            y: 0.0,
            mains: None,
        }],
        throws: throws.collect(),
        cylinders: cylinders.collect(),
        ..EngineParts::default()
    })
    .expect("the parts of an engine")
}

/// The in-line twin with pistons in step.
pub(crate) fn twin() -> Engine {
    in_line(&[0.0, 0.0])
}
