//! Scatter of engines with articulated rods and of engines with geared crankshafts: every sample is an engine.
use crate::scatter::{all_outputs, deviated, everything, orders, request, tolerance, wanted, with_parts};
use lanchester_model::{Engine, Ratio, RodJoint};
use lanchester_study::explore::Sense;
use lanchester_study::scatter::*;
use lanchester_task::{Distribution, Extent, Tolerance, Varied};
use lanchester_testkit::gallery::gallery as engine;

/// Masters with 2, 8 and twice 6 articulated rods; crankshafts that turn opposite and the same way.
const ENGINES: [&str; 6] = ["radial-3", "radial-9", "radial-14", "square-4", "opposed-piston-3", "v6-60"];

/// Everything off, for all parts together and part by part.
fn wide(engine: &Engine) -> Vec<Tolerance> {
    let mut tolerances = everything(engine);
    for (quantity, half_width) in [
        (Varied::RodLength, 0.002),
        (Varied::CylinderAngle, 0.01),
        (Varied::Offset, 0.001),
        (Varied::ThrowAngle, 0.02),
        (Varied::CylinderPlane, 0.001),
    ] {
        tolerances.push(tolerance(quantity, half_width, Extent::Common));
    }
    for tolerance in &mut tolerances {
        tolerance.distribution = Distribution::Uniform;
    }
    tolerances
}

/// What the moving masses exert if all point one way [N].
fn scale(engine: &Engine) -> f64 {
    let masses = engine
        .cylinders
        .iter()
        .map(|c| (c.piston_mass + c.rod.small_end_mass + c.rod.big_end_mass) * engine.throws[c.throw].radius);
    masses.sum::<f64>() * engine.speed.highest.powi(2)
}

/// Largest difference of samples from the loads of the engines that they are, over the scale; its output is told too.
fn farthest_sample(engine: &Engine, tolerances: &[Tolerance], samples: u64) -> (f64, String) {
    let scattering =
        Scattering::new(request(engine.clone(), tolerances.to_vec(), samples)).expect("a scatter");
    let mut drawn = Drawn::default();
    scattering.draw(0..samples, Some(&mut drawn));
    let mut worst = (0.0, String::new());
    for sample in 0..samples as usize {
        let deviations: Vec<f64> = drawn.deviations.iter().map(|all| all[sample]).collect();
        let built = deviated(engine, tolerances, &deviations);
        for (place, output) in all_outputs().into_iter().enumerate() {
            let (got, wanted) = (drawn.outputs[place][sample], wanted(&built, output));
            let off = (got - wanted).abs() / scale(engine);
            if off > worst.0 || off.is_nan() {
                worst = (off, format!("{} {}, sample {sample}: {got} {wanted}", engine.name, output.name()));
            }
        }
    }
    worst
}

#[test]
fn samples_are_the_engines_that_they_draw() {
    for name in ENGINES {
        let engine = engine(name);
        let (off, which) = farthest_sample(&engine, &wide(&engine), 16);
        // Orders beyond the last that matters are 1e-13 of the first each; the rest is rounding.
        assert!(off < 2e-13, "{off:.2e} {which}");
    }
}

/// Engines of the gallery changed: shafts of other speeds, rods that nearly lock.
fn changed() -> Vec<Engine> {
    let ratio = |numerator| Ratio::new(numerator, 1).expect("it is not 0");
    let geared = |name: &str, numerator: i32| {
        let change = |parts: &mut lanchester_model::EngineParts| {
            let mut second = parts.crankshafts[0].clone();
            (second.name, second.ratio, second.phase) = ("second".into(), ratio(numerator), 0.4);
            parts.crankshafts.push(second);
            parts.throws.iter_mut().for_each(|throw| throw.crankshaft = 1);
            parts.counterweights.iter_mut().for_each(|weight| weight.crankshaft = 1);
        };
        engine(name).with(change).expect("it turns")
    };
    let faster = engine("square-4").with(|parts| parts.crankshafts[1].ratio = ratio(-2)).expect("it turns");
    vec![geared("radial-3", -1), geared("radial-3", 3), faster, with_short_rods(0.5)]
}

/// A radial three whose articulated rods have a share of their length; they cannot turn with less than a third.
fn with_short_rods(share: f64) -> Engine {
    let shorten = |parts: &mut lanchester_model::EngineParts| {
        for cylinder in &mut parts.cylinders {
            if matches!(cylinder.rod.joint, RodJoint::Articulated { .. }) {
                cylinder.rod.length *= share;
            }
        }
    };
    engine("radial-3").with(shorten).expect("it turns")
}

#[test]
fn geared_and_nearly_locked_samples_are_the_engines_that_they_draw() {
    for engine in changed() {
        let (off, which) = farthest_sample(&engine, &wide(&engine), 16);
        assert!(off < 2e-13, "{off:.2e} {which}");
    }
}

/// Deviations of the corner number `number`.
fn corner(tolerances: &[Tolerance], engine: &Engine, number: u64) -> Vec<f64> {
    let mut state = number.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut side = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        if state >> 40 & 1 == 1 { 1.0 } else { -1.0 }
    };
    let mut deviations = Vec::new();
    for tolerance in tolerances {
        let parts = match tolerance.extent {
            Extent::Common => 1,
            Extent::PerPart => tolerance.quantity.parts(engine),
        };
        deviations.extend((0..parts).map(|_| side() * tolerance.half_width));
    }
    deviations
}

