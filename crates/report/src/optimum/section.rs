//! The section of the report on what balancing found.

use crate::kit::figure::Figure;
use crate::kit::table::Table;
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

/// What the section shows.
pub(crate) struct OptimumSection {
    /// What was reached, in a sentence.
    pub headline: String,
    /// How it was found, in a sentence.
    pub method: String,
    pub tables: Vec<Table>,
    pub figures: Vec<Figure>,
    /// What shakes the engine with the answer; empty without one.
    pub left: String,
}

impl OptimumSection {
    pub fn of(engine: &Engine, input: &OptimumInput<'_>) -> OptimumSection {
        let answer = input.answer;
        let (headline, method) = (headline(engine, answer), method_words(answer));
        let equals = equals_words(engine, answer);
        let worse = input.consequences.map_or_else(String::new, consequence_words);
        let words = [headline, equals, worse].into_iter().filter(|words| !words.is_empty());
        let headline = words.collect::<Vec<_>>().join(" ");
        if let Outcome::Infeasible { closest, .. } = &answer.outcome {
            let tables = match closest.is_empty() {
                true => Vec::new(),
                false => vec![closest_table(engine, answer, closest)],
            };
            return OptimumSection { headline, method, tables, figures: Vec::new(), left: String::new() };
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
        OptimumSection { headline, method, tables, figures, left: input.after.diagnosis.summary.clone() }
    }
}
