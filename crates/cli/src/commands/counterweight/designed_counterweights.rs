//! What `counterweight design` found for counterweights, as text and CSV.

use super::words::{list, room_words};
use lanchester::geometry::clearance::{RadialEnvelope, SweptRoom};
use lanchester::geometry::{DesignOutcome, DesignSettings, Evolution, Optimum};
use lanchester::report::{
    DesignedShape, designed_dimensions_table, designed_properties_table, nearest_limits_table,
    objective_name, objective_words,
};
use lanchester::{CounterweightDesigns, DesignedCounterweight};

/// Weights of one duty, and what was found for them.
struct Group<'a> {
    names: String,
    duty: f64,
    room: Option<&'a SweptRoom>,
    envelope: Option<&'a RadialEnvelope>,
    part_mass: Option<f64>,
    without_room: Option<f64>,
    outcome: &'a DesignOutcome,
    evolution: Option<&'a Evolution>,
}

fn groups(designs: &CounterweightDesigns) -> Vec<Group<'_>> {
    let mut groups: Vec<Group> = Vec::new();
    for weight in &designs.weights {
        // Weights of one duty that stand alike have one outcome.
        let alike =
            |other: &DesignedCounterweight| other.duty == weight.duty && other.outcome == weight.outcome;
        let names = designs.weights.iter().filter(|other| alike(other));
        let names = list(names.map(|other| other.name.as_str()));
        if groups.iter().any(|group| group.names == names) {
            continue;
        }
        groups.push(Group {
            names,
            duty: weight.duty,
            room: weight.room.as_ref(),
            envelope: weight.envelope.as_ref(),
            part_mass: weight.part_mass,
            without_room: weight.without_room,
            outcome: &weight.outcome,
            evolution: weight.evolution.as_ref(),
        });
    }
    groups
}

fn shapes<'a>(groups: &'a [Group<'a>]) -> Vec<(DesignedShape<'a>, &'a Optimum)> {
    let found = groups.iter().filter_map(|group| match group.outcome {
        DesignOutcome::Found(best) => {
            let shape = DesignedShape { names: &group.names, duty: group.duty, design: &best.design };
            Some((shape, best.as_ref()))
        }
        DesignOutcome::Infeasible(_) => None,
    });
    found.collect()
}

/// How far a proof of this gap goes, in words.
fn proved_to(gap: f64) -> String {
    if gap == DesignSettings::PROVED_GAP {
        "one part in a million".to_owned()
    } else {
        format!("{:.4} %", 100.0 * gap)
    }
}

/// What was found, as text.
pub fn text(designs: &CounterweightDesigns) -> String {
    let groups = &groups(designs);
    let mut out = String::new();
    let shapes = shapes(groups);
    for (shape, best) in &shapes {
        let name = objective_name(best.objective);
        let value = objective_words(best.objective, best.value);
        let is_bounded = groups.iter().any(|group| group.names == shape.names && group.envelope.is_some());
        let within = if is_bounded {
            "the ranges, limits and the clearance envelope"
        } else {
            "the ranges and limits"
        };
        out += &match best.proved {
            true => format!(
                "{}: the least {name} of all shapes within {within} is {value}, proved to {}.\n",
                shape.names,
                proved_to(designs.task.settings.gap)
            ),
            false => format!(
                "{}: the least {name} found is {value}; the proof was stopped after {} boxes; \
                 hint: --max-boxes {} goes on, a wider --gap ends it earlier.\n",
                shape.names,
                best.boxes,
                designs.task.settings.max_boxes.saturating_mul(10)
            ),
        };
    }
    out += &groups.iter().filter_map(in_the_room).collect::<String>();
    for group in groups {
        if let (Some(mass), DesignOutcome::Found(best)) = (group.part_mass, group.outcome) {
            out += &format!(
                "{}: the exported part has {:.1} g, with the web's disc and flank that it covers; {:.1} g of it are beyond the web as it is.\n",
                group.names,
                1e3 * mass,
                1e3 * best.design.mass
            );
        }
    }
    for group in groups {
        out += &group
            .evolution
            .map(|evolution| evolved(&group.names, evolution, group.outcome))
            .unwrap_or_default();
    }
    if !shapes.is_empty() {
        let shapes: Vec<DesignedShape> = shapes.into_iter().map(|(shape, _)| shape).collect();
        out += &format!("\n{}", designed_properties_table(&shapes).text());
        out += &format!("\n{}", designed_dimensions_table(&shapes).text());
    }
    out + &in_the_way(groups)
}

/// What clearance costs, where it does.
fn in_the_room(group: &Group<'_>) -> Option<String> {
    let mut told = format!("{}: {}", group.names, room_words(group.room, group.envelope)?);
    if let DesignOutcome::Infeasible(infeasible) = group.outcome
        && infeasible.nearest.is_empty()
    {
        told += " No shape with this unbalance keeps it: relaxing one limit alone is not sufficient.";
    }
    if let (Some(without), DesignOutcome::Found(best)) = (group.without_room, group.outcome) {
        told += &format!(
            " The best shape of all, which does not keep it, has {}: no shape that does has less.",
            objective_words(best.objective, without)
        );
    }
    Some(told + "\n")
}

/// What the evolutionary search found, beside the optimum.
fn evolved(names: &str, evolution: &Evolution, outcome: &DesignOutcome) -> String {
    let looked = format!("{names}: the evolutionary search looked at {} designs", evolution.evaluations);
    match (evolution.best, outcome) {
        (None, _) => format!("{looked} and met none within all limits.\n"),
        (Some(found), DesignOutcome::Found(best)) => format!(
            "{looked}; its best, {}, is {:.3} % above the optimum.\n",
            objective_words(evolution.objective, found.value),
            100.0 * (found.value / best.value - 1.0)
        ),
        (Some(found), DesignOutcome::Infeasible(_)) => {
            format!("{looked}; its best is {}.\n", objective_words(evolution.objective, found.value))
        }
    }
}

/// What stands in the way of a shape.
pub fn infeasible_text(designs: &CounterweightDesigns) -> String {
    format!("{}\n{}", designs.engine, in_the_way(&groups(designs)))
}

fn in_the_way(groups: &[Group<'_>]) -> String {
    let mut out = String::new();
    for group in groups {
        if let DesignOutcome::Infeasible(infeasible) = group.outcome {
            out += &format!("\n{}", nearest_limits_table(&group.names, infeasible).text());
            if !infeasible.proved {
                out += "The search was stopped before its end: a shape may have been overlooked.\n";
            }
        }
    }
    out
}

/// Properties and dimensions of what was found, as CSV.
pub fn csv(designs: &CounterweightDesigns) -> String {
    let groups = &groups(designs);
    let shapes: Vec<DesignedShape> = shapes(groups).into_iter().map(|(shape, _)| shape).collect();
    let mut table = designed_properties_table(&shapes);
    let dimensions = designed_dimensions_table(&shapes);
    table.columns.extend(dimensions.columns.into_iter().skip(1));
    for (row, more) in table.rows.iter_mut().zip(dimensions.rows) {
        row.extend(more.into_iter().skip(1));
    }
    table.csv()
}
