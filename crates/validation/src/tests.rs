//! The published numbers: every verdict is the expected one, and a verdict that should fail does: every number is
//! moved by one unit of its last digit.

use super::files::sources;
use super::source::PrintedCells;
use crate::*;
use std::path::Path;
use std::sync::{Mutex, MutexGuard, OnceLock};

/// What is computed once for all tests. Its lock is taken for one use at a time.
fn bench() -> MutexGuard<'static, Bench> {
    static BENCH: OnceLock<Mutex<Bench>> = OnceLock::new();
    // A failed test leaves whole runs behind.
    BENCH.get_or_init(Mutex::default).lock().unwrap_or_else(|poisoned| poisoned.into_inner())
}

/// The printed text moved by so many units of its last digit.
fn moved(text: &str, units: f64) -> String {
    match (text, Printed::read(text)) {
        ("Yes", _) => "No".to_string(),
        ("No", _) => "Yes".to_string(),
        (_, Printed::Number { value, last_place, decimals }) => {
            format!("{:.decimals$}", value + units * last_place)
        }
        (_, Printed::Word(word)) => panic!("{word} is not a number"),
    }
}

/// Rows after a change of every printed cell: it changes no engine.
fn changed(mut change: impl FnMut(&mut Cell)) -> Vec<RowResult> {
    let mut bench = bench();
    let mut rows = Vec::new();
    for mut source in sources() {
        for row in source.tables.iter_mut().flat_map(|t| &mut t.rows) {
            match &mut row.printed {
                PrintedCells::One(cell) => change(cell),
                PrintedCells::Columns(cells) => cells.iter_mut().for_each(&mut change),
            }
        }
        rows.extend(source.tables.iter().flat_map(|t| validate_table(&mut bench, &source, t).rows));
    }
    rows
}

/// As [`validate`] finds them.
fn of(filter: Option<&str>) -> Validation {
    validate_on(&mut bench(), filter)
}

/// All numbers, computed once for all tests.
fn whole() -> &'static Validation {
    static WHOLE: OnceLock<Validation> = OnceLock::new();
    WHOLE.get_or_init(|| of(None))
}

/// Fails with the rows that are not as expected.
fn assert_passed(validation: &Validation) {
    assert!(validation.passed(), "{}", text(validation, false));
}

#[test]
fn lit_louvigny_2008_twin_cylinder_thesis() {
    assert_passed(&of(Some("twin-cylinder-thesis")));
}

#[test]
fn lit_singh_2017_three_four_cylinder_thesis() {
    assert_passed(&of(Some("three-four-cylinder-thesis")));
}

#[test]
fn lit_louvigny_2009_flexible_paper() {
    assert_passed(&of(Some("flexible-paper")));
}

#[test]
fn lit_applied_sciences_2021_8997_tool_paper() {
    assert_passed(&of(Some("balancing-tool-paper")));
}

#[test]
fn published_examples_of_the_workshop() {
    for source in ["two-plane-example", "balance-grade-example", "bobweight-example"] {
        let validation = of(Some(source));
        assert_passed(&validation);
        assert_eq!(validation.counts.with(Verdict::Match), validation.counts.rows, "{source}");
    }
}

#[test]
fn filters_keep_whole_table_numbers() {
    let tables = |filter| -> Vec<String> {
        of(Some(filter)).sources.into_iter().flat_map(|s| s.tables).map(|t| t.table).collect()
    };
    assert_eq!(tables("table 4"), ["Table 4"]);
    assert_eq!(tables("three-four-cylinder-thesis table 4."), ["Table 4.2", "Table 4.3", "Table 4.4"]);
    assert_eq!(tables("TABLE 36"), ["Table 36"]);
    assert!(tables("table 99").is_empty());
}

#[test]
fn nothing_computed_has_not_passed() {
    let nothing = of(Some("no such source"));
    assert!(!nothing.passed());
    assert!(text(&nothing, false).contains("nothing was computed"));
}

