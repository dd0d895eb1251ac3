//! Weights of balance shafts as real parts, on the command line.

use crate::program::{examples, folder, message, output, output_json};
use std::fs;
use std::path::{Path, PathBuf};

fn four() -> String {
    fs::read_to_string(examples().join("in-line-4-shafts.toml")).unwrap()
}

/// A folder with the example in it, changed.
fn with_file(test: &str, change: impl Fn(String) -> String) -> PathBuf {
    let folder = folder(test);
    fs::write(folder.join("four.toml"), change(four())).unwrap();
    folder
}

const DESIGN: [&str; 3] = ["counterweight", "design", "four.toml"];

fn design(folder: &Path, status: i32, more: &[&str]) -> String {
    output(folder, status, &[&DESIGN[..], more].concat())
}

/// The story of the guide: from the file to STEP in two commands, and the loads are those of the shapes.
#[test]
fn from_the_file_to_step_in_two_commands() {
    let folder = with_file("shaft-weights-story", |text| text);
    let text = design(&folder, 0, &[]);
    assert!(text.contains("with the crank, against the crank: the least mass"), "{text}");
    let loads = || output_json(&folder, 0, &["loads", "four.toml", "--format", "json"]);
    let before = loads();
    design(&folder, 0, &["--write"]);
    let written = fs::read_to_string(folder.join("four.toml")).unwrap();
    assert_eq!(written.matches("shape = {").count(), 4);
    // Nothing else has changed.
    let lines = |text: &str| -> Vec<String> {
        text.lines().filter(|line| !line.contains("{ z = ")).map(str::to_owned).collect()
    };
    assert_eq!(lines(&written), lines(&four()));
    let after = loads();
    let couple =
        |loads: &serde_json::Value| loads["total"]["peaks"]["couple"]["max"]["value"].as_f64().unwrap();
    let force =
        |loads: &serde_json::Value| loads["total"]["peaks"]["force"]["max"]["value"].as_f64().unwrap();
    assert!((force(&before) - force(&after)).abs() < 1e-8 * force(&before));
    assert!((couple(&before) - couple(&after)).abs() < 1e-8 * couple(&before).max(1.0));

    let checked = output_json(&folder, 0, &["counterweight", "check", "four.toml", "--format", "json"]);
    let weights = checked["shaft_weights"].as_array().unwrap();
    assert_eq!((weights.len(), checked["swept_overlaps"].as_array().unwrap().len()), (4, 0));
    for weight in weights {
        assert!((weight["unbalance"].as_f64().unwrap() / 2.1885e-3 - 1.0).abs() < 1e-9, "{weight}");
        assert!(weight["radius"].as_f64().unwrap() <= 0.028, "{weight}");
    }
    let csv = ["counterweight", "check", "four.toml", "--format", "csv", "--table", "shaft-weights"];
    assert_eq!(output(&folder, 0, &csv).lines().count(), 5);

    output(&folder, 0, &["counterweight", "check", "four.toml", "--figures", "figures"]);
    // All four have one shape: one drawing.
    assert_eq!(fs::read_dir(folder.join("figures")).unwrap().count(), 1);
    let drawing = folder.join("figures/shaft-weight-with-the-crank-weight-1.svg");
    let drawing = fs::read_to_string(drawing).unwrap();
    assert!(drawing.contains("Likewise: with the crank weight 2"), "{drawing}");
    assert!(drawing.contains("Ø ") && drawing.contains("R 28"), "{drawing}");

    output(&folder, 0, &["counterweight", "export", "four.toml", "--output", "shafts.step"]);
    let step = fs::read_to_string(folder.join("shafts.step")).unwrap();
    // Two weights and the bar between them, for each shaft.
    assert!(step.matches("MANIFOLD_SOLID_BREP").count() == 6 && step.contains("'against the crank bar'"));
    for ending in ["stl", "glb"] {
        let file = format!("one.{ending}");
        let one = ["counterweight", "export", "four.toml", "--shaft", "with the crank", "--output", &file];
        output(&folder, 0, &one);
        assert!(fs::metadata(folder.join(file)).unwrap().len() > 1000);
    }
    // A second design finds the same shapes again.
    design(&folder, 0, &["--write"]);
    assert_eq!(fs::read_to_string(folder.join("four.toml")).unwrap(), written);
}

#[test]
fn what_cannot_be_met_is_told_with_the_nearest_values() {
    let folder = with_file("shaft-weights-infeasible", |text| {
        text.replace("radius = [\"20 mm\", \"28 mm\"]", "radius = [\"14 mm\", \"20 mm\"]")
    });
    let text = design(&folder, 1, &[]);
    assert!(text.contains("No weight has the unbalance") && text.contains("radius, at most"), "{text}");
    // The nearest radius is one that can be met.
    let found = output_json(&folder, 1, &[&DESIGN[..], &["--format", "json"]].concat());
    let nearest = &found["shaft_weights"]["weights"][0]["outcome"]["nearest"][0];
    assert_eq!(nearest["limit"], "largest-radius");
    let radius = nearest["nearest"].as_f64().unwrap();
    for (factor, status) in [(1.0 + 1e-9, 0), (1.0 - 1e-6, 1)] {
        let range = format!("radius = [\"14 mm\", \"{} m\"]", radius * factor);
        let text = four().replace("radius = [\"20 mm\", \"28 mm\"]", &range);
        fs::write(folder.join("four.toml"), text).unwrap();
        design(&folder, status, &[]);
    }
}

