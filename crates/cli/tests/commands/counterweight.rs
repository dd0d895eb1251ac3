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
        // Beyond the web: what lies within its flank is the web's.
        assert!((number("unbalance") - 0.08876).abs() < 1e-10, "{design}");
        assert!(weight["shared"]["unbalance"].as_f64().unwrap() > 0.0, "{weight}");
        let radii = weight["envelope"]["radii"].as_array().unwrap().iter().map(|r| r.as_f64().unwrap());
        assert!(number("swept_radius") <= radii.fold(0.0, f64::max) * (1.0 + 1e-9), "{design}");
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
    let text = output(&folder, 0, &[&front[..], &["--adopt", "2", "--figures", "figures"]].concat());
    assert!(text.contains("keeps 1.50 mm of clearance, bounded first by piston"), "{text}");
    for figure in ["counterweight-front.svg", "counterweight-web-5-web-6.svg"] {
        let svg = std::fs::read_to_string(folder.join("figures").join(figure)).unwrap();
        assert!(svg.starts_with("<svg") && !svg.contains("NaN"), "{figure}");
    }
    // An adopted design makes up for what it shares with the flank of its web, also at both ends.
    let last = (csv.lines().count() - 1).to_string();
    for number in ["1", &last] {
        std::fs::copy(&file, folder.join("three.toml")).unwrap();
        let adopt = ["counterweight", "front", "three.toml", "--against", "inertia", "--designs", "5"];
        output(&folder, 0, &[&adopt[..], &["--adopt", number, "--write"]].concat());
        let checked = output_json(&folder, 0, &["counterweight", "check", "three.toml", "--format", "json"]);
        for weight in checked["counterweights"].as_array().unwrap() {
            assert!((weight["unbalance"].as_f64().unwrap() / 0.08876 - 1.0).abs() < 1e-8, "{weight}");
        }
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
    let told = design(&["--seed", "3"]);
    assert!(told.contains("--method evolution"), "{told}");
    let export = ["counterweight", "export", &file, "--output", "crank.step", "--facet", "1 mm"];
    assert!(message(&folder, 2, &export).contains("STL and glTF alone"));
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

/// The story of the guide: from the file to STEP in two commands, and the loads are those of the shapes.
#[test]
fn from_the_file_to_step_in_two_commands() {
    let folder = folder("counterweight-story");
    std::fs::copy(three(), folder.join("three.toml")).unwrap();
    output(&folder, 0, &["counterweight", "design", "three.toml", "--write"]);
    output(&folder, 0, &["counterweight", "export", "three.toml", "--output", "crankshaft.step"]);
    let step = std::fs::read_to_string(folder.join("crankshaft.step")).unwrap();
    assert!(step.starts_with("ISO-10303-21;") && step.matches("MANIFOLD_SOLID_BREP").count() == 13, "{step}");

    let checked = output_json(&folder, 0, &["counterweight", "check", "three.toml", "--format", "json"]);
    let body = &checked["crankshafts"][0];
    let amount =
        |vector: &serde_json::Value| vector["x"].as_f64().unwrap().hypot(vector["y"].as_f64().unwrap());
    // The throws stand evenly, and the weights of the ends are opposed: what was wanted is there, and nothing beside it.
    assert!(amount(&body["unbalance"]["unbalance"]) < 1e-10 * 0.08876, "{}", body["unbalance"]);
    assert_eq!(checked["is_kept"], true);
    for weight in checked["counterweights"].as_array().unwrap() {
        assert!((weight["unbalance"].as_f64().unwrap() - 0.08876).abs() < 1e-9 * 0.08876, "{weight}");
    }
    let loads = |file: &str| output_json(&folder, 0, &["loads", file, "--format", "json"]);
    let couple = |loads: &serde_json::Value| {
        let peaks = &loads["total"]["peaks"];
        peaks["couple"]["max"]["value"].as_f64().unwrap_or_else(|| panic!("{peaks}"))
    };
    let [before, after] = [loads(&three()), loads("three.toml")].map(|loads| couple(&loads));
    assert!((before - after).abs() < 1e-8 * before, "{before} {after}");

    // A second design finds the same shapes again.
    let text = std::fs::read_to_string(folder.join("three.toml")).unwrap();
    output(&folder, 0, &["counterweight", "design", "three.toml", "--write"]);
    assert_eq!(std::fs::read_to_string(folder.join("three.toml")).unwrap(), text);
}

/// An outline goes out as DXF and comes back as the same weight.
#[test]
fn an_outline_goes_out_and_comes_back() {
    let folder = folder("counterweight-import");
    std::fs::copy(three(), folder.join("three.toml")).unwrap();
    output(&folder, 0, &["counterweight", "design", "three.toml", "--write"]);
    for ending in ["dxf", "svg"] {
        let drawing = format!("web.{ending}");
        let one = ["counterweight", "export", "three.toml", "--weight", "web 1", "--output", &drawing];
        output(&folder, 0, &one);
        let import = ["counterweight", "import", "three.toml", &drawing, "--weight", "web 2"];
        let imported = output_json(&folder, 0, &[&import[..], &["--format", "json"]].concat());
        let unbalance = &imported["properties"]["unbalance"];
        // The disc is in the outline, and balanced: the same unbalance, but for what the flank of the web shares.
        let amount = unbalance["x"].as_f64().unwrap();
        assert!((amount - 0.08876).abs() < 1e-3 * 0.08876, "{unbalance}");
        let changed = output(&folder, 0, &[&import[..], &["--dry-run"]].concat());
        assert!(changed.contains("+    { x = ") && changed.contains("bulge = "), "{changed}");
    }
    let lost = ["counterweight", "import", "three.toml", "lost.dxf", "--weight", "web 2"];
    assert!(message(&folder, 2, &lost).contains("cannot read lost.dxf"));
}

#[test]
fn a_clearance_that_is_not_kept_is_told() {
    let folder = folder("counterweight-clearance");
    let file =
        std::fs::read_to_string(three()).unwrap().replace("liner_end = \"95 mm\"", "liner_end = \"86 mm\"");
    std::fs::write(folder.join("three.toml"), file).unwrap();
    let text = output(&folder, 1, &["counterweight", "check", "three.toml", "--figures", "figures"]);
    let curve = std::fs::read_to_string(folder.join("figures/clearance.svg")).unwrap();
    assert!(curve.contains("liner 1") && !curve.contains("NaN"));
    assert!(text.contains("overlaps by") && text.contains("which is not kept"), "{text}");
    let csv = ["counterweight", "check", "three.toml", "--format", "csv", "--table", "clearances"];
    assert!(output(&folder, 1, &csv).starts_with("part,against,distance [mm]"));
}

/// The weights that balancing finds on webs weigh what their shapes weigh.
#[test]
fn found_weights_have_a_true_mass() {
    let folder = folder("counterweight-mass");
    // Without anything to stay clear of there is a shape for every weight.
    let text = std::fs::read_to_string(three()).unwrap();
    let (text, _) = text.split_once("# What the turning crankshaft must not touch.").unwrap();
    std::fs::write(folder.join("three.toml"), text).unwrap();
    let ask = ["balance", "three.toml", "--counterweights", "webs"];
    let found = output_json(&folder, 0, &[&ask[..], &["--format", "json"]].concat());
    output(&folder, 0, &[&ask[..], &["--write"]].concat());
    let design = ["counterweight", "design", "three.toml", "--format", "json"];
    let parts = found["as_parts"].as_array().unwrap();
    let designed = output_json(&folder, 0, &design);
    let weights = designed["weights"].as_array().unwrap();
    assert!(parts.len() >= 2, "{parts:?}");
    for part in parts {
        let weight = weights.iter().find(|weight| weight["name"] == part["name"]).unwrap();
        let mass = weight["outcome"]["found"]["design"]["mass"].as_f64().unwrap();
        // The weight is rounded where it is written, and the optimum is proved to a millionth.
        assert!((part["mass"].as_f64().unwrap() / mass - 1.0).abs() < 1e-5, "{part} {mass}");
    }
}
