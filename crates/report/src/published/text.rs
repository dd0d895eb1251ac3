//! A published method and the optimum beside it as plain text.

use crate::kit::magnitude::Magnitude;
use crate::kit::number;
use crate::kit::paragraph::push_wrapped;
use crate::kit::rounding::clean;
use crate::optimum::consequence_tables::consequences_table;
use crate::optimum::consequence_text::consequence_words;
use crate::optimum::effect_noise::effect_noise;
use crate::optimum::tables::stages_table;
use crate::published::tables::{
    equilibrium_table, method_effects_table, method_numbers_table, method_orders_table, method_weights_table,
};
use lanchester_balance::Consequences;
use lanchester_literature::{MethodAnswer, MethodFound};
use lanchester_model::Engine;
use lanchester_task::{Criterion, criterion_name, criterion_unit};
use std::fmt::Write;

/// What the method found, what it leaves, and how much better the same devices could do, as aligned plain text.
pub fn method_text(engine: &Engine, answer: &MethodAnswer, consequences: &Consequences) -> String {
    let mut out = String::with_capacity(4096);
    let rpm = number::terminal(number::rpm(answer.optimum.speed), 0);
    let _ = writeln!(out, "{} at {rpm} rpm, where the loads of the range are largest", answer.engine);
    push_wrapped(&mut out, "", &format!("Method: {}.", method_source(&answer.found)));
    out.push('\n');
    push_wrapped(&mut out, "", &verdict(engine, answer));
    push_wrapped(&mut out, "", &consequence_words(consequences));
    let mut tables = vec![method_weights_table(answer), method_numbers_table(answer)];
    tables.extend(equilibrium_table(answer));
    tables.extend([
        method_effects_table(engine, answer),
        consequences_table(consequences),
        method_orders_table(answer),
        stages_table(engine, &answer.optimum),
    ]);
    for table in tables {
        out.push('\n');
        out.push_str(&table.text());
    }
    let remarks = remarks(answer);
    if !remarks.is_empty() {
        out.push_str("\nTo know about it\n");
        for remark in remarks {
            push_wrapped(&mut out, "  - ", &remark);
        }
    }
    out
}

/// Name and source of a method.
pub fn method_source(found: &MethodFound) -> String {
    const THESIS: &str = "J. Singh, Mass balancing of 3-cylinder and 4-cylinder inline engines, ME thesis, Thapar \
                          University, 2017";
    match found {
        MethodFound::Matrix { printed_used, .. } => format!(
            "matrices of the crankshaft balancing tool, Applied Sciences 2021, 11, 8997, {}",
            if *printed_used {
                "with the shafts as it sizes them for a V engine"
            } else {
                "its equations corrected"
            }
        ),
        MethodFound::ThreeCylinder { .. } => {
            format!("50 % rule of the in-line three with a balancer shaft, {THESIS}")
        }
        MethodFound::FourCylinder { .. } => format!("second-order shafts of the in-line four, {THESIS}"),
        MethodFound::Factor { share, .. } => {
            format!(
                "rotating masses and {} % of the reciprocating ones, {THESIS}",
                number::trimmed(100.0 * share, 4)
            )
        }
    }
}

/// Below this a load on the block of `engine` in `unit`, N or N m, is rounding.
pub fn residual_noise(engine: &Engine, unit: &str) -> f64 {
    Magnitude::of_masses(engine).noise_of_unit(unit)
}

/// How much the method leaves, in a sentence.
fn verdict(engine: &Engine, answer: &MethodAnswer) -> String {
    // The lightest of equals is sought last, without being judged.
    let stages = &answer.optimum.stages;
    let loads = stages
        .iter()
        .rposition(|s| s.terms[0].0 != Criterion::AddedUnbalance)
        .map_or(stages.len(), |last| last + 1);
    let judged = answer.optimum.effects.iter().filter(|e| {
        stages[..loads].iter().flat_map(|s| &s.terms).any(|(criterion, _)| *criterion == e.criterion)
    });
    let words: Vec<String> = judged
        .map(|e| {
            let noise = effect_noise(engine, &answer.optimum.effects, &e.criterion);
            let [before, after] = [e.before, e.after].map(|v| clean(v, noise));
            let unit = criterion_unit(&e.criterion);
            let name = criterion_name(&e.criterion, engine);
            let close = (before - after).abs() <= 1e-6 * e.without.abs().max(before);
            let number = |v: f64| number::short(v, 5);
            match close {
                true => format!("{name} {} {unit}, as little as these devices allow", number(before)),
                false => format!(
                    "{name} {} {unit} where the optimum of the same devices has {} {unit}",
                    number(before),
                    number(after)
                ),
            }
        })
        .collect();
    format!("The method leaves {}.", words.join("; "))
}

/// What to know about the result, in sentences.
fn remarks(answer: &MethodAnswer) -> Vec<String> {
    match &answer.found {
        MethodFound::Matrix { balance, .. } => balance.remarks.iter().map(ToString::to_string).collect(),
        MethodFound::ThreeCylinder { .. } => {
            vec!["the second-order couple has no device; the rule leaves all of it".to_owned()]
        }
        MethodFound::FourCylinder { .. } => vec![
            "the shafts stand level with the crank: what they do to the roll moment is left out of the rule"
                .to_owned(),
        ],
        MethodFound::Factor { .. } => Vec::new(),
    }
}
