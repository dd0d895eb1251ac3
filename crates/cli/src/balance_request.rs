//! From the options of `balance` to a task: what the file's section `[balance]` says, changed by the options.

use crate::arguments::{BalanceArguments, CrankWeights};
use crate::failure::Failure;
use lanchester::model::option::{self, BadQuantity};
use lanchester::model::{
    BalanceTask, CrankWeightPlaces, Engine, FreeShaft, FreeWeight, Phase, Place, Ratio, Seat, crank_weights,
    default_task,
};

/// The task behind the options.
pub fn balance_task(engine: &Engine, arguments: &BalanceArguments) -> Result<BalanceTask, Failure> {
    let mut task = engine.balance.clone().unwrap_or_else(|| default_task(engine));
    if let Some(places) = arguments.counterweights {
        replace_crank_weights(engine, &mut task, places)?;
    }
    for text in &arguments.shaft {
        add_shaft(&mut task, text)?;
    }
    if let Some(most) = &arguments.most {
        let most = option::unbalance(most, "--most").map_err(refused)?;
        for weight in task.weights.iter_mut().filter(|w| matches!(w.seat, Seat::Crankshaft(_))) {
            weight.most = Some(most);
        }
    }
    if !arguments.minimise.is_empty() {
        let stage = |text: &String| option::stage(text, &engine.mounts, "--minimise").map_err(refused);
        task.stages = arguments.minimise.iter().map(stage).collect::<Result<_, Failure>>()?;
    }
    if !arguments.minimise.is_empty() {
        task.cancel.clear();
    }
    if !arguments.cancel.is_empty() {
        let orders = |text: &String| option::cancel(text, &engine.mounts, "--cancel").map_err(refused);
        let lists: Vec<_> = arguments.cancel.iter().map(orders).collect::<Result<_, Failure>>()?;
        (task.cancel, task.stages, task.limits) = (lists.concat(), Vec::new(), Vec::new());
    }
    for text in &arguments.limit {
        let limit = option::limit(text, &engine.mounts, "--limit").map_err(refused)?;
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

fn refused(bad: BadQuantity) -> Failure {
    Failure::input(&bad.message, &bad.hint)
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

/// `RATIO @ x, y @ z1, z2`
fn add_shaft(task: &mut BalanceTask, text: &str) -> Result<(), Failure> {
    let wrong =
        |what: String| Failure::input(what, "write it like --shaft \"-1 @ 0 mm, 100 mm @ -40 mm, 40 mm\"");
    let parts: Vec<&str> = text.split('@').map(str::trim).collect();
    let [ratio, axis, planes] = parts[..] else {
        return Err(wrong(format!("--shaft needs ratio @ x, y @ planes, got `{text}`")));
    };
    let ratio = ratio_of(ratio)
        .ok_or_else(|| wrong(format!("--shaft needs a ratio such as -1 or 1/2, got `{ratio}`")))?;
    let length = |text: &str| option::length(text.trim(), "--shaft").map_err(refused);
    let axis: Vec<f64> = axis.split(',').map(length).collect::<Result<_, _>>()?;
    let [x, y] = axis[..] else {
        return Err(wrong(format!("--shaft needs the two coordinates x, y of its axis, got {}", axis.len())));
    };
    let planes: Vec<f64> = planes.split(',').map(length).collect::<Result<_, _>>()?;
    let taken = |name: &str| task.shafts.iter().any(|s| s.name == name);
    let name =
        (1..).map(|n| format!("shaft {n}")).find(|name| !taken(name)).expect("invariant: numbers do not end");
    let seat = Seat::Shaft(task.shafts.len());
    for (k, z) in planes.iter().enumerate() {
        task.weights.push(FreeWeight {
            name: format!("{name} {}", k + 1),
            seat,
            z: Place::At(*z),
            least: 0.0,
            most: None,
            phase: Phase::Free,
            optional: false,
            radius: None,
        });
    }
    task.shafts.push(FreeShaft { name, ratio, x: Place::At(x), y: Place::At(y), optional: false });
    Ok(())
}

fn ratio_of(text: &str) -> Option<Ratio> {
    match text.split_once('/') {
        Some((numerator, denominator)) => {
            Ratio::new(numerator.trim().parse().ok()?, denominator.trim().parse().ok()?)
        }
        None => Ratio::whole(text.trim_start_matches('+').parse().ok()?),
    }
}
