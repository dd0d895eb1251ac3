//! `lanchester bearings`: what pistons, pins and bearings carry.

use crate::commands::{json, open};
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::figures::write_figures;
use crate::files::{print, tell};
use crate::format::Format;
use crate::options::torque::{BearingsArguments, FilmOption, PartOption};
use crate::trace_files::trace_files;
use lanchester::film::{BALANCED, BearingFilm, BearingKind, Cavitation, OrbitOutcome};
use lanchester::mechanism::{BearingLoads, BearingPart, BearingRequest};
use lanchester::model::Engine;
use lanchester::report::{
    Figure, bearing_figures, bearings_brief, bearings_csv, bearings_text, film_figures, films_csv,
    films_over_speed_figure, films_over_speed_table, films_text, words_before_tables,
};
use lanchester::task::option;
use lanchester::value_list;
use lanchester::{
    BearingFilms, FilmMethod, bearing_films, bearing_films_over_speed, bearing_report, bearing_sizes,
};
use serde::Serialize;

/// Loads with counterweights, and without where the engine has some.
#[derive(Serialize)]
struct WithAndWithout<'a> {
    #[serde(flatten)]
    loads: &'a BearingLoads,
    without_counterweights: Option<&'a BearingLoads>,
}

pub fn run(arguments: &BearingsArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let speed = arguments.speed.as_deref().map(|text| option::speed(text, "--speed").map_err(Failure::from));
    let speed = speed.transpose()?;
    let wanted = match &arguments.least_film {
        Some(text) => Some(wanted_film(text)?),
        None => None,
    };
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
    let loads_at = |speed, part, counterweights| {
        let samples = arguments.samples as usize;
        let request = BearingRequest { speed, part, counterweights, samples };
        bearing_report(engine, &traces, &request).map_err(Failure::refused)
    };
    let loads = |part, counterweights| loads_at(speed, part, counterweights);
    if let Some(models) = &arguments.film {
        let models: Vec<Cavitation> = models.iter().map(|model| model_of(*model)).collect();
        let is_conserving = models.contains(&Cavitation::MassConserving);
        let method = match (arguments.dynamic, arguments.grooves || is_conserving) {
            (true, true) => {
                return Err(Failure::input(
                    "--dynamic moves the crankshaft by tables of films, which mass-conserving films do not have",
                    "ask for gumbel, reynolds or full, or leave out --dynamic",
                ));
            }
            (true, false) => FilmMethod::RigidShaft,
            (false, true) => FilmMethod::Grooved,
            (false, false) => FilmMethod::Tables,
        };
        let draw = |figures: &[Figure]| match &arguments.figures {
            Some(folder) => write_figures(folder, &arguments.file, figures).map(drop),
            None => Ok(()),
        };
        let (text, found) = match &arguments.speeds {
            Some(list) => {
                let speeds = value_list(list, "--speeds", |one| option::speed(one, "--speeds"))?;
                let loads = speeds.into_iter().map(|speed| loads_at(Some(speed), part, true));
                films_over_speed(
                    engine,
                    &loads.collect::<Result<Vec<_>, _>>()?,
                    &models,
                    method,
                    arguments.format,
                    &draw,
                )?
            }
            None => films(engine, &loads(part, true)?, &models, method, arguments.format, &draw)?,
        };
        print(&match arguments.format {
            Format::Text if arguments.printed.brief => arguments.printed.words(words_before_tables(&text)),
            Format::Text => arguments.printed.words(text),
            Format::Csv => arguments.printed.csv(text),
            Format::Json => text,
        })?;
        return Ok(verdict(&found, wanted));
    }
    let found = loads(part, true)?;
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
        Format::Text => arguments.printed.text(
            || bearings_text(&found, &parts, bare.as_ref(), bearing_sizes(engine)),
            || bearings_brief(&found),
        ),
        Format::Json => json(&WithAndWithout { loads: &found, without_counterweights: bare.as_ref() })?,
        Format::Csv => arguments.printed.csv(bearings_csv(&found)),
    })?;
    Ok(DONE)
}

fn films(
    engine: &Engine,
    loads: &BearingLoads,
    models: &[Cavitation],
    method: FilmMethod,
    format: Format,
    draw: &dyn Fn(&[Figure]) -> Result<(), Failure>,
) -> Result<(String, Vec<BearingFilms>), Failure> {
    let films = bearing_films(engine, loads, models, method).map_err(Failure::refused)?;
    draw(&film_figures(films.period, &films.films))?;
    let text = match format {
        Format::Text => films_text(&films.engine, &films.input()),
        Format::Json => json(&films)?,
        Format::Csv => films_csv(films.period, &films.films),
    };
    Ok((text, vec![films]))
}

