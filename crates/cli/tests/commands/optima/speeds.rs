//! Speeds at which loads are judged, with their weights, and what the answer says of them.

use crate::program::{example, folder, lanchester, message, output, output_json};
use std::fs;
use std::path::Path;

/// The transverse four on its mounts with a section [balance].
fn four(folder: &Path, balance: &str) -> String {
    let text = fs::read_to_string(example("in-line-4-mounts")).unwrap();
    fs::write(folder.join("four.toml"), format!("{text}\n[balance]\n{balance}\n")).unwrap();
    "four.toml".to_owned()
}

/// All that `check` says, which must end with `status`.
fn checked(folder: &Path, status: i32, file: &str) -> String {
    let run = lanchester(folder, &["check", file]);
    let said = [run.stdout, run.stderr].map(|bytes| String::from_utf8(bytes).unwrap()).concat();
    assert_eq!(run.status.code(), Some(status), "{said}");
    said
}

fn value(answer: &serde_json::Value) -> f64 {
    answer["stages"][0]["value"].as_f64().unwrap()
}

#[test]
fn weights_of_speeds_are_judged_and_told() {
    let folder = folder("balance-speed-weights");
    let speeds =
        "minimise = [\"mount force with gas\"]\nspeeds = [\"900 rpm\", { speed = \"3000 rpm\", weight = 8 }]";
    let file = four(&folder, speeds);
    let asked = ["balance", file.as_str()];
    let found = output_json(&folder, 0, &[&asked[..], &["--format", "json"]].concat());
    assert_eq!(found["mount_gas_speeds"]["weights"], serde_json::json!([1.0, 8.0]));
    assert_eq!(found["mount_gas_speeds"]["judged"].as_array().unwrap().len(), 2);
    let text = output(&folder, 0, &asked);
    assert!(text.contains("mount force with gas"), "{text}");
    assert!(
        text.replace('\n', " ").contains("at weighted speeds: 900 rpm times 1, 3000 rpm times 8"),
        "{text}"
    );
    // The options say the same, in place of what the file says.
    let options = ["--speed", "900 rpm", "--speed", "3000 rpm * 8", "--format", "json"];
    assert_eq!(value(&output_json(&folder, 0, &[&asked[..], &options].concat())), value(&found));
    let plain = ["--speed", "900 rpm", "--speed", "3000 rpm", "--format", "json"];
    let plain = output_json(&folder, 0, &[&asked[..], &plain].concat());
    assert!(value(&plain) <= value(&found) && plain["mount_gas_speeds"]["weights"].is_null());
    // What is expanded reads back.
    let shown = output(&folder, 0, &["show", &file]);
    assert!(shown.contains("{ speed = \"3000 rpm\", weight = 8 }"), "{shown}");
    for weight in ["0", "-2", "nan", "two"] {
        let refused = message(&folder, 2, &["balance", &file, "--speed", &format!("3000 rpm * {weight}")]);
        assert!(refused.contains("weight") && refused.contains("hint:"), "{refused}");
        if weight == "two" {
            continue;
        }
        let section =
            format!("minimise = [\"mount force\"]\nspeeds = [{{ speed = \"3000 rpm\", weight = {weight} }}]");
        let file = four(&folder, &section);
        let refused = checked(&folder, 2, &file);
        assert!(refused.contains("weight"), "{refused}");
        four(&folder, speeds);
    }
    let file = four(&folder, "minimise = [\"mount force\"]\nspeeds = [{ weight = 2 }]");
    assert!(checked(&folder, 2, &file).contains("`speed` is missing"));
}

/// Inertia alone is told as such where the file has gas.
#[test]
fn an_answer_says_that_the_gas_is_left_out() {
    let folder = folder("balance-without-gas");
    let file = four(&folder, "minimise = [\"mount force\"]");
    let text = output(&folder, 0, &["balance", &file]);
    assert!(text.replace('\n', " ").contains("Forces of inertia at the mounts, without the gas,"), "{text}");
}

#[test]
fn speeds_that_decide_nothing_are_told() {
    let folder = folder("balance-idle-speeds");
    let file = four(&folder, "minimise = [\"couple\"]\nspeeds = [\"900 rpm\"]");
    let text = output(&folder, 0, &["balance", &file]);
    assert!(text.replace('\n', " ").contains("The given speeds decide nothing here"), "{text}");
    let warned = checked(&folder, 0, &file);
    assert!(warned.contains("W0204") && warned.contains("`speeds` has no effect"), "{warned}");
    let file = four(&folder, "minimise = [\"couple\", \"mount force\"]\nspeeds = [\"900 rpm\"]");
    assert!(!checked(&folder, 0, &file).contains("W0204"));
}

/// One table has every quantity once.
#[test]
fn before_and_after_says_every_quantity_once() {
    let folder = folder("balance-rows-once");
    for name in ["in-line-3", "in-line-4", "v8-crossplane"] {
        let file = format!("{name}.toml");
        output(&folder, 0, &["new", name, "--output", &file]);
        let text = output(&folder, 0, &["balance", &file]);
        assert!(!text.contains("What it does"), "{name}: {text}");
        let table = text.split("Before and after\n").nth(1).unwrap();
        let rows: Vec<&str> = table.lines().skip_while(|line| !line.contains("quantity")).skip(1).collect();
        let rows = rows.iter().take_while(|line| !line.trim().is_empty());
        let mut seen: Vec<String> = Vec::new();
        for row in rows {
            // Everything before the unit: quantity and place.
            let cells: Vec<&str> =
                row.trim().split("  ").map(str::trim).filter(|cell| !cell.is_empty()).collect();
            let units = ["N", "N m", "%", "g", "g mm"];
            let key: Vec<&str> = cells.into_iter().take_while(|cell| !units.contains(cell)).collect();
            let key = key.join(" | ");
            if !key.is_empty() && !key.starts_with(['-', '\u{2500}']) {
                assert!(!seen.contains(&key), "{name}: {key} twice in {table}");
                seen.push(key);
            }
        }
        for quantity in ["force", "couple", "roll moment", "bending moment"] {
            assert!(seen.iter().any(|key| key == quantity), "{name}: {quantity} in {seen:?}");
        }
    }
}
