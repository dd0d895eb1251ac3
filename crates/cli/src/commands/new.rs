//! `lanchester new`: an engine file to start from.

use crate::arguments::NewArguments;
use crate::commands::complete::{completed, tell_of};
use crate::commands::json;
use crate::failure::{DONE, Failure};
use crate::files::{print, tell, write_new, write_own};
use crate::format::Format;
use lanchester::file::{SCHEMA_ID, json_schema, nearest_template, template, templates};
use lanchester::report::csv_text;
use lanchester_files::shown;
use std::path::Path;

/// The schema beside engine files, for completion in editors.
const SCHEMA: &str = "lanchester.schema.json";

pub fn run(arguments: &NewArguments, colour: bool) -> Result<u8, Failure> {
    let Some(name) = &arguments.name else { return list(arguments.format) };
    let Some(template) = template(name) else {
        let nearest =
            nearest_template(name).map_or(String::new(), |near| format!("did you mean {}? ", near.name));
        return Err(Failure::input(
            format_args!("there is no layout `{name}` in the gallery"),
            format_args!("{nearest}`lanchester new --list` shows all of them"),
        ));
    };
    let completed = match arguments.complete {
        true => {
            let completed = completed(template.text, &[], None, colour)?;
            tell_of(&completed, template.name);
            Some(completed.text)
        }
        false => None,
    };
    let text = completed.as_deref().unwrap_or(template.text);
    match &arguments.output {
        Some(path) if arguments.no_schema => {
            write_new(path, text)?;
            print(&format!("{}\n", shown(path)))?;
        }
        Some(path) => {
            write_new(path, format!("#:schema ./{SCHEMA}\n{text}"))?;
            print(&format!("{}\n", shown(path)))?;
            keep_schema(path)?;
        }
        None => print(text)?,
    }
    Ok(DONE)
}

/// Puts the schema that the first line of an engine file names beside it.
fn keep_schema(engine_file: &Path) -> Result<(), Failure> {
    let place = engine_file.with_file_name(SCHEMA);
    let is_kept = write_own(&place, SCHEMA_ID, &json(&json_schema())?)?;
    if !is_kept {
        tell(format_args!(
            "note: {} is no schema of lanchester and is left alone; `lanchester schema` prints the one that editors complete from",
            shown(&place)
        ));
    }
    Ok(())
}

fn list(format: Format) -> Result<u8, Failure> {
    let width = templates().iter().map(|template| template.name.len()).max().unwrap_or(0);
    let mut out = String::new();
    match format {
        Format::Text => {
            for template in templates() {
                out += &format!("{:width$}  {}\n", template.name, template.title);
            }
        }
        Format::Csv => {
            out += "name,title\n";
            for template in templates() {
                out += &format!("{},{}\n", template.name, csv_text(template.title));
            }
        }
        Format::Json => {
            let list: Vec<_> = templates()
                .iter()
                .map(|template| serde_json::json!({ "name": template.name, "title": template.title }))
                .collect();
            out = json(&list)?;
        }
    }
    print(&out)?;
    Ok(DONE)
}
