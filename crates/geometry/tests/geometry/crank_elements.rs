//! The crankshaft by elements: what single elements change, against the uniform body and against numbers by hand.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester_file::{expanded, read, render};
use lanchester_geometry::crankshaft::{CrankshaftBody, crankshaft};
use lanchester_geometry::export::{StepHeader, solids, step};
use lanchester_model::*;
use lanchester_shape::Point;
use std::f64::consts::PI;

const EXAMPLE: &str = include_str!("../../../../examples/in-line-4-crank-by-elements.toml");

const UNIFORM: &str = r#"
name = "Two"
speed = "3000 rpm"
[layout]
type = "in-line"
cylinders = 2
spacing = "90 mm"
crank_angles = ["0 deg", "90 deg"]
[piston]
mass = "0.3 kg"
[rod]
length = "120 mm"
mass = "0.3 kg"
[crank]
stroke = "80 mm"
web_distance = "44 mm"
[crank.body]
density = "7850 kg/m3"
journal_diameter = "54 mm"
journal_bore = "10 mm"
pin_diameter = "46 mm"
web_thickness = "18 mm"
web_radius = "36 mm"
pin_end_radius = "32 mm"
end_journals = ["20 mm", "30 mm"]
"#;

fn engine(text: &str) -> Engine {
    let reading = read(text);
    assert!(reading.diagnostics.is_empty(), "{}", render(&reading.diagnostics, "engine.toml", text, false));
    reading.engine().unwrap()
}

fn body(text: &str) -> CrankshaftBody {
    crankshaft(&engine(text), 0).unwrap()
}

fn near(found: f64, wanted: f64, tolerance: f64, what: &str) {
    assert!((found - wanted).abs() <= tolerance, "{what}: {found} against {wanted}");
}

#[test]
fn a_crank_written_out_element_by_element_is_the_uniform_one() {
    // Half of what the uniform body says is wrong here, and every element says its own: planes at -45 and 45 mm, webs at -22 and +22 mm of them.
    let mut text = UNIFORM.replace("journal_diameter = \"54 mm\"", "journal_diameter = \"60 mm\"");
    text = text.replace("pin_diameter = \"46 mm\"", "pin_diameter = \"50 mm\"");
    text = text.replace("journal_bore = \"10 mm\"", "journal_bore = \"20 mm\"");
    text = text.replace("web_thickness = \"18 mm\"", "web_thickness = \"12 mm\"");
    text = text.replace("web_radius = \"36 mm\"", "web_radius = \"40 mm\"");
    for journal in 1..=3 {
        text += &format!(
            "[[crank.body.journal]]\nnumbers = [{journal}]\ndiameter = \"54 mm\"\nbore = \"10 mm\"\n"
        );
    }
    text += "[[crank.body.pin]]\nnumbers = [1, 2]\ndiameter = \"46 mm\"\n";
    for (web, position) in [(1, 23), (2, 67), (3, 113), (4, 157)] {
        text += &format!(
            "[[crank.body.web]]\nnumbers = [{web}]\nthickness = \"18 mm\"\nradius = \"36 mm\"\nposition = \"{} mm\"\n",
            position - 90
        );
    }
    let (written, uniform) = (body(&text), body(UNIFORM));
    let scale = uniform.mass.mass;
    near(written.mass.mass, scale, 1e-12 * scale, "mass");
    near(written.polar_inertia, uniform.polar_inertia, 1e-12 * uniform.polar_inertia, "polar inertia");
    for axis in 0..3 {
        near(written.mass.centre[axis], uniform.mass.centre[axis], 1e-12, "centre");
    }
    let largest = uniform.polar_inertia.max(scale * 0.01);
    let couple = written.unbalance.couple - uniform.unbalance.couple;
    assert!((written.unbalance.unbalance - uniform.unbalance.unbalance).norm() < 1e-12 * scale * 0.05);
    assert!(couple.norm() < 1e-12 * largest);
    for (one, other) in written.sections.iter().zip(&uniform.sections) {
        assert_eq!((&one.name, one.kind, one.throw), (&other.name, other.kind, other.throw));
        near(one.mass, other.mass, 1e-12 * scale, &one.name);
    }
    // Planes and unbalances of the throws too.
    for (one, other) in engine(&text).throws.iter().zip(&engine(UNIFORM).throws) {
        near(one.unbalance, other.unbalance, 1e-14, "unbalance of the throw");
        near(one.unbalance_plane(), other.unbalance_plane(), 1e-14, "its plane");
    }
}

