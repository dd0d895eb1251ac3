//! `lanchester balance --method sweep`: the crank by the sweep of the twin-cylinder thesis, the true optimum beside it.

use crate::arguments::{BalanceArguments, BalanceMethod, BalanceTable};
use crate::commands::balance::found::{
    WithConsequences, consequences, put_into_file, tell_what_does_not_fit,
};
use crate::commands::{Opened, json};
use crate::failure::{DONE, Failure};
use crate::files::{print, write_result};
use crate::format::Format;
use crate::requests::loads::series;
use lanchester::balance::Answer;
use lanchester::literature::{CrankLoad, SweepOptions, SweptCrank, sweep, swept, with_even_crank};
use lanchester::mechanism::Kinematics;
use lanchester::model::Engine;
use lanchester::report::{
    Figure, consequence_figures, consequences_table, crank_curve, sweep_steps_table, swept_text,
};
use lanchester::task::{Criterion, Load, option};

/// The options of one method do not go with the other.
pub fn check(arguments: &BalanceArguments) -> Result<(), Failure> {
    let given =
        |options: &[(&'static str, bool)]| options.iter().find(|(_, given)| *given).map(|(name, _)| *name);
    let options = &arguments.published;
    let wrong = match arguments.method {
        BalanceMethod::Sweep => given(&[
            ("--cancel", !arguments.cancel.is_empty()),
            ("--limit", !arguments.limit.is_empty()),
            ("--counterweights", arguments.counterweights.is_some()),
            ("--max-unbalance", arguments.most.is_some()),
            ("--shaft", !arguments.shaft.is_empty()),
            ("--table", arguments.table.is_some_and(|table| table != BalanceTable::Consequences)),
        ])
        .map(|name| {
            (
                format!("--method sweep chooses one amount for all throws and has no place for {name}"),
                "leave one of the two out; without --method the true optimum is found",
            )
        }),
        _ => given(&[
            ("--step", options.step.is_some()),
            ("--grid", options.grid.is_some()),
            ("--series", options.series.is_some()),
        ])
        .map(|name| (format!("{name} belongs to the sweep"), "add --method sweep")),
    };
    wrong.map_or(Ok(()), |(message, hint)| Err(Failure::input(message, hint)))
}

/// Sweeps, writes the crank into the file if asked for, and prints what was found.
pub fn run(arguments: &BalanceArguments, opened: &Opened, colour: bool) -> Result<u8, Failure> {
    let engine = &opened.file.engine;
    let mut options = SweepOptions::fitting(engine);
    if let Some(step) = &arguments.published.step {
        options.step =
            option::unbalance(step, "--step").map_err(|bad| Failure::input(&bad.message, &bad.hint))?;
    }
    if let Some(angles) = arguments.published.grid {
        options.angles = angles as usize;
    }
    let kinematics = arguments.published.series.as_deref().map_or(Ok(Kinematics::Exact), series)?;
    let found = swept(engine, load(arguments, engine)?, kinematics, &options).map_err(Failure::refused)?;
    let after = with_even_crank(engine, found.best.unbalance);
    tell_what_does_not_fit(opened, &after)?;
    let effect = consequences(engine, &after, None)?;
    if let Some(folder) = &arguments.figures {
        let curve = crank_curve(&found.sweep, found.optimal());
        for figure in std::iter::once(curve).chain(consequence_figures(&after, &effect)) {
            write_result(&folder.join(format!("{}.svg", figure.id)), &arguments.file, &figure.svg())?;
        }
    }
    if put_into_file(opened, arguments, &after, Some(&effect), colour)? {
        return Ok(DONE);
    }
    print(&match arguments.format {
        Format::Text => arguments.printed.led(swept_text(&found, &effect)),
        Format::Json => json(&WithConsequences { answer: &found, consequences: Some(&effect) })?,
        Format::Csv if arguments.table == Some(BalanceTable::Consequences) => {
            arguments.printed.csv(consequences_table(&effect).csv())
        }
        Format::Csv => arguments.printed.csv(sweep_steps_table(&found.sweep).csv()),
    })?;
    Ok(DONE)
}

/// What `--minimise` asks to sweep for.
fn load(arguments: &BalanceArguments, engine: &Engine) -> Result<Option<CrankLoad>, Failure> {
    let hint = "give --minimise force or --minimise couple, or leave it out";
    let [text] = &arguments.minimise[..] else {
        return match arguments.minimise.len() {
            0 => Ok(None),
            count => Err(Failure::input(format!("--method sweep needs one load, got {count}"), hint)),
        };
    };
    let stage =
        option::stage(text, engine, "--minimise").map_err(|bad| Failure::input(&bad.message, &bad.hint))?;
    match stage.terms[..] {
        [(_, Criterion::Peak(Load::Force))] => Ok(Some(CrankLoad::Force)),
        [(_, Criterion::Peak(Load::Couple))] => Ok(Some(CrankLoad::Couple)),
        _ => Err(Failure::input(format!("--method sweep needs force or couple, got `{text}`"), hint)),
    }
}

/// The sweep's curve with an optimum in its place, where `after`, the engine with the answer, has one weight of one
/// amount opposite every throw and nothing else on the crank, and force or couple alone was made small.
pub fn curve(after: &Engine, answer: &Answer) -> Option<Figure> {
    let [stage] = &answer.stages[..] else { return None };
    let load = match stage.terms[..] {
        [(Criterion::Peak(Load::Force), _)] => CrankLoad::Force,
        [(Criterion::Peak(Load::Couple), _)] => CrankLoad::Couple,
        _ => return None,
    };
    let task = &answer.task;
    let other = !(task.limits.is_empty() && task.shafts.is_empty() && task.inertias.is_empty());
    if other || answer.weights.len() != after.throws.len() || after.counterweights.len() != after.throws.len()
    {
        return None;
    }
    let amount = after.counterweights.first()?.unbalance;
    let opposite = |throw: &lanchester::model::Throw| {
        after.counterweights.iter().any(|weight| {
            let turn = weight.angle - throw.angle;
            weight.crankshaft == throw.crankshaft
                && (weight.z - throw.z).abs() <= 1e-9
                && (weight.unbalance - amount).abs() <= 1e-6 * amount
                && turn.cos() <= -1.0 + 1e-12
        })
    };
    if !after.throws.iter().all(opposite) {
        return None;
    }
    let found = sweep(after, load, Kinematics::Exact, &SweepOptions::fitting(after)).ok()?;
    Some(crank_curve(&found, Some(SweptCrank { unbalance: amount, criterion: stage.value })))
}
