//! `lanchester sensitivity`: what matters most for loads, torque, bearings and mounts.

use crate::commands::{json, open};
use crate::failure::{DONE, Failure};
use crate::figures::write_figures;
use crate::files::{print, tell};
use crate::format::Format;
use crate::options::sensitivity::{SensitivityArguments, WeightsOption};
use crate::trace_files::trace_files;
use lanchester::mechanism::OuterTorque;
use lanchester::report::{sensitivity_brief, sensitivity_csv, sensitivity_text, tornado_figure};
use lanchester::study::sensitivity::{Output, SensitivityRequest, Weights, sensitivity};
use lanchester::task::option;
use lanchester::{operating_point, sensitivity_amount};

pub fn run(arguments: &SensitivityArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let speed = arguments.speed.as_deref().map(|text| option::speed(text, "--speed")).transpose()?;
    let amounts =
        arguments.vary.iter().map(|text| sensitivity_amount(text, "--vary")).collect::<Result<_, _>>()?;
    let file = open(&arguments.file, colour)?.file;
    let engine = file.engine;
    let named = |text: &String| Output::named(text, &engine).map_err(Failure::refused);
    let outputs: Vec<Output> = arguments.output.iter().map(named).collect::<Result<_, Failure>>()?;
    let outputs = if outputs.is_empty() { Output::peaks() } else { outputs };
    let needs = Output::needs_of(&outputs);
    let traces = if needs.gas { trace_files(&engine, &arguments.file)? } else { Vec::new() };
    let speed = speed.unwrap_or(engine.speed.highest);
    let (mut point, warnings) = operating_point(&engine, &traces, speed, needs).map_err(Failure::refused)?;
    point.outer = OuterTorque::of(file.tasks.simulation.as_deref()).map_err(Failure::refused)?;
    point.weights = match arguments.weights {
        WeightsOption::Fixed => Weights::Fixed,
        WeightsOption::Follow => Weights::Follow,
    };
    for warning in &warnings {
        tell(format_args!("warning: {warning}"));
    }
    let request = SensitivityRequest {
        outputs,
        each: arguments.each,
        amounts,
        only: arguments.only,
        sobol: arguments.sobol.map(|draws| [draws, arguments.seed.unwrap_or(1)]),
    };
    let found = sensitivity(&point, &request).map_err(Failure::refused)?;
    if let Some(folder) = &arguments.figures {
        write_figures(folder, &arguments.file, &[tornado_figure(&found)])?;
    }
    let said = match arguments.format {
        Format::Text if arguments.printed.brief => sensitivity_brief(&found),
        Format::Text => sensitivity_text(&found),
        Format::Json => json(&found)?,
        Format::Csv => sensitivity_csv(&found),
    };
    print(&said)?;
    Ok(DONE)
}
