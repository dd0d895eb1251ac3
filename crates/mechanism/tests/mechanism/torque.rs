//! Torque of gas and inertia: virtual work, work by routes that share nothing, orders, levers, firing, textbook cases.

use crate::support;
use crate::support::pressure::{any_gas, block, cycle, diesel_like, fired};
use crate::support::random::{ALL_SHAPES, any_engine};
use crate::support::{assert_close, brute, cylinder, engine, in_line, radial, throw, vee};
use lanchester_file::{read, template};
use lanchester_mechanism::*;
use lanchester_model::*;
use lanchester_results::PeriodicCurve;
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

/// An engine of a random shape, fired, with pressures of its own for every cylinder.
fn any_fired() -> impl Strategy<Value = (Engine, Vec<CylinderGas>)> {
    (any_engine(ALL_SHAPES), any::<bool>()).prop_flat_map(|(engine, two)| {
        let engine = fired(engine, 0.07, if two { Strokes::Two } else { Strokes::Four });
        let gas = prop::collection::vec(any_gas(cycle(&engine)), engine.cylinders.len());
        (Just(engine), gas)
    })
}

fn work_scale(engine: &Engine, gas: &[CylinderGas]) -> f64 {
    let of = |(cylinder, gas): (&Cylinder, &CylinderGas)| {
        let area = 0.25 * PI * cylinder.bore.expect("it was given one").powi(2);
        let largest = |curve: &PeriodicCurve| curve.extremes().iter().fold(0.0f64, |m, e| m.max(e.0.abs()));
        area * (largest(&gas.cylinder) + largest(&gas.crankcase)) * engine.throws[cylinder.throw].radius
    };
    engine.cylinders.iter().zip(gas).map(of).sum()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// T dtheta = - SUM f ds with the pistons placed by plane geometry, at every angle.
    #[test]
    fn prop_gas_torque_is_virtual_work((engine, gas) in any_fired()) {
        let train = GasTrain::new(&engine, &gas, Lever::Exact).unwrap();
        let motion = motion(&engine, &LoadRequest { samples: 1, ..LoadRequest::default() }).unwrap();
        let scale = work_scale(&engine, &gas);
        for theta in support::odd_angles(7) {
            let mut wanted = 0.0;
            for (index, (cylinder, gas)) in engine.cylinders.iter().zip(&gas).enumerate() {
                let ratio = engine.crankshafts[engine.throws[cylinder.throw].crankshaft].ratio.value();
                let own = ratio.abs() * (theta - motion[index].firing_angle.unwrap());
                let area = 0.25 * PI * cylinder.bore.unwrap().powi(2);
                let force = area * (gas.cylinder.at(own) - gas.crankcase.at(own));
                let along = |theta: f64| {
                    let [_, pin, _] = brute::joints(&engine, index, theta);
                    pin[0] * cylinder.angle.cos() + pin[1] * cylinder.angle.sin()
                };
                let h = 1e-3;
                let rate = (8.0 * (along(theta + h) - along(theta - h))
                    - (along(theta + 2.0 * h) - along(theta - 2.0 * h))) / (12.0 * h);
                wanted -= force * rate;
            }
            let got = train.torque(theta);
            // Fourth-order difference over 2e-3 rad: truncation and rounding near 1e-11 of the values.
            prop_assert!((got - wanted).abs() < 1e-8 * scale, "{got} {wanted} {scale}");
        }
    }

    /// The three routes of the work agree for any trace, and the means are theirs.
    #[test]
    fn prop_work_by_torque_and_by_volume_agree((engine, gas) in any_fired()) {
        let request = TorqueRequest { samples: 36, ..TorqueRequest::default() };
        let torque = torque(&engine, &gas, &request).unwrap();
        let scale = work_scale(&engine, &gas);
        let mut mean = 0.0;
        for (cylinder, result) in engine.cylinders.iter().zip(&torque.cylinders) {
            let work = result.work;
            prop_assert!((work.by_torque - work.by_volume).abs() < 1e-9 * scale, "{work:?} {scale}");
            prop_assert!((work.by_rods - work.by_volume).abs() < 1e-9 * scale, "{work:?} {scale}");
            prop_assert!((work.cylinder + work.crankcase - work.by_volume).abs() < 1e-9 * scale, "{work:?}");
            let ratio = engine.crankshafts[engine.throws[cylinder.throw].crankshaft].ratio.value();
            mean += work.by_volume * ratio.abs() / cycle(&engine);
        }
        prop_assert!((torque.indicated.torque - mean).abs() < 1e-9 * scale);
        prop_assert!((torque.harmonics[0].gas.re - mean).abs() < 1e-9 * scale);
        // The stretches between breaks are a third quadrature.
        prop_assert!((torque.energy.mean - mean).abs() < 1e-9 * scale + 1e-9 * torque.inertia_extremes.max_abs());
    }

    /// The block feels the gas as the reaction to its torque alone, order by order; inertia is not touched.
    #[test]
    fn prop_gas_adds_torque_and_its_reaction_alone((engine, gas) in any_fired()) {
        let request = TorqueRequest { samples: 12, max_order: 4, ..TorqueRequest::default() };
        let torque = torque(&engine, &gas, &request).unwrap();
        let inertia = total_loads(&engine, &LoadRequest { max_order: 4, ..LoadRequest::default() }).unwrap().orders;
        for (order, harmonic) in torque.orders.iter().zip(&torque.harmonics) {
            let own = inertia.iter().find(|i| (i.order - order.order).abs() < 1e-9);
            let force = own.map_or(0.0.into(), |i| i.force_forward);
            prop_assert_eq!(order.force_forward, force);
            let roll = own.map_or(0.0.into(), |i| i.roll_moment) - harmonic.gas;
            prop_assert!((order.roll_moment - roll).norm() <= 1e-9 * work_scale(&engine, &gas));
        }
    }
}

