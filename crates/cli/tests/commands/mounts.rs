//! The block on its mounts: text, CSV, JSON, figures, refusals.

use crate::program::{examples, folder, lanchester, output, output_json};
use std::fs;
use std::path::PathBuf;

fn example(test: &str) -> PathBuf {
    let folder = folder(test);
    fs::copy(examples().join("in-line-4-mounts.toml"), folder.join("four.toml")).unwrap();
    folder
}

#[test]
fn modes_and_forces_stand_in_the_text() {
    let folder = example("mounts-text");
    let text = output(&folder, 0, &["mounts", "four.toml", "--point", "300 mm, 0 mm, 100 mm"]);
    for words in [
        "Transverse four on its mounts, shaken by inertia loads and gas (computed: Otto cycle)",
        "Torque-roll axis",
        "Mounts at rest",
        "Modes of the block on its mounts",
        "Damped modes",
        "Forces at the mounts by order at 6000 rpm",
        "Point 1 is x = 300",
        "The table of mount engine side goes from 1 to 400 Hz",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
}

#[test]
fn csv_and_json_hold_the_same_forces() {
    let folder = example("mounts-csv");
    let rest = ["--speed", "3000 rpm", "--orders", "4", "--inertia-only"];
    let csv = output(&folder, 0, &[&["mounts", "four.toml", "--format", "csv"], &rest[..]].concat());
    let json = output_json(&folder, 0, &[&["mounts", "four.toml", "--format", "json"], &rest[..]].concat());
    // Four orders at three mounts.
    assert_eq!(csv.lines().count(), 1 + 4 * 3, "{csv}");
    let orders = json["response"]["speeds"][0]["orders"].as_array().unwrap();
    let second = orders.iter().find(|o| o["order"] == 2.0).unwrap();
    let along_x = &second["forces"][0][0];
    let size = along_x[0].as_f64().unwrap().hypot(along_x[1].as_f64().unwrap());
    let line =
        csv.lines().find(|l| l.starts_with("3000,2,100,engine side,")).unwrap_or_else(|| panic!("{csv}"));
    let told: f64 = line.split(',').nth(5).unwrap().parse().unwrap();
    assert!((told - size).abs() < 1e-9 * size, "{line} {size}");
    let modes = output(&folder, 0, &["mounts", "four.toml", "--format", "csv", "--table", "modes"]);
    assert_eq!(modes.lines().count(), 7, "{modes}");
}

#[test]
fn figures_are_written() {
    let folder = example("mounts-figures");
    output(&folder, 0, &["mounts", "four.toml", "--figures", "out"]);
    for name in ["mount-forces", "mount-waterfall", "mount-transmissibility", "mount-modes"] {
        let svg = fs::read_to_string(folder.join(format!("out/{name}.svg"))).unwrap();
        assert!(svg.starts_with("<svg"), "{name}");
    }
}

#[test]
fn a_block_that_is_not_held_is_told() {
    let folder = example("mounts-free");
    let text = fs::read_to_string(folder.join("four.toml")).unwrap();
    let two = text.split("# Torque rod").next().unwrap();
    fs::write(folder.join("two.toml"), two).unwrap();
    let run = lanchester(&folder, &["mounts", "two.toml"]);
    let said = String::from_utf8(run.stderr).unwrap();
    assert_eq!(run.status.code(), Some(2));
    assert!(
        said.contains("it can turn about the line through mounts `engine side` and `gearbox side`"),
        "{said}"
    );
    fs::copy(examples().join("in-line-4.toml"), folder.join("plain.toml")).unwrap();
    let run = lanchester(&folder, &["mounts", "plain.toml"]);
    let said = String::from_utf8(run.stderr).unwrap();
    assert_eq!(run.status.code(), Some(2));
    assert!(said.contains("add a [block] section"), "{said}");
}
