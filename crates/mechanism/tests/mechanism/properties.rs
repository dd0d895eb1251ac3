//! What must hold for every engine, whatever its shape.
use crate::support::random::{ALL_SHAPES, any_engine};
use crate::support::{assert_close, brute, list, odd_angles, scales};
use lanchester_mechanism::{LoadRequest, Mechanism, Part, PeakMode, Selection, loads};
use lanchester_model::Engine;
use lanchester_results::Components;
use num_complex::Complex64;
use proptest::prelude::*;

const NAMES: [&str; 6] = ["force x", "force y", "couple x", "couple y", "roll moment", "shaft torque"];

fn whole(engine: &Engine) -> Mechanism {
    Mechanism::new(engine, &LoadRequest::default()).expect("the engine is valid")
}

/// Compares components against wanted ones, at rounding.
fn same(got: Components, wanted: [f64; 6], scale: &[f64; 6], tolerance: f64, reason: &str) {
    for (k, name) in NAMES.iter().enumerate() {
        assert_close(name, list(got)[k], wanted[k], tolerance * scale[k], 0.0, reason);
    }
}

/// The engine with the whole block turned by `delta`: axes, throws, weights and axes of shafts.
fn turned(engine: &Engine, delta: f64) -> Engine {
    let mut engine = engine.clone();
    let turn = |x: &mut f64, y: &mut f64| {
        let place = Complex64::new(*x, *y) * Complex64::cis(delta);
        (*x, *y) = (place.re, place.im);
    };
    engine = engine
        .with(|engine| {
            for crankshaft in &mut engine.crankshafts {
                turn(&mut crankshaft.x, &mut crankshaft.y);
            }

            for throw in &mut engine.throws {
                throw.angle += delta;
            }

            for cylinder in &mut engine.cylinders {
                cylinder.angle += delta;
            }

            for weight in &mut engine.counterweights {
                weight.angle += delta;
            }

            for shaft in &mut engine.shafts {
                turn(&mut shaft.x, &mut shaft.y);
                for weight in &mut shaft.weights {
                    weight.phase += delta;
                }
            }
        })
        .unwrap();
    engine
}

/// The engine with all masses times `factor`.
fn heavier(engine: &Engine, factor: f64) -> Engine {
    let mut engine = engine.clone();
    engine = engine
        .with(|engine| {
            for throw in &mut engine.throws {
                throw.unbalance *= factor;
            }

            for cylinder in &mut engine.cylinders {
                cylinder.piston_mass *= factor;
                cylinder.rod.big_end_mass *= factor;
                cylinder.rod.small_end_mass *= factor;
                cylinder.rod.inertia = cylinder.rod.inertia.map(|inertia| inertia * factor);
            }

            for weight in &mut engine.counterweights {
                weight.unbalance *= factor;
            }

            for weight in engine.shafts.iter_mut().flat_map(|s| &mut s.weights) {
                weight.unbalance *= factor;
            }
        })
        .unwrap();
    engine
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn prop_loads_grow_with_mass_and_speed_squared(
        engine in any_engine(ALL_SHAPES), mass in 0.1..10.0f64, speed in 0.1..10.0f64,
    ) {
        let scale = scales(&engine);
        let request = LoadRequest { speed: Some(speed * engine.speed.highest), ..LoadRequest::default() };
        let faster = Mechanism::new(&heavier(&engine, mass), &request).unwrap();
        let factor = mass * speed * speed;
        for theta in odd_angles(5) {
            let wanted = list(whole(&engine).components(theta)).map(|v| factor * v);
            let scale = scale.map(|s| factor * s);
            same(faster.components(theta), wanted, &scale, 1e-13, "rounding of a sum of a dozen parts");
        }
    }

    #[test]
    fn prop_turning_the_block_turns_the_loads(engine in any_engine(ALL_SHAPES), delta in -3.0..3.0f64) {
        let scale = scales(&engine);
        let turn = Complex64::cis(delta);
        let (still, other) = (whole(&engine), whole(&turned(&engine, delta)));
        for theta in odd_angles(5) {
            let c = still.components(theta);
            let force = Complex64::new(c.force_x, c.force_y) * turn;
            let couple = Complex64::new(c.couple_x, c.couple_y) * turn;
            let wanted = [force.re, force.im, couple.re, couple.im, c.roll_moment, c.shaft_torque];
            same(other.components(theta), wanted, &scale, 1e-12, "rounding of angles of a few turns");
        }
    }

    #[test]
    fn prop_cylinders_in_another_order_give_the_same_loads(engine in any_engine(ALL_SHAPES), by in 0..12usize) {
        let count = engine.cylinders.len();
        let mut other = engine.clone();
        other = other.with(|other| { other.cylinders.rotate_left(by % count);
 for cylinder in &mut other.cylinders {
            if let lanchester_model::RodJoint::Articulated { master, .. } = &mut cylinder.rod.joint {
                *master = (*master + count - by % count) % count;
            }
        }
}).unwrap();
        let scale = scales(&engine);
        for theta in odd_angles(5) {
            let wanted = list(whole(&engine).components(theta));
            same(whole(&other).components(theta), wanted, &scale, 1e-13, "another order of the same sum");
        }
    }

    #[test]
    fn prop_parts_and_cylinders_add_up(engine in any_engine(ALL_SHAPES)) {
        let scale = scales(&engine);
        let request = LoadRequest::default();
        let sum = |selections: &[Selection], theta: f64| {
            let mut sum = [0.0; 6];
            for &selection in selections {
                let part = Mechanism::of(&engine, &request, selection).unwrap().components(theta);
                for (sum, value) in sum.iter_mut().zip(list(part)) {
                    *sum += value;
                }
            }
            sum
        };
        let parts = Part::ALL.map(Selection::Part);
        let mut pieces: Vec<Selection> = (0..engine.cylinders.len()).map(Selection::Cylinder).collect();
        pieces.extend([Selection::Part(Part::Counterweights), Selection::Part(Part::Shafts)]);
        for theta in odd_angles(3) {
            let total = whole(&engine).components(theta);
            same(total, sum(&parts, theta), &scale, 1e-13, "rounding of a sum");
            same(total, sum(&pieces, theta), &scale, 1e-13, "rounding of a sum");
        }
    }

    #[test]
    fn prop_torque_has_no_mean_and_gives_the_energy_back(engine in any_engine(ALL_SHAPES)) {
        let mechanism = whole(&engine);
        let scale = scales(&engine)[5];
        let torque = mechanism.trace(512).shaft_torque;
        let mean = torque.iter().sum::<f64>() / torque.len() as f64;
        assert_close("mean torque", mean, 0.0, 1e-13 * scale, 0.0, "trapezoidal rule on an analytic function");
        let (step, speed) = (1e-2, engine.speed.highest);
        for theta in odd_angles(3) {
            let change = |h: f64| {
                (brute::energy(&engine, theta + h, speed) - brute::energy(&engine, theta - h, speed)) / (2.0 * h)
            };
            let slope = (4.0 * change(step) - change(2.0 * step)) / 3.0;
            let got = mechanism.components(theta).shaft_torque;
            assert_close("torque against energy", got, -slope, 1e-5 * scale, 0.0, "fourth-order difference, step 0.01");
        }
    }

}

