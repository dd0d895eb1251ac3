//! `lanchester torsion`.

use crate::program::{folder, message, output};
use std::path::Path;

const SIX: &str = include_str!("../../../../examples/in-line-6-torsion.toml");
/// Few speeds: what is tested is the command.
const FEW: [&str; 2] = ["--speeds", "600 rpm .. 2600 rpm by 200 rpm"];

fn six(folder: &Path, text: &str) {
    std::fs::write(folder.join("six.toml"), text).expect("a file");
}

fn asked<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&["torsion", "six.toml"], &FEW[..], more].concat()
}

#[test]
fn text_figures_tables_and_limits() {
    let folder = folder("torsion");
    six(&folder, SIX);
    let text = output(&folder, 0, &asked(&["--tune", "damper", "--figures", "figures"]));
    for part in [
        "first natural frequency",
        "Critical speeds",
        "throw 6 to flywheel",
        "Best setting of the damper",
        "Limit of the twist",
    ] {
        assert!(text.contains(part), "{part} is missing in {text}");
    }
    for figure in [
        "torsion-campbell",
        "torsion-twist",
        "torsion-stress",
        "torsion-modes",
        "torsion-damper",
        "torsion-tuning",
    ] {
        assert!(folder.join(format!("figures/{figure}.svg")).exists(), "{figure}");
    }
    let csv = output(&folder, 0, &asked(&["--format", "csv"]));
    assert_eq!(csv.lines().count(), 12);
    let json = output(&folder, 0, &asked(&["--format", "json"]));
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(json["sweep"]["orders"].as_array().map(Vec::len), Some(24));
    let holzer = output(&folder, 0, &asked(&["--table", "holzer"]));
    assert_eq!(holzer.matches("Holzer's table at").count(), 3, "{holzer}");
    let stars = output(&folder, 0, &asked(&["--table", "stars", "--format", "csv"]));
    assert_eq!(stars.lines().count(), 25);
    let refused = message(&folder, 2, &asked(&["--table", "tuning"]));
    assert!(refused.contains("--tune damper"), "{refused}");
    six(&folder, &SIX.replace("twist_limit = \"1.2 deg\"", "twist_limit = \"0.001 deg\""));
    let text = output(&folder, 1, &asked(&[]));
    assert!(text.contains("not kept"), "{text}");
}

#[test]
fn what_is_lacking_is_said_with_its_key() {
    let folder = folder("torsion-lacking");
    let text: Vec<&str> = SIX.split("[flywheel]\ninertia = \"0.95 kg m2\"\n").collect();
    six(&folder, &text.join("\n"));
    let refused = message(&folder, 2, &asked(&[]));
    assert!(refused.contains("flywheel") && refused.contains("[flywheel]"), "{refused}");
    let refused = message(&folder, 2, &["torsion", "six.toml", "--speeds", "900 rpm, 800 rpm"]);
    assert!(refused.contains("rise") || refused.contains("flywheel"), "{refused}");
}
