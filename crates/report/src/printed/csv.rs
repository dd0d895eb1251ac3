//! Tables of CSV: heads say the unit in brackets.

use super::layout::converted_cells;
use crate::kit::table::{csv_number, push_csv_line};

/// CSV of a report in units of the United States, unrounded: columns whose heads say a unit in brackets, rows whose unit
/// stands in a column `unit` or at the end of their name.
pub fn csv_in_us_units(csv: &str) -> String {
    let lines = parsed(csv);
    let Some((head, rows)) = lines.split_first() else { return String::new() };
    let heads = vec![head.iter().map(String::as_str).collect::<Vec<_>>()];
    // A line of another length is no row of this table: it stays.
    let whole = |row: &&Vec<String>| row.len() == head.len();
    let cells: Vec<Vec<&str>> =
        rows.iter().filter(whole).map(|row| row.iter().map(String::as_str).collect()).collect();
    let (heads, converted) = converted_cells(&heads, &cells, &|value, _| csv_number(value));
    let mut converted = converted.into_iter();
    let mut out = String::with_capacity(csv.len());
    heads.into_iter().for_each(|line| push_csv_line(&mut out, line));
    for row in rows {
        let line = if row.len() == head.len() { converted.next() } else { None };
        push_csv_line(&mut out, line.unwrap_or_else(|| row.clone()));
    }
    out
}

/// Fields of each line (RFC 4180); a guarding apostrophe is taken off and comes back where it is written.
fn parsed(csv: &str) -> Vec<Vec<String>> {
    let mut lines = Vec::new();
    let (mut line, mut field, mut quoted) = (Vec::new(), String::new(), false);
    let mut letters = csv.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            '"' if quoted && letters.peek() == Some(&'"') => {
                field.push('"');
                letters.next();
            }
            '"' => quoted = !quoted,
            ',' if !quoted => line.push(std::mem::take(&mut field)),
            '\r' if !quoted && letters.peek() == Some(&'\n') => {}
            '\n' if !quoted => {
                line.push(std::mem::take(&mut field));
                lines.push(std::mem::take(&mut line));
            }
            other => field.push(other),
        }
    }
    if !field.is_empty() || !line.is_empty() {
        line.push(field);
        lines.push(line);
    }
    let guarded = |field: &String| {
        field.starts_with("'=")
            || field.starts_with("'+")
            || field.starts_with("'-")
            || field.starts_with("'@")
    };
    lines
        .into_iter()
        .map(|line| line.into_iter().map(|f| if guarded(&f) { f[1..].to_owned() } else { f }).collect())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::csv_in_us_units;

    #[test]
    fn heads_and_numbers_change_together() {
        let si = "quantity,\"load, all [N]\",at [deg],note\r\nfront,4.4482216152605,-30,\"5 N, \"\"most\"\"\"\r\nrear,,1e-3,\r\n";
        let us = "quantity,\"load, all [lbf]\",at [deg],note\r\nfront,1,-30,\"1.12 lbf, \"\"most\"\"\"\r\nrear,,1e-3,\r\n";
        assert_eq!(csv_in_us_units(si), us);
        let rows = "quantity,unit,value\r\nforce,N,8.896443230521\r\nshare,%,12\r\n";
        assert_eq!(csv_in_us_units(rows), "quantity,unit,value\r\nforce,lbf,2\r\nshare,%,12\r\n");
        assert_eq!(csv_in_us_units("name,Force F_x [N]\r\n"), "name,Force F_x [lbf]\r\n");
        assert_eq!(
            csv_in_us_units("quantity,largest\r\nCouple [N m],1.3558179483314004\r\n"),
            "quantity,largest\r\nCouple [lbf ft],1\r\n"
        );
    }
}
