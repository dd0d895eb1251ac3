//! Which arrangement: searched, listed, drawn, one chosen and written.

use crate::program::{examples, folder, lanchester, message, output, output_json};
use std::fs;
use std::path::{Path, PathBuf};

/// A folder with the twins of the thesis and the four that they are compared with.
fn engines(test: &str) -> PathBuf {
    let folder = folder(test);
    for (from, to) in [
        ("twin-in-line-out-of-phase", "in-line"),
        ("twin-boxer-in-phase", "boxer"),
        ("in-line-4-long-stroke", "four"),
    ] {
        let copied = fs::copy(examples().join(format!("{from}.toml")), folder.join(format!("{to}.toml")));
        copied.unwrap();
    }
    folder
}

/// Mounts 176 mm apart, half the four is good enough.
fn search<'a>(file: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    let mut arguments = vec!["balance", file, "--search", "--mount-spacing", "176 mm"];
    arguments.extend(["--reference", "four.toml", "--share", "1/2"]);
    arguments.extend(more);
    arguments
}

fn mount_force(folder: &Path, file: &str) -> f64 {
    // Two mounts into the file, then its loads.
    let path = folder.join("mounted.toml");
    let mut text = fs::read_to_string(folder.join(file)).unwrap();
    for (name, z) in [("front", "-88 mm"), ("rear", "88 mm")] {
        text += &format!("\n[[mount]]\nname = \"{name}\"\nx = \"0 mm\"\ny = \"0 mm\"\nz = \"{z}\"\n");
    }
    fs::write(&path, text).unwrap();
    let question = ["balance", "mounted.toml", "--minimise", "mount force", "--counterweights", "throws"];
    let found = output_json(folder, 0, &[&question[..], &["--format", "json"]].concat());
    let effects = found["effects"].as_array().unwrap().iter();
    let of_mounts: Vec<_> = effects.filter(|e| e["criterion"]["peak"] == "largest-mount-force").collect();
    of_mounts[0]["before"].as_f64().unwrap()
}

#[test]
fn the_simplest_is_named_with_its_drive() {
    let folder = engines("search-text");
    let text = output(&folder, 0, &search("in-line.toml", &[]));
    assert!(
        text.contains("good enough: 2900.5 N (0.5 of the mount force of in-line four, long stroke"),
        "{text}"
    );
    assert!(text.contains("simplest: no. 8, crank weights, one first-order double shaft against"), "{text}");
    assert!(text.contains("Drive: ") && text.contains("narrowest place: 3.0 mm"), "{text}");
    let all = output(&folder, 0, &search("in-line.toml", &["--all"]));
    assert!(all.lines().count() > text.lines().count() && all.contains("All arrangements"), "{all}");
}

#[test]
fn spacings_stand_in_front_of_the_rows_and_in_the_names_of_the_figures() {
    let folder = engines("search-csv");
    let more = ["--spacing", "88 mm, 60 mm", "--format", "csv", "--figures", "figures"];
    let table = output(&folder, 0, &search("boxer.toml", &more));
    let mut lines = table.lines();
    assert!(
        lines.next().unwrap().starts_with("spacing [mm],no.,arrangement,mount force [N],of limit [%]"),
        "{table}"
    );
    assert!(table.contains("\n88,1,nothing,") && table.contains("\n60,1,nothing,"), "{table}");
    for figure in ["arrangements", "drives-88mm", "drives-60mm"] {
        let svg = fs::read_to_string(folder.join(format!("figures/{figure}.svg"))).unwrap();
        assert!(svg.starts_with("<svg") && !svg.contains("NaN"), "{figure}");
    }
}

#[test]
fn a_chosen_arrangement_is_written_and_does_what_was_said() {
    let folder = engines("search-write");
    let path = folder.join("in-line.toml");
    let before = fs::read_to_string(&path).unwrap();
    let choice = ["--choose", "crank -1"];
    let chosen =
        output_json(&folder, 0, &[&search("in-line.toml", &choice)[..], &["--format", "json"]].concat());
    let difference = output(&folder, 0, &[&search("in-line.toml", &choice)[..], &["--dry-run"]].concat());
    assert!(
        difference.contains("+ratio = -1") && fs::read_to_string(&path).unwrap() == before,
        "{difference}"
    );
    let text = output(&folder, 0, &[&search("in-line.toml", &choice)[..], &["--write"]].concat());
    assert!(text.contains("crank weights, one first-order double shaft against (crank -1)"), "{text}");
    let after = fs::read_to_string(&path).unwrap();
    assert!(after.starts_with(before.trim_end()), "what was there stays\n{after}");
    let (said, is) = (chosen["residual"].as_f64().unwrap(), mount_force(&folder, "in-line.toml"));
    assert!((is - said).abs() < 1e-6 * said, "said {said} N, is {is} N");
    // Half a turn is half a turn, not 180.00000008 degrees.
    assert!(!after.contains(".9999999") && !after.contains(".0000000"), "{after}");
}

