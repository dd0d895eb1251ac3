//! Whether a task can be answered at all.

use crate::error::BalanceError;
use crate::operator::ratio_of;
use crate::problem::implied;
use lanchester_model::Engine;
use lanchester_task::{
    BalanceTask, Catalogue, Criterion, DrillCatalogue, FreeWeight, GiveUp, Phase, Place, Seat,
};

/// Places closer than this are the same [m].
const SAME_PLACE: f64 = 1e-9;

/// Phases closer than this are the same line [rad].
const SAME_LINE: f64 = 1e-9;

/// Refuses numbers that are not possible and weights that cannot be told apart.
pub(crate) fn check(engine: &Engine, task: &BalanceTask) -> Result<(), BalanceError> {
    for shaft in &task.shafts {
        place("x", &shaft.name, shaft.x)?;
        place("y", &shaft.name, shaft.y)?;
    }
    if let Some(cost) = task.shaft_costs.iter().find(|cost| !(**cost >= 0.0 && cost.is_finite())) {
        return Err(number("fixed cost", "a shaft", "0 or more", *cost));
    }
    for one in &task.weights {
        weight(engine, task, one)?;
    }
    for speed in &task.speeds {
        positive("speed", "the speeds that are judged", *speed)?;
    }
    for weight in &task.speed_weights {
        positive("weight", "a speed that is judged", *weight)?;
    }
    if task.speed_weights.len() > task.speeds.len() {
        let got = task.speed_weights.len() as f64;
        return Err(number(
            "number of weights",
            "the speeds that are judged",
            "at most that of the speeds",
            got,
        ));
    }
    for inertia in &task.inertias {
        positive("ratio", &inertia.name, inertia.ratio)?;
        positive("inertia of the crank train", &inertia.name, inertia.crank_inertia)?;
        if let Some(most) = inertia.most {
            positive("largest inertia", &inertia.name, most)?;
        }
    }
    if let Some(second) = task.inertias.iter().filter(|inertia| !inertia.optional).nth(1) {
        return Err(BalanceError::OneInertia { second: second.name.clone() });
    }
    for tie in &task.ties {
        let second = task
            .weights
            .get(tie.second)
            .filter(|_| tie.first < task.weights.len() && tie.first != tie.second);
        let Some(second) = second else {
            let got = tie.second as f64;
            return Err(number("tie", "ties", "between two of the weights", got));
        };
        if !tie.factor.is_finite() {
            return Err(number("factor of the tie", &second.name, "finite", tie.factor));
        }
    }
    for stage in &task.stages {
        for (weight, criterion) in &stage.terms {
            if !(weight.is_finite() && *weight > 0.0) {
                return Err(number("weight in a stage", &format!("{criterion:?}"), "positive", *weight));
            }
        }
    }
    for limit in &task.limits {
        if !(limit.most >= 0.0 && limit.most.is_finite()) {
            return Err(number("limit", &format!("{:?}", limit.criterion), "0 or more", limit.most));
        }
    }
    give_ups(engine, task)?;
    alike(engine, task)?;
    let mass = task
        .stages
        .iter()
        .flat_map(|s| s.terms.iter().map(|t| t.1))
        .chain(task.limits.iter().map(|l| l.criterion));
    if mass.into_iter().any(|c| c == Criterion::AddedMass)
        && let Some(weight) = task.weights.iter().find(|w| w.radius.is_none())
    {
        return Err(BalanceError::NoRadius { weight: weight.name.clone() });
    }
    Ok(())
}

/// Refuses shares and amounts that are none, stages that are not there, and what nobody could use.
fn give_ups(engine: &Engine, task: &BalanceTask) -> Result<(), BalanceError> {
    let count = task.stages_or_default().len();
    for (stage, give_up) in task.give_up.iter().enumerate() {
        let (GiveUp::Share(value) | GiveUp::Amount(value)) = *give_up else { continue };
        let name = format!("stage {}", stage + 1);
        if stage >= count {
            return Err(number("give-up", &name, "for a stage that is there", value));
        }
        if !(value >= 0.0 && value.is_finite()) {
            return Err(number("give-up", &name, "0 or more", value));
        }
        if stage + 1 == count && value > 0.0 && implied(engine, task).is_empty() {
            return Err(BalanceError::Unsuited {
                method: "what the last stage gives up",
                needed: "something after it that could use it",
                got: "nothing that is decided after it".into(),
                hint: "add another criterion to what is minimised, or leave the give-up out",
            });
        }
    }
    Ok(())
}

