//! Engine files read, shown, computed and reported.

use crate::program::{examples, folder, lanchester, message, output, output_json, piped, twin};
use std::fs;

#[test]
fn every_template_is_valid_and_comes_back_as_it_was_listed() {
    let folder = folder("templates");
    let list = output(&folder, 0, &["new", "--list", "--format", "csv"]);
    let names: Vec<&str> = list.lines().skip(1).map(|line| line.split(',').next().unwrap()).collect();
    assert!(names.len() >= 24, "{} layouts", names.len());
    for name in names {
        let file = format!("{name}.toml");
        output(&folder, 0, &["new", name, "--output", &file]);
        let said = output(&folder, 0, &["check", &file]);
        assert!(said.starts_with(&format!("{file}: valid: ")), "{said}");
    }
}

#[test]
fn a_new_file_names_the_schema_beside_it() {
    let folder = folder("new-schema");
    let (engine, schema) = (folder.join("four.toml"), folder.join("lanchester.schema.json"));
    let read = |path: &std::path::Path| fs::read_to_string(path).unwrap();
    assert_eq!(output(&folder, 0, &["new", "in-line-4", "--output", "four.toml"]), "four.toml\n");
    assert!(read(&engine).starts_with("#:schema ./lanchester.schema.json\n"));
    let whole = output(&folder, 0, &["schema"]);
    assert_eq!(read(&schema), whole);
    assert!(whole.contains("\"$id\": \"urn:lanchester:engine-file:"), "{}", &whole[..200]);
    assert!(output(&folder, 0, &["check", "four.toml"]).contains("valid"));
    // One of an earlier version is made anew, somebody else's is left alone, and who wants none has none.
    fs::write(&schema, "{ \"$id\": \"urn:lanchester:engine-file:0.0.1\" }").unwrap();
    output(&folder, 0, &["new", "in-line-3", "--output", "three.toml"]);
    assert_eq!(read(&schema), whole);
    fs::write(&schema, "mine").unwrap();
    let told = lanchester(&folder, &["new", "in-line-6", "--output", "six.toml"]);
    assert!(told.status.success() && String::from_utf8_lossy(&told.stderr).contains("left alone"));
    assert_eq!(read(&schema), "mine");
    output(&folder, 0, &["new", "v6-60", "--no-schema", "--output", "v6.toml"]);
    assert_eq!(read(&folder.join("v6.toml")), output(&folder, 0, &["new", "v6-60"]));
}

#[test]
fn a_users_file_is_never_overwritten() {
    let folder = folder("overwrite");
    fs::write(folder.join("mine.toml"), "name = \"mine\"").unwrap();
    let said = message(&folder, 2, &["new", "in-line-4", "--output", "mine.toml"]);
    assert!(said.contains("not overwritten") && said.contains("hint:"), "{said}");
    for target in ["mine.toml", "./mine.toml", "other.toml"] {
        let said = message(&folder, 2, &["report", &twin(), "--output", target]);
        assert!(said.contains("engine file"), "{said}");
    }
    fs::copy(twin(), folder.join("engine.txt")).unwrap();
    let said = message(&folder, 2, &["show", "engine.txt", "--drawing", "engine.txt"]);
    assert!(said.contains("not overwritten"), "{said}");
    assert_eq!(fs::read_to_string(folder.join("mine.toml")).unwrap(), "name = \"mine\"");
}

#[test]
fn all_mistakes_at_once_with_their_places() {
    let folder = folder("mistakes");
    let text = fs::read_to_string(twin()).unwrap();
    let wrong = text
        .replace("mass = \"0.7754 kg\"", "mass = \"0,7754 kg\"")
        .replace("[rod]", "[rod]\nlenght = \"3 mm\"");
    assert_ne!(wrong, text);
    fs::write(folder.join("wrong.toml"), wrong).unwrap();
    let output = lanchester(&folder, &["check", "wrong.toml"]);
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2));
    for expected in ["0,7754 kg", "0.7754 kg", "lenght", "length", "wrong.toml:"] {
        assert!(said.contains(expected), "`{expected}` is missing in:\n{said}");
    }
    let said = output_json(&folder, 2, &["check", "wrong.toml", "--format", "json"]);
    assert_eq!(said[0]["diagnostics"].as_array().unwrap().len(), 2, "{said}");
    assert_eq!(message(&folder, 2, &["loads", "wrong.toml"]).matches("error").count(), 2);
}

