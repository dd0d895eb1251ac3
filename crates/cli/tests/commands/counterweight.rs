//! Counterweights as real parts, on the command line.

use crate::program::{examples, folder, message, output, output_json};

fn three() -> String {
    examples().join("in-line-3-counterweights.toml").display().to_string()
}

#[test]
fn the_lightest_shape_keeps_its_limit_and_its_duty() {
    let folder = folder("counterweight-design");
    let found = output_json(&folder, 0, &["counterweight", "design", &three(), "--format", "json"]);
    let weights = found["weights"].as_array().unwrap();
    assert_eq!(weights.len(), 4);
    for weight in weights {
        let best = &weight["outcome"]["found"];
        let design = &best["design"];
        assert_eq!(best["proved"], true);
        let number = |key: &str| design[key].as_f64().unwrap();
        assert!((number("unbalance") - 0.08876).abs() < 1e-10, "{design}");
        assert!(number("swept_radius") <= 0.093 * (1.0 + 1e-9), "{design}");
    }
    let text = output(&folder, 0, &["counterweight", "design", &three()]);
    assert!(text.contains("web 1, web 2, web 5, web 6: the least mass"), "{text}");
    let csv = output(&folder, 0, &["counterweight", "design", &three(), "--format", "csv"]);
    assert!(csv.starts_with("weight,mass [g],") && csv.lines().count() == 2, "{csv}");
}

#[test]
fn what_cannot_be_met_is_told_with_the_nearest_values() {
    let folder = folder("counterweight-infeasible");
    let limit = ["counterweight", "design", &three(), "--limit", "swept radius = 80 mm"];
    let text = output(&folder, 1, &limit);
    assert!(
        text.contains("swept radius, at most  80.000 mm") && text.contains("balance, at least"),
        "{text}"
    );
    let front = ["counterweight", "front", &three(), "--limit", "swept radius = 80 mm"];
    assert!(output(&folder, 1, &front).contains("swept radius, at most  80.000 mm"));
}

#[test]
fn a_front_has_designs_to_adopt() {
    let folder = folder("counterweight-front");
    let file = three();
    let front = ["counterweight", "front", &file, "--against", "inertia", "--designs", "5"];
    let csv = output(&folder, 0, &[&front[..], &["--format", "csv"]].concat());
    assert!((4..=6).contains(&csv.lines().count()), "{csv}");
    output(&folder, 0, &[&front[..], &["--adopt", "2", "--figures", "figures"]].concat());
    for figure in ["counterweight-front.svg", "counterweight-web-5.svg"] {
        let svg = std::fs::read_to_string(folder.join("figures").join(figure)).unwrap();
        assert!(svg.starts_with("<svg") && !svg.contains("NaN"), "{figure}");
    }
    let told = message(&folder, 2, &[&front[..], &["--adopt", "40"]].concat());
    assert!(told.contains("--adopt needs the number of a design"), "{told}");
}

#[test]
fn wrong_options_are_told_with_what_is_right() {
    let folder = folder("counterweight-wrong");
    let file = three();
    let design = |more: &[&str]| {
        message(&folder, 2, &[&["counterweight", "design", file.as_str()][..], more].concat())
    };
    for (options, told) in [
        (["--dimension", "height = 2 mm"], "`rectangle height`"),
        (["--dimension", "arc radius"], "arc radius = 60 mm .. 100 mm"),
        (["--dimension", "arc radius = 60"], "write \"60 mm\""),
        (["--dimension", "arc radius = 90 mm .. 60 mm"], "range from small to large"),
        (["--limit", "width = 2 mm"], "`half width`"),
        (["--density", "7.85 kg/m3"], "7850 kg/m3"),
        (["--weight", "web 9"], "\"web 1\", \"web 2\""),
        (["--unbalance", "-3 kg mm"], "must not be negative"),
    ] {
        let message = design(&options);
        assert!(message.contains(told), "{options:?}: {message}");
    }
    let plain = examples().join("in-line-3.toml").display().to_string();
    let told = message(&folder, 2, &["counterweight", "design", &plain]);
    assert!(told.contains("[counterweight_design]") && told.contains("arc_radius"), "{told}");
}

/// The evolutionary search of the tool paper never wins.
#[test]
fn evolution_stands_beside_the_optimum() {
    let folder = folder("counterweight-evolution");
    let asked = ["counterweight", "design", &three(), "--method", "evolution", "--evaluations", "3000"];
    let text = output(&folder, 0, &asked);
    assert!(text.contains("looked at 3000 designs") && text.contains("% above the optimum"), "{text}");
    assert!(!text.contains("is -"), "{text}");
}
