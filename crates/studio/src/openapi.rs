//! The description of all questions and answers as OpenAPI 3.1, whose schemas are JSON Schemas.

use crate::api::{Answer, Api, Endpoint};
use serde_json::{Map, Value, json};

/// The description.
pub fn openapi() -> Value {
    let mut api = Api::new();
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
            "schemas": api.schemas.take_definitions(true),
            "securitySchemes": { "token": { "type": "apiKey", "in": "header", "name": "X-Lanchester-Token" } },
        },
    })
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
