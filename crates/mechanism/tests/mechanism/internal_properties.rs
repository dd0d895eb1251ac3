//! Shear force and bending moment of random engines, against a derivation of their own.
use crate::support::random::{ALL_SHAPES, any_engine};
use crate::support::{assert_close, in_line, radial};
use lanchester_mechanism::{
    BeamLoads, BeamModel, InternalMoments, InternalRequest, Kinematics, internal_moments,
};
use lanchester_model::{Engine, RodJoint};
use num_complex::Complex64;
use proptest::prelude::*;

const SAMPLES: usize = 12;

fn moments(engine: &Engine, share: f64, counterweights: bool) -> InternalMoments {
    let request = InternalRequest {
        reciprocating_share: share,
        counterweights,
        samples: SAMPLES,
        ..InternalRequest::default()
    };
    internal_moments(engine, &request).expect("the engine is valid")
}

/// Big end, piston pin, piston centre of cylinder `index` with its (master's) crankpin at `crankpin`, and the rod's lean.
fn joints(engine: &Engine, index: usize, crankpin: Complex64) -> ([Complex64; 3], f64) {
    let cylinder = &engine.cylinders[index];
    let crankshaft = &engine.crankshafts[engine.throws[cylinder.throw].crankshaft];
    let big_end = match cylinder.rod.joint {
        RodJoint::Articulated { master, knuckle_radius, knuckle_angle } => {
            let ([_, pin, _], _) = joints(engine, master, crankpin);
            let line = pin - crankpin;
            crankpin + line / line.norm() * Complex64::from_polar(knuckle_radius, knuckle_angle)
        }
        _ => crankpin,
    };
    let along = Complex64::cis(cylinder.angle);
    let axis = Complex64::new(crankshaft.x, crankshaft.y);
    let seen = (big_end - axis) / along;
    let beside = cylinder.offset + cylinder.pin_offset;
    let rise = (cylinder.rod.length.powi(2) - (seen.im - beside).powi(2)).sqrt();
    let small_end = axis + along * Complex64::new(seen.re + rise, beside);
    let centre = small_end - along * Complex64::new(0.0, cylinder.pin_offset);
    ([big_end, small_end, centre], ((small_end - big_end) / along).arg())
}

/// Masses [kg] of big end, small end and piston with their places, and the inertia that the two masses of the rod miss
/// with its lean.
fn bodies(engine: &Engine, index: usize, crankpin: Complex64) -> ([(f64, Complex64); 3], f64, f64) {
    let cylinder = &engine.cylinders[index];
    let (places, lean) = joints(engine, index, crankpin);
    let masses = [cylinder.rod.big_end_mass, cylinder.rod.small_end_mass, cylinder.piston_mass];
    (std::array::from_fn(|k| (masses[k], places[k])), -cylinder.rod.residual_inertia(), lean)
}

