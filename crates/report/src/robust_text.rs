//! The answer for a production of engines, as plain text.

use crate::balance_tables::{effects_table, found_inertias_table, found_shafts_table, found_weights_table};
use crate::number::short;
use crate::terminal::push_wrapped;
use lanchester_balance::{RobustAnswer, RobustMeasure};
use lanchester_model::Engine;
use lanchester_task::criterion_name;

/// What was found, how sure it is, and what it costs the engine as it is meant.
pub fn robust_text(engine: &Engine, found: &RobustAnswer) -> String {
    let name = criterion_name(&found.criterion, engine);
    let unit = &found.unit;
    let of = match found.measure {
        RobustMeasure::Worst => format!("the worst of {} engines", found.samples),
        RobustMeasure::MeanOfWorst(_) => {
            format!("the mean of the worst {} of {} engines", found.averaged, found.samples)
        }
    };
    let amount = |value: f64| format!("{} {unit}", short(value, 6));
    let mut out = format!("{} within its tolerances (seed {})\n\n", found.answer.engine, found.seed);
    push_wrapped(
        &mut out,
        "",
        &format!(
            "The least {name} of {of} that these devices allow: {}; no weights bring it below {}. Standard error by resampling: {}.",
            amount(found.value),
            amount(found.lower_bound),
            amount(found.standard_error)
        ),
    );
    if let Some(second) = found.second_value {
        let words =
            format!("{} other engines, drawn independently, have {}.", found.second_samples, amount(second));
        push_wrapped(&mut out, "", &words);
    }
    push_wrapped(
        &mut out,
        "",
        &format!(
            "The weights that are best for the engine as it is meant would have {}. As it is meant it has {} with the weights below, {} with its own best.",
            amount(found.ordinary),
            amount(found.nominal),
            amount(found.ordinary_nominal)
        ),
    );
    let answer = &found.answer;
    let tables =
        [Some(found_weights_table(answer)), found_shafts_table(answer), found_inertias_table(answer)];
    for table in tables.into_iter().flatten().chain([effects_table(engine, answer)]) {
        out.push('\n');
        out.push_str(&table.text());
    }
    out
}
