//! Torque and bearings on the command line.

use crate::program::{folder, message, output, output_json};
use std::path::Path;

const FOUR: &str = r#"name = "Four with ideal gas"
speed = ["800 rpm", "6000 rpm"]
[firing]
order = [1, 3, 4, 2]
[layout]
type = "in-line"
cylinders = 4
spacing = "90 mm"
[crank]
stroke = "86 mm"
[piston]
mass = "0.4 kg"
bore = "80 mm"
[rod]
length = "144 mm"
mass = "0.5 kg"
[counterweights]
rotating_share = "100 %"
"#;

const GAS: &str = r#"[gas]
compression_ratio = 10
[gas.cycle]
type = "seiliger"
peak_pressure = "70 bar"
[gas.fuel]
energy = "1.2 kJ"
[gas.intake]
temperature = "40 degC"
"#;

fn written(folder: &Path, text: &str) {
    std::fs::write(folder.join("four.toml"), text).expect("the folder is ours");
}

#[test]
fn torque_is_the_work_over_the_cycle() {
    let folder = folder("torque");
    written(&folder, &format!("{FOUR}{GAS}"));
    let all = ["--fmep", "1.2 bar", "--speeds", "1000 rpm, 2000 rpm, 3000 rpm", "--fluctuation", "2 %"];
    let json = output_json(&folder, 0, &[&["torque", "four.toml", "--format", "json"], &all[..]].concat());
    let number = |pointer: &str| json.pointer(pointer).and_then(serde_json::Value::as_f64).expect("a number");
    let cylinders = json["torque"]["cylinders"].as_array().expect("a list");
    let work: f64 = cylinders.iter().map(|c| c["work"]["by_volume"].as_f64().expect("a number")).sum();
    assert_eq!(cylinders.len(), 4);
    let torque = number("/torque/indicated/torque");
    assert!((torque - work / (4.0 * std::f64::consts::PI)).abs() < 1e-9 * torque);
    // 1.2 bar over the swept volume.
    let lost = 1.2e5 * number("/torque/indicated/displacement") / (4.0 * std::f64::consts::PI);
    assert!((torque - lost - number("/brake/torque")).abs() < 1e-9 * torque);
    assert!(number("/flywheel/flywheel") > 0.0 && number("/power/peak/1") > 0.0);
    let text = output(&folder, 0, &["torque", "four.toml", "--figures", "figures"]);
    assert!(text.contains("Even: every 180 deg.") && text.contains("P  C  I  E"), "{text}");
    assert!(folder.join("figures/strokes.svg").exists() && folder.join("figures/speed-ripple.svg").exists());
    let csv = output(&folder, 0, &["torque", "four.toml", "--format", "csv"]);
    assert_eq!(csv.lines().count(), 721);
    let refused = message(&folder, 2, &["torque", "four.toml", "--speeds", "1000 rpm, 2000 rpm"]);
    assert!(refused.contains("three or more different speeds"), "{refused}");
}

#[test]
fn bearings_with_gas_and_without() {
    let folder = folder("bearings");
    written(&folder, &format!("{FOUR}{GAS}"));
    let text = output(&folder, 0, &["bearings", "four.toml", "--figures", "figures"]);
    assert!(text.contains("gas and inertia") && text.contains("peak, bare"), "{text}");
    assert!(folder.join("figures/main-5.svg").exists() && folder.join("figures/crankpin-4.svg").exists());
    let csv = output(&folder, 0, &["bearings", "four.toml", "--part", "gas", "--format", "csv"]);
    assert_eq!(csv.lines().count(), 721);
    written(&folder, FOUR);
    let text = output(&folder, 0, &["bearings", "four.toml"]);
    assert!(text.contains("rpm: inertia"), "{text}");
    let refused = message(&folder, 2, &["bearings", "four.toml", "--part", "gas"]);
    assert!(refused.contains("says nothing of the gas"), "{refused}");
    let refused = message(&folder, 2, &["torque", "four.toml"]);
    assert!(refused.contains("hint: add [gas]"), "{refused}");
}
