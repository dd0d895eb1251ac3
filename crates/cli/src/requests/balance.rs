//! From the options of `balance` to a task: what the file's section `[balance]` says, changed by the options.

use crate::arguments::{BalanceArguments, CrankWeights};
use crate::failure::Failure;
use lanchester::file::EngineFile;
use lanchester::task::{BalanceTask, CrankWeightPlaces, TaskOptions, default_task};

/// The task behind the options.
pub fn balance_task(file: &EngineFile, arguments: &BalanceArguments) -> Result<BalanceTask, Failure> {
    let options = TaskOptions {
        prefix: "--",
        counterweights: arguments.counterweights.map(places),
        shafts: arguments.shaft.clone(),
        minimise: arguments.minimise.clone(),
        limits: arguments.limit.clone(),
        cancel: arguments.cancel.clone(),
        least: arguments.least.clone(),
        most: arguments.most.clone(),
        budget: arguments.budget.clone(),
        step: arguments.weight_step.clone(),
        equal_parts: arguments.equal_parts,
        optional: arguments.optional,
        most_optional: arguments.most_optional,
        speeds: arguments.speed.clone(),
        give_up: arguments.give_up.clone(),
        maximise: arguments.durable.maximise.clone(),
        at_least: arguments.durable.at_least.clone(),
    };
    let engine = &file.engine;
    let task = file.tasks.balance.clone().unwrap_or_else(|| default_task(engine));
    let changed = options.change(engine, task)?;
    for fault in changed.warnings {
        eprintln!("warning: {}\nhint: {}", fault.message, fault.hint);
    }
    Ok(changed.task)
}

fn places(weights: CrankWeights) -> CrankWeightPlaces {
    match weights {
        CrankWeights::None => CrankWeightPlaces::None,
        CrankWeights::File => CrankWeightPlaces::File,
        CrankWeights::Throws => CrankWeightPlaces::Throws,
        CrankWeights::Webs => CrankWeightPlaces::Webs,
    }
}
