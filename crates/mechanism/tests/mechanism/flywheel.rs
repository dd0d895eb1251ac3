//! Inertia of the train against bodies placed by plane geometry, cyclic speed fluctuation against a step-by-step integration, textbook flywheels.

use crate::support;
use crate::support::pressure::{diesel_like, fired};
use crate::support::random::{ALL_SHAPES, any_engine};
use crate::support::{assert_close, brute, in_line};
use lanchester_mechanism::*;
use lanchester_model::*;
use proptest::prelude::*;
use std::f64::consts::TAU;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    /// 1/2 J w^2 is the kinetic energy of all bodies, but for a constant: what turns about its own axis.
    #[test]
    fn prop_the_inertia_is_that_of_the_kinetic_energy(engine in any_engine(ALL_SHAPES)) {
        let theta: Vec<f64> = support::odd_angles(9).collect();
        let inertia = train_inertia(&engine, TurningInertia::default(), &theta).unwrap();
        let brute: Vec<f64> = theta.iter().map(|theta| 2.0 * brute::energy(&engine, *theta, 1.0)).collect();
        let largest = inertia.extremes.max.value;
        for j in 1..theta.len() {
            let got = inertia.total[j] - inertia.total[0];
            // Rates of the bodies by central differences.
            prop_assert!((got - (brute[j] - brute[0])).abs() < 1e-6 * largest, "{got} {}", brute[j] - brute[0]);
        }
    }
}

/// Fired in-line engine with its gas.
fn fired_in_line(angles: &[f64]) -> (Engine, Vec<CylinderGas>) {
    let mut engine = fired(in_line(angles), 0.08, Strokes::Four);
    let count = angles.len();
    engine = engine
        .with(|engine| {
            for (k, cylinder) in engine.cylinders.iter_mut().enumerate() {
                cylinder.bore = Some(0.08);
                cylinder.firing_angle = Some(2.0 * TAU * k as f64 / count as f64);
            }
        })
        .unwrap();
    let gas = vec![diesel_like(&engine, 2.5); count];
    (engine, gas)
}

/// A speed that repeats.
fn periodic(engine: &Engine, gas: Option<&[CylinderGas]>, speed: f64, given: TurningInertia) -> SpeedRipple {
    periodic_under(engine, gas, speed, given, &OuterTorque::default())
}

/// The same under torques over the angle.
fn periodic_under(
    engine: &Engine,
    gas: Option<&[CylinderGas]>,
    speed: f64,
    given: TurningInertia,
    outer: &OuterTorque,
) -> SpeedRipple {
    match speed_ripple(engine, gas, speed, outer, KnownInertia::of(given)).expect("a valid engine") {
        RippleOutcome::Periodic(ripple) => *ripple,
        other => panic!("{other:?}"),
    }
}

#[test]
fn an_inertia_that_is_not_known_is_an_outcome_with_its_key() {
    let (engine, gas) = fired_in_line(&[0.0, 0.0]);
    for (flywheel, crankshaft, keys) in [
        (None, None, vec!["flywheel.inertia".to_owned(), "flywheel.crankshaft_inertia".to_owned()]),
        (None, Some(0.1), vec!["flywheel.inertia".to_owned()]),
        (Some(0.1), None, vec!["flywheel.crankshaft_inertia".to_owned()]),
    ] {
        let known = KnownInertia { flywheel, crankshaft };
        let found = speed_ripple(&engine, Some(&gas), 90.0, &OuterTorque::default(), known).unwrap();
        let RippleOutcome::IncompleteInertia(incomplete) = &found else { panic!("{found:?}") };
        assert_eq!((&incomplete.keys, incomplete.mean_speed), (&keys, 90.0));
        assert!(found.periodic().is_none() && found.trouble().unwrap()[1].contains("[flywheel]"));
    }
}

