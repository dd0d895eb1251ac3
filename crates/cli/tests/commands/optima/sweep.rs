//! The published sweep of the crank, on the command line.

use crate::program::{folder, message, output, output_json};
use std::fs;
use std::path::Path;

fn thesis(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation/twin-cylinder-thesis");
    folder.join(format!("{name}.toml")).display().to_string()
}

/// Engine of the longer stroke, what its crank is chosen for, unbalance of one half crank [kg m], largest load [N], [N m].
const SWEPT: [(&str, &str, f64, f64); 3] = [
    ("in-line-in-phase", "force", 0.04875, 11889.0),
    ("in-line-out-of-phase", "couple", 0.04353, 363.0),
    ("boxer-in-phase", "couple", 0.04875, 523.0),
];

/// Louvigny, Preliminary design of twin-cylinder engines (2008), Tables 17, 22 and 26, case 2.
#[test]
fn lit_louvigny_2008_swept_cranks() {
    let folder = folder("sweep-thesis");
    for (name, load, crank, printed) in SWEPT {
        let file = thesis(name);
        let found = output_json(
            &folder,
            0,
            &["balance", &file, "--method", "sweep", "--series", "power:4:5", "--format", "json"],
        );
        assert_eq!(found["sweep"]["load"], load, "{name}");
        let number = |value: &serde_json::Value| value.as_f64().unwrap();
        assert!((number(&found["best"]["unbalance"]) - crank).abs() < 1e-9, "{name} {}", found["best"]);
        let swept = found["sweep"]["steps"].as_array().unwrap();
        let least = swept.iter().map(|s| number(&s["criterion"])).fold(f64::INFINITY, f64::min);
        // Printed as whole numbers.
        assert!((least - printed).abs() <= 0.5, "{name} {least}");
        let optimum = number(&found["optimum"]["stages"][0]["value"]);
        let peak = number(&found["best"]["criterion"]);
        assert!(optimum <= peak && peak - optimum < 0.01 * peak, "{name} {optimum} {peak}");
    }
}

#[test]
fn the_sweep_comes_as_text_as_its_curve_and_as_a_figure() {
    let folder = folder("sweep-forms");
    let file = thesis("single");
    let text = output(&folder, 0, &["balance", &file, "--method", "sweep", "--figures", "."]);
    assert!(text.contains("above the true optimum") && text.contains("best step"), "{text}");
    let figure = fs::read_to_string(folder.join("crank-sweep.svg")).unwrap();
    assert!(figure.contains("near the optimum") && figure.contains("true optimum"));

    let sweep = ["balance", &file, "--method", "sweep", "--format", "csv"];
    let fine = output(&folder, 0, &sweep);
    let coarse = output(&folder, 0, &[&sweep[..], &["--step", "1e-4 kg m", "--grid", "36"]].concat());
    // A heading and the crank without counterweights come before the steps.
    let steps = |csv: &str| csv.lines().count() - 2;
    assert_eq!(steps(&fine).div_ceil(10), steps(&coarse));

    // The optimum of the same crank draws the same curve.
    fs::remove_file(folder.join("crank-sweep.svg")).unwrap();
    output(&folder, 0, &["balance", &file, "--minimise", "force", "--figures", "."]);
    assert!(folder.join("crank-sweep.svg").exists() && folder.join("optimum.svg").exists());
}

#[test]
fn options_of_the_other_method_are_refused() {
    let folder = folder("sweep-options");
    let file = thesis("single");
    for (options, expected) in [
        (&["--step", "1e-5 kg m"][..], "--method sweep"),
        (&["--method", "sweep", "--webs", "11"], "--webs"),
        (&["--method", "sweep", "--limit", "force = 1 N"], "--limit"),
        (&["--method", "sweep", "--minimise", "roll moment"], "force or couple"),
        (&["--method", "sweep", "--minimise", "force", "--minimise", "couple"], "one load"),
        (&["--method", "sweep", "--step", "0 kg m"], "positive"),
        (&["--method", "sweep", "--minimise", "couple"], "other load"),
    ] {
        let said = message(&folder, 2, &[&["balance", &file], options].concat());
        assert!(said.contains(expected), "{options:?}: {said}");
    }
}