#[test]
fn the_shown_general_form_has_the_same_loads() {
    let folder = folder("show");
    for name in ["twin-boxer-in-phase", "in-line-3", "v6-60"] {
        let file = examples().join(format!("{name}.toml")).display().to_string();
        fs::write(folder.join("general.toml"), output(&folder, 0, &["show", &file])).unwrap();
        let short = output_json(&folder, 0, &["loads", &file, "--format", "json"]);
        let general = output_json(&folder, 0, &["loads", "general.toml", "--format", "json"]);
        assert_eq!(short["total"], general["total"], "{name}");
    }
    output(&folder, 0, &["show", &twin(), "--drawing", "drawn/twin.svg"]);
    assert!(fs::read_to_string(folder.join("drawn/twin.svg")).unwrap().starts_with("<svg"));
    assert!(output(&folder, 0, &["show", &twin(), "--format", "csv"]).lines().count() == 3);
}

#[test]
fn loads_in_the_convention_of_the_twin_thesis() {
    let folder = folder("loads");
    // Louvigny 2008, Table 17 case 1: 21973 N; Table 40 the same.
    let loads = output_json(
        &folder,
        0,
        &["loads", &twin(), "--series", "power:4:5", "--grid", "360", "--format", "json"],
    );
    let force = loads["total"]["peaks"]["force"]["max"]["value"].as_f64().unwrap();
    assert_eq!(force.round(), 21973.0);
    let orders = output(&folder, 0, &["loads", &twin(), "--format", "csv", "--orders", "4"]);
    assert_eq!(
        orders.lines().filter(|line| line.starts_with("total,")).count(),
        5,
        "orders 0 to 4:\n{orders}"
    );
    let trace = output(&folder, 0, &["loads", &twin(), "--format", "csv", "--table", "trace"]);
    assert_eq!(trace.lines().count(), 721);
    let motion = output(&folder, 0, &["loads", &twin(), "--format", "csv", "--table", "motion"]);
    let top: Vec<f64> = motion.lines().nth(1).unwrap().split(',').map(|cell| cell.parse().unwrap()).collect();
    // Louvigny 2008, Table 1: at top dead centre the pin stands at r + l and does not move.
    assert!((top[1] - (0.04775 + 0.144)).abs() < 1e-12 && top[2].abs() < 1e-9, "{top:?}");
    // A couple about another point is the force times the distance.
    let moved =
        output_json(&folder, 0, &["loads", &twin(), "--about", "0 mm, 0 mm, -100 mm", "--format", "json"]);
    let (force, couple) =
        (&moved["total"]["peaks"]["force_x"]["max"], &moved["total"]["peaks"]["couple_y"]["max"]);
    let lever = couple["value"].as_f64().unwrap() / force["value"].as_f64().unwrap();
    assert!((lever - 0.1).abs() < 1e-9, "lever {lever}");
}

#[test]
fn wrong_options_say_what_is_needed() {
    let folder = folder("options");
    for (arguments, expected) in [
        (&["loads", "TWIN", "--speed", "4000"][..], "rpm"),
        (&["loads", "TWIN", "--speed", "4 m"], "speed"),
        (&["loads", "TWIN", "--speed", "-4 rpm"], "more than 0"),
        (&["loads", "TWIN", "--about", "1 mm, 2 mm"], "three coordinates"),
        (&["loads", "TWIN", "--series", "taylor"], "power:N:P"),
        (&["loads", "TWIN", "--grid", "0"], "peak grid"),
        (&["loads", "TWIN", "--orders", "0"], "highest order"),
        (&["loads", "no-such-file.toml"], "lanchester new"),
        (&["new", "inline4"], "in-line-4"),
        (&["validate", "no such source"], "without a filter"),
        (&["loads", "TWIN", "--table", "trace", "--format", "json"], "--format csv"),
    ] {
        let arguments: Vec<String> = arguments.iter().map(|word| word.replace("TWIN", &twin())).collect();
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        let said = message(&folder, 2, &arguments);
        assert!(said.contains(expected) && said.contains("hint:"), "`{expected}` is missing in:\n{said}");
    }
}

