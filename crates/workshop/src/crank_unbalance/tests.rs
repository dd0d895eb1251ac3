use super::*;
use crate::{FactorRequest, balance_factors};
use lanchester_file::{read, template};

fn gallery(name: &str) -> Engine {
    read(template(name).unwrap().text).engine().unwrap()
}

fn planes(front: f64, rear: f64) -> [Plane; 2] {
    [Plane { name: "front".into(), z: front }, Plane { name: "rear".into(), z: rear }]
}

/// In-line three, no counterweights: throws of U = own + bobweight at 0, 240, 120 deg, 78 mm apart. By formula the
/// static unbalance is 0, the couple sqrt(3) a U, in planes L apart sqrt(3) a U / L, opposed.
#[test]
fn in_line_three_by_formula() {
    let mut engine = gallery("in-line-3");
    engine = engine
        .with(|engine| {
            engine.counterweights.clear();
        })
        .expect("an engine");
    let bob = 0.34 + 0.5 * 0.44;
    let unbalance = engine.throws[0].unbalance + bob * 0.041;
    let body = CrankBody { mass: 9.0, mass_centre: 0.0, transverse_inertia: 0.09, polar_inertia: 0.02 };
    let got = crank_unbalance(&engine, 0, &[bob; 3], &planes(-0.1, 0.15), Some(body)).unwrap();
    let couple = 3f64.sqrt() * 0.078 * unbalance;
    assert!(got.static_unbalance.norm() < 1e-16);
    assert!((got.couple_unbalance.norm() - couple).abs() < 1e-16);
    let [front, rear] = &got.planes;
    assert!((rear.unbalance.norm() - couple / 0.25).abs() < 1e-15);
    assert!((front.unbalance + rear.unbalance).norm() < 1e-15);
    let state = got.body.unwrap();
    assert_eq!((state.kind, state.offset), (UnbalanceKind::Couple, Complex64::ZERO));
    assert!((state.tilt - 0.5 * (2.0 * couple / 0.07).atan()).abs() < 1e-15);
    assert!((state.tilt_direction - got.couple_unbalance.arg()).abs() < 1e-12);
}

/// A crank whose counterweights fit the bobweights throw by throw is in balance in any planes.
#[test]
fn a_crank_that_fits_its_bobweights_is_balanced() {
    for name in ["in-line-3", "v8-crossplane", "v6-90", "single"] {
        let engine = gallery(name);
        let bobs: Vec<f64> = balance_factors(&engine, &FactorRequest::default())
            .unwrap()
            .iter()
            .map(|f| f.bobweight)
            .collect();
        let got = crank_unbalance(&engine, 0, &bobs, &planes(-0.2, 0.3), None).unwrap();
        assert!(got.planes.iter().all(|p| p.unbalance.norm() < 1e-15), "{name}: {:?}", got.planes);
        // The V8 and V6 have more than one rod a pin, so this says something.
        assert!(bobs.iter().all(|b| *b > 0.4), "{bobs:?}");
    }
}

