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
        // What lies within the flank of the web is the web's.
        let on_web = number("unbalance") - weight["shared"].as_f64().unwrap();
        assert!((on_web - 0.08876).abs() < 1e-10, "{design}");
        // Within the crankcase of 100 mm, less 1.5 mm; the liners leave less.
        assert!(number("swept_radius") <= 0.0985, "{design}");
        assert_eq!(weight["room_is_exact"], true);
    }
    let text = output(&folder, 0, &["counterweight", "design", &three()]);
    assert!(text.contains("web 1, web 2, web 5, web 6: the least mass"), "{text}");
    let csv = output(&folder, 0, &["counterweight", "design", &three(), "--format", "csv"]);
    assert!(csv.starts_with("weight,mass [g],") && csv.lines().count() == 2, "{csv}");
}

/// A counterweight has one mass, that which the crankshaft gains, in `design`, `front`, `check` and the sections of the crankshaft; beside it stands what
/// the whole part has.
#[test]
fn one_mass_is_told_of_a_counterweight() {
    let folder = folder("counterweight-masses");
    std::fs::copy(three(), folder.join("three.toml")).unwrap();
    let design = ["counterweight", "design", "three.toml"];
    let designed = output_json(&folder, 0, &[&design[..], &["--format", "json"]].concat());
    let weight = &designed["weights"][0];
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    let (mass, whole) = (number(&weight["on_web"]["mass"]), number(&weight["on_web"]["whole_part"]));
    let own = &weight["outcome"]["found"]["design"];
    let (within, thickness) = (number(&weight["on_web"]["within_web"]), number(&own["thickness"]));
    assert!(within > 0.0 && (number(&own["mass"]) - mass - within).abs() < 1e-12, "{weight}");
    let radius = number(&own["shape"]["web_radius"]);
    let disc = 7850.0 * thickness * std::f64::consts::PI * radius * radius;
    assert!((whole - disc - mass - within).abs() < 1e-9, "{weight}");

    let front = ["counterweight", "front", "three.toml", "--against", "inertia", "--designs", "3"];
    let front = output_json(&folder, 0, &[&front[..], &["--format", "json"]].concat());
    // Both ends are proved to a millionth.
    assert!((number(&front["on_web"][0]["mass"]) / mass - 1.0).abs() < 2e-6, "{}", front["on_web"]);

    output(&folder, 0, &[&design[..], &["--write"]].concat());
    let checked = output_json(&folder, 0, &["counterweight", "check", "three.toml", "--format", "json"]);
    let counterweight = &checked["counterweights"][0];
    assert!((number(&counterweight["mass"]) / mass - 1.0).abs() < 1e-7, "{counterweight}");
    assert!((number(&counterweight["whole_part"]) / whole - 1.0).abs() < 1e-7, "{counterweight}");
    let sections = checked["crankshafts"][0]["sections"].as_array().unwrap();
    let section = sections.iter().find(|one| one["kind"] == "counterweight").unwrap();
    assert!((number(&section["mass"]) / mass - 1.0).abs() < 1e-7, "{section}");
    let export = ["counterweight", "export", "three.toml", "--weight", "web 1", "--output", "web.step"];
    let told = message(&folder, 0, &export);
    assert!(told.contains(&format!("whole part {:.1} g", 1e3 * whole)), "{told}");
}

