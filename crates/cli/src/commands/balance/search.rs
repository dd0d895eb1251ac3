//! `lanchester balance --search`: which arrangement of crank weights and balance shafts, and one of them in full.

use crate::arguments::{BalanceArguments, BalanceTable};
use crate::commands::balance::found::{
    WithConsequences, consequences, csv, loads_of, put_into_file, tell_what_does_not_fit,
};
use crate::commands::{Opened, json, open};
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::files::{print, write_result};
use crate::format::Format;
use crate::requests::search::arrangement_request;
use lanchester::balance::{
    Arrangement, ArrangementRequest, Arrangements, SpacingArrangements, arrangements, fitted, searched_engine,
};
use lanchester::model::{Engine, Fault};
use lanchester::report::{
    Figure, arrangement_figure, arrangement_parts, arrangements_text, balance_text, drive_sketches,
    front_table, narrowest_place,
};

pub fn run(arguments: &BalanceArguments, colour: bool) -> Result<u8, Failure> {
    fits_together(arguments)?;
    let opened = open(&arguments.file, colour)?;
    let request = arrangement_request(&opened.file.engine, arguments, colour)?;
    let found = arrangements(&opened.file.engine, &request).map_err(Failure::refused)?;
    let choice = arguments.search.choose.as_deref().map(|text| choice(&found, text)).transpose()?;
    if let Some(folder) = &arguments.figures {
        for figure in figures(&opened.file.engine, &request, &found, choice) {
            write_result(&folder.join(format!("{}.svg", figure.id)), &arguments.file, &figure.svg())?;
        }
    }
    if let Some(choice) = choice {
        return one(&opened, arguments, &request, &found, choice, colour);
    }
    if let Some(nearest) = found.nearest.as_ref().filter(|_| arguments.format != Format::Text) {
        eprintln!("{}", nearest.reason);
    }
    print(&match arguments.format {
        Format::Text => arguments.printed.led(arrangements_text(&found, arguments.search.all)),
        Format::Json => json(&found)?,
        Format::Csv => {
            let tables = found.spacings.iter().map(|s| front_table(&found, s, arguments.search.all));
            // One head for all spacings, each with its own length in the first column.
            arguments.printed.csv(with_spacings(&found, tables.map(|table| table.csv())))
        }
    })?;
    Ok(status(found.limit.is_none() || found.nearest.is_none()))
}

/// The residuals against what they cost, then places and drives: of the front, or of the chosen one.
fn figures(
    engine: &Engine,
    request: &ArrangementRequest,
    found: &Arrangements,
    choice: Option<usize>,
) -> Vec<Figure> {
    let mut figures = vec![arrangement_figure(found)];
    for spacing in &found.spacings {
        let shown = choice.map_or_else(|| spacing.front.clone(), |choice| vec![choice]);
        let mut drives = drive_sketches(engine, &request.parts, found, spacing, &shown);
        if let Some(at) = spacing.spacing.filter(|_| found.spacings.len() > 1) {
            drives.id = format!("{}-{}mm", drives.id, (1e4 * at).round() / 10.0);
        }
        if !drives.panels.is_empty() {
            figures.push(drives);
        }
    }
    figures
}

fn status(good_enough: bool) -> u8 {
    if good_enough { DONE } else { NOT_AS_EXPECTED }
}

/// Options that have no meaning together.
fn fits_together(arguments: &BalanceArguments) -> Result<(), Failure> {
    let search = &arguments.search;
    if !arguments.shaft.is_empty() {
        return Err(Failure::input(
            "--search chooses the shafts itself, and --shaft gives one",
            "leave --search out to balance with that shaft, or say with --place where shafts may stand",
        ));
    }
    if arguments.most.is_some() {
        return Err(Failure::input(
            "--search has no largest amount for each crank weight",
            "limit the sum: --limit 'added unbalance = 0.05 kg m'",
        ));
    }
    let of_cancelled = matches!(arguments.table, Some(BalanceTable::Orders | BalanceTable::Proof));
    if of_cancelled || !arguments.cancel.is_empty() {
        return Err(Failure::input(
            "--search makes the peak small, not chosen orders vanish",
            "leave --cancel and its tables out, or --search",
        ));
    }
    if search.choose.is_none() {
        let needs_choice = [("--write", arguments.write), ("--dry-run", arguments.dry_run)];
        if let Some((option, _)) = needs_choice.into_iter().find(|(_, given)| *given) {
            return Err(Failure::input(
                format_args!("{option} needs one arrangement, and --search finds many"),
                "add --choose with the number or the name of one",
            ));
        }
        if arguments.table.is_some() {
            return Err(Failure::input(
                "--table is about one arrangement, and --search finds many",
                "add --choose with the number or the name of one, or leave --table out",
            ));
        }
    }
    Ok(())
}

