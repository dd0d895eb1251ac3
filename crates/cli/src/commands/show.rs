//! `lanchester show`: the expanded form and the drawing.

use crate::arguments::{Format, ShowArguments};
use crate::commands::{json, open, refused};
use crate::failure::{DONE, Failure};
use crate::files::{print, write_result};
use lanchester::mechanism::{LoadRequest, loads};
use lanchester::model::expanded;
use lanchester::report::{drawing, motion_table};

pub fn run(arguments: &ShowArguments, colour: bool) -> Result<u8, Failure> {
    let opened = open(&arguments.file, colour)?;
    let engine = &opened.engine;
    if let Some(path) = &arguments.drawing {
        write_result(path, &arguments.file, &drawing(engine).svg())?;
    }
    let request = LoadRequest { samples: 1, ..LoadRequest::default() };
    print(&match arguments.format {
        Format::Text => {
            let loads = loads(engine, &request).map_err(refused)?;
            // The table stands in comments, so that the whole output is an engine file again.
            let mut out = String::new();
            for line in motion_table(&loads).text().lines() {
                out += format!("# {line}").trim_end();
                out.push('\n');
            }
            out + "\n" + &expanded(engine)
        }
        Format::Json => json(engine)?,
        Format::Csv => motion_table(&loads(engine, &request).map_err(refused)?).csv(),
    })?;
    Ok(DONE)
}
