//! `lanchester export`: loads for other programs.

mod fmu;

use crate::commands::open;
use crate::failure::{DONE, Failure};
use crate::files::{print, tell, write_new};
use crate::options::export::{
    ExportArguments, ExportCommand, ForcesArguments, HistoryArguments, PointsOption, ScriptArguments,
};
use crate::run::write_rows;
use crate::trace_files::trace_files;
use lanchester::exchange_formats::{FirstNumbers, ForceTable, exudyn, nastran, universal};
use lanchester::task::option;
use lanchester::value_list;
use lanchester::{
    ForceTableError, ForceTableRequest, LoadedPoints, MountSpeeds, force_table, load_history, rigid_train,
};
use std::path::Path;

pub fn run(arguments: &ExportArguments, colour: bool) -> Result<u8, Failure> {
    match &arguments.command {
        ExportCommand::Nastran(own) => {
            let first = FirstNumbers { set: own.first_set, table: own.first_table };
            put(&own.forces.output, &nastran(&forces(&own.forces, colour)?, first))
        }
        ExportCommand::Universal(own) => put(&own.output, &universal(&forces(own, colour)?)),
        ExportCommand::History(own) => history(own, colour),
        ExportCommand::Exudyn(own) => script(own, colour),
        ExportCommand::Fmu(own) => fmu::run(own, colour),
    }?;
    Ok(DONE)
}

fn put(path: &Path, text: &str) -> Result<(), Failure> {
    if path == Path::new("-") { print(text) } else { write_new(path, text) }
}

fn speed(text: &Option<String>) -> Result<Option<f64>, Failure> {
    Ok(text.as_deref().map(|text| option::speed(text, "--speed")).transpose()?)
}

fn forces(arguments: &ForcesArguments, colour: bool) -> Result<ForceTable, Failure> {
    let speeds = match &arguments.speeds {
        Some(list) => MountSpeeds::List(value_list(list, "--speeds", |one| option::speed(one, "--speeds"))?),
        None => MountSpeeds::Range(arguments.steps as usize),
    };
    let request = ForceTableRequest {
        points: match arguments.points {
            PointsOption::All => LoadedPoints::All,
            PointsOption::Mounts => LoadedPoints::Mounts,
            PointsOption::Bearings => LoadedPoints::Bearings,
        },
        speeds,
        max_order: arguments.orders,
        gas: !arguments.inertia_only,
        first_id: arguments.first_node,
    };
    let opened = open(&arguments.file, colour)?;
    let engine = &opened.file.engine;
    let traces = if arguments.inertia_only { Vec::new() } else { trace_files(engine, &arguments.file)? };
    let table = force_table(engine, &traces, &request).map_err(|error| match error {
        ForceTableError::OneSpeed { .. } => Failure::input(
            error,
            "add --speeds '1000 rpm .. 6000 rpm by 100 rpm', or give `speed` in the file as a range",
        ),
        other => Failure::refused(other),
    })?;
    for note in table.notes.iter().filter(|note| note.contains("left out")) {
        tell(format_args!("warning: {note}"));
    }
    Ok(table)
}

fn history(arguments: &HistoryArguments, colour: bool) -> Result<(), Failure> {
    let speed = speed(&arguments.speed)?;
    let opened = open(&arguments.file, colour)?;
    let engine = &opened.file.engine;
    let traces = trace_files(engine, &arguments.file)?;
    let found = load_history(engine, &traces, speed, arguments.samples as usize).map_err(Failure::refused)?;
    for note in &found.notes {
        tell(format_args!("warning: {note}"));
    }
    let about = [
        ("lanchester.title".to_owned(), found.title),
        ("lanchester.version".to_owned(), env!("CARGO_PKG_VERSION").to_owned()),
        ("lanchester.engine".to_owned(), opened.source.text),
    ];
    write_rows(&arguments.output, &found.columns, found.rows, &about)
}

fn script(arguments: &ScriptArguments, colour: bool) -> Result<(), Failure> {
    let speed = speed(&arguments.speed)?;
    let opened = open(&arguments.file, colour)?;
    let train = rigid_train(&opened.file.engine, speed).map_err(Failure::refused)?;
    put(&arguments.output, &exudyn(&train).map_err(Failure::own)?)
}