#[test]
fn standard_input_and_output() {
    let folder = folder("pipes");
    let run = |arguments: &[&str], text: &[u8]| piped(&folder, arguments, text);
    let text = fs::read_to_string(twin()).unwrap();
    // Byte order mark and CRLF are what some editors write.
    let windows = format!("\u{feff}{}", text.replace('\n', "\r\n"));
    let plain = run(&["loads", "-", "--format", "csv"], text.as_bytes());
    assert_eq!(plain.stdout, run(&["loads", "-", "--format", "csv"], windows.as_bytes()).stdout);
    assert!(plain.status.success() && !plain.stdout.is_empty());
    let page = run(&["report", "-", "--output", "-"], text.as_bytes());
    assert!(page.stdout.starts_with(b"<!DOCTYPE html>") || page.stdout.starts_with(b"<!doctype html>"));
    let binary = run(&["check", "-"], b"name = \"\xff\xfe\"");
    assert_eq!(binary.status.code(), Some(2));
    assert!(String::from_utf8(binary.stderr).unwrap().contains("UTF-8"));
}

#[test]
fn report_writes_the_page_and_its_figures() {
    let folder = folder("report");
    assert_eq!(output(&folder, 0, &["report", &twin()]).trim(), "twin-in-line-in-phase.html");
    let page = fs::read_to_string(folder.join("twin-in-line-in-phase.html")).unwrap();
    assert!(page.contains("FNV-1a") && page.contains("4000 rpm"));
    for outside in ["http://", "https://", "src=\"", "<script", "@import", "url("] {
        let found = page.matches(outside).count()
            - page.matches("http://www.w3.org/2000/svg").count() * usize::from(outside == "http://");
        assert_eq!(found, 0, "`{outside}` would need a network");
    }
    let written =
        output(&folder, 0, &["report", &twin(), "--output", "out/page.html", "--figures", "out/figures"]);
    assert!(written.lines().count() > 5, "{written}");
    for line in written.lines() {
        assert!(folder.join(line).is_file(), "{line}");
    }
}

#[test]
fn validate_ends_with_0_and_speaks_every_format() {
    let folder = folder("validate");
    // The whole is held by the crate's own tests and by the generated page.
    assert!(output(&folder, 0, &["validate", "balancing"]).contains("every verdict is the expected one"));
    let rows = output(&folder, 0, &["validate", "twin", "--format", "csv"]).lines().count();
    assert!(rows > 500, "{rows} rows");
    let json = output_json(&folder, 0, &["validate", "mechanisms", "--format", "json"]);
    assert_eq!(json["sources"].as_array().unwrap().len(), 1);
}

#[test]
fn validate_draws_figures_of_the_sources_and_writes_numbers_for_other_programs() {
    let folder = folder("validate-figures");
    let figure = "twin-cylinder-thesis Figure 18";
    let said = output(&folder, 0, &["validate", figure, "--figures", "atlas"]);
    assert!(said.contains("1  drawn"), "{said}");
    let read = |name: &str| fs::read_to_string(folder.join(name)).unwrap();
    assert!(read("atlas/twin-thesis-figure-18.svg").contains("total F<tspan"));
    assert!(read("atlas/twin-thesis-figure-18.csv").lines().count() > 2000);
    assert!(read("atlas/index.html").contains("<img src=\"twin-thesis-figure-18.svg\""));
    assert!(message(&folder, 2, &["validate", "no such figure", "--figures", "atlas"]).contains("Figure 18"));

    let said = output(&folder, 0, &["validate", "Table 36", "--suite", "suite.json"]);
    assert_eq!(said, "9 rows, 1 engines, version 1\n");
    let suite: serde_json::Value = serde_json::from_str(&read("suite.json")).unwrap();
    assert_eq!(suite["rows"][0]["expected"]["value"], 11587.78);
    assert_eq!(suite["engines"]["engine 1"]["cylinders"].as_array().unwrap().len(), 4);
    assert!(
        message(&folder, 2, &["validate", "no such table", "--suite", "suite.json"]).contains("no source")
    );
    let schema = output_json(&folder, 0, &["schema", "--suite"]);
    assert_eq!(schema["title"], "Suite");
}

