//! Torque and bearings on the command line.

use crate::program::{folder, lanchester, message, output, output_json};
use std::path::Path;

const FOUR: &str = r#"name = "Four with ideal gas"
speed = ["800 rpm", "6000 rpm"]
[firing]
order = [1, 3, 4, 2]
[layout]
type = "in-line"
cylinders = 4
spacing = "90 mm"
[crank]
stroke = "86 mm"
[piston]
mass = "0.4 kg"
bore = "80 mm"
[rod]
length = "144 mm"
mass = "0.5 kg"
[counterweights]
rotating_share = "100 %"
"#;

const GAS: &str = r#"[gas]
compression_ratio = 10
[gas.cycle]
type = "seiliger"
peak_pressure = "70 bar"
[gas.fuel]
energy = "1.2 kJ"
[gas.intake]
temperature = "40 degC"
"#;

fn written(folder: &Path, text: &str) {
    std::fs::write(folder.join("four.toml"), text).expect("the folder is ours");
}

#[test]
fn torque_is_the_work_over_the_cycle() {
    let folder = folder("torque");
    written(&folder, &format!("{FOUR}{GAS}"));
    let all = ["--fmep", "1.2 bar", "--speeds", "1000 rpm, 2000 rpm, 3000 rpm", "--fluctuation", "2 %"];
    let json = output_json(&folder, 0, &[&["torque", "four.toml", "--format", "json"], &all[..]].concat());
    let number = |pointer: &str| json.pointer(pointer).and_then(serde_json::Value::as_f64).expect("a number");
    let cylinders = json["torque"]["cylinders"].as_array().expect("a list");
    let work: f64 = cylinders.iter().map(|c| c["work"]["by_volume"].as_f64().expect("a number")).sum();
    assert_eq!(cylinders.len(), 4);
    let torque = number("/torque/indicated/torque");
    assert!((torque - work / (4.0 * std::f64::consts::PI)).abs() < 1e-9 * torque);
    // 1.2 bar over the swept volume.
    let lost = 1.2e5 * number("/torque/indicated/displacement") / (4.0 * std::f64::consts::PI);
    assert!((torque - lost - number("/brake/torque")).abs() < 1e-9 * torque);
    assert!(number("/flywheel/flywheel") > 0.0 && number("/power/peak/1") > 0.0);
    let inertia = ["--flywheel", "0.12 kg m2", "--crankshaft-inertia", "0.03 kg m2", "--figures", "figures"];
    let text = output(&folder, 0, &[&["torque", "four.toml"], &inertia[..]].concat());
    assert!(text.contains("Even: every 180 deg.") && text.contains("P  C  I  E"), "{text}");
    assert!(folder.join("figures/strokes.svg").exists() && folder.join("figures/speed-ripple.svg").exists());
    let csv = output(&folder, 0, &["torque", "four.toml", "--format", "csv"]);
    assert_eq!(csv.lines().count(), 721);
    let refused = message(&folder, 2, &["torque", "four.toml", "--speeds", "1000 rpm, 2000 rpm"]);
    assert!(refused.contains("three or more different speeds"), "{refused}");
}

