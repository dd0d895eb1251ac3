//! Shear force and bending moment along the crankshaft: formulas that a pencil gives.
use crate::support;
use crate::support::{assert_close, engine, in_line, throw, vee};
use lanchester_mechanism::{
    BeamModel, InternalMoments, InternalRequest, LoadError, Station, internal_cases, internal_moments,
};
use lanchester_model::{Counterweight, Engine};
use num_complex::Complex64;
use std::f64::consts::PI;

/// Distance between the throws of `in_line` [m].
const SPACING: f64 = 0.09;

fn moments(engine: &Engine) -> InternalMoments {
    internal_moments(engine, &InternalRequest { samples: 8, ..InternalRequest::default() })
        .expect("the engine is valid")
}

/// Rotating force of one throw with its big ends [N].
fn throw_force(engine: &Engine, throw: usize) -> f64 {
    (engine.throws[throw].unbalance + engine.rod_unbalance(throw)) * engine.speed.highest.powi(2)
}

fn weight(engine: &Engine, throw: usize, z: f64, share: f64) -> Counterweight {
    Counterweight {
        name: format!("weight {} at {z}", throw + 1),
        crankshaft: 0,
        z,
        unbalance: share * (engine.throws[throw].unbalance + engine.rod_unbalance(throw)),
        angle: engine.throws[throw].angle + PI,
        part: None,
    }
}

/// The engine with a weight opposite every throw that holds all of it in balance.
fn balanced_at_throws(engine: &Engine) -> Engine {
    let weights = (0..engine.throws.len()).map(|k| weight(engine, k, engine.throws[k].z, 1.0)).collect();
    engine.with(|parts| parts.counterweights = weights).unwrap()
}

/// The engine with half such a weight on each of the two webs of every throw, `distance` apart.
fn balanced_on_webs(engine: &Engine, distance: f64) -> Engine {
    let of_throw = |k: usize| {
        let z = engine.throws[k].z;
        [z - 0.5 * distance, z + 0.5 * distance].map(|z| weight(engine, k, z, 0.5))
    };
    let weights = (0..engine.throws.len()).flat_map(of_throw).collect();
    engine.with(|parts| parts.counterweights = weights).unwrap()
}

fn at(stations: &[Station], z: f64) -> &Station {
    stations.iter().find(|s| (s.z - z).abs() < 1e-9).expect("there is a station")
}

const HAND: &str = "a formula of a few products";

#[test]
fn an_in_line_four_bends_in_the_middle_by_throw_force_times_spacing() {
    let engine = in_line(&[0.0, 180.0, 180.0, 0.0]);
    let force = throw_force(&engine, 0);
    let shaft = &moments(&engine).crankshafts[0];
    let peak = shaft.free_beam.peak_moment;
    assert_close("centre moment", peak.value, force * SPACING, 0.0, 1e-13, HAND);
    // Between throws 2 and 3 the shaft is free of shear: the first of the two has the peak.
    assert_close("place", peak.z, -0.5 * SPACING, 1e-12, 0.0, "the plane of throw 2");
    assert_close("peak shear", shaft.free_beam.peak_shear.value, force, 0.0, 1e-13, "one throw");
    // M = i (z_1 - z) F: at theta = 0 throw 1 pulls along +x, so that M points along -y.
    let middle = at(&shaft.free_beam.stations, 0.0).moment[0];
    assert_close("M_x", middle.re, 0.0, 1e-9, 0.0, "rounding of N m");
    assert_close("M_y", middle.im, -force * SPACING, 0.0, 1e-13, HAND);
    for main in &shaft.free_beam.mains {
        assert_close("free mains", main.largest.value, 0.0, 1e-12 * force, 0.0, "the crank is in balance");
    }
    let cut = &shaft.throw_by_throw;
    assert_close("moment in a throw", cut.peak_moment.value, 0.25 * force * SPACING, 0.0, 1e-13, HAND);
    let mains: Vec<f64> = cut.mains.iter().map(|m| m.largest.value / force).collect();
    for (got, wanted) in mains.iter().zip([0.5, 0.0, 1.0, 0.0, 0.5]) {
        assert_close("share of a throw", *got, wanted, 1e-12, 0.0, "the middle main has two throws alike");
    }
}

#[test]
fn counterweights_in_the_throw_planes_take_all_of_it() {
    for angles in [&[0.0, 180.0, 180.0, 0.0][..], &[0.0, 120.0, 240.0, 240.0, 120.0, 0.0]] {
        let engine = balanced_at_throws(&in_line(angles));
        let scale = throw_force(&engine, 0) * SPACING;
        let shaft = &moments(&engine).crankshafts[0];
        for beam in BeamModel::ALL.map(|model| shaft.of(model)) {
            assert_close("moment", beam.peak_moment.value, 0.0, 1e-12 * scale, 0.0, "nothing is left");
            assert_close("main", beam.peak_main.value, 0.0, 1e-12 * scale / SPACING, 0.0, "nothing is left");
        }
    }
}