#[test]
fn orders_are_those_of_the_torque() {
    let engine = fired(vee(60.0, &[0.0, 120.0, 240.0]), 0.09, Strokes::Four);
    let gas: Vec<CylinderGas> = (0..6).map(|k| diesel_like(&engine, 2.0 + 0.1 * f64::from(k))).collect();
    let train = GasTrain::new(&engine, &gas, Lever::Exact).unwrap();
    let orders = train.orders(12);
    let halves: Vec<f64> = orders.iter().map(|o| o.order).collect();
    assert_eq!(halves, (0..=24).map(|n| f64::from(n) / 2.0).collect::<Vec<_>>());
    // The torque of a spline has bends in its third derivative: the trapezoidal rule over 7200 angles has order n right to
    // (7200 - 2 n)^-4 of it.
    let count = 7200;
    let samples: Vec<f64> =
        (0..count).map(|j| train.torque(2.0 * TAU * f64::from(j) / f64::from(count))).collect();
    let scale = work_scale(&engine, &gas);
    for order in &orders {
        let sides = if order.order == 0.0 { 1.0 } else { 2.0 };
        let turn =
            |j: usize| num_complex::Complex64::cis(-order.order * 2.0 * TAU * j as f64 / f64::from(count));
        let wanted: num_complex::Complex64 =
            samples.iter().enumerate().map(|(j, t)| turn(j) * (sides * t / f64::from(count))).sum();
        assert!((order.shaft_torque - wanted).norm() < 1e-9 * scale, "{}: {wanted}", order.order);
        assert_eq!(order.roll_moment, -order.shaft_torque);
    }
}