/// The shipped single gives neither flywheel nor crankshaft: no speed is made up, and the keys that are missing are named.
#[test]
fn an_inertia_that_is_not_known_makes_no_speed() {
    let folder = folder("torque-inertia");
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/single-gas.toml");
    let file = std::fs::read_to_string(shipped).expect("it is shipped");
    std::fs::write(folder.join("four.toml"), &file).expect("the folder is ours");
    let text = output(&folder, 0, &["torque", "four.toml"]);
    assert!(
        text.contains("inertia not known") && text.contains("`crankshaft_inertia` to [flywheel]"),
        "{text}"
    );
    let json = output_json(&folder, 0, &["torque", "four.toml", "--format", "json"]);
    for ripple in json["ripples"].as_array().expect("a list") {
        assert_eq!(ripple["outcome"], "incomplete-inertia");
        assert_eq!(ripple["keys"][1], "flywheel.crankshaft_inertia");
        assert!(ripple.get("fluctuation").is_none());
    }
    // Too light an engine stops at idle, and the flywheel that keeps it turning does.
    let light = "[flywheel]\ninertia = \"0 kg m2\"\ncrankshaft_inertia = \"0.001 kg m2\"\n";
    std::fs::write(folder.join("four.toml"), format!("{file}\n{light}")).expect("the folder is ours");
    let json = output_json(&folder, 0, &["torque", "four.toml", "--format", "json"]);
    assert_eq!(
        (&json["ripples"][0]["outcome"], &json["ripples"][0]["key"]),
        (&"stops".into(), &"flywheel.inertia".into())
    );
    let text = output(&folder, 0, &["torque", "four.toml"]);
    assert!(text.contains("the engine stops: the speed falls below 5 % of its mean"), "{text}");
    let enough = json["ripples"][0]["flywheel"].as_f64().expect("a flywheel") * 1.01;
    let option = format!("{enough} kg m2");
    let json = output_json(&folder, 0, &["torque", "four.toml", "--flywheel", &option, "--format", "json"]);
    assert_eq!(json["ripples"][0]["outcome"], "periodic");
    let refused = message(
        &folder,
        2,
        &["sensitivity", "four.toml", "--speed", "1500 rpm", "--output", "speed fluctuation"],
    );
    assert!(refused.contains("the engine stops"), "{refused}");
    // Without gas the file is valid, and the inertia of the piston makes the speed swing.
    let (train, _) = file.split_once("[gas] ").expect("it has gas");
    let heavy = "[flywheel]\ninertia = \"0.01 kg m2\"\ncrankshaft_inertia = \"0.001 kg m2\"\n";
    std::fs::write(folder.join("four.toml"), format!("{train}{heavy}")).expect("the folder is ours");
    let json = output_json(
        &folder,
        0,
        &["sensitivity", "four.toml", "--output", "inertia speed fluctuation", "--format", "json"],
    );
    assert!(json["outputs"][0]["nominal"].as_f64().expect("a number") > 0.001, "{json}");
}