#[test]
fn an_engine_that_stops_is_an_outcome_with_the_flywheel_that_keeps_it_turning() {
    let (engine, gas) = fired_in_line(&[0.0]);
    let (speed, light) = (60.0, TurningInertia { flywheel: 1e-4, crankshaft: 1e-4 });
    let found =
        speed_ripple(&engine, Some(&gas), speed, &OuterTorque::default(), KnownInertia::of(light)).unwrap();
    let RippleOutcome::Stops(stopped) = &found else { panic!("{found:?}") };
    assert_eq!(stopped.key, "flywheel.inertia");
    let flywheel = stopped.flywheel.unwrap();
    // Just above it turns, with the lowest speed at the limit; just below it stops.
    let turning =
        periodic(&engine, Some(&gas), speed, TurningInertia { flywheel: flywheel * 1.0001, ..light });
    let lowest = turning.speed.iter().copied().fold(f64::INFINITY, f64::min) / speed;
    assert!((STOPPED..1.01 * STOPPED).contains(&lowest), "{lowest}");
    let less = KnownInertia { flywheel: Some(flywheel * 0.999), crankshaft: Some(light.crankshaft) };
    assert!(matches!(
        speed_ripple(&engine, Some(&gas), speed, &OuterTorque::default(), less).unwrap(),
        RippleOutcome::Stops(_)
    ));
    // There the quadrature still is exact: the time of a period by integrating theta'' = T/J step by step.
    let train = GasTrain::new(&engine, &gas, Lever::Exact).unwrap();
    let given = TurningInertia { flywheel: flywheel * 1.0001, ..light };
    let inertia = |theta: f64| train_inertia(&engine, given, &[theta]).unwrap().mean;
    let state = |theta: f64| -> f64 {
        let steps = 20_000;
        let h = theta / f64::from(steps);
        let work = |t: f64| train.torque(t) - turning.load;
        (0..steps).map(|k| h * work(h * (f64::from(k) + 0.5))).sum()
    };
    let theta = turning.theta[400];
    let energy =
        0.5 * inertia(theta) * turning.speed[400].powi(2) - 0.5 * inertia(0.0) * turning.speed[0].powi(2);
    assert_close("energy", energy, state(theta), 0.0, 1e-5, "midpoint rule");
}

#[test]
fn without_gas_the_inertia_of_the_pistons_makes_the_speed_swing() {
    let (engine, _) = fired_in_line(&[0.0]);
    let given = TurningInertia { flywheel: 0.002, crankshaft: 0.001 };
    let ripple = periodic(&engine, None, 200.0, given);
    assert!(ripple.fluctuation > 0.01 && ripple.load == 0.0, "{}", ripple.fluctuation);
    // J w^2 keeps its value.
    for (j, w) in ripple.speed.iter().enumerate() {
        let energy = ripple.inertia.total[j] * w * w;
        let first = ripple.inertia.total[0] * ripple.speed[0] * ripple.speed[0];
        assert_close("energy", energy, first, 0.0, 1e-12, "nothing does work");
    }
    // Highest over lowest speed: the square root of the inertias the other way round.
    let [most, least] = [ripple.inertia.extremes.max.value, ripple.inertia.extremes.min.value];
    let ratio = ripple.extremes.max.value / ripple.extremes.min.value;
    assert_close("ratio", ratio, (most / least).sqrt(), 0.0, 1e-6, "half a degree");
}

