//! The commands of the workshop that are about a crank: factor, bobweight, crank, external, internal.

use crate::program::{examples, folder, lanchester};
use std::fs;

fn sheet(name: &str) -> String {
    examples().join("workshop").join(name).display().to_string()
}

/// Standard output and standard error of a run that must end with `status`.
fn run(status: i32, arguments: &[&str]) -> (String, String) {
    let output = lanchester(&examples(), &[&["workshop"], arguments].concat());
    let (out, err) = (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap());
    assert_eq!(output.status.code(), Some(status), "{arguments:?}\n{out}\n{err}");
    (out, err)
}

fn json(arguments: &[&str]) -> serde_json::Value {
    let out = run(0, &[arguments, &["--format", "json"]].concat()).0;
    serde_json::from_str(&out).unwrap()
}

const V8: &str = "engines/v8-crossplane.toml";

/// By hand: 2 (370 + 40) + 4 + (180 + 430 + 140 + 46 + 4) = 1624 g.
#[test]
fn bobweights_of_the_example_sheets() {
    let answer = json(&["bobweight", &sheet("v8-bobweight.toml")]);
    let masses: Vec<f64> =
        answer["bobweights"].as_array().unwrap().iter().map(|b| b["mass"].as_f64().unwrap()).collect();
    assert!(masses.len() == 4 && masses.iter().all(|m| (m - 1.624).abs() < 1e-12), "{masses:?}");
    let (text, said) = run(0, &["bobweight", &sheet("v6-90-odd-bobweight.toml")]);
    assert!(said.is_empty(), "{said}");
    for part in ["1715.0", "1714.3", "first-order couple of the engine", "optimum"] {
        assert!(text.contains(part), "{part}\n{text}");
    }
    let csv = run(0, &["bobweight", &sheet("v8-bobweight.toml"), "--format", "csv"]).0;
    assert!(csv.contains("bobweight [g]") && csv.contains("1624"), "{csv}");
}

#[test]
fn factors_convert_on_the_command_line() {
    let of = |option: &str, value: &str| {
        let answer = json(&["factor", &sheet(V8), option, value]);
        answer["throws"][0]["reciprocating_share"].as_f64().unwrap()
    };
    assert!((of("--reciprocating-share", "40%") - 0.4).abs() < 1e-12);
    // 2 * 410 g and 40 % of 2 * 800 g.
    assert!((of("--bobweight", "1460 g") - 0.4).abs() < 1e-12);
    assert!((of("--bobweight-share", "0.603305785123967") - 0.4).abs() < 1e-12);
    let text = run(0, &["factor", &sheet(V8), "--oil", "20 g", "--wet-share", "0.5"]).0;
    assert!(text.contains("oil counted as rotating") && text.contains("wet"), "{text}");
}

#[test]
fn the_ellipse_is_written_and_an_engine_file_never() {
    let folder = folder("ellipse");
    let _ = fs::remove_dir_all(&folder);
    let figure = folder.join("ellipse.svg").display().to_string();
    run(0, &["factor", &sheet(V8), "--figure", &figure]);
    assert!(fs::read_to_string(&figure).unwrap().contains("The primary ellipse"));
    let said = run(2, &["factor", &sheet(V8), "--figure", &sheet(V8)]).1;
    assert!(said.contains("not overwritten"), "{said}");
}

/// 4 g of oil on pins 95.25 mm of throw: the file's counterweights lack it, so the crank has its couple.
#[test]
fn the_crank_on_the_machine() {
    let answer = json(&["crank", &sheet(V8), "--sheet", &sheet("v8-bobweight.toml")]);
    let couple = answer["couple_unbalance"].as_array().unwrap();
    let [x, y] = [0, 1].map(|k| couple[k].as_f64().unwrap());
    // Throws at 0, 90, 270, 180 deg, 111 mm apart: |SUM z e^{ia}| = 111 mm sqrt(10).
    let wanted = 0.004 * 0.0381 * 0.111 * 10f64.sqrt();
    assert!((x.hypot(y) - wanted).abs() < 1e-12, "{x} {y} {wanted}");
    let text = run(0, &["crank", &sheet(V8), "--sheet", &sheet("v8-bobweight.toml")]).0;
    assert!(text.contains("tilt of the principal axis") && text.contains("couple: "), "{text}");
    // With the default 50 % the file's crank is in balance in any planes.
    let plain = run(0, &["crank", &sheet(V8), "--planes", "a=-100 mm, b=120 mm"]).0;
    assert!(plain.contains("static unbalance                        0 g mm"), "{plain}");
    assert!(plain.contains("couple unbalance about z = 0            0 kg mm2"), "{plain}");
}

