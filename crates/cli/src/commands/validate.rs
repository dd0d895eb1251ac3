//! `lanchester validate`: printed against computed.

use crate::arguments::ValidateArguments;
use crate::commands::json;
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::files::{print, tell, write_result};
use crate::format::Format;
use lanchester_validation::{
    AtlasFigure, FigureVerdict, atlas, atlas_markdown, atlas_page, csv, markdown, suite, text, validate,
};
use std::path::Path;

/// No engine file is read: no result can write over one.
const NO_ENGINE: &str = "";

pub fn run(arguments: &ValidateArguments) -> Result<u8, Failure> {
    if let Some(folder) = &arguments.figures {
        return figures(arguments, folder);
    }
    if let Some(file) = &arguments.suite {
        return suite_file(arguments, file);
    }
    let validation = validate(arguments.filter.as_deref());
    if validation.sources.is_empty() {
        return Err(nothing(arguments));
    }
    print(&match arguments.format {
        _ if arguments.markdown => markdown(&validation),
        Format::Text => text(&validation, arguments.verbose),
        Format::Json => json(&validation)?,
        Format::Csv => csv(&validation),
    })?;
    Ok(if validation.passed() { DONE } else { NOT_AS_EXPECTED })
}

/// The reference suite.
fn suite_file(arguments: &ValidateArguments, file: &Path) -> Result<u8, Failure> {
    let found = suite(arguments.filter.as_deref());
    if found.rows.is_empty() {
        return Err(nothing(arguments));
    }
    write_result(file, Path::new(NO_ENGINE), &json(&found)?)?;
    print(&format!(
        "{} rows, {} engines, version {}\n",
        found.rows.len(),
        found.engines.len(),
        found.version
    ))?;
    Ok(DONE)
}

fn nothing(arguments: &ValidateArguments) -> Failure {
    Failure::input(
        format_args!("no source or table contains `{}`", arguments.filter.as_deref().unwrap_or_default()),
        "`lanchester validate` without a filter lists all of them",
    )
}

/// The atlas of the sources' figures.
fn figures(arguments: &ValidateArguments, folder: &Path) -> Result<u8, Failure> {
    let found = atlas(arguments.filter.as_deref());
    if found.sources.is_empty() {
        return Err(Failure::input(
            format_args!("no figure contains `{}`", arguments.filter.as_deref().unwrap_or_default()),
            "for example `lanchester validate 'twin-cylinder-thesis Figure 18' --figures atlas`",
        ));
    }
    found.figures().try_for_each(|figure| write(folder, figure))?;
    write_result(&folder.join("index.html"), Path::new(NO_ENGINE), &atlas_page(&found))?;
    print(&if arguments.markdown {
        atlas_markdown(&found)
    } else {
        let listed = FigureVerdict::ALL.map(|verdict| (found.count(verdict), verdict.name()));
        let lines = listed.iter().filter(|(count, _)| *count > 0);
        let lines: String = lines.map(|(count, name)| format!("{count:5}  {name}\n")).collect();
        let sources = found.sources.len();
        format!("Figures of {sources} {}\n{lines}", if sources == 1 { "source" } else { "sources" })
    })?;
    Ok(if found.passed() { DONE } else { NOT_AS_EXPECTED })
}

/// A figure and the values of its curves.
fn write(folder: &Path, figure: &AtlasFigure) -> Result<(), Failure> {
    match &figure.svg {
        Some(Ok(svg)) => write_result(&folder.join(figure.file()), Path::new(NO_ENGINE), svg)?,
        Some(Err(why)) => tell(format_args!("{} cannot be drawn: {why}", figure.id)),
        None => {}
    }
    match figure.csv() {
        Some(values) => {
            write_result(&folder.join(format!("{}.csv", figure.id)), Path::new(NO_ENGINE), &values)
        }
        None => Ok(()),
    }
}
