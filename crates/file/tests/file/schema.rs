//! The JSON Schema against files that the reader takes and refuses.

use lanchester_file::{expanded, json_schema, read, reference_markdown, templates};
use serde_json::{Map, Value, json};
use toml_spanner::{Arena, Item, Value as Toml};

fn as_json(text: &str) -> Value {
    let arena = Arena::new();
    let document = toml_spanner::parse(text, &arena).unwrap_or_else(|error| panic!("{error:?}"));
    value(document.table().as_item())
}

fn value(item: &Item<'_>) -> Value {
    match item.value() {
        Toml::String(text) => json!(text),
        Toml::Integer(number) => json!(number.as_i64()),
        Toml::Float(number) => json!(number),
        Toml::Boolean(truth) => json!(truth),
        Toml::DateTime(_) => json!("date"),
        Toml::Array(array) => array.iter().map(value).collect(),
        Toml::Table(table) => {
            let map: Map<String, Value> =
                table.iter().map(|(key, item)| (key.as_str().to_string(), value(item))).collect();
            Value::Object(map)
        }
    }
}

fn schema() -> jsonschema::Validator {
    jsonschema::draft202012::new(&json_schema()).expect("the schema is a schema")
}

#[test]
fn every_template_and_its_expanded_form_fit_the_schema() {
    let schema = schema();
    let parts = ("parts", include_str!("../files/crank-as-body.toml"));
    let gas = ("gas", include_str!("../files/gas.toml"));
    let files = templates().iter().map(|template| (template.name, template.text)).chain([parts, gas]);
    for (name, file) in files {
        let read = read(file).file.unwrap_or_else(|| panic!("{name} cannot be read"));
        for text in [file, &expanded(&read)] {
            let errors: Vec<String> = schema
                .iter_errors(&as_json(text))
                .map(|error| format!("{} at {}", error, error.instance_path()))
                .collect();
            assert!(errors.is_empty(), "{name}: {errors:?}");
        }
    }
}

#[test]
fn what_the_reader_refuses_by_its_keys_the_schema_refuses() {
    let schema = schema();
    let good = templates()[0].text;
    assert!(schema.is_valid(&as_json(good)));
    let with = |pointer: &str, key: &str, new: Value| {
        let mut json = as_json(good);
        let table = json.pointer_mut(pointer).and_then(Value::as_object_mut).expect("a table");
        table.insert(key.to_string(), new);
        json
    };
    for (pointer, key, new) in [
        ("", "colour", json!("red")),
        ("/rod", "lenght", json!("144 mm")),
        ("/rod", "length", json!(144)),
        ("/rod", "length", json!("144")),
        ("/rod", "length", json!("144,5 mm")),
        ("/rod", "length", json!("144 kg")),
        ("/rod", "length", json!("-144 mm")),
        ("/layout", "type", json!("inline")),
        ("/layout", "cylinders", json!(0)),
        ("", "strokes", json!(3)),
        ("", "shaft", json!([{ "ratio": 0, "weights": [] }])),
        ("", "mount", json!([{ "name": "front" }])),
    ] {
        assert!(!schema.is_valid(&with(pointer, key, new.clone())), "{pointer}/{key} = {new}");
    }
    for (pointer, key, new) in [
        ("/rod", "length", json!(" 1.44e2mm ")),
        ("/rod", "length", json!("144 µm")),
        (
            "",
            "counterweight_design",
            json!({ "density": "7.85 g/cm³", "balance": [0.9, "110 %"],
            "rectangle_height": "1 mm", "arc_radius": ["1 mm", "2 mm"], "arc_angle": "9 deg", "thickness": "1 mm" }),
        ),
        ("/crank", "unbalance", json!("-0.02 kg·m")),
        ("/rod", "inertia", json!("2000 kg mm²")),
        ("", "speed", json!(["1 Hz", "4000 rpm"])),
        ("", "shaft", json!([{ "ratio": "-1/2", "weights": [] }])),
    ] {
        assert!(schema.is_valid(&with(pointer, key, new.clone())), "{pointer}/{key} = {new}");
    }
}

#[test]
fn the_reference_names_every_table_and_unit() {
    let reference = reference_markdown();
    for part in
        ["## The file", "## `[rod]`", "## `[[shaft.weights]]`", "| `length` |", "`lbf ft`", "`kg mm2`"]
    {
        assert!(reference.contains(part), "{part}");
    }
}
