//! All questions by name.

mod balancing;
mod crankshaft;
mod in_time;
mod layouts;
mod loads;
mod studies;
mod torsion;
mod turning;
mod workshop;

use crate::blocks::Blocks;
use crate::failure::Failure;
use crate::options::Options;
use crate::prepared::Prepared;
use crate::question::Question;
use schemars::generate::SchemaSettings;
use serde_json::Value;
use std::collections::BTreeMap;
use std::sync::Arc;

fn all() -> impl Iterator<Item = &'static Question> {
    let lists: [&'static [Question]; 9] = [
        &loads::QUESTIONS,
        &turning::QUESTIONS,
        &balancing::QUESTIONS,
        &studies::QUESTIONS,
        &layouts::QUESTIONS,
        &in_time::QUESTIONS,
        &crankshaft::QUESTIONS,
        &torsion::QUESTIONS,
        &workshop::QUESTIONS,
    ];
    lists.into_iter().flatten()
}

/// The question of this name.
///
/// # Errors
/// Where there is none: the package is not of one piece.
pub fn question(name: &str) -> Result<&'static Question, Failure> {
    all().find(|question| question.name == name).ok_or_else(|| {
        let names: Vec<&str> = all().map(|question| question.name).collect();
        Failure::option(
            format_args!("there is no question \"{name}\""),
            format_args!("one of {}", names.join(", ")),
        )
    })
}

/// The study behind a question in blocks, whose rows are its cases; `None` where its cases are those of many engines.
///
/// # Errors
/// Where the arguments cannot be used.
pub fn blocks(
    name: &str,
    options: &Options<'_>,
    own: &Arc<Prepared>,
) -> Result<Option<Box<dyn Blocks>>, Failure> {
    match name {
        "explore" => layouts::explore_blocks(options, own).map(Some),
        "scatter" => studies::scatter_blocks(options, own).map(Some),
        _ => Ok(None),
    }
}

/// The schemas of all answers, and for every question the name of the schema of its answer.
pub fn schemas() -> (Value, BTreeMap<&'static str, String>) {
    let mut generator = SchemaSettings::draft2020_12().for_serialize().into_generator();
    let mut names = BTreeMap::new();
    for question in all() {
        let schema = (question.schema)(&mut generator);
        let name = schema.get("$ref").and_then(Value::as_str).and_then(|path| path.rsplit('/').next());
        names.insert(question.name, name.unwrap_or_default().to_owned());
    }
    (Value::Object(generator.take_definitions(true)), names)
}