/// The tables one below another, with the spacing before each row where there are several.
fn with_spacings(found: &Arrangements, tables: impl Iterator<Item = String>) -> String {
    if found.spacings.len() == 1 {
        return tables.collect();
    }
    let mut out = String::new();
    for (spacing, table) in found.spacings.iter().zip(tables) {
        let mut lines = table.lines();
        let head = lines.next().unwrap_or_default();
        if out.is_empty() {
            out += &format!("spacing [mm],{head}\n");
        }
        for line in lines {
            // To the nanometre: a spacing comes from a length in mm.
            let at = spacing.spacing.map_or(String::new(), |s| ((1e9 * s).round() / 1e6).to_string());
            out += &format!("{at},{line}\n");
        }
    }
    out
}

/// One arrangement in full, put into the file if asked for.
fn one(
    opened: &Opened,
    arguments: &BalanceArguments,
    request: &ArrangementRequest,
    found: &Arrangements,
    choice: usize,
    colour: bool,
) -> Result<u8, Failure> {
    let spacing = &found.spacings[0];
    let chosen = &spacing.arrangements[choice];
    let bare = searched_engine(&opened.file.engine, request, spacing.scale).map_err(Failure::refused)?;
    let adopted = arguments.write || arguments.dry_run;
    if adopted {
        may_be_written(spacing, chosen)?;
    }
    let after = fitted(&bare, &chosen.answer);
    tell_what_does_not_fit(opened, &after)?;
    // The file's own devices on the mounts that the search judges.
    let before = opened.file.engine.with(|parts| parts.mounts.clone_from(&bare.mounts));
    let before = before.map_err(|faults| Failure::refused(Fault::first_of(faults)))?;
    let effect = consequences(&before, &after, Some(&chosen.answer.task))?;
    let good = chosen.possible && chosen.reaches_limit != Some(false);
    if adopted && put_into_file(opened, arguments, &after, Some(&effect), colour)? {
        return Ok(status(good));
    }
    print(&match arguments.format {
        Format::Text => {
            let mut out = format!("{}: {} ({})\n\n", found.engine, chosen.name, chosen.label);
            out += &balance_text(
                &bare,
                &chosen.answer,
                None,
                Some(&effect),
                &loads_of(&after)?.diagnosis.summary,
            );
            for table in arrangement_parts(chosen) {
                out += &format!("\n{}", table.text());
            }
            let place = narrowest_place(chosen);
            arguments.printed.led(out + &place.map_or_else(String::new, |place| format!("\n{place}\n")))
        }
        Format::Json => json(&WithConsequences { answer: chosen, consequences: Some(&effect) })?,
        Format::Csv => arguments.printed.csv(csv(&bare, &chosen.answer, Some(&effect), arguments.table)),
    })?;
    Ok(status(good))
}

/// Index of the arrangement of this number or name, at the one spacing.
fn choice(found: &Arrangements, text: &str) -> Result<usize, Failure> {
    let [spacing] = &found.spacings[..] else {
        return Err(Failure::input(
            format_args!("--choose needs one cylinder spacing, got {}", found.spacings.len()),
            "give --spacing one length, or leave it out",
        ));
    };
    let all = &spacing.arrangements;
    let text = text.trim();
    let by_name = all.iter().position(|a| a.label == text || a.name == text);
    let by_number = || {
        // "+1" and "-1" are names of shafts.
        let digits = !text.is_empty() && text.chars().all(|c| c.is_ascii_digit());
        let number = digits.then(|| text.parse::<usize>().ok()).flatten();
        number.and_then(|n| n.checked_sub(1)).filter(|index| *index < all.len())
    };
    by_name.or_else(by_number).ok_or_else(|| {
        let names: Vec<&str> = spacing.front.iter().map(|&k| all[k].label.as_str()).collect();
        Failure::input(
            format_args!("--choose needs a number from 1 to {} or a name, got `{text}`", all.len()),
            format_args!("Pareto-optimal: {}; --all lists the others", names.join("; ")),
        )
    })
}

/// Only what has a place, at the spacing that the file has, may be written into it.
fn may_be_written(spacing: &SpacingArrangements, chosen: &Arrangement) -> Result<(), Failure> {
    if !chosen.possible {
        let why = narrowest_place(chosen).filter(|_| chosen.drive.is_none() && !chosen.shafts.is_empty());
        let why = why.unwrap_or_else(|| "the further limits cannot be held".to_owned());
        return Err(Failure::input(
            format_args!("`{}` cannot be fitted: {why}", chosen.label),
            "choose another one, or allow it more: --place, --size, --limit",
        ));
    }
    if spacing.scale == 1.0 {
        return Ok(());
    }
    let millimetres = |length: f64| (1e7 * length).round() / 1e4;
    let at = spacing.spacing.unwrap_or_default();
    Err(Failure::input(
        format_args!(
            "`{}` was found at {} mm spacing, and the engine file has {} mm",
            chosen.label,
            millimetres(at),
            millimetres(at / spacing.scale)
        ),
        "change the spacing in the file first, then search without --spacing",
    ))
}
