//! Engines side by side on the command line.

use crate::program::{folder, message, output, output_json};
use serde_json::Value;

fn example(name: &str) -> String {
    format!("{}/../../examples/{name}.toml", env!("CARGO_MANIFEST_DIR"))
}

fn number(value: &Value, pointer: &str) -> f64 {
    value
        .pointer(pointer)
        .and_then(Value::as_f64)
        .unwrap_or_else(|| panic!("no number at {pointer}: {value}"))
}

/// The nine arrangements of the thesis stand as in its Table 38, and the optimum is not worse than any crank.
#[test]
fn arrangements_and_optimum_stand_side_by_side() {
    let folder = folder("compare-arrangements");
    let twin = example("twin-in-line-in-phase");
    let all = ["compare", &twin, "--arrangements", "all", "--optimum"];
    let json = output_json(&folder, 0, &[&all[..], &["--format", "json"]].concat());
    let force = |k: usize| number(&json, &format!("/engines/{k}/force"));
    assert_eq!(json["engines"].as_array().map(Vec::len), Some(10));
    assert!(force(9) <= force(1) && force(1) < 0.55 * force(0) && force(8) < 0.01 * force(0));
    assert_eq!(json.pointer("/rankings/0/places/9/engine"), Some(&Value::from(0)));
    let text = output(&folder, 0, &[&all[..], &["--figures", "figures"]].concat());
    assert!(text.contains("10. 21 977 N: above all order 1, both ways alike (no. 1, basic crank)"), "{text}");
    assert!(folder.join("figures/comparison.svg").exists());
}

/// A similar engine made by hand, every length times 1.2 and every mass times 1.2^3, has the loads that the comparison says.
#[test]
fn a_similar_engine_is_the_engine_built_in_that_size() {
    let folder = folder("compare-similar");
    let text = |k: f64| {
        let (mass, length) = (k.powi(3), |mm: f64| k * mm);
        format!(
            "name = \"four {k}\"\nspeed = [\"1000 rpm\", \"5000 rpm\"]\n[firing]\norder = [1, 3, 4, 2]\n[layout]\ntype = \"in-line\"\n\
             cylinders = 4\nspacing = \"{} mm\"\n[crank]\nstroke = \"{} mm\"\n[piston]\nmass = \"{} kg\"\nbore = \"{} mm\"\n[rod]\n\
             length = \"{} mm\"\nmass = \"{} kg\"\n[gas]\ncompression_ratio = 10\n[gas.cycle]\ntype = \"otto\"\n[gas.fuel]\nenergy = \"{} kJ\"\n",
            length(90.0),
            length(86.0),
            0.4 * mass,
            length(80.0),
            length(144.0),
            0.5 * mass,
            1.2 * mass
        )
    };
    for (name, k) in [("small.toml", 1.0), ("large.toml", 1.2)] {
        std::fs::write(folder.join(name), text(k)).expect("the folder is ours");
    }
    for hold in ["speed", "piston-speed"] {
        let arguments = ["compare", "large.toml", "small.toml", "--equal", "displacement", "--hold", hold];
        let json = output_json(&folder, 0, &[&arguments[..], &["--format", "json"]].concat());
        assert!((number(&json, "/engines/1/similar/length") - 1.2).abs() < 1e-12);
        let speed = if hold == "speed" { "5000 rpm" } else { "4166.6666666666667 rpm" };
        let alone = output_json(
            &folder,
            0,
            &["compare", "large.toml", "large.toml", "--speed", speed, "--format", "json"],
        );
        let same = |pointer: &str| {
            let (scaled, built) = (
                number(&json, &format!("/engines/1{pointer}")),
                number(&alone, &format!("/engines/0{pointer}")),
            );
            assert!((scaled - built).abs() < 1e-9 * built.abs(), "{hold} {pointer}: {scaled} {built}");
        };
        for pointer in [
            "/speed",
            "/displacement",
            "/force",
            "/roll_moment",
            "/torque/mean",
            "/torque/most",
            "/torque/excess",
        ] {
            same(pointer);
        }
        if hold == "speed" {
            same("/torque/flywheel");
        }
    }
    // With equal power at equal speed the two are one.
    let json = output_json(
        &folder,
        0,
        &["compare", "large.toml", "small.toml", "--equal", "power", "--format", "json"],
    );
    assert!(
        (number(&json, "/engines/1/torque/power") / number(&json, "/engines/0/torque/power") - 1.0).abs()
            < 1e-9
    );
}

#[test]
fn mistakes_of_a_comparison_are_told() {
    let folder = folder("compare-mistakes");
    let twin = example("twin-in-line-in-phase");
    let refused = |arguments: &[&str], said: &str| {
        let told = message(&folder, 2, arguments);
        assert!(told.contains(said), "{told}");
    };
    refused(&["compare", &twin], "two or more engines or arrangements, got 1");
    refused(&["compare", &twin, &twin, "--reference", "3"], "the reference is number 3 of 2 engines");
    refused(&["compare", &twin, &twin, "--reference", "0"], "counts the engines from 1");
    refused(&["compare", &twin, "--arrangements", "1,10"], "numbers from 1 to 9, got `10`");
    refused(&["compare", &twin, &twin, "--hold", "speed"], "--equal");
    let four = example("in-line-4");
    refused(&["compare", &four, &four, "--fluctuation", "3 %"], "needs an engine with gas");
    let text = std::fs::read_to_string(&twin).expect("it is shipped");
    let bore = text.lines().filter(|line| !line.starts_with("bore")).collect::<Vec<_>>().join("\n");
    std::fs::write(folder.join("bare.toml"), bore).expect("the folder is ours");
    refused(&["compare", &twin, "bare.toml", "--equal", "power"], "needs the bore of every cylinder");
}