#[test]
fn a_constant_pressure_over_the_stroke_does_its_pressure_times_the_swept_volume() {
    let mut engine =
        fired(engine("single", vec![throw(0.0, 0.0)], vec![cylinder(0, 0.0, 0.0)]), 0.08, Strokes::Four);
    engine = engine
        .with(|engine| {
            engine.cylinders[0].firing_angle = Some(0.0);
        })
        .unwrap();
    // Centred: bottom dead centre half a turn after top dead centre.
    let gas = block(&engine, 2e6, PI);
    let torque = torque(&engine, &[gas], &TorqueRequest::default()).unwrap();
    let swept = 0.25 * PI * 0.08f64.powi(2) * 0.09;
    let work = torque.cylinders[0].work;
    assert_close("swept volume", work.swept, swept, 0.0, 1e-14, "closed form");
    assert_close("work by torque", work.by_torque, 2e6 * swept, 0.0, 1e-12, "Gauss rule on analytic pieces");
    assert_close("work by volume", work.by_volume, 2e6 * swept, 0.0, 1e-12, "geometric series");
    assert_close("net", work.imep(), 2e6, 0.0, 1e-12, "as above");
    assert_close("gross", work.gross_imep(), 2e6, 0.0, 1e-12, "as above");
    assert_close("torque", torque.indicated.torque, 2e6 * swept / (4.0 * PI), 0.0, 1e-12, "as above");
    assert_close("power", torque.indicated.power, 2e6 * swept / (4.0 * PI) * 300.0, 0.0, 1e-12, "as above");
    assert_close("piston speed", torque.indicated.mean_piston_speed, 0.18 * 300.0 / TAU, 0.0, 1e-12, "2 s n");
    // Largest p A r sin(phi + beta)/cos(beta) where the rod stands at a right angle to the crank, nearly.
    let most = torque.gas_extremes.max.value / (2e6 * 0.25 * PI * 0.08f64.powi(2) * 0.045);
    assert!(most > 1.03 && most < 1.05, "{most}");
    // Nothing is stored but the stroke less its share of the mean.
    let stored = torque.gas_energy.excess / (2e6 * swept);
    assert!(stored > 0.75 && stored < 0.8, "{stored}");
}

#[test]
fn the_sine_lever_is_that_of_a_long_rod() {
    let build = |length: f64| {
        let mut engine = fired(in_line(&[0.0, 180.0, 180.0, 0.0]), 0.08, Strokes::Four);
        engine = engine
            .with(|engine| {
                for cylinder in &mut engine.cylinders {
                    cylinder.rod.length = length;
                }
            })
            .unwrap();
        engine
    };
    let mean = |engine: &Engine, lever| {
        let gas = vec![diesel_like(engine, 2.5); 4];
        torque(engine, &gas, &TorqueRequest { lever, ..TorqueRequest::default() }).unwrap()
    };
    let engine = build(0.15);
    let [exact, sine] = [Lever::Exact, Lever::Sine].map(|lever| mean(&engine, lever).indicated.torque);
    assert!(sine < 0.92 * exact && sine > 0.75 * exact, "{sine} {exact}");
    let long = build(4500.0);
    let [exact, sine] = [Lever::Exact, Lever::Sine].map(|lever| mean(&long, lever));
    assert_close(
        "torque",
        sine.indicated.torque,
        exact.indicated.torque,
        0.0,
        3e-5,
        "first power of r/l = 1e-5",
    );
    assert_close(
        "inertia",
        sine.inertia_extremes.max.value,
        exact.inertia_extremes.max.value,
        0.0,
        3e-5,
        "as above",
    );
    for (a, b) in sine.harmonics.iter().zip(&exact.harmonics) {
        assert!((a.inertia - b.inertia).norm() < 1e-3, "{}: {} {}", a.order, a.inertia, b.inertia);
    }
    // The traces of the named lever are the sum of its orders.
    let named = mean(&engine, Lever::Sine);
    let at = 1.234;
    let request =
        TorqueRequest { lever: Lever::Sine, max_order: 60, samples: 360, ..TorqueRequest::default() };
    let many = torque(&engine, &vec![diesel_like(&engine, 2.5); 4], &request).unwrap();
    let sum: f64 =
        many.harmonics.iter().map(|h| (h.inertia * num_complex::Complex64::cis(h.order * at)).re).sum();
    let place = named.theta.iter().position(|t| (t - at).abs() < 0.5 * named.theta[1]).unwrap();
    let slope = (named.inertia[place + 1] - named.inertia[place - 1]) / (2.0 * named.theta[1]);
    let wanted = named.inertia[place] + slope * (at - named.theta[place]);
    assert!((sum - wanted).abs() < 0.01 * named.inertia_extremes.max_abs(), "{sum} {wanted}");
    let refused = torque(
        &radial_fired(),
        &vec![diesel_like(&radial_fired(), 2.0); 5],
        &TorqueRequest { lever: Lever::Sine, ..TorqueRequest::default() },
    );
    assert_eq!(refused.unwrap_err(), TorqueError::SineLever { cylinder: 2, found: "an articulated rod" });
}