#[test]
fn csv_has_a_line_for_every_row() {
    let validation = of(Some("Table 50"));
    let csv = csv(&validation);
    assert_eq!(csv.lines().count(), 1 + validation.counts.rows);
    assert!(csv.contains("\"29,2\""), "a decimal comma must be quoted");
}

#[test]
fn the_page_of_the_book_is_fresh() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src/validation.md");
    let committed = std::fs::read_to_string(page).unwrap();
    assert!(
        committed == markdown(whole()),
        "docs/src/validation.md is stale: write it with `lanchester validate --markdown`"
    );
}

#[test]
fn the_suite_has_every_number() {
    let validation = whole();
    let suite = suite::suite_on(&mut bench(), None);
    assert_eq!(suite.sources.len(), validation.sources.len());
    assert_eq!(suite.rows.len(), validation.counts.rows);
    let rows = validation.sources.iter().flat_map(|s| &s.tables).flat_map(|t| &t.rows);
    for (row, own) in rows.zip(&suite.rows) {
        assert_eq!((&row.printed, row.verdict), (&own.printed.text, own.verdict), "{}", own.id);
        assert_eq!(row.value, own.ours, "{}", own.id);
        assert!(own.engine.iter().all(|name| suite.engines.contains_key(name)), "{}", own.id);
        assert!(own.sheet.iter().all(|name| suite.sheets.contains_key(name)), "{}", own.id);
    }
}

#[test]
fn every_row_is_as_expected_unless_it_is_changed() {
    assert!(changed(|_| {}).iter().all(|r| r.ok));
}

#[test]
fn a_printed_number_one_unit_off_fails() {
    for units in [-1.0, 1.0] {
        let rows = changed(|cell| cell.set_text(moved(cell.text(), units)));
        // A number that the source prints wrongly stays wrong, one within a range stays within: there the correct one is
        // held instead.
        let stays = |row: &RowResult| {
            let is_apart = matches!(row.expected, Verdict::WithinRounding | Verdict::InputItself);
            row.expected.is_stated() || is_apart && row.correct.is_some()
        };
        for row in rows.iter().filter(|row| !stays(row)) {
            assert!(!row.ok, "{} printed {} ours {}", row.quantity, row.printed, row.ours);
        }
    }
}

#[test]
fn a_correct_number_one_unit_off_fails() {
    for units in [-1.0, 1.0] {
        let rows = changed(|cell| {
            let text = cell.correct().map(|c| moved(c, units));
            cell.set_correct(text);
        });
        for row in rows.iter().filter(|r| r.correct.is_some()) {
            assert!(!row.ok, "{} correct {:?} ours {}", row.quantity, row.correct, row.ours);
        }
    }
}

#[test]
fn ours_one_unit_off_fails() {
    let validation = whole();
    let rows = validation.sources.iter().flat_map(|s| &s.tables).flat_map(|t| &t.rows);
    for (row, value) in rows.filter_map(|r| Some((r, r.value?))) {
        if row.verdict == Verdict::Residual {
            continue;
        }
        let held = Printed::read(row.correct.as_ref().unwrap_or(&row.printed));
        let Printed::Number { last_place, .. } = held else { panic!("{} is a number", row.quantity) };
        assert!(held.agrees(&Value::Number(value)));
        for off in [-last_place, last_place] {
            assert!(!held.agrees(&Value::Number(value + off)), "{} {value}", row.quantity);
        }
    }
}

#[test]
fn another_expected_verdict_fails() {
    let others = [Verdict::Match, Verdict::WithinRounding, Verdict::RoundedIntermediate, Verdict::Residual];
    for other in others {
        let rows = changed(|cell| {
            let expected = if cell.expected() == other { Verdict::ExplainedAfterwards } else { other };
            cell.set_expected(expected);
        });
        assert!(rows.iter().all(|r| !r.ok));
    }
}

#[test]
fn one_row_that_is_not_as_expected_fails_the_whole() {
    let mut validation = of(Some("Table 36"));
    assert!(validation.passed());
    validation.sources[0].tables[0].rows[3].ok = false;
    validation.counts = Counts::of(&validation.sources[0].tables[0].rows);
    assert!(!validation.passed());
    assert!(text(&validation, false).contains("NOT AS EXPECTED"));
    assert!(text(&validation, false).contains("1 verdict is not the expected one"));
}

