//! All questions by name.

mod balancing;
mod crank_cycle;
mod crankshaft;
mod in_time;
mod layouts;
mod loads;
mod sheets;
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
pub use sheets::SheetQuestion;
use std::collections::BTreeMap;
use std::sync::Arc;

fn all() -> impl Iterator<Item = &'static Question> {
    let lists: [&'static [Question]; 10] = [
        &loads::QUESTIONS,
        &turning::QUESTIONS,
        &balancing::QUESTIONS,
        &studies::QUESTIONS,
        &layouts::QUESTIONS,
        &in_time::QUESTIONS,
        &crankshaft::QUESTIONS,
        &crank_cycle::QUESTIONS,
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

/// The question of this name about a workshop sheet.
///
/// # Errors
/// Where there is none: the package is not of one piece.
pub fn sheet_question(name: &str) -> Result<&'static SheetQuestion, Failure> {
    sheets::QUESTIONS.iter().find(|question| question.name == name).ok_or_else(|| {
        let names: Vec<&str> = sheets::QUESTIONS.iter().map(|question| question.name).collect();
        Failure::option(
            format_args!("there is no question \"{name}\" about a workshop sheet"),
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
    let of_sheets = sheets::QUESTIONS.iter().map(|question| (question.name, question.schema));
    for (question, schema) in all().map(|question| (question.name, question.schema)).chain(of_sheets) {
        let schema = schema(&mut generator);
        let name = schema.get("$ref").and_then(Value::as_str).and_then(|path| path.rsplit('/').next());
        names.insert(question, name.unwrap_or_default().to_owned());
    }
    (Value::Object(generator.take_definitions(true)), names)
}
