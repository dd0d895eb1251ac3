//! The types of all questions and answers as TypeScript, from the same schemas as [`crate::openapi`].

use crate::openapi;
use serde_json::{Map, Value};
use std::fmt::Write;

const HEAD: &str = "// Written by `cargo xtask generate` from the Rust types. Do not edit.\n// SI units and radians; complex numbers are [re, im].\n";

/// One exported type for every structure, sorted by name.
pub fn typescript() -> String {
    let mut api = openapi::all();
    let definitions = api.schemas.take_definitions(true);
    let mut out = HEAD.to_string();
    for (name, schema) in &definitions {
        out.push('\n');
        write_doc(&mut out, schema, "");
        let _ = writeln!(out, "export type {name} = {};", of(schema, ""));
    }
    out
}

fn write_doc(out: &mut String, schema: &Value, indent: &str) {
    if let Some(text) = schema.get("description").and_then(Value::as_str) {
        let text = text.replace("*/", "* /");
        let lines: Vec<&str> = text.lines().collect();
        match lines[..] {
            [line] => {
                let _ = writeln!(out, "{indent}/** {line} */");
            }
            _ => {
                let _ = writeln!(out, "{indent}/**");
                for line in lines {
                    let _ = writeln!(out, "{}", format!("{indent} * {line}").trim_end());
                }
                let _ = writeln!(out, "{indent} */");
            }
        }
    }
}

/// The type of a schema.
fn of(schema: &Value, indent: &str) -> String {
    let Some(keys) = schema.as_object() else {
        // `true`: anything.
        return "unknown".into();
    };
    if let Some(reference) = keys.get("$ref").and_then(Value::as_str) {
        let name = reference.rsplit('/').next().unwrap_or_default();
        if !keys.contains_key("properties") {
            return name.to_string();
        }
        // A variant that is a struct of its own, with the tag beside it.
        let mut beside = keys.clone();
        beside.remove("$ref");
        return format!("{name} & {}", of(&Value::Object(beside), indent));
    }
    if let Some(value) = keys.get("const") {
        return value.to_string();
    }
    if let Some(values) = keys.get("enum").and_then(Value::as_array) {
        return values.iter().map(Value::to_string).collect::<Vec<_>>().join(" | ");
    }
    for union in ["anyOf", "oneOf"] {
        if let Some(parts) = keys.get(union).and_then(Value::as_array) {
            let parts: Vec<String> = parts.iter().map(|part| of(part, indent)).collect();
            let union = parts.join(" | ");
            return if keys.contains_key("properties") {
                format!("{} & ({union})", object(keys, indent))
            } else {
                union
            };
        }
    }
    if let Some(parts) = keys.get("allOf").and_then(Value::as_array) {
        let mut parts: Vec<String> = parts.iter().map(|part| of(part, indent)).collect();
        if keys.contains_key("properties") {
            parts.insert(0, object(keys, indent));
        }
        return parts.join(" & ");
    }
    match keys.get("type") {
        Some(Value::String(kind)) => of_kind(kind, keys, indent),
        Some(Value::Array(kinds)) => {
            let kinds = kinds.iter().filter_map(Value::as_str);
            kinds.map(|kind| of_kind(kind, keys, indent)).collect::<Vec<_>>().join(" | ")
        }
        _ => "unknown".into(),
    }
}

fn of_kind(kind: &str, keys: &Map<String, Value>, indent: &str) -> String {
    match kind {
        "number" | "integer" => "number".into(),
        "string" => "string".into(),
        "boolean" => "boolean".into(),
        "null" => "null".into(),
        "array" => array(keys, indent),
        "object" => object(keys, indent),
        _ => "unknown".into(),
    }
}

fn array(keys: &Map<String, Value>, indent: &str) -> String {
    if let Some(items) = keys.get("prefixItems").and_then(Value::as_array) {
        let items: Vec<String> = items.iter().map(|item| of(item, indent)).collect();
        return format!("[{}]", items.join(", "));
    }
    let item = keys.get("items").map_or("unknown".into(), |items| of(items, indent));
    let count = |key| keys.get(key).and_then(Value::as_u64);
    match (count("minItems"), count("maxItems")) {
        (Some(least), Some(most)) if least == most && most <= 6 => {
            format!("[{}]", vec![item; most as usize].join(", "))
        }
        _ if item.contains([' ', '|']) => format!("Array<{item}>"),
        _ => format!("{item}[]"),
    }
}

fn object(keys: &Map<String, Value>, indent: &str) -> String {
    let below = format!("{indent}  ");
    let required: Vec<&str> = keys
        .get("required")
        .and_then(Value::as_array)
        .into_iter()
        .flatten()
        .filter_map(Value::as_str)
        .collect();
    let Some(properties) = keys.get("properties").and_then(Value::as_object) else {
        let value = keys.get("additionalProperties").map_or("unknown".into(), |schema| of(schema, indent));
        return format!("Record<string, {value}>");
    };
    let mut out = "{\n".to_string();
    for (name, schema) in properties {
        write_doc(&mut out, schema, &below);
        let is_word = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        let name_text = if is_word { name.clone() } else { format!("{name:?}") };
        let optional = if required.contains(&name.as_str()) { "" } else { "?" };
        let _ = writeln!(out, "{below}{name_text}{optional}: {};", of(schema, &below));
    }
    let _ = write!(out, "{indent}}}");
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn every_kind_of_schema_has_its_type() {
        let of = |schema: Value| of(&schema, "");
        assert_eq!(of(json!({ "type": ["number", "null"] })), "number | null");
        assert_eq!(
            of(json!({ "type": "array", "items": { "type": "number" }, "minItems": 2, "maxItems": 2 })),
            "[number, number]"
        );
        assert_eq!(of(json!({ "type": "array", "items": { "$ref": "#/components/schemas/A" } })), "A[]");
        let tagged = json!({ "$ref": "#/x/A", "type": "object", "properties": { "kind": { "const": "a" } }, "required": ["kind"] });
        assert_eq!(of(tagged), "A & {\n  kind: \"a\";\n}");
        assert_eq!(of(json!({ "enum": ["a", "b"] })), "\"a\" | \"b\"");
        assert_eq!(of(json!({ "anyOf": [{ "$ref": "#/x/A" }, { "type": "null" }] })), "A | null");
        assert_eq!(
            of(
                json!({ "type": "object", "properties": { "a": { "type": "string" }, "b-c": true }, "required": ["a"] })
            ),
            "{\n  a: string;\n  \"b-c\"?: unknown;\n}"
        );
    }

    #[test]
    fn no_answer_is_of_an_unknown_type() {
        let text = typescript();
        assert!(text.contains("export type Loads = {") && text.contains("export type Problem = {"));
        let unknown: Vec<&str> = text
            .lines()
            .filter(|line| {
                line.contains("unknown") && !line.contains("\"unknown\"") && !line.contains("unknowns")
            })
            .collect();
        // Values of the engine file are of any kind.
        assert!(unknown.iter().all(|line| line.trim_start().starts_with("value")), "{unknown:#?}");
    }
}