/// Corners built as engines lie below the bound: with all tolerances, and with each kind of length and angle alone, which leaves the bound
/// nothing to hide behind.
#[test]
fn no_corner_lies_beyond_the_bound() {
    let check = |engine: &Engine, tolerances: &[Tolerance], corners: u64| {
        let request = request(engine.clone(), tolerances.to_vec(), 8);
        let cases = worst_cases(&request).expect("worst cases");
        for number in 1..=corners {
            let built = deviated(engine, tolerances, &corner(tolerances, engine, number));
            for case in &cases {
                let got = wanted(&built, case.output);
                let told = format!("{} {:?} {}: {got}", engine.name, tolerances[0], case.output.name());
                assert!(got <= case.bound + 1e-13 * scale(engine), "{told} {}", case.bound);
            }
        }
        for case in &cases {
            let told = format!("{} {:?}: {case:?}", engine.name, tolerances[0]);
            assert!(case.attained <= case.bound + 1e-13 * scale(engine), "{told}");
        }
    };
    for engine in ENGINES.map(engine).into_iter().chain(changed()) {
        check(&engine, &wide(&engine), 24);
    }
    for engine in [engine("radial-3"), with_short_rods(0.4)] {
        for (quantity, half_width) in [
            (Varied::RodLength, 0.001),
            (Varied::CrankRadius, 0.001),
            (Varied::CylinderAngle, 0.01),
            (Varied::ThrowAngle, 0.02),
            (Varied::Offset, 0.001),
            (Varied::RodCentre, 0.002),
        ] {
            check(&engine, &[tolerance(quantity, half_width, Extent::PerPart)], 16);
        }
    }
}

/// The bound of one small deviation is its first derivative in each part, and next to nothing for the second.
#[test]
fn the_bound_of_a_small_deviation_is_nearly_attained() {
    let engine = engine("radial-9");
    // Far from balance, so that the change of a size is the change along the vector.
    let heavy = engine.with(|parts| parts.counterweights.clear()).expect("it turns");
    let tolerances = [tolerance(Varied::CrankRadius, 1e-5, Extent::Common)];
    let mut request = request(heavy, tolerances.to_vec(), 8);
    request.outputs = vec![Output::ForceSense { order: 1, sense: Sense::Forward }];
    let case = &worst_cases(&request).expect("worst cases")[0];
    let ratio = (case.bound - case.nominal) / (case.attained - case.nominal);
    assert!((1.0..1.2).contains(&ratio), "{ratio} {case:?}");
}

#[test]
fn what_cannot_be_is_refused_with_its_cylinder_or_crankshaft() {
    let refused = |engine: Engine, half_width: f64| {
        let tolerances = vec![tolerance(Varied::RodLength, half_width, Extent::PerPart)];
        worst_cases(&request(engine, tolerances, 8)).map(|_| ()).map_err(|refused| refused.to_string())
    };
    assert_eq!(refused(with_short_rods(0.4), 0.001), Ok(()));
    // Both rods of the masters stay long enough.
    let told = refused(with_short_rods(0.4), 0.03).expect_err("the rod would lose its knuckle pin");
    assert!(told.contains("cylinder 2 would be no cylinder: its crank could not turn"), "{told}");
    let half = Ratio::new(1, 2).expect("it is not 0");
    let slow = engine("square-4").with(|parts| parts.crankshafts[1].ratio = half).expect("it turns");
    let told = refused(slow, 0.001).expect_err("half the speed");
    assert!(told.contains("got the crankshaft \"rear\" at 1/2 of it"), "{told}");
}

/// All assignments of a radial three built as engines: the master rod keeps its place, and none leaves less.
#[test]
fn rods_take_the_places_of_their_kind() {
    let engine = engine("radial-3");
    let rods = [(2.1, 0.8), (0.62, 0.41), (0.58, 0.44)]
        .map(|(big_end_mass, small_end_mass)| WeighedRod { big_end_mass, small_end_mass });
    let request = AssignmentRequest {
        engine: engine.clone(),
        speed: None,
        pistons: vec![0.861, 0.849, 0.855],
        rods: rods.to_vec(),
        lever: 0.2,
    };
    let found = assign(&request).expect("an assignment");
    let own = with_parts(&engine, &request, &found.pistons, &found.rods);
    assert!(found.proved && (own - found.residual).abs() < 1e-9 * own, "{own} {found:?}");
    assert_eq!(found.rods[0], 1, "the master rod is the only one of its kind");
    for pistons in orders(3) {
        for rods in [[1, 2, 3], [1, 3, 2]] {
            let other = with_parts(&engine, &request, &pistons, &rods);
            assert!(other >= found.residual * (1.0 - 1e-9), "{pistons:?} {rods:?}: {other}");
        }
    }
    // Beyond eight cylinders exchanges keep to kinds too.
    let nine = lanchester_testkit::gallery::gallery("radial-9");
    let rod = |k: usize| WeighedRod { big_end_mass: 1.35 + 0.01 * (k * 5 % 7) as f64, small_end_mass: 0.85 };
    let request = AssignmentRequest {
        pistons: (0..9).map(|k| 3.0 + 0.01 * (k * 4 % 9) as f64).collect(),
        rods: (0..9).map(rod).collect(),
        engine: nine.clone(),
        ..request
    };
    let found = assign(&request).expect("an assignment");
    let own = with_parts(&nine, &request, &found.pistons, &found.rods);
    assert!((own - found.residual).abs() < 1e-9 * own.max(1.0), "{own} {found:?}");
    assert!(found.rods[0] == 1 && found.bound <= found.residual && found.residual < found.as_numbered);
}
