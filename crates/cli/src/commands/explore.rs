//! `lanchester explore`: all layouts of given parts, and the Pareto-optimal ones.

use crate::commands::{Opened, json, open};
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::figures::write_figures;
use crate::files::{print, write_new};
use crate::format::Format;
use crate::options::explore::ExploreArguments;
use crate::requests::explore::{LayoutSearch, layout_search};
use crate::run::{Head, run_alone, run_into};
use crate::trace_files::trace_files;
use lanchester::file::{expanded, read, render};
use lanchester::model::Engine;
use lanchester::report::{
    layout_front_figure, layout_front_table, layout_ranking_table, layout_search_brief, layout_search_text,
};
use lanchester::study::explore::{Exploration, ExploreAnswer, Explorer};
use lanchester::task::{DurabilityMeter, Measured};
use lanchester::{
    DurabilityRequest, EngineDurability, LayoutRows, LayoutStudy, SavedSearch, adopted_layout, given_engine,
    layout_meter,
};
use lanchester_files::shown;
use std::path::Path;

pub fn run(arguments: &ExploreArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let opened = open(&arguments.file, colour)?;
    let LayoutSearch { explorer, mut notes, told } = layout_search(&opened.file.engine, arguments)?;
    let explorer = match told.is_empty() {
        true => explorer,
        false => {
            let engine = &opened.file.engine;
            let traces = trace_files(engine, &arguments.file)?;
            let own = EngineDurability::of_files(traces.clone(), DurabilityRequest::default());
            // What the engine of the file does not know its layouts do not know either.
            for measured in own.measure(engine, &told) {
                if let Measured::Unknown(why) = measured {
                    return Err(Failure::input(why.reason, &why.remedy));
                }
            }
            let meter =
                layout_meter(engine, traces, &explorer.request().space.parts, arguments.most_measured);
            explorer.with_meter(meter)
        }
    };
    arguments.run.set_threads();
    let rows = match (&arguments.run.save, arguments.front_only) {
        (None, _) => LayoutRows::Nothing,
        (Some(_), true) => LayoutRows::Front,
        (Some(_), false) => LayoutRows::Judged,
    };
    let study = LayoutStudy { explorer, rows };
    let found = match &arguments.run.save {
        None => run_alone(&study)?,
        Some(path) => {
            let request = study.explorer.request().clone();
            let saved = SavedSearch { request, rows, notes: notes.clone() };
            run_into(&study, &Head::new("explore", &saved, &opened.source.text)?, path, arguments.run.part)?
        }
    };
    let engine = &opened.file.engine;
    if !study.explorer.request().at_least.is_empty() {
        notes.push(format!(
            "films and safeties were computed for {} layouts: those that no other layout covers",
            study.explorer.measured_layouts()
        ));
    }
    let mut answer = answer_of(engine, &study.explorer, &found, notes)?;
    if !told.is_empty() {
        study.explorer.tell_durability(&mut answer, &told, arguments.rows).map_err(Failure::refused)?;
    }
    if let Some(folder) = arguments.figures.as_deref().filter(|_| !answer.front.is_empty()) {
        write_figures(folder, &arguments.file, &[layout_front_figure(&answer)])?;
    }
    if let Some(number) = arguments.adopt {
        adopt(&opened, arguments, &study.explorer, &answer, number, colour)?;
    }
    let answered = match arguments.format {
        Format::Text if arguments.printed.brief => layout_search_brief(&answer),
        format => said(&answer, format, arguments.rows, arguments.ranking)?,
    };
    print(&arguments.printed.said(arguments.format, answered))?;
    Ok(if answer.front.is_empty() { NOT_AS_EXPECTED } else { DONE })
}

/// The answer with the engine of the file in it.
pub fn answer_of(
    engine: &Engine,
    explorer: &Explorer,
    found: &Exploration,
    notes: Vec<String>,
) -> Result<ExploreAnswer, Failure> {
    let mut answer = explorer.answer(found, &engine.name, notes).map_err(Failure::refused)?;
    answer.given = Some(given_engine(engine, explorer, &answer).map_err(Failure::refused)?);
    Ok(answer)
}

/// The answer as it is printed.
pub fn said(answer: &ExploreAnswer, format: Format, rows: usize, ranking: bool) -> Result<String, Failure> {
    Ok(match format {
        Format::Text => layout_search_text(answer, rows, ranking),
        Format::Json => json(answer)?,
        Format::Csv if ranking => layout_ranking_table(answer).csv(),
        Format::Csv => layout_front_table(answer).csv(),
    })
}

/// Writes a layout as an engine file.
fn adopt(
    opened: &Opened,
    arguments: &ExploreArguments,
    explorer: &Explorer,
    answer: &ExploreAnswer,
    number: usize,
    colour: bool,
) -> Result<(), Failure> {
    let list = if arguments.ranking { &answer.ranking } else { &answer.front };
    let found = number.checked_sub(1).and_then(|index| list.get(index)).ok_or_else(|| {
        Failure::input(
            format_args!("--adopt needs the number of a layout, 1 to {}, got {number}", list.len()),
            "leave --adopt out to see them",
        )
    })?;
    let engine =
        adopted_layout(&opened.file.engine, explorer, found.layout.case).map_err(Failure::refused)?;
    let text = expanded(&engine.into());
    let reading = read(&text);
    if reading.file.is_none() {
        eprint!("{}", render(&reading.diagnostics, "the engine file of the layout", &text, colour));
        return Err(Failure::input(
            format_args!("layout {number} cannot be written as an engine file"),
            "see above for what is in the way",
        ));
    }
    let path = arguments.output.as_deref().unwrap_or(Path::new("-"));
    write_new(path, &text)?;
    eprintln!("layout {number} written into {}", shown(path));
    Ok(())
}
