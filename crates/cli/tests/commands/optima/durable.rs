//! Oil films and safeties: balanced for, compared, and as limits of layouts.

use crate::program::{example, folder, message, number, output, output_json};
use serde_json::Value;

const FOUR: &str = "in-line-4-crank-by-elements";

/// The engine file with one speed, so that every bearing is computed once.
fn at_one_speed(folder: &std::path::Path) {
    let text = std::fs::read_to_string(example(FOUR)).expect("an example");
    let text = text.replace("speed = [\"800 rpm\", \"6500 rpm\"]", "speed = \"4000 rpm\"");
    std::fs::write(folder.join("four.toml"), text).expect("the folder is ours");
}

#[test]
fn balance_tells_films_and_moves_weights_for_them() {
    let folder = folder("durable-balance");
    at_one_speed(&folder);
    let plain = output_json(&folder, 0, &["balance", "four.toml", "--format", "json"]);
    assert_eq!(plain.pointer("/durability/end/kind"), Some(&Value::from("not-asked")));
    let film =
        |json: &Value, when: &str, row: usize| number(json, &format!("/durability/rows/{row}/{when}/value"));
    // The optimum's weights make the film of the middle bearing thicker, and leave big ends and the sheet as they are.
    assert!(film(&plain, "optimum", 2) > 1.1 * film(&plain, "before", 2));
    for row in [5, 6] {
        let (before, after) = (film(&plain, "before", row), film(&plain, "optimum", row));
        assert!((after / before - 1.0).abs() < 1e-9, "row {row}: {before} {after}");
    }
    let least = (0..5).map(|row| film(&plain, "optimum", row)).fold(f64::INFINITY, f64::min);
    let holds = format!("main-bearing film = {} um", 0.9e6 * least);
    let text = output(&folder, 0, &["balance", "four.toml", "--at-least", &holds]);
    assert!(text.contains("proof holds for the limited problem too"), "{text}");
    let not = format!("main-bearing film = {} um", 20e6 * least);
    let text = output(&folder, 1, &["balance", "four.toml", "--at-least", &not, "--max-evaluations", "10"]);
    assert!(text.contains("NOT MET") && text.contains("No global optimum is claimed"), "{text}");
    let text = output(&folder, 1, &["balance", "four.toml", "--at-least", "rule safety = 9"]);
    assert!(text.contains("no unbalance on a crankshaft changes it"), "{text}");
    let csv = output(&folder, 0, &["balance", "four.toml", "--format", "csv", "--table", "durability"]);
    assert!(csv.starts_with("film or safety") && csv.contains("main-bearing film 3"), "{csv}");
}

/// Where the search moved weights, one crankshaft is told and written: the criteria after are those of the written file.
#[test]
fn what_is_told_after_a_search_is_what_is_written() {
    let folder = folder("durable-written");
    at_one_speed(&folder);
    let asked = ["balance", "four.toml", "--maximise", "main-bearing film"];
    let text = output(&folder, 0, &asked);
    assert!(text.contains("those of the search"), "{text}");
    let brief = output(&folder, 0, &[&asked[..], &["--brief"]].concat());
    let json = output_json(&folder, 0, &[&asked[..], &["--format", "json"]].concat());
    let effects = json.pointer("/durability/effects").and_then(Value::as_array).expect("weights were moved");
    let largest = |effects: &[Value]| {
        let own = effects.iter().find(|effect| effect.to_string().contains("largest-main-load")).unwrap();
        number(own, "/after")
    };
    let moved = largest(effects);
    assert!(
        (moved / largest(json.pointer("/effects").and_then(Value::as_array).unwrap()) - 1.0).abs() > 1e-3
    );
    // The weights of both texts are those that are written.
    let unbalance = number(&json, "/durability/weights/0/unbalance/0")
        .hypot(number(&json, "/durability/weights/0/unbalance/1"));
    let words = format!("{:.1}", 1e6 * unbalance);
    let words = format!("{}\u{a0}{}", &words[..words.len() - 5], &words[words.len() - 5..]);
    assert!(text.contains(&words) && brief.contains(&words), "{words} in\n{brief}");
    output(&folder, 0, &[&asked[..], &["--write"]].concat());
    let table = output_json(&folder, 0, &["balance", "four.toml", "--format", "json"]);
    let before = table.pointer("/effects").and_then(Value::as_array).unwrap().iter();
    let before = before.filter(|effect| effect.to_string().contains("largest-main-load")).collect::<Vec<_>>();
    assert!((number(before[0], "/before") / moved - 1.0).abs() < 1e-6, "{before:?} {moved}");
}

#[test]
fn what_is_asked_wrongly_is_refused_with_what_there_is() {
    let folder = folder("durable-refused");
    let four = example(FOUR);
    for (arguments, words) in [
        (vec!["--at-least", "main-bearing film 9 = 1 um"], "main bearings 1 to 5"),
        (vec!["--at-least", "least film"], "--at-least"),
        (vec!["--at-least", "least flim = 1 um"], "least film"),
        (vec!["--maximise", "force"], "no film and no safety"),
        (vec!["--at-least", "rule safety = 1.3 um"], "plain number"),
        (vec!["--maximise", "least film", "--robust", "10"], "cannot be used with"),
    ] {
        let all: Vec<&str> = ["balance", &four].into_iter().chain(arguments).collect();
        let said = message(&folder, 2, &all);
        assert!(said.contains(words), "{said}");
    }
    let said = message(&folder, 2, &["explore", &example("in-line-4"), "--at-least", "least film = 1 um"]);
    assert!(said.contains("[bearings.film]") && said.contains("hint"), "{said}");
    let said = message(&folder, 2, &["explore", &four, "--durability", "fillet safety"]);
    assert!(said.contains("finite elements"), "{said}");
}

#[test]
fn compare_has_films_where_the_files_have_oil() {
    let folder = folder("durable-compare");
    at_one_speed(&folder);
    let json = output_json(&folder, 0, &["compare", "four.toml", &example("in-line-4"), "--format", "json"]);
    assert!(
        number(&json, "/engines/0/main_film/value") > 0.0
            && number(&json, "/engines/0/rule_safety/value") > 1.0
    );
    assert_eq!(json.pointer("/engines/1/main_film/kind"), Some(&Value::from("unknown")));
    let text = output(&folder, 0, &["compare", "four.toml", &example("in-line-4")]);
    assert!(text.contains("main film") && text.contains("safety UR M53"), "{text}");
    assert!(text.contains("of no. 2: the oil of the bearings is not given; give viscosity"), "{text}");
}

#[test]
fn layouts_hold_a_limit_on_films_and_tell_them() {
    let folder = folder("durable-explore");
    at_one_speed(&folder);
    let space = [
        "explore",
        "four.toml",
        "--even-firing",
        "--throw-angles",
        "every 90 deg",
        "--minimise",
        "force order 2",
    ];
    let told = [&space[..], &["--durability", "main-bearing film", "--format", "json"]].concat();
    let json = output_json(&folder, 0, &told);
    let film = number(&json, "/front/0/durability/0/value");
    assert!(film > 0.0 && json["durability"].as_array().map(Vec::len) == Some(1));
    let kept = format!("main-bearing film = {} um", 0.99e6 * film);
    let text = output(&folder, 0, &[&space[..], &["--at-least", &kept]].concat());
    assert!(text.contains("Layouts of front and ranking hold: main-bearing film at least"), "{text}");
    let text = output(&folder, 1, &[&space[..], &["--at-least", "main-bearing film = 29 um"]].concat());
    assert!(text.contains("the front is empty"), "{text}");
}
