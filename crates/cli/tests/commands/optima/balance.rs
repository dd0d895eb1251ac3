//! Optima found, shown and written back.

use crate::program::{example, folder, lanchester, message, output, output_json, piped, twin};
use std::fs;
use std::path::Path;

fn template(folder: &Path, name: &str) -> String {
    let file = format!("{name}.toml");
    output(folder, 0, &["new", name, "--no-schema", "--output", &file]);
    file
}

fn reached(answer: &serde_json::Value, stage: usize) -> f64 {
    answer["stages"][stage]["value"].as_f64().unwrap()
}

#[test]
fn what_is_written_is_the_optimum_and_nothing_else_changes() {
    let folder = folder("balance-write");
    for name in ["twin-360", "in-line-3-shaft", "v6-60", "v8-crossplane"] {
        let file = template(&folder, name);
        let path = folder.join(&file);
        let text = fs::read_to_string(&path).unwrap().replacen("[crank]", "[crank] # forged", 1);
        fs::write(&path, &text).unwrap();
        let request = ["balance", &file, "--format", "json"];
        let found = output_json(&folder, 0, &request);

        let difference = output(&folder, 0, &["balance", &file, "--dry-run"]);
        assert_eq!(fs::read_to_string(&path).unwrap(), text, "{name}: --dry-run changes nothing");
        assert!(difference.lines().any(|line| line.starts_with('+')), "{name}: {difference}");

        assert_eq!(output_json(&folder, 0, &[&request[..], &["--write"]].concat()), found, "{name}");
        let written = fs::read_to_string(&path).unwrap();
        assert!(written.contains("[crank] # forged"), "{name}");
        for line in difference.lines().filter(|line| line.starts_with('+') && !line.starts_with("+++")) {
            assert!(written.contains(&line[1..]), "{name}: {line}");
        }
        let peak = output_json(&folder, 0, &["loads", &file, "--format", "json"])["total"]["peaks"]["force"]
            ["max"]["value"]
            .as_f64()
            .unwrap();
        // Written amounts are within 1e-11 of the found ones: so are the forces of the weights.
        let square = found["speed"].as_f64().unwrap().powi(2);
        let amount = |weight: &serde_json::Value| -> f64 {
            weight["unbalance"].as_array().unwrap().iter().map(|part| part.as_f64().unwrap().abs()).sum()
        };
        let weights: f64 = found["weights"].as_array().unwrap().iter().map(amount).sum();
        let tolerance = 1e-11 * square * weights + 1e-10 * peak;
        assert!((peak - reached(&found, 0)).abs() <= tolerance, "{name}: {peak}");
    }
}

#[test]
fn a_second_run_leaves_the_file_as_it_is() {
    let folder = folder("balance-again");
    let file = template(&folder, "twin-360");
    output(&folder, 0, &["balance", &file, "--write"]);
    let once = fs::read_to_string(folder.join(&file)).unwrap();
    let again = lanchester(&folder, &["balance", &file, "--dry-run"]);
    assert!(again.stdout.is_empty(), "{}", String::from_utf8_lossy(&again.stdout));
    assert!(String::from_utf8_lossy(&again.stderr).contains("already"), "said that nothing changes");
    output(&folder, 0, &["balance", &file, "--write"]);
    assert_eq!(fs::read_to_string(folder.join(&file)).unwrap(), once);
}

#[test]
fn a_file_that_cannot_be_written_is_left_whole() {
    let folder = folder("balance-refused");
    let file = template(&folder, "twin-360");
    let text = fs::read_to_string(folder.join(&file)).unwrap();
    let path = folder.join(&file);
    let mut permissions = fs::metadata(&path).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&path, permissions).unwrap();
    let said = message(&folder, 2, &["balance", &file, "--write"]);
    assert!(said.contains("may not be written") && said.contains("hint:"), "{said}");
    assert_eq!(fs::read_to_string(&path).unwrap(), text);

    let pipe = piped(&folder, &["balance", "-", "--write"], text.as_bytes());
    assert_eq!(pipe.status.code(), Some(2));
    assert!(String::from_utf8(pipe.stderr).unwrap().contains("--write needs a file"));
    let pipe = piped(&folder, &["balance", "-", "--dry-run"], text.as_bytes());
    assert!(pipe.status.success() && pipe.stdout.starts_with(b"--- <stdin>"));
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 1, "nothing is left behind");
}

