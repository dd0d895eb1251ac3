//! `lanchester mounts`: the block on its mounts.

use crate::commands::{json, open};
use crate::failure::{DONE, Failure};
use crate::figures::write_figures;
use crate::files::{print, tell};
use crate::format::Format;
use crate::options::mounts::{MountsArguments, MountsTable, RotorOption};
use crate::requests::loads::point;
use crate::trace_files::trace_files;
use lanchester::report::{
    mount_figures, mount_forces_csv, mount_modes_csv, mount_motion_csv, mounts_brief, mounts_text,
};
use lanchester::task::option;
use lanchester::{MountSpeeds, mounts_with_rotors};

pub fn run(arguments: &MountsArguments, colour: bool) -> Result<u8, Failure> {
    if arguments.table.is_some() && arguments.format != Format::Csv {
        return Err(Failure::input(
            "--table chooses what --format csv writes",
            "add --format csv, or leave --table out",
        ));
    }
    arguments.printed.check(arguments.format == Format::Text)?;
    let speed = |text: &str, name| option::speed(text.trim(), name).map_err(Failure::from);
    let speeds = match (&arguments.speed, &arguments.speeds) {
        (Some(one), _) => MountSpeeds::List(vec![speed(one, "--speed")?]),
        (None, Some(list)) => {
            MountSpeeds::List(list.split(',').map(|one| speed(one, "--speeds")).collect::<Result<_, _>>()?)
        }
        (None, None) => MountSpeeds::Range(arguments.steps as usize),
    };
    let points =
        arguments.point.iter().map(|text| point(text, "--point")).collect::<Result<Vec<_>, Failure>>()?;
    let opened = open(&arguments.file, colour)?;
    let traces = match arguments.inertia_only {
        true => None,
        false => Some(trace_files(&opened.file.engine, &arguments.file)?),
    };
    let effects = arguments.rotors.effects();
    let study = mounts_with_rotors(
        &opened.file.engine,
        &speeds,
        arguments.orders,
        traces.as_deref(),
        &points,
        effects,
    )
    .map_err(Failure::refused)?;
    for warning in &study.warnings {
        tell(format_args!("warning: {warning}"));
    }
    if study.rotors == 0.0 && arguments.rotors != RotorOption::Both {
        tell(format_args!(
            "warning: --rotors changes nothing: the file gives no inertia of what turns in the block"
        ));
    }
    if let Some(folder) = &arguments.figures {
        write_figures(folder, &arguments.file, &mount_figures(&opened.file.engine, &study))?;
    }
    let printed = &arguments.printed;
    print(&match (arguments.format, arguments.table) {
        (Format::Text, _) => printed.text(|| mounts_text(&study), || mounts_brief(&study)),
        (Format::Json, _) => json(&study)?,
        (Format::Csv, Some(MountsTable::Motion)) => printed.csv(mount_motion_csv(&study)),
        (Format::Csv, Some(MountsTable::Modes)) => printed.csv(mount_modes_csv(&study)),
        (Format::Csv, _) => printed.csv(mount_forces_csv(&study)),
    })?;
    Ok(DONE)
}