/// Force of cylinder `index` on its crankpin by virtual power: moving the crankpin aside at a standing crank moves the
/// bodies against their inertia forces; walls do no work. Of it, what an articulated rod has from the wall of its master's cylinder: moving that
/// wall aside moves its own bodies.
fn pin_force(engine: &Engine, index: usize, theta: f64) -> [Complex64; 2] {
    let throw = &engine.throws[engine.cylinders[index].throw];
    let crankshaft = &engine.crankshafts[throw.crankshaft];
    let axis = Complex64::new(crankshaft.x, crankshaft.y);
    let pin = |theta: f64| {
        let angle = crankshaft.ratio.value() * theta + crankshaft.phase + throw.angle;
        axis + Complex64::from_polar(throw.radius, angle)
    };
    // Second difference of eighth order in theta: its error and rounding are below 1e-8 of the accelerations here.
    let (step, weights) = (0.02, [-205.0 / 72.0, 8.0 / 5.0, -1.0 / 5.0, 8.0 / 315.0, -1.0 / 560.0]);
    let mut acceleration = [Complex64::ZERO; 3];
    let mut swing = 0.0;
    for (k, weight) in weights.iter().enumerate() {
        for side in if k == 0 { &[1.0][..] } else { &[1.0, -1.0] } {
            let (masses, _, lean) = bodies(engine, index, pin(theta + side * k as f64 * step));
            for (sum, (_, place)) in acceleration.iter_mut().zip(masses) {
                *sum += weight * place / (step * step);
            }
            swing += weight * lean / (step * step);
        }
    }
    let square = engine.speed.highest.powi(2);
    // First difference of sixth order in the place of the crankpin.
    let aside = 1e-3;
    let power = |moved_by: &dyn Fn(f64) -> ([(f64, Complex64); 3], f64, f64)| -> f64 {
        let weights = [3.0 / 4.0, -3.0 / 20.0, 1.0 / 60.0];
        weights
            .iter()
            .enumerate()
            .map(|(k, weight)| {
                let distance = (k as f64 + 1.0) * aside;
                let [(after, inertia, lean_after), (before, _, lean_before)] =
                    [1.0, -1.0].map(|side| moved_by(side * distance));
                let moved: f64 = (0..3)
                    .map(|b| {
                        let moved = (after[b].1 - before[b].1) / aside;
                        -after[b].0 * (acceleration[b].conj() * moved).re
                    })
                    .sum();
                weight * (moved - inertia * swing * (lean_after - lean_before) / aside)
            })
            .sum::<f64>()
            * square
    };
    let aside_pin =
        |direction: Complex64| power(&|distance| bodies(engine, index, pin(theta) + distance * direction));
    let all = Complex64::new(aside_pin(Complex64::ONE), aside_pin(Complex64::I));
    let RodJoint::Articulated { master, .. } = engine.cylinders[index].rod.joint else {
        return [all, Complex64::ZERO];
    };
    let wall = power(&|distance| {
        let shifted = engine.with(|parts| parts.cylinders[master].offset += distance).unwrap();
        bodies(&shifted, index, pin(theta))
    });
    let of_master = Complex64::new(0.0, -wall) * Complex64::cis(engine.cylinders[master].angle);
    [all - of_master, of_master]
}

/// All forces on crankshaft `index` with their planes, at `theta`.
fn forces(engine: &Engine, index: usize, theta: f64) -> Vec<(f64, Complex64)> {
    let crankshaft = &engine.crankshafts[index];
    let (ratio, square) = (crankshaft.ratio.value(), engine.speed.highest.powi(2));
    let turning = |z: f64, unbalance: f64, angle: f64| {
        (
            z,
            Complex64::from_polar(
                unbalance * square * ratio * ratio,
                ratio * theta + crankshaft.phase + angle,
            ),
        )
    };
    let throws = engine.throws.iter().filter(|t| t.crankshaft == index);
    let weights = engine.counterweights.iter().filter(|w| w.crankshaft == index);
    let mut list: Vec<_> = throws.map(|t| turning(t.z, t.unbalance, t.angle)).collect();
    list.extend(weights.map(|w| turning(w.z, w.unbalance, w.angle)));
    for (k, cylinder) in engine.cylinders.iter().enumerate() {
        if engine.throws[cylinder.throw].crankshaft == index {
            let [own, of_master] = pin_force(engine, k, theta);
            list.push((cylinder.z, own));
            if let RodJoint::Articulated { master, .. } = cylinder.rod.joint {
                list.push((engine.cylinders[master].z, of_master));
            }
        }
    }
    list
}

/// Shear and moment by the forces towards the free end, the end mains' answers found from the two balances of the whole.
fn check_free_beam(engine: &Engine, index: usize, j: usize, theta: f64, beam: &BeamLoads) {
    let mut list = forces(engine, index, theta);
    let mains = engine.main_planes(index);
    let (a, b) = (mains[0], mains[mains.len() - 1]);
    let force: Complex64 = list.iter().map(|l| l.1).sum();
    let couple: Complex64 = list.iter().map(|l| l.0 * l.1).sum();
    let scale: f64 = list.iter().map(|l| l.1.norm()).sum();
    let at_b = (couple - a * force) / (b - a);
    let tolerance = 1e-6 * scale * (1.0 + list.iter().fold(0.0f64, |m, l| m.max(l.0.abs())) / (b - a));
    let why = "differences of the brute force";
    assert_close("last main", (beam.mains[mains.len() - 1].load[j] - at_b).norm(), 0.0, tolerance, 0.0, why);
    assert_close("first main", (beam.mains[0].load[j] - (force - at_b)).norm(), 0.0, tolerance, 0.0, why);
    list.push((a, at_b - force));
    list.push((b, -at_b));
    for station in &beam.stations {
        let before = list.iter().filter(|l| l.0 <= station.z + 1e-9);
        let shear: Complex64 = before.clone().map(|l| l.1).sum();
        let moment: Complex64 = before.map(|l| Complex64::I * (l.0 - station.z) * l.1).sum();
        assert_close("shear", (station.shear[j] - shear).norm(), 0.0, tolerance, 0.0, why);
        assert_close("moment", (station.moment[j] - moment).norm(), 0.0, tolerance, 0.0, why);
    }
}