/// A shaft that is geared to turn against the crank at twice its speed: energy counts the square of its ratio, the roll of the block its sense.
#[test]
fn an_inertia_geared_against_the_crank_counts_with_the_square_of_its_ratio_and_its_sense() {
    let (engine, gas) = fired_in_line(&[0.0, 0.0]);
    let inertia = 0.003;
    let geared = |ratio: (i32, u32)| {
        let shaft = BalanceShaft {
            name: "geared".into(),
            ratio: Ratio::new(ratio.0, ratio.1).unwrap(),
            x: 0.0,
            y: 0.1,
            weights: Vec::new(),
            inertia: Some(inertia),
        };
        engine.with(|parts| parts.shafts.push(shaft)).unwrap()
    };
    let given = TurningInertia { flywheel: 0.08, crankshaft: 0.02 };
    let bare = periodic(&engine, Some(&gas), 90.0, given);
    for (ratio, square) in [((-2, 1), 4.0), ((2, 1), 4.0), ((-1, 1), 1.0), ((-1, 2), 0.25)] {
        let geared = geared(ratio);
        let rho = f64::from(ratio.0) / f64::from(ratio.1);
        for speed in [90.0, 200.0, 400.0] {
            let ripple = periodic(&geared, Some(&gas), speed, given);
            let heavier = TurningInertia { flywheel: given.flywheel + square * inertia, ..given };
            let same = periodic(&engine, Some(&gas), speed, heavier);
            assert_close("fluctuation", ripple.fluctuation, same.fluctuation, 0.0, 1e-9, "rounding of J");
            assert_close("shafts", ripple.inertia.geared, square * inertia, 0.0, 1e-14, "J n^2");
            assert_close("mean", ripple.inertia.mean, same.inertia.mean, 0.0, 1e-12, "rounding");
        }
        // It swings less than without it: eq. (25.4).
        let less = periodic(&geared, Some(&gas), 90.0, given);
        let formula = bare.inertia.mean / (bare.inertia.mean + square * inertia);
        let got = less.simple_fluctuation / bare.simple_fluctuation;
        assert_close("by formula", got, formula, 0.0, 1e-9, "the excess energy is the same");
        // The block feels the change of the angular momentum of all rotors, each in its own sense: rho J, not rho^2 J.
        let about_z = |engine: &Engine| rotor_inertia_about_z(&engine.rotating_bodies(&[]));
        let added = about_z(&geared) - about_z(&engine);
        assert_close("about z", added, rho * inertia, 1e-15, 0.0, "one sum");
    }
    // A flywheel that keeps a fluctuation is as much smaller.
    let need = |engine: &Engine| {
        let known = KnownInertia::of(given);
        flywheel_need(engine, Some(&gas), 90.0, &OuterTorque::default(), known, 0.02)
            .unwrap()
            .flywheel
            .unwrap()
    };
    let spared = need(&engine) - need(&geared((-2, 1)));
    assert_close("spared flywheel", spared, 4.0 * inertia, 1e-9, 0.0, "bisection");
}

#[test]
fn the_ripple_is_the_one_of_the_equation_of_motion() {
    let (engine, gas) = fired_in_line(&[0.0, 0.0]);
    let given = TurningInertia { flywheel: 0.08, crankshaft: 0.02 };
    for speed in [90.0, 400.0] {
        let ripple = periodic(&engine, Some(&gas), speed, given);
        let train = GasTrain::new(&engine, &gas, Lever::Exact).unwrap();
        let inertia = |theta: f64| train_inertia(&engine, given, &[theta]).unwrap().mean;
        // J w w' + 1/2 J' w^2 = T_gas - T_load, by Runge and Kutta.
        let rate = |theta: f64, w: f64| {
            let h = 1e-4;
            let slope = (inertia(theta + h) - inertia(theta - h)) / (2.0 * h);
            (train.torque(theta) - ripple.load - 0.5 * slope * w * w) / (inertia(theta) * w)
        };
        let h = ripple.theta[1];
        let (mut w, mut time) = (ripple.speed[0], 0.0);
        for (j, theta) in ripple.theta.iter().enumerate() {
            assert_close("speed", w, ripple.speed[j], 0.0, 1e-7, "fourth order at half a degree");
            let k1 = rate(*theta, w);
            let k2 = rate(theta + 0.5 * h, w + 0.5 * h * k1);
            let k3 = rate(theta + 0.5 * h, w + 0.5 * h * k2);
            let k4 = rate(theta + h, w + h * k3);
            let next = w + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
            time += 0.5 * h * (1.0 / w + 1.0 / next);
            w = next;
        }
        assert_close("period", w, ripple.speed[0], 0.0, 1e-7, "the speed comes back");
        assert_close(
            "mean speed",
            ripple.period / time,
            speed,
            0.0,
            1e-5,
            "rectangles and trapezia at half a degree",
        );
        assert!(
            ripple.fluctuation > 0.0
                && ripple.extremes.max.value > speed
                && ripple.extremes.min.value < speed
        );
    }
}

