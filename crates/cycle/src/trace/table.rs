//! CSV to numbers in SI, with the line of each.

use super::fault::TraceFault;
use csv::{ReaderBuilder, StringRecord, Trim};
use lanchester_units::option;

/// Angles and pressures as the file has them, in SI.
#[derive(Debug)]
pub(super) struct Table {
    /// Angles [rad].
    pub(super) angles: Vec<f64>,
    /// Line of each angle, from 1.
    pub(super) lines: Vec<u64>,
    /// Heading and values [Pa] of each column of pressure, or [N m] of torque.
    pub(super) columns: Vec<(String, Vec<f64>)>,
}

/// What the columns beside that of the angle hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Holds {
    Pressure,
    Torque,
}

enum Column {
    /// Factor to rad.
    Angle(f64),
    /// Factor to Pa or N m.
    Value(f64),
}

type Placed<T> = Result<T, (Option<u64>, TraceFault)>;

pub(super) fn read(text: &str, holds: Holds) -> Placed<Table> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let delimiter = delimiter(text);
    let mut reader = ReaderBuilder::new()
        .delimiter(delimiter)
        .comment(Some(b'#'))
        .trim(Trim::All)
        .flexible(true)
        .from_reader(text.as_bytes());
    let unreadable = |error: csv::Error| {
        let line = error.position().map(csv::Position::line);
        (line, TraceFault::Csv { message: error.to_string() })
    };
    let header = reader.headers().map_err(unreadable)?.clone();
    let header_line = header.position().map(csv::Position::line);
    let columns: Vec<(String, Column)> = header
        .iter()
        .map(|heading| {
            let kind = column(heading, holds).ok_or_else(|| {
                let column = heading.to_string();
                let fault = match holds {
                    Holds::Pressure => TraceFault::Heading { column },
                    Holds::Torque => TraceFault::TorqueHeading { column },
                };
                (header_line, fault)
            })?;
            Ok((heading.to_string(), kind))
        })
        .collect::<Placed<_>>()?;
    let count = columns.iter().filter(|(_, kind)| matches!(kind, Column::Angle(_))).count();
    if count != 1 {
        return Err((header_line, TraceFault::Angles { got: count }));
    }
    match holds {
        Holds::Pressure if columns.len() == 1 => return Err((header_line, TraceFault::NoPressure)),
        Holds::Torque if columns.len() != 2 => {
            return Err((header_line, TraceFault::Torques { got: columns.len() - 1 }));
        }
        _ => {}
    }
    let mut values: Vec<Vec<f64>> = columns.iter().map(|_| Vec::new()).collect();
    let mut lines = Vec::new();
    for record in reader.records() {
        let record: StringRecord = record.map_err(unreadable)?;
        let line = record.position().map(csv::Position::line);
        if record.len() != columns.len() {
            let (got, needed) = (record.len(), columns.len());
            return Err((line, TraceFault::RowLength { got, needed, has_commas: delimiter == b',' }));
        }
        for ((text, (heading, kind)), values) in record.iter().zip(&columns).zip(&mut values) {
            let (Column::Angle(factor) | Column::Value(factor)) = kind;
            values.push(number(text, heading).map_err(|fault| (line, fault))? * factor);
        }
        lines.push(line.unwrap_or(0));
    }
    let mut angles = Vec::new();
    let mut others = Vec::new();
    for ((heading, kind), values) in columns.into_iter().zip(values) {
        match kind {
            Column::Angle(_) => angles = values,
            Column::Value(_) => others.push((heading, values)),
        }
    }
    Ok(Table { angles, lines, columns: others })
}

/// What parts the columns: a semicolon or a tab where the first line that is no comment has one.
fn delimiter(text: &str) -> u8 {
    let header = text.lines().find(|line| !line.trim().is_empty() && !line.starts_with('#')).unwrap_or("");
    [b';', b'\t'].into_iter().find(|mark| header.as_bytes().contains(mark)).unwrap_or(b',')
}

/// Unit of a heading such as `p1 [bar]` or `theta (deg)`.
fn column(heading: &str, holds: Holds) -> Option<Column> {
    let open = heading.rfind(['[', '('])?;
    let unit = heading[open + 1..].trim_end_matches([']', ')', ' ']).trim();
    let text = format!("1 {}", if unit == "°" { "deg" } else { unit });
    let value = || match holds {
        Holds::Pressure => option::pressure(&text, heading),
        Holds::Torque => option::torque(&text, heading),
    };
    option::angle(&text, heading).map(Column::Angle).or_else(|_| value().map(Column::Value)).ok()
}

fn number(text: &str, heading: &str) -> Result<f64, TraceFault> {
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ if text.matches(',').count() == 1 && text.replace(',', ".").parse::<f64>().is_ok() => {
            Err(TraceFault::DecimalComma { text: text.to_string(), column: heading.to_string() })
        }
        _ => Err(TraceFault::Number { text: text.chars().take(40).collect(), column: heading.to_string() }),
    }
}
