//! `lanchester bearings`: what pistons, pins and bearings carry.

use crate::commands::{json, open, write_figures};
use crate::failure::{DONE, Failure};
use crate::files::print;
use crate::format::Format;
use crate::options::torque::{BearingsArguments, FilmOption, PartOption};
use crate::trace_files::trace_files;
use lanchester::film::Cavitation;
use lanchester::mechanism::{BearingLoads, BearingPart, BearingRequest};
use lanchester::report::{bearing_figures, bearings_csv, bearings_text, films_csv, films_text};
use lanchester::task::option;
use lanchester::{bearing_films, bearing_report, bearing_sizes};
use serde::Serialize;

/// Loads with counterweights, and without where the engine has some.
#[derive(Serialize)]
struct WithAndWithout<'a> {
    #[serde(flatten)]
    loads: &'a BearingLoads,
    without_counterweights: Option<&'a BearingLoads>,
}

pub fn run(arguments: &BearingsArguments, colour: bool) -> Result<u8, Failure> {
    let speed = arguments.speed.as_deref().map(|text| option::speed(text, "--speed").map_err(Failure::from));
    let speed = speed.transpose()?;
    let opened = open(&arguments.file, colour)?;
    let engine = &opened.file.engine;
    let traces = trace_files(engine, &arguments.file)?;
    let part = match (engine.gas.is_some(), arguments.part) {
        (false, PartOption::Gas) => {
            return Err(Failure::input(
                "the engine file says nothing of the gas",
                "add [gas] with [[gas.trace]] or [gas.cycle]",
            ));
        }
        (false, _) | (true, PartOption::Inertia) => BearingPart::Inertia,
        (true, PartOption::All) => BearingPart::All,
        (true, PartOption::Gas) => BearingPart::Gas,
    };
    let loads = |part, counterweights| {
        let samples = arguments.samples as usize;
        let request = BearingRequest { speed, part, counterweights, samples };
        bearing_report(engine, &traces, &request).map_err(Failure::refused)
    };
    let found = loads(part, true)?;
    if let Some(models) = &arguments.film {
        let models: Vec<Cavitation> = models.iter().map(|model| model_of(*model)).collect();
        let films = bearing_films(engine, &found, &models).map_err(Failure::refused)?;
        print(&match arguments.format {
            Format::Text => films_text(&films.engine, films.speed, &films.films, &films.assumptions),
            Format::Json => json(&films)?,
            Format::Csv => films_csv(films.period, &films.films),
        })?;
        return Ok(DONE);
    }
    let has_weights = part != BearingPart::Gas && engine.counterweights.iter().any(|w| w.unbalance > 0.0);
    let bare = if has_weights { Some(loads(part, false)?) } else { None };
    let mut parts = vec![found.clone()];
    if part == BearingPart::All {
        parts.push(loads(BearingPart::Gas, true)?);
        parts.push(loads(BearingPart::Inertia, true)?);
    }
    if let Some(folder) = &arguments.figures {
        write_figures(folder, &arguments.file, &bearing_figures(&parts))?;
    }
    print(&match arguments.format {
        Format::Text => bearings_text(&found, &parts, bare.as_ref(), bearing_sizes(engine)),
        Format::Json => json(&WithAndWithout { loads: &found, without_counterweights: bare.as_ref() })?,
        Format::Csv => bearings_csv(&found),
    })?;
    Ok(DONE)
}

fn model_of(option: FilmOption) -> Cavitation {
    match option {
        FilmOption::Full => Cavitation::Full,
        FilmOption::Gumbel => Cavitation::Gumbel,
        FilmOption::Reynolds => Cavitation::Reynolds,
    }
}
