//! Searches over choices: what ends them, what is said meanwhile, weighted sums and shadow prices in every form.

use crate::program::{folder, lanchester, message, number, output, output_json};
use serde_json::Value;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Command, Stdio};

/// A search that would take hours: a given amount of free direction on every web of a V8.
const LONG: [&str; 9] = [
    "balance",
    "v8.toml",
    "--counterweights",
    "webs",
    "--min-unbalance",
    "0.05 kg m",
    "--max-unbalance",
    "0.05 kg m",
    "--minimise=main-bearing load rms",
];

fn engine(folder: &Path, layout: &str, file: &str) {
    output(folder, 0, &["new", layout, "--output", file]);
}

/// Value, bound and gap of the first stage, which must fit together.
fn first_stage(answer: &Value) -> [f64; 3] {
    let found = ["value", "lower_bound", "gap"].map(|key| number(answer, &format!("/stages/0/{key}")));
    let [value, bound, gap] = found;
    assert!(bound <= value && (gap - (value - bound)).abs() < 1e-9 * value, "{found:?}");
    found
}

#[test]
fn the_largest_number_of_nodes_and_the_gap_are_options() {
    let folder = folder("search-limits");
    engine(&folder, "v8-crossplane", "v8.toml");
    let few = [&LONG[..], &["--max-nodes", "2", "--format", "json"]].concat();
    let run = lanchester(&folder, &few);
    assert_eq!(run.status.code(), Some(1));
    let said = String::from_utf8(run.stderr).unwrap();
    assert!(
        said.contains("the largest number of nodes was reached after ") && said.contains("gap"),
        "{said}"
    );
    assert!(said.contains("hint: --max-nodes 20 "), "{said}");
    let answer: Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(answer["outcome"]["cause"], "max-nodes");
    assert_eq!(answer["settings"]["max_nodes"], 2);
    let [value, bound, gap] = first_stage(&answer);
    assert!(gap > 1e-6 * value);

    let more = output_json(&folder, 1, &[&LONG[..], &["--max-nodes", "12", "--format", "json"]].concat());
    let [better, higher, _] = first_stage(&more);
    assert!(better <= value * (1.0 + 1e-8) && higher >= bound, "{better} {value}, {higher} {bound}");
    // As wide a gap as that is closed already.
    let share = format!("{}", (1.2 * gap / bound).min(0.5));
    let wide = output(&folder, 0, &[&LONG[..], &["--gap", &share]].concat());
    assert!(wide.contains("The search ended within the gap of "), "{wide}");
}

#[test]
fn a_time_limit_gives_the_best_so_far() {
    let folder = folder("search-time");
    engine(&folder, "v8-crossplane", "v8.toml");
    let limited = [&LONG[..], &["--max-nodes", "1000000", "--time-limit", "1 ms"]].concat();
    let run = lanchester(&folder, &limited);
    assert_eq!(run.status.code(), Some(1));
    let said = String::from_utf8(run.stdout).unwrap();
    assert!(said.contains("the time limit was reached"), "{said}");
}

#[test]
fn limits_of_a_search_without_a_meaning_are_refused() {
    let folder = folder("search-refused");
    engine(&folder, "v8-crossplane", "v8.toml");
    for (option, value, needed) in [
        ("--gap", "0", "1e-8 to 0.5"),
        ("--gap", "60 %", "1e-8 to 0.5"),
        ("--max-nodes", "0", "1 or more"),
        ("--time-limit", "30", "such as \"30 s\""),
        ("--time-limit", "0 s", "above 0"),
    ] {
        let said = message(&folder, 2, &["balance", "v8.toml", option, value]);
        assert!(said.contains(needed), "{option} {value}: {said}");
    }
    for other in ["--search", "--method=half", "--cancel=force order 1"] {
        let said = message(&folder, 2, &["balance", "v8.toml", other, "--max-nodes", "9"]);
        assert!(said.contains("end a search over choices"), "{other}: {said}");
    }
}

