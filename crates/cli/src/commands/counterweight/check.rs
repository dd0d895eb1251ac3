//! `lanchester counterweight check`: crankshaft and counterweights as they stand in the file.

use super::drawings::draw;
use crate::commands::{json, open};
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::files::{print, write_result};
use crate::format::Format;
use crate::options::counterweight::{CheckTable, CounterweightCheckArguments};
use lanchester::model::Engine;
use lanchester::report::{
    Figure, clearance_plot, clearance_words, clearances_table, counterweight_parts_table, crank_body_words,
    crank_sections_table, shaft_weight_parts_table, swept_overlap_words,
};
use lanchester::{CounterweightCheck, check_counterweights, clearance_curve};

pub fn run(arguments: &CounterweightCheckArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    if arguments.table.is_some() && arguments.format != Format::Csv {
        return Err(Failure::input(
            "--table chooses what --format csv writes",
            "add --format csv, or leave --table out",
        ));
    }
    let opened = open(&arguments.file, colour)?;
    let engine = &opened.file.engine;
    let checked = check_counterweights(engine).map_err(Failure::refused)?;
    if let Some(folder) = &arguments.figures {
        draw(engine, folder, &arguments.file)?;
        if let Some(figure) = clearance_figure(engine, &checked)? {
            write_result(&folder.join(format!("{}.svg", figure.id)), &arguments.file, &figure.svg())?;
        }
    }
    let said = match arguments.format {
        Format::Text if arguments.printed.brief => brief(&checked),
        Format::Text => text(engine, &checked),
        Format::Json => json(&checked)?,
        Format::Csv => csv(engine, &checked, arguments.table)?,
    };
    print(&arguments.printed.said(arguments.format, said))?;
    Ok(if checked.is_kept { DONE } else { NOT_AS_EXPECTED })
}

/// Angles of a curve.
const ANGLES: usize = 360;

/// The clearance over the angle of the part that comes nearest to anything.
fn clearance_figure(engine: &Engine, checked: &CounterweightCheck) -> Result<Option<Figure>, Failure> {
    let Some(clearances) = &checked.clearances else { return Ok(None) };
    let Some(smallest) = &clearances.smallest else { return Ok(None) };
    let Some(index) = clearances.bodies.iter().position(|body| body.name == smallest.body) else {
        return Ok(None);
    };
    let mut moving: Vec<_> =
        clearances.bodies[index].clearances.iter().filter(|one| one.theta.is_some()).collect();
    moving.sort_by(|a, b| a.signed().total_cmp(&b.signed()));
    let curve = |obstacle| {
        clearance_curve(engine, index, obstacle, ANGLES)
            .map(|curve| (obstacle, curve))
            .map_err(Failure::refused)
    };
    let curves = moving.into_iter().map(|one| curve(one.obstacle)).collect::<Result<Vec<_>, _>>()?;
    Ok((!curves.is_empty()).then(|| clearance_plot(&smallest.body, &curves)))
}

fn text(engine: &Engine, checked: &CounterweightCheck) -> String {
    let mut out = format!("{}\n", checked.engine);
    for body in &checked.crankshafts {
        out += &format!("\n{}\n", crank_body_words(body));
    }
    if let Some(table) = counterweight_parts_table(engine) {
        out += &format!("\n{}", table.text());
    }
    for weight in checked.counterweights.iter().filter(|weight| !weight.is_met) {
        out += &missed(&weight.name, weight.wanted, weight.unbalance);
    }
    if let Some(table) = shaft_weight_parts_table(engine) {
        out += &format!("\n{}", table.text());
    }
    let shafts = checked.shaft_weights.iter().map(|weight| (&weight.name, weight.wanted, weight));
    for (name, wanted, weight) in shafts.filter(|(.., weight)| !weight.is_met) {
        out += &missed(name, wanted, weight.unbalance);
    }
    out += &swept_overlap_words(&checked.swept_overlaps);
    for body in &checked.crankshafts {
        out += &format!("\n{}", crank_sections_table(body).text());
    }
    match &checked.clearances {
        Some(clearances) => {
            out += &format!("\n{}", clearances_table(clearances, true).text());
            out += &format!("{}\n", clearance_words(clearances));
        }
        None => out += &format!("\n{UNCHECKED}\n"),
    }
    out
}

const UNCHECKED: &str = "No clearance is checked: the file has no section [clearance].";

/// What misses its unbalance, what overlaps, and the smallest clearance.
fn brief(checked: &CounterweightCheck) -> String {
    let mut out = format!("{}\n", checked.engine);
    for weight in checked.counterweights.iter().filter(|weight| !weight.is_met) {
        out += &missed(&weight.name, weight.wanted, weight.unbalance);
    }
    for weight in checked.shaft_weights.iter().filter(|weight| !weight.is_met) {
        out += &missed(&weight.name, weight.wanted, weight.unbalance);
    }
    out += &swept_overlap_words(&checked.swept_overlaps);
    out + &checked.clearances.as_ref().map_or_else(|| UNCHECKED.to_owned(), clearance_words) + "\n"
}

/// A weight that has not the unbalance that it should have [kg m].
fn missed(name: &str, wanted: Option<f64>, unbalance: f64) -> String {
    let share = 100.0 * (unbalance / wanted.unwrap_or_default() - 1.0);
    format!(
        "{name} misses its unbalance by {share:.2} %: `lanchester counterweight design` finds the shape that has it.\n"
    )
}

fn csv(engine: &Engine, checked: &CounterweightCheck, table: Option<CheckTable>) -> Result<String, Failure> {
    let missing = |what: &str, hint: &str| Failure::input(what, hint);
    match table.unwrap_or(CheckTable::Counterweights) {
        CheckTable::Counterweights => {
            counterweight_parts_table(engine).map(|table| table.csv()).ok_or_else(|| {
                missing("no counterweight has a shape yet", "`counterweight design --write` finds shapes")
            })
        }
        CheckTable::ShaftWeights => {
            shaft_weight_parts_table(engine).map(|table| table.csv()).ok_or_else(|| {
                missing(
                    "no weight of a balance shaft has a shape yet",
                    "`counterweight design --write` finds shapes where the file has a section [shaft_weight_design]",
                )
            })
        }
        CheckTable::Sections if checked.crankshafts.is_empty() => {
            Err(missing("the file says nothing of the crankshaft's pieces", "add [crank.body]"))
        }
        CheckTable::Sections => {
            let tables = checked.crankshafts.iter().map(|body| crank_sections_table(body).csv());
            Ok(tables.collect::<Vec<_>>().join("\n"))
        }
        CheckTable::Clearances => checked
            .clearances
            .as_ref()
            .map(|clearances| clearances_table(clearances, false).csv())
            .ok_or_else(|| missing("the file names nothing to stay clear of", "add a section [clearance]")),
    }
}
