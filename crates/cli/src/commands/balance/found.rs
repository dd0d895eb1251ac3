//! What balancing found: as tables, and put into the engine file.

use crate::arguments::{BalanceArguments, BalanceTable};
use crate::commands::Opened;
use crate::failure::Failure;
use crate::put_back::PutBack;
use lanchester::WebExcess;
use lanchester::balance::{Answer, Consequences};
use lanchester::mechanism::{LoadRequest, Loads, loads};
use lanchester::model::Engine;
use lanchester::report::{
    cancellation_proof_table, cancelled_orders_table, consequence_words, consequences_table, effects_table,
    found_weights_table, limits_table, stages_table,
};
use lanchester::task::BalanceTask;
use serde::Serialize;

pub fn loads_of(engine: &Engine) -> Result<Loads, Failure> {
    loads(engine, &LoadRequest::default()).map_err(crate::commands::refused)
}

/// Does what `--write` and `--dry-run` of `balance` ask ([`PutBack`]). Where only the difference is shown, what gets worse and
/// which counterweights go is said beside it.
pub fn put_into_file(
    opened: &Opened,
    arguments: &BalanceArguments,
    after: &Engine,
    effect: Option<&Consequences>,
    colour: bool,
) -> Result<bool, Failure> {
    let BalanceArguments { file, write, dry_run, .. } = arguments;
    let put_back = PutBack { path: file, write: *write, dry_run: *dry_run, what: "weights" };
    let is_all = put_back.run(opened, after, colour)?;
    let words = effect.filter(|_| is_all).map_or_else(String::new, consequence_words);
    if !words.is_empty() {
        eprintln!("{words}");
    }
    Ok(is_all)
}

/// Says which weights do not fit on their webs, where the way in which they were found knows no bound of that.
pub fn tell_what_does_not_fit(opened: &Opened, after: &Engine) -> Result<(), Failure> {
    let shapes = opened.file.tasks.shape_task.as_ref();
    let found = lanchester::web_excesses(after, shapes).map_err(Failure::refused)?;
    let grams = |unbalance: f64| format!("{:.1} g mm", 1e6 * unbalance);
    if !found.too_large.is_empty() {
        let (count, of) = (found.too_large.len(), found.checked);
        eprintln!(
            "warning: this method knows no bound of what fits on the webs: {count} of {of} weights do not fit"
        );
        for WebExcess { name, web, unbalance, bound, by } in &found.too_large {
            eprintln!("  {name}, web {web}: {}; what fits is {}, by {by}", grams(*unbalance), grams(*bound));
        }
        eprintln!("hint: `lanchester balance` without --search and --method bounds them by what fits");
    }
    if !found.elsewhere.is_empty() {
        let names = found.elsewhere.join(", ");
        eprintln!("note: what fits is not checked for weights that stand on no web: {names}");
    }
    Ok(())
}

/// An answer with what it does to the engine.
#[derive(Debug, Serialize)]
pub struct WithConsequences<'a, T> {
    #[serde(flatten)]
    pub answer: &'a T,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub consequences: Option<&'a Consequences>,
}

/// What the weights of `after` do to `engine`.
pub fn consequences(
    engine: &Engine,
    after: &Engine,
    task: Option<&BalanceTask>,
) -> Result<Consequences, Failure> {
    lanchester::consequences(engine, after, task).map_err(Failure::refused)
}

pub fn csv(
    engine: &Engine,
    answer: &Answer,
    consequences: Option<&Consequences>,
    table: Option<BalanceTable>,
) -> String {
    match table.unwrap_or(BalanceTable::Weights) {
        BalanceTable::Weights => found_weights_table(answer).csv(),
        BalanceTable::Effects => effects_table(engine, answer).csv(),
        BalanceTable::Consequences => {
            consequences.map_or(String::new(), |found| consequences_table(found).csv())
        }
        BalanceTable::Stages => stages_table(engine, answer).csv(),
        BalanceTable::Limits => limits_table(engine, answer).map_or(String::new(), |table| table.csv()),
        BalanceTable::Durability => String::new(),
        BalanceTable::Orders => {
            let table = answer.cancellation.as_ref().map(|c| cancelled_orders_table(engine, c));
            table.map_or(String::new(), |table| table.csv())
        }
        BalanceTable::Proof => {
            let table = answer.cancellation.as_ref().and_then(|c| cancellation_proof_table(engine, c));
            table.map_or(String::new(), |table| table.csv())
        }
    }
}