#[test]
fn a_search_takes_out_what_an_earlier_one_wrote() {
    let folder = engines("search-again");
    let table = |file: &str| -> Vec<String> {
        let csv = output(&folder, 0, &search(file, &["--format", "csv"]));
        csv.lines().map(str::to_owned).collect()
    };
    let fresh = table("in-line.toml");
    output(&folder, 0, &search("in-line.toml", &["--choose", "crank -1", "--write"]));
    assert_eq!(fresh, table("in-line.toml"));
    // Another choice replaces the first one.
    output(&folder, 0, &search("in-line.toml", &["--choose", "+1 -1", "--write"]));
    let written = fs::read_to_string(folder.join("in-line.toml")).unwrap();
    assert!(!written.contains("crank weight") && written.contains("shaft +1"), "{written}");
    let text = output(&folder, 0, &search("in-line.toml", &[]));
    assert!(text.contains("balance shafts of the file are taken out: 2"), "{text}");
}

#[test]
fn a_limit_out_of_reach_is_status_1_and_tells_how_close_the_best_comes() {
    let folder = engines("search-limit");
    let few = ["balance", "boxer.toml", "--search", "--minimise", "couple", "--limit", "couple = 1 N m"];
    let text = output(&folder, 1, &[&few[..], &["--max-shafts", "0"]].concat());
    assert!(
        text.contains("nothing reaches 1.0 N m: the best, crank weights") && text.contains("523 times"),
        "{text}"
    );
    let csv = [&few[..], &["--max-shafts", "0", "--format", "csv"]].concat();
    let beside = lanchester(&folder, &csv);
    assert_eq!(beside.status.code(), Some(1));
    assert!(
        String::from_utf8(beside.stderr).unwrap().contains("nothing reaches"),
        "told beside the table too"
    );
}

#[test]
fn what_has_no_meaning_is_refused_with_what_to_do() {
    let folder = engines("search-refused");
    let boxer = |more: &[&'static str]| [&["balance", "boxer.toml", "--search"], more].concat();
    let no_place = ["--minimise", "couple", "--place", "-30 mm, 0 mm", "--choose", "-1", "--write"];
    for (arguments, says) in [
        (boxer(&["--minimise", "mount force"]), "--mount-spacing"),
        (boxer(&["--minimise", "couple", "--minimise", "force"]), "one criterion, got 2"),
        (boxer(&["--minimise", "roll moment"]), "force, couple or mount force, got `roll moment`"),
        (boxer(&["--spacing", "-3 mm"]), "0 or more, got -3 mm"),
        (boxer(&["--spacing", ""]), "needs a length with its unit"),
        (boxer(&["--minimise", "couple", "--limit", "couple = 0 N m"]), "must be above 0"),
        (boxer(&["--limit", "added mass = 1 kg"]), "no limit on the added mass"),
        (boxer(&["--max-shafts", "9"]), "needs 0 to 4, got 9"),
        (boxer(&["--shaft-orders", "3"]), "needs 1, 2 or both"),
        (boxer(&["--place", "-120 mm"]), "needs a point x, y or a box"),
        (boxer(&["--place", "-90 mm .. -300 mm, 0 mm .. 0 mm"]), "smaller to the larger"),
        (boxer(&["--place", "-300 mm .. -90 mm, -1 m .. 1 m", "--place-step", "1 mm"]), "at most 400"),
        (boxer(&["--size", "crnk sweep = 1 mm"]), "its parts are"),
        (boxer(&["--size", "module = 0 mm"]), "above 0 for `module`"),
        (boxer(&["--reference", "four.toml", "--minimise", "couple"]), "choose another criterion"),
        (boxer(&["--reference", "four.toml", "--limit", "force = 3 N"]), "told twice"),
        (boxer(&["--reference", "four.toml", "--share", "0"]), "share above 0"),
        (boxer(&["--write"]), "add --choose"),
        (boxer(&["--choose", "99"]), "needs a number from 1 to 1 or a name, got `99`"),
        (boxer(&["--shaft", "-1 @ 0 mm, 100 mm @ 0 mm"]), "--place"),
        (
            boxer(&["--minimise", "couple", "--spacing", "60 mm", "--choose", "2", "--write"]),
            "the engine file has 88 mm",
        ),
        (boxer(&no_place), "cannot be fitted: narrowest place: -100.6 mm"),
        (vec!["balance", "boxer.toml", "--spacing", "88 mm"], "--search"),
    ] {
        let said = message(&folder, 2, &arguments);
        assert!(said.contains(says) && said.contains("error:"), "{arguments:?}: {said}");
    }
}
