//! Every load against an independent derivation: momentum, spin and energy of bodies placed by plane geometry.
use crate::support::random::{ALL_SHAPES, any_engine};
use crate::support::{assert_close, brute, list, odd_angles, radial};
use lanchester_mechanism::{LoadRequest, Mechanism, Part, Selection};
use lanchester_model::Engine;
use proptest::prelude::*;

const NAMES: [&str; 6] = ["force x", "force y", "couple x", "couple y", "roll moment", "shaft torque"];

/// Compares all six components at some angles; the scale is the largest sum of amounts of the parts.
fn compare(engine: &Engine, reference: [f64; 3]) {
    let request = LoadRequest { reference, ..LoadRequest::default() };
    let mechanism = Mechanism::new(engine, &request).expect("the engine is valid");
    let speed = engine.speed.highest;
    let parts: Vec<Mechanism> = Part::ALL
        .iter()
        .map(|&p| Mechanism::of(engine, &request, Selection::Part(p)).expect("the engine is valid"))
        .collect();
    let mut scale = [0.0f64; 2];
    for theta in odd_angles(16) {
        for part in &parts {
            let c = part.components(theta);
            scale[0] = scale[0].max(c.force_x.hypot(c.force_y));
            scale[1] = scale[1].max(c.couple_x.hypot(c.couple_y)).max(c.roll_moment.abs());
        }
    }
    for theta in odd_angles(7) {
        let (got, wanted) =
            (list(mechanism.components(theta)), brute::loads(engine, reference, theta, speed));
        for ((name, got), (k, wanted)) in NAMES.iter().zip(got).zip(wanted.into_iter().enumerate()) {
            let absolute = 1e-8 * scale[usize::from(k > 1)];
            assert_close(name, got, wanted, absolute, 0.0, "two numerical derivatives of step 6e-3 rad");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn prop_loads_are_minus_the_change_of_momentum(
        engine in any_engine(ALL_SHAPES), x in -0.2..0.2f64, y in -0.2..0.2f64, z in -0.3..0.3f64,
    ) {
        compare(&engine, [x, y, z]);
    }
}

#[test]
fn radial_nine_with_articulated_rods() {
    let mut engine = radial(9, 0.06);
    engine = engine
        .with(|engine| {
            engine.cylinders[0].rod.inertia = Some(0.05);

            engine.cylinders[4].rod.inertia = Some(0.01);
        })
        .unwrap();
    compare(&engine, [0.0; 3]);
    compare(&engine, [0.03, -0.11, 0.2]);
}