/// Progress is said without a terminal too, and the first Ctrl-C after it gives the best so far with its bound.
#[cfg(unix)]
#[test]
fn ctrl_c_gives_the_best_so_far() {
    let folder = folder("search-stopped");
    engine(&folder, "v8-crossplane", "v8.toml");
    let mut child = Command::new(env!("CARGO_BIN_EXE_lanchester"))
        .args([&LONG[..], &["--max-nodes", "100000000", "--format", "json"]].concat())
        .current_dir(&folder)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut told = BufReader::new(child.stderr.take().unwrap());
    let mut line = String::new();
    told.read_line(&mut line).unwrap();
    assert!(
        line.starts_with("stage 1 of 1 (main-bearing load rms): best ") && line.contains(" N, bound "),
        "{line}"
    );
    assert!(line.contains(" gap ") && line.contains(" nodes"), "{line}");
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    let mut rest = String::new();
    told.read_to_string(&mut rest).unwrap();
    let mut answer = String::new();
    child.stdout.take().unwrap().read_to_string(&mut answer).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(1), "{rest}");
    assert!(rest.contains("stopping with the best so far") && rest.contains("cancelled after "), "{rest}");
    let answer: Value = serde_json::from_str(&answer).unwrap();
    assert_eq!(answer["outcome"]["cause"], "cancelled");
    first_stage(&answer);
    assert_eq!(answer["weights"].as_array().unwrap().len(), 8);
}

/// A weighted sum says what it is and what it leaves of each term; its shadow prices have no unit of either.
#[test]
fn a_weighted_sum_is_no_row_of_stages() {
    let folder = folder("weighted-sum");
    engine(&folder, "twin-270", "twin.toml");
    let sum = [
        "balance",
        "twin.toml",
        "--counterweights=throws",
        "--max-unbalance=0.004 kg m",
        "--minimise=force = 3 kN, couple = 200 N m",
    ];
    let said = output(&folder, 0, &sum);
    let plain = said.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        plain.contains("Least weighted sum ")
            && plain.contains("(force / 3000 N + couple / 200 N m); it leaves force "),
        "{said}"
    );
    assert!(!plain.contains(", then couple") && plain.contains(" and couple "), "{said}");
    assert!(plain.contains("per kg m weighted sum"), "{said}");

    let json = output_json(&folder, 0, &[&sum[..], &["--format=json"]].concat());
    let found = &json["stages"][0];
    assert_eq!(found["unit"], "1");
    let of = |term: usize| {
        found["terms"][term][1].as_f64().unwrap() * found["term_weights"][term].as_f64().unwrap()
    };
    assert!((number(&json, "/stages/0/value") - of(0) - of(1)).abs() < 1e-12, "{found}");
    let limit = json["limits"].as_array().unwrap().iter().find(|limit| limit["price"] != 0.0).unwrap();
    assert_eq!(
        (&limit["price_unit"], &limit["stage"], &limit["side"]),
        (&"1 per kg m".into(), &0.into(), &"at-most".into())
    );

    let csv = output(&folder, 0, &[&sum[..], &["--format=csv", "--table=limits"]].concat());
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("limit,side,value,reached,unit,shadow price,unit of price,of"));
    let price = limit["price"].as_f64().unwrap();
    assert!(csv.contains(&format!(",kg m,{price},per kg m,weighted sum")), "{csv}");

    // One weight alone: there is no other to cancel what it has too much.
    engine(&folder, "single", "single.toml");
    let least =
        ["balance", "single.toml", "--counterweights=throws", "--minimise=force", "--min-unbalance=0.2 kg m"];
    let said = output(&folder, 0, &least);
    assert!(said.contains("least amount of `throw 1`") && said.contains("at least"), "{said}");
    assert!(said.contains("N per kg m"), "{said}");
}
