//! The validation as text for a terminal, as CSV and as the book's page.

use super::{Counts, RowResult, SourceResult, TableResult, Validation, Verdict};
use lanchester_report::csv_text;
use std::fmt::Write;

/// Text for a terminal: a line a table, then every row that is no plain match; all rows with `verbose`.
pub fn text(validation: &Validation, verbose: bool) -> String {
    let mut out = String::new();
    for source in &validation.sources {
        let _ = writeln!(out, "{}: {}", source.title, source.citation);
        let width = source.tables.iter().map(|t| t.table.chars().count()).max().unwrap_or(0);
        for table in &source.tables {
            let _ = writeln!(out, "  {:width$}  {}", table.table, words(&Counts::of(&table.rows)));
            for row in table.rows.iter().filter(|_| verbose) {
                let _ = writeln!(out, "      {}", line(row));
            }
        }
        let rows = explained(source);
        for (at, (table, row)) in rows.iter().enumerate() {
            let _ = writeln!(out, "{}  {}, {}", if at == 0 { "\n" } else { "" }, table.table, line(row));
            if let Some(wrong) = unexpected(row) {
                let _ = writeln!(out, "      {wrong}");
            }
            // Neighbours with one reason share it.
            if rows.get(at + 1).is_none_or(|(_, next)| next.reason != row.reason)
                && let Some(reason) = &row.reason
            {
                let _ = writeln!(out, "      {reason}");
            }
        }
        if !source.deferred.is_empty() {
            let _ = writeln!(out, "\n  not computed yet");
        }
        for deferred in &source.deferred {
            let _ = writeln!(out, "      {}: {}", deferred.what, deferred.reason);
        }
        out.push('\n');
    }
    let counts = validation.counts();
    let conclusion = match (counts.rows, counts.unexpected) {
        (0, _) => "nothing was computed".to_string(),
        (_, 0) => "every verdict is the expected one".to_string(),
        (_, 1) => "1 verdict is not the expected one".to_string(),
        (_, n) => format!("{n} verdicts are not the expected ones"),
    };
    let _ = writeln!(out, "{}; {conclusion}", words(&counts));
    out
}

/// One line a row, RFC 4180.
pub fn csv(validation: &Validation) -> String {
    let mut out = String::from(
        "source,table,section,column,quantity,unit,printed,ours,verdict,expected,ok,correct,reason,how\r\n",
    );
    for source in &validation.sources {
        for table in &source.tables {
            for row in &table.rows {
                let optional = |field: &Option<String>| field.clone().unwrap_or_default();
                let fields = [
                    source.key.clone(),
                    table.table.clone(),
                    optional(&row.section),
                    optional(&row.column),
                    row.quantity.clone(),
                    row.unit.clone(),
                    row.printed.clone(),
                    row.value.map_or_else(|| row.ours.clone(), |v| v.to_string()),
                    row.verdict.to_string(),
                    row.expected.to_string(),
                    row.ok.to_string(),
                    optional(&row.correct),
                    optional(&row.reason),
                    row.how.clone(),
                ];
                let _ = write!(out, "{}\r\n", fields.map(|f| csv_text(&f)).join(","));
            }
        }
    }
    out
}

