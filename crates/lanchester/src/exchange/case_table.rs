//! A table of cases: a row an engine, a column a key of the engine file; and the loads of all of them.

use lanchester_file::{Edit, Severity, edit, key_tables, read, si_value};
use lanchester_mechanism::{LoadRequest, Loads, loads};
use lanchester_report::{Cell, Column, Table};
use rayon::prelude::*;
use serde_json::Value;

/// The key whose cells are words, digits too.
const NAME: &str = "name";

/// A cell of a table of cases.
#[derive(Debug, Clone, PartialEq)]
pub enum CaseCell {
    /// The key stays as the engine file has it.
    Empty,
    /// A text, such as a quantity with its unit.
    Text(String),
    /// A number: in the unit of its head, or SI.
    Number(f64),
    /// True or false.
    Flag(bool),
    /// What is no value, in words.
    Unusable(String),
}

/// A row of a table of cases.
#[derive(Debug, Clone, PartialEq)]
pub struct CaseRow {
    /// Its number as its user sees it, from 1.
    pub number: usize,
    /// Its cells.
    pub cells: Vec<CaseCell>,
}

/// A cell, row or head that cannot be used.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("row {row}{}: {message}", column.as_ref().map(|column| format!(", column {column}")).unwrap_or_default())]
pub struct CaseFault {
    /// Number of its row, from 1.
    pub row: usize,
    /// Letter and head of its column; `None` where the cells of the row do not fit together.
    pub column: Option<String>,
    /// What was needed and what was got.
    pub message: String,
}

/// The key of a column and the unit of its numbers.
#[derive(Debug, Clone, PartialEq)]
struct Head {
    text: String,
    key: String,
    unit: Option<String>,
}

/// A table of cases whose heads are keys.
#[derive(Debug, Clone, PartialEq)]
pub struct CaseTable {
    heads: Vec<Head>,
    rows: Vec<CaseRow>,
}

impl CaseTable {
    /// The table of these rows, of which the first holds the heads: `rod.length [mm]`, `cylinder[1].piston.mass`, `name`.
    ///
    /// # Errors
    /// All heads that are none, and rows that are longer than their heads.
    pub fn of(rows: Vec<CaseRow>) -> Result<CaseTable, Vec<CaseFault>> {
        let mut rows = rows.into_iter();
        let none = |row, message: &str| vec![CaseFault { row, column: None, message: message.to_owned() }];
        let first = rows.next().ok_or_else(|| none(1, "the table is empty: its first row has the keys"))?;
        let mut faults = Vec::new();
        let mut heads: Vec<Head> = Vec::new();
        for (place, cell) in first.cells.iter().enumerate() {
            let mut fault = |message: String| {
                let column = Some(column_name(place, None));
                faults.push(CaseFault { row: first.number, column, message });
            };
            let CaseCell::Text(text) = cell else {
                let due = "a head is due: a key of the engine file such as rod.length [mm]";
                fault(match cell {
                    CaseCell::Unusable(words) => format!("{due}, got {words}"),
                    _ => due.to_owned(),
                });
                continue;
            };
            match head(text) {
                None => fault(format!("`{text}` is no key of an engine file; write it like rod.length [mm]")),
                Some(own) if heads.iter().any(|other| other.key == own.key) => {
                    fault(format!("two columns are of `{}`", own.key));
                }
                Some(Head { key, unit: Some(unit), .. }) if holds(&key) == Holds::Words => {
                    fault(format!("`{key}` is no quantity and has no unit: write the head without [{unit}]"));
                }
                Some(own) => heads.push(own),
            }
        }
        let rows: Vec<CaseRow> = rows.collect();
        for row in rows.iter().filter(|row| row.cells.len() > first.cells.len()) {
            let message =
                format!("it has {} cells, the first row has {}", row.cells.len(), first.cells.len());
            faults.push(CaseFault { row: row.number, column: None, message });
        }
        if rows.is_empty() && faults.is_empty() {
            return Err(none(first.number + 1, "there is no case: every row below the keys is one"));
        }
        if faults.is_empty() { Ok(CaseTable { heads, rows }) } else { Err(faults) }
    }

    /// The same with a point in numbers that have a decimal comma, `140,5` or `0,30 kg`.
    #[must_use]
    pub fn with_decimal_commas(mut self) -> CaseTable {
        for (place, head) in self.heads.iter().enumerate() {
            let cells = self.rows.iter_mut().filter_map(|row| row.cells.get_mut(place));
            CaseTable::put_points(&head.key, head.unit.is_some(), cells);
        }
        self
    }

