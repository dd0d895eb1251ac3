//! Whole engine files, short and general form.

use lanchester_file::{EngineFile, Severity, expanded, read, render};
use lanchester_model::{Engine, RodJoint, RodMassRule};
use std::f64::consts::{PI, TAU};

#[track_caller]
fn engine(text: &str) -> Engine {
    let reading = read(text);
    let rendered = render(&reading.diagnostics, "engine.toml", text, false);
    assert!(reading.diagnostics.is_empty(), "{rendered}");
    let file = reading.file.expect("no engine");
    assert_reads_back(&file);
    file.engine
}

/// The expanded form is the same engine, to the last bit.
#[track_caller]
fn assert_reads_back(file: &EngineFile) {
    let text = expanded(file);
    let reading = read(&text);
    let rendered = render(&reading.diagnostics, "expanded.toml", &text, false);
    assert_eq!(reading.file.as_ref(), Some(file), "{rendered}{text}");
}

const FOUR: &str = r#"
name = "Four in line"
speed = ["800 rpm", "6000 rpm"]

[firing]
order = [1, 3, 4, 2]

[layout]
type = "in-line"
cylinders = 4
spacing = "88 mm"

[crank]
stroke = "95.5 mm"
pin_mass = "0.5 kg"
web_mass = "0.8 kg"
web_radius = "-12 mm"
web_distance = "44 mm"

[piston]
mass = "0.5 kg"
bore = "79.5 mm"

[rod]
length = "144 mm"
mass = "0.63 kg"

[counterweights]
rotating_share = "100 %"
reciprocating_share = 0.5
at = "webs"

[[counterweight]]
name = "flywheel"
z = "200 mm"
mass = "0.1 kg"
radius = "100 mm"
angle = "90 deg"

[[shaft]]
name = "left"
ratio = -2
x = "50 mm"
y = "100 mm"
weights = [{ z = "0 mm", unbalance = "0.003 kg m", phase = "180 deg" }]

[[mount]]
name = "front"
x = "0 mm"
y = "-200 mm"
z = "0 mm"

[[cylinder]]
number = 2
piston = { mass = "0.52 kg" }
rod = { big_end_mass = "0.42 kg", small_end_mass = "0.21 kg", inertia = "2000 kg mm2" }
"#;

#[test]
fn in_line_four() {
    let engine = engine(FOUR);
    assert_eq!(engine.throws.len(), 4);
    let angles: Vec<f64> = engine.throws.iter().map(|throw| throw.angle.to_degrees().round()).collect();
    assert_eq!(angles, [0.0, 180.0, 180.0, 0.0]);
    let firing: Vec<f64> =
        engine.cylinders.iter().map(|c| c.firing_angle.unwrap().to_degrees().round()).collect();
    assert_eq!(firing, [0.0, 540.0, 180.0, 360.0]);
    assert_eq!(engine.throws[0].z, -0.132);
    assert_eq!(engine.throws[0].webs, Some([-0.132 - 0.022, -0.132 + 0.022]));
    // m_pin r + 2 m_web r_web
    assert!((engine.throws[0].unbalance - (0.5 * 0.04775 - 2.0 * 0.8 * 0.012)).abs() < 1e-15);
    assert_eq!(engine.cylinders[1].piston_mass, 0.52);
    assert_eq!(engine.cylinders[1].rod.mass_rule, RodMassRule::WeighedEnds);
    assert_eq!(engine.cylinders[0].rod.mass_rule, RodMassRule::Thirds);
    assert_eq!(engine.cylinders[0].bore, Some(0.0795));
    assert_eq!(engine.counterweights.len(), 9);
    let throw = &engine.throws[0];
    let wanted = throw.unbalance + engine.rod_unbalance(0) + 0.5 * (0.5 + 0.21) * throw.radius;
    let first = &engine.counterweights[0];
    assert!((first.unbalance - wanted / 2.0).abs() < 1e-15, "{first:?}");
    assert_eq!((first.name.as_str(), first.z, first.angle), ("web 1", -0.132 - 0.022, PI));
    let flywheel = &engine.counterweights[8];
    assert!((flywheel.unbalance - 0.01).abs() < 1e-17);
    assert_eq!((flywheel.name.as_str(), flywheel.z), ("flywheel", 0.2));
    assert_eq!(engine.speed.highest, 6000.0 * (PI / 30.0));
}

const OPPOSED: &str = r#"
name = "Opposed pistons"
strokes = 2
speed = "3000 rpm"
origin = "10 mm"
[[crankshaft]]
name = "exhaust"
[[crankshaft]]
name = "inlet"
ratio = -1
phase = "12 deg"
x = "600 mm"
[[throw]]
angle = "0 deg"
z = "10 mm"
[[throw]]
crankshaft = 2
angle = "180 deg"
z = "10 mm"
radius = "35 mm"
[crank]
radius = "40 mm"
[piston]
mass = "0.5 kg"
[rod]
length = "150 mm"
mass = "0.6 kg"
centre_of_gravity = "50 mm"
[[cylinder]]
throw = 1
angle = "0 deg"
[[cylinder]]
throw = 2
angle = "180 deg"
[firing]
angles = ["0 deg", "12 deg"]
"#;

#[test]
fn opposed_pistons_on_geared_cranks() {
    let engine = engine(OPPOSED);
    assert_eq!(engine.crankshafts[1].ratio.value(), -1.0);
    assert_eq!((engine.throws[0].z, engine.throws[1].radius, engine.throws[0].radius), (0.0, 0.035, 0.04));
    assert_eq!(engine.cylinders[1].z, 0.0);
    let rod = &engine.cylinders[0].rod;
    assert!((rod.centre_of_gravity() - 0.05).abs() < 1e-15);
    assert!((rod.mass() - 0.6).abs() < 1e-15);
    assert!((engine.cylinders[1].firing_angle.unwrap() - 12_f64.to_radians()).abs() < 1e-12);
}