#[cfg(unix)]
#[test]
fn links_and_permissions_of_the_file_stay() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = folder("balance-links");
    let file = template(&folder, "twin-360");
    fs::set_permissions(folder.join(&file), fs::Permissions::from_mode(0o640)).unwrap();
    symlink(&file, folder.join("link.toml")).unwrap();
    output(&folder, 0, &["balance", "link.toml", "--write"]);
    assert!(fs::symlink_metadata(folder.join("link.toml")).unwrap().is_symlink());
    let metadata = fs::metadata(folder.join(&file)).unwrap();
    assert_eq!(metadata.permissions().mode() & 0o777, 0o640);
    assert!(fs::read_to_string(folder.join(&file)).unwrap().contains("[[counterweight]]"));
}

#[test]
fn a_limit_that_nobody_reaches_is_told_and_nothing_is_written() {
    let folder = folder("balance-infeasible");
    let file = template(&folder, "twin-360");
    let text = fs::read_to_string(folder.join(&file)).unwrap();
    let said = output(&folder, 1, &["balance", &file, "--limit", "force = 100 N", "--write"]);
    assert!(said.contains("10\u{a0}502"), "the closest value is told:\n{said}");
    assert_eq!(fs::read_to_string(folder.join(&file)).unwrap(), text);
}

#[test]
fn what_a_stage_gives_up_is_told_with_what_that_gains() {
    let folder = folder("balance-give-up");
    let file = template(&folder, "in-line-3");
    let bounded = ["balance", &file, "--counterweights", "throws", "--max-unbalance", "0.005 kg m"];
    let stages = ["--minimise", "couple", "--minimise", "main-bearing load rms"];
    let strict = output_json(&folder, 0, &[&bounded[..], &stages, &["--format", "json"]].concat());
    let give_up = ["--give-up", "couple = 5 %"];
    let found = output_json(&folder, 0, &[&bounded[..], &stages, &give_up, &["--format", "json"]].concat());
    let given = &found["stages"][0]["give_up"];
    assert!((given["most"].as_f64().unwrap() / reached(&strict, 0) - 1.05).abs() < 1e-7, "{given}");
    assert!(reached(&found, 1) < reached(&strict, 1), "{found}");
    let told = found["stages"][1]["without_give_up"].as_f64().unwrap();
    assert!((told / reached(&strict, 1) - 1.0).abs() < 1e-7);
    let text = output(&folder, 0, &[&bounded[..], &stages, &give_up].concat());
    for words in ["with what earlier stages give up", "Give-up: couple could be", "that lowers", "given up"] {
        assert!(text.contains(words), "{words}: {text}");
    }
    // The file says the same.
    let path = folder.join(&file);
    let section =
        "\n[balance]\nminimise = [\"couple\", \"main-bearing load rms\"]\ngive_up = { couple = \"5 %\" }\n";
    fs::write(&path, fs::read_to_string(&path).unwrap() + section).unwrap();
    let by_file = output_json(&folder, 0, &[&bounded[..], &["--format", "json"]].concat());
    assert_eq!(by_file["stages"], found["stages"]);
    let refused = message(&folder, 2, &[&bounded[..], &["--give-up", "force = 1 %"]].concat());
    assert!(refused.contains("no stage minimises `force`") && refused.contains("hint:"), "{refused}");
}

