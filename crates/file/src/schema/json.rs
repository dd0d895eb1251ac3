//! The JSON Schema of the engine file, for completion and checking in editors.

use super::{FILE, Key, Kind, Need, Table};
use crate::workshop::SHEET;
use lanchester_units::{ALIASES, Bound, Dimension};
use serde_json::{Map, Value, json};

/// JSON Schema (draft 2020-12) of the engine file.
///
/// It says what each key holds; what only the engine as a whole can tell, [`read`](crate::read) checks.
pub fn json_schema() -> Value {
    schema_of(&FILE, "engine-file", "Lanchester engine file")
}

/// JSON Schema (draft 2020-12) of the workshop sheet.
pub fn sheet_schema() -> Value {
    schema_of(&SHEET, "workshop-sheet", "Lanchester workshop sheet")
}

/// What the name of every schema of ours begins with.
pub const SCHEMA_ID: &str = "urn:lanchester:";

fn schema_of(file: &Table, name: &str, title: &str) -> Value {
    let Value::Object(mut root) = table_schema(file) else { return Value::Null };
    let mut schema = Map::new();
    schema.insert("$schema".into(), json!("https://json-schema.org/draft/2020-12/schema"));
    schema.insert("$id".into(), json!(format!("{SCHEMA_ID}{name}:{}", env!("CARGO_PKG_VERSION"))));
    schema.insert("title".into(), json!(title));
    schema.append(&mut root);
    let definitions: Map<String, Value> = Dimension::ALL
        .iter()
        .map(|dimension| (definition_name(*dimension), quantity_schema(*dimension)))
        .collect();
    schema.insert("$defs".into(), Value::Object(definitions));
    Value::Object(schema)
}

fn table_schema(table: &Table) -> Value {
    let properties: Map<String, Value> =
        table.keys.iter().map(|key| (key.name.to_string(), key_schema(key))).collect();
    let required: Vec<&str> =
        table.keys.iter().filter(|key| key.need == Need::Required).map(|key| key.name).collect();
    json!({
        "type": "object",
        "description": table.doc,
        "properties": properties,
        "required": required,
        "additionalProperties": false,
    })
}

fn key_schema(key: &Key) -> Value {
    let list = |items: Value| json!({ "type": "array", "items": items });
    let mut schema = match key.kind {
        Kind::Flag => json!({ "type": "boolean" }),
        Kind::Text(most) => json!({ "type": "string", "minLength": 1, "maxLength": most }),
        Kind::Whole(least, most) => json!({ "type": "integer", "minimum": least, "maximum": most }),
        Kind::Wholes(least, most) => list(json!({ "type": "integer", "minimum": least, "maximum": most })),
        Kind::WholeChoice(choices) => json!({ "enum": choices }),
        Kind::Choice(words) => json!({ "enum": words }),
        Kind::Quantity(dimension, bound) => bounded(dimension, bound),
        Kind::Quantities(dimension, bound) => list(bounded(dimension, bound)),
        Kind::QuantityOrPair(dimension, bound) => json!({ "anyOf": [
            bounded(dimension, bound),
            { "type": "array", "items": bounded(dimension, bound), "minItems": 2, "maxItems": 2 },
        ] }),
        Kind::QuantityOrThree(dimension, bound) => json!({ "anyOf": [
            bounded(dimension, bound),
            { "type": "array", "items": bounded(dimension, bound), "minItems": 3, "maxItems": 3 },
        ] }),
        Kind::QuantityOrWord(dimension, bound, word) => {
            json!({ "anyOf": [bounded(dimension, bound), { "enum": [word] }] })
        }
        Kind::Share => share_schema(),
        Kind::ShareOrPair => {
            let share = share_schema();
            json!({ "anyOf": [share, { "type": "array", "items": share, "minItems": 2, "maxItems": 2 }] })
        }
        Kind::ShareOrThree => {
            let share = share_schema();
            json!({ "anyOf": [share, { "type": "array", "items": share, "minItems": 3, "maxItems": 3 }] })
        }
        Kind::Direction => {
            json!({ "type": "array", "items": { "type": "number" }, "minItems": 3, "maxItems": 3 })
        }
        Kind::Number(Bound::Any) => json!({ "type": "number" }),
        Kind::Number(Bound::NotNegative) => json!({ "type": "number", "minimum": 0 }),
        Kind::Number(Bound::Positive) => json!({ "type": "number", "exclusiveMinimum": 0 }),
        Kind::Truth => json!({ "type": "boolean" }),
        Kind::Stages => json!({
            "type": "array",
            "items": { "anyOf": [{ "type": "string" }, criteria_with_values(&CRITERION_DIMENSIONS)] },
            "minItems": 1,
        }),
        Kind::Amounts => {
            let amounts = [Dimension::Mass, Dimension::Unbalance].map(|own| bounded(own, Bound::Positive));
            let one = json!({ "anyOf": amounts });
            json!({ "anyOf": [one, list(one.clone())] })
        }
        Kind::Orders => json!({ "type": "array", "items": { "type": "string" }, "minItems": 1 }),
        Kind::Durabilities => json!({ "type": "array", "items": { "type": "string" }, "minItems": 1 }),
        Kind::AtLeast => json!({
            "type": "object",
            "additionalProperties": { "anyOf": [
                bounded(Dimension::Length, Bound::Positive),
                { "type": "number", "exclusiveMinimum": 0 },
            ] },
            "minProperties": 1,
        }),
        Kind::Limits => criteria_with_values(&CRITERION_DIMENSIONS),
        Kind::GiveUps => criteria_with_values(&[&CRITERION_DIMENSIONS[..], &[Dimension::Share]].concat()),
        Kind::Ratio => json!({ "anyOf": [
            { "type": "integer", "not": { "const": 0 } },
            { "type": "string", "pattern": "^\\s*[+-]?0*[1-9][0-9]*\\s*(/\\s*0*[1-9][0-9]*\\s*)?$" },
        ] }),
        Kind::Order => json!({ "anyOf": [
            { "type": "number", "minimum": 0 },
            { "type": "string", "pattern": "^\\s*\\+?[0-9]+\\s*(/\\s*0*[1-9][0-9]*\\s*)?$" },
        ] }),
        Kind::Table(table) => table_schema(table),
        Kind::ValuesOrTables(table, most) => {
            let value = table.keys.first().map_or_else(|| json!({}), key_schema);
            let items = json!({ "anyOf": [value, table_schema(table)] });
            json!({ "type": "array", "items": items, "maxItems": most })
        }
        Kind::Tables(table, most) => {
            json!({ "type": "array", "items": table_schema(table), "maxItems": most })
        }
    };
    if let Value::Object(object) = &mut schema {
        object.insert("description".into(), json!(key.doc));
        if !matches!(key.kind, Kind::Table(_) | Kind::Tables(..) | Kind::ValuesOrTables(..))
            && let Ok(example) = serde_json::from_str::<Value>(key.example)
        {
            object.insert("examples".into(), json!([example]));
        }
    }
    schema
}