/// The cycle tells what it finds: in text, JSON, CSV and the report, with one set of numbers.
#[test]
fn the_cycle_tells_what_it_finds() {
    let folder = folder("torque-cycle");
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/single-gas.toml");
    std::fs::copy(shipped, folder.join("single.toml")).expect("it is shipped");
    let arguments = ["torque", "single.toml", "--speed", "4000 rpm"];
    let json = output_json(&folder, 0, &[&arguments[..], &["--format", "json"]].concat());
    let number = |pointer: &str| json.pointer(pointer).and_then(serde_json::Value::as_f64).expect("a number");
    let (work, heat) = (number("/cycles/0/work"), number("/cycles/0/heat"));
    assert!((number("/cycles/0/thermal_efficiency") - work / heat).abs() < 1e-6);
    assert!((number("/cycles/0/indicated_efficiency") - 0.96 * work / heat).abs() < 1e-6);
    assert!((0.01..0.2).contains(&number("/cycles/0/exchange/residual_share")));
    assert!((0.05..0.4).contains(&number("/cycles/0/exchange/wall_heat_share")));
    assert!(number("/cycles/0/exchange/energy_residual_share").abs() < 1e-7);
    assert!(number("/cycles/0/exchange/mass_residual_share").abs() < 1e-7);
    let trapped = number("/cycles/0/trapped_mass");
    let count = json["cycles"][0]["trace"]["mass"].as_array().expect("a list").len();
    assert_eq!(count, 720);
    // Heat released and heat to the walls over the angle add up to those of the cycle.
    let sum = |name: &str| {
        let list = json["cycles"][0]["trace"][name].as_array().expect("a list");
        list.iter().filter_map(serde_json::Value::as_f64).sum::<f64>() * std::f64::consts::PI / 180.0
    };
    assert!((sum("heat_release") / heat - 1.0).abs() < 1e-3, "{}", sum("heat_release"));
    assert!((sum("wall_heat") / number("/cycles/0/exchange/wall_heat") - 1.0).abs() < 1e-3);
    assert!((sum("exhaust") / sum("intake") - 1.0).abs() < 1e-2, "what comes in goes out");
    let text = output(&folder, 0, &arguments);
    assert!(
        text.contains("residual gas, of the trapped mass") && text.contains("volumetric efficiency"),
        "{text}"
    );
    let table = output(&folder, 0, &[&arguments[..], &["--table", "cycle", "--format", "csv"]].concat());
    let line = table.lines().find(|line| line.starts_with("trapped mass")).expect("a line");
    let value: f64 = line.rsplit(',').next().and_then(|cell| cell.parse().ok()).expect("a number");
    assert!((value - 1e6 * trapped).abs() < 1e-6 * value, "{line}");
    let over = output(&folder, 0, &[&arguments[..], &["--table", "cycle-angle", "--format", "csv"]].concat());
    assert_eq!(over.lines().count(), 721);
    assert!(
        over.lines()
            .next()
            .is_some_and(|head| head.contains("temperature [K]") && head.contains("mass [mg]"))
    );
    output(&folder, 0, &["report", "single.toml", "--output", "single.html"]);
    let page = std::fs::read_to_string(folder.join("single.html")).expect("it was written");
    let names = names_of(&page);
    for name in ["gas-cycle", "cycle-diagrams", "cycle-temperature", "cycle-mass", "cycle-heat"] {
        assert_eq!(names.iter().filter(|other| **other == name).count(), 1, "{name}: {names:?}");
    }
    // Measured pressures have no cycle.
    let traces = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation/traces/pressure-3000.csv");
    std::fs::copy(traces, folder.join("p.csv")).expect("the traces are shipped");
    written(&folder, &format!("{FOUR}[[gas.trace]]\nfile = \"p.csv\"\n"));
    let refused = message(&folder, 2, &["torque", "four.toml", "--table", "cycle"]);
    assert!(refused.contains("no computed cycle"), "{refused}");
}

#[test]
fn bearings_with_gas_and_without() {
    let folder = folder("bearings");
    written(&folder, &format!("{FOUR}{GAS}"));
    let text = output(&folder, 0, &["bearings", "four.toml", "--figures", "figures"]);
    assert!(text.contains("gas and inertia") && text.contains("peak, bare"), "{text}");
    assert!(text.contains("Largest loads of gas, inertia and both"), "{text}");
    assert!(folder.join("figures/main-5.svg").exists() && folder.join("figures/crankpin-4.svg").exists());
    let csv = output(&folder, 0, &["bearings", "four.toml", "--part", "gas", "--format", "csv"]);
    assert_eq!(csv.lines().count(), 721);
    written(&folder, FOUR);
    let text = output(&folder, 0, &["bearings", "four.toml"]);
    assert!(text.contains("rpm: inertia"), "{text}");
    let refused = message(&folder, 2, &["bearings", "four.toml", "--part", "gas"]);
    assert!(refused.contains("says nothing of the gas"), "{refused}");
}