#[test]
fn weights_in_steps_and_equal_parts() {
    let folder = folder("balance-steps");
    let file = template(&folder, "in-line-3");
    let bounded = ["balance", &file, "--counterweights", "throws", "--minimise", "couple", "--gap", "1 %"];
    let steps = ["--weight-step", "1000 g mm", "--max-unbalance", "15000 g mm", "--format", "json"];
    let found = output_json(&folder, 0, &[&bounded[..], &steps].concat());
    for weight in found["weights"].as_array().unwrap() {
        let [x, y] = [0, 1].map(|k| weight["unbalance"][k].as_f64().unwrap());
        let number = x.hypot(y) / 1e-3;
        assert!((number - number.round()).abs() < 1e-9, "{weight}");
    }
    assert_eq!(found["method"]["kind"], "branch-and-bound");
    for (options, says) in [
        (vec!["--weight-step", "5 g"], "needs the radius"),
        (vec!["--weight-step", "0 g mm"], "more than 0"),
        (vec!["--weight-step", "5 N"], "`--weight-step`"),
        (vec!["--equal-parts"], "has no effect"),
        (vec!["--weight-step", "3 kg mm", "--max-unbalance", "2 kg mm"], "larger than the largest amount"),
    ] {
        let refused = message(&folder, 2, &[&bounded[..], &options].concat());
        assert!(refused.contains(says) && refused.contains("hint:"), "{options:?}: {refused}");
    }
}

#[test]
fn a_speed_that_nothing_asks_for_is_refused() {
    let folder = folder("balance-speed");
    let file = example("in-line-4-mounts");
    let asked = |criterion| ["balance", file.as_str(), "--minimise", criterion, "--speed", "2000 rpm"];
    for criterion in ["mount force", "main-bearing load with gas"] {
        let text = output(&folder, 0, &asked(criterion)).replace('\n', " ");
        assert!(text.contains("at 2000 rpm"), "{text}");
    }
    let refused = message(&folder, 2, &asked("force"));
    assert!(refused.contains("--speed has no effect") && refused.contains("hint:"), "{refused}");
}

#[test]
fn a_budget_chooses_the_weights() {
    let folder = folder("balance-budget");
    let file = template(&folder, "in-line-3");
    let path = folder.join(&file);
    let weight = |throw: u32, cost: u32| {
        format!("[[balance.counterweight]]\nthrow = {throw}\nmost = \"0.01 kg m\"\nfixed_cost = {cost}\n")
    };
    let section =
        format!("\n[balance]\nminimise = [\"couple\"]\nbudget = 7\n{}{}", weight(1, 4), weight(3, 6));
    fs::write(&path, fs::read_to_string(&path).unwrap() + &section).unwrap();
    let used = |budget: &[&str]| {
        let found = output_json(&folder, 0, &[&["balance", &file, "--format", "json"], budget].concat());
        let is_used = |weight: &serde_json::Value| weight["used"].as_bool().unwrap();
        found["weights"].as_array().unwrap().iter().filter(|weight| is_used(weight)).count()
    };
    assert_eq!((used(&[]), used(&["--budget", "3"]), used(&["--budget", "10"])), (1, 0, 2));
    let text = output(&folder, 0, &["balance", &file]);
    assert!(text.contains("cost"), "{text}");
    let refused = message(&folder, 2, &["balance", &file, "--budget", "ten"]);
    assert!(refused.contains("--budget") && refused.contains("hint:"), "{refused}");
}

