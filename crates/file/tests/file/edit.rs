//! Single keys of an engine file changed by their path.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester_file::{Edit, EditError, edit, file_entries, read, templates};
use serde_json::{Value, json};

fn set(text: &str, path: &str, value: Value) -> String {
    edit(text, &[Edit { path: path.to_string(), value }]).unwrap()
}

const FILE: &str = "# head\nname = \"A\" # the name\n\n[crank] # shaft\nstroke = \"80 mm\" # measured\n\n[rod]\nmass = \"1 lb\"\nsmall = { end = 3 }\n\n[[cylinder]]\nnumber = 1\npiston.mass = \"0.3 kg\"\n\n[[cylinder]]\nnumber = 2\n";

#[test]
fn a_value_is_exchanged_and_nothing_else() {
    assert_eq!(set(FILE, "crank.stroke", json!("3.2 in")), FILE.replace("80 mm", "3.2 in"));
    assert_eq!(set(FILE, "cylinder[1].number", json!(3)), FILE.replace("number = 2", "number = 3"));
    assert_eq!(set(FILE, "cylinder[0].piston.mass", json!("1 oz")), FILE.replace("0.3 kg", "1 oz"));
    assert_eq!(set(FILE, "rod.small.end", json!(4)), FILE.replace("end = 3", "end = 4"));
}

#[test]
fn a_new_key_stands_behind_the_last_of_its_table() {
    assert_eq!(
        set(FILE, "crank.phase", json!("10 deg")),
        FILE.replace("# measured\n", "# measured\nphase = \"10 deg\"\n")
    );
    assert_eq!(set(FILE, "note", json!("n")), FILE.replace("# the name\n", "# the name\nnote = \"n\"\n"));
    assert_eq!(
        set(FILE, "rod.small.share", json!(0.5)),
        FILE.replace("{ end = 3 }", "{ end = 3, share = 0.5 }")
    );
    assert_eq!(
        set(FILE, "cylinder[0].piston.bore", json!("8 cm")),
        FILE.replace("\"0.3 kg\"\n", "\"0.3 kg\"\npiston.bore = \"8 cm\"\n")
    );
    assert_eq!(
        set(FILE, "cylinder[1].piston.mass", json!("1 kg")),
        FILE.replace("number = 2\n", "number = 2\npiston = { mass = \"1 kg\" }\n")
    );
}

#[test]
fn tables_and_entries_come_to_be() {
    assert_eq!(
        set(FILE, "piston.mass", json!("1 kg")),
        format!("{FILE}\n[piston]\nmass = \"1 kg\"\n").replace("\n\n\n", "\n\n")
    );
    assert_eq!(
        set(FILE, "gas.cycle", json!({ "kind": "otto", "ratio": 9 })),
        format!("{FILE}\n[gas.cycle]\nkind = \"otto\"\nratio = 9\n")
    );
    assert_eq!(set(FILE, "cylinder[2].number", json!(3)), format!("{FILE}\n[[cylinder]]\nnumber = 3\n"));
    assert_eq!(
        set(FILE, "shaft[0]", json!({ "name": "first", "ratio": -1 })),
        format!("{FILE}\n[[shaft]]\nname = \"first\"\nratio = -1\n")
    );
    assert_eq!(set("", "crank.stroke", json!("1 m")), "[crank]\nstroke = \"1 m\"\n");
    assert_eq!(set("[crank]\n", "name", json!("B")), "name = \"B\"\n[crank]\n");
    assert_eq!(set("[crank] # c\n", "crank.stroke", json!("1 m")), "[crank] # c\nstroke = \"1 m\"\n");
    assert_eq!(set("a = {}\n", "a.b", json!([1, "x"])), "a = { b = [1, \"x\"] }\n");
}

#[test]
fn what_is_taken_out_leaves_its_comments() {
    assert_eq!(
        set(FILE, "crank.stroke", Value::Null),
        FILE.replace("stroke = \"80 mm\" # measured", "# measured")
    );
    assert_eq!(set(FILE, "cylinder[1]", Value::Null), FILE.replace("[[cylinder]]\nnumber = 2\n", ""));
    assert_eq!(
        set(FILE, "cylinder[0].piston.mass", Value::Null),
        FILE.replace("piston.mass = \"0.3 kg\"\n", "")
    );
    assert_eq!(set(FILE, "nothing.there", Value::Null), FILE);
    let bare = set(FILE, "cylinder", Value::Null);
    assert!(!bare.contains("cylinder") && bare.contains("[rod]"), "{bare}");
    assert!(!set(FILE, "rod", Value::Null).contains("rod"));
}

#[test]
fn paths_that_lead_nowhere_are_told() {
    for path in [
        "",
        "crank.",
        "crank..stroke",
        "crank[x]",
        "crank[0",
        "name.first",
        "cylinder[7].number",
        "crank",
        "cylinder",
        "\"open",
    ] {
        let error = edit(FILE, &[Edit { path: path.to_string(), value: json!(1) }]).unwrap_err();
        assert!(error.to_string().contains("hint: "), "{path}: {error}");
    }
    let broken = edit("a = 1\nb = \nc = 2\n", &[Edit { path: "c".into(), value: json!(3) }]).unwrap_err();
    assert_eq!(broken, EditError::Syntax { line: 2 });
}

#[test]
fn every_value_of_the_gallery_can_be_set_to_itself() {
    for template in templates() {
        let entries = file_entries(template.text);
        assert!(entries.len() > 5, "{}", template.name);
        for entry in &entries {
            let text = set(template.text, &entry.path, entry.value.clone());
            assert_eq!(file_entries(&text).len(), entries.len(), "{} {}", template.name, entry.path);
            assert_eq!(
                read(&text).engine(),
                read(template.text).engine(),
                "{} {}",
                template.name,
                entry.path
            );
            let without = set(template.text, &entry.path, Value::Null);
            assert!(
                file_entries(&without)
                    .iter()
                    .all(|other| other.path != entry.path || other.path.contains('['))
            );
        }
    }
}
