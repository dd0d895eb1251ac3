//! From the options of `balance` to a task: what the file's section `[balance]` says, changed by the options.

use crate::arguments::{BalanceArguments, CrankWeights};
use crate::failure::Failure;
use crate::shaft_option::add_shaft;
use lanchester::model::option;
use lanchester::model::{
    BalanceTask, CrankWeightPlaces, Engine, RoomFaultKind, Seat, TaskDevice, crank_weights, default_task,
    room_faults,
};

/// The task behind the options.
pub fn balance_task(engine: &Engine, arguments: &BalanceArguments) -> Result<BalanceTask, Failure> {
    let mut task = engine.balance.clone().unwrap_or_else(|| default_task(engine));
    if let Some(places) = arguments.counterweights {
        replace_crank_weights(engine, &mut task, places)?;
    }
    let (own_shafts, own_weights) = (task.shafts.len(), task.weights.len());
    for text in &arguments.shaft {
        add_shaft(&mut task, text)?;
    }
    // Of what stands in the file its reader has told.
    for fault in room_faults(engine, &task) {
        let of_file = match fault.device {
            TaskDevice::Shaft(index) => index < own_shafts,
            TaskDevice::Weight(index) => index < own_weights,
        };
        if of_file {
            continue;
        }
        if fault.kind == RoomFaultKind::Through {
            return Err(Failure::input(&fault.message, fault.hint));
        }
        eprintln!("warning: {}\nhint: {}", fault.message, fault.hint);
    }
    bound_crank_weights(&mut task, arguments)?;
    if !arguments.minimise.is_empty() {
        let stage = |text: &String| option::stage(text, &engine.mounts, "--minimise").map_err(Failure::from);
        task.stages = arguments.minimise.iter().map(stage).collect::<Result<_, Failure>>()?;
    }
    if !arguments.minimise.is_empty() {
        task.cancel.clear();
    }
    if !arguments.cancel.is_empty() {
        let orders = |text: &String| option::cancel(text, &engine.mounts, "--cancel").map_err(Failure::from);
        let lists: Vec<_> = arguments.cancel.iter().map(orders).collect::<Result<_, Failure>>()?;
        (task.cancel, task.stages, task.limits) = (lists.concat(), Vec::new(), Vec::new());
    }
    for text in &arguments.limit {
        let limit = option::limit(text, &engine.mounts, "--limit").map_err(Failure::from)?;
        task.limits.retain(|l| l.criterion != limit.criterion);
        task.limits.push(limit);
    }
    if task.weights.is_empty() && task.inertias.is_empty() {
        return Err(Failure::input(
            "nothing is free: there is no weight whose unbalance could be found",
            "give --counterweights, --shaft, or a section [balance] in the engine file",
        ));
    }
    Ok(task)
}

/// Bounds the weights on crankshafts, and says how many optional devices may be used.
fn bound_crank_weights(task: &mut BalanceTask, arguments: &BalanceArguments) -> Result<(), Failure> {
    let amount = |text: &Option<String>, option: &str| {
        text.as_ref().map(|text| option::unbalance(text, option).map_err(Failure::from)).transpose()
    };
    let (least, most) = (amount(&arguments.least, "--least")?, amount(&arguments.most, "--most")?);
    let followers: Vec<usize> = task.ties.iter().map(|tie| tie.second).collect();
    for (index, weight) in task.weights.iter_mut().enumerate() {
        if !matches!(weight.seat, Seat::Crankshaft(_)) {
            continue;
        }
        weight.most = most.or(weight.most);
        // A follower does what its leader does.
        if !followers.contains(&index) {
            weight.least = least.unwrap_or(weight.least);
            weight.optional |= arguments.optional;
        }
    }
    let Some(most) = arguments.most_optional else { return Ok(()) };
    let shafts = task.shafts.iter().any(|shaft| shaft.optional);
    if !shafts && !task.weights.iter().any(|w| w.optional) && !task.inertias.iter().any(|i| i.optional) {
        return Err(Failure::input(
            "--most-optional counts optional devices, and nothing is optional",
            "add --optional for the weights on the crank, or write a shaft like \
             --shaft '-1 @ 0 mm, 100 mm @ 0 mm @ optional, most 0.02 kg m'",
        ));
    }
    task.most_optional = Some(most);
    Ok(())
}

/// Drops the free weights on crankshafts with their ties, and sets those asked for in their place.
fn replace_crank_weights(
    engine: &Engine,
    task: &mut BalanceTask,
    places: CrankWeights,
) -> Result<(), Failure> {
    let on_shaft: Vec<bool> = task.weights.iter().map(|w| matches!(w.seat, Seat::Shaft(_))).collect();
    let moved: Vec<usize> =
        (0..on_shaft.len()).map(|k| on_shaft[..k].iter().filter(|kept| **kept).count()).collect();
    task.ties.retain(|t| on_shaft[t.first] && on_shaft[t.second]);
    for tie in &mut task.ties {
        (tie.first, tie.second) = (moved[tie.first], moved[tie.second]);
    }
    let mut index = 0;
    task.weights.retain(|_| {
        index += 1;
        on_shaft[index - 1]
    });
    let places = match places {
        CrankWeights::None => return Ok(()),
        CrankWeights::File => CrankWeightPlaces::File,
        CrankWeights::Throws => CrankWeightPlaces::Throws,
        CrankWeights::Webs => CrankWeightPlaces::Webs,
    };
    let weights = crank_weights(engine, places);
    if weights.is_empty() {
        return Err(match places {
            CrankWeightPlaces::Webs => Failure::input(
                "--counterweights webs needs the places of the webs, and the file does not give them",
                "add web_distance to [crank]",
            ),
            _ => Failure::input(
                "--counterweights file needs counterweights in the file, and it has none",
                "--counterweights throws puts one in the plane of every throw",
            ),
        });
    }
    task.weights.extend(weights);
    Ok(())
}