#[test]
fn radial_five_with_articulated_rods() {
    let text = r#"
name = "Radial five"
speed = "2000 rpm"
[firing]
order = [1, 3, 5, 2, 4]
[layout]
type = "radial"
cylinders = 5
knuckle_radius = "50 mm"
[crank]
stroke = "140 mm"
[piston]
mass = "2 kg"
[rod]
length = "250 mm"
mass = "3 kg"
[articulated_rod]
length = "200 mm"
big_end_mass = "0.5 kg"
small_end_mass = "0.4 kg"
"#;
    let engine = engine(text);
    assert_eq!(engine.throws.len(), 1);
    let RodJoint::Articulated { master, knuckle_radius, knuckle_angle } = engine.cylinders[2].rod.joint
    else {
        panic!("cylinder 3 is a slave")
    };
    assert_eq!((master, knuckle_radius), (0, 0.05));
    assert!((knuckle_angle - 2.0 * TAU / 5.0).abs() < 1e-12);
    assert_eq!(engine.cylinders[2].rod.length, 0.2);
}

#[test]
fn a_v_with_side_by_side_rods_in_one_plane_is_a_stated_simplification() {
    let text = r#"
name = "V8"
speed = "6000 rpm"
[layout]
type = "v"
cylinders = 8
spacing = "110 mm"
bank_angle = "90 deg"
crank_angles = ["0 deg", "90 deg", "270 deg", "180 deg"]
numbering = "alternating"
[crank]
stroke = "90 mm"
[piston]
mass = "0.5 kg"
[rod]
length = "150 mm"
mass = "0.6 kg"
"#;
    let reading = read(text);
    let codes: Vec<_> = reading.diagnostics.iter().map(|d| (d.code, d.severity)).collect();
    assert_eq!(codes, [("W0505", Severity::Warning)]);
    assert_eq!(reading.engine().unwrap().throws.len(), 4);
}

#[test]
fn byte_order_mark_and_windows_line_ends_change_nothing() {
    let plain = engine(FOUR);
    let windows = engine(&format!("\u{feff}{}", FOUR.replace('\n', "\r\n")));
    assert_eq!(plain, windows);
}

#[test]
fn z_counts_from_midway_between_the_outer_throws_or_from_the_origin() {
    let text = r#"
name = "Twin with a wide flywheel side"
speed = "3000 rpm"
[layout]
type = "in-line"
cylinders = 2
positions = ["10 mm", "110 mm"]
crank_angles = ["0 deg", "180 deg"]
[crank]
stroke = "60 mm"
web_distance = "30 mm"
[piston]
mass = "0.3 kg"
[rod]
length = "110 mm"
mass = "0.3 kg"
[[counterweight]]
web = 4
unbalance = "2 oz in"
[[counterweight]]
z = "150 mm"
unbalance = "5 g mm"
[[mount]]
x = "0 mm"
y = "0 mm"
z = "60 mm"
[[shaft]]
ratio = "-1/2"
weights = [{ z = "20 mm", mass = "100 g", radius = "2 cm" }]
"#;
    let near = |got: f64, expected: f64| assert!((got - expected).abs() < 1e-15, "{got} {expected}");
    let middle = engine(text);
    near(middle.throws[0].z, -0.05);
    near(middle.cylinders[1].z, 0.05);
    near(middle.mounts[0].z, 0.0);
    near(middle.shafts[0].weights[0].z, -0.04);
    near(middle.shafts[0].weights[0].unbalance, 0.002);
    // Web 4 is the rear web of throw 2; its weight stands opposite that throw.
    let weight = &middle.counterweights[0];
    assert_eq!((weight.name.as_str(), weight.z), ("web 4", middle.throws[1].webs.unwrap()[1]));
    near(weight.z, 0.065);
    near(weight.angle, 0.0);
    near(middle.counterweights[1].z, 0.09);

    let moved = engine(&text.replace("[layout]", "origin = \"10 mm\"\n[layout]"));
    near(moved.throws[0].z, 0.0);
    near(moved.counterweights[0].z, 0.115);
    near(moved.mounts[0].z, 0.05);
}

#[test]
fn a_mass_rule_of_one_cylinder_replaces_the_whole_rule() {
    let text = FOUR.replace(
        "mass = \"0.63 kg\"",
        "mass = \"0.63 kg\"\ncentre_of_gravity = \"40 mm\"\ninertia = \"2500 kg mm2\"",
    );
    let text = text
        .replace("number = 2\npiston = { mass = \"0.52 kg\" }", "number = 2\npiston = { bore = \"80 mm\" }");
    let text = text.replace(
        "rod = { big_end_mass = \"0.42 kg\", small_end_mass = \"0.21 kg\", inertia = \"2000 kg mm2\" }",
        "rod = { mass = \"0.66 kg\" }\n[[cylinder]]\nnumber = 3\nrod = { inertia = \"2600 kg mm2\" }",
    );
    let engine = engine(&text);
    let rules: Vec<_> = engine.cylinders.iter().map(|c| (c.rod.mass_rule, c.rod.inertia)).collect();
    let usual = (RodMassRule::CentreOfGravity, Some(2500e-6));
    let other = (RodMassRule::CentreOfGravity, Some(2600e-6));
    assert_eq!(rules, [usual, (RodMassRule::Thirds, None), other, usual]);
    assert_eq!((engine.cylinders[1].bore, engine.cylinders[1].piston_mass), (Some(0.08), 0.5));
}
