//! `lanchester scatter`: what tolerances of the parts do to residual forces and couples.

use crate::commands::{json, open, write_figures};
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED, WRONG_INPUT};
use crate::files::print;
use crate::format::Format;
use crate::scatter_arguments::ScatterArguments;
use lanchester::model::option;
use lanchester::report::{scatter_figure, scatter_table, scatter_text};
use lanchester::study::scatter::{ScatterOptions, scatter_study};

pub fn run(arguments: &ScatterArguments, colour: bool) -> Result<u8, Failure> {
    let speed = arguments.speed.as_deref().map(|text| option::speed(text, "--speed")).transpose()?;
    let engine = open(&arguments.file, colour)?.engine;
    let limit = |text: &String| option::limit(text, &engine.mounts, "--limit");
    let standard = ScatterOptions::default();
    let options = ScatterOptions {
        speed,
        samples: arguments.samples,
        seed: arguments.seed,
        peaks: !arguments.orders_only,
        limits: arguments.limit.iter().map(limit).collect::<Result<_, _>>()?,
        capability: arguments.capability.unwrap_or(standard.capability),
    };
    let study = scatter_study(&engine, &options)
        .map_err(|error| Failure { status: WRONG_INPUT, message: format!("error: {error}") })?;
    if let Some(folder) = &arguments.figures {
        write_figures(folder, &arguments.file, &[scatter_figure(&study)])?;
    }
    print(&match arguments.format {
        Format::Text => scatter_text(&study),
        Format::Json => json(&study)?,
        Format::Csv => scatter_table(&study).csv(),
    })?;
    Ok(if study.limits.iter().all(|limit| limit.is_met) { DONE } else { NOT_AS_EXPECTED })
}
