//! A verdict that should fail does: every number is moved by one unit of its last digit.

use super::files::sources;
use super::source::PrintedCells;
use super::*;

/// The printed text moved by so many units of its last digit.
fn moved(text: &str, place: Option<f64>, units: f64) -> String {
    match (text, Printed::read(text, place)) {
        ("Yes", _) => "No".to_string(),
        ("No", _) => "Yes".to_string(),
        (_, Printed::Number { value, last_place, decimals }) => {
            format!("{:.decimals$}", value + units * last_place)
        }
        (_, Printed::Word(word)) => panic!("{word} is not a number"),
    }
}

fn changed(mut change: impl FnMut(&mut Cell)) -> Vec<RowResult> {
    let mut bench = Bench::default();
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

#[test]
fn every_row_is_as_expected_unless_it_is_changed() {
    assert!(changed(|_| {}).iter().all(|r| r.ok));
}

#[test]
fn a_printed_number_one_unit_off_fails() {
    for units in [-1.0, 1.0] {
        let rows = changed(|cell| cell.set_text(moved(cell.text(), cell.place(), units)));
        // A number that the source prints wrongly stays wrong: there the correct one is held instead.
        for row in rows.iter().filter(|r| !matches!(r.expected, Verdict::Close | Verdict::Differs)) {
            assert!(!row.ok, "{} printed {} ours {}", row.quantity, row.printed, row.ours);
        }
    }
}

#[test]
fn a_correct_number_one_unit_off_fails() {
    for units in [-1.0, 1.0] {
        let rows = changed(|cell| {
            let text = cell.correct().map(|c| moved(c, None, units));
            cell.set_correct(text);
        });
        for row in rows.iter().filter(|r| r.correct.is_some()) {
            assert!(!row.ok, "{} correct {:?} ours {}", row.quantity, row.correct, row.ours);
        }
    }
}

#[test]
fn ours_one_unit_off_fails() {
    let validation = validate(None);
    let rows = validation.sources.iter().flat_map(|s| &s.tables).flat_map(|t| &t.rows);
    for (row, value) in rows.filter_map(|r| Some((r, r.value?))) {
        // The one number whose last digits do not count, "approximately 11000".
        let place = (row.printed == "11000").then_some(1000.0);
        let held = Printed::read(row.correct.as_ref().unwrap_or(&row.printed), place);
        let Printed::Number { last_place, .. } = held else { panic!("{} is a number", row.quantity) };
        assert!(held.agrees(&Value::Number(value)));
        for off in [-last_place, last_place] {
            assert!(!held.agrees(&Value::Number(value + off)), "{} {value}", row.quantity);
        }
    }
}

#[test]
fn another_expected_verdict_fails() {
    let others = [Verdict::Match, Verdict::MatchWithRoundedInput, Verdict::Close, Verdict::Differs];
    for other in others {
        let rows = changed(|cell| {
            let expected = if cell.expected() == other { Verdict::MatchWithUnprintedInput } else { other };
            cell.set_expected(expected);
        });
        assert!(rows.iter().all(|r| !r.ok));
    }
}

#[test]
fn one_row_that_is_not_as_expected_fails_the_whole() {
    let mut validation = validate(Some("Table 36"));
    assert!(validation.passed());
    validation.sources[0].tables[0].rows[3].ok = false;
    assert!(!validation.passed());
    assert!(text(&validation, false).contains("NOT AS EXPECTED"));
    assert!(text(&validation, false).contains("1 verdict is not the expected one"));
}

#[test]
fn what_cannot_be_computed_is_said_and_fails() {
    let mut bench = Bench::default();
    let mut sources = sources();
    let source = &mut sources[0];
    source.tables[0].rows[0].key = "lunar phase".to_string();
    let row = &validate_table(&mut bench, source, &source.tables[0]).rows[0];
    assert_eq!((row.verdict, row.ok), (Verdict::NotComputed, false));
    assert!(row.ours.contains("lunar phase"));
}
