//! `lanchester simulate`: the rigid crank train in time.

use crate::commands::{json, open};
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::figures::write_figures;
use crate::files::{print, print_bytes};
use crate::options::simulation::{BlockOption, SimulateArguments, SimulationFormat, SimulationTable};
use crate::requests::loads::point;
use crate::simulation_watch::Interruptible;
use crate::trace_files::trace_files;
use lanchester::file::{StartOfRun, event_from_words, start_from_words};
use lanchester::model::NamedPoint;
use lanchester::multibody::{LoadLaw, PeriodicOutcome, ReactsOn, RunOutcome};
use lanchester::report::{
    SimulationColumns, SimulationResult, simulation_brief, simulation_energy_columns,
    simulation_events_columns, simulation_extremes_columns, simulation_figures, simulation_orders_columns,
    simulation_reactions_columns, simulation_text, simulation_trace_columns,
};
use lanchester::table::{Column, Form, Rows, TableWriter, Values};
use lanchester::task::option;
use lanchester::{RunLength, SimulateRequest, simulate_watched, simulation_beside};

pub fn run(arguments: &SimulateArguments, colour: bool) -> Result<u8, Failure> {
    let of_columns = matches!(arguments.format, SimulationFormat::Csv | SimulationFormat::Parquet);
    if arguments.table.is_some() && !of_columns {
        return Err(Failure::input(
            "--table chooses what --format csv or parquet writes",
            "add --format csv or parquet, or leave --table out",
        ));
    }
    arguments.printed.check(arguments.format == SimulationFormat::Text)?;
    let mut request = request(arguments)?;
    let opened = open(&arguments.file, colour)?;
    if request.gas == Some(false) && !arguments.misfire.is_empty() {
        return Err(Failure::input(
            "--misfire has no effect without gas",
            "leave out --inertia-only, or --misfire",
        ));
    }
    for (place, &number) in arguments.misfire.iter().enumerate() {
        let count = opened.file.engine.cylinders.len();
        if !(1..=count).contains(&number) {
            let needed = format!("--misfire needs a number of a cylinder, from 1 to {count}, got {number}");
            return Err(Failure::input(needed, "cylinders are numbered as in the file"));
        }
        if arguments.misfire[..place].contains(&number) {
            return Err(Failure::input(
                format_args!("--misfire names cylinder {number} twice"),
                "name each cylinder once",
            ));
        }
        request.misfire.push(number - 1);
    }
    for text in &arguments.event {
        let parts = text
            .split_once(':')
            .map(|(when, action)| event_from_words(when, action, opened.file.engine.cylinders.len()));
        match parts {
            Some(Ok(event)) => request.events.push(event),
            Some(Err((message, hint))) => {
                return Err(Failure::input(format_args!("--event: {message}"), hint));
            }
            None => {
                return Err(Failure::input(
                    format_args!("--event needs a moment and what happens, got `{text}`"),
                    "write it like --event \"3 revolutions: misfire 1\"",
                ));
            }
        }
    }
    for text in &arguments.point {
        let at = point(text, "--point")?;
        request.points.push(NamedPoint { name: text.trim().to_owned(), at });
    }
    let in_file = opened.file.tasks.simulation.as_ref().and_then(|input| input.gas);
    let traces = match request.gas.or(in_file) {
        Some(false) => Vec::new(),
        _ => trace_files(&opened.file.engine, &arguments.file)?,
    };
    let run = Interruptible::listening();
    let result = simulate_watched(&opened.file, &traces, &request, &|_| run.goes_on());
    let result = result.map_err(Failure::refused)?;
    if let Some(folder) = &arguments.figures {
        let closed = simulation_beside(&opened.file, &traces, &result);
        write_figures(folder, &arguments.file, &simulation_figures(&result, closed.as_ref()))?;
    }
    match arguments.format {
        SimulationFormat::Text => {
            print(&arguments.printed.text(|| simulation_text(&result), || simulation_brief(&result)))?;
        }
        SimulationFormat::Json => print(&json(&*result.written())?)?,
        SimulationFormat::Csv => print(&arguments.printed.csv(columns(&result, arguments.table).csv()))?,
        SimulationFormat::Parquet => print_bytes(&parquet(columns(&result, arguments.table))?)?,
    }
    let ended =
        matches!(result.run.outcome, RunOutcome::Complete | RunOutcome::Stopped | RunOutcome::AtRest { .. })
            && result.periodic.as_ref().is_none_or(|periodic| periodic.outcome != PeriodicOutcome::NotFound);
    Ok(if ended { DONE } else { NOT_AS_EXPECTED })
}

