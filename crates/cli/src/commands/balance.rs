//! `lanchester balance`: the best weights and shafts, their proof and their price, written back if asked for.

pub(in crate::commands) mod found;
pub(in crate::commands) mod published;
pub(in crate::commands) mod robust;
pub(in crate::commands) mod search;
pub(in crate::commands) mod sweep;

use crate::arguments::{BalanceArguments, BalanceMethod, BalanceTable};
use crate::commands::balance::found::{consequences, csv, loads_of, put_into_file, tell_what_does_not_fit};
use crate::commands::{json, open};
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::files::{print, tell, write_result};
use crate::format::Format;
use crate::options::search_limit::hint;
use crate::requests::balance::balance_task;
use crate::trace_files::trace_files;
use crate::watch::Watch;
use lanchester::balance::{Answer, Consequences, Durable, Outcome, fitted};
use lanchester::model::Engine;
use lanchester::report::{
    PartMass, Table, balance_brief, balance_text, consequence_figures, durability_table, durability_text,
    durability_words, headline, optimum_figures, part_masses_table,
};
use lanchester::task::{BalanceTask, Tasks};
use lanchester::{WeightAsPart, durable_balance, optimise_on_webs, weights_as_parts};
use serde::Serialize;
use std::path::Path;

pub fn run(arguments: &BalanceArguments, colour: bool) -> Result<u8, Failure> {
    if arguments.table.is_some() && arguments.format != Format::Csv {
        return Err(Failure::input(
            "--table chooses what --format csv writes",
            "add --format csv, or leave --table out",
        ));
    }
    arguments.printed.check(arguments.format == Format::Text)?;
    if arguments.write && arguments.file == Path::new("-") {
        return Err(Failure::input(
            "--write needs a file, got standard input",
            "give the path of the engine file",
        ));
    }
    for (is_asked, what) in [
        (arguments.search.search, "--search"),
        (arguments.method != BalanceMethod::Optimum, "--method"),
        (!arguments.cancel.is_empty(), "--cancel"),
    ] {
        if is_asked {
            arguments.limits.refuse_with(what)?;
        }
    }
    if arguments.search.search {
        return search::run(arguments, colour);
    }
    sweep::check(arguments)?;
    let opened = open(&arguments.file, colour)?;
    let engine = &opened.file.engine;
    if published::asked_for(arguments)? {
        let answer = published::fit(engine, arguments)?;
        let effect = consequences(engine, &answer.fitted, None)?;
        tell_what_does_not_fit(&opened, &answer.fitted)?;
        return match put_into_file(&opened, arguments, &answer.fitted, Some(&effect), colour)? {
            true => Ok(DONE),
            false => published::tell(&opened, arguments, &answer, &effect),
        };
    }
    if arguments.method == BalanceMethod::Sweep {
        return sweep::run(arguments, &opened, colour);
    }
    let task = balance_task(&opened.file, arguments)?;
    if matches!(arguments.table, Some(BalanceTable::Orders | BalanceTable::Proof)) && task.cancel.is_empty() {
        return Err(Failure::input(
            "this table tells of orders that must vanish, and none is asked for",
            "give --cancel, or take another --table",
        ));
    }
    if let Some(options) = arguments.robust.options()? {
        return robust::run(&opened, arguments, &task, &options, colour);
    }
    let settings = arguments.limits.settings()?;
    let watch = Watch::new(engine, settings);
    let tells_films = tells_films(engine, &task);
    let traces = match task.counts_gas() || tells_films {
        true => trace_files(engine, &arguments.file)?,
        false => Vec::new(),
    };
    let answer = optimise_on_webs(
        engine,
        Ok(&traces),
        &task,
        opened.file.tasks.shape_task.as_ref(),
        &settings,
        &|state| watch.look(state),
    );
    let answer = answer.map_err(Failure::refused)?;
    if let Outcome::Stopped { cause, .. } = &answer.outcome {
        let hint = hint(*cause, &settings);
        if !hint.is_empty() {
            eprintln!("{hint}");
        }
    }
    let found = !matches!(answer.outcome, Outcome::Infeasible { .. });
    let durable = match found && !answer.weights.is_empty() && tells_films {
        true => {
            let options = arguments.durable.options(settings);
            let found = durable_balance(&opened.file, Ok(&traces), &answer, &options, &|count| {
                watch.look_at_films(count)
            });
            Some(found.map_err(Failure::refused)?)
        }
        false => None,
    };
    drop(watch);
    let after = match &durable {
        Some(durable) if durable.is_moved() => durable.engine(engine, &answer),
        _ => fitted(engine, &answer),
    };
    let shown = durable.as_ref().map_or_else(|| answer.clone(), |found| found.answer(&answer));
    let status = match &durable {
        Some(durable) if !durable.is_met() || !durable.is_searched() => {
            eprintln!("{}", durability_words(durable));
            NOT_AS_EXPECTED
        }
        _ => status(&answer),
    };
    let loads_after = loads_of(&after)?;
    let effect = match answer.weights.is_empty() {
        true => None,
        false => Some(consequences(engine, &after, Some(&answer.task))?),
    };
    if let Some(folder) = &arguments.figures
        && found
    {
        let before = loads_of(engine)?;
        let of_answer = optimum_figures(engine, &shown, &before, &after, &loads_after);
        let of_effect = effect.as_ref().map(|effect| consequence_figures(&after, effect));
        let all = of_answer.into_iter().chain(of_effect.into_iter().flatten());
        for figure in all.chain(sweep::curve(&after, &answer)) {
            write_result(&folder.join(format!("{}.svg", figure.id)), &arguments.file, &figure.svg())?;
        }
    }
    if found && put_into_file(&opened, arguments, &after, effect.as_ref(), colour)? {
        return Ok(status);
    }
    if status != DONE && arguments.format != Format::Text {
        tell(headline(engine, &answer));
    }
    let as_parts = if found { as_parts(&shown, &after, &opened.file.tasks) } else { Vec::new() };
    print(&match (arguments.format, arguments.table) {
        (Format::Text, _) => {
            let whole = || {
                let left = &loads_after.diagnosis.summary;
                let text = balance_text(engine, &answer, durable.as_ref(), effect.as_ref(), left);
                let films = durable.as_ref().map_or_else(String::new, |found| durability_text(engine, found));
                let films = if films.is_empty() { films } else { format!("\n{films}") };
                text + &masses(&as_parts).map_or(String::new(), |table| format!("\n{}", table.text()))
                    + &films
            };
            arguments.printed.text(whole, || balance_brief(engine, &answer, durable.as_ref()))
        }
        (Format::Json, _) => {
            let durability = durable.as_ref();
            json(&Found { answer: &answer, as_parts: &as_parts, consequences: effect.as_ref(), durability })?
        }
        (Format::Csv, Some(BalanceTable::Durability)) => {
            let table = durable.as_ref().map_or_else(String::new, |found| durability_table(found).csv());
            arguments.printed.csv(table)
        }
        (Format::Csv, table) => arguments.printed.csv(csv(engine, &shown, effect.as_ref(), table)),
    })?;
    Ok(status)
}

