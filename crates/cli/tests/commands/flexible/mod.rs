//! `stress`: static cases, modes, exports, reduced models, decks, refusals.

mod cycle;
mod films;

use crate::program::{folder, lanchester, message, number, output, output_json};
use std::fs;
use std::path::PathBuf;

/// One throw with fillets, coarse enough for a test.
const ENGINE: &str = r#"
name = "single"
speed = ["1000 rpm", "4000 rpm"]
[layout]
type = "in-line"
cylinders = 1
spacing = "90 mm"
[crank]
stroke = "95.5 mm"
web_distance = "48 mm"
[crank.body]
density = "7850 kg/m3"
journal_diameter = "55 mm"
pin_diameter = "48 mm"
web_thickness = "20 mm"
web_radius = "40 mm"
pin_end_radius = "36 mm"
end_journals = ["25 mm", "25 mm"]
pin_fillet = "6 mm"
journal_fillet = "6 mm"
[crank.material]
preset = "42CrMo4 quenched and tempered"
[piston]
mass = "0.5 kg"
[rod]
length = "150 mm"
mass = "0.6 kg"
"#;

const COARSE: [&str; 4] = ["--size", "20 mm", "--fillet-elements", "2"];

fn engine(test: &str, change: impl Fn(&str) -> String) -> PathBuf {
    let folder = folder(test);
    fs::write(folder.join("engine.toml"), change(ENGINE)).unwrap();
    folder
}

fn words<'a>(rest: &[&'a str]) -> Vec<&'a str> {
    [&["stress", rest[0], "engine.toml"], &rest[1..], &COARSE].concat()
}