#[test]
fn a_heavy_flywheel_follows_the_formula() {
    let (engine, gas) = fired_in_line(&[0.0, 180.0, 180.0, 0.0]);
    let need = flywheel_need(
        &engine,
        Some(&gas),
        150.0,
        &OuterTorque::default(),
        KnownInertia::of(TurningInertia::default()),
        0.001,
    )
    .unwrap();
    let torque =
        torque(&engine, &gas, &TorqueRequest { speed: Some(150.0), ..TorqueRequest::default() }).unwrap();
    assert_close(
        "formula",
        need.by_formula,
        torque.energy.excess / (0.001 * 150.0 * 150.0),
        0.0,
        1e-9,
        "the same largest excess energy",
    );
    let flywheel = need.flywheel.unwrap();
    assert_close(
        "true flywheel",
        flywheel,
        need.flywheel_by_formula,
        0.0,
        2e-3,
        "the formula is the first power of C_s",
    );
    let given = TurningInertia { flywheel, crankshaft: 0.0 };
    let ripple = periodic(&engine, Some(&gas), 150.0, given);
    assert_close("fluctuation", ripple.fluctuation, 0.001, 0.0, 1e-6, "what was asked for");
    assert_close("mean", ripple.inertia.mean, flywheel + need.train, 0.0, 1e-12, "parts add up");
    // A train that is heavy enough by itself needs none.
    let heavy = KnownInertia { flywheel: None, crankshaft: Some(1e4) };
    assert_eq!(
        flywheel_need(&engine, Some(&gas), 150.0, &OuterTorque::default(), heavy, 0.1).unwrap().flywheel,
        Some(0.0)
    );
    for wrong in [0.0, 2.0, f64::NAN] {
        assert!(flywheel_need(&engine, Some(&gas), 150.0, &OuterTorque::default(), heavy, wrong).is_err());
    }
}

/// Within a share of the value wanted.
#[track_caller]
fn near(got: f64, wanted: f64, share: f64) {
    assert_close(
        "number",
        got,
        wanted,
        0.0,
        share,
        "the printed digits, or the differences that it is made of",
    );
}

/// A crank almost without masses whose torque and load are those of the file.
fn textbook_engine(orders: &[(f64, f64, f64)], load: Option<LoadLaw>) -> (Engine, OuterTorque) {
    let mut parts = in_line(&[0.0]).into_parts();
    for cylinder in &mut parts.cylinders {
        (cylinder.piston_mass, cylinder.rod.big_end_mass, cylinder.rod.small_end_mass) = (1e-12, 0.0, 0.0);
        cylinder.rod.inertia = None;
    }
    parts.throws[0].unbalance = 0.0;
    let engine = Engine::new(parts).expect("an engine may be light");
    let torque = orders.iter().map(|&(order, sin, cos)| TorqueOrder { order, sin, cos }).collect();
    let load = load.map(|law| RunLoad { law, reacts_on: ReactsOn::Ground });
    let input = SimulationInput { torque, load, ..SimulationInput::default() };
    (engine, OuterTorque::of(Some(&input)).unwrap())
}

/// The flywheel problem of the textbooks: `T = 20000 + 9500 sin 2 theta - 5700 cos 2 theta` N m at 180 rpm, 1 % in all. The excess energy is the amplitude,
/// `sqrt(9500^2 + 5700^2) = 11079` J, the flywheel 3118 kg m^2 (printed, with rounded steps: 3121), the acceleration at 45 deg 3.04 rad/s^2.
#[test]
fn the_flywheel_problem_of_the_textbooks() {
    let (engine, outer) = textbook_engine(&[(0.0, 0.0, 20_000.0), (2.0, 9500.0, -5700.0)], None);
    let speed = 180.0 * TAU / 60.0;
    let amplitude = 9500.0f64.hypot(5700.0);
    let known = KnownInertia { flywheel: Some(0.0), crankshaft: Some(0.0) };
    let need = flywheel_need(&engine, None, speed, &outer, known, 0.01).unwrap();
    near(need.by_formula, amplitude / (0.01 * speed * speed), 1e-9);
    assert!((need.by_formula - 3121.0).abs() < 0.002 * 3121.0, "{}", need.by_formula);
    // The true speed keeps 1 % with this flywheel to the square of the fluctuation.
    let flywheel = need.flywheel.unwrap();
    assert!((flywheel / need.by_formula - 1.0).abs() < 1e-4, "{flywheel}");
    let given = TurningInertia { flywheel, ..TurningInertia::default() };
    let ripple = periodic_under(&engine, None, speed, given, &outer);
    near(ripple.load, 20_000.0, 1e-12);
    near(ripple.fluctuation, 0.01, 1e-6);
    near(ripple.excess, amplitude, 1e-9);
    // At 45 deg the torque exceeds its mean by 9500 N m; the largest by the amplitude.
    near(ripple.acceleration, amplitude / flywheel, 1e-4);
}