#[test]
fn bearings_with_oil_films() {
    let folder = folder("bearings-film");
    let sizes = "[bearings.main]\ndiameter = \"55 mm\"\nwidth = \"22 mm\"\n[bearings.crankpin]\ndiameter = \"48 mm\"\nwidth = \"22 mm\"\n";
    written(&folder, &format!("{FOUR}{sizes}"));
    let text = output(&folder, 0, &["bearings", "four.toml", "--film", "gumbel,reynolds", "--samples", "90"]);
    assert!(text.contains("Oil films") && text.contains("big end 4") && text.contains("reynolds"), "{text}");
    assert!(text.contains("diametral clearance where none is given") && text.contains("5W-30"), "{text}");
    let csv = output(&folder, 0, &["bearings", "four.toml", "--film", "--samples", "90", "--format", "csv"]);
    // In the journal's frame, which turns with the crankshaft, the eccentricity has the same size.
    let rows =
        csv.lines().skip(1).map(|row| row.split(',').skip(4).map(|own| own.parse().unwrap()).collect());
    for row in rows.collect::<Vec<Vec<f64>>>() {
        let [angle, x, y, _, u, v] = row[..] else { panic!("{row:?}") };
        let (sin, cos) = angle.to_radians().sin_cos();
        assert!((cos * u - sin * v - x).abs() < 2e-5 && (sin * u + cos * v - y).abs() < 2e-5, "{row:?}");
    }
    assert_eq!(csv.lines().count(), 1 + 9 * 180);
    let speeds = [
        "bearings",
        "four.toml",
        "--film",
        "--speeds",
        "2000 rpm .. 6000 rpm by 4000 rpm",
        "--format",
        "csv",
    ];
    let over = output(&folder, 0, &speeds);
    assert!(over.lines().count() == 3 && over.contains("big end 4"), "{over}");
    // A limit ends with a status, and says which film is the thinnest.
    let asked = ["bearings", "four.toml", "--film", "--samples", "90", "--least-film"];
    output(&folder, 0, &[&asked[..], &["0.01 um"]].concat());
    let thin = lanchester(&folder, &[&asked[..], &["25 um"]].concat());
    assert_eq!(thin.status.code(), Some(1));
    assert!(String::from_utf8(thin.stdout).unwrap().contains("Oil films"));
    let said = String::from_utf8(thin.stderr).unwrap();
    assert!(
        said.contains("the least film is")
            && said.contains("wanted are 25.000 um")
            && said.contains("rpm, gumbel"),
        "{said}"
    );
    let refused = message(&folder, 2, &["bearings", "four.toml", "--least-film", "1 um"]);
    assert!(refused.contains("--film"), "{refused}");
    // A crankshaft that floats needs a body and films that have a table.
    let refused = message(&folder, 2, &["bearings", "four.toml", "--film", "--dynamic"]);
    assert!(refused.contains("[crank.body]"), "{refused}");
    let refused = message(&folder, 2, &["bearings", "four.toml", "--film", "mass-conserving", "--dynamic"]);
    assert!(refused.contains("tables of films"), "{refused}");
    written(&folder, FOUR);
    let refused = message(&folder, 2, &["bearings", "four.toml", "--film"]);
    assert!(refused.contains("diameter and width"), "{refused}");
}