#[test]
fn fillets_of_the_built_in_cases_are_tabulated() {
    let folder = engine("stress-static", str::to_owned);
    let text = output(&folder, 0, &words(&["static"]));
    for words in [
        "static stress of crankshaft 1",
        "Largest fillet stress",
        "yield strength 650 MPa (typical value)",
        "journal 1 at web 1",
        "largest radial",
        "4000 rpm",
        "loads and reactions balance to",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let csv =
        output(&folder, 0, &words(&["static", "--angle", "0 deg", "--speed", "4000 rpm", "--format", "csv"]));
    // Four fillets, a pin, two journals, two webs.
    assert_eq!(csv.lines().count(), 1 + 9, "{csv}");
}

#[test]
fn forces_are_in_balance_and_stress_is_proportional_to_them() {
    let folder = engine("stress-force", str::to_owned);
    let of = |force: &str| {
        output_json(
            &folder,
            0,
            &words(&["static", "--support", "clamped-ends", "--force", force, "--format", "json"]),
        )
    };
    let [one, two] = [of("1: -20 kN, 5 kN"), of("1: -40 kN, 10 kN")];
    let at = |json: &serde_json::Value, key: &str| number(json, &format!("/cases/0/{key}"));
    // Throw 1 points along x, and the crankshaft turns from x to y.
    for (key, wanted) in [("load/0", -20e3), ("load/1", 5e3), ("reaction/0", 20e3), ("reaction/1", -5e3)] {
        assert!((at(&one, key) - wanted).abs() < 1e-4, "{key}: {}", at(&one, key));
    }
    for (key, factor) in
        [("energy", 4.0), ("result/largest_displacement", 2.0), ("result/peaks/1/stress/von_mises", 2.0)]
    {
        let ratio = at(&two, key) / at(&one, key);
        assert!((ratio / factor - 1.0).abs() < 1e-9, "{key}: {ratio}");
    }
}

#[test]
fn an_exported_deck_gives_the_same_numbers_when_it_is_solved() {
    let folder = engine("stress-deck", str::to_owned);
    let rest = ["--force", "1: -20 kN, 5 kN", "--speed", "4000 rpm"];
    let json = output_json(&folder, 0, &words(&[&["static"], &rest[..], &["--format", "json"]].concat()));
    output(&folder, 0, &words(&[&["export"], &rest[..], &["--output", "case.inp"]].concat()));
    output(&folder, 0, &words(&[&["export"], &rest[..], &["--output", "case.vtu"]].concat()));
    assert!(fs::read(folder.join("case.vtu")).unwrap().starts_with(b"<?xml"));
    let solved = output_json(
        &folder,
        0,
        &["stress", "solve", "case.inp", "--output", "again.vtu", "--format", "json"],
    );
    let [ours, theirs] = [number(&json, "/cases/0/energy"), number(&solved, "/steps/0/energy")];
    assert!((ours / theirs - 1.0).abs() < 1e-9, "{ours} {theirs}");
    let moved = [
        number(&json, "/cases/0/result/largest_displacement"),
        number(&solved, "/steps/0/largest_displacement/0"),
    ];
    assert!((moved[0] / moved[1] - 1.0).abs() < 1e-9, "{moved:?}");
    assert!(fs::read(folder.join("again.vtu")).unwrap().starts_with(b"<?xml"));
    let deck = fs::read_to_string(folder.join("case.inp")).unwrap().replace("*STATIC", "*DYNAMIC");
    fs::write(folder.join("bad.inp"), deck).unwrap();
    let words = message(&folder, 2, &["stress", "solve", "bad.inp"]);
    assert!(words.contains("unknown card *DYNAMIC") && words.contains("line "), "{words}");
}

#[test]
fn rings_say_how_they_touch() {
    let folder = engine("stress-rings", str::to_owned);
    let rest = ["static", "--force", "1: -20 kN", "--support", "rings", "--ring-thickness", "4 mm"];
    let text = output(&folder, 0, &words(&rest)).replace('\n', " ");
    for words in
        ["rings 4 mm thick of 210 GPa", "Contact: ", "of the rings' area touches", "outside of its ring"]
    {
        assert!(text.contains(words), "{words}: {text}");
    }
    let json = output_json(&folder, 0, &words(&[&rest[..], &["--format", "json"]].concat()));
    let closed = number(&json, "/cases/0/result/contact/closed");
    assert!(closed > 0.1 && closed < 0.9, "{closed}");
    output(&folder, 0, &words(&[&["export"], &rest[1..], &["--output", "rings.inp"]].concat()));
    let deck = fs::read_to_string(folder.join("rings.inp")).unwrap();
    // Two journals and a pin.
    assert_eq!(deck.matches("*CONTACT PAIR").count(), 3);
    let [load, reaction] = ["load", "reaction"].map(|key| number(&json, &format!("/cases/0/{key}/0")));
    assert!((load + reaction).abs() < 0.01, "{load} {reaction}");
}

/// Springs far softer than the crankshaft take F^2/(2 k) of a force along each of two directions.
#[test]
fn springs_have_a_stiffness_for_each_journal_and_direction() {
    let folder = engine("stress-springs", str::to_owned);
    let energy = |angle: &str| {
        let rest = ["static", "--force", "1: -10 kN", "--support", "springs", "--stiffness"];
        let stiffness = "1 kN/mm : 4 kN/mm, 1 kN/mm : 4 kN/mm";
        let rest = [&rest[..], &[stiffness, "--angle", angle, "--format", "json"]].concat();
        let json = output_json(&folder, 0, &words(&rest));
        let support = json["support"].as_str().unwrap();
        assert!(support.contains("1 1 and 4, 2 1 and 4"), "{support}");
        number(&json, "/cases/0/energy")
    };
    // The force is along the throw, which is along x of the block at 0 deg and along y at 90 deg.
    for (angle, stiffness) in [("0 deg", 2e6), ("90 deg", 8e6)] {
        let ratio = energy(angle) / (1e4 * 1e4 / (2.0 * stiffness));
        assert!((1.0..1.05).contains(&ratio), "{angle}: {ratio}");
    }
}

/// Cases of the file, and the fineness that it asks for.
const CASES: &str = r#"
[crank.mesh]
size = "20 mm"
fillet_elements = 2
[[stress.case]]
name = "unit radial"
pin = 1
radial = "-10 kN"
support = "clamped-ends"
[[stress.case]]
name = "In springs"
pin = 1
radial = "-10 kN"
tangential = "2 kN"
speed = "3000 rpm"
angle = "30 deg"
support = "springs"
stiffness = [{ x = "5 N/um", y = "8 N/um" }]
[[stress.case]]
name = "at 7 deg"
angle = "7 deg"
speed = "4000 rpm"
"#;

#[test]
fn static_cases_of_the_file_are_solved_by_name() {
    let folder = engine("stress-case", |text| text.replace("[piston]", &format!("{CASES}[piston]")));
    let json = |rest: &[&str]| {
        let all = [&["stress", "static", "engine.toml"], rest, &["--format", "json"]].concat();
        output_json(&folder, 0, &all)
    };
    // The same by options.
    let radial = ["--force", "1: -10 kN", "--support", "clamped-ends"];
    let springs =
        ["--force", "1: -10 kN, 2 kN", "--speed", "3000 rpm", "--angle", "30 deg", "--support", "springs"];
    let springs = [&springs[..], &["--stiffness", "5 kN/mm : 8 kN/mm"]].concat();
    let angle = ["--angle", "7 deg", "--speed", "4000 rpm"];
    for (name, options) in [("UNIT radial", &radial[..]), ("In springs", &springs), ("at 7 deg", &angle)] {
        let (case, own) = (json(&["--case", name]), json(options));
        for key in ["energy", "result/largest_displacement", "result/peaks/1/stress/von_mises"] {
            let of = |json: &serde_json::Value| number(json, &format!("/cases/0/{key}"));
            assert_eq!(of(&case), of(&own), "{name}: {key}");
        }
        assert_eq!(case["support"], own["support"], "{name}");
        let told = case["cases"][0]["name"].as_str().unwrap();
        assert!(told.to_lowercase().starts_with(&format!("{}: ", name.to_lowercase())), "{told}");
    }
    // Who says how fine the mesh is.
    let text =
        output(&folder, 0, &["stress", "static", "engine.toml", "--case", "unit radial"]).replace('\n', " ");
    assert!(text.contains("size of the elements as [crank.mesh] of the engine file says"), "{text}");
    let asked = ["stress", "static", "engine.toml", "--case", "unit radial", "--size", "25 mm"];
    let text = output(&folder, 0, &asked).replace('\n', " ");
    assert!(text.contains("size of the elements as asked for, before that of [crank.mesh]"), "{text}");
    let fine = json(&["--case", "unit radial", "--fillet-elements", "4"]);
    assert_eq!(fine["sheet"]["origins"]["fillet_elements"], "asked-before-file");
    assert_eq!(number(&fine, "/sheet/options/fillet_elements"), 4.0);
    // A deck of the case has its support.
    output(&folder, 0, &["stress", "export", "engine.toml", "--case", "unit radial", "--output", "case.inp"]);
    let solved = output_json(&folder, 0, &["stress", "solve", "case.inp", "--format", "json"]);
    let ratio =
        number(&solved, "/steps/0/energy") / number(&json(&["--case", "unit radial"]), "/cases/0/energy");
    assert!((ratio - 1.0).abs() < 1e-6, "{ratio}");
    // The file as the program shows it has them.
    let shown = output(&folder, 0, &["show", "engine.toml"]);
    assert!(shown.contains("[[stress.case]]") && shown.contains("[crank.mesh]"), "{shown}");
    for (rest, wanted) in [
        (&["--case", "radial"][..], "the file has \"unit radial\", \"In springs\", \"at 7 deg\""),
        (&["--case", "unit radial", "--angle", "7 deg"], "cannot be used with"),
    ] {
        let said = message(&folder, 2, &[&["stress", "static", "engine.toml"], rest].concat());
        assert!(said.contains(wanted), "{rest:?}: {said}");
    }
    let bare = engine("stress-no-case", str::to_owned);
    let said = message(&bare, 2, &words(&["static", "--case", "unit radial"]));
    assert!(said.contains("the file has none") && said.contains("[[stress.case]]"), "{said}");
}

#[test]
fn a_mesh_of_its_own_takes_the_place_of_the_body() {
    let folder = engine("stress-own-mesh", |text| {
        text.replace(
            "[piston]",
            &format!(
                "{}[piston]",
                CASES.replace("size = \"20 mm\"\nfillet_elements = 2", "file = \"crank.inp\"")
            ),
        )
    });
    let case = ["stress", "static", "engine.toml", "--case", "unit radial"];
    let missing = message(&folder, 2, &case);
    assert!(missing.contains("crank.inp") && missing.contains("[crank.mesh] names it"), "{missing}");
    // The program's own mesh stands for one from elsewhere: a size that is asked for meshes the body.
    let mesh =
        [&["stress", "export", "engine.toml"][..], &COARSE, &["--modes", "1", "--output", "crank.inp"]]
            .concat();
    output(&folder, 0, &mesh);
    let own = output_json(&folder, 0, &[&case[..], &["--format", "json"]].concat());
    let body = output_json(&folder, 0, &[&case[..], &COARSE, &["--format", "json"]].concat());
    let ratio = number(&own, "/cases/0/energy") / number(&body, "/cases/0/energy");
    assert!((ratio - 1.0).abs() < 1e-8, "{ratio}");
    assert_eq!(own["sheet"]["own_file"], "crank.inp");
    assert!(body["sheet"]["own_file"].is_null());
    assert_eq!(body["sheet"]["origins"]["size"], "asked-before-file");
    let text = output(&folder, 0, &case).replace('\n', " ");
    for part in [
        "from crank.inp",
        "of [crank.body] with nose and flange",
        "Largest stress",
        "surface outside of the sets",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let modes = output_json(&folder, 0, &["stress", "modes", "engine.toml", "-n", "2", "--format", "json"]);
    assert!(number(&modes, "/modes/modes/0/frequency") > 100.0);
    let converge = message(&folder, 2, &[&case[..], &["--converge"]].concat());
    assert!(converge.contains("meshes of three sizes") && converge.contains("hint:"), "{converge}");
    let text = fs::read_to_string(folder.join("crank.inp")).unwrap();
    fs::write(folder.join("crank.inp"), text.replace("NSET=PIN_1", "NSET=PIN")).unwrap();
    let said = message(&folder, 2, &case);
    assert!(said.contains("crank.inp: the mesh does not fit the engine: the set PIN_1 is missing"), "{said}");
    fs::write(folder.join("crank.inp"), text.replace("*STEP", "*STEP\n*DYNAMIC")).unwrap();
    let said = message(&folder, 2, &case);
    assert!(said.contains("crank.inp: line ") && said.contains("unknown card *DYNAMIC"), "{said}");
}

#[test]
fn three_meshes_give_a_band() {
    // The finest mesh has half as many nodes as with fillets of 6 mm.
    let folder = engine("stress-converge", |text| text.replace("fillet = \"6 mm\"", "fillet = \"8 mm\""));
    let size = ["--size", "40 mm", "--fillet-elements", "2"];
    let rest = ["--force", "1: -20 kN", "--converge", "--figures", "pictures", "--format", "json"];
    let json = output_json(&folder, 0, &[&["stress", "static", "engine.toml"], &size[..], &rest].concat());
    let picture = fs::read_to_string(folder.join("pictures/stress-contours.svg")).unwrap();
    assert!(picture.contains("<path style=\"fill:#") && picture.contains("MPa"));
    let numbers = json["convergence"]["numbers"].as_array().unwrap();
    assert_eq!(numbers.len(), 2 + 4);
    let energy = &numbers[1]["found"];
    // The fine mesh is softer, and the band about what the meshes tend to holds it.
    let values: Vec<f64> = (0..3).map(|k| number(energy, &format!("/values/{k}"))).collect();
    assert!(values[0] < values[2], "{values:?}");
    let [value, band] = ["/value", "/band"].map(|key| number(energy, key));
    assert!((value - values[2]).abs() <= band && band < 0.05 * value, "{value} {band} {values:?}");
    assert_eq!(number(&json, "/cases/0/energy"), values[2]);
}

/// Crank angles one after another as a series for ParaView.
#[test]
fn angles_of_the_cycle_are_a_series() {
    let folder = engine("stress-series", str::to_owned);
    let angles = ["--angle", "0 deg .. 20 deg by 10 deg", "--speed", "4000 rpm", "--output", "out/cycle.pvd"];
    output(&folder, 0, &words(&[&["export"], &angles[..]].concat()));
    let list = fs::read_to_string(folder.join("out/cycle.pvd")).unwrap();
    for (k, angle) in ["0", "10", "20"].into_iter().enumerate() {
        let name = format!("cycle-{:03}.vtu", k + 1);
        assert!(
            list.contains(&format!("timestep=\"{angle}\" group=\"\" part=\"0\" file=\"{name}\"")),
            "{list}"
        );
        let field = fs::read(folder.join("out").join(&name)).unwrap();
        assert!(String::from_utf8_lossy(&field[..600]).contains("von Mises"), "{name}");
    }
    // The second case is that angle asked for alone.
    let json = |angle: &str| {
        output_json(
            &folder,
            0,
            &words(&["static", "--angle", angle, "--speed", "4000 rpm", "--format", "json"]),
        )
    };
    let [some, one] = ["0 deg, 10 deg", "10 deg"].map(json);
    assert_eq!(some["cases"].as_array().unwrap().len(), 2);
    let [here, alone] = [number(&some, "/cases/1/energy"), number(&one, "/cases/0/energy")];
    assert!((here / alone - 1.0).abs() < 1e-9, "{here} {alone}");
    for (rest, wanted) in [
        (&["export", "--modes", "2", "--output", "modes.pvd"][..], "a .pvd file load cases"),
        (&["static", "--angle", "0 deg .. 720 deg by 1 deg"], "721 crank angles"),
        (&["static", "--angle", "7 deg, x"], "--angle"),
    ] {
        let said = message(&folder, 2, &words(rest));
        assert!(said.contains(wanted), "{wanted} in {said}");
    }
}

#[test]
fn shapes_for_viewers_are_written() {
    let folder = engine("stress-shapes", str::to_owned);
    let force = ["--force", "1: -20 kN"];
    output(&folder, 0, &words(&[&["export"], &force[..], &["--output", "case.glb"]].concat()));
    output(
        &folder,
        0,
        &words(&[&["export"], &force[..], &["--output", "case.stl", "--deformation", "100"]].concat()),
    );
    output(&folder, 0, &words(&["export", "--modes", "2", "--output", "modes.glb"]));
    for (name, wanted) in [("case.glb", "deformation x "), ("modes.glb", "mode 2 ")] {
        let bytes = fs::read(folder.join(name)).unwrap();
        assert!(bytes.starts_with(b"glTF"), "{name}");
        assert!(String::from_utf8_lossy(&bytes).contains(wanted), "{name}");
    }
    let stl = fs::read(folder.join("case.stl")).unwrap();
    let count = u32::from_le_bytes(stl[80..84].try_into().unwrap()) as usize;
    assert!(count > 1000 && stl.len() == 84 + 50 * count);
}

#[test]
fn modes_and_a_reduced_model_agree_where_both_are_right() {
    let folder = engine("stress-modes", str::to_owned);
    let modes = output_json(&folder, 0, &words(&["modes", "-n", "4", "--format", "json"]));
    let reduced = output_json(&folder, 0, &words(&["reduce", "--output", "crank.npz", "--format", "json"]));
    assert!(fs::read(folder.join("crank.npz")).unwrap().starts_with(b"PK"));
    assert!(number(&reduced, "/mass_error").abs() < 1e-9 && number(&reduced, "/residual") < 1e-9);
    for k in 0..4 {
        let full = number(&modes, &format!("/modes/modes/{k}/frequency"));
        let own = number(&reduced, &format!("/frequencies/{k}/0"));
        // Rigid bearing surfaces stiffen: never below the full model.
        assert!(own > 0.999_99 * full && own < 1.5 * full, "mode {k}: {own} {full}");
    }
    let text = output(&folder, 0, &words(&["modes", "-n", "2"]));
    assert!(text.contains("Natural modes") && text.contains("six rigid motions"), "{text}");
}

#[test]
fn what_cannot_be_computed_is_refused() {
    let folder = engine("stress-refused", str::to_owned);
    for (rest, wanted) in [
        (&["static", "--force", "2: 1 kN"][..], "pin 2 is needed"),
        (&["static", "--force", "1 kN"], "--force needs a pin"),
        (&["static", "--force", "1: 1 mm"], "--force"),
        (&["static", "--crankshaft", "2"], "crankshaft 2 is needed"),
        (&["static", "--memory", "1 MB"], "allow more memory"),
        (&["static", "--memory", "much"], "--memory needs a size"),
        (&["static", "--stiffness", "1 kN/mm"], "--support springs"),
        (&["static", "--support", "springs", "--stiffness", "1 kN/mm : 1 mm"], "--stiffness"),
        (
            &["static", "--support", "springs", "--stiffness", "1 kN/mm, 2 kN/mm, 3 kN/mm"],
            "1 for all journals, or 2",
        ),
        (&["static", "--force", "1: 1 kN", "--angle", "7 deg"], "--angle beside --force has no effect"),
        (&["fatigue", "--support", "springs", "--stiffness", "1 kN/mm : 2 kN/mm"], "at every crank angle"),
        (&["modes", "--fillet-elements", "3"], "an even number"),
        (&["export", "--output", "case.stp"], ".inp, .vtu, .pvd, .glb or .stl"),
        (&["export", "--output", "case.inp", "--deformation", "10"], ".glb and .stl"),
        (&["export", "--modes", "2", "--output", "modes.stl"], "one shape"),
        (&["modes", "--support", "rings"], "needs a support that is linear"),
        (&["static", "--ring-thickness", "5 mm"], "--support rings"),
        (&["static", "--support", "rings", "--ring-modulus", "5 mm"], "--ring-modulus"),
        (&["reduce", "--output", "case.zip"], ".npz"),
    ] {
        let mut all = vec!["stress", rest[0], "engine.toml", "--size", "20 mm"];
        all.extend(&rest[1..]);
        let words = message(&folder, 2, &all);
        assert!(words.contains(wanted) && words.contains("hint:"), "{rest:?}: {words}");
    }
    // A sharp corner's stress is refused, and a crankshaft of sharp corners altogether.
    let sharp = engine("stress-sharp", |text| text.replace("pin_fillet = \"6 mm\"\n", ""));
    let text = output(&sharp, 0, &words(&["static", "--force", "1: -20 kN"]));
    assert!(text.contains("pin 1 at web 1 (sharp: stress unbounded)"), "{text}");
    let sharp = engine("stress-sharper", |text| {
        text.replace("pin_fillet = \"6 mm\"\njournal_fillet = \"6 mm\"\n", "")
    });
    let refused = message(&sharp, 2, &words(&["static", "--force", "1: -20 kN"]));
    assert!(refused.contains("sharp corner") && refused.contains("pin_fillet"), "{refused}");
    let bare = engine("stress-bare", |text| text.replace("[crank.material]\npreset", "#preset"));
    let text = output(&bare, 0, &words(&["static", "--force", "1: -20 kN"]));
    let text = text.replace('\n', " ");
    assert!(text.contains("no yield strength, so no safety"), "{text}");
}

/// `stress rule` of the engine above with another end.
fn rule(folder: &std::path::Path, status: i32, rest: &[&str]) -> String {
    output(folder, status, &[&["stress", "rule", "engine.toml"], rest].concat())
}

#[test]
fn the_sheet_of_the_class_rule_has_every_number() {
    let folder = engine("stress-rule", str::to_owned);
    let text = rule(&folder, 0, &["--torsional-vibration", "100 N m"]);
    for words in [
        "strength of crankshaft 1",
        "Formulas after UR M53, not compared with the printed rule.",
        "tensile strength 900 MPa (typical value)",
        "K = 1 (assumed)",
        "pin 1 at web 2",
        "journal 2 at web 2",
        "Nominal alternating stresses",
        "Parts of beta_Q",
        "plus the amplitude of torsional vibration",
    ] {
        assert!(text.contains(words), "{words} is missing in\n{text}");
    }
    let json = output_json(
        &folder,
        0,
        &["stress", "rule", "engine.toml", "--format", "json", "--speed", "4000 rpm"],
    );
    let web = &json["speeds"][0]["throws"][0]["webs"][0];
    let safety = number(web, "/pin_fillet/strength") / number(web, "/pin_fillet/equivalent");
    assert!((number(web, "/pin_fillet/safety") - safety).abs() < 1e-12);
    let csv = rule(&folder, 0, &["--format", "csv"]);
    assert_eq!(csv.lines().count(), 1 + 2 * 4, "{csv}");
}

#[test]
fn a_safety_below_the_rule_and_a_size_outside_its_range_are_status_1() {
    let folder = engine("stress-rule-limits", str::to_owned);
    let weak = rule(&folder, 1, &["--torsional-vibration", "4 kN m"]);
    assert!(weak.contains("below the 1.15 of the rule") && weak.contains("below the rule"), "{weak}");
    let folder =
        engine("stress-rule-range", |text| text.replace("pin_fillet = \"6 mm\"", "pin_fillet = \"1 mm\""));
    let outside = rule(&folder, 1, &[]);
    for words in [
        "Web 1: r = R_H/D = 0.0208 is below the range 0.03 to 0.13 by 0.0092",
        "not judged",
        "No place has a safety",
    ] {
        assert!(outside.contains(words), "{words} is missing in\n{outside}");
    }
}

#[test]
fn a_sheet_names_all_that_it_lacks() {
    let folder = engine("stress-rule-lacks", |text| {
        text.replace("journal_fillet = \"6 mm\"", "")
            .replace("preset = \"42CrMo4 quenched and tempered\"", "")
    });
    let words = message(&folder, 2, &["stress", "rule", "engine.toml"]);
    for part in [
        "material: the tensile strength is needed",
        "journal 1: a fillet radius above 0 is needed",
        "journal 2:",
    ] {
        assert!(words.contains(part), "{part} is missing in\n{words}");
    }
    let folder = engine("stress-rule-vibration", str::to_owned);
    let words =
        message(&folder, 2, &["stress", "rule", "engine.toml", "--torsional-vibration", "1 N m, 2 N m"]);
    assert!(words.contains("one for each of 1 throws, got 2"), "{words}");
}

#[test]
fn modes_are_written_without_loads() {
    let folder = engine("stress-modes-loads", str::to_owned);
    for load in [
        &["--loads", "simulation"][..],
        &["--pin-pressure", "uniform"],
        &["--speed", "4000 rpm"],
        &["--case", "unit"],
        &["--inertia-only"],
    ] {
        let line = ["stress", "export", "engine.toml", "--modes", "2", "--output", "modes.vtu"];
        let said = message(&folder, 2, &[&line[..], load].concat());
        assert!(said.contains("cannot be used with") && said.contains(load[0]), "{load:?}: {said}");
    }
}

#[test]
fn pressure_on_a_pin_is_even_on_request() {
    let folder = engine("stress-pressure", str::to_owned);
    let found = |more: &[&str]| {
        let rest = [&["static", "--force", "1: -20 kN, 5 kN", "--format", "json"], more].concat();
        output_json(&folder, 0, &words(&rest))
    };
    let [cosine, even] = [found(&[]), found(&["--pin-pressure", "uniform"])];
    let note = |json: &serde_json::Value| json.pointer("/notes/0").unwrap().as_str().unwrap().to_owned();
    assert!(note(&cosine).contains("p0 cos(a)") && note(&even).contains("an even pressure"));
    assert_eq!(even.pointer("/cases/0/loading/pressure").unwrap(), "uniform");
    // The same force, nearly the same bending, and another deformation of the pin.
    for axis in 0..3 {
        let load = |json: &serde_json::Value| number(json, &format!("/cases/0/load/{axis}"));
        assert!((load(&even) - load(&cosine)).abs() < 1e-6, "N");
    }
    let ratio = number(&even, "/cases/0/energy") / number(&cosine, "/cases/0/energy");
    assert!((ratio - 1.0).abs() < 0.05 && (ratio - 1.0).abs() > 1e-4, "{ratio}");
}

#[test]
fn fatigue_of_the_fillets_is_tabulated() {
    let folder = engine("stress-fatigue", str::to_owned);
    let rest = ["fatigue", "--speed", "4000 rpm", "--instants", "24"];
    let text = output(&folder, 0, &words(&rest));
    for words in [
        "fatigue of crankshaft 1",
        "Least safety against fatigue",
        "bending 405 MPa (assumed)",
        "surface off",
        "gradient off",
        "pin 1 at web 2",
        "Fatigue of fillets at 4000 rpm",
    ] {
        assert!(text.contains(words), "{words} is missing in\n{text}");
    }
    // A factor lowers every safety by itself.
    let json =
        |more: &[&str]| output_json(&folder, 0, &[&words(&rest)[..], &["--format", "json"], more].concat());
    let safety = |found: &serde_json::Value| number(found, "/speeds/0/fillets/0/point/safety_of_all");
    let [polished, rough] = [json(&[]), json(&["--surface-factor", "0.8"])].map(|found| safety(&found));
    assert!((rough / polished - 0.8).abs() < 1e-12, "{rough} {polished}");
    let weak = lanchester(&folder, &[&words(&rest)[..], &["--safety", "1000"]].concat());
    let said = String::from_utf8(weak.stderr).unwrap();
    assert_eq!(weak.status.code(), Some(1), "{said}");
    assert!(said.contains(" at web 2 (4000 rpm) is "), "{said}");
}

#[test]
fn fatigue_without_strength_is_refused() {
    let folder =
        engine("stress-fatigue-lacks", |text| text.replace("preset = \"42CrMo4 quenched and tempered\"", ""));
    let words = message(&folder, 2, &words(&["fatigue"]));
    assert!(words.contains("fatigue_bending"), "{words}");
}

#[test]
fn throw_is_solved_again_on_a_finer_mesh() {
    let folder = engine("stress-submodel", str::to_owned);
    let case = ["static", "--force", "1: -20 kN, 5 kN"];
    let finer = ["--submodel", "1", "--submodel-elements", "4", "--format", "csv"];
    let text = output(&folder, 0, &words(&[&case[..], &finer].concat()));
    let stress = |place: &str| -> f64 {
        let row = text.lines().find(|line| line.split(',').any(|cell| cell == place));
        let row = row.unwrap_or_else(|| panic!("no {place} in {text}"));
        // The case has commas of its own; the stress stands behind the place and the radius.
        let cells: Vec<&str> = row.split(',').collect();
        let at = cells.iter().position(|cell| *cell == place).unwrap();
        cells[at + 2].parse().unwrap()
    };
    for fillet in ["journal 1 at web 1", "pin 1 at web 1", "pin 1 at web 2", "journal 2 at web 2"] {
        let ratio = stress(&format!("{fillet} (submodel)")) / stress(fillet);
        assert!((1.05..1.35).contains(&ratio), "{fillet}: {ratio}");
    }
    let refused = |more: &[&str], wanted: &str| {
        let said = message(&folder, 2, &words(&[&case[..], more].concat()));
        assert!(said.contains(wanted), "{wanted} in {said}");
    };
    refused(&["--submodel", "2"], "crankpin 2 is needed");
    refused(&["--submodel", "1", "--submodel-elements", "2"], "which has 2; got 2");
    refused(&["--submodel", "1", "--support", "free"], "balanced by its inertia");
    refused(&["--submodel", "1", "--support", "rings"], "support that is linear");
    refused(&["--submodel-elements", "4"], "--submodel");
}
