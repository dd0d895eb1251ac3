//! Weights of balance shafts as parts, and `[shaft_weight_design]`.

use lanchester_file::{EngineFile, Severity, expanded, json_schema, read, render};
use lanchester_model::{Engine, ShaftWeight};
use lanchester_task::{Range, ShaftWeightAim, ShaftWeightTask};
use proptest::prelude::*;

const HEAD: &str = r#"name = "Single"
speed = "3000 rpm"
origin = "15 mm"
[piston]
mass = "0.3 kg"
[rod]
length = "110 mm"
mass = "0.3 kg"
[layout]
type = "in-line"
cylinders = 1
[crank]
stroke = "60 mm"
"#;

/// The engine of a text, which must read back from its expanded form to the last bit.
fn engine(text: &str) -> Engine {
    file(text).engine
}

/// As [`engine`], with what is asked of it.
fn file(text: &str) -> EngineFile {
    let reading = read(text);
    let shown = render(&reading.diagnostics, "engine.toml", text, false);
    let file = reading.file.unwrap_or_else(|| panic!("{shown}\n{text}"));
    let printed = expanded(&file);
    let again = read(&printed);
    let shown = render(&again.diagnostics, "expanded.toml", &printed, false);
    assert_eq!(again.file.as_ref(), Some(&file), "{shown}\n{printed}");
    file
}

fn codes(text: &str) -> Vec<&'static str> {
    read(text).diagnostics.iter().map(|diagnostic| diagnostic.code).collect()
}

fn shaft(weight: &str) -> String {
    format!("{HEAD}[[shaft]]\nratio = -1\n[[shaft.weights]]\nz = \"40 mm\"\nphase = \"30 deg\"\n{weight}")
}

fn weight(text: &str) -> ShaftWeight {
    engine(&shaft(text)).shafts[0].weights[0].clone()
}

const HALF: &str = "[shaft.weights.shape]\nshaft_diameter = \"24 mm\"\nradius = \"36 mm\"\nlength = \"40 mm\"\n\
                    density = \"7850 kg/m3\"\n";

#[test]
fn half_a_disc_around_its_shaft_has_its_unbalance() {
    let found = weight(HALF);
    // 2/3 (R^3 - r^3) of a half ring; mass and inertia are half of those of a ring.
    let unbalance = 7850.0 * 0.04 * 2.0 / 3.0 * (0.036f64.powi(3) - 0.012f64.powi(3));
    assert!((found.unbalance / unbalance - 1.0).abs() < 1e-14, "{found:?}");
    assert_eq!((found.z, found.phase), (0.04 - 0.015, 30f64.to_radians()));
    let part = found.part.expect("a part");
    let half = std::f64::consts::FRAC_PI_2 * 7850.0 * 0.04;
    let mass = half * (0.036f64.powi(2) - 0.012f64.powi(2));
    let inertia = half / 2.0 * (0.036f64.powi(4) - 0.012f64.powi(4));
    assert!((part.mass() / mass - 1.0).abs() < 1e-14 && (part.polar_inertia() / inertia - 1.0).abs() < 1e-14);
    assert_eq!(part.wanted, None);
}

#[test]
fn the_chord_may_be_given_by_its_angle() {
    let by_angle = weight(&format!("{HALF}half_angle = \"80 deg\"\n"));
    let chord = 36.0 * 80f64.to_radians().cos();
    let by_chord = weight(&format!("{HALF}chord = \"{chord} mm\"\n"));
    assert!((by_angle.unbalance / by_chord.unbalance - 1.0).abs() < 1e-13);
    assert!(by_angle.unbalance < weight(HALF).unbalance);
}

#[test]
fn a_shape_that_misses_its_unbalance_is_told() {
    let unbalance = weight(HALF).unbalance;
    let text = |share: f64| shaft(&format!("unbalance = \"{} kg m\"\n{HALF}", share * unbalance));
    assert_eq!(codes(&text(1.0095)), Vec::<&str>::new());
    assert_eq!(codes(&text(0.9905)), Vec::<&str>::new());
    assert_eq!(codes(&text(1.0105)), ["W0901"]);
    assert_eq!(codes(&text(0.9895)), ["W0901"]);
    let read = engine(&text(1.005));
    let weight = &read.shafts[0].weights[0];
    assert_eq!(weight.unbalance, unbalance);
    assert!((weight.part.and_then(|part| part.wanted).expect("wanted") / unbalance - 1.005).abs() < 1e-12);
}