/// Says which run is not balanced, which film is thinner than wanted, or not one to go by.
fn verdict(found: &[BearingFilms], wanted: Option<f64>) -> u8 {
    let mut status = DONE;
    for films in found {
        for run in films.shafts.iter().filter(|run| run.outcome != OrbitOutcome::Overloaded) {
            if !run.is_balanced() {
                tell(format_args!(
                    "energies of crankshaft {} at {:.0} rpm, {}, do not balance: {:.1e} of the turnover is missing, allowed is {BALANCED:.0e}",
                    run.crankshaft,
                    films.speed * 30.0 / std::f64::consts::PI,
                    run.cavitation.name(),
                    run.energy_error.unwrap_or(f64::NAN)
                ));
                status = NOT_AS_EXPECTED;
            }
        }
    }
    let Some(wanted) = wanted else { return status };
    let all = || found.iter().flat_map(|films| films.films.iter().map(|film| (films.speed, film)));
    let place = |speed: f64, film: &BearingFilm| {
        let kind = match film.kind {
            BearingKind::Main => "main",
            BearingKind::Crankpin => "big end",
        };
        format!(
            "{kind} {} at {:.0} rpm, {}",
            film.number,
            speed * 30.0 / std::f64::consts::PI,
            film.cavitation.name()
        )
    };
    if let Some((speed, film)) = all().find(|(_, film)| film.orbit.outcome != OrbitOutcome::Periodic) {
        tell(format_args!(
            "the least film is not known: {}: {}",
            place(speed, film),
            match film.orbit.outcome {
                OrbitOutcome::Overloaded => "the film cannot carry the load",
                OrbitOutcome::NotPeriodic | OrbitOutcome::Periodic => "the orbit does not repeat",
            }
        ));
        status = NOT_AS_EXPECTED;
    }
    let thickness = |film: &BearingFilm| film.orbit.least_anywhere();
    match all().min_by(|a, b| thickness(a.1).total_cmp(&thickness(b.1))) {
        Some((speed, film)) if thickness(film) < wanted => {
            tell(format_args!(
                "the least film is {:.3} um ({}), wanted are {:.3} um",
                1e6 * thickness(film),
                place(speed, film),
                1e6 * wanted
            ));
            status = NOT_AS_EXPECTED;
        }
        Some(_) => {}
        None => {
            tell("no bearing has an oil film");
            status = NOT_AS_EXPECTED;
        }
    }
    status
}

fn films_over_speed(
    engine: &Engine,
    loads: &[BearingLoads],
    models: &[Cavitation],
    method: FilmMethod,
    format: Format,
    draw: &dyn Fn(&[Figure]) -> Result<(), Failure>,
) -> Result<(String, Vec<BearingFilms>), Failure> {
    let found = bearing_films_over_speed(engine, loads, models, method).map_err(Failure::refused)?;
    let by_speed: Vec<_> = found.iter().map(|films| (films.speed, films.films.as_slice())).collect();
    draw(&films_over_speed_figure(&by_speed).into_iter().collect::<Vec<_>>())?;
    let table = films_over_speed_table(&found.iter().map(BearingFilms::input).collect::<Vec<_>>());
    let text = match format {
        Format::Text => table.text(),
        Format::Json => json(&found)?,
        Format::Csv => table.csv(),
    };
    Ok((text, found))
}

fn model_of(option: FilmOption) -> Cavitation {
    match option {
        FilmOption::Full => Cavitation::Full,
        FilmOption::Gumbel => Cavitation::Gumbel,
        FilmOption::Reynolds => Cavitation::Reynolds,
        FilmOption::MassConserving => Cavitation::MassConserving,
    }
}

/// A least film that is wanted [m].
///
/// # Errors
/// A text that is no length, or one that every film keeps.
pub(super) fn wanted_film(text: &str) -> Result<f64, Failure> {
    let wanted = option::length(text, "--least-film")?;
    if wanted > 0.0 {
        return Ok(wanted);
    }
    Err(Failure::input(
        format_args!("--least-film needs a thickness above 0, got \"{text}\""),
        "for example --least-film '1 um'",
    ))
}