#[test]
fn what_cannot_be_computed_is_said_and_fails() {
    let mut sources = sources();
    let source = &mut sources[0];
    source.tables[0].rows[0].key = "lunar phase".to_string();
    let row = &validate_table(&mut bench(), source, &source.tables[0]).rows[0];
    assert_eq!((row.verdict, row.ok), (Verdict::NotComputed, false));
    assert!(row.ours.contains("lunar phase"));
}

fn rows(validation: &Validation) -> impl Iterator<Item = &RowResult> {
    validation.sources.iter().flat_map(|s| &s.tables).flat_map(|t| &t.rows)
}

#[test]
fn every_tolerance_is_that_of_the_printed_digits_and_is_shown() {
    let validation = whole();
    let shown = text(validation, true);
    for row in rows(validation) {
        let digits = row.printed.replace(',', ".");
        let Ok(number) = digits.parse::<f64>() else {
            assert!(row.tolerance.is_none() || row.printed == "Zero", "{}", row.printed);
            continue;
        };
        let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        let tolerance = 0.5 * 10f64.powi(-(decimals as i32));
        assert_eq!(row.tolerance, Some(tolerance), "{}", row.printed);
        let words = format!(
            "printed {}{}{} ± {tolerance:.*}, ours",
            row.printed,
            if row.unit.is_empty() { "" } else { " " },
            row.unit,
            decimals + 1
        );
        assert!(shown.contains(&words), "{words}");
        if row.verdict == Verdict::Match {
            let off = (row.value.unwrap() - number).abs();
            assert!(off <= tolerance * (1.0 + 1e-8), "{}: {off} against {tolerance}", row.quantity);
        }
    }
}

#[test]
fn an_input_compared_with_itself_is_no_match() {
    let mut sources = sources();
    let source = sources.iter_mut().find(|source| source.key == "balancing-tool-paper").unwrap();
    source.tables[0].rows[0].key = "rod length".to_string();
    source.tables[0].rows[0].divided_by = [("millimetre [m]".to_string(), 0.001)].into();
    let mut cell = Cell::Plain("135".to_string());
    cell.set_expected(Verdict::Match);
    source.tables[0].rows[0].printed = PrintedCells::One(cell);
    let row = &validate_table(&mut bench(), source, &source.tables[0]).rows[0];
    assert_eq!((row.verdict, row.ok), (Verdict::InputItself, false), "{}", row.ours);
}

#[test]
fn rows_of_synthetic_pressures_are_residuals_and_no_correct_value_is_claimed() {
    let validation = whole();
    let residuals: Vec<&RowResult> = rows(validation).filter(|r| r.verdict == Verdict::Residual).collect();
    assert!(residuals.len() > 80, "{}", residuals.len());
    assert!(residuals.iter().all(|row| row.correct.is_none() && row.residual.is_some()));
}

#[test]
fn a_rounded_intermediate_is_printed_by_its_source() {
    for source in sources() {
        let cells: Vec<&Cell> =
            source.tables.iter().flat_map(|t| &t.rows).flat_map(|r| r.printed.cells()).collect();
        let printed: Vec<String> = cells.iter().map(|cell| cell.text().replace(',', ".")).collect();
        for edit in cells.iter().flat_map(|cell| cell.rounded()) {
            let values: Vec<String> = match edit {
                // The name of the change holds the value: "oscillating mass 0.985 kg".
                Edit::Named(name) => vec![name.clone()],
                Edit::Written(change) => change
                    .values()
                    .map(|value| match value {
                        source::NewValue::Text(text) => text.clone(),
                        _ => panic!("a value"),
                    })
                    .collect(),
            };
            for value in values {
                let number = value.split(' ').find(|word| word.parse::<f64>().is_ok()).unwrap();
                assert!(printed.iter().any(|text| text == number), "{} prints {number} nowhere", source.key);
            }
        }
    }
}