    /// Puts a point into the numbers of a column that have a decimal comma: those of a key that holds one number, and those with a unit in
    /// the head or the cell. Texts and lists such as `1,2` keep their commas; a number with separators between its thousands cannot be used.
    pub fn put_points<'c>(key: &str, has_unit: bool, cells: impl Iterator<Item = &'c mut CaseCell>) {
        let holds = holds(key);
        if holds == Holds::Words {
            return;
        }
        for cell in cells {
            if let CaseCell::Text(text) = cell {
                match with_point(text, holds == Holds::Number, has_unit) {
                    Ok(None) => {}
                    Ok(Some(pointed)) => *text = pointed,
                    Err(plain) => {
                        let words = format!("`{text}`: thousands separators are not read, write {plain}");
                        *cell = CaseCell::Unusable(words);
                    }
                }
            }
        }
    }

    /// Number of cases.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }
}

/// What a key holds, as far as commas go.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Holds {
    /// One number, with or without a unit.
    Number,
    /// A text or a word.
    Words,
    /// A list, a table, or nothing that is known.
    Other,
}

fn holds(key: &str) -> Holds {
    // `cylinder[1].piston.mass` is `mass` of `cylinder[].piston`.
    let mut place = String::new();
    for part in key.split_inclusive('[') {
        place.push_str(part.trim_start_matches(|c: char| c.is_ascii_digit()));
    }
    let (table, name) = place.rsplit_once('.').unwrap_or(("", &place));
    let (name, is_entry) = name.strip_suffix("[]").map_or((name, false), |name| (name, true));
    let tables = key_tables();
    let table = tables.iter().find(|own| own.path == table);
    let found = table.and_then(|table| table.keys.iter().find(|own| own.name == name));
    match found.map(|own| own.kind) {
        Some("whole" | "number" | "quantity" | "share" | "ratio") => Holds::Number,
        Some("quantities" | "list") if is_entry => Holds::Number,
        Some("text" | "choice" | "flag") => Holds::Words,
        _ => Holds::Other,
    }
}

/// What stands between digits: marks of decimals, and what else parts thousands.
const SEPARATORS: [char; 7] = ['.', ',', ' ', '\'', '_', '\u{a0}', '\u{202f}'];

/// A number with a decimal comma at the beginning, with a point in its place; `None` of any other text. Without a unit it may be a list, but where
/// one number is due.
///
/// # Errors
/// A number with separators between its thousands, without them.
fn with_point(text: &str, is_number: bool, has_unit: bool) -> Result<Option<String>, String> {
    let unsigned = text.trim_start_matches(['+', '-']);
    let sign = &text[..text.len() - unsigned.len()];
    let behind = unsigned.trim_start_matches(|c: char| c.is_ascii_digit() || SEPARATORS.contains(&c));
    let number = unsigned[..unsigned.len() - behind.len()].trim_end_matches(|c: char| !c.is_ascii_digit());
    let behind = &unsigned[number.len()..];
    // `1.5e-3` has no unit.
    let power = behind.strip_prefix(['e', 'E']).map(|power| power.trim_start_matches(['+', '-']));
    let power = power.filter(|power| power.starts_with(|c: char| c.is_ascii_digit()));
    let unit =
        power.map_or(behind, |power| power.trim_start_matches(|c: char| c.is_ascii_digit())).trim_start();
    let own_unit = !unit.is_empty() && !unit.starts_with('/') && !unit.contains(',');
    if unit.starts_with(['.', ',']) || !(is_number || has_unit || own_unit) {
        return Ok(None);
    }
    let groups: Vec<&str> = number.split(SEPARATORS).collect();
    let marks: Vec<char> = number.chars().filter(|c| !c.is_ascii_digit()).collect();
    if groups.iter().any(|digits| digits.is_empty()) {
        return Ok(None);
    }
    match marks[..] {
        [] | ['.'] => Ok(None),
        [','] => Ok(Some(format!("{sign}{}.{}{behind}", groups[0], groups[1]))),
        [first, ..] => {
            let last = marks[marks.len() - 1];
            // The last mark is that of the decimals where it is another one.
            let has_decimals = last != first && matches!(last, '.' | ',');
            let (whole, decimals) =
                groups.split_at(if has_decimals { groups.len() - 1 } else { groups.len() });
            let parts_thousands = groups[0].len() <= 3
                && whole[1..].iter().all(|digits| digits.len() == 3)
                && marks[..whole.len() - 1].iter().all(|mark| *mark == first);
            if !parts_thousands || !is_number && marks.iter().all(|mark| *mark == ',') {
                return Ok(None);
            }
            let decimals: String = decimals.iter().map(|digits| format!(",{digits}")).collect();
            Err(format!("{sign}{}{decimals}{behind}", whole.concat()))
        }
    }
}

