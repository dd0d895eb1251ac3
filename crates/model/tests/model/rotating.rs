//! The list of rotating bodies and the faults of single crank elements.

use lanchester_file::read;
use lanchester_model::{
    Engine, Gear, GearDisc, InertiaSum, Origin, Ratio, RotatingKind, ShapedCrankshaft, crank_faults,
};
use std::f64::consts::PI;

const EXAMPLE: &str = include_str!("../../../../examples/in-line-4-crank-by-elements.toml");

fn example() -> Engine {
    read(EXAMPLE).engine().unwrap()
}

fn gear(name: &str, ratio: Ratio, inertia: Option<f64>, disc: Option<GearDisc>) -> Gear {
    Gear { name: name.into(), ratio, x: 0.1, y: 0.0, inertia, disc }
}

fn geared() -> Engine {
    let disc = GearDisc { diameter: 0.12, bore: 0.03, width: 0.018, density: 7850.0 };
    example()
        .with(|parts| {
            parts.gears.push(gear("camshaft", Ratio::new(-1, 2).unwrap(), None, Some(disc)));
            parts.gears.push(gear("alternator", Ratio::new(5, 2).unwrap(), Some(0.002), None));
        })
        .unwrap()
}

#[test]
fn gears_count_with_ratio_in_momentum_and_with_its_square_in_energy() {
    let engine = geared();
    // By hand: a disc of 120 mm with a bore of 30 mm, 18 mm wide.
    let mass = 7850.0 * 0.018 * PI * (0.06_f64.powi(2) - 0.015_f64.powi(2));
    let disc = mass / 2.0 * (0.06_f64.powi(2) + 0.015_f64.powi(2));
    assert!((engine.geared_inertia() - (disc / 4.0 + 6.25 * 0.002)).abs() < 1e-17);
    let bodies = engine.rotating_bodies(&[]);
    let of = |kind| bodies.iter().find(|body| body.kind == kind).unwrap();
    let camshaft = of(RotatingKind::Gear(0));
    assert_eq!(camshaft.inertia.unwrap().origin, Origin::FromShape);
    assert!((camshaft.mass.unwrap().value - mass).abs() < 1e-15);
    assert!((camshaft.momentum().unwrap() + disc / 2.0).abs() < 1e-17);
    let alternator = of(RotatingKind::Gear(1));
    assert_eq!(alternator.inertia.unwrap().origin, Origin::Given);
    assert_eq!(alternator.momentum(), Some(0.005));
    // As shafts without weights they go into every other model.
    let shafts = engine.geared_shafts();
    assert_eq!((shafts.len(), shafts[1].inertia, shafts[1].weights.len()), (2, Some(0.002), 0));
}

#[test]
fn what_is_not_known_names_its_key_and_is_not_zero() {
    let engine = example();
    let unknown = engine.rotating_bodies(&[]);
    assert_eq!(unknown[0].inertia, None);
    assert_eq!(
        InertiaSum::of(&unknown).missing,
        vec![("crankshaft".to_owned(), "flywheel.crankshaft_inertia")]
    );
    let shape = ShapedCrankshaft { mass: 12.0, centre: [0.0; 3], inertia: 0.02 };
    let known = InertiaSum::of(&engine.rotating_bodies(&[Some(shape)]));
    assert!(known.missing.is_empty());
    assert!((known.known - 0.14).abs() < 1e-15);
    assert_eq!(known.origin, Some(Origin::FromShape), "the least certain of its parts");
}

#[test]
fn a_gear_of_no_engine_is_a_fault() {
    let bad = example().with(|parts| {
        parts.gears.push(gear("one", Ratio::ONE, Some(-1.0), None));
        parts.gears.push(gear("one", Ratio::ONE, Some(f64::NAN), None));
    });
    let faults: Vec<String> = bad.unwrap_err().iter().map(ToString::to_string).collect();
    assert!(faults.iter().any(|fault| fault.starts_with("gears[0]: inertia")), "{faults:?}");
    assert!(faults.iter().any(|fault| fault.starts_with("gears[1]: inertia")), "{faults:?}");
    assert!(faults.iter().any(|fault| fault.starts_with("gears[1]: name")), "{faults:?}");
}

#[test]
fn elements_that_do_not_fit_are_faults_each_with_its_place() {
    assert!(crank_faults(&example()).is_empty());
    let bad = example().with(|parts| {
        let details = parts.crank_details.as_mut().unwrap();
        details.pins[0].bore = Some(0.05);
        details.pins[1].recess = Some(0.004);
        details.webs[0].pin_end_radius = Some(0.02);
        details.journals[0].fillet = Some(0.02);
        details.ends[2].bore = 0.2;
    });
    let faults: Vec<String> =
        bad.unwrap_err().iter().map(|fault| format!("{}: {}", fault.part, fault.quantity)).collect();
    for wanted in [
        "pin 1: bore",
        "pin 4: recess",
        "pin 1: diameter",
        "journal 3: fillet",
        "step 3 of nose and flange: bore",
    ] {
        assert!(faults.iter().any(|fault| fault == wanted), "{wanted} in {faults:?}");
    }
    let bad = example().with(|parts| parts.crank_details.as_mut().unwrap().webs[0].web = 8);
    assert!(bad.unwrap_err()[0].to_string().contains("web must be from 0 to 7"));
    let bad = example().with(|parts| {
        let details = parts.crank_details.as_mut().unwrap();
        details.pins[1].throw = details.pins[0].throw;
    });
    assert!(bad.unwrap_err()[0].to_string().contains("join the two"));
}

#[test]
fn material_and_bearings_say_where_their_numbers_come_from() {
    let engine = example();
    let material = engine.crank_material.unwrap();
    let tensile = material.tensile_strength().unwrap();
    assert_eq!((tensile.value, tensile.origin), (900e6, Origin::Typical));
    let bending = material.fatigue_bending().unwrap();
    assert_eq!((bending.value, bending.origin), (405e6, Origin::Assumed));
    assert!((material.fatigue_torsion().unwrap().value - 405e6 / 3_f64.sqrt()).abs() < 1.0);
    assert_eq!(material.forging_factor().value, 1.05);
    // Main 3 has a width of its own and the rest of all.
    let [third, second] = [2, 1].map(|index| engine.main_bearing_data(index));
    assert_eq!((third.width, second.width), (Some(0.022), Some(0.02)));
    assert_eq!(third.diametral_clearance, Some(0.06e-3));
    assert_eq!(third.grooves.unwrap().len(), 1);
    assert_eq!(engine.crankpin_bearing_data(0).diametral_clearance, Some(0.05e-3));
}
