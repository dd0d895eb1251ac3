//! `lanchester compare`: engines and arrangements side by side.

use crate::commands::{json, open};
use crate::failure::{DONE, Failure};
use crate::figures::write_figures;
use crate::files::{print, tell};
use crate::format::Format;
use crate::options::compare::{CompareArguments, EqualOption, HeldOption};
use crate::options::share::share;
use crate::trace_files::trace_files;
use lanchester::literature::TwinArrangement;
use lanchester::report::{comparison_figure, comparison_table, comparison_text};
use lanchester::study::compare::{Equal, Held};
use lanchester::task::option;
use lanchester::{CompareEntry, CompareRequest, ComparedWith, compare};
use std::path::Path;

pub fn run(arguments: &CompareArguments, colour: bool) -> Result<u8, Failure> {
    let request = request(arguments)?;
    let with = with(arguments)?;
    let mut entries = Vec::with_capacity(arguments.files.len() * with.len() + 1);
    let mut take = |file: &Path, with: &[ComparedWith]| -> Result<(), Failure> {
        let opened = open(file, colour)?;
        let traces = trace_files(&opened.file.engine, file)?;
        entries.extend(with.iter().map(|&with| CompareEntry {
            file: opened.file.clone(),
            traces: traces.clone(),
            with,
        }));
        Ok(())
    };
    if arguments.reference.parse::<usize>().is_err() {
        take(Path::new(&arguments.reference), &[ComparedWith::OwnDevices])?;
    }
    for file in &arguments.files {
        take(file, &with)?;
    }
    let comparison = compare(&entries, &request).map_err(Failure::refused)?;
    for warning in &comparison.warnings {
        tell(format_args!("warning: {warning}"));
    }
    if let Some(folder) = &arguments.figures {
        write_figures(folder, &arguments.files[0], &[comparison_figure(&comparison)])?;
    }
    print(&match arguments.format {
        Format::Text => comparison_text(&comparison),
        Format::Json => json(&comparison)?,
        Format::Csv => comparison_table(&comparison).csv(),
    })?;
    Ok(DONE)
}

fn request(arguments: &CompareArguments) -> Result<CompareRequest, Failure> {
    let speed = arguments.speed.as_deref().map(|text| option::speed(text, "--speed")).transpose()?;
    let fluctuation =
        arguments.fluctuation.as_deref().map(|text| option::share(text, "--fluctuation")).transpose()?;
    // A file stands first.
    let number = arguments.reference.parse::<usize>().unwrap_or(1);
    let Some(reference) = number.checked_sub(1) else {
        return Err(Failure::input("--reference counts the engines from 1, got 0", "the first one is 1"));
    };
    let equal = match arguments.equal {
        None => Equal::AsTheyAre,
        Some(EqualOption::Displacement) => Equal::Displacement,
        Some(EqualOption::Power) => Equal::Power,
    };
    let held = match arguments.hold {
        HeldOption::Speed => Held::Speed,
        HeldOption::PistonSpeed => Held::PistonSpeed,
    };
    let share = arguments.share.as_deref().map_or(Ok(1.0), share)?;
    let spacing = arguments.mount_spacing.as_deref();
    let mount_spacing = spacing.map(|text| option::length(text, "--mount-spacing")).transpose()?;
    let finite_elements = arguments.finite_elements;
    Ok(CompareRequest { equal, held, speed, reference, share, mount_spacing, fluctuation, finite_elements })
}

/// What every file is compared with.
fn with(arguments: &CompareArguments) -> Result<Vec<ComparedWith>, Failure> {
    let mut with = match arguments.arrangements.as_deref() {
        None => vec![ComparedWith::OwnDevices],
        Some("all") => TwinArrangement::ALL.map(ComparedWith::Arrangement).to_vec(),
        Some(list) => list
            .split(',')
            .map(|one| {
                let number = one.trim().parse().ok();
                number.and_then(TwinArrangement::from_number).map(ComparedWith::Arrangement).ok_or_else(
                    || {
                        Failure::input(
                            format!("--arrangements needs numbers from 1 to 9, got `{}`", one.trim()),
                            "write `1,2,4`, or `all`",
                        )
                    },
                )
            })
            .collect::<Result<_, _>>()?,
    };
    if arguments.optimum {
        with.push(ComparedWith::Optimum);
    }
    Ok(with)
}