fn head(text: &str) -> Option<Head> {
    let text = text.trim();
    // A unit stands behind a blank; brackets within a key are indices.
    let (key, unit) = match text.strip_suffix(']').and_then(|inside| inside.rsplit_once('[')) {
        Some((key, unit)) if !unit.trim().chars().all(|c| c.is_ascii_digit()) => {
            (key.trim(), Some(unit.trim()))
        }
        _ => (text, None),
    };
    let is_key = |c: char| c.is_alphanumeric() || "._-[]".contains(c);
    let valid = !key.is_empty() && key.chars().all(is_key) && unit != Some("");
    valid.then(|| Head { text: text.to_owned(), key: key.to_owned(), unit: unit.map(str::to_owned) })
}

/// `B (rod.length [mm])`, as spreadsheets count columns.
fn column_name(place: usize, head: Option<&str>) -> String {
    let (mut letters, mut rest) = (String::new(), place + 1);
    while rest > 0 {
        letters.insert(0, char::from(b'A' + ((rest - 1) % 26) as u8));
        rest = (rest - 1) / 26;
    }
    head.map_or(letters.clone(), |head| format!("{letters} ({head})"))
}

/// The value that a cell gives its key; `None` where it stays.
fn value(cell: &CaseCell, head: &Head) -> Result<Option<Value>, String> {
    let number = |number: f64| serde_json::Number::from_f64(number).map(Value::Number);
    match cell {
        CaseCell::Text(text) if head.key == NAME => return Ok(Some(Value::String(text.clone()))),
        CaseCell::Number(number) if head.key == NAME => return Ok(Some(Value::String(number.to_string()))),
        _ => {}
    }
    let parsed = match cell {
        CaseCell::Text(text) => text.parse::<f64>().ok().filter(|number| number.is_finite()),
        CaseCell::Number(number) => Some(*number),
        _ => None,
    };
    Ok(match (cell, &head.unit, parsed) {
        (CaseCell::Empty, ..) => None,
        (CaseCell::Unusable(words), ..) => return Err(format!("needs a value, got {words}")),
        (CaseCell::Text(text), Some(unit), Some(_)) => Some(Value::String(format!("{text} {unit}"))),
        (_, Some(unit), Some(number)) => Some(Value::String(format!("{number} {unit}"))),
        (CaseCell::Text(text), Some(unit), None) => {
            return Err(format!("needs a number [{unit}], got `{text}`: the unit stands in the head"));
        }
        (CaseCell::Flag(flag), Some(unit), _) => return Err(format!("needs a number [{unit}], got {flag}")),
        (_, None, Some(found)) => {
            // A count is a whole number.
            let whole = (found.fract() == 0.0 && found.abs() < 1e15).then(|| Value::from(found as i64));
            let plain = whole
                .or_else(|| number(found))
                .ok_or_else(|| format!("needs a finite number, got {found}"))?;
            Some(si_value(&head.key, plain))
        }
        (CaseCell::Text(text), None, None) => Some(Value::String(text.clone())),
        (CaseCell::Flag(flag), None, _) => Some(Value::Bool(*flag)),
        (CaseCell::Number(found), ..) => return Err(format!("needs a finite number, got {found}")),
    })
}

/// The engine file with the values of some cells, and what is wrong with it.
fn changed(text: &str, cells: &[(&Head, Value)]) -> Result<lanchester_file::EngineFile, String> {
    let edits: Vec<Edit> =
        cells.iter().map(|(head, value)| Edit { path: head.key.clone(), value: value.clone() }).collect();
    let with_hint = |message: &str, hint: Option<&str>| match hint {
        Some(hint) => format!("{message} ({hint})"),
        None => message.to_owned(),
    };
    let text = edit(text, &edits).map_err(|error| {
        let words = error.to_string();
        words.split_once("\nhint: ").map_or(words.clone(), |(message, hint)| with_hint(message, Some(hint)))
    })?;
    let reading = read(&text);
    reading.file.ok_or_else(|| {
        let errors = reading.diagnostics.iter().filter(|own| own.severity == Severity::Error);
        let words = errors.map(|own| with_hint(&own.message, own.hint.as_deref()));
        words.collect::<Vec<_>>().join("; ")
    })
}