/// Whether films and safeties are told: where they are wanted, and where the file says enough of the oil.
fn tells_films(engine: &Engine, task: &BalanceTask) -> bool {
    let oil = engine.bearing_design.as_ref().map(|design| &design.oil);
    !task.durability.is_empty() || oil.is_some_and(|oil| oil.viscosity.is_some() || oil.name.is_some())
}

/// What was found, with the weights as parts where the file says among which shapes they are searched.
#[derive(Debug, Serialize)]
struct Found<'a> {
    #[serde(flatten)]
    answer: &'a Answer,
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    as_parts: &'a [WeightAsPart],
    #[serde(skip_serializing_if = "Option::is_none")]
    consequences: Option<&'a Consequences>,
    #[serde(skip_serializing_if = "Option::is_none")]
    durability: Option<&'a Durable>,
}

/// The found weights as parts; what is in the way of that is a warning.
fn as_parts(answer: &Answer, after: &Engine, tasks: &Tasks) -> Vec<WeightAsPart> {
    weights_as_parts(answer, after, tasks).unwrap_or_else(|error| {
        let message = error.to_string().replace("\nhint:", ";");
        tell(format_args!("warning: the mass of the weights as parts is left out: {message}"));
        Vec::new()
    })
}

fn masses(parts: &[WeightAsPart]) -> Option<Table> {
    let masses = parts.iter().map(|part| PartMass {
        name: &part.name,
        unbalance: part.unbalance,
        at_radius: part.at_radius,
        mass: part.mass,
    });
    let masses: Vec<PartMass> = masses.collect();
    (!masses.is_empty()).then(|| part_masses_table(&masses))
}

fn status(answer: &Answer) -> u8 {
    if answer.outcome == Outcome::Optimal { DONE } else { NOT_AS_EXPECTED }
}
