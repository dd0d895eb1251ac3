//! What an answer does to bearings, bending and balance rates, in every form of output.

use crate::program::{example, folder, lanchester, output, output_json};
use std::fs;

/// The counterweights of an in-line four do nothing for force and couple, so that the lightest answer to these has none: the least
/// unbalance is asked for before the main bearings decide.
const BLIND: [&str; 5] =
    ["balance", "in-line-4.toml", "--minimise=force", "--minimise=couple", "--minimise=added unbalance"];

#[test]
fn what_gets_worse_is_in_the_headline_and_marked_in_the_table() {
    let folder = folder("consequences-text");
    output(&folder, 0, &["new", "in-line-4", "--output", "in-line-4.toml"]);
    let text = output(&folder, 0, &BLIND);
    let words: String = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("Worse than before: the peak load on main 3 rises from"), "{text}");
    assert!(words.contains("All counterweights dropped: web 1 to 8."), "{text}");
    let row = |start: &str| {
        let found = text.lines().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" "));
        found.into_iter().find(|line| line.starts_with(start)).unwrap_or_else(|| panic!("{start}: {text}"))
    };
    assert!(row("main-bearing load, peak main 3 N").ends_with("worse"), "{text}");
    assert!(row("balance rate mains 2–3 % 80.00 0").ends_with("worse"), "{text}");
    assert!(row("counterweight unbalance g mm").ends_with("better"), "{text}");
}

#[test]
fn json_and_csv_have_all_of_it() {
    let folder = folder("consequences-data");
    output(&folder, 0, &["new", "in-line-4", "--output", "in-line-4.toml"]);
    let found = output_json(&folder, 0, &[&BLIND[..], &["--format", "json"]].concat());
    let rows = found["consequences"]["rows"].as_array().unwrap();
    let of = |quantity: &str| rows.iter().filter(|row| row["quantity"] == quantity).collect::<Vec<_>>();
    assert_eq!((of("main-load-peak").len(), of("main-load-rms").len(), of("balance-rate").len()), (5, 5, 4));
    assert!(of("balance-rate").iter().all(|row| {
        (row["before"].as_f64().unwrap() - 0.8).abs() < 1e-12
            && row["after"] == 0.0
            && row["change"] == "worse"
    }));
    assert_eq!(found["consequences"]["dropped"].as_array().unwrap().len(), 8);

    let csv = output(&folder, 0, &[&BLIND[..], &["--format", "csv", "--table", "consequences"]].concat());
    assert_eq!(csv.lines().next(), Some("quantity,at,unit,before,after,change [%],mark"), "{csv}");
    assert_eq!(csv.lines().filter(|line| line.starts_with("balance rate,")).count(), 4, "{csv}");
}

#[test]
fn no_counterweight_goes_without_a_word_where_only_the_difference_is_shown() {
    let folder = folder("consequences-difference");
    output(&folder, 0, &["new", "in-line-4", "--output", "in-line-4.toml"]);
    let shown = lanchester(&folder, &[&BLIND[..], &["--dry-run"]].concat());
    let said = String::from_utf8(shown.stderr).unwrap();
    assert!(
        said.contains("All counterweights dropped: web 1 to 8.")
            && said.contains("peak load on main 3 rises from"),
        "{said}"
    );
    assert!(shown.stdout.starts_with(b"--- "), "the difference alone is on standard output");
}

#[test]
fn published_methods_sweeps_and_chosen_arrangements_have_it_too() {
    let folder = folder("consequences-methods");
    let three = example("in-line-3");
    let twin = example("twin-in-line-in-phase");
    for arguments in [
        &["balance", &three, "--method", "half"][..],
        &["balance", &twin, "--method", "sweep"],
        &["balance", &twin, "--search", "--choose", "crank"],
        &["balance", &twin, "--cancel", "force order 1", "--shaft", "-1 @ 0 mm, 120 mm @ 0 mm"],
    ] {
        let text = output(&folder, 0, arguments);
        assert!(text.contains("Before and after") && text.contains("balance rate"), "{arguments:?}: {text}");
        let json = output_json(&folder, 0, &[arguments, &["--format", "json"]].concat());
        assert!(json["consequences"]["rows"].as_array().is_some_and(|rows| rows.len() > 8), "{arguments:?}");
        let table = [arguments, &["--format", "csv", "--table", "consequences"]].concat();
        assert!(output(&folder, 0, &table).contains("main-bearing load"), "{arguments:?}");
    }
}

#[test]
fn a_designed_counterweight_says_what_its_shape_does() {
    let folder = folder("consequences-design");
    let file = example("in-line-3-counterweights");
    let text = output(&folder, 0, &["counterweight", "design", &file]);
    assert!(text.contains("Before and after") && text.contains("counterweight unbalance"), "{text}");
    let json = output_json(&folder, 0, &["counterweight", "design", &file, "--format", "json"]);
    assert!(json["consequences"]["rows"].is_array());
}

#[test]
fn the_report_and_the_figures_show_it() {
    let folder = folder("consequences-report");
    output(&folder, 0, &["new", "in-line-4", "--output", "in-line-4.toml"]);
    output(&folder, 0, &[&BLIND[..], &["--figures", "pictures"]].concat());
    let picture = fs::read_to_string(folder.join("pictures/consequences.svg")).unwrap();
    assert!(picture.contains("Main-bearing load, peak") && picture.contains("Bending moment"), "{picture}");

    let file = folder.join("in-line-4.toml");
    let task = "\n[balance]\nminimise = [\"force\", \"couple\"]\n";
    fs::write(&file, fs::read_to_string(&file).unwrap() + task).unwrap();
    output(&folder, 0, &["report", "in-line-4.toml"]);
    let page = fs::read_to_string(folder.join("in-line-4.html")).unwrap();
    assert!(
        page.contains("Before and after")
            && page.contains("Block, main bearings and bending, before and after")
    );
}