#[test]
fn a_fixed_shape_stays_and_one_weight_can_be_named() {
    let shape = "shape = { shaft_diameter = \"24 mm\", radius = \"30 mm\", length = \"20 mm\", density = \"7850 kg/m3\" }";
    let folder = with_file("shaft-weights-fixed", |text| {
        text.replacen("z = \"-30 mm\", unbalance = \"2.1885 kg mm\"", &format!("z = \"-30 mm\", {shape}"), 1)
    });
    let text = design(&folder, 0, &[]);
    assert!(text.contains("with the crank weight 2, against the crank: the least mass"), "{text}");
    let text = design(&folder, 0, &["--weight", "against the crank weight 1"]);
    assert!(text.contains("\nagainst the crank weight 1: the least"), "{text}");
    let told = message(
        &folder,
        2,
        &[&DESIGN[..], &["--weight", "against the crank", "--density", "1 g/cm3"]].concat(),
    );
    assert!(told.contains("[shaft_weight_design]"), "{told}");
    // Every weight fixed: nothing is left to design.
    let bare = four().replace("unbalance = \"2.1885 kg mm\"", shape);
    fs::write(folder.join("four.toml"), bare.clone()).unwrap();
    let told = message(&folder, 2, &DESIGN);
    assert!(told.contains("no weight of a balance shaft is to be designed"), "{told}");
    // Without the section a named weight needs it.
    let (without, _) = bare.split_once("# Among these shapes").unwrap();
    fs::write(folder.join("four.toml"), without).unwrap();
    let told = message(&folder, 2, &[&DESIGN[..], &["--weight", "with the crank"]].concat());
    assert!(told.contains("add a section like"), "{told}");
}

#[test]
fn swept_circles_that_overlap_are_a_warning() {
    let folder = with_file("shaft-weights-overlap", |text| {
        text.replace("y = \"45 mm\"", "y = \"20 mm\"").replace("y = \"-45 mm\"", "y = \"-20 mm\"")
    });
    design(&folder, 0, &["--write"]);
    let text = output(&folder, 0, &["counterweight", "check", "four.toml"]);
    assert!(
        text.contains(
            "swept circles of with the crank weight 1 and against the crank weight 1 overlap by 16.00 mm"
        ),
        "{text}"
    );
    let told = message(
        &folder,
        2,
        &["counterweight", "export", "four.toml", "--shaft", "left", "--output", "x.stl"],
    );
    assert!(told.contains("\"with the crank\", \"against the crank\""), "{told}");
}

/// What balancing finds is told as parts too, by the shapes that `counterweight design` gives them.
#[test]
fn found_weights_have_a_true_mass() {
    let balance = "[balance]\nminimise = [\"force\", \"added mass\"]\n[[balance.shaft]]\nname = \"with\"\nratio = 2\nx = \"-75 mm\"\n\
                   y = \"45 mm\"\nweights = [{ z = \"0 mm\", radius = \"15 mm\" }]\n[[balance.shaft]]\nname = \"against\"\nratio = -2\n\
                   x = \"-75 mm\"\ny = \"-45 mm\"\nweights = [{ z = \"0 mm\", radius = \"15 mm\" }]\n";
    let folder = with_file("shaft-weights-balance", |text| {
        let (head, rest) = text.split_once("[[shaft]]").unwrap();
        let (_, task) = rest.split_once("# Among these shapes").unwrap();
        let task = task.replace("\"40 mm\"]", "\"60 mm\"]");
        format!("{head}{balance}# Among these shapes{task}")
    });
    let ask = ["balance", "four.toml"];
    let found = output_json(&folder, 0, &[&ask[..], &["--format", "json"]].concat());
    let parts = found["as_parts"].as_array().unwrap();
    assert_eq!((parts.len(), &parts[0]["name"]), (2, &"with".into()));
    let text = output(&folder, 0, &ask);
    assert!(text.contains("The weights as parts") && text.contains("at its radius"), "{text}");
    output(&folder, 0, &[&ask[..], &["--write"]].concat());
    let designed = output_json(&folder, 0, &[&DESIGN[..], &["--format", "json"]].concat());
    for (part, weight) in parts.iter().zip(designed["shaft_weights"]["weights"].as_array().unwrap()) {
        assert_eq!(part["name"], weight["name"]);
        let number = |value: &serde_json::Value| value.as_f64().unwrap();
        assert!((number(&part["mass"]) / number(&weight["outcome"]["mass"]) - 1.0).abs() < 1e-9);
        assert!((number(&part["at_radius"]) * 0.015 / number(&part["unbalance"]) - 1.0).abs() < 1e-9);
    }
}