proptest! {
    // A whole calculation each: fewer of them.
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn prop_peaks_bound_the_loads_and_are_attained(engine in any_engine(ALL_SHAPES)) {
        let loads = loads(&engine, &LoadRequest::default()).unwrap();
        let fine = whole(&engine).trace(4096);
        let scale = scales(&engine);
        let peaks = &loads.total.peaks;
        let size = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a.hypot(*b)).collect::<Vec<_>>();
        let columns = [
            (fine.force_x.clone(), peaks.force_x, scale[0]),
            (fine.force_y.clone(), peaks.force_y, scale[0]),
            (size(&fine.force_x, &fine.force_y), peaks.force, scale[0]),
            (fine.couple_x.clone(), peaks.couple_x, scale[2]),
            (fine.couple_y.clone(), peaks.couple_y, scale[2]),
            (size(&fine.couple_x, &fine.couple_y), peaks.couple, scale[2]),
            (fine.roll_moment.clone(), peaks.roll_moment, scale[4]),
            (fine.shaft_torque.clone(), peaks.shaft_torque, scale[5]),
        ];
        for (k, (values, found, scale)) in columns.iter().enumerate() {
            let max = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let min = values.iter().copied().fold(f64::INFINITY, f64::min);
            prop_assert!(found.max.value >= max - 1e-12 * scale, "{k}: {:?} below the grid's {max:e}", found.max);
            prop_assert!(found.min.value <= min + 1e-12 * scale, "{k}: {:?} above the grid's {min:e}", found.min);
            // Between angles 1.5 mrad apart a load of order n < 20 or so changes by (20 * 1.5e-3)^2 / 8 at most.
            assert_close("maximum beyond the grid", found.max.value, max, 2e-4 * scale, 0.0, "parabola between angles");
            // A resultant that nearly vanishes has a kink: between angles it falls by its slope times half the step.
            let (share, reason) = if k == 2 || k == 5 { (2e-2, "slope times step") } else { (2e-4, "as above") };
            assert_close("minimum beyond the grid", found.min.value, min, share * scale, 0.0, reason);
            if found.max_abs() > 1e-6 * scale {
                let at = |theta: f64| {
                    let c = list(whole(&engine).components(theta));
                    [c[0], c[1], c[0].hypot(c[1]), c[2], c[3], c[2].hypot(c[3]), c[4], c[5]][k]
                };
                let (high, low) = (found.max, found.min);
                assert_close("maximum at its angle", at(high.theta), high.value, 1e-12 * scale, 0.0, "the same code");
                assert_close("minimum at its angle", at(low.theta), low.value, 1e-12 * scale, 0.0, "the same code");
            }
        }
    }

    #[test]
    fn prop_grid_peaks_are_those_of_the_grid(engine in any_engine(ALL_SHAPES), count in 1..400usize) {
        let request = LoadRequest { peaks: PeakMode::Grid(count), ..LoadRequest::default() };
        let found = loads(&engine, &request).unwrap().total.peaks;
        let trace = whole(&engine).trace(count);
        let max = trace.force_x.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        assert_close("grid maximum", found.force_x.max.value, max, 0.0, 0.0, "the same numbers");
    }
}
