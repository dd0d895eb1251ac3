//! The section `[balance]`.

use super::text::{File, quantity, quoted, ratio, turn_between};
use lanchester_model::Engine;
use lanchester_model::angle;
use lanchester_task::WHAT_FITS;
use lanchester_task::criterion::{dimension, name_among};
use lanchester_task::workshop::{DrillDirection, Surface};
use lanchester_task::{
    AtLeast, BalanceTask, Catalogue, Criterion, DrillCatalogue, FreeWeight, GiveUp, Limit, Phase, Place,
    Seat, Tasks,
};
use lanchester_units::{Dimension, text_that};
use std::f64::consts::PI;

impl File {
    pub(super) fn balance(&mut self, tasks: &Tasks, engine: &Engine) {
        let Some(task) = &tasks.balance else { return };
        self.header("[balance]", "");
        let named = |criterion: &Criterion| quoted(&name_among(criterion, &engine.mounts));
        if !task.stages.is_empty() {
            let stages: Vec<String> = task
                .stages
                .iter()
                .map(|stage| match stage.terms.as_slice() {
                    [(weight, criterion)] if *weight == 1.0 => named(criterion),
                    terms => {
                        let terms: Vec<String> = terms
                            .iter()
                            .map(|(weight, criterion)| {
                                let text = text_that(1.0 / weight, dimension(criterion), |read| {
                                    1.0 / read == *weight
                                });
                                format!("{} = \"{text}\"", named(criterion))
                            })
                            .collect();
                        format!("{{ {} }}", terms.join(", "))
                    }
                })
                .collect();
            self.entry("minimise", &format!("[{}]", stages.join(", ")));
        }
        if !task.speeds.is_empty() {
            let text = |(speed, weight): &(f64, f64)| {
                let speed = quantity(*speed, Dimension::Speed);
                if *weight == 1.0 { speed } else { format!("{{ speed = {speed}, weight = {weight} }}") }
            };
            let speeds: Vec<String> = task.weighted_speeds().iter().map(text).collect();
            self.entry("speeds", &format!("[{}]", speeds.join(", ")));
        }
        let give_ups: Vec<String> = task
            .stages_or_default()
            .iter()
            .zip(&task.give_up)
            .filter_map(|(stage, give_up)| {
                let criterion = &stage.terms.first()?.1;
                let text = match give_up {
                    GiveUp::Nothing => return None,
                    GiveUp::Share(share) => quantity(*share, Dimension::Share),
                    GiveUp::Amount(amount) => quantity(*amount, dimension(criterion)),
                };
                Some(format!("{} = {text}", named(criterion)))
            })
            .collect();
        if !give_ups.is_empty() {
            self.entry("give_up", &format!("{{ {} }}", give_ups.join(", ")));
        }
        let (budgets, limits): (Vec<&Limit>, Vec<&Limit>) =
            task.limits.iter().partition(|limit| limit.criterion == Criterion::Cost);
        if let Some(budget) = budgets.first() {
            self.entry("budget", &format!("{:?}", budget.most));
        }
        if !limits.is_empty() {
            let limits: Vec<String> = limits
                .iter()
                .map(|limit| {
                    format!(
                        "{} = {}",
                        named(&limit.criterion),
                        quantity(limit.most, dimension(&limit.criterion))
                    )
                })
                .collect();
            self.entry("limits", &format!("{{ {} }}", limits.join(", ")));
        }
        let wish = &task.durability;
        if !wish.at_least.is_empty() {
            let value = |one: &AtLeast| match one.criterion.is_film() {
                true => quantity(one.least, Dimension::Length),
                false => format!("{:?}", one.least),
            };
            let all =
                wish.at_least.iter().map(|one| format!("\"{}\" = {}", one.criterion.name(), value(one)));
            self.entry("at_least", &format!("{{ {} }}", all.collect::<Vec<_>>().join(", ")));
        }
        if !wish.maximise.is_empty() {
            let all = wish.maximise.iter().map(|criterion| format!("\"{}\"", criterion.name()));
            self.entry("maximise", &format!("[{}]", all.collect::<Vec<_>>().join(", ")));
        }
        if !task.cancel.is_empty() {
            let orders: Vec<String> =
                task.cancel.iter().map(|&(load, order)| named(&Criterion::Order(load, order))).collect();
            self.entry("cancel", &format!("[{}]", orders.join(", ")));
        }
        if let Some(most) = task.most_optional {
            self.entry("most_optional", &most.to_string());
        }
        for (index, weight) in task.weights.iter().enumerate() {
            if let Seat::Crankshaft(crankshaft) = weight.seat {
                self.header("[[balance.counterweight]]", "");
                if crankshaft > 0 {
                    self.entry("crankshaft", &(crankshaft + 1).to_string());
                }
                for (key, value) in weight_entries(task, index, engine) {
                    self.entry(key, &value);
                }
            }
        }
        for (index, shaft) in task.shafts.iter().enumerate() {
            self.header("[[balance.shaft]]", "");
            self.entry("name", &quoted(&shaft.name));
            self.entry("ratio", &ratio(shaft.ratio));
            self.entry("x", &place(shaft.x));
            self.entry("y", &place(shaft.y));
            if task.shaft_cost(index) != 0.0 {
                self.entry("fixed_cost", &format!("{:?}", task.shaft_cost(index)));
            }
            if shaft.optional {
                self.entry("optional", "true");
            }
            let own = task.weights.iter().enumerate().filter(|(_, weight)| weight.seat == Seat::Shaft(index));
            let list: String = own
                .map(|(index, _)| {
                    let entries: Vec<String> = weight_entries(task, index, engine)
                        .into_iter()
                        .map(|(key, value)| format!("{key} = {value}"))
                        .collect();
                    format!("    {{ {} }},\n", entries.join(", "))
                })
                .collect();
            self.entry("weights", &format!("[\n{list}]"));
        }
        for inertia in &task.inertias {
            self.header("[[balance.inertia]]", "");
            self.entry("name", &quoted(&inertia.name));
            self.entry("ratio", &format!("{:?}", inertia.ratio));
            self.entry("crank_inertia", &quantity(inertia.crank_inertia, Dimension::Inertia));
            if let Some(most) = inertia.most {
                self.entry("most", &quantity(most, Dimension::Inertia));
            }
            if inertia.optional {
                self.entry("optional", "true");
            }
        }
    }
}