/// The loads of one case, or what is wrong with its cells.
fn case(text: &str, heads: &[Head], row: &CaseRow, request: &LoadRequest) -> Result<Loads, Vec<CaseFault>> {
    let mut faults = Vec::new();
    let mut cells: Vec<(usize, &Head, Value)> = Vec::new();
    let fault = |place: Option<usize>, message: String| CaseFault {
        row: row.number,
        column: place.map(|place| column_name(place, Some(&heads[place].text))),
        message,
    };
    for (place, (cell, head)) in row.cells.iter().zip(heads).enumerate() {
        match value(cell, head) {
            Ok(None) => {}
            Ok(Some(value)) => cells.push((place, head, value)),
            Err(message) => faults.push(fault(Some(place), message)),
        }
    }
    let all: Vec<(&Head, Value)> = cells.iter().map(|(_, head, value)| (*head, value.clone())).collect();
    let whole = match changed(text, &all) {
        Ok(file) if faults.is_empty() => loads(&file.engine, request).map_err(|error| error.to_string()),
        Ok(_) => return Err(faults),
        Err(message) => Err(message),
    };
    whole.map_err(|message| {
        // Which cells are wrong by themselves.
        for (place, head, value) in &cells {
            if let Err(message) = changed(text, &[(head, value.clone())]) {
                faults.push(fault(Some(*place), message));
            }
        }
        if faults.is_empty() {
            faults.push(fault(None, format!("its cells do not make an engine together: {message}")));
        }
        faults
    })
}