#[test]
fn a_bored_pin_loses_the_mass_of_its_bore() {
    let bored = body(&format!("{UNIFORM}[[crank.body.pin]]\nnumbers = [2]\nbore = \"16 mm\"\n"));
    let uniform = body(UNIFORM);
    // The pin is 44 - 18 = 26 mm long.
    let bore = 7850.0 * PI / 4.0 * 0.016_f64.powi(2) * 0.026;
    near(uniform.mass.mass - bored.mass.mass, bore, 1e-14, "mass of the bore");
    // Its unbalance is that mass at the crank radius, at the angle of throw 2.
    let lost = uniform.unbalance.unbalance - bored.unbalance.unbalance;
    assert!((lost - Point::polar(bore * 0.04, PI / 2.0)).norm() < 1e-15, "{lost:?}");
    let polar = bore * (0.016_f64.powi(2) / 8.0 + 0.04_f64.powi(2));
    near(uniform.polar_inertia - bored.polar_inertia, polar, 1e-15, "polar inertia of the bore");
}

/// Area of the convex hull of two discs at a distance, by sectors and the trapezoids between tangents and line of centres.
fn hull(one: f64, two: f64, distance: f64) -> f64 {
    let half_angle = ((one - two) / distance).acos();
    let tangent = (distance * distance - (one - two).powi(2)).sqrt();
    (one + two) * tangent + one * one * (PI - half_angle) + two * two * half_angle
}

#[test]
fn the_example_weighs_what_its_elements_weigh_by_hand() {
    let crank = body(EXAMPLE);
    let round =
        |diameter: f64, bore: f64, length: f64| PI / 4.0 * (diameter * diameter - bore * bore) * length;
    // Pins 45 - 20 = 25 mm; inner journals 91 - 45 - 20 = 26 mm; end journals as given, whatever the webs beside them.
    let journals = round(0.058, 0.0, 0.022 + 0.026 + 2.0 * 0.026) + round(0.062, 0.020, 0.026);
    let pins = round(0.048, 0.0, 2.0 * 0.025) + round(0.048, 0.018, 2.0 * 0.025);
    let usual = hull(0.038, 0.034, 0.044);
    let webs = 6.0 * 0.020 * usual + 0.024 * usual + 0.024 * hull(0.042, 0.034, 0.044);
    let ends = round(0.032, 0.0, 0.030) + round(0.045, 0.0, 0.012) + round(0.096, 0.022, 0.012);
    let mass = 7850.0 * (journals + pins + webs + ends);
    near(crank.mass.mass, mass, 1e-12 * mass, "mass");

    let faces: Vec<(String, i64, i64)> = crank
        .sections
        .iter()
        .map(|section| (section.name.clone(), micrometres(section.from), micrometres(section.to)))
        .collect();
    let face = |name: &str| faces.iter().find(|one| one.0 == name).map(|one| (one.1, one.2)).unwrap();
    // Throw 1 stands at -136.5 mm; web 1 keeps its face at the pin, -136.5 - 12.5 mm.
    assert_eq!(face("pin 1"), (-149_000, -124_000));
    assert_eq!(face("web 1"), (-173_000, -149_000));
    assert_eq!(face("journal 1"), (-195_000, -173_000));
    assert_eq!(face("nose 2"), (-207_000, -195_000));
    assert_eq!(face("nose 1"), (-237_000, -207_000));
    assert_eq!(face("web 8"), (149_000, 173_000));
    assert_eq!(face("journal 5"), (173_000, 199_000));
    assert_eq!(face("flange 1"), (199_000, 211_000));
}

fn micrometres(length: f64) -> i64 {
    (length * 1e6).round() as i64
}

