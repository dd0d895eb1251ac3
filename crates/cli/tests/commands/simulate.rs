//! `simulate` and `crosscheck`: text, JSON, CSV, refusals, Ctrl-C.

use crate::program::{changed_example, message, number, output, output_json, same};
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::Duration;

const SET: &str = "generator-set-3.toml";

/// One value of a CSV file: column by the start of its name, row from 0.
fn cell(csv: &str, column: &str, row: usize) -> f64 {
    let place = csv.lines().next().unwrap().split(',').position(|name| name.starts_with(column)).unwrap();
    csv.lines().nth(row + 1).unwrap().split(',').nth(place).unwrap().parse().unwrap()
}

#[test]
fn a_start_of_the_generator_set_is_told() {
    let folder = changed_example("simulate-start", SET, same);
    let text = output(&folder, 0, &["simulate", "engine.toml", "--for", "1.2 s", "--figures", "figures"]);
    for figure in ["speed", "torque", "orbit", "mount-forces", "energy"] {
        let svg = fs::read_to_string(folder.join(format!("figures/simulated-{figure}.svg"))).unwrap();
        assert!(svg.starts_with("<svg") && !svg.contains("NaN"), "{figure}");
    }
    for words in [
        "Generator set of three cylinders, simulated as rigid bodies",
        "Run: complete. It ends after 1.2000 s",
        "the starter lets go",
        "Event 3 (load 40 N m) never came.",
        "Speed in the last period",
        "Block in the last period",
        "Mounts: largest force",
        "Largest and smallest values over the whole run",
        "Main bearings",
        "  whole run  ",
        "Audit: energy",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
}

/// A file that describes a run has it in its report, with its own start and events.
#[test]
fn the_report_has_the_run_of_the_file() {
    let folder = changed_example("simulate-report", SET, |text| {
        text.replace("duration = \"24 s\"", "duration = \"1 s\"")
    });
    let page = output(&folder, 0, &["report", "engine.toml", "--output", "-"]);
    for words in
        ["<h2>Simulated</h2>", "It ends after 1.0000 s", "the starter lets go", "Where the energy goes"]
    {
        assert!(page.contains(words), "{words}");
    }
}

#[test]
fn csv_and_json_hold_the_same_run() {
    let folder = changed_example("simulate-csv", "in-line-4.toml", same);
    let rest = ["--imposed", "--speed", "2000 rpm", "--for", "1 revolution", "--step", "10 deg"];
    let of = |format: &[&'static str]| [&["simulate", "engine.toml"], &rest[..], format].concat();
    let json = output_json(&folder, 0, &of(&["--format", "json"]));
    let csv = output(&folder, 0, &of(&["--format", "csv"]));
    assert_eq!(csv.lines().count(), 1 + 37, "{csv}");
    let at = |pointer: &str| number(&json, pointer);
    let turn = std::f64::consts::PI;
    assert!((at("/run/samples/theta/18") - turn).abs() < 1e-9);
    assert!((at("/run/samples/speed/18") - 2000.0 * turn / 30.0).abs() < 1e-9);
    assert!((cell(&csv, "outside_torque", 18) - at("/run/samples/outside_torque/18")).abs() < 1e-9, "{csv}");
    for table in ["reactions", "extremes", "energy", "events", "trace"] {
        let csv = output(&folder, 0, &of(&["--format", "csv", "--table", table]));
        assert!(!csv.is_empty(), "{table}");
    }
    message(&folder, 2, &of(&["--table", "energy"]));
}

#[test]
fn every_misfire_and_cut_of_the_file_comes() {
    let folder = changed_example("simulate-events", SET, |text| {
        let text = text.replace("speed = \"0 rpm\"", "speed = \"1500 rpm\"");
        text.replace("\"4 s\"", "\"0.1 s\"").replace("\"6 s\"", "\"0.2 s\"").replace("\"8 s\"", "\"0.3 s\"")
    });
    let csv = output(
        &folder,
        0,
        &[
            "simulate",
            "engine.toml",
            "--for",
            "0.4 s",
            "--block",
            "fixed",
            "--format",
            "csv",
            "--table",
            "events",
        ],
    );
    for words in ["load 40 N m", "cylinder 2 fires no more", "no load", "fuel 0 %"] {
        assert!(csv.contains(words), "{words}: {csv}");
    }
}

/// What cannot be run is refused before it starts, with what fixes it; what stalls runs, and says so.
#[test]
fn bad_input_is_told() {
    let refused =
        |name: &str, file: &str, change: fn(String) -> String, arguments: &[&str], words: &[&str]| {
            let folder = changed_example(name, file, change);
            let told = message(&folder, 2, &[&["simulate", "engine.toml"], arguments].concat());
            for words in words {
                assert!(told.contains(words), "{name}, {words}: {told}");
            }
        };
    refused(
        "simulate-power",
        SET,
        |text| text.replace("type = \"none\"", "type = \"power\"\npower = \"5 kW\""),
        &[],
        &["least_speed"],
    );
    refused(
        "simulate-inertia",
        "in-line-4.toml",
        same,
        &[],
        &["moment of inertia", "[flywheel]", "[crank.body]"],
    );
    refused(
        "simulate-block",
        SET,
        |text| text.replace("mass = \"190 kg\"", "mass = \"2 kg\""),
        &["--for", "0.1 s"],
        &["the block less"],
    );
    refused(
        "simulate-free",
        SET,
        |text| {
            text.replace("[\"140 N/mm\", \"60 N/mm\", \"60 N/mm\"]", "[\"140 N/mm\", \"0 N/mm\", \"0 N/mm\"]")
        },
        &["--for", "0.1 s"],
        &["leave a motion of it free"],
    );
    refused(
        "simulate-long",
        SET,
        same,
        &["--for", "1000000 revolutions"],
        &["evaluations", "long run", "--long"],
    );
    // A run that no machine could make is told in words, never as "inf".
    let folder = changed_example("simulate-endless", SET, same);
    let told = message(&folder, 2, &["simulate", "engine.toml", "--for", "1e300 revolutions"]);
    assert!(
        told.contains("more evaluations of the equations of motion than could ever be made")
            && !told.contains("inf"),
        "{told}"
    );
    assert!(told.contains("where 1e7 are allowed") && told.contains("where 1e6 are allowed"), "{told}");
    refused("simulate-many", SET, same, &["--for", "100 revolutions", "--step", "0.001 deg"], &["samples"]);
    refused("simulate-cylinder", SET, same, &["--misfire", "4"], &["from 1 to 3"]);
    refused("simulate-tolerance", SET, same, &["--tolerance", "1"], &["tolerance"]);
    refused("simulate-duration", SET, same, &["--for", "soon"], &["--for"]);
}

/// Loss factors have no meaning in time of their own: the run says by what they are replaced, and how well.
#[test]
fn loss_factors_are_fitted_and_the_run_says_how_well() {
    let folder = changed_example("simulate-loss", "in-line-4-mounts.toml", same);
    let text = output(&folder, 0, &["simulate", "engine.toml", "--imposed", "--block", "mounts"]);
    assert!(text.contains("Maxwell chains") && text.contains("% off"), "{text}");
}

#[test]
fn a_weak_starter_and_a_load_too_large_are_outcomes() {
    let weak = changed_example("simulate-weak", SET, |text| text.replace("\"6 N m\"", "\"0.5 N m\""));
    let text = output(&weak, 0, &["simulate", "engine.toml", "--for", "2 s", "--block", "fixed"]);
    assert!(text.contains("the crank comes to rest at"), "{text}");
    // 0.5 N m by 12, less what weight and gas take, against 7.404 N m of friction.
    for words in [
        "The starter is too weak: the crank stalls at 0 deg",
        "6.000 N m at the crankshaft",
        "2.208 N m are missing",
        "0.1840 N m at the starter",
    ] {
        assert!(text.replace('\n', " ").contains(words), "{words}: {text}");
    }
    // On its mounts the run goes on with a crank that stands, and says the same; at rest no energy is amiss.
    let moving = output(&weak, 0, &["simulate", "engine.toml", "--for", "2 s"]);
    assert!(
        moving.contains("The starter is too weak") && !moving.contains("Audit: energy 1.7e4"),
        "{moving}"
    );
    let heavy = changed_example("simulate-heavy", SET, same);
    let text = output(
        &heavy,
        0,
        &[
            "simulate",
            "engine.toml",
            "--for",
            "20 s",
            "--block",
            "fixed",
            "--speed",
            "900 rpm",
            "--load",
            "300 N m",
        ],
    );
    assert!(text.contains("the crank comes to rest at") && text.contains("It ends after"), "{text}");
}

/// The first Ctrl-C gives the samples so far, marked incomplete.
#[cfg(target_os = "linux")]
#[test]
fn an_interrupted_run_keeps_its_samples() {
    let folder = changed_example("simulate-interrupted", "in-line-4.toml", same);
    let arguments = [
        "simulate",
        "engine.toml",
        "--imposed",
        "--long",
        "--for",
        "10000000 revolutions",
        "--step",
        "720 deg",
    ];
    let mut child = Command::new(env!("CARGO_BIN_EXE_lanchester"))
        .current_dir(&folder)
        .args(arguments)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // Before the run listens to it, an interrupt would end the program without a word.
    let listens = || {
        let status = fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap();
        let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:")).unwrap();
        const INTERRUPT: u64 = 1 << 1;
        u64::from_str_radix(caught.trim(), 16).unwrap() & INTERRUPT != 0
    };
    while !listens() {
        std::thread::sleep(Duration::from_millis(10));
    }
    assert!(child.try_wait().unwrap().is_none(), "it runs for long");
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    let ended = child.wait_with_output().unwrap();
    let text = String::from_utf8(ended.stdout).unwrap();
    assert_eq!(ended.status.code(), Some(1), "{text}");
    assert!(text.contains("incomplete: cancelled, the samples so far are shown"), "{text}");
}

#[test]
fn crosscheck_lists_every_condition_and_what_is_missing() {
    let folder = changed_example("crosscheck", "in-line-4.toml", same);
    let text = output(&folder, 0, &["crosscheck", "engine.toml", "--order", "2"]);
    for words in ["Condition A", "Condition B", "Condition C", "Condition D", "agrees"] {
        assert!(text.contains(words), "{words}: {text}");
    }
    assert!(!text.contains("disagrees"), "{text}");
    let json =
        output_json(&folder, 0, &["crosscheck", "engine.toml", "--condition", "a", "--format", "json"]);
    assert_eq!(json["conditions"].as_array().unwrap().len(), 1);
    let rows = json["conditions"][0]["rows"].as_array().unwrap();
    assert!(rows.iter().all(|row| row["verdict"] == "agrees") && rows.len() > 8);
    let csv = output(&folder, 0, &["crosscheck", "engine.toml", "--format", "csv"]);
    assert!(csv.lines().count() > rows.len(), "{csv}");
    // Condition B has the change of every load by order with its estimate, in one form of numbers with their units.
    let folder_b = changed_example("crosscheck-b", "three-cylinder.toml", same);
    let json =
        output_json(&folder_b, 0, &["crosscheck", "engine.toml", "--condition", "b", "--format", "json"]);
    let rows = json["conditions"][0]["rows"].as_array().unwrap();
    for kind in ["force", "couple", "roll moment"] {
        let name = format!("{kind}, change by the free speed");
        let own: Vec<_> = rows.iter().filter(|row| row["quantity"] == name.as_str()).collect();
        assert!(own.len() > 2 && own[0]["order"].is_null(), "{kind}: {own:?}");
        assert!(own.iter().all(|row| row["reason"].as_str().unwrap().contains("to the first order")));
    }
    // A bar below rounding is not kept, and the exit status says so.
    let text = output(&folder, 1, &["crosscheck", "engine.toml", "--bar", "1e-19"]);
    assert!(text.contains("disagrees"), "{text}");
    message(&folder, 2, &["crosscheck", "engine.toml", "--bar", "0"]);
}

/// A torque over the angle from a file is that of its orders: in the run, in the speed fluctuation, in the cross-check.
#[test]
fn a_torque_from_a_file_is_that_of_its_orders() {
    let of = |test: &str, torque: &str| {
        changed_example(test, SET, |text| {
            let gas = text.find("[gas]").unwrap();
            let rest = text.find("# Flywheel and rotor").unwrap();
            let text = format!("{}{}", &text[..gas], &text[rest..text.find("[load]").unwrap()]);
            format!("{text}\n[simulation]\ntorque = {torque}\n")
        })
    };
    let listed = of(
        "simulate-orders",
        "[{ order = 0, cos = \"20 N m\" }, { order = 1.5, sin = \"60 N m\" }, { order = 3, cos = \"-15 N m\" }]",
    );
    let named = of("simulate-file", "[{ file = \"torque.csv\" }]");
    let torque = |theta: f64| 20.0 + 60.0 * (1.5 * theta).sin() - 15.0 * (3.0 * theta).cos();
    let lines = (0..=720).map(|deg| format!("{deg}; {}\n", torque(f64::from(deg).to_radians())));
    let text = format!("# synthetic\ntheta [deg]; torque [N m]\n{}", lines.collect::<String>());
    fs::write(named.join("torque.csv"), text).unwrap();
    let rest = ["engine.toml", "--format", "json"];
    for (command, pointers) in [
        ("simulate", ["/run/samples/speed/1234", "/run/samples/outside_torque/77"]),
        ("torque", ["/ripples/0/speed/40", "/ripples/0/speed/90"]),
    ] {
        let run = |folder: &PathBuf| output_json(folder, 0, &[&[command], &rest[..]].concat());
        let (a, b) = (run(&listed), run(&named));
        for pointer in pointers {
            let (a, b) = (number(&a, pointer), number(&b, pointer));
            // The spline through samples at every degree is off by (h n)^4 of an order.
            assert!((a - b).abs() < 1e-5 * a.abs().max(1.0), "{command} {pointer}: {a} {b}");
        }
    }
    let text = output(&named, 0, &["simulate", "engine.toml", "--for", "1 revolution"]);
    assert!(text.contains("Torque of torque.csv:"), "{text}");
    let told = output(&named, 0, &["crosscheck", "engine.toml", "--condition", "b"]);
    assert!(told.contains("agrees") && !told.contains("disagrees"), "{told}");
    let expanded = output(&named, 0, &["show", "engine.toml"]);
    assert!(expanded.contains("file = \"torque.csv\""), "{expanded}");
    fs::write(named.join("torque.csv"), "theta [deg]; p [bar]\n0; 1\n").unwrap();
    assert!(message(&named, 2, &["simulate", "engine.toml"]).contains("E1621"));
    assert!(message(&named, 2, &["torque", "engine.toml"]).contains("torque.csv"));
    fs::remove_file(named.join("torque.csv")).unwrap();
    let told = message(&named, 2, &["simulate", "engine.toml"]);
    assert!(told.contains("torque.csv") && told.contains("[simulation] names it"), "{told}");
}
