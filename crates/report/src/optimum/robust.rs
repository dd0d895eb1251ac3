//! The answer for a production of engines, as plain text.

use crate::kit::number::short;
use crate::kit::paragraph::push_wrapped;
use crate::kit::table::Table;
use crate::optimum::tables::{effects_table, found_inertias_table, found_shafts_table, found_weights_table};
use lanchester_balance::{RobustAnswer, RobustMeasure};
use lanchester_model::Engine;
use lanchester_task::{criterion_name, criterion_unit};

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
            amount(found.least),
            amount(found.lower_bound),
            amount(found.standard_error)
        ),
    );
    if found.value > found.least * (1.0 + 2e-6) {
        let words = format!("With what it gives up for later stages it is {}.", amount(found.value));
        push_wrapped(&mut out, "", &words);
    }
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
    for stage in &found.later {
        let names: Vec<String> = stage.criteria.iter().map(|one| criterion_name(one, engine)).collect();
        let unit = if let [one] = &stage.criteria[..] { criterion_unit(one) } else { "" };
        let words = format!(
            "Then {} of the engine as it is meant: {} {unit}; nothing that keeps what comes before goes below {} {unit}.",
            names.join(" and "),
            short(stage.value, 6),
            short(stage.lower_bound, 6)
        );
        push_wrapped(&mut out, "", &words);
    }
    for limit in &found.limits {
        let (name, unit) = (criterion_name(&limit.criterion, engine), criterion_unit(&limit.criterion));
        let samples = match (limit.worst, limit.beyond) {
            (Some(worst), Some(beyond)) => format!(
                "; {beyond} of the {} engines pass it, the worst has {} {unit}",
                found.samples,
                short(worst, 6)
            ),
            _ => String::new(),
        };
        let words = format!(
            "The limit of {name}, {} {unit}, holds for the engine as it is meant, which has {} {unit}{samples}.",
            short(limit.most, 6),
            short(limit.nominal, 6)
        );
        push_wrapped(&mut out, "", &words);
    }
    for table in robust_tables(engine, found) {
        out.push('\n');
        out.push_str(&table.text());
    }
    out
}

/// Weights, shafts and inertias that were found, and what they do to the engine as it is meant.
pub fn robust_tables(engine: &Engine, found: &RobustAnswer) -> Vec<Table> {
    let answer = &found.answer;
    let found = [Some(found_weights_table(answer)), found_shafts_table(answer), found_inertias_table(answer)];
    found.into_iter().flatten().chain([effects_table(engine, answer)]).collect()
}