#[test]
fn weights_for_a_production_of_engines() {
    let folder = folder("balance-robust");
    let file = template(&folder, "in-line-3");
    let asked = ["balance", &file, "--counterweights", "throws", "--minimise", "couple", "--robust", "60"];
    let untold = message(&folder, 2, &asked);
    assert!(untold.contains("tolerance") && untold.contains("hint:"), "{untold}");
    let path = folder.join(&file);
    let tolerances = "\n[tolerances]\npiston_mass = { plus_minus = \"8 g\" }\nthrow_angle = { plus_minus = \"0.3 deg\" }\n";
    fs::write(&path, fs::read_to_string(&path).unwrap() + tolerances).unwrap();
    let found = |more: &[&str]| output_json(&folder, 0, &[&asked[..], &["--format", "json"], more].concat());
    let number = |found: &serde_json::Value, key: &str| found[key].as_f64().unwrap();
    let worst = found(&[]);
    let mean = found(&["--worst-share", "10 %"]);
    assert_eq!((worst["averaged"].as_u64(), mean["averaged"].as_u64()), (Some(1), Some(6)));
    for one in [&worst, &mean] {
        let (value, bound) = (number(one, "value"), number(one, "lower_bound"));
        assert!(
            value >= bound
                && value - bound <= 1e-5 * value
                && value <= number(one, "ordinary") * (1.0 + 1e-9),
            "{one}"
        );
        assert_eq!(one["samples"].as_u64(), Some(60));
    }
    assert!(number(&mean, "value") < number(&worst, "value"));
    assert_eq!(found(&["--worst-share", "10 %"]), mean, "the same seed, the same answer");
    assert_ne!(found(&["--worst-share", "10 %", "--robust-seed", "2"])["value"], mean["value"]);
    // A limit holds for the engine as it is meant; a later stage takes what the first gives up.
    let limited = found(&["--limit", "main-bearing load = 1000 kN"]);
    assert_eq!(limited["limits"][0]["beyond"], 0);
    let later = ["--minimise", "added unbalance", "--give-up", "5 %"];
    let given = found(&later);
    let (least, value) = (number(&given, "least"), number(&given, "value"));
    assert!((least - number(&worst, "value")).abs() < 1e-6 * least && value > least && value < 1.051 * least);
    assert!(number(&given["later"][0], "value") > 0.0);
    let told = output(&folder, 0, &[&asked[..], &later].concat());
    assert!(told.contains("gives up for later stages") && told.contains("Then added unbalance"), "{told}");
    let text = output(&folder, 0, &asked);
    for words in ["the worst of 60 engines", "Standard error", "drawn independently", "as it is meant"] {
        assert!(text.contains(words), "{words}: {text}");
    }
    for (more, says) in [
        (["--limit", "couple = 0.001 N m"], "limits that can hold together"),
        (["--min-unbalance", "0.01 kg m"], "proved on every sample"),
        (["--worst-share", "0 %"], "above 0"),
        (["--worst-share", "x"], "--worst-share"),
        (["--format", "csv"], "no table"),
    ] {
        let refused = message(&folder, 2, &[&asked[..], &more].concat());
        assert!(refused.contains(says), "{more:?}: {refused}");
    }
}

#[test]
fn the_tables_of_an_optimum_are_comma_separated_values() {
    let folder = folder("balance-csv");
    let file = template(&folder, "in-line-3");
    let shaft = ["--shaft", "-1 @ 100 mm, 0 mm @ -100 mm, 100 mm"];
    let json = output_json(&folder, 0, &[&["balance", &file, "--format", "json"][..], &shaft].concat());
    let weights = json["weights"].as_array().unwrap();
    let table = output(
        &folder,
        0,
        &[&["balance", &file, "--format", "csv", "--table", "weights"][..], &shaft].concat(),
    );
    assert_eq!(table.lines().count(), weights.len() + 1, "{table}");
    for table in ["effects", "stages"] {
        let csv = output(&folder, 0, &["balance", &file, "--format", "csv", "--table", table]);
        let columns = csv.lines().next().unwrap().split(',').count();
        assert!(columns >= 3 && csv.lines().count() >= 3, "{csv}");
    }
    let figures = folder.join("figures");
    output(&folder, 0, &["balance", &file, "--figures", "figures"]);
    assert!(fs::read_dir(figures).unwrap().all(|f| f.unwrap().path().extension().unwrap() == "svg"));
}

#[test]
fn a_shaft_in_the_way_of_the_crank_is_refused_and_one_too_far_out_told() {
    let folder = folder("balance-room");
    let shaft = |text: &str| lanchester(&folder, &["balance", &twin(), "--shaft", text]);
    let through = shaft("-1 @ 0 mm, 20 mm @ 0 mm");
    let said = String::from_utf8(through.stderr).unwrap();
    assert!(through.status.code() == Some(2) && said.contains("runs through the crank"), "{said}");
    for (text, says) in [
        ("-1 @ 0 mm, 10 mm .. 100 mm @ 0 mm @ most 0.05 kg m", "may strike the crank"),
        ("-1 @ 0 mm, 120 mm @ 900 mm", "stands far beyond the crank: z = 900 mm"),
    ] {
        let told = shaft(text);
        let said = String::from_utf8(told.stderr).unwrap();
        assert!(
            told.status.code() == Some(0) && said.contains(says) && said.contains("hint:"),
            "{text}: {said}"
        );
    }
    assert!(shaft("-1 @ 0 mm, 120 mm @ 0 mm").stderr.is_empty());
}

