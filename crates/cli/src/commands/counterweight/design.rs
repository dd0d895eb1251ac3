//! `lanchester counterweight design`: the best shape for every counterweight.

use super::{draw, list, refused, room_words};
use crate::commands::put_back::PutBack;
use crate::commands::{json, open};
use crate::counterweight_arguments::{DesignArguments, DesignMethod};
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::files::print;
use crate::format::Format;
use crate::shape_request::shape_request;
use lanchester::geometry::clearance::SweptRoom;
use lanchester::geometry::{Design, DesignOutcome, Evolution, Optimum};
use lanchester::report::{
    DesignedShape, designed_dimensions_table, designed_properties_table, nearest_limits_table,
    objective_name, objective_words,
};
use lanchester::{
    CounterweightDesigns, CounterweightRequest, DesignedCounterweight, EvolutionRequest,
    design_counterweights, with_counterweights,
};

/// Weights of one duty, and what was found for them.
struct Group<'a> {
    names: String,
    duty: f64,
    /// What of the shape the plain web has already [kg m].
    shared: f64,
    room: Option<&'a SweptRoom>,
    without_room: Option<f64>,
    outcome: &'a DesignOutcome,
    evolution: Option<&'a Evolution>,
}

pub fn run(arguments: &DesignArguments, colour: bool) -> Result<u8, Failure> {
    let opened = open(&arguments.shape.file, colour)?;
    let engine = &opened.engine;
    let evolution = evolution(arguments)?;
    let request = CounterweightRequest { evolution, ..shape_request(engine, &arguments.shape)? };
    let designs = design_counterweights(engine, &request).map_err(refused)?;
    let groups = groups(&designs);
    let found: Vec<(usize, Design)> = designs
        .weights
        .iter()
        .filter_map(|weight| match &weight.outcome {
            DesignOutcome::Found(best) => Some((weight.index, best.design)),
            DesignOutcome::Infeasible(_) => None,
        })
        .collect();
    let put_back = PutBack {
        path: &arguments.shape.file,
        write: arguments.write,
        dry_run: arguments.dry_run,
        what: "shapes",
    };
    let status = if found.len() == designs.weights.len() { DONE } else { NOT_AS_EXPECTED };
    if !found.is_empty() {
        let after = with_counterweights(engine, &found, request.task.density).map_err(refused)?;
        if put_back.run(&opened, &after, colour)? {
            return Ok(status);
        }
        if let Some(folder) = &arguments.figures {
            draw(&after, folder, &arguments.shape.file)?;
        }
    }
    print(&match arguments.format {
        Format::Text => text(&designs, &groups),
        Format::Json => json(&designs)?,
        Format::Csv => csv(&groups),
    })?;
    Ok(status)
}

/// The evolutionary search that is asked for.
fn evolution(arguments: &DesignArguments) -> Result<Option<EvolutionRequest>, Failure> {
    match arguments.method {
        DesignMethod::Proof if arguments.seed.is_some() || arguments.evaluations.is_some() => {
            Err(Failure::input(
                "--seed and --evaluations are of the evolutionary search, which is not asked for",
                "add --method evolution, or leave them out",
            ))
        }
        DesignMethod::Proof => Ok(None),
        DesignMethod::Evolution => Ok(Some(EvolutionRequest {
            seed: arguments.seed.unwrap_or(1),
            evaluations: arguments.evaluations.unwrap_or(20_000),
        })),
    }
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
            shared: weight.shared,
            room: weight.room.as_ref(),
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
            let (names, duty, shared) = (group.names.as_str(), group.duty, group.shared);
            let shape = DesignedShape { names, duty, shared, design: &best.design };
            Some((shape, best.as_ref()))
        }
        DesignOutcome::Infeasible(_) => None,
    });
    found.collect()
}

fn text(designs: &CounterweightDesigns, groups: &[Group<'_>]) -> String {
    let mut out = format!("{}\n\n", designs.engine);
    let shapes = shapes(groups);
    for (shape, best) in &shapes {
        let name = objective_name(best.objective);
        let value = objective_words(best.objective, best.value);
        out += &match best.proved {
            true => format!(
                "{}: the least {name} of all shapes within the ranges and limits is {value}, proved to one part in a million.\n",
                shape.names
            ),
            false => format!(
                "{}: the least {name} found is {value}; the proof was broken off after {} boxes.\n",
                shape.names, best.boxes
            ),
        };
    }
    out += &groups.iter().filter_map(in_the_room).collect::<String>();
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
    let room = group.room?;
    let mut told = format!("{}: {}", group.names, room_words(room));
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
                out += "The search was broken off: a shape may have been overlooked.\n";
            }
        }
    }
    out
}

fn csv(groups: &[Group<'_>]) -> String {
    let shapes: Vec<DesignedShape> = shapes(groups).into_iter().map(|(shape, _)| shape).collect();
    let mut table = designed_properties_table(&shapes);
    let dimensions = designed_dimensions_table(&shapes);
    table.columns.extend(dimensions.columns.into_iter().skip(1));
    for (row, more) in table.rows.iter_mut().zip(dimensions.rows) {
        row.extend(more.into_iter().skip(1));
    }
    table.csv()
}
