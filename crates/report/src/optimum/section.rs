//! The section of the report on what balancing found.

use crate::kit::section::Section;
use crate::optimum::before_after::before_and_after_table;
use crate::optimum::cancellation::{cancellation_proof_table, cancelled_orders_table};
use crate::optimum::consequence_figures::consequence_figures;
use crate::optimum::consequence_text::consequence_words;
use crate::optimum::figures::optimum_figures;
use crate::optimum::tables::{
    closest_table, found_inertias_table, found_shafts_table, found_weights_table, limits_table, stages_table,
    web_bounds_table,
};
use crate::optimum::text::{equals_words, headline, method_words};
use lanchester_balance::{Answer, Consequences, Outcome};
use lanchester_mechanism::Loads;
use lanchester_model::Engine;

/// What the section `[balance]` of an engine file asks, answered.
#[derive(Debug, Clone, Copy)]
pub struct OptimumInput<'a> {
    /// What was found.
    pub answer: &'a Answer,
    /// Loads as the file stands, at the speed of the answer.
    pub before: &'a Loads,
    /// The engine with the answer fitted.
    pub fitted: &'a Engine,
    /// Its loads, at the same speed.
    pub after: &'a Loads,
    /// What the answer does to the engine.
    pub consequences: Option<&'a Consequences>,
}

/// What balancing found, as a section of a report.
pub fn optimum_section(engine: &Engine, input: &OptimumInput<'_>) -> Section {
    let answer = input.answer;
    let equals = equals_words(engine, answer);
    let worse = input.consequences.map_or_else(String::new, consequence_words);
    let words = [headline(engine, answer), equals, worse].into_iter().filter(|words| !words.is_empty());
    let method = format!(
        "{} What may be done and what is wanted stands in the section [balance] of the engine file.",
        method_words(answer)
    );
    let section = Section::new("optimum", "Optimum", "The optimum")
        .lead(words.collect::<Vec<_>>().join(" "))
        .words(method);
    if let Outcome::Infeasible { closest, .. } = &answer.outcome {
        let closest = (!closest.is_empty()).then(|| closest_table(engine, answer, closest));
        return section.tables(closest);
    }
    let mut tables = Vec::new();
    if !answer.weights.is_empty() {
        tables.push(found_weights_table(answer));
        tables.extend(web_bounds_table(answer));
    }
    tables.extend(found_shafts_table(answer));
    tables.extend(found_inertias_table(answer));
    tables.extend(before_and_after_table(engine, answer, input.consequences));
    match &answer.cancellation {
        Some(cancellation) => {
            tables.push(cancelled_orders_table(engine, cancellation));
            tables.extend(cancellation_proof_table(engine, cancellation));
        }
        None if !answer.stages.is_empty() => tables.push(stages_table(engine, answer)),
        None => {}
    }
    tables.extend(limits_table(engine, answer));
    let mut figures = optimum_figures(engine, answer, input.before, input.fitted, input.after);
    let pictures = input.consequences.map(|consequences| consequence_figures(input.fitted, consequences));
    figures.extend(pictures.into_iter().flatten());
    let left = &input.after.diagnosis.summary;
    let left = if left.is_empty() { String::new() } else { format!("What is left. {left}") };
    section.words(left).rows(figures).tables(tables)
}