fn radial_fired() -> Engine {
    fired(radial(5, 0.06), 0.15, Strokes::Four)
}

#[test]
fn what_is_missing_is_named() {
    let whole = fired(in_line(&[0.0, 180.0]), 0.08, Strokes::Four);
    let gas = vec![diesel_like(&whole, 2.0); 2];
    let ask =
        |engine: &Engine, gas: &[CylinderGas]| torque(engine, gas, &TorqueRequest::default()).unwrap_err();
    assert_eq!(ask(&whole, &gas[..1]), TorqueError::CylinderCount { needed: 2, got: 1 });
    let mut engine = whole.clone();
    engine = engine
        .with(|engine| {
            engine.cylinders[1].bore = None;
        })
        .unwrap();
    assert_eq!(ask(&engine, &gas), TorqueError::NoBore { cylinder: 2 });
    let mut engine = whole.clone();
    engine = engine
        .with(|engine| {
            engine.cylinders[0].firing_angle = None;
        })
        .unwrap();
    assert_eq!(ask(&engine, &gas), TorqueError::NoFiring { cylinder: 1 });
    let mut engine = whole.clone();
    engine = engine
        .with(|engine| {
            engine.strokes = Strokes::Two;
        })
        .unwrap();
    assert_eq!(ask(&engine, &gas), TorqueError::Period { cylinder: 1, needed: TAU, got: 2.0 * TAU });
}

/// Singh 2017, Table 4.1: 1-3-4-2, and the strokes of all four cylinders.
#[test]
fn lit_power_strokes_of_an_in_line_four() {
    let text = template("in-line-4").unwrap().text;
    let chart = firing_chart(&read(text).engine().unwrap()).unwrap();
    assert_eq!(chart.order(), [1, 3, 4, 2]);
    let changes = chart.changes();
    assert_eq!(changes.len(), 4);
    let rows: Vec<String> = changes
        .iter()
        .map(|from| {
            let letter = |c: usize| chart.cylinders[c - 1].at(from + 0.1, chart.period).unwrap().letter();
            chart.order().into_iter().map(letter).collect()
        })
        .collect();
    assert_eq!(rows, ["PCIE", "EPCI", "IEPC", "CIEP"]);
    assert!(chart.firings.iter().all(|f| (f.interval - PI).abs() < 1e-12));
    assert_eq!(chart.unevenness, 0.0);
    for star in &chart.stars {
        let wanted = if star.order % 2.0 == 0.0 { 1.0 } else { 0.0 };
        assert_close("star", star.share, wanted, 1e-12, 0.0, "four even unit vectors");
    }
}