#[test]
fn weights_outside_and_slugs_inside() {
    let planes = "damper=-290 mm, flywheel=330 mm";
    let text = run(0, &["external", &sheet(V8), "--planes", planes, "--keep", "70%"]).0;
    // By hand: 30 % of 104 544 g mm (V8 by formula sqrt(10) * 111 mm) over 620 mm.
    assert!((0.3 * 104_544.0 * 10f64.sqrt() * 111.0 / 620.0 - 17_756.0).abs() < 1.0);
    assert!(text.contains("17\u{a0}756"), "{text}");
    // 17 756 g mm at 71 mm are 250.1 g.
    let planes = "damper=-290 mm @ 71 mm, flywheel=330 mm";
    let text = run(0, &["external", &sheet(V8), "--planes", planes, "--keep", "70%"]).0;
    assert!(text.contains("71.0  250.1"), "{text}");
    // By hand: 6005 g mm * 620 mm / 399 mm = 9331 g mm in each counterweight; two slugs side by side stand
    // asin(28.4/136) = 12.05 deg off: 9331 / (2 cos 12.05 deg) = 4771 of the 6621 g mm that 21 mm gain: 15.13 mm.
    let text = run(0, &["internal", &sheet("v8-slugs.toml")]).0;
    assert!(text.contains("all of it") && text.contains("15.13"), "{text}");
    // A sheet about another engine is used, and told of.
    let of_v8 = ["crank", &sheet(V8), "--sheet", &sheet("v8-bobweight.toml")];
    assert_eq!(run(0, &of_v8).1, "");
    let other = sheet("engines/v6-90-odd.toml");
    let said =
        lanchester(&examples(), &["workshop", "crank", &other, "--sheet", &sheet("v8-bobweight.toml")]);
    assert!(String::from_utf8(said.stderr).unwrap().contains("v8-crossplane.toml, and the engine given is"));
    let small = fs::read_to_string(sheet("v8-slugs.toml")).unwrap().replace("25.4 mm", "9 mm");
    let file = folder("small-slugs").join("sheet.toml");
    fs::write(&file, small).unwrap();
    let text = run(1, &["internal", &file.display().to_string()]).0;
    assert!(text.contains("not enough room") && text.contains("static unbalance left"), "{text}");
}

#[test]
fn bad_input_says_what_to_do() {
    let v8 = sheet(V8);
    for (arguments, says) in [
        (vec!["factor", &v8, "--reciprocating-share", "50"], "write 50% or 0.5"),
        (vec!["factor", &v8, "--bobweight", "1500"], "needs a mass with its unit"),
        (vec!["factor", &v8, "--axis-ratio", "wide"], "--axis-ratio needs a number"),
        (vec!["factor", &v8, "--angle", "30 deg", "--least-peak"], "on the side away from the throw"),
        (vec!["crank", &v8, "--planes", "front=-180 mm"], "--planes needs two planes"),
        (vec!["crank", &v8, "--planes", "a=10 mm, b=10 mm"], "different from 0"),
        (vec!["crank", &v8, "--crankshaft", "2"], "there is no crankshaft 2"),
        (vec!["crank", &v8, "--crankshaft", "0"], "there is no crankshaft 0"),
        (vec!["external", &v8, "--planes", "a=-1 m @ 0 mm, b=1 m"], "above 0, got 0"),
        (vec!["crank", &v8, "--planes", "a=-1 m @ 10 mm, b=1 m"], "has no radii"),
        (vec!["external", &v8, "--planes", "a=-1 m, b=1 m", "--keep", "1.5"], "from 0 to 1, got 1.5"),
        (vec!["bobweight", &v8], "unknown key"),
        (vec!["internal", &sheet("v8-bobweight.toml")], "an external weight is needed"),
        (vec!["bobweight", &sheet("v8-slugs.toml")], "[parts]"),
    ] {
        let said = run(2, &arguments).1;
        assert!(said.contains(says) && said.contains("hint:"), "{arguments:?}\n{said}");
    }
    // What a sheet alone looks right, and its engine or its metal does not allow.
    let changed = |name: &str, from: &str, to: &str| {
        let text = fs::read_to_string(sheet(name)).unwrap();
        assert!(text.contains(from), "{from}");
        let engines = format!("engine = \"{}/", sheet("engines"));
        let text = text.replace(from, to).replace("engine = \"engines/", &engines);
        let file = folder("changed-sheet").join("sheet.toml");
        fs::write(&file, text).unwrap();
        file.display().to_string()
    };
    let (v8, v6, slugs) = ("v8-bobweight.toml", "v6-90-odd-bobweight.toml", "v8-slugs.toml");
    for (command, name, from, to, says) in [
        ("bobweight", v8, "pins = 4", "pins = 5", "stands for throw 5, but the engine has 4"),
        ("bobweight", v8, "pins = 4", "pins = 3", "throw 4 of the engine needs a pin in the sheet"),
        ("bobweight", v8, "rods = 2", "rods = 1", "as many rods as throw 1 of the engine, 2, got 1"),
        ("bobweight", v6, "throw = 3", "throw = 4", "throw 3 of the engine needs a pin in the sheet"),
        ("bobweight", v8, "pins = 4", "reciprocating_share = 50\npins = 4", "must be from 0 to 2, got 50"),
        ("bobweight", v8, "v8-crossplane.toml", "v9.toml", "v9.toml"),
        ("internal", slugs, "rim = \"86 mm\"", "rim = \"80 mm\"", "rim radius [m] of the slugs"),
        ("internal", slugs, "17 g/cm3", "7 g/cm3", "above that of the crank"),
        ("internal", slugs, "17 g/cm3", "170 g/cm3", "that of osmium"),
        ("internal", slugs, "radius = \"68 mm\"", "radius = \"20 mm\"", "at most the radius of its axis"),
        ("internal", slugs, "radius = \"68 mm\"\n", "", "z and radius of plane"),
        ("internal", slugs, "199.5 mm", "0 mm", "different from 0"),
        ("internal", slugs, "angle = \"18.4 deg\"", "angle = \"18.4\"", "unit missing"),
        ("internal", slugs, "sector = \"100 deg\"", "sector = \"200 deg\"", "from 0 to pi"),
    ] {
        let said = run(2, &[command, &changed(name, from, to)]).1;
        assert!(said.contains(says) && said.contains("hint:"), "{from} -> {to}\n{said}");
    }
    // Two definitions at once are refused by the command line itself.
    run(2, &["factor", v8, "--least-peak", "--total-share", "0.7"]);
}
