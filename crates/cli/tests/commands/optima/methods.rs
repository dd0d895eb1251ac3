//! The published rules, matrices and 50 % shares, on the command line.

use crate::program::{example, folder, message, output, output_json};
use std::path::Path;

fn source(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation").join(name).display().to_string()
}

/// Applied Sciences 2021, 11, 8997, Table 5: m_c 1.275 kg, m_c,1 0.665 kg and m_c,2 0.0985 kg on every shaft.
#[test]
fn lit_balancing_tool_2021_v4_matrices() {
    let folder = folder("matrix-v4");
    let file = source("balancing-tool-paper/v4-90.toml");
    let found = output_json(&folder, 0, &["balance", &file, "--method", "matrix", "--format", "json"]);
    let weights = found["weights"].as_array().unwrap();
    let mass = |name: &str| {
        let of_name = weights.iter().filter(|w| w["name"].as_str().unwrap().starts_with(name));
        of_name.map(|w| w["mass"].as_f64().unwrap()).collect::<Vec<_>>()
    };
    assert!(mass("web").len() == 4 && mass("web").iter().all(|m| (m - 1.275).abs() < 1e-9), "{weights:?}");
    // Printed with four decimals; it adds both banks' pistons without projecting them, which concerns the first order alone.
    assert!(mass("second order").iter().all(|m| (m - 0.0985).abs() < 5e-5), "{weights:?}");
    // What the sources leave of first order turns with the crank: no shaft against it.
    assert!(mass("first order against").is_empty() && mass("first order with").len() == 2, "{weights:?}");
    let text = output(&folder, 0, &["balance", &file, "--method", "matrix"]);
    assert!(text.contains("0.66468") && text.contains("no balance shaft is needed"), "{text}");
    // Without that shaft: heavier counterweights do the same.
    let shaftless = ["balance", &file, "--method", "matrix", "--first-on-crank", "--shafts", "second"];
    let text = output(&folder, 0, &shaftless);
    assert!(!text.contains("first order with the crank, weight"), "{text}");
    assert!(text.contains("couple 0 N m,"), "{text}");
}

/// Singh (2017), section 3.6: counterweights of 90.15 kg mm and a balancer of 38.97 kg mm, whose printed phase leaves half.
#[test]
fn the_half_rules_stand_beside_the_optimum() {
    let folder = folder("half-three");
    let file = example("in-line-3");
    let found = output_json(&folder, 0, &["balance", &file, "--method", "half", "--format", "json"]);
    let weights = found["weights"].as_array().unwrap();
    let amount = |weight: &serde_json::Value, key: &str| {
        let part = |k: usize| weight[key][k].as_f64().unwrap();
        part(0).hypot(part(1))
    };
    let balancer: Vec<_> = weights.iter().filter(|w| w["shaft"].is_string() || w["shaft"].is_u64()).collect();
    assert_eq!(balancer.len(), 2, "{weights:?}");
    for weight in balancer {
        // The optimum of the same devices is the method's own balancer, at the corrected phase.
        let (method, optimum) = (amount(weight, "unbalance"), amount(weight, "optimum"));
        assert!((method - optimum).abs() < 1e-6 * optimum, "{method} {optimum}");
    }
    let text = output(&folder, 0, &["balance", &file, "--method", "half"]);
    assert!(text.contains("51.76") && text.contains("B_U"), "{text}");
    let csv =
        output(&folder, 0, &["balance", &file, "--method", "half", "--format", "csv", "--table", "orders"]);
    assert!(csv.lines().any(|line| line.starts_with("couple,N m,1,against,")), "{csv}");
    // Another share on an engine without a rule of its own.
    let share = ["balance", &example("twin-in-line-in-phase"), "--method", "half"];
    let full =
        output_json(&folder, 0, &[&share[..], &["--balance-factor", "100 %", "--format", "json"]].concat());
    let half =
        output_json(&folder, 0, &[&share[..], &["--balance-factor", "50 %", "--format", "json"]].concat());
    let sum = |answer: &serde_json::Value| -> f64 {
        answer["weights"].as_array().unwrap().iter().map(|w| amount(w, "unbalance")).sum()
    };
    assert!(sum(&full) > 1.2 * sum(&half), "{} {}", sum(&full), sum(&half));
}

#[test]
fn an_option_of_another_method_is_refused_with_what_to_do() {
    let folder = folder("methods-refused");
    let three = example("in-line-3");
    for (more, says) in [
        (vec!["--method", "matrix", "--webs", "101"], "6"),
        (vec!["--method", "matrix", "--webs", "10x001"], "1 or 0"),
        (vec!["--method", "half", "--webs", "100001"], "--webs"),
        (vec!["--alpha", "30 deg"], "--method"),
        (vec!["--method", "matrix", "--alpha", "30"], "unit"),
        (vec!["--method", "matrix", "--shaft-length", "0 mm"], "must be positive"),
    ] {
        let said = message(&folder, 2, &[&["balance", &three], &more[..]].concat());
        assert!(said.contains("error:") && said.contains(says), "{more:?}: {said}");
    }
}