/// A percentage, or a bare fraction.
fn share_schema() -> Value {
    json!({ "anyOf": [
        bounded(Dimension::Share, Bound::NotNegative),
        { "type": "number", "minimum": 0 },
    ] })
}

/// A table whose keys are criteria: each value is a quantity in a unit of its criterion.
/// What criteria measure.
const CRITERION_DIMENSIONS: [Dimension; 4] =
    [Dimension::Force, Dimension::Torque, Dimension::Mass, Dimension::Unbalance];

fn criteria_with_values(dimensions: &[Dimension]) -> Value {
    let values: Vec<Value> =
        dimensions.iter().map(|dimension| bounded(*dimension, Bound::NotNegative)).collect();
    json!({ "type": "object", "additionalProperties": { "anyOf": values }, "minProperties": 1 })
}

fn bounded(dimension: Dimension, bound: Bound) -> Value {
    let reference = format!("#/$defs/{}", definition_name(dimension));
    match bound {
        Bound::Any => json!({ "$ref": reference }),
        // What counts from the ice point may be negative there.
        _ if dimension == Dimension::Temperature => json!({ "$ref": reference }),
        Bound::NotNegative | Bound::Positive => json!({ "$ref": reference, "pattern": "^\\s*[^\\s-]" }),
    }
}

fn definition_name(dimension: Dimension) -> String {
    dimension.name().replace(' ', "-")
}

/// A text of a number and a unit. A product may be spelled `kg m`, `kg*m`, `kg·m` or `kgm`.
fn quantity_schema(dimension: Dimension) -> Value {
    let aliases = ALIASES.iter().filter(|(_, name)| dimension.units().any(|unit| unit.name == *name));
    let units: Vec<String> = dimension
        .units()
        .map(|unit| {
            let name = unit.name.replace(' ', "\\s*[*·⋅]?\\s*");
            let power =
                |base: &str, digit: char, raised: char| format!("{base}({digit}|\\^{digit}|{raised})");
            let name = match (name.strip_suffix('2'), name.strip_suffix('3')) {
                (Some(base), _) => power(base, '2', '²'),
                (_, Some(base)) => power(base, '3', '³'),
                _ => name,
            };
            name.replace("um", "[uµμ]m")
        })
        .chain(aliases.map(|(alias, _)| alias.replace("min-1", "min(\\^?-1|⁻¹)")))
        .collect();
    json!({
        "type": "string",
        "description": format!("{} with its unit: {}", dimension.with_article(), dimension.unit_list()),
        "pattern": format!(
            "^\\s*[+-]?((([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)?)|([0-9]+ +)?[0-9]+/[0-9]+)\\s*({})\\s*$",
            units.join("|")
        ),
    })
}