/// What the throws of the engine say is what the body has: a thicker web moves the plane of a throw's unbalance.
#[test]
fn unbalance_and_couple_of_the_body_are_those_of_the_throws() {
    let engine = engine(EXAMPLE);
    let crank = crankshaft(&engine, 0).unwrap();
    let (mut unbalance, mut couple) = (Point::ORIGIN, Point::ORIGIN);
    for throw in &engine.throws {
        let own = Point::polar(throw.unbalance, throw.angle);
        unbalance = unbalance + own;
        couple = couple + own * throw.unbalance_plane();
    }
    assert!((crank.unbalance.unbalance - unbalance).norm() < 1e-14, "{:?} {unbalance:?}", crank.unbalance);
    assert!((crank.unbalance.couple - couple).norm() < 1e-14, "{:?} {couple:?}", crank.unbalance);
    assert!(engine.throws[0].unbalance_offset < -1e-4, "the thick web stands in front");
    assert_eq!(engine.throws[1].unbalance_offset, 0.0);
}

/// The solids that go into STEP and STL have the mass of the body, with nose and flange.
#[test]
fn solids_follow_the_elements() {
    let crank = body(EXAMPLE);
    let mass: f64 = crank.parts.iter().map(|placed| placed.part.moments().mass).sum();
    near(mass, crank.mass.mass, 1e-12 * mass, "mass of the solids");
    let names: Vec<&str> = crank.parts.iter().map(|placed| placed.name.as_str()).collect();
    assert!(names.contains(&"nose 1") && names.contains(&"flange 1"), "{names:?}");
    let text = step(&solids(&crank.parts).unwrap(), &StepHeader::default());
    assert!(text.contains("flange 1"), "the STEP file names it");
}

/// The expanded form has every element, and makes the same engine to the last bit.
#[test]
fn the_expanded_form_keeps_the_elements() {
    for text in [
        EXAMPLE.to_owned(),
        UNIFORM.to_owned(),
        format!("{UNIFORM}[[crank.body.web]]\nnumbers = [2]\nthickness = \"21.3 mm\"\n"),
    ] {
        let file = read(&text).file.unwrap();
        let written = expanded(&file);
        let again = read(&written);
        assert!(again.diagnostics.is_empty(), "{}", render(&again.diagnostics, "x", &written, false));
        assert_eq!(again.file.unwrap().engine, file.engine, "{written}");
    }
    let file = read(EXAMPLE).file.unwrap();
    let written = expanded(&file);
    for line in ["pin 4", "journal 3", "web 8", "nose 2", "flange 1"] {
        assert!(written.contains(&format!("#   {line}")), "{written}");
    }
}

#[test]
fn elements_know_fillets_undercuts_and_oil_holes() {
    let elements = engine(EXAMPLE).crank_elements(0).unwrap();
    let of = |name: &str| *elements.iter().find(|element| element.name() == name).unwrap();
    let fillet = |radius: f64, recess: f64| Some(Fillet { radius: Some(radius), recess });
    assert_eq!(of("pin 1").bar().unwrap().fillets, [fillet(0.0025, 0.0003); 2]);
    assert_eq!(of("pin 2").bar().unwrap().fillets, [fillet(0.003, 0.0); 2]);
    // The first journal has a web at its rear face alone.
    assert_eq!(of("journal 1").bar().unwrap().fillets, [None, fillet(0.003, 0.0)]);
    let CrankElementForm::Pin { oil_hole: Some(hole), .. } = of("pin 3").form else { panic!("no oil hole") };
    assert_eq!((hole.diameter, hole.angle), (0.005, PI / 3.0));
    // Elements follow each other without gaps.
    assert!(elements.windows(2).all(|pair| (pair[0].faces[1] - pair[1].faces[0]).abs() < 1e-12));
    // The outlines of single elements are those of the body.
    let mass: f64 = elements
        .iter()
        .map(|element| element.density * element.length() * element.outline().unwrap().moments().area)
        .sum();
    near(mass, body(EXAMPLE).mass.mass, 1e-12 * mass, "mass by elements");
}
