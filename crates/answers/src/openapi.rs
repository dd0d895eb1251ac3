//! The description of all questions and answers as OpenAPI 3.1, whose schemas are JSON Schemas.

use crate::api::{Answer, Answers, Api, Endpoint};
use crate::questions;
use serde_json::{Map, Value, json};

/// All questions, that for their description among them.
pub(crate) fn all() -> Api {
    questions::all().get("/api/openapi.json", "This description.", |_| Ok(openapi()))
}

/// The one list of questions, with what answers them.
pub fn answers() -> Answers {
    all().answers()
}

/// The description.
pub fn openapi() -> Value {
    let mut api = all();
    let mut paths = Map::new();
    for endpoint in &api.endpoints {
        let methods = paths.entry(endpoint.path).or_insert_with(|| json!({}));
        methods[endpoint.method] = operation(endpoint);
    }
    let events = json!({
        "summary": "Events `file`: the open file as it stands on the disk, or null, with every change.",
        "parameters": [{ "name": "token", "in": "query", "required": true, "schema": { "type": "string" } }],
        "responses": { "200": { "description": "A stream of events.", "content": { "text/event-stream": {} } } },
    });
    paths.insert("/api/events".into(), json!({ "get": events }));
    let mut schemas = Value::Object(api.schemas.take_definitions(true));
    leave_out(&mut schemas, &Value::Object(api.asked.take_definitions(true)));
    leave_defaults_out(&mut schemas);
    json!({
        "openapi": "3.1.0",
        "info": {
            "title": "Lanchester studio",
            "version": env!("CARGO_PKG_VERSION"),
            "description": "Answers of the studio's server. All numbers are SI and radians; complex numbers are pairs of real and imaginary part.",
        },
        "security": [{ "token": [] }],
        "paths": paths,
        "components": {
            "schemas": schemas,
            "securitySchemes": { "token": { "type": "apiKey", "in": "header", "name": "X-Lanchester-Token" } },
        },
    })
}

/// Schemas of answers require all of their fields; those of questions only what the same schemas require when they are read.
fn leave_out(schema: &mut Value, asked: &Value) {
    match (schema, asked) {
        (Value::Object(keys), Value::Object(asked)) => {
            let needed = asked.get("required").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
            if let Some(Value::Array(required)) = keys.get_mut("required") {
                required.retain(|name| needed.contains(name));
                if required.is_empty() {
                    keys.remove("required");
                }
            }
            for (key, schema) in keys.iter_mut() {
                if let Some(asked) = asked.get(key) {
                    leave_out(schema, asked);
                }
            }
        }
        (Value::Array(list), Value::Array(asked)) => {
            list.iter_mut().zip(asked).for_each(|(schema, asked)| leave_out(schema, asked));
        }
        _ => {}
    }
}

/// Nor is anything required, in types that answers alone have, that has a default.
fn leave_defaults_out(schema: &mut Value) {
    match schema {
        Value::Object(keys) => {
            let has_default: Vec<String> = match keys.get("properties") {
                Some(Value::Object(properties)) => {
                    let with = properties.iter().filter(|(_, property)| property.get("default").is_some());
                    with.map(|(name, _)| name.clone()).collect()
                }
                _ => Vec::new(),
            };
            if let Some(Value::Array(required)) = keys.get_mut("required") {
                required.retain(|name| !has_default.iter().any(|other| name == other));
                if required.is_empty() {
                    keys.remove("required");
                }
            }
            keys.values_mut().for_each(leave_defaults_out);
        }
        Value::Array(list) => list.iter_mut().for_each(leave_defaults_out),
        _ => {}
    }
}

fn operation(endpoint: &Endpoint) -> Value {
    let answer = match &endpoint.answer {
        Answer::Json(schema) => json!({ "application/json": { "schema": schema } }),
        Answer::File(kind) => json!({ (*kind): { "schema": { "type": "string", "format": "binary" } } }),
    };
    let refusal = json!({
        "description": "Why there is no answer.",
        "content": { "application/json": { "schema": { "$ref": "#/components/schemas/Problem" } } },
    });
    let mut operation = json!({
        "summary": endpoint.doc,
        "responses": { "200": { "description": endpoint.doc, "content": answer }, "4XX": refusal },
    });
    if let Some(question) = &endpoint.question {
        operation["requestBody"] =
            json!({ "required": true, "content": { "application/json": { "schema": question } } });
    }
    operation
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_reference_leads_somewhere() {
        let description = openapi();
        let mut count = 0;
        check(&description, &description, &mut count);
        assert!(count > 100, "{count} references");
    }

    #[test]
    fn nothing_that_has_a_default_is_required() {
        let description = openapi();
        let question = description.pointer("/components/schemas/BalanceQuestion").unwrap();
        assert_eq!(question["required"], json!(["text"]));
        let answer = description.pointer("/components/schemas/Session/required").unwrap();
        assert!(
            answer.as_array().is_some_and(|all| all.len() == 6),
            "an answer has all its fields: {answer}"
        );
        let mut defaults = 0;
        look(&description, &mut defaults);
        assert!(defaults > 15, "{defaults} defaults");
    }

    fn look(value: &Value, defaults: &mut usize) {
        if let (Some(Value::Object(properties)), required) = (value.get("properties"), value.get("required"))
        {
            for (name, property) in properties {
                if property.get("default").is_some() {
                    *defaults += 1;
                    let required = required.and_then(Value::as_array);
                    assert!(!required.is_some_and(|all| all.iter().any(|other| other == name)), "{name}");
                }
            }
        }
        match value {
            Value::Object(keys) => keys.values().for_each(|value| look(value, defaults)),
            Value::Array(list) => list.iter().for_each(|value| look(value, defaults)),
            _ => {}
        }
    }

    fn check(value: &Value, root: &Value, count: &mut usize) {
        match value {
            Value::Object(keys) => {
                if let Some(Value::String(reference)) = keys.get("$ref") {
                    *count += 1;
                    let path = reference.strip_prefix('#').unwrap_or_else(|| panic!("{reference}"));
                    assert!(root.pointer(path).is_some(), "{reference}");
                }
                keys.values().for_each(|value| check(value, root, count));
            }
            Value::Array(list) => list.iter().for_each(|value| check(value, root, count)),
            _ => {}
        }
    }
}
