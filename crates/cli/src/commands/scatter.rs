//! `lanchester scatter`: what tolerances of the parts do to residual forces and couples.

use crate::commands::{json, open};
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::figures::write_figures;
use crate::files::print;
use crate::format::Format;
use crate::options::scatter::ScatterArguments;
use crate::run::{Head, run_alone, run_into};
use lanchester::file::EngineFile;
use lanchester::report::{scatter_brief, scatter_figure, scatter_table, scatter_text};
use lanchester::study::scatter::{ScatterOptions, ScatterStudy, Scattering, Tally, scatter_study_of};
use lanchester::task::option;
use lanchester::{SampleStudy, SavedScatter};

/// The request behind the options.
fn request(arguments: &ScatterArguments) -> Result<SavedScatter, Failure> {
    let speed = arguments.speed.as_deref().map(|text| option::speed(text, "--speed")).transpose()?;
    Ok(SavedScatter {
        speed,
        samples: arguments.samples,
        seed: arguments.seed,
        orders_only: arguments.orders_only,
        limits: arguments.limit.clone(),
        capability: arguments.capability.unwrap_or(ScatterOptions::default().capability),
    })
}

/// The run for an engine, its samples being rows or not.
pub fn sample_study(
    saved: &SavedScatter,
    file: &EngineFile,
    keeps_samples: bool,
) -> Result<SampleStudy, Failure> {
    let limit = |text: &String| option::limit(text, &file.engine, "--limit");
    let options = saved.options(saved.limits.iter().map(limit).collect::<Result<_, _>>()?);
    let request = options.request(&file.engine, &file.tasks.tolerances).map_err(Failure::refused)?;
    let scattering = Scattering::new(request).map_err(Failure::refused)?;
    Ok(SampleStudy { scattering, keeps_samples })
}

/// What is told of the samples that were drawn; `None` of no sample.
pub fn answer_of_samples(
    saved: &SavedScatter,
    study: &SampleStudy,
    tally: &Tally,
) -> Result<Option<ScatterStudy>, Failure> {
    scatter_study_of(&study.scattering, tally, saved.capability).map_err(Failure::refused)
}

pub fn run(arguments: &ScatterArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let saved = request(arguments)?;
    let opened = open(&arguments.file, colour)?;
    arguments.run.set_threads();
    let study = sample_study(&saved, &opened.file, arguments.run.save.is_some())?;
    let tally = match &arguments.run.save {
        None => run_alone(&study)?,
        Some(path) => {
            let head = Head::new("scatter", &saved, &opened.source.text)?;
            run_into(&study, &head, path, arguments.run.part)?
        }
    };
    let Some(answer) = answer_of_samples(&saved, &study, &tally)? else {
        eprintln!("no sample falls into this part: the run has fewer blocks than parts");
        return Ok(DONE);
    };
    if let Some(folder) = &arguments.figures {
        write_figures(folder, &arguments.file, &[scatter_figure(&answer)])?;
    }
    let whole = match arguments.format {
        Format::Text if arguments.printed.brief => scatter_brief(&answer),
        format => said(&answer, format)?,
    };
    print(&arguments.printed.said(arguments.format, whole))?;
    // A part alone is not the production: its limits are judged where parts are merged.
    Ok(if arguments.run.part.is_some() { DONE } else { status(&answer) })
}

/// The answer as it is printed.
pub fn said(answer: &ScatterStudy, format: Format) -> Result<String, Failure> {
    Ok(match format {
        Format::Text => scatter_text(answer),
        Format::Json => json(answer)?,
        Format::Csv => scatter_table(answer).csv(),
    })
}

/// Whether the limits are met, as an exit status.
pub fn status(answer: &ScatterStudy) -> u8 {
    if answer.limits.iter().all(|limit| limit.is_met) { DONE } else { NOT_AS_EXPECTED }
}
