use super::*;
use crate::{Plane, PlaneUnbalance, in_two_planes};
use lanchester_file::workshop::read_sheet;
use num_complex::Complex64;

/// Unbalances moved to two places along the shaft [kg m].
fn moved(unbalances: &[(f64, Complex64)], places: [f64; 2]) -> [Complex64; 2] {
    let unbalances: Vec<PlaneUnbalance> = unbalances
        .iter()
        .map(|(z, unbalance)| PlaneUnbalance { name: String::new(), z: *z, unbalance: *unbalance })
        .collect();
    in_two_planes(&unbalances, &places.map(|z| Plane { name: String::new(), z }))
        .unwrap()
        .map(|at| at.unbalance)
}

fn sheet(text: &str) -> Sheet {
    let reading = read_sheet(text);
    reading.sheet.unwrap_or_else(|| panic!("{:?}", reading.diagnostics))
}

fn rotor(more: &str) -> Sheet {
    sheet(&format!(
        "name = \"x\"\n[rotor]\nmass = \"12 kg\"\nspeed = \"6000 rpm\"\ngrade = \"G 6.3\"\n{more}"
    ))
}

#[test]
fn the_rule_of_thumb_of_the_workshop() {
    let found = grade(&rotor("")).unwrap();
    // U_per [g mm] = 9549 G m/n, with 9549 rounded from 30000/pi.
    let rule = 9549.0 * 6.3 * 12.0 / 6000.0;
    assert!((found.permissible * 1e6 / rule - 1.0).abs() < 4e-5, "{}", found.permissible);
    assert!(found.bearings.is_empty() && found.kept.is_none());
}

#[test]
fn bearings_share_by_levers_and_planes_use_them_up() {
    let found = grade(&rotor(
        "centre = \"150 mm\"\nsupports = [\"0 mm\", \"400 mm\"]\n\
         [[plane]]\nname = \"front\"\nz = \"50 mm\"\n[[plane]]\nname = \"rear\"\nz = \"300 mm\"",
    ))
    .unwrap();
    let [a, b] = [&found.bearings[0], &found.bearings[1]];
    assert!((a.permissible / found.permissible - 0.625).abs() < 1e-12);
    assert!((a.permissible + b.permissible - found.permissible).abs() < 1e-15);
    // Both planes at their limit and in one direction: both bearings just at theirs.
    let worst: Vec<(f64, Complex64)> =
        found.planes.iter().map(|plane| (plane.z, Complex64::from_polar(plane.permissible, 0.4))).collect();
    let on = moved(&worst, [a.z, b.z]);
    assert!(
        (on[0].norm() / a.permissible - 1.0).abs() < 1e-12
            && (on[1].norm() / b.permissible - 1.0).abs() < 1e-12
    );
}

/// Limits of ISO 21940-11: 0.3 and 0.7 of the whole inside the bearings, 0.3 and 1.3 outside.
#[test]
fn lit_iso21940_no_bearing_gets_too_little_or_too_much() {
    for (centre, shares) in [
        (40.0, [0.7, 0.3]),
        (100.0, [0.7, 0.3]),
        (160.0, [0.6, 0.4]),
        (390.0, [0.3, 0.7]),
        (440.0, [0.3, 1.1]),
        (560.0, [0.4, 1.3]),
        (-60.0, [1.15, 0.3]),
    ] {
        let found =
            grade(&rotor(&format!("centre = \"{centre} mm\"\nsupports = [\"0 mm\", \"400 mm\"]"))).unwrap();
        for (bearing, share) in found.bearings.iter().zip(shares) {
            let got = bearing.permissible / found.permissible;
            assert!((got - share).abs() < 1e-12, "centre at {centre} mm: {got} instead of {share}");
        }
    }
}

#[test]
fn overhung_planes_never_exceed_a_bearing() {
    let found = grade(&rotor(
        "centre = \"450 mm\"\nsupports = [\"0 mm\", \"300 mm\"]\n\
         [[plane]]\nname = \"one\"\nz = \"420 mm\"\n[[plane]]\nname = \"two\"\nz = \"500 mm\"",
    ))
    .unwrap();
    for step in 0..72 {
        let angle = f64::from(step) * 5f64.to_radians();
        let left = [
            (0.42, Complex64::from(found.planes[0].permissible)),
            (0.5, Complex64::from_polar(found.planes[1].permissible, angle)),
        ];
        let on = moved(&left, [0.0, 0.3]);
        for (part, bearing) in on.iter().zip(&found.bearings) {
            assert!(part.norm() <= bearing.permissible * (1.0 + 1e-12), "{angle}");
        }
    }
}

#[test]
fn the_verdict_is_that_of_the_bearings() {
    let text = |amount: &str| {
        format!(
            "centre = \"200 mm\"\nsupports = [\"0 mm\", \"400 mm\"]\n\
             [[plane]]\nname = \"front\"\nz = \"100 mm\"\n[[plane]]\nname = \"rear\"\nz = \"300 mm\"\n\
             [[display]]\nkind = \"couple\"\nplanes = [\"100 mm\", \"300 mm\"]\nunbalance = \"{amount}\"\nangle = \"30 deg\""
        )
    };
    // Each bearing and each plane may have 60.16 g mm; a couple of U at half the distance is U/2 at the bearings.
    let within = grade(&rotor(&text("100 g mm"))).unwrap();
    assert_eq!(within.kept, Some(true));
    assert!(
        within.planes.iter().all(|plane| plane.kept == Some(false)),
        "the planes' rule is the stricter one"
    );
    assert!(within.resultant.unwrap().norm() < 1e-18);
    assert_eq!(grade(&rotor(&text("130 g mm"))).unwrap().kept, Some(false));
}

/// A couple of 130 g mm is beyond what the bearings may have (the test above), and its resultant is nothing.
#[test]
fn a_couple_is_not_judged_by_its_resultant() {
    let measured = |amounts: [f64; 2]| {
        let display = |z: f64, amount: f64, angle: f64| {
            format!(
                "[[display]]\nkind = \"plane\"\nz = \"{z} mm\"\nunbalance = \"{amount} g mm\"\nangle = \"{angle} deg\"\n"
            )
        };
        grade(&rotor(&(display(100.0, amounts[0], 30.0) + &display(300.0, amounts[1], 210.0)))).unwrap()
    };
    let couple = measured([130.0, 130.0]);
    assert!(couple.resultant.unwrap().norm() < 1e-12 && couple.bearings.is_empty());
    assert_eq!(couple.kept, None);
    // U_per is 120.3 g mm.
    assert_eq!(measured([130.0, 5.0]).kept, Some(false));
}

#[test]
fn what_is_missing_is_named() {
    let error = grade(&sheet("name = \"x\"\n[rotor]\nmass = \"1 kg\"\nspeed = \"10 Hz\"")).unwrap_err();
    assert!(error.to_string().contains("G 6.3"), "{error}");
}