#[test]
fn counterweights_on_webs_leave_a_quarter_of_force_times_web_distance() {
    let engine = balanced_on_webs(&in_line(&[0.0, 180.0, 180.0, 0.0]), 0.04);
    let force = throw_force(&engine, 0);
    let shaft = &moments(&engine).crankshafts[0];
    for beam in BeamModel::ALL.map(|model| shaft.of(model)) {
        assert_close("moment", beam.peak_moment.value, 0.25 * force * 0.04, 0.0, 1e-12, HAND);
        assert_close("main", beam.peak_main.value, 0.0, 1e-12 * force, 0.0, "every throw is in balance");
    }
}

#[test]
fn an_in_line_six_bends_in_the_middle_by_root_three_of_force_times_spacing() {
    let engine = in_line(&[0.0, 120.0, 240.0, 240.0, 120.0, 0.0]);
    let force = throw_force(&engine, 0);
    let shaft = &moments(&engine).crankshafts[0];
    // | -5/2 - 3/2 w - 1/2 w^2 | with w = e^{2 pi i / 3}: |2 + w| = sqrt(3).
    let middle = at(&shaft.free_beam.stations, 0.0).largest_moment.value;
    assert_close("centre moment", middle, 3f64.sqrt() * force * SPACING, 0.0, 1e-12, HAND);
    assert_close("peak", shaft.free_beam.peak_moment.value, middle, 0.0, 1e-12, "no shear in the middle");
    let mains: Vec<f64> = shaft.throw_by_throw.mains.iter().map(|m| m.largest.value / force).collect();
    // Neighbours 120 deg apart leave half a throw, the two alike in the middle a whole one.
    for (got, wanted) in mains.iter().zip([0.5, 0.5, 0.5, 1.0, 0.5, 0.5, 0.5]) {
        assert_close("share of a throw", *got, wanted, 1e-12, 0.0, HAND);
    }
}

#[test]
fn a_crossplane_v8_hands_its_couple_to_the_end_mains() {
    let engine = vee(90.0, &[0.0, 90.0, 270.0, 180.0]);
    let spacing = 0.11;
    let force = throw_force(&engine, 0);
    let shaft = &moments(&engine).crankshafts[0];
    let mains = &shaft.free_beam.mains;
    assert_eq!(mains.len(), 5);
    // Couple |-3/2 - i/2 - i/2 - 3/2| = sqrt(10) spacings over four of them.
    for (main, wanted) in mains.iter().zip([10f64.sqrt() / 4.0, 0.0, 0.0, 0.0, 10f64.sqrt() / 4.0]) {
        assert_close("main", main.largest.value / force, wanted, 1e-12, 0.0, HAND);
    }
    // In units of force and spacing: N_1 = (3 + i) / 4 at -2, throws 1 at -3/2, i at -1/2, -i at 1/2, -1 at 3/2.
    // M(-1/2) = i ((-2 + 1/2) (-N_1) + (-3/2 + 1/2)) = i (1/8 + 3 i / 8); M(1/2) is its mirror image, M(-3/2) =
    // i (3 + i) / 8; M(0) = i ((-2)(-N_1) - 3/2 - i/2) = 0.
    let size = |z: f64| at(&shaft.free_beam.stations, z * spacing).largest_moment.value / (force * spacing);
    for (z, wanted) in [
        (-1.5, 10f64.sqrt() / 8.0),
        (-0.5, 10f64.sqrt() / 8.0),
        (0.0, 0.0),
        (0.5, 10f64.sqrt() / 8.0),
        (1.5, 10f64.sqrt() / 8.0),
    ] {
        assert_close(&format!("M({z})"), size(z), wanted, 1e-12, 0.0, HAND);
    }
    let cut = &shaft.throw_by_throw;
    // Neighbours 90 deg apart leave |1 + i| / 2 on the mains between them; the middle one has i - i.
    let half = 0.5f64.sqrt();
    for (main, wanted) in cut.mains.iter().zip([0.5, half, 0.0, half, 0.5]) {
        assert_close("main, cut", main.largest.value / force, wanted, 1e-12, 0.0, HAND);
    }
}