/// The loads of every case of a table as a table: the cells of the case, then the largest loads and those of orders 1 and 2, with units.
///
/// `text` is the engine file that the cases change.
///
/// # Errors
/// Every cell that cannot be used, with its row and column; rows whose cells do not fit together.
pub fn case_loads(text: &str, table: &CaseTable, request: &LoadRequest) -> Result<Table, Vec<CaseFault>> {
    let found: Vec<_> = table.rows.par_iter().map(|row| case(text, &table.heads, row, request)).collect();
    let (mut all, mut faults) = (Vec::with_capacity(found.len()), Vec::new());
    for loads in found {
        match loads {
            Ok(loads) => all.push(loads),
            Err(more) => faults.extend(more),
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let mut columns = vec![Column::numbers("row", "")];
    columns.extend(table.heads.iter().map(|head| Column::words(head.text.clone())));
    // A column of the cases may have this head already.
    let is_given = table.heads.iter().any(|head| head.text == "speed [rpm]");
    columns.extend([
        Column::numbers(if is_given { "speed of the loads" } else { "speed" }, "rpm"),
        Column::numbers("largest force", "N"),
        Column::numbers("largest couple", "N m"),
        Column::numbers("largest roll moment", "N m"),
        Column::numbers("smallest roll moment", "N m"),
    ]);
    for order in [1, 2] {
        columns.push(Column::numbers(format!("force order {order}"), "N"));
        columns.push(Column::numbers(format!("couple order {order}"), "N m"));
    }
    let rows = table.rows.iter().zip(&all).map(|(row, loads)| {
        let mut cells = vec![Cell::Number { value: row.number as f64, decimals: 0 }];
        cells.extend((0..table.heads.len()).map(|place| match row.cells.get(place) {
            None | Some(CaseCell::Empty) => Cell::Empty,
            Some(CaseCell::Text(text) | CaseCell::Unusable(text)) => Cell::text(text.clone()),
            Some(CaseCell::Number(number)) => Cell::text(number.to_string()),
            Some(CaseCell::Flag(flag)) => Cell::text(flag.to_string()),
        }));
        let peaks = &loads.total.peaks;
        let rpm = super::force_table::rpm(loads.speed);
        let order = |number: f64| loads.total.orders.iter().find(|own| own.order == number);
        let of = |number: f64| {
            let own = order(number);
            [own.map_or(f64::NAN, |own| own.force_peak()), own.map_or(f64::NAN, |own| own.couple_peak())]
        };
        let values = [
            rpm,
            peaks.force.max.value,
            peaks.couple.max.value,
            peaks.roll_moment.max.value,
            peaks.roll_moment.min.value,
        ];
        let number = |value: f64| if value.is_finite() { Cell::number(value, 6) } else { Cell::Empty };
        cells.extend(values.into_iter().chain(of(1.0)).chain(of(2.0)).map(number));
        cells
    });
    Ok(Table {
        id: "cases",
        title: "Loads of all cases".to_owned(),
        note:
            "Forces and couples of inertia; a cell that is empty leaves the key of the engine file as it is."
                .to_owned(),
        remark: String::new(),
        columns,
        rows: rows.collect(),
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]
    use super::*;

    #[test]
    fn heads_have_keys_indices_and_units() {
        let parts = |text: &str| head(text).map(|own| (own.key, own.unit));
        assert_eq!(parts("rod.length [mm]"), Some(("rod.length".into(), Some("mm".into()))));
        assert_eq!(parts("cylinder[1].piston.mass"), Some(("cylinder[1].piston.mass".into(), None)));
        assert_eq!(parts("throw[0]"), Some(("throw[0]".into(), None)));
        assert_eq!(parts("[mm]"), None);
        assert_eq!(parts("two words"), None);
        assert_eq!((column_name(0, None), column_name(27, None)), ("A".to_owned(), "AB".to_owned()));
    }

    #[test]
    fn decimal_commas_are_those_of_numbers() {
        let point = |text: &str| with_point(text, true, false);
        for (text, wanted) in
            [("-140,5", "-140.5"), ("0,30 kg", "0.30 kg"), ("1,5e-3", "1.5e-3"), ("140,500", "140.500")]
        {
            assert_eq!(point(text), Ok(Some(wanted.to_owned())), "{text}");
        }
        for other in
            ["140.5", "1,234,5", "1,2.3", "a,5", ",5", "5,", "80 mm, 90 mm", "1, 2", "4 1/2 in", "140", ""]
        {
            assert_eq!(point(other), Ok(None), "{other}");
        }
        for (text, plain) in [
            ("1.234,5", "1234,5"),
            ("-1.234.567,25 mm", "-1234567,25 mm"),
            ("1 234", "1234"),
            ("1'234.5", "1234,5"),
            ("1,234.5", "1234,5"),
            ("1.234.567", "1234567"),
        ] {
            assert_eq!(point(text), Err(plain.to_owned()), "{text}");
        }
        // What may be a list needs a unit.
        let list = |text: &str, has_unit: bool| with_point(text, false, has_unit).unwrap();
        for text in ["1,2", "1,2,3", "100,200,300", "1,2e1", "1,2 deg, 3 deg"] {
            assert_eq!(list(text, false), None, "{text}");
        }
        assert_eq!(list("1,2 deg", false).as_deref(), Some("1.2 deg"));
        assert_eq!(list("1,2", true).as_deref(), Some("1.2"));
    }

    #[test]
    fn keys_say_what_their_commas_are() {
        for (key, wanted) in [
            ("rod.length", Holds::Number),
            ("cylinder[1].piston.mass", Holds::Number),
            ("layout.cylinders", Holds::Number),
            ("name", Holds::Words),
            ("counterweight[0].name", Holds::Words),
            ("speed", Holds::Other),
            ("speed[1]", Holds::Number),
            ("firing.order", Holds::Other),
            ("firing.angles", Holds::Other),
            ("balance.limits.force", Holds::Other),
            ("nothing.known", Holds::Other),
        ] {
            assert_eq!(holds(key), wanted, "{key}");
        }
    }

    #[test]
    fn lists_keep_their_commas_in_tables() {
        let text = |text: &str| CaseCell::Text(text.to_owned());
        let row =
            |number, cells: &[&str]| CaseRow { number, cells: cells.iter().map(|own| text(own)).collect() };
        let heads = ["rod.length [mm]", "piston.mass", "firing.angles", "name", "crank.stroke [mm]"];
        let table = CaseTable::of(vec![row(1, &heads), row(2, &["140,5", "0,3", "1,2", "1,2 l", "1.234,5"])]);
        let table = table.unwrap().with_decimal_commas();
        assert_eq!(table.rows[0].cells[..4], [text("140.5"), text("0.3"), text("1,2"), text("1,2 l")]);
        let wrong = value(&table.rows[0].cells[4], &table.heads[4]).unwrap_err();
        assert_eq!(wrong, "needs a value, got `1.234,5`: thousands separators are not read, write 1234,5");
    }
}