fn compare(engine: &Engine) {
    let result = moments(engine, 1.0, true);
    for shaft in &result.crankshafts {
        for j in [1, 4, 10] {
            let theta = result.theta[j];
            check_free_beam(engine, shaft.crankshaft - 1, j, theta, &shaft.free_beam);
        }
    }
}

#[test]
fn rods_press_their_pins_as_virtual_power_says() {
    compare(&in_line(&[0.0, 90.0, 200.0]));
    let mut leaning = in_line(&[0.0, 140.0]);
    leaning = leaning
        .with(|leaning| {
            leaning.cylinders[0].offset = 0.012;

            leaning.cylinders[1].pin_offset = -0.004;

            for cylinder in &mut leaning.cylinders {
                cylinder.rod.inertia = Some(0.004);
            }
        })
        .unwrap();
    compare(&leaning);
    compare(&radial(5, 0.06));
}

/// Every complex trace of a beam in one row.
fn row(beam: &BeamLoads) -> Vec<Complex64> {
    let stations = beam.stations.iter().flat_map(|s| s.shear.iter().chain(&s.moment));
    stations.chain(beam.mains.iter().flat_map(|m| &m.load)).copied().collect()
}

/// Sum of all forces on the shaft at its worst, the free beam's mains aside: what rounding is measured against.
fn scale(result: &InternalMoments) -> f64 {
    let all = result.crankshafts.iter().flat_map(|s| BeamModel::ALL.map(|m| s.of(m)));
    all.map(|b| b.peak_shear.value.max(b.peak_main.value).max(b.peak_moment.value)).fold(1e-9, f64::max)
}