/// The page of the book.
pub fn markdown(validation: &Validation) -> String {
    let mut out = String::from(
        "# Validation\n\n\
         <!-- written by `lanchester validate --format markdown`; a test holds it against the program -->\n\n\
         Every published number that this version can compute, printed against computed. `lanchester validate` prints\n\
         this page's tables, `lanchester validate --verbose` every number.\n\n\
         * **match**: ours lies within half a unit of the last printed digit.\n\
         * **match with rounded input**, **match with unprinted input**: it does so with an input that the source\n  \
         rounded, or needs but does not print; the reason names it.\n\
         * **match with synthetic input**: the source does not print its input; one was made that gives this number, among\n  \
         others, so that the row shows that they are consistent, and no more.\n\
         * **close**: within 0.5 %. **differs**: further away.\n\n\
         A row that is no plain match says why, and gives the correct value, which ours must equal to its digits.\n\n",
    );
    let _ = writeln!(out, "In all: {}.", words(&validation.counts()));
    for source in &validation.sources {
        let _ = writeln!(out, "\n## {}\n\n{}\n", source.title, cell(&source.citation));
        out.push_str("| table | what | verdicts |\n|---|---|---|\n");
        for table in &source.tables {
            let verdicts = words(&Counts::of(&table.rows));
            let _ = writeln!(out, "| {} | {} | {verdicts} |", cell(&table.table), cell(&table.title));
        }
        let rows = explained(source);
        if !rows.is_empty() {
            out.push_str(
                "\n| where | quantity | printed | ours | verdict | reason |\n|---|---|---|---|---|---|\n",
            );
        }
        for (table, row) in rows {
            let reason = row.reason.clone().into_iter().chain(unexpected(row)).collect::<Vec<_>>().join("; ");
            let _ = writeln!(
                out,
                "| {} | {} | {} | {} | {} | {} |",
                cell(&place(table, row)),
                cell(&row.quantity),
                cell(&with_unit(&row.printed, row)),
                cell(&with_unit(&row.ours, row)),
                row.verdict,
                cell(&reason)
            );
        }
        if !source.deferred.is_empty() {
            out.push_str("\nNot computed yet:\n\n");
        }
        for deferred in &source.deferred {
            let _ = writeln!(out, "* {}: {}.", deferred.what, deferred.reason);
        }
    }
    out
}

fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}

fn place(table: &TableResult, row: &RowResult) -> String {
    match (&row.section, &row.column) {
        (Some(section), _) => format!("{} {section}", table.table),
        (_, Some(column)) => format!("{}, column {column}", table.table),
        _ => table.table.clone(),
    }
}

fn with_unit(number: &str, row: &RowResult) -> String {
    if row.unit.is_empty() { number.to_string() } else { format!("{number} {}", row.unit) }
}

/// "section 4.1, quantity, column 2: printed 9,5 N, ours 9.4999 N: match".
fn line(row: &RowResult) -> String {
    let mut line = row.section.as_ref().map_or_else(String::new, |s| format!("{s}: "));
    line += &row.quantity;
    if let Some(column) = &row.column {
        let _ = write!(line, ", column {column}");
    }
    let _ = write!(
        line,
        ": printed {}, ours {}: {}",
        with_unit(&row.printed, row),
        with_unit(&row.ours, row),
        row.verdict
    );
    line
}

/// What is wrong with a row that is not as expected.
fn unexpected(row: &RowResult) -> Option<String> {
    let correct = row.correct.as_ref().map_or_else(String::new, |c| format!(", ours {c}"));
    (!row.ok).then(|| format!("NOT AS EXPECTED: {}{correct}", row.expected))
}

/// Rows that are no plain, expected match.
fn explained(source: &SourceResult) -> Vec<(&TableResult, &RowResult)> {
    let rows = source.tables.iter().flat_map(|t| t.rows.iter().map(move |r| (t, r)));
    rows.filter(|(_, r)| !r.ok || r.verdict != Verdict::Match).collect()
}

fn words(counts: &Counts) -> String {
    let named = [
        (counts.matches, "match"),
        (counts.rounded, "match with rounded input"),
        (counts.unprinted, "match with unprinted input"),
        (counts.synthetic, "match with synthetic input"),
        (counts.close, "close"),
        (counts.differs, if counts.differs == 1 { "differs" } else { "differ" }),
        (counts.unexpected, "NOT AS EXPECTED"),
    ];
    let parts: Vec<String> =
        named.iter().filter(|(n, _)| *n > 0).map(|(n, name)| format!("{n} {name}")).collect();
    let numbers = if counts.rows == 1 { "number" } else { "numbers" };
    format!("{} {numbers}: {}", counts.rows, parts.join(", "))
}