/// A thin rod of mass m and length L, tilted bodily by a small angle a about its centre and moved sideways by e:
/// D = I_t' sin a cos a exactly, so that the tilt comes back as a; the offset as e.
#[test]
fn a_tilted_rod_tells_its_tilt() {
    let (mass, length, tilt, offset) = (3.0, 0.8, 0.013, 2e-4);
    let count = 4000;
    let mut engine = gallery("single");
    engine = engine
        .with(|engine| {
            engine.throws[0].unbalance = 0.0;
        })
        .expect("an engine");
    let (mut transverse, mut polar) = (0.0, 0.0);
    engine = engine
        .with(|engine| {
            engine.counterweights = (0..count)
                .map(|k| {
                    let s = length * ((f64::from(k) + 0.5) / f64::from(count) - 0.5);
                    let (x, z, m) = (s * f64::sin(tilt), s * f64::cos(tilt), mass / f64::from(count));
                    transverse += m * z * z;
                    polar += m * x * x;
                    let x = x + offset;
                    let angle = if x < 0.0 { std::f64::consts::PI } else { 0.0 };
                    lanchester_model::Counterweight {
                        name: format!("piece {k}"),
                        crankshaft: 0,
                        z: z + 0.05,
                        unbalance: m * x.abs(),
                        angle: angle + 0.7,
                        part: None,
                    }
                })
                .collect();
        })
        .expect("an engine");
    let body = CrankBody { mass, mass_centre: 0.05, transverse_inertia: transverse, polar_inertia: polar };
    let got = crank_unbalance(&engine, 0, &[0.0], &planes(-0.2, 0.3), Some(body)).unwrap();
    let state = got.body.unwrap();
    assert!((state.tilt - tilt).abs() < 1e-12, "{}", state.tilt);
    assert!((state.tilt_direction - 0.7).abs() < 1e-9);
    assert!((state.offset - Complex64::from_polar(offset, 0.7)).norm() < 1e-15);
    assert_eq!(state.kind, UnbalanceKind::QuasiStatic);
    // One weight in the quasi-static plane is all of it.
    let quasi = state.quasi_static.unwrap();
    let one = PlaneUnbalance { name: String::new(), z: quasi.z, unbalance: got.static_unbalance };
    for (a, b) in in_two_planes(&[one], &planes(-0.2, 0.3)).unwrap().iter().zip(&got.planes) {
        assert!((a.unbalance - b.unbalance).norm() < 1e-12);
    }
}

#[test]
fn kinds_of_unbalance() {
    let mut engine = gallery("single");
    engine = engine
        .with(|engine| {
            engine.throws[0].unbalance = 0.0;
        })
        .expect("an engine");
    let weight = |z: f64, unbalance: f64, degrees: f64| lanchester_model::Counterweight {
        name: format!("at {z}"),
        crankshaft: 0,
        z,
        unbalance,
        angle: degrees.to_radians(),
        part: None,
    };
    let body = CrankBody { mass: 5.0, mass_centre: 0.02, transverse_inertia: 0.05, polar_inertia: 0.01 };
    let mut kind = |weights: Vec<lanchester_model::Counterweight>| {
        engine = engine
            .with(|engine| {
                engine.counterweights = weights;
            })
            .expect("an engine");
        crank_unbalance(&engine, 0, &[0.0], &planes(-0.2, 0.3), Some(body)).unwrap().body.unwrap().kind
    };
    assert_eq!(kind(vec![]), UnbalanceKind::Balanced);
    assert_eq!(kind(vec![weight(0.02, 1e-4, 40.0)]), UnbalanceKind::Static);
    assert_eq!(kind(vec![weight(0.1, 1e-4, 40.0)]), UnbalanceKind::QuasiStatic);
    assert_eq!(kind(vec![weight(0.1, 1e-4, 40.0), weight(-0.1, 1e-4, 220.0)]), UnbalanceKind::Couple);
    assert_eq!(kind(vec![weight(0.1, 1e-4, 40.0), weight(-0.1, 1e-4, 130.0)]), UnbalanceKind::Dynamic);
}

#[test]
fn a_body_that_cannot_be_is_refused() {
    let engine = gallery("single");
    let good = CrankBody { mass: 5.0, mass_centre: 0.0, transverse_inertia: 0.05, polar_inertia: 0.01 };
    let refused = |body, bobs: &[f64]| {
        crank_unbalance(&engine, 0, bobs, &planes(-0.2, 0.3), Some(body)).unwrap_err().to_string()
    };
    assert!(refused(CrankBody { mass: 0.0, ..good }, &[0.5]).contains("mass [kg] of the crankshaft"));
    assert!(
        refused(CrankBody { transverse_inertia: 0.004, ..good }, &[0.5]).contains("half the polar inertia")
    );
    assert!(refused(good, &[0.5, 0.5]).contains("1 throws need a bobweight each, got 2"));
    assert!(refused(good, &[-0.5]).contains("bobweight [kg] of throw 1"));
    assert!(crank_unbalance(&engine, 4, &[0.5], &planes(0.0, 1.0), None).is_err());
}