#[test]
fn an_option_that_would_be_ignored_is_refused() {
    let folder = folder("ignored");
    for arguments in [
        &["new", "in-line-4", "--format", "json"][..],
        &["loads", &twin(), "--table", "trace"],
        &["validate", "--verbose", "--format", "csv"],
        &["validate", "--markdown", "--format", "csv"],
        &["validate", "--figures", "atlas", "--format", "csv"],
        &["validate", "--suite", "suite.json", "--format", "csv"],
    ] {
        assert!(message(&folder, 2, arguments).contains("--format"), "{arguments:?}");
    }
}

#[test]
fn report_shows_the_optimum_where_the_file_asks() {
    let folder = folder("report-optimum");
    let text = fs::read_to_string(twin()).unwrap();
    let page = |name: &str, more: &str| {
        fs::write(folder.join(name), format!("{text}{more}")).unwrap();
        let written = output(&folder, 0, &["report", name, "--figures", name.trim_end_matches(".toml")]);
        let page = fs::read_to_string(folder.join(name.replace(".toml", ".html"))).unwrap();
        (page, written.contains("optimum.svg") && written.contains("optimum-crank-view.svg"))
    };
    let (silent, drawn) = page("silent.toml", "");
    assert!(!silent.contains("id=\"optimum\"") && !drawn);
    let section = "\n[balance]\nminimise = [\"force\"]\n\n[[balance.counterweight]]\nthrow = 1\n";
    let (asking, drawn) = page("asking.toml", section);
    assert!(drawn);
    let said = output(&folder, 0, &["balance", "asking.toml", "--format", "csv", "--table", "stages"]);
    let value: f64 = said.lines().nth(1).unwrap().split(',').nth(2).unwrap().parse().unwrap();
    let section = &asking[asking.find("<section id=\"optimum\"").unwrap()..];
    let section = &section[..section.find("</section>").unwrap()];
    assert!(section.contains("The minimum achievable with these devices") && section.contains("The proof"));
    assert!(section.contains("First order: throws against all devices, at the optimum"));
    // As the page shows it: five digits.
    let digits = format!("{value:.0}");
    let plain: String = section.chars().filter(|letter| !letter.is_whitespace()).collect();
    assert!(plain.contains(&digits), "{digits}");
}

#[test]
fn the_gas_of_a_file_is_checked_with_its_traces() {
    let folder = folder("gas");
    let text = fs::read_to_string(twin()).unwrap();
    let gas = "\n[gas]\n[[gas.trace]]\nfile = \"pressure.csv\"\n";
    fs::write(folder.join("twin.toml"), format!("{text}{gas}")).unwrap();
    let refused = lanchester(&folder, &["check", "twin.toml"]);
    let said = String::from_utf8(refused.stderr).unwrap();
    assert_eq!(refused.status.code(), Some(2));
    assert!(said.contains("cannot read") && said.contains("pressure.csv"), "{said}");
    let trace = |end: i32| {
        let lines = (0..=end).map(|degrees| {
            let half = (f64::from(degrees) - 10.0).to_radians() / 4.0;
            format!("{degrees},{}\n", 1.0 + 60.0 * half.cos().powi(60))
        });
        format!("theta [deg],p [bar]\n{}", lines.collect::<String>())
    };
    fs::write(folder.join("pressure.csv"), trace(360)).unwrap();
    let said = output_json(&folder, 2, &["check", "twin.toml", "--format", "json"]);
    let gap = said[0]["gas"][0].as_str().unwrap();
    assert!(
        gap.contains("nothing between 360.0000 deg and 720.0000 deg") && said[0]["valid"] == false,
        "{gap}"
    );
    fs::write(folder.join("pressure.csv"), trace(720)).unwrap();
    assert!(output(&folder, 0, &["check", "twin.toml"]).contains("valid"));
}
