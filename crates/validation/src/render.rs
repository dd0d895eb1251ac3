//! The validation as text for a terminal, as CSV and as the book's page.

use crate::verdict::Printed;
use crate::{Counts, RowResult, SourceResult, TableResult, Validation, Verdict};
use lanchester::report::csv_text;
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
            let _ = writeln!(out, "\n  not computed");
        }
        for deferred in &source.deferred {
            let _ = writeln!(out, "      {}: {}", deferred.what, deferred.reason);
        }
        out.push('\n');
    }
    let counts = &validation.counts;
    let conclusion = match (counts.rows, counts.unexpected) {
        (0, _) => "nothing was computed".to_string(),
        (_, 0) => "every verdict is the expected one".to_string(),
        (_, 1) => "1 verdict is not the expected one".to_string(),
        (_, n) => format!("{n} verdicts are not the expected ones"),
    };
    let _ = writeln!(out, "{}; {conclusion}", words(counts));
    out
}

/// One line a row, RFC 4180.
pub fn csv(validation: &Validation) -> String {
    let mut out = String::from(
        "source,table,section,column,quantity,unit,printed,tolerance,ours,low,high,residual,verdict,expected,ok,correct,\
         given_by,reason,how\r\n",
    );
    for source in &validation.sources {
        for table in &source.tables {
            for row in &table.rows {
                let number = |field: Option<f64>| field.map_or_else(String::new, |value| value.to_string());
                let optional = |field: &Option<String>| field.clone().unwrap_or_default();
                let fields = [
                    source.key.clone(),
                    table.table.clone(),
                    optional(&row.section),
                    optional(&row.column),
                    row.quantity.clone(),
                    row.unit.clone(),
                    row.printed.clone(),
                    number(row.tolerance),
                    row.value.map_or_else(|| row.ours.clone(), |v| v.to_string()),
                    number(row.range.map(|[low, _]| low)),
                    number(row.range.map(|[_, high]| high)),
                    number(row.residual),
                    row.verdict.to_string(),
                    row.expected.to_string(),
                    row.ok.to_string(),
                    optional(&row.correct),
                    optional(&row.given_by),
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
         <!-- written by `lanchester validate --markdown`; a test holds it against the program -->\n\n\
         Every published number that this version can compute, printed against computed. `lanchester validate` prints\n\
         this page's tables, `lanchester validate --verbose` every number.\n\n\
         The tolerance of a number is half a unit of its last printed digit; every row shows it. A *match* is ours within the\n\
         tolerance, from the printed inputs. Nothing that was found afterwards to explain a number counts as one.\n\n\
         A row that is no match says why (those that are inputs are only counted), and gives the correct value where it is known: ours must equal it to its digits.\n\n\
         The [atlas](atlas.md) has the sources' figures, drawn from our numbers. `lanchester validate --suite suite.json` writes all numbers with their inputs in\n\
         SI for other programs; `validation/README.md` describes the form.\n\n",
    );
    let counts = &validation.counts;
    let _ = writeln!(out, "{} numbers:\n\n| verdict | numbers | meaning |\n|---|---:|---|", counts.rows);
    for count in &counts.verdicts {
        let _ = writeln!(out, "| {} | {} | {} |", count.verdict, count.rows, count.verdict.meaning());
    }
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
                "\n| where | quantity | printed | tolerance | ours | verdict | reason |\n|---|---|---|---|---|---|---|\n",
            );
        }
        for (table, row) in rows {
            let reason = row.reason.clone().into_iter().chain(unexpected(row)).collect::<Vec<_>>().join("; ");
            let more = further(row).map_or_else(String::new, |more| format!("; {more}"));
            let _ = writeln!(
                out,
                "| {} | {} | {} | {} | {} | {} | {} |",
                cell(&place(table, row)),
                cell(&row.quantity),
                cell(&with_unit(&row.printed, row)),
                tolerance(row),
                cell(&format!("{}{more}", with_unit(&row.ours, row))),
                row.verdict,
                cell(&reason)
            );
        }
        if !source.deferred.is_empty() {
            out.push_str("\nNot computed:\n\n");
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

/// "section 4.1, quantity, column 2: printed 9,5 N ± 0.05, ours 9.499 N: match".
fn line(row: &RowResult) -> String {
    let mut line = row.section.as_ref().map_or_else(String::new, |s| format!("{s}: "));
    line += &row.quantity;
    if let Some(column) = &row.column {
        let _ = write!(line, ", column {column}");
    }
    let _ = write!(line, ": printed {}", with_unit(&row.printed, row));
    if row.tolerance.is_some() {
        let _ = write!(line, " {}", tolerance(row));
    }
    let _ = write!(line, ", ours {}", with_unit(&row.ours, row));
    if let Some(more) = further(row) {
        let _ = write!(line, ", {more}");
    }
    let _ = write!(line, ": {}", row.verdict);
    line
}

/// "± 0.05"; for a word that it must be the same.
fn tolerance(row: &RowResult) -> String {
    row.tolerance.map_or_else(
        || "same word".to_string(),
        |tolerance| format!("± {}", Printed::read(&row.printed).digits(tolerance, 1)),
    )
}

/// What belongs to ours: the residual of a fit, the range over the rounding of the inputs.
fn further(row: &RowResult) -> Option<String> {
    let printed = Printed::read(&row.printed);
    match (row.verdict, row.range, row.residual) {
        (Verdict::Residual, _, Some(residual)) => Some(format!("residual {}", printed.digits(residual, 2))),
        (_, Some([low, high]), _) => {
            let [low, high] = [low, high].map(|end| printed.digits(end, 0));
            Some(format!("{low} to {high} over the rounding of the inputs"))
        }
        _ => None,
    }
}

/// What is wrong with a row that is not as expected.
fn unexpected(row: &RowResult) -> Option<String> {
    let correct = row.correct.as_ref().map_or_else(String::new, |c| format!(", ours {c}"));
    (!row.ok).then(|| format!("NOT AS EXPECTED: {}{correct}", row.expected))
}

/// Rows that are not as expected, and those that are no match; inputs are counted alone.
fn explained(source: &SourceResult) -> Vec<(&TableResult, &RowResult)> {
    let rows = source.tables.iter().flat_map(|t| t.rows.iter().map(move |r| (t, r)));
    rows.filter(|(_, r)| !r.ok || !matches!(r.verdict, Verdict::Match | Verdict::InputItself)).collect()
}

fn words(counts: &Counts) -> String {
    let mut parts: Vec<String> =
        counts.verdicts.iter().map(|count| format!("{} {}", count.rows, count.verdict)).collect();
    if counts.unexpected > 0 {
        parts.push(format!("{} NOT AS EXPECTED", counts.unexpected));
    }
    let numbers = if counts.rows == 1 { "number" } else { "numbers" };
    format!("{} {numbers}: {}", counts.rows, parts.join(", "))
}