/// Without gas the inertia of pistons and rods alone turns the crank to and fro, and makes its speed swing.
#[test]
fn torque_without_gas_is_that_of_inertia() {
    let folder = folder("torque-without-gas");
    let wheel =
        "\n[flywheel]\ninertia = \"0.1 kg m2\"\ncrankshaft_inertia = \"0.02 kg m2\"\nfluctuation = \"1 %\"\n";
    written(&folder, &format!("{FOUR}{wheel}"));
    let text = output(&folder, 0, &["torque", "four.toml", "--figures", "figures"]);
    assert!(
        text.contains("Inertia alone with the exact lever") && text.contains("for gas add [gas]"),
        "{text}"
    );
    assert!(!text.contains("IMEP") && !text.contains("Pressures:") && !text.contains("brake"), "{text}");
    assert!(
        folder.join("figures/torque.svg").exists() && !folder.join("figures/pressure-volume.svg").exists()
    );
    let json: serde_json::Value =
        serde_json::from_str(&output(&folder, 0, &["torque", "four.toml", "--format", "json"]))
            .expect("JSON");
    let torque = &json["torque"];
    assert_eq!(torque["with_gas"], false);
    assert_eq!(json["power"], serde_json::Value::Null);
    // The torque is that of `loads`, order by order, and nothing else.
    let loads: serde_json::Value =
        serde_json::from_str(&output(&folder, 0, &["loads", "four.toml", "--format", "json"])).expect("JSON");
    let largest = torque["inertia_extremes"]["max"]["value"].as_f64().expect("a number");
    let sampled = loads["total"]["trace"]["shaft_torque"].as_array().expect("a trace");
    let most = sampled.iter().filter_map(|one| one.as_f64()).fold(0.0, f64::max);
    assert!(most > 1.0 && most <= largest * (1.0 + 1e-12) && most > 0.999 * largest, "{most} {largest}");
    // The largest excess energy over inertia times speed squared is the fluctuation, while both are small.
    let ripples = json["ripples"].as_array().expect("a list");
    for ripple in ripples {
        assert_eq!(ripple["outcome"], "periodic", "{ripple}");
        assert_eq!(ripple["load"], 0.0);
        let [exact, simple] =
            ["fluctuation", "simple_fluctuation"].map(|name| ripple[name].as_f64().expect("a number"));
        assert!(exact > 0.0 && (exact / simple - 1.0).abs() < 0.1, "{exact} {simple}");
        // Nothing works on the train: J w^2 stays, so the speed is highest where the inertia is lowest.
        let value =
            |of: &serde_json::Value, end: &str| of["extremes"][end]["value"].as_f64().expect("a number");
        let speeds = value(ripple, "max") / value(ripple, "min");
        let inertias = value(&ripple["inertia"], "max") / value(&ripple["inertia"], "min");
        // The extremes of the inertia are those of samples.
        assert!((speeds - inertias.sqrt()).abs() < 1e-4 * (speeds - 1.0), "{speeds} {inertias}");
    }
    assert!(json["flywheel"]["flywheel"].as_f64().is_some_and(|wheel| wheel >= 0.0), "{}", json["flywheel"]);
    let csv = output(&folder, 0, &["torque", "four.toml", "--format", "csv"]);
    let head = csv.lines().next().expect("a head");
    assert!(head.contains("cylinder 4 inertia [N m]") && !head.contains("pressure"), "{head}");
    let rows: Vec<usize> = csv.lines().map(|line| line.split(',').count()).collect();
    assert!(rows.len() > 300 && rows.iter().all(|count| *count == 12), "{rows:?}");
    let refused = message(&folder, 2, &["torque", "four.toml", "--table", "cycle"]);
    assert!(refused.contains("there is no cycle") && refused.contains("hint: add [gas]"), "{refused}");
    let page = {
        output(&folder, 0, &["report", "four.toml", "--output", "four.html"]);
        std::fs::read_to_string(folder.join("four.html")).expect("the report")
    };
    assert!(
        page.contains("this is the torque of inertia alone") && page.contains("id=\"speed-ripple-table\""),
        "no ripple"
    );
}

#[test]
fn a_crankshaft_without_throws_is_named() {
    let folder = folder("bearings-bare");
    let first = "name = \"Two cranks\"\nstrokes = 2\nspeed = \"6000 rpm\"\n[[crankshaft]]\nname = \"a\"\n";
    let second = "[[crankshaft]]\nname = \"b\"\nratio = -1\ny = \"200 mm\"\n";
    let rest = "[[throw]]\ncrankshaft = 1\nangle = \"0 deg\"\nz = \"0 mm\"\nradius = \"30 mm\"\n\
                [[cylinder]]\nthrow = 1\nangle = \"0 deg\"\n[piston]\nmass = \"0.3 kg\"\n\
                [rod]\nlength = \"120 mm\"\nmass = \"0.3 kg\"\n";
    std::fs::write(folder.join("two.toml"), format!("{first}{second}{rest}")).expect("the folder is ours");
    let text = output(&folder, 0, &["bearings", "two.toml"]);
    assert!(text.contains("Crankshaft 2 has no throw: where its main bearings stand is not known"), "{text}");
    std::fs::write(folder.join("one.toml"), format!("{first}{rest}")).expect("the folder is ours");
    assert!(!output(&folder, 0, &["bearings", "one.toml"]).contains("no throw"));
}

/// Names of everything in a page that has one.
fn names_of(page: &str) -> Vec<&str> {
    page.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect()
}