/// The optimum lies on the envelope of the clearance, and the check proves the same clearance.
#[test]
fn the_best_shape_within_the_envelope_keeps_the_clearance_just_so() {
    let folder = folder("counterweight-envelope");
    std::fs::copy(three(), folder.join("three.toml")).unwrap();
    let design = ["counterweight", "design", "three.toml"];
    let designed = output_json(&folder, 0, &[&design[..], &["--format", "json"]].concat());
    let weight = &designed["weights"][0];
    let mass = weight["on_web"]["mass"].as_f64().unwrap();
    // Within the circle of 92.5 mm that keeps any shape clear it was 1.6053 kg; without any clearance it is 1.29 kg.
    assert!(mass < 1.605 && mass > weight["without_room"].as_f64().unwrap(), "{weight}");
    output(&folder, 0, &[&design[..], &["--write"]].concat());
    let checked = output_json(&folder, 0, &["counterweight", "check", "three.toml", "--format", "json"]);
    let bodies = checked["clearances"]["bodies"].as_array().unwrap();
    let own = bodies.iter().find(|body| body["name"] == "web 1").unwrap();
    let distances = own["clearances"].as_array().unwrap().iter();
    let distances = distances.filter(|one| one["obstacle"]["kind"] != "big-end-side");
    let least = distances.map(|one| one["distance"].as_f64().unwrap()).fold(f64::INFINITY, f64::min);
    assert!((least - 1.5e-3).abs() < 1e-6, "{least}");
}

/// The optimum whose weights are bounded by what fits can be built at once.
#[test]
fn the_optimum_of_what_fits_can_be_built() {
    let folder = folder("counterweight-what-fits");
    std::fs::copy(three(), folder.join("three.toml")).unwrap();
    let found = output_json(&folder, 0, &["balance", "three.toml", "--format", "json"]);
    let bounds = found["web_bounds"].as_array().unwrap();
    assert_eq!(bounds.len(), 4, "{found}");
    for (bound, weight) in bounds.iter().zip(found["weights"].as_array().unwrap()) {
        assert_eq!(bound["name"], weight["name"]);
        let part = |index: usize| weight["unbalance"][index].as_f64().unwrap();
        assert!(part(0).hypot(part(1)) <= bound["most"].as_f64().unwrap() * (1.0 + 1e-6), "{weight} {bound}");
        assert_eq!(bound["is_default"], true);
        assert!(!bound["limits"].as_array().unwrap().is_empty(), "{bound}");
    }
    let text = output(&folder, 0, &["balance", "three.toml", "--most", "what fits"]);
    assert!(text.contains("What fits on the webs") && text.contains("clearance to piston"), "{text}");
    output(&folder, 0, &["balance", "three.toml", "--write"]);
    output(&folder, 0, &["counterweight", "design", "three.toml", "--write"]);
    let checked = output_json(&folder, 0, &["counterweight", "check", "three.toml", "--format", "json"]);
    assert_eq!(checked["is_kept"], true);
    for weight in checked["counterweights"].as_array().unwrap() {
        assert_eq!(weight["is_met"], true, "{weight}");
    }
    // As much as fits, and not a hundredth more.
    let most = bounds[0]["most"].as_f64().unwrap();
    let design = |factor: f64, status: i32| {
        let unbalance = format!("{:.9} kg m", factor * most);
        let angle = bounds[0]["direction"].as_f64().unwrap();
        assert!(angle.is_finite());
        let asked = ["counterweight", "design", "three.toml", "--weight", "web 1", "--unbalance", &unbalance];
        output(&folder, status, &asked)
    };
    design(1.0, 0);
    design(1.01, 1);
    let plain = examples().join("in-line-3.toml").display().to_string();
    let told = message(&folder, 2, &["balance", &plain, "--most", "what fits"]);
    assert!(told.contains("what fits") && told.contains("[counterweight_design]"), "{told}");
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
    let text = output(&folder, 0, &front);
    assert!(text.contains("all shapes searched keep 1.50 mm of clearance"), "{text}");
    assert!(text.contains("below piston 1, at 92.50 mm"), "{text}");
    output(&folder, 0, &[&front[..], &["--adopt", "2", "--figures", "figures"]].concat());
    for figure in ["counterweight-front.svg", "counterweight-web-5-web-6.svg"] {
        let svg = std::fs::read_to_string(folder.join("figures").join(figure)).unwrap();
        assert!(svg.starts_with("<svg") && !svg.contains("NaN"), "{figure}");
    }
    // An adopted design makes up for what it shares with the flank of its web, also at both ends.
    let last = (csv.lines().count() - 1).to_string();
    for number in ["1", "2", &last] {
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
