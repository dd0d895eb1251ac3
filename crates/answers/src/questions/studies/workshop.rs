//! The sheet of a crank builder: bobweights from weighed parts, corrections, grade.

use crate::api::Api;
use crate::asker::Asker;
use crate::problem::Problem;
use crate::questions::reading::engine;
use lanchester::file::workshop::read_sheet;
use lanchester::report::workshop::{bobweight_text, correction_text, grade_text};
use lanchester::task::workshop::Sheet;
use lanchester::workshop::{
    Bobweight, BobweightComparison, WorkshopError, bobweight_answer, correction, grade,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A workshop sheet, and the engine that it is about.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct WorkshopQuestion {
    /// The workshop sheet.
    sheet: String,
    /// The engine file in the place of the one that the sheet names; none: the parts alone.
    #[serde(default)]
    text: Option<String>,
}

/// What a workshop sheet says of its crank.
#[derive(Debug, Serialize, JsonSchema)]
struct WorkshopAnswer {
    /// Bobweights, where the sheet has weighed parts.
    bobweights: Option<SheetBobweights>,
    /// What the commands of the workshop print, for all that the sheet has data for.
    printed: Vec<PrintedPart>,
    /// Mistakes that leave an answer, in words.
    warnings: Vec<String>,
}

/// Bobweights of a sheet.
#[derive(Debug, Serialize, JsonSchema)]
struct SheetBobweights {
    /// Share of the reciprocating masses.
    share: f64,
    /// Whether the sheet gives it; else it leaves the smallest first order.
    given: bool,
    /// What a derived share leaves least of; none where none was derived.
    judged_by: Option<&'static str>,
    /// Pin by pin.
    pins: Vec<Bobweight>,
    /// The engine with these parts, its crank balanced in different ways.
    comparison: Option<BobweightComparison>,
}

/// What a command prints.
#[derive(Debug, Serialize, JsonSchema)]
struct PrintedPart {
    /// The command.
    command: &'static str,
    /// Its text, or why there is none.
    text: String,
    /// Whether it is the answer, or the reason.
    answered: bool,
}

pub(super) fn questions(api: Api) -> Api {
    api.post("/api/workshop", "The sheet of a crank builder: `lanchester workshop`.", sheet)
}

fn sheet(_: &Asker, question: WorkshopQuestion) -> Result<WorkshopAnswer, Problem> {
    let reading = read_sheet(&question.sheet);
    let mistakes = reading.diagnostics;
    let Some(mut sheet) = reading.sheet else {
        let first = mistakes.first().map_or("", |diagnostic| diagnostic.message.as_str());
        let mut problem = Problem::refused(format!("the workshop sheet has mistakes: {first}"));
        problem.hint = mistakes.first().and_then(|first| first.hint.clone());
        return Err(problem);
    };
    let engine = question.text.as_deref().map(engine).transpose()?;
    if engine.is_some() {
        // The pins of a sheet stand for the throws of the engine, one after the other where it names none.
        for (index, pin) in sheet.bobweight.iter_mut().flat_map(|own| &mut own.pins).enumerate() {
            pin.throw = pin.throw.or(Some(index + 1));
        }
    }
    let mut printed = Vec::new();
    let bobweights = match &sheet.bobweight {
        None => None,
        Some(_) => {
            let answer = bobweight_answer(&sheet, engine.as_ref()).map_err(Problem::refused)?;
            printed.push(PrintedPart {
                command: "lanchester workshop bobweight",
                text: bobweight_text(&answer),
                answered: true,
            });
            Some(SheetBobweights {
                share: answer.reciprocating_share,
                given: answer.share_given,
                judged_by: answer.judged_by,
                pins: answer.bobweights,
                comparison: answer.comparison,
            })
        }
    };
    if has_measurements(&sheet) {
        let found = correction(&sheet).map(|found| correction_text(&found));
        printed.push(part("lanchester workshop correct", found));
    }
    if sheet.rotor.grade.is_some() {
        printed.push(part("lanchester workshop grade", grade(&sheet).map(|found| grade_text(&found))));
    }
    if printed.is_empty() {
        return Err(Problem::refused(
            "the sheet has nothing to work out\nhint: add [parts] with [bobweight], measurements as [[display]] or [[run]], or a grade to [rotor]",
        ));
    }
    let warnings = mistakes.into_iter().map(|warning| warning.message).collect();
    Ok(WorkshopAnswer { bobweights, printed, warnings })
}

fn has_measurements(sheet: &Sheet) -> bool {
    !sheet.displays.is_empty() || !sheet.runs.is_empty()
}

fn part(command: &'static str, found: Result<String, WorkshopError>) -> PrintedPart {
    match found {
        Ok(text) => PrintedPart { command, text, answered: true },
        Err(error) => PrintedPart { command, text: error.to_string(), answered: false },
    }
}
