//! `lanchester simulate`: the rigid crank train in time.

use crate::commands::{json, open};
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::figures::write_figures;
use crate::files::print;
use crate::format::Format;
use crate::options::simulation::{BlockOption, SimulateArguments, SimulationTable};
use crate::simulation_watch::GoesOn;
use crate::trace_files::trace_files;
use lanchester::multibody::{LoadLaw, ReactsOn, RunOutcome};
use lanchester::report::{
    simulation_energy_csv, simulation_events_csv, simulation_figures, simulation_orders_csv,
    simulation_reactions_csv, simulation_text, simulation_trace_csv,
};
use lanchester::task::option;
use lanchester::{RunLength, SimulateRequest, simulate_watched};

pub fn run(arguments: &SimulateArguments, colour: bool) -> Result<u8, Failure> {
    if arguments.table.is_some() && arguments.format != Format::Csv {
        return Err(Failure::input(
            "--table chooses what --format csv writes",
            "add --format csv, or leave --table out",
        ));
    }
    let mut request = request(arguments)?;
    let opened = open(&arguments.file, colour)?;
    for &number in &arguments.misfire {
        let count = opened.file.engine.cylinders.len();
        if !(1..=count).contains(&number) {
            let needed = format!("--misfire needs a number of a cylinder, from 1 to {count}, got {number}");
            return Err(Failure::input(needed, "cylinders are numbered as in the file"));
        }
        request.misfire.push(number - 1);
    }
    let in_file = opened.file.tasks.simulation.as_ref().and_then(|input| input.gas);
    let traces = match request.gas.or(in_file) {
        Some(false) => Vec::new(),
        _ => trace_files(&opened.file.engine, &arguments.file)?,
    };
    let goes_on = GoesOn::until_interrupted();
    let result = simulate_watched(&opened.file, &traces, &request, &|_| goes_on.now());
    let result = result.map_err(Failure::refused)?;
    if let Some(folder) = &arguments.figures {
        write_figures(folder, &arguments.file, &simulation_figures(&result))?;
    }
    print(&match (arguments.format, arguments.table) {
        (Format::Text, _) => simulation_text(&result),
        (Format::Json, _) => json(&result)?,
        (Format::Csv, Some(SimulationTable::Reactions)) => simulation_reactions_csv(&result),
        (Format::Csv, Some(SimulationTable::Orders)) => simulation_orders_csv(&result),
        (Format::Csv, Some(SimulationTable::Energy)) => simulation_energy_csv(&result),
        (Format::Csv, Some(SimulationTable::Events)) => simulation_events_csv(&result),
        (Format::Csv, _) => simulation_trace_csv(&result),
    })?;
    let ended =
        matches!(result.run.outcome, RunOutcome::Complete | RunOutcome::Stopped | RunOutcome::AtRest { .. });
    Ok(if ended { DONE } else { NOT_AS_EXPECTED })
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
    Ok(SimulateRequest {
        speed: arguments.speed.as_deref().map(|text| option::speed(text, "--speed")).transpose()?,
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
    let Some(turns) = turns else { return Ok(RunLength::Time(option::time(text, "--for")?)) };
    match turns.trim().parse::<f64>() {
        Ok(turns) if turns > 0.0 && turns.is_finite() => Ok(RunLength::Revolutions(turns)),
        _ => Err(Failure::input(
            format_args!("--for needs a number of revolutions above 0, got \"{text}\""),
            "write it like \"10 revolutions\" or \"2 s\"",
        )),
    }
}
