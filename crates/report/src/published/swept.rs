//! A swept crank beside the true optimum, as plain text and as tables.

use crate::kit::number;
use crate::kit::table::{Cell, Column, Table};
use crate::loads::text::push_wrapped;
use crate::optimum::consequence_tables::consequences_table;
use crate::optimum::consequence_text::consequence_words;
use crate::published::crank_curve::{load_name, load_unit};
use lanchester_balance::Consequences;
use lanchester_literature::{CrankSweep, Swept, SweptCrank};
use std::fmt::Write;

/// What the sweep found, what its crank really does, and what the true optimum does, as aligned plain text; `consequences` of the crank
/// with the sweep's best step.
pub fn swept_text(swept: &Swept, consequences: &Consequences) -> String {
    let mut out = String::with_capacity(2048);
    let rpm = number::terminal(number::rpm(swept.speed), 0);
    let _ = writeln!(out, "{} at {rpm} rpm, where the loads of the range are largest", swept.engine);
    let _ = writeln!(
        out,
        "sweep of the crank for the smallest largest {}: every {} kg m, {} angles a revolution\n",
        load_name(swept.sweep.load),
        number::trimmed(swept.sweep.step, 3),
        swept.angles
    );
    push_wrapped(&mut out, "", &verdict(swept));
    push_wrapped(&mut out, "", &consequence_words(consequences));
    let _ = write!(out, "\n{}\n{}", swept_table(swept).text(), consequences_table(consequences).text());
    if !swept.one_amount {
        out.push('\n');
        let words = "The sweep has one amount for all throws; its throws do not stand in line or are not alike, and the \
                     true optimum is free to choose for each.";
        push_wrapped(&mut out, "", words);
    }
    out
}

/// How far the sweep stops short of the optimum, in a sentence.
fn verdict(swept: &Swept) -> String {
    let unit = load_unit(swept.sweep.load);
    let Some(optimum) = swept.optimal() else {
        return "The true optimum could not be proved.".to_owned();
    };
    let bound = swept.optimum.stages.first().map_or(0.0, |stage| stage.lower_bound);
    let above = swept.best.criterion - optimum.criterion;
    let share = 100.0 * above / optimum.criterion.max(f64::MIN_POSITIVE);
    let short = if above <= 1e-8 * optimum.criterion {
        "The best step of the sweep is the true optimum".to_owned()
    } else {
        format!(
            "The best step of the sweep is {} {unit} ({} %) above the true optimum",
            number::short(above, 3),
            number::short(share, 2)
        )
    };
    let found = number::short(optimum.criterion, 7);
    let gap = number::short((optimum.criterion - bound).max(0.0), 1);
    format!("{short}: {found} {unit}, which nothing goes below by more than {gap} {unit}.")
}

/// The basic crank, the sweep's best and the true optimum.
pub fn swept_table(swept: &Swept) -> Table {
    let unit = load_unit(swept.sweep.load);
    let rows: Vec<(&str, f64, Option<f64>, SweptCrank)> = [
        Some(("rotating masses only", swept.basic.unbalance, Some(swept.sweep.basic.criterion), swept.basic)),
        Some((
            "best step of the sweep",
            swept.best.unbalance,
            Some(swept.sweep.best().criterion),
            swept.best,
        )),
        swept.optimal().map(|best| ("true optimum", best.unbalance, None, best)),
    ]
    .into_iter()
    .flatten()
    .collect();
    let largest = rows.iter().map(|row| row.3.criterion).fold(0.0, f64::max);
    let decimals = number::decimals(largest, 7);
    let number = |value: f64, decimals| Cell::Number { value, decimals };
    Table::of_columns(
        "swept",
        "The crank, swept and proved",
        "The sweep sees its own angles alone; the peak is that over the continuous angle.",
        vec![
            (Column::words("crank"), rows.iter().map(|row| Cell::text(row.0)).collect()),
            (Column::numbers("throw 1", "kg m"), rows.iter().map(|row| number(row.1, 8)).collect()),
            (
                Column::numbers("on the grid", unit),
                rows.iter().map(|row| row.2.map_or(Cell::Empty, |value| number(value, decimals))).collect(),
            ),
            (
                Column::numbers("peak", unit),
                rows.iter().map(|row| number(row.3.criterion, decimals)).collect(),
            ),
        ],
    )
}

/// Every step of the sweep.
pub fn sweep_steps_table(sweep: &CrankSweep) -> Table {
    let unit = load_unit(sweep.load);
    let largest = sweep.steps.iter().map(|s| s.criterion).fold(0.0, f64::max);
    let decimals = number::decimals(largest, 9);
    let number = |value: f64, decimals| Cell::Number { value, decimals };
    Table::of_columns(
        "steps",
        "Steps of the sweep",
        "",
        vec![
            (
                Column::numbers("counterweight of throw 1", "kg m"),
                sweep.steps.iter().map(|s| number(s.unbalance, 8)).collect(),
            ),
            (
                Column::numbers(format!("largest {}", load_name(sweep.load)), unit),
                sweep.steps.iter().map(|s| number(s.criterion, decimals)).collect(),
            ),
        ],
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use lanchester_balance::consequences;
    use lanchester_file::{read, template};
    use lanchester_literature::{SweepOptions, swept, with_even_crank};
    use lanchester_mechanism::Kinematics;
    use lanchester_model::Engine;

    fn engine(name: &str) -> Engine {
        let text = template(name).expect("it is in the gallery").text;
        read(text).engine().expect("it is valid")
    }

    fn text(name: &str) -> String {
        let (engine, found) = (engine(name), found(name));
        let after = with_even_crank(&engine, found.best.unbalance);
        let effect = consequences(&engine, &after, |_, _| None).expect("it has loads");
        swept_text(&found, &effect)
    }

    fn found(name: &str) -> Swept {
        swept(&engine(name), None, Kinematics::Exact, &SweepOptions::default()).expect("it can be swept")
    }

    #[test]
    fn the_text_tells_how_far_the_sweep_stops_short() {
        let single = text("single");
        assert!(single.contains("above the true optimum") && single.contains("360 angles"), "{single}");
        assert!(!single.contains("free to choose"));
        assert!(text("in-line-3").contains("free to choose"));
    }

    #[test]
    fn the_table_has_the_three_cranks_and_the_steps_all_of_the_curve() {
        let found = found("twin-360");
        assert_eq!(swept_table(&found).rows.len(), 3);
        let steps = sweep_steps_table(&found.sweep).csv();
        assert_eq!(steps.lines().count(), found.sweep.steps.len() + 1);
    }
}
