//! `lanchester crosscheck`: closed form and bond graph against the multibody simulation.

use crate::commands::{json, open};
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::files::print;
use crate::format::Format;
use crate::options::simulation::{ConditionOption, CrosscheckArguments};
use crate::trace_files::trace_files;
use lanchester::report::{Condition, crosscheck_brief, crosscheck_csv, crosscheck_text};
use lanchester::task::option;
use lanchester::{CrossCheckRequest, crosscheck};

pub fn run(arguments: &CrosscheckArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let speed = arguments.speed.as_deref().map(|text| option::speed(text, "--speed")).transpose()?;
    if let Some(bar) = arguments.bar.filter(|bar| !(*bar > 0.0 && bar.is_finite())) {
        return Err(Failure::input(
            format_args!("--bar needs a share above 0, got {bar}"),
            "write it like 1e-10",
        ));
    }
    let conditions = arguments.condition.iter().map(|condition| match condition {
        ConditionOption::A => Condition::LikeForLike,
        ConditionOption::B => Condition::FreeSpeed,
        ConditionOption::C => Condition::MovingBlock,
        ConditionOption::D => Condition::AllFree,
        ConditionOption::E => Condition::FlexibleCrank,
    });
    let opened = open(&arguments.file, colour)?;
    let request = CrossCheckRequest {
        speed,
        conditions: conditions.collect(),
        max_order: arguments.order,
        bar: arguments.bar,
        simulation: opened.file.tasks.simulation.clone(),
    };
    let traces = trace_files(&opened.file.engine, &arguments.file)?;
    let check = crosscheck(&opened.file.engine, &traces, &request).map_err(Failure::refused)?;
    let said = match arguments.format {
        Format::Text if arguments.printed.brief => crosscheck_brief(&check),
        Format::Text => crosscheck_text(&check),
        Format::Json => json(&check)?,
        Format::Csv => crosscheck_csv(&check),
    };
    print(&said)?;
    Ok(if check.agrees() { DONE } else { NOT_AS_EXPECTED })
}