/// A load that goes up and down on straight lines under a torque of two orders: the excess energy of the parabolas, by hand.
#[test]
fn a_load_that_varies_over_the_angle() {
    // A triangle from 0 to 100 N m and back over a revolution, about its mean of 50; no torque but its mean. Half of it is above: 100/2 over 2 pi/4 each side.
    let points = vec![[0.0, 0.0], [TAU / 2.0, 100.0]];
    let (engine, outer) = textbook_engine(&[(0.0, 0.0, 50.0)], Some(LoadLaw::Angle { period: TAU, points }));
    let given = TurningInertia { flywheel: 2.0, ..TurningInertia::default() };
    let ripple = periodic_under(&engine, None, 60.0, given, &outer);
    let area = 0.5 * (TAU / 2.0) * 50.0;
    near(ripple.excess, area, 1e-9);
    near(ripple.load, 50.0, 1e-12);
    // 1/2 J (w_max^2 - w_min^2) is the excess energy, exactly: nothing else swings.
    let squares = ripple.extremes.max.value.powi(2) - ripple.extremes.min.value.powi(2);
    near(0.5 * 2.0 * squares, area, 1e-6);
    // Twice as often within a revolution: half the energy.
    let points = vec![[0.0, 0.0], [TAU / 4.0, 100.0]];
    let law = LoadLaw::Angle { period: TAU / 2.0, points: points.clone() };
    let (engine, outer) = textbook_engine(&[(0.0, 0.0, 50.0)], Some(law));
    near(periodic_under(&engine, None, 60.0, given, &outer).excess, 0.5 * area, 1e-9);
    // Of a table over the speed too the curve at the mean speed counts: a third of the way to twice the torque.
    let twice = vec![[0.0, 0.0], [TAU / 4.0, 200.0]];
    let [low, high] = [(50.0, points), (80.0, twice)].map(|(speed, points)| LoadCurve { speed, points });
    let law = LoadLaw::Map { period: TAU / 2.0, curves: vec![low, high] };
    let (engine, outer) = textbook_engine(&[(0.0, 0.0, 50.0)], Some(law));
    for (speed, factor) in [(30.0, 1.0), (60.0, 4.0 / 3.0), (95.0, 2.0)] {
        near(periodic_under(&engine, None, speed, given, &outer).excess, 0.5 * factor * area, 1e-9);
    }
    // Three revolutions of the load, two of half orders: the period is six.
    let points = vec![[0.0, 0.0], [TAU, 100.0]];
    let law = LoadLaw::Angle { period: 3.0 * TAU, points };
    let (engine, outer) = textbook_engine(&[(0.0, 0.0, 50.0), (0.5, 3.0, 0.0)], Some(law));
    let ripple = periodic_under(&engine, None, 60.0, given, &outer);
    near(ripple.period, 6.0 * TAU, 1e-12);
    // A period that no 120 revolutions hold is refused.
    let order = TorqueOrder { order: std::f64::consts::SQRT_2, sin: 1.0, cos: 0.0 };
    let odd = SimulationInput { torque: vec![order], ..SimulationInput::default() };
    assert!(OuterTorque::of(Some(&odd)).is_err());
}