fn number(quantity: &'static str, device: &str, needed: &'static str, got: f64) -> BalanceError {
    BalanceError::Number { quantity, device: device.to_string(), needed, got }
}

fn positive(quantity: &'static str, device: &str, got: f64) -> Result<(), BalanceError> {
    if got > 0.0 && got.is_finite() { Ok(()) } else { Err(number(quantity, device, "positive", got)) }
}

fn place(quantity: &'static str, device: &str, place: Place) -> Result<(), BalanceError> {
    match place {
        Place::At(value) if !value.is_finite() => Err(number(quantity, device, "finite", value)),
        Place::Between(low, high) if !(low.is_finite() && high.is_finite() && low < high) => {
            Err(number(quantity, device, "a stretch whose end lies beyond its start", high - low))
        }
        Place::At(_) | Place::Between(..) => Ok(()),
    }
}

fn weight(engine: &Engine, task: &BalanceTask, weight: &FreeWeight) -> Result<(), BalanceError> {
    let name = &weight.name;
    let (count, seat) = match weight.seat {
        Seat::Crankshaft(index) => (engine.crankshafts.len(), index),
        Seat::Shaft(index) => (task.shafts.len(), index),
    };
    if seat >= count {
        return Err(number("seat", name, "one of the crankshafts or shafts", seat as f64));
    }
    place("z", name, weight.z)?;
    if !(weight.least >= 0.0 && weight.least.is_finite()) {
        return Err(number("least amount", name, "0 or more", weight.least));
    }
    if let Some(most) = weight.most
        && !(most >= weight.least && most.is_finite())
    {
        return Err(number("largest amount", name, "finite and no less than the least amount", most));
    }
    match weight.phase {
        Phase::Line(angle) | Phase::Direction(angle) if !angle.is_finite() => {
            return Err(number("phase", name, "finite", angle));
        }
        Phase::Free | Phase::Line(_) | Phase::Direction(_) => {}
    }
    weight.radius.map_or(Ok(()), |radius| positive("radius", name, radius))?;
    for (what, cost) in [("fixed cost", weight.cost.fixed), ("cost per amount", weight.cost.per_amount)] {
        if !(cost >= 0.0 && cost.is_finite()) {
            return Err(number(what, name, "0 or more", cost));
        }
    }
    catalogue(task, weight)?;
    let on_free_shaft = match weight.seat {
        Seat::Shaft(index) => {
            let shaft = &task.shafts[index];
            shaft.optional
                || task.pays_for_shaft(index)
                || [shaft.x, shaft.y].iter().any(|p| matches!(p, Place::Between(..)))
        }
        Seat::Crankshaft(_) => false,
    };
    let pays = weight.cost.fixed > 0.0 && task.asks_for_cost();
    let chosen = pays || weight.optional || matches!(weight.z, Place::Between(..)) || on_free_shaft;
    if chosen && weight.most.is_none() {
        return Err(BalanceError::Unbounded { device: name.clone() });
    }
    Ok(())
}