#[test]
fn weights_of_one_shaft_that_share_metal_are_told() {
    let text = |z: f64, phase: f64, chord: f64| {
        let one = |z: f64, phase: f64| {
            format!(
                "[[shaft.weights]]\nz = \"{z} mm\"\nphase = \"{phase} deg\"\n{HALF}chord = \"{chord} mm\"\n"
            )
        };
        format!("{HEAD}[[shaft]]\nratio = -1\n{}{}", one(40.0, 0.0), one(z, phase))
    };
    // 40 mm long each: side by side they touch.
    assert_eq!(codes(&text(80.0, 0.0, 0.0)), Vec::<&str>::new());
    assert_eq!(codes(&text(79.0, 0.0, 0.0)), ["W0902"]);
    // Opposite halves share nothing, more than halves do.
    assert_eq!(codes(&text(50.0, 180.0, 0.0)), Vec::<&str>::new());
    assert_eq!(codes(&text(50.0, 180.0, -5.0)), ["W0902"]);
    let told = read(&text(79.0, 0.0, 0.0)).diagnostics;
    assert_eq!(
        told[0].message,
        "weights 1 and 2 of one shaft overlap by 1 mm along it: what both have counts twice"
    );
    // A shaft of its own has nothing to do with it.
    let apart = text(79.0, 0.0, 0.0).replacen(
        "[[shaft.weights]]\nz = \"79",
        "[[shaft]]\nratio = 1\n[[shaft.weights]]\nz = \"79",
        1,
    );
    assert_eq!(codes(&apart), Vec::<&str>::new());
}

#[test]
fn shapes_to_search_have_their_defaults() {
    let section = "[shaft_weight_design]\ndensity = \"17.5 g/cm3\"\nshaft_diameter = \"24 mm\"\nradius = \"36 mm\"\n\
                   length = [\"10 mm\", \"6 cm\"]\n";
    let text = format!("{}{section}", shaft(HALF));
    let task = file(&text).tasks.shaft_weight_task.expect("a task");
    let expected = ShaftWeightTask {
        minimise: ShaftWeightAim::Mass,
        density: 17500.0,
        shaft_radius: 0.012,
        radius: Range::fixed(0.036),
        chord: Range::fixed(0.0),
        length: Range::new(0.01, 0.06),
    };
    assert_eq!(task, expected);
    let own = "minimise = \"inertia\"\nchord = [\"-10 mm\", \"8 mm\"]\n";
    let task = file(&format!("{text}{own}")).tasks.shaft_weight_task.expect("a task");
    let chord = Range::new(-0.01, 0.008);
    assert_eq!(task, ShaftWeightTask { minimise: ShaftWeightAim::Inertia, chord, ..expected });
    // Without any shaft they are for nothing.
    assert_eq!(codes(&format!("{HEAD}{section}")), ["W0204"]);
}

#[test]
fn a_weight_is_named_after_its_shaft() {
    let engine = engine(include_str!("../files/crank-as-body.toml"));
    assert_eq!(engine.shafts[0].weight_name(1), "left weight 2");
    assert_eq!(engine.shafts[1].weight_name(0), "shaft 2");
}

#[test]
fn the_schema_knows_them() {
    let schema = json_schema();
    let shape =
        &schema["properties"]["shaft"]["items"]["properties"]["weights"]["items"]["properties"]["shape"];
    assert_eq!(shape["required"][0], "shaft_diameter");
    assert_eq!(schema["properties"]["shaft_weight_design"]["required"][0], "density");
}

proptest! {
    /// Whatever is read is read again from its expanded form, to the last bit; the unbalance is that of the outline.
    #[test]
    fn prop_shaft_weights_read_back_to_the_last_bit(
        shaft_radius in 2.0_f64..30.0, beyond in 0.01_f64..60.0, share in 0.01_f64..0.99, by_angle in any::<bool>(),
        length in 0.5_f64..200.0, density in 1000.5_f64..22000.0, z in -300.0_f64..300.0, phase in -400.0_f64..400.0,
        wanted in prop::option::of(0.0_f64..0.1),
    ) {
        let radius = shaft_radius + beyond;
        let chord = -radius + share * (radius + shaft_radius);
        let chord = match by_angle {
            true => format!("half_angle = \"{} deg\"", (chord / radius).acos().to_degrees()),
            false => format!("chord = \"{chord} mm\""),
        };
        let wanted = wanted.map_or(String::new(), |wanted| format!("unbalance = \"{wanted} kg m\", "));
        let text = format!(
            "{HEAD}[[shaft]]\nratio = 2\nweights = [{{ z = \"{z} mm\", {wanted}phase = \"{phase} deg\", shape = {{ shaft_diameter = \
             \"{} mm\", radius = \"{radius} mm\", {chord}, length = \"{length} mm\", density = \"{density} kg/m3\" }} }}]\n",
            2.0 * shaft_radius
        );
        let reading = read(&text);
        let shown = render(&reading.diagnostics, "engine.toml", &text, false);
        let is_error = reading.diagnostics.iter().any(|d| d.severity == Severity::Error);
        prop_assert!(!is_error, "{shown}");
        let file = reading.file.expect("no error");
        let printed = expanded(&file);
        let again = read(&printed).file;
        prop_assert_eq!(again.as_ref(), Some(&file), "{}", printed);
        let engine = file.engine;
        let weight = &engine.shafts[0].weights[0];
        let moments = weight.part.expect("a part").part().expect("a shape").moments();
        // The outline holds the shaft too, whose moment is 0: rounding is of the size of mass times radius.
        let scale = moments.mass * radius * 1e-3;
        prop_assert!((moments.first[0] - weight.unbalance).abs() < 1e-12 * scale, "{} {}", moments.first[0], weight.unbalance);
        prop_assert!(moments.first[1].abs() < 1e-12 * scale);
    }
}