#[test]
fn a_flywheel_weight_overhangs() {
    let mut engine = in_line(&[0.0, 180.0, 180.0, 0.0]);
    engine = engine
        .with(|engine| {
            for throw in &mut engine.throws {
                throw.unbalance = 0.0;
            }

            for cylinder in &mut engine.cylinders {
                cylinder.rod.big_end_mass = 0.0;
            }
        })
        .unwrap();
    let z = 2.5 * SPACING;
    engine = engine
        .with(|engine| {
            engine.counterweights = vec![Counterweight {
                name: "flywheel".into(),
                crankshaft: 0,
                z,
                unbalance: 0.01,
                angle: 0.0,
                part: None,
            }];
        })
        .unwrap();
    let force = 0.01 * 300.0f64.powi(2);
    let shaft = &moments(&engine).crankshafts[0];
    for beam in BeamModel::ALL.map(|model| shaft.of(model)) {
        let peak = beam.peak_moment;
        assert_close("moment", peak.value, 0.5 * SPACING * force, 0.0, 1e-12, "force times overhang");
        assert_close("place", peak.z, 2.0 * SPACING, 1e-12, 0.0, "the last main");
    }
    let [first, last] = [0, 4].map(|k| shaft.free_beam.mains[k].load[0].re / force);
    assert_close("first main", first, -0.125, 1e-12, 0.0, "lever");
    assert_close("last main", last, 1.125, 1e-12, 0.0, "lever");
}

#[test]
fn a_single_presses_its_mains_by_halves() {
    let mut single = engine("single", vec![throw(0.0, 0.0)], vec![support::cylinder(0, 0.0, 0.0)]);
    single = single
        .with(|single| {
            single.cylinders[0].rod.big_end_mass = 0.0;

            single.throws[0].unbalance = 0.0;
        })
        .unwrap();
    let request = InternalRequest { reciprocating_share: 1.0, ..InternalRequest::default() };
    let result = internal_moments(&single, &request).expect("the engine is valid");
    let beam = &result.crankshafts[0].free_beam;
    // At top dead centre the rod stands along the cylinder: F = m r W^2 (1 + r/l).
    let top = 0.7 * 0.045 * 300.0f64.powi(2) * (1.0 + 0.045 / 0.15);
    for main in &beam.mains {
        assert_close("half of the top force", main.load[0].re, 0.5 * top, 0.0, 1e-12, HAND);
        assert_close("largest", main.largest.value, 0.5 * top, 0.0, 1e-12, "it is the largest of the cycle");
        assert_close("no side", main.load[0].im, 0.0, 1e-12 * top, 0.0, "crank and rod in line");
    }
    // At theta = 90 deg the rod leans by asin(r/l): its force points along it.
    let quarter = beam.mains[0].load[180];
    let lean = (0.045f64 / 0.15).asin();
    assert_close(
        "lean",
        (quarter.im / quarter.re).abs(),
        lean.tan(),
        0.0,
        1e-12,
        "a two-mass rod pulls along itself",
    );
}

#[test]
fn all_cases_are_there_to_compare() {
    let bare = in_line(&[0.0, 180.0, 180.0, 0.0]);
    let kinds = |engine: &Engine, share: f64| -> Vec<(bool, f64)> {
        let request = InternalRequest { reciprocating_share: share, ..InternalRequest::default() };
        let cases = internal_cases(engine, &request).expect("the engine is valid");
        cases.iter().map(|c| (c.counterweights, c.reciprocating_share)).collect()
    };
    assert_eq!(kinds(&bare, 0.0), [(true, 0.0), (true, 1.0)]);
    assert_eq!(kinds(&bare, 1.0), [(true, 1.0)]);
    let weighted = balanced_at_throws(&bare);
    assert_eq!(kinds(&weighted, 0.5), [(true, 0.5), (false, 0.5), (true, 1.0), (false, 1.0)]);
}

#[test]
fn impossible_requests_are_refused() {
    let engine = in_line(&[0.0, 180.0]);
    for share in [-0.1, 1.1, f64::NAN] {
        let request = InternalRequest { reciprocating_share: share, ..InternalRequest::default() };
        assert!(matches!(internal_moments(&engine, &request), Err(LoadError::Request { .. })), "{share}");
    }
    let request = InternalRequest { samples: 0, ..InternalRequest::default() };
    assert!(matches!(internal_moments(&engine, &request), Err(LoadError::Request { .. })));
    let idle = engine
        .with(|parts| {
            parts.throws = Vec::new();
            parts.cylinders = Vec::new();
        })
        .unwrap();
    assert!(moments(&idle).crankshafts.is_empty());
    let zero = Complex64::ZERO;
    assert_eq!(moments(&in_line(&[0.0])).crankshafts[0].free_beam.stations[0].moment[0], zero);
}