fn sample() -> ProptestConfig {
    ProptestConfig { cases: 48, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(sample())]

    #[test]
    fn prop_an_independent_derivation_agrees(engine in any_engine(ALL_SHAPES)) {
        compare(&engine);
    }

    #[test]
    fn prop_both_ends_are_free(engine in any_engine(ALL_SHAPES), share in 0.0..1.0f64) {
        let result = moments(&engine, share, true);
        for shaft in &result.crankshafts {
            for beam in BeamModel::ALL.map(|m| shaft.of(m)) {
                let last = beam.stations.last().expect("a shaft has two mains");
                let force = beam.peak_main.value.max(beam.peak_shear.value);
                let couple = force * (last.z - beam.stations[0].z) + beam.peak_moment.value;
                for j in 0..result.theta.len() {
                    assert_close("Q at the end", last.shear[j].norm(), 0.0, 1e-12 * force, 0.0, "rounding");
                    assert_close("M at the end", last.moment[j].norm(), 0.0, 1e-12 * couple, 0.0, "rounding");
                }
            }
        }
    }

    #[test]
    fn prop_cases_add_up(engine in any_engine(ALL_SHAPES), share in 0.0..1.0f64) {
        let [bare, weighted, whole, part] =
            [(0.0, false), (0.0, true), (1.0, false), (share, true)].map(|(s, c)| moments(&engine, s, c));
        let scale = [&bare, &weighted, &whole, &part].map(scale).into_iter().fold(0.0, f64::max);
        for (k, shaft) in part.crankshafts.iter().enumerate() {
            for model in BeamModel::ALL {
                // A case without weights has no stations at their planes: mains are there in all.
                let load = |r: &InternalMoments, m: usize, j: usize| r.crankshafts[k].of(model).mains[m].load[j];
                for m in 0..shaft.of(model).mains.len() {
                    for j in 0..part.theta.len() {
                        let sum = load(&weighted, m, j) + share * (load(&whole, m, j) - load(&bare, m, j));
                        let off = (load(&part, m, j) - sum).norm();
                        assert_close("superposition", off, 0.0, 1e-11 * scale, 0.0, "rounding");
                    }
                }
            }
        }
    }

    #[test]
    fn prop_what_only_turns_is_constant_on_the_shaft(engine in any_engine(ALL_SHAPES)) {
        let result = moments(&engine, 0.0, true);
        let scale = scale(&result);
        for shaft in &result.crankshafts {
            let ratio = engine.crankshafts[shaft.crankshaft - 1].ratio.value();
            for beam in BeamModel::ALL.map(|m| shaft.of(m)) {
                for trace in row(beam).chunks(result.theta.len()) {
                    for (theta, value) in result.theta.iter().zip(trace) {
                        let off = (value * Complex64::cis(-ratio * theta) - trace[0]).norm();
                        assert_close("turned back", off, 0.0, 1e-12 * scale, 0.0, "rounding");
                    }
                }
                assert_eq!(beam.peak_moment.theta, 0.0);
            }
        }
    }

    #[test]
    fn prop_the_influence_of_each_load_adds_up(engine in any_engine(ALL_SHAPES)) {
        let result = moments(&engine, 0.0, true);
        let scale = scale(&result);
        let square = engine.speed.highest.powi(2);
        for shaft in &result.crankshafts {
            let index = shaft.crankshaft - 1;
            let crankshaft = &engine.crankshafts[index];
            let own = square * crankshaft.ratio.value().powi(2);
            let force = |unbalance: f64, angle: f64| Complex64::from_polar(unbalance * own, crankshaft.phase + angle);
            let throws = engine.throws.iter().filter(|t| t.crankshaft == index);
            let mut loads: Vec<(f64, Complex64)> = throws.map(|t| (t.z, force(t.unbalance, t.angle))).collect();
            let weights = engine.counterweights.iter().filter(|w| w.crankshaft == index);
            loads.extend(weights.map(|w| (w.z, force(w.unbalance, w.angle))));
            for cylinder in &engine.cylinders {
                let throw = &engine.throws[cylinder.throw];
                if throw.crankshaft == index {
                    loads.push((cylinder.z, force(cylinder.rod.big_end_mass * throw.radius, throw.angle)));
                }
            }
            for model in BeamModel::ALL {
                let beam = lanchester_mechanism::Beam::new(&engine.main_planes(index), model).expect("mains");
                for station in &shaft.of(model).stations {
                    let z = station.z;
                    let moment: Complex64 = loads.iter().map(|l| beam.moment_influence(z, l.0) * l.1).sum();
                    let off = (station.moment[0] - Complex64::I * moment).norm();
                    assert_close("moment", off, 0.0, 1e-11 * scale, 0.0, "rounding");
                    let shear: Complex64 = loads.iter().map(|l| beam.shear_influence(z, l.0) * l.1).sum();
                    assert_close("shear", (station.shear[0] - shear).norm(), 0.0, 1e-11 * scale, 0.0, "rounding");
                }
            }
        }
    }

    #[test]
    fn prop_no_angle_goes_beyond_the_envelope(engine in any_engine(ALL_SHAPES), share in 0.1..1.0f64) {
        let coarse = moments(&engine, share, true);
        let odd = InternalRequest { reciprocating_share: share, samples: 1327, ..InternalRequest::default() };
        let fine = internal_moments(&engine, &odd).expect("the engine is valid");
        let scale = scale(&fine);
        for (a, b) in coarse.crankshafts.iter().zip(&fine.crankshafts) {
            for model in BeamModel::ALL {
                for (a, b) in a.of(model).stations.iter().zip(&b.of(model).stations) {
                    let seen = b.moment.iter().map(|m| m.norm()).fold(0.0, f64::max);
                    prop_assert!(seen <= a.largest_moment.value + 1e-9 * scale, "{seen} {:?}", a.largest_moment);
                    let off = (a.largest_moment.value - b.largest_moment.value).abs();
                    prop_assert!(off <= 1e-9 * scale, "{:?} {:?}", a.largest_moment, b.largest_moment);
                }
            }
        }
    }
}

#[test]
fn truncated_motion_comes_close_to_the_exact_one() {
    let engine = in_line(&[0.0, 180.0, 180.0, 0.0]);
    let peak = |kinematics| {
        let request = InternalRequest { kinematics, reciprocating_share: 1.0, ..InternalRequest::default() };
        let result = internal_moments(&engine, &request).expect("the engine is valid");
        result.crankshafts[0].free_beam.peak_moment.value
    };
    let exact = peak(Kinematics::Exact);
    assert_close("orders to 12", peak(Kinematics::Orders(12)), exact, 0.0, 1e-6, "orders above 12 are tiny");
    let two = peak(Kinematics::Orders(1));
    assert!((two - exact).abs() > 1e-3 * exact, "{two} {exact}");
}