/// Refuses catalogues that are none, that leave no amount, and equal parts of unlike catalogues.
fn catalogue(task: &BalanceTask, weight: &FreeWeight) -> Result<(), BalanceError> {
    let unsuited = |needed: &'static str, got: String, hint: &'static str| {
        Err(BalanceError::Unsuited { method: "a catalogue of amounts", needed, got, hint })
    };
    let name = &weight.name;
    let Some(catalogue) = &weight.catalogue else {
        if weight.equal_parts.is_some() {
            return unsuited(
                "a step or a list of amounts where parts are equal",
                format!("neither for `{name}`"),
                "give `step` or `catalogue`, or tie the weights with `equal_to`",
            );
        }
        return Ok(());
    };
    match catalogue {
        Catalogue::Steps(step) => positive("step", name, *step)?,
        Catalogue::Amounts(list) => {
            list.iter().try_for_each(|amount| positive("amount of the catalogue", name, *amount))?;
            if list.is_empty() || !list.is_sorted_by(|a, b| a < b) {
                return unsuited(
                    "one amount or more, rising",
                    format!("{} for `{name}`", list.len()),
                    "sort them and give each once",
                );
            }
        }
    }
    let is_of = |drill: &DrillCatalogue| {
        let holes = drill.holes();
        (1..=holes.len()).all(|k| catalogue.amount(k) == holes[k - 1].unbalance)
            && catalogue.last() == holes.len()
    };
    if weight.drill.as_ref().is_some_and(|drill| !is_of(drill)) {
        return unsuited(
            "the unbalances of the holes as the catalogue of a drilled weight",
            format!("others for `{name}`"),
            "set both with `FreeWeight::drilled`",
        );
    }
    let last = weight.most.map_or(catalogue.last(), |most| catalogue.below(most));
    if weight.least > 0.0 && catalogue.amount(last) < weight.least * (1.0 - 1e-9) {
        return unsuited(
            "an amount from the least to the largest one",
            format!("none for `{name}`"),
            "widen `least` and `most`, or add an amount",
        );
    }
    if task.ties.iter().any(|tie| task.weights[tie.second].name == *name) {
        return unsuited(
            "weights that follow no other",
            format!("`{name}`"),
            "give the leader the catalogue",
        );
    }
    let unlike = |other: &&FreeWeight| {
        other.equal_parts == weight.equal_parts && other.catalogue.as_ref() != Some(catalogue)
    };
    match task.weights.iter().find(unlike).filter(|_| weight.equal_parts.is_some()) {
        Some(other) => unsuited(
            "the same catalogue for equal parts",
            format!("others for `{name}` and `{}`", other.name),
            "give both the same amounts, or another name of the parts",
        ),
        None => Ok(()),
    }
}

/// Refuses two weights in one plane of one axis at one speed that are not tied and have a direction in common.
fn alike(engine: &Engine, task: &BalanceTask) -> Result<(), BalanceError> {
    let axis = |weight: &FreeWeight| match weight.seat {
        Seat::Crankshaft(index) => {
            let crankshaft = &engine.crankshafts[index];
            Some([crankshaft.x, crankshaft.y])
        }
        Seat::Shaft(index) => match (task.shafts[index].x, task.shafts[index].y) {
            (Place::At(x), Place::At(y)) => Some([x, y]),
            _ => None,
        },
    };
    let same_line = |a: Phase, b: Phase| match (a, b) {
        (Phase::Line(a) | Phase::Direction(a), Phase::Line(b) | Phase::Direction(b)) => {
            (a - b).sin().abs() < SAME_LINE
        }
        _ => true,
    };
    for (j, second) in task.weights.iter().enumerate() {
        for (i, first) in task.weights[..j].iter().enumerate() {
            let (Place::At(z1), Place::At(z2)) = (first.z, second.z) else { continue };
            let same_axis = first.seat == second.seat
                || matches!((axis(first), axis(second)), (Some(a), Some(b))
                    if (a[0] - b[0]).abs() < SAME_PLACE && (a[1] - b[1]).abs() < SAME_PLACE);
            let same_speed = ratio_of(engine, task, first.seat) == ratio_of(engine, task, second.seat);
            let tied =
                task.ties.iter().any(|t| (t.first, t.second) == (i, j) || (t.first, t.second) == (j, i));
            let chosen = [first, second].iter().any(|w| w.optional || w.least > 0.0 || w.catalogue.is_some());
            if same_axis
                && same_speed
                && (z1 - z2).abs() < SAME_PLACE
                && !tied
                && !chosen
                && same_line(first.phase, second.phase)
            {
                return Err(BalanceError::Alike { first: first.name.clone(), second: second.name.clone() });
            }
        }
    }
    Ok(())
}