#[test]
fn uneven_and_simultaneous_firing() {
    // Cranks 180 deg apart: 180 and 540 deg. In phase, fired together: 0 and 720 deg.
    let mut twin = fired(in_line(&[0.0, 180.0]), 0.08, Strokes::Four);
    twin = twin
        .with(|twin| {
            twin.cylinders[1].firing_angle = Some(PI);

            twin.cylinders[0].firing_angle = Some(0.0);
        })
        .unwrap();
    let chart = firing_chart(&twin).unwrap();
    let intervals: Vec<f64> = chart.firings.iter().map(|f| f.interval / PI).collect();
    assert_close("first", intervals[0], 1.0, 1e-12, 0.0, "half turns");
    assert_close("second", intervals[1], 3.0, 1e-12, 0.0, "half turns");
    assert_close("unevenness", chart.unevenness, 0.5, 1e-12, 0.0, "540 against 360");
    let mut together = fired(in_line(&[0.0, 0.0]), 0.08, Strokes::Four);
    together = together
        .with(|together| {
            for cylinder in &mut together.cylinders {
                cylinder.firing_angle = Some(0.0);
            }
        })
        .unwrap();
    let chart = firing_chart(&together).unwrap();
    assert_eq!(chart.firings.iter().map(|f| f.cylinder).collect::<Vec<_>>(), [1, 2]);
    assert_eq!(chart.firings[0].interval, 0.0);
    assert_close("unevenness", chart.unevenness, 1.0, 1e-12, 0.0, "0 against 360");
}

#[test]
fn a_twin_in_phase_repeats_every_turn() {
    let build = |second: f64, firing: f64| {
        let mut engine = fired(in_line(&[0.0, second]), 0.08, Strokes::Four);
        engine = engine
            .with(|engine| {
                engine.cylinders[1].bore = engine.cylinders[0].bore;

                engine.cylinders[0].firing_angle = Some(0.0);

                engine.cylinders[1].firing_angle = Some(firing);
            })
            .unwrap();
        let gas = vec![diesel_like(&engine, 2.5); 2];
        torque(&engine, &gas, &TorqueRequest::default()).unwrap()
    };
    let (in_phase, out) = (build(0.0, TAU), build(180.0, PI));
    assert_close("own period", in_phase.energy.own_period, TAU, 1e-12, 0.0, "closed form");
    assert_close("own period", out.energy.own_period, 2.0 * TAU, 1e-12, 0.0, "closed form");
    assert_close(
        "mean torque",
        in_phase.indicated.torque,
        out.indicated.torque,
        0.0,
        1e-12,
        "the layout does not change the work",
    );
    assert!(in_phase.energy.excess < out.energy.excess);
}

/// Geared crankshafts: each works at its own speed, the torque of all arrives at crankshaft 1.
#[test]
fn power_passes_through_the_gears() {
    for (ratio, revolutions) in [((-1, 1), 2.0), ((1, 2), 4.0), ((2, 1), 2.0), ((-3, 2), 4.0)] {
        let mut geared = support::parts(
            "geared",
            vec![throw(0.0, 0.0), Throw { crankshaft: 1, ..throw(0.4, 0.0) }],
            vec![cylinder(0, 0.0, 0.0), cylinder(1, 0.2, 0.0)],
        );
        let ratio = Ratio::new(ratio.0, ratio.1).unwrap();
        let second = Crankshaft { name: "second".into(), ratio, x: 0.3, ..support::crankshaft() };
        geared.crankshafts.push(second);
        let engine = Engine::new(geared).unwrap();
        let mut engine = fired(engine, 0.08, Strokes::Four);
        engine = engine
            .with(|engine| {
                engine.cylinders[1].bore = Some(0.08);
            })
            .unwrap();
        let gas = vec![diesel_like(&engine, 2.5); 2];
        let torque = torque(&engine, &gas, &TorqueRequest::default()).unwrap();
        assert_close("period", torque.period, TAU * revolutions, 0.0, 1e-14, "whole cycles of both");
        let [one, two] = [0, 1].map(|k| torque.cylinders[k].work.by_volume);
        let wanted = (one + two * ratio.value().abs()) / (4.0 * PI);
        assert_close("torque", torque.indicated.torque, wanted, 0.0, 1e-10, "power of both");
        let samples: f64 = torque.gas.iter().sum::<f64>() / torque.gas.len() as f64;
        assert_close("mean of the trace", samples, wanted, 0.0, 1e-6, "trapezoidal rule at 1 deg");
    }
}
