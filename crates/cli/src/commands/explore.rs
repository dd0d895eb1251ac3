//! `lanchester explore`: all layouts of given parts, and those that nothing beats.

use crate::commands::{Opened, json, open, write_figures};
use crate::explore_arguments::ExploreArguments;
use crate::explore_request::{LayoutSearch, layout_search, refused};
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::files::{print, write_new};
use crate::format::Format;
use lanchester::model::{expanded, read, render};
use lanchester::report::{layout_front_figure, layout_front_table, layout_ranking_table, layout_search_text};
use lanchester::study::explore::{ExploreAnswer, Explorer};
use lanchester::{adopted_layout, given_engine};

pub fn run(arguments: &ExploreArguments, colour: bool) -> Result<u8, Failure> {
    let opened = open(&arguments.file, colour)?;
    let LayoutSearch { explorer, notes } = layout_search(&opened.engine, arguments)?;
    let found = explorer.explore().map_err(refused)?;
    let mut answer = explorer.answer(&found, &opened.engine.name, notes).map_err(refused)?;
    answer.given = Some(given_engine(&opened.engine, &explorer, &answer).map_err(refused)?);
    if let Some(folder) = arguments.figures.as_deref().filter(|_| !answer.front.is_empty()) {
        write_figures(folder, &arguments.file, &[layout_front_figure(&answer)])?;
    }
    if let Some(number) = arguments.adopt {
        adopt(&opened, arguments, &explorer, &answer, number, colour)?;
    }
    print(&match arguments.format {
        Format::Text => layout_search_text(&answer, arguments.rows, arguments.ranking),
        Format::Json => json(&answer)?,
        Format::Csv if arguments.ranking => layout_ranking_table(&answer).csv(),
        Format::Csv => layout_front_table(&answer).csv(),
    })?;
    Ok(if answer.front.is_empty() { NOT_AS_EXPECTED } else { DONE })
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
    let engine = adopted_layout(&opened.engine, explorer, found.layout.case).map_err(refused)?;
    let text = expanded(&engine);
    let reading = read(&text);
    if reading.engine.is_none() {
        eprint!("{}", render(&reading.diagnostics, "the engine file of the layout", &text, colour));
        return Err(Failure::input(
            format_args!("layout {number} cannot be written as an engine file"),
            "see above for what is in the way",
        ));
    }
    let path = arguments.output.as_deref().unwrap_or_else(|| std::path::Path::new("-"));
    write_new(path, &text)?;
    eprintln!("layout {number} written into {}", path.display());
    Ok(())
}