/// One of two shafts, its height found: the text says how, the bound stands, and the other shaft is left out.
#[test]
fn choices_are_searched_and_told() {
    let folder = folder("balance-choices");
    let file = template(&folder, "twin-360");
    let arguments = [
        "balance",
        &file,
        "--minimise",
        "force",
        "--max-optional",
        "1",
        "--shaft",
        "-1 @ 0 mm, 50 mm .. 100 mm @ 0 mm @ optional, most 0.05 kg m",
        "--shaft",
        "2 @ 0 mm, -90 mm @ 0 mm @ optional, most 0.05 kg m",
    ];
    let said = output(&folder, 0, &arguments);
    assert!(said.contains("branch and bound, ") && said.contains("No choice goes below"), "{said}");
    let json = output_json(&folder, 0, &[&arguments[..], &["--format", "json"]].concat());
    assert_eq!(json["method"]["kind"], "branch-and-bound");
    let used = |k: usize| json["shafts"][k]["used"].as_bool().unwrap();
    assert!(used(0) && !used(1), "{json}");
    let least =
        output_json(&folder, 0, &["balance", &file, "--min-unbalance", "0.05 kg m", "--format", "json"]);
    let amount = |weight: &serde_json::Value| {
        let part = |k: usize| weight["unbalance"][k].as_f64().unwrap();
        part(0).hypot(part(1))
    };
    assert!(least["weights"].as_array().unwrap().iter().all(|w| amount(w) > 0.05 * (1.0 - 1e-9)), "{least}");
}

/// What was left to choose: planes and axes are written where they were found, what is left out is not, and everything
/// else in the file stays. The file's own loads are then those of the answer, and a second run changes nothing.
#[test]
fn found_places_are_written_back() {
    let folder = folder("balance-write-choices");
    let example = include_str!("../../../../../examples/twin-270-choices.toml");
    let free_axis = example.replace("y = \"95 mm\"", "y = [\"60 mm\", \"95 mm\"]");
    for (file, text) in [("plane.toml", example), ("axis.toml", &free_axis)] {
        let path = folder.join(file);
        fs::write(&path, text).unwrap();
        let found = output_json(&folder, 0, &["balance", file, "--format", "json", "--write"]);
        assert_eq!(found["method"]["kind"], "branch-and-bound");
        let written = fs::read_to_string(&path).unwrap();
        let left: Vec<&str> = text.lines().filter(|line| !written.contains(line)).collect();
        assert!(left.is_empty(), "{file}: lines are lost: {left:?}");

        let engine = output_json(&folder, 0, &["show", file, "--format", "json"]);
        let number = |value: &serde_json::Value| value.as_f64().unwrap();
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b.abs().max(1e-3);
        let weight = &found["weights"].as_array().unwrap()[0];
        let standing = &engine["counterweights"].as_array().unwrap()[0];
        assert_eq!(weight["name"], standing["name"]);
        assert!(near(number(&standing["z"]), number(&weight["z"])), "{file}: {standing} {weight}");
        let shafts = engine["shafts"].as_array().unwrap();
        assert_eq!(shafts.len(), 1, "{file}: the other is left out");
        let used = |s: &&serde_json::Value| s["used"].as_bool().unwrap();
        let chosen = found["shafts"].as_array().unwrap().iter().find(used).unwrap();
        assert_eq!(shafts[0]["name"], chosen["name"]);
        for axis in ["x", "y"] {
            assert!(near(number(&shafts[0][axis]), number(&chosen[axis])), "{file}: {chosen} {}", shafts[0]);
        }

        let peaks = output_json(&folder, 0, &["loads", file, "--format", "json"])["total"]["peaks"].clone();
        for (effect, peak) in [(0, "force"), (1, "couple"), (2, "roll_moment")] {
            let want = number(&found["effects"][effect]["after"]);
            let got = number(&peaks[peak]["max"]["value"])
                .abs()
                .max(peaks[peak]["min"]["value"].as_f64().map_or(0.0, f64::abs));
            assert!((got - want).abs() <= 1e-7 * want, "{file} {peak}: {got} {want}");
        }
        let again = lanchester(&folder, &["balance", file, "--dry-run"]);
        assert!(again.stdout.is_empty(), "{file}: {}", String::from_utf8_lossy(&again.stdout));
    }
}