#[test]
fn the_report_has_torque_and_bearings_where_the_file_has_gas() {
    let folder = folder("report-gas");
    let more = "[flywheel]\ninertia = \"0.05 kg m2\"\ncrankshaft_inertia = \"0.01 kg m2\"\n[bearings.crankpin]\ndiameter = \"48 mm\"\nwidth = \"22 mm\"\n";
    written(&folder, &format!("{FOUR}{GAS}{more}"));
    output(&folder, 0, &["report", "four.toml", "--figures", "figures"]);
    let page = std::fs::read_to_string(folder.join("four.html")).expect("it was written");
    let names = names_of(&page);
    for name in [
        "torque-over-cycle",
        "torque",
        "pressure-volume",
        "torque-orders",
        "strokes",
        "firing-star",
        "speed-ripple",
        "bearings",
        "rod-forces-1",
        "crankpins",
        "main-bearings-polar",
        "main-journals-polar",
        "side-thrust",
    ] {
        assert_eq!(names.iter().filter(|other| **other == name).count(), 1, "{name}: {names:?}");
    }
    let mut unique = names.clone();
    unique.sort_unstable();
    unique.dedup();
    assert_eq!(unique.len(), names.len(), "duplicate name: {names:?}");
    // All four cylinders have the same loads: one picture.
    assert!(page.contains("all cylinders") && !names.contains(&"rod-forces-2"), "{names:?}");
    // An ideal cycle does not know the speed: power over it tells nothing.
    assert!(!names.contains(&"power") && page.contains("MPa"));
    assert!(folder.join("figures/crankpins.svg").exists() && folder.join("figures/strokes.svg").exists());

    written(&folder, FOUR);
    output(&folder, 0, &["report", "four.toml"]);
    let page = std::fs::read_to_string(folder.join("four.html")).expect("it was written");
    assert!(!names_of(&page).iter().any(|name| ["torque-over-cycle", "bearings"].contains(name)));
}

#[test]
fn the_report_of_measured_pressures_has_the_power_over_their_speeds() {
    let folder = folder("report-traces");
    let traces = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation/traces");
    let mut gas = String::new();
    for rpm in [1000, 2000, 3000, 4000] {
        let name = format!("pressure-{rpm}.csv");
        std::fs::copy(traces.join(&name), folder.join(&name)).expect("the traces are shipped");
        gas += &format!("[[gas.trace]]\nfile = \"{name}\"\nspeed = \"{rpm} rpm\"\n");
    }
    let four = FOUR.replace("6000 rpm", "4000 rpm");
    written(&folder, &format!("{four}{gas}"));
    output(&folder, 0, &["report", "four.toml"]);
    let page = std::fs::read_to_string(folder.join("four.html")).expect("it was written");
    assert!(
        names_of(&page).contains(&"power")
            && page.contains("no cyclic speed fluctuation, because the inertia of the flywheel")
    );
    // Torque and bearings are told at the speed asked for.
    output(&folder, 0, &["report", "four.toml", "--speed", "2000 rpm", "--output", "slow.html"]);
    let slow = std::fs::read_to_string(folder.join("slow.html")).expect("it was written");
    assert!(
        page.contains("At 4000\u{a0}rpm the gas gives") && slow.contains("At 2000\u{a0}rpm the gas gives")
    );
    assert!(
        page.contains("At 4000\u{a0}rpm under gas and") && slow.contains("At 2000\u{a0}rpm under gas and")
    );
    // Without one of the files the rest of the report stands, and says what is missing.
    std::fs::remove_file(folder.join("pressure-2000.csv")).expect("it is there");
    let run = lanchester(&folder, &["report", "four.toml"]);
    let said = String::from_utf8(run.stderr).expect("it is text");
    assert!(
        run.status.success()
            && said.contains("torque with gas is left out")
            && said.contains("pressure-2000.csv"),
        "{said}"
    );
    let page = std::fs::read_to_string(folder.join("four.html")).expect("it was written");
    assert!(!names_of(&page).contains(&"bearings") && page.contains("loads of the bearings are left out"));
}