fn columns(result: &SimulationResult, table: Option<SimulationTable>) -> SimulationColumns {
    match table.unwrap_or(SimulationTable::Trace) {
        SimulationTable::Trace => simulation_trace_columns(result),
        SimulationTable::Reactions => simulation_reactions_columns(result),
        SimulationTable::Orders => simulation_orders_columns(result),
        SimulationTable::Energy => simulation_energy_columns(result),
        SimulationTable::Extremes => simulation_extremes_columns(result),
        SimulationTable::Events => simulation_events_columns(result),
    }
}

/// A head as a name of letters, digits and underscores: `gear force_x [N m]` is `gear_force_x_N_m`.
fn column_name(head: &str) -> String {
    let parts = head.split(|one: char| !one.is_alphanumeric()).filter(|part| !part.is_empty());
    parts.collect::<Vec<_>>().join("_")
}

fn parquet(table: SimulationColumns) -> Result<Vec<u8>, Failure> {
    let rows = table.rows();
    let (mut heads, mut values): (Vec<Column>, Vec<Values>) = (Vec::new(), Vec::new());
    // Two heads that differ in signs alone would be one name.
    let name_of = |head: &str, heads: &[Column]| {
        let plain = column_name(head);
        let taken = |name: &str| heads.iter().any(|other| other.name == name);
        let numbered = (2..).map(|count| format!("{plain}_{count}"));
        std::iter::once(plain.clone()).chain(numbered).find(|name| !taken(name)).unwrap_or(plain.clone())
    };
    if let Some((head, mut names)) = table.names {
        names.truncate(rows);
        heads.push(Column::text(name_of(&head, &heads)));
        values.push(Values::Text(names));
    }
    for (head, mut numbers) in table.numbers {
        numbers.truncate(rows);
        heads.push(Column::real(name_of(&head, &heads)));
        values.push(Values::Real(numbers));
    }
    let mut bytes = Vec::new();
    let write = |bytes: &mut Vec<u8>| {
        let mut writer = TableWriter::new(Form::Parquet, bytes, &heads)?;
        writer.push(Rows::of(values))?;
        writer.finish(&[])
    };
    match write(&mut bytes) {
        Ok(_) => Ok(bytes),
        Err(error) => {
            Err(Failure::input(format_args!("the table cannot be written: {error}"), "take --format csv"))
        }
    }
}

fn request(arguments: &SimulateArguments) -> Result<SimulateRequest, Failure> {
    let load = match arguments.load.as_deref().map(str::trim) {
        None => None,
        Some("none") => Some(LoadLaw::None),
        Some(text) => Some(LoadLaw::Constant(option::torque(text, "--load")?)),
    };
    let length = match (arguments.until, &arguments.duration) {
        (Some(_), _) => Some(RunLength::Periodic),
        (None, text) => text.as_deref().map(length).transpose()?,
    };
    let start = arguments
        .start
        .as_deref()
        .map_or(Ok(StartOfRun::default()), start_from_words)
        .map_err(|(message, hint)| Failure::input(format_args!("--start: {message}"), hint))?;
    let speed = arguments.speed.as_deref().map(|text| option::start_speed(text, "--speed")).transpose()?;
    if speed.is_some() && start.speed.is_some() {
        return Err(Failure::input(
            "--speed and --start both give the speed at the start",
            "give it in one of them",
        ));
    }
    Ok(SimulateRequest {
        speed: speed.or(start.speed),
        start_angle: start.angle,
        start_block: start.block,
        events: Vec::new(),
        points: Vec::new(),
        length,
        imposed: match (arguments.imposed, arguments.free) {
            (true, _) => Some(true),
            (false, true) => Some(false),
            (false, false) => None,
        },
        on_mounts: arguments.block.map(|block| block == BlockOption::Mounts),
        gravity: arguments.no_gravity.then_some(false),
        gas: arguments.inertia_only.then_some(false),
        load,
        reacts_on: arguments.load_on_block.then_some(ReactsOn::Block),
        misfire: Vec::new(),
        step: arguments.step.as_deref().map(|text| option::angle(text, "--step")).transpose()?,
        tolerance: arguments.tolerance,
        long: arguments.long,
    })
}

/// `10 revolutions` or `2 s`.
fn length(text: &str) -> Result<RunLength, Failure> {
    let text = text.trim();
    let turns = text.strip_suffix("revolutions").or_else(|| text.strip_suffix("revolution"));
    let Some(turns) = turns else {
        let time = option::time(text, "--for").map_err(|_| {
            Failure::input(
                format_args!("--for needs a number of revolutions or a time, got \"{text}\""),
                "write it like \"10 revolutions\" or \"2 s\"; a periodic motion is asked for by --until periodic",
            )
        })?;
        return Ok(RunLength::Time(time));
    };
    match turns.trim().parse::<f64>() {
        Ok(turns) if turns > 0.0 && turns.is_finite() => Ok(RunLength::Revolutions(turns)),
        _ => Err(Failure::input(
            format_args!("--for needs a number of revolutions above 0, got \"{text}\""),
            "write it like \"10 revolutions\" or \"2 s\"",
        )),
    }
}