/// Exact cancellation knows no choices: it says which one is in the way and what to do; with places given it is written.
#[test]
fn cancellation_with_choices_says_what_is_in_the_way() {
    let folder = folder("balance-cancel-choices");
    let file = template(&folder, "twin-360");
    let text = fs::read_to_string(folder.join(&file)).unwrap();
    let cancel = ["balance", &file, "--cancel", "force order 1"];
    let shaft = "-1 @ 0 mm, 100 mm @ 0 mm";
    for (arguments, expected, hint) in [
        (
            &["--shaft", "-1 @ 0 mm, 50 mm .. 90 mm @ 0 mm @ most 0.1 kg m"][..],
            "axis to be found",
            "one place",
        ),
        (&["--shaft", shaft, "--min-unbalance", "0.01 kg m"], "a least amount", "leave out"),
        (
            &["--shaft", "-1 @ 0 mm, 100 mm @ 0 mm @ optional, most 0.1 kg m", "--max-optional", "1"],
            "number of optional devices",
            "leave out",
        ),
    ] {
        let said = message(&folder, 2, &[&cancel[..], arguments, &["--write"]].concat());
        assert!(said.contains(expected) && said.contains(hint), "{arguments:?}: `{expected}` in:\n{said}");
        assert_eq!(fs::read_to_string(folder.join(&file)).unwrap(), text, "nothing is written");
    }

    let found =
        output_json(&folder, 0, &[&cancel[..], &["--shaft", shaft, "--write", "--format", "json"]].concat());
    assert_eq!(found["outcome"]["kind"], "optimal");
    let orders = output_json(&folder, 0, &["loads", &file, "--format", "json"]);
    let first = orders["total"]["orders"].as_array().unwrap().iter().find(|o| o["order"] == 1.0).unwrap();
    let largest = |key: &str| {
        first[key].as_array().unwrap().iter().fold(0.0f64, |m, part| m.max(part.as_f64().unwrap().abs()))
    };
    let before = found["effects"][0]["before"].as_f64().unwrap();
    for key in ["force_forward", "force_backward"] {
        assert!(largest(key) <= 1e-9 * before, "{key}: {first}");
    }
}

#[test]
fn wrong_wishes_say_what_is_needed() {
    let folder = folder("balance-options");
    let file = template(&folder, "twin-360");
    for (arguments, expected) in [
        (&["--minimise", "noise"][..], "couple"),
        (&["--limit", "force"], "="),
        (&["--limit", "force = 3 kg"], "N"),
        (&["--shaft", "-1"], "@"),
        (&["--shaft", "0 @ 0 mm, 0 mm @ 0 mm"], "0"),
        (&["--max-unbalance", "-3 g mm"], "-3 g mm"),
        (&["--shaft", "-1 @ 0 mm, 50 mm .. 90 mm @ 0 mm"], "largest"),
        (&["--shaft", "-1 @ 0 mm, 90 mm .. 50 mm @ 0 mm @ most 0.01 kg m"], "smaller"),
        (&["--shaft", "-1 @ 0 mm, 90 mm @ 0 mm @ maybe"], "optional"),
        (&["--max-optional", "1"], "nothing is optional"),
        (&["--optional"], "most"),
        (&["--minimise", "mount force 7"], "mount"),
        (&["--table", "weights"], "--format csv"),
    ] {
        let said = message(&folder, 2, &[&["balance", &file][..], arguments].concat());
        assert!(said.contains(expected) && said.contains("hint:"), "{arguments:?}: `{expected}` in:\n{said}");
    }
}
