//! The published numbers: every verdict is the expected one, and a verdict that should fail does.

use lanchester_validation::{Validation, Verdict, csv, markdown, text, validate};
use std::path::Path;

/// Fails with the rows that are not as expected.
fn assert_passed(validation: &Validation) {
    assert!(validation.passed(), "{}", text(validation, false));
}

#[test]
fn lit_louvigny_2008_twin_cylinder_thesis() {
    assert_passed(&validate(Some("twin-cylinder-thesis")));
}

#[test]
fn lit_singh_2017_three_four_cylinder_thesis() {
    assert_passed(&validate(Some("three-four-cylinder-thesis")));
}

#[test]
fn lit_louvigny_2009_flexible_paper() {
    assert_passed(&validate(Some("flexible-paper")));
}

#[test]
fn lit_applied_sciences_2021_8997_tool_paper() {
    assert_passed(&validate(Some("balancing-tool-paper")));
}

#[test]
fn published_examples_of_the_workshop() {
    for source in ["two-plane-example", "balance-grade-example", "bobweight-example"] {
        let validation = validate(Some(source));
        assert_passed(&validation);
        assert_eq!(validation.counts.with(Verdict::Match), validation.counts.rows, "{source}");
    }
}

#[test]
fn filters_keep_whole_table_numbers() {
    let tables = |filter| -> Vec<String> {
        validate(Some(filter)).sources.into_iter().flat_map(|s| s.tables).map(|t| t.table).collect()
    };
    assert_eq!(tables("table 4"), ["Table 4"]);
    assert_eq!(tables("three-four-cylinder-thesis table 4."), ["Table 4.2", "Table 4.3", "Table 4.4"]);
    assert_eq!(tables("TABLE 36"), ["Table 36"]);
    assert!(tables("table 99").is_empty());
}

#[test]
fn nothing_computed_has_not_passed() {
    let nothing = validate(Some("no such source"));
    assert!(!nothing.passed());
    assert!(text(&nothing, false).contains("nothing was computed"));
}

#[test]
fn csv_has_a_line_for_every_row() {
    let validation = validate(Some("Table 50"));
    let csv = csv(&validation);
    assert_eq!(csv.lines().count(), 1 + validation.counts.rows);
    assert!(csv.contains("\"29,2\""), "a decimal comma must be quoted");
}

#[test]
fn the_page_of_the_book_is_fresh() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src/validation.md");
    let committed = std::fs::read_to_string(page).unwrap();
    assert!(
        committed == markdown(&validate(None)),
        "docs/src/validation.md is stale: write it with `lanchester validate --markdown`"
    );
}