/// Keys and values of a weight, but for its crankshaft.
fn weight_entries(task: &BalanceTask, index: usize, engine: &Engine) -> Vec<(&'static str, String)> {
    let weight = &task.weights[index];
    let mut entries = vec![("name", quoted(&weight.name)), ("z", place(weight.z))];
    if let Some(tie) = task.ties.iter().find(|tie| tie.second == index) {
        let (key, factor) = match (tie.mirrored, tie.factor) {
            (true, factor) => ("mirrored_to", factor),
            (false, factor) if factor < 0.0 => ("opposed_to", -factor),
            (false, factor) => ("equal_to", factor),
        };
        entries.push((key, quoted(&task.weights[tie.first].name)));
        if factor != 1.0 {
            entries.push(("factor", format!("{factor:?}")));
        }
    } else {
        let along = if matches!(weight.seat, Seat::Shaft(_)) { "phase" } else { "angle" };
        match weight.phase {
            Phase::Free => {}
            Phase::Direction(phase) => {
                // That of the hole.
                let is_hole = weight.drill.as_ref().is_some_and(|drill| drill.slug_density.is_none());
                let phase = if is_hole { angle::direction(phase + PI) } else { phase };
                entries.push((along, direction(phase, weight, engine)));
            }
            Phase::Line(phase) => entries.push(("line", direction(phase, weight, engine))),
        }
        let amount = |amount: f64| quantity(amount, Dimension::Unbalance);
        match weight.most {
            Some(most) if most == weight.least && weight.drill.is_none() => {
                entries.push(("unbalance", amount(most)))
            }
            most => {
                if weight.least > 0.0 {
                    entries.push(("least", amount(weight.least)));
                }
                entries.extend(most.map(|most| ("most", amount(most))));
                if weight.fits && most.is_none() {
                    entries.push(("most", quoted(WHAT_FITS)));
                }
            }
        }
        match &weight.catalogue {
            _ if weight.drill.is_some() => entries.extend(weight.drill.as_ref().map(|d| ("drill", drill(d)))),
            Some(Catalogue::Steps(step)) => entries.push(("step", amount(*step))),
            Some(Catalogue::Amounts(list)) => {
                let list: Vec<String> = list.iter().map(|one| amount(*one)).collect();
                entries.push(("catalogue", format!("[{}]", list.join(", "))));
            }
            None => {}
        }
        for (key, cost) in [("fixed_cost", weight.cost.fixed), ("cost_per_kg_m", weight.cost.per_amount)] {
            if cost != 0.0 {
                entries.push((key, format!("{cost:?}")));
            }
        }
        entries.extend(weight.equal_parts.as_ref().map(|name| ("equal_parts", quoted(name))));
        if weight.optional {
            entries.push(("optional", "true".to_string()));
        }
    }
    entries.extend(weight.radius.map(|radius| ("radius", quantity(radius, Dimension::Length))));
    entries
}

/// Holes as an inline table.
fn drill(drill: &DrillCatalogue) -> String {
    let length = |length: f64| quantity(length, Dimension::Length);
    let mut entries = match (drill.direction, drill.surface) {
        (DrillDirection::Axial, _) => "direction = \"axial\"".to_string(),
        (DrillDirection::Radial, Surface::Round) => "direction = \"radial\"".to_string(),
        (DrillDirection::Radial, Surface::Flat) => "direction = \"radial\", surface = \"flat\"".to_string(),
    };
    let diameters: Vec<String> = drill.diameters.iter().map(|one| length(*one)).collect();
    let more = [
        ("radius", length(drill.radius)),
        ("diameters", format!("[{}]", diameters.join(", "))),
        ("max_depth", length(drill.max_depth)),
        ("depth_step", length(drill.depth_step)),
        ("point", quantity(drill.point, Dimension::Angle)),
        ("density", quantity(drill.density, Dimension::Density)),
    ];
    let slug = drill.slug_density.map(|density| ("slug_density", quantity(density, Dimension::Density)));
    for (key, value) in more.into_iter().chain(slug) {
        entries.push_str(&format!(", {key} = {value}"));
    }
    format!("{{ {entries} }}")
}

/// On a crankshaft angles count from its own zero.
fn direction(phase: f64, weight: &FreeWeight, engine: &Engine) -> String {
    let zero = match weight.seat {
        Seat::Crankshaft(index) => engine.crankshafts.get(index).map_or(0.0, |crankshaft| crankshaft.phase),
        Seat::Shaft(_) => 0.0,
    };
    if zero == 0.0 {
        return quantity(phase, Dimension::Angle);
    }
    turn_between(zero, phase)
}

fn place(place: Place) -> String {
    match place {
        Place::At(at) => quantity(at, Dimension::Length),
        Place::Between(first, last) => {
            format!("[{}, {}]", quantity(first, Dimension::Length), quantity(last, Dimension::Length))
        }
    }
}
