//! Sensitivities on the command line.

use crate::program::{example, folder, message, output, output_json};
use serde_json::Value;

/// The piston mass one percent up in the file does what the sensitivity says it does.
#[test]
fn a_change_of_the_file_does_what_was_said() {
    let folder = folder("sensitivity");
    let twin = example("twin-in-line-in-phase");
    let json = output_json(&folder, 0, &["sensitivity", &twin, "--format", "json"]);
    let inputs = json["inputs"].as_array().expect("a list");
    let place =
        inputs.iter().position(|input| input["quantity"]["part"] == "piston-mass").expect("it varies");
    let nominal = inputs[place]["nominal"].as_f64().expect("one mass");
    assert!((inputs[place]["half_width"].as_f64().expect("a number") - 0.01 * nominal).abs() < 1e-12);
    let above = json["outputs"][0]["effects"][place]["above"].as_f64().expect("an engine");
    let text = std::fs::read_to_string(&twin).expect("it is shipped");
    let heavier = format!("[piston]\nmass = \"{} kg\"", 1.01 * nominal);
    let start = text.find("[piston]\nmass").expect("the mass comes first");
    let end = start + "[piston]\n".len() + text[start + "[piston]\n".len()..].find('\n').expect("a line");
    std::fs::write(folder.join("heavier.toml"), format!("{}{heavier}{}", &text[..start], &text[end..]))
        .expect("ours");
    let loads = output_json(&folder, 0, &["loads", "heavier.toml", "--format", "json"]);
    let peak = loads["total"]["peaks"]["force"]["max"]["value"].as_f64().expect("a peak");
    assert!((peak - above).abs() < 1e-9 * peak, "{peak} {above}");
    let text = output(
        &folder,
        0,
        &[
            "sensitivity",
            &twin,
            "--vary",
            "rod length = 10 %",
            "--only",
            "--sobol",
            "64",
            "--figures",
            "figures",
        ],
    );
    assert!(text.contains("rod length") && !text.contains("piston mass"), "{text}");
    assert!(folder.join("figures/sensitivity.svg").exists());
    let csv =
        output(&folder, 0, &["sensitivity", &twin, "--output", "force order 2", "--each", "--format", "csv"]);
    assert!(csv.lines().all(|line| line.split(',').count() == 14) && csv.contains("piston mass 2"), "{csv}");
}

#[test]
fn mistakes_of_a_sensitivity_are_told() {
    let folder = folder("sensitivity-mistakes");
    let twin = example("twin-in-line-in-phase");
    let refused = |arguments: &[&str], said: &str| {
        let told = message(&folder, 2, &[&["sensitivity", &twin], arguments].concat());
        assert!(told.contains(said), "{told}");
    };
    refused(&["--vary", "rod weight = 1 g"], "unknown quantity \"rod weight\"");
    refused(&["--vary", "rod length"], "needs a quantity and how far it goes");
    refused(&["--vary", "rod length = 1 kg"], "rod length");
    refused(&["--vary", "piston-pin offset = 10 %"], "no size of which a share could be taken");
    refused(&["--output", "added mass"], "there is no output \"added mass\"");
    refused(&["--output", "torque"], "peak torque needs the gas");
    refused(&["--output", "mount force"], "needs engine mounts, and there are none");
    refused(&["--output", "inertia main bearing 4"], "no main bearing 4, the last one is main bearing 3");
    refused(
        &["--output", "inertia torque", "--vary", "gas pressure = 1 %"],
        "the engine has no gas pressure",
    );
    refused(&["--sobol", "2"], "from 16 to 10 000 000 draws, got 2");
    refused(&["--only"], "--vary");
    assert_eq!(output_json(&folder, 0, &["sensitivity", &twin, "--format", "json"])["sobol"], Value::Null);
}

/// The derivative by the pressure, against `torque` and `bearings` with the same engine: both grow in proportion where gas alone counts.
#[test]
fn gas_alone_grows_with_its_pressure() {
    let folder = folder("sensitivity-gas");
    let four = example("in-line-4-mounts");
    let arguments =
        ["--output", "gas torque", "--output", "gas torque mean", "--output", "mount force torque rod"];
    let only = ["--vary", "gas pressure = 1 %", "--vary", "bore = 1 %", "--only", "--speed", "2000 rpm"];
    let json = output_json(
        &folder,
        0,
        &[&["sensitivity", &four, "--format", "json"], &arguments[..], &only[..]].concat(),
    );
    assert_eq!(json["version"], 3);
    let torque = output_json(&folder, 0, &["torque", &four, "--speed", "2000 rpm", "--format", "json"]);
    let mean = torque["torque"]["indicated"]["torque"].as_f64().expect("a torque");
    let of = |place: usize| &json["outputs"][place];
    let number = |value: &Value| value.as_f64().expect("a number");
    assert_eq!(of(1)["name"], "mean gas torque");
    assert!((number(&of(1)["nominal"]) - mean).abs() < 1e-9 * mean);
    // Bore first: a factor on the area is a factor on the torque.
    let bore = number(&json["inputs"][0]["nominal"]);
    for place in [0, 1] {
        let slope = number(&of(place)["effects"][0]["slope"]["up"]);
        let nominal = number(&of(place)["nominal"]);
        assert!((slope * bore / 2.0 - nominal).abs() < 1e-9 * nominal, "{slope} {nominal}");
    }
    let text = output(&folder, 0, &["sensitivity", &four, "--output", "mount force torque rod"]);
    assert!(text.contains("mount stiffness") && text.contains("block mass"), "{text}");
    // Jumps of ideal pressures part: no number is the slope.
    let leap = [
        "sensitivity",
        &four,
        "--output",
        "main bearing 2",
        "--vary",
        "throw angle = 1 deg",
        "--only",
        "--each",
    ];
    let text = output(&folder, 0, &leap);
    assert!(text.contains("leaps  per deg, upwards"), "{text}");
    let json = output(&folder, 0, &[&leap[..], &["--format", "json"]].concat());
    assert!(json.contains("\"up\": null"), "{json}");
    let csv = output(&folder, 0, &["sensitivity", &four, "--output", "crankpin 2 mean", "--format", "csv"]);
    assert!(csv.contains("mean crankpin load 2,N,") && csv.contains("gas pressure"), "{csv}");
}
