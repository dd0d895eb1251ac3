//! Weights and shafts that were found, written into the text of the engine file.
//!
//! The text is changed in pieces at the places that the parser gives; what is not changed stays byte for byte
//! (decision 12 says why no editing library does it).

mod amount;
mod counterweights;
mod difference;
mod edit;
mod entry;
mod shafts;
mod splice;

use crate::engine_file::EngineFile;
use crate::expanded::{quantity, quoted};
use crate::read::{read, read_with_origin};
use amount::{Units, same_amount, same_place};
use counterweights::CounterweightWriter;
pub use difference::difference;
pub use edit::{Edit, EditError, FileEntry, edit, file_entries};
use entry::{Entry, List};
use lanchester_diagnostic::Diagnostic;
use lanchester_model::Engine;
use lanchester_units::{Dimension, parse, rewritten};
use shafts::ShaftWriter;
use splice::Splices;

/// Why nothing was written.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum WriteBackError {
    /// The file itself cannot be read.
    #[error("the engine file has mistakes")]
    File(Vec<Diagnostic>),
    /// The file would not be an engine file any more: too many weights, or one that no file may hold.
    #[error("the weights cannot stand in an engine file")]
    Weights {
        /// What the file would be.
        text: String,
        /// Its mistakes.
        diagnostics: Vec<Diagnostic>,
    },
    /// A shape that an engine file has no words for, such as an insert that reaches neither face.
    #[error("the shape of {name} cannot be said in an engine file")]
    Shape {
        /// Name of the weight.
        name: String,
    },
}

/// What a weight may differ from its part, relatively, in thicknesses and in radians: more is another weight.
const PART: f64 = 1e-9;
/// What the unbalance of a written shape may miss, relatively.
const SHAPE: f64 = 1e-9;

/// The text of an engine file with the counterweights and shafts of `fitted`, which else is the engine of the file.
///
/// An entry of the same name is changed in place: only values that differ, in the unit and the spelling that they have;
/// its comments, the order of its keys and their spacing stay. A weight or shaft that the file does not have comes behind
/// the last of its kind, or at the end; one that `fitted` does not have goes, its comments stay. The short form
/// `[counterweights]` gives way to `[[counterweight]]` in its place if any weight that it makes is changed. What is not
/// changed stays byte for byte.
///
/// A weight whose part is unchanged keeps its entry byte for byte. A part that the file does not have is written as `shape`, and
/// `unbalance` stays, or becomes the wanted one of the part; where the weight has another amount, plane or direction than its part, or no
/// part, the `shape` of the entry gives way to the number, and its comments stay.
///
/// Reading the new text gives the weights of `fitted`, in the order of the file: amounts and places to 1e-11 of their
/// size, directions to 1e-11 rad and up to whole turns (of a weight of 0: any), so that every load is the same to 1e-9 of the
/// unbalanced one.
///
/// # Errors
/// [`WriteBackError`] if the text is no engine file, or would be none with these weights.
pub fn write_back(text: &str, fitted: &Engine) -> Result<String, WriteBackError> {
    let (written, engine) = written(text, fitted, false)?;
    if shapes_are_kept(&engine, fitted).is_ok() {
        return Ok(written);
    }
    // Few digits are not enough where the unbalance is a small difference of large ones.
    let (written, engine) = self::written(text, fitted, true)?;
    shapes_are_kept(&engine, fitted).map(|()| written)
}

/// Whether every weight that is a part has its unbalance in `read` too.
fn shapes_are_kept(read: &Engine, fitted: &Engine) -> Result<(), WriteBackError> {
    for shaft in &fitted.shafts {
        for (index, weight) in shaft.weights.iter().enumerate().filter(|(_, weight)| weight.part.is_some()) {
            let is_there = read.shafts.iter().filter(|other| other.name == shaft.name).any(|other| {
                other.weights.get(index).is_some_and(|other| is_shape(other.unbalance, weight.unbalance))
            });
            if !is_there {
                return Err(WriteBackError::Shape { name: shaft.weight_name(index) });
            }
        }
    }
    for weight in fitted.counterweights.iter().filter(|weight| weight.part.is_some()) {
        let is_there = read
            .counterweights
            .iter()
            .any(|other| other.name == weight.name && is_shape(other.unbalance, weight.unbalance));
        if !is_there {
            return Err(WriteBackError::Shape { name: weight.name.clone() });
        }
    }
    Ok(())
}

/// Whether a shape that was read has the unbalance that was written.
fn is_shape(read: f64, written: f64) -> bool {
    (read - written).abs() <= SHAPE * written.max(f64::MIN_POSITIVE)
}

/// The new text and its engine; `exact`: with all digits of shapes.
fn written(text: &str, fitted: &Engine, exact: bool) -> Result<(String, Engine), WriteBackError> {
    let (reading, origin) = read_with_origin(text);
    let (Some(EngineFile { engine, .. }), Some(origin)) = (reading.file, origin) else {
        return Err(WriteBackError::File(reading.diagnostics));
    };
    let arena = toml_spanner::Arena::new();
    let document = toml_spanner::parse_recoverable(text, &arena);
    let root = document.table();
    let mut splices = Splices::new(text);
    let units = Units::new(root.as_item());
    // A file that was read has lists of tables here, or nothing.
    if let (Some(weights), Some(shafts)) = (List::of(root.get("counterweight")), List::of(root.get("shaft")))
    {
        let line_end = splices.line_end;
        let writer = CounterweightWriter { engine: &engine, origin, units: &units, line_end, exact };
        writer.write(root, &weights, &fitted.counterweights, &mut splices);
        let writer = ShaftWriter { engine: &engine, origin, units: &units, exact };
        writer.write(&shafts, &fitted.shafts, &mut splices);
    }
    let text = splices.apply();
    let reading = read(&text);
    match reading.file {
        Some(file) => Ok((text, file.engine)),
        None => Err(WriteBackError::Weights { text, diagnostics: reading.diagnostics }),
    }
}

/// For each part that is there the one that it becomes, by its name; of several of one name first those that are the
/// same already.
fn matches<T>(
    there: &[T],
    wanted: &[T],
    same_name: impl Fn(&T, &T) -> bool,
    same: impl Fn(&T, &T) -> bool,
) -> Vec<Option<usize>> {
    let mut found: Vec<Option<usize>> = vec![None; there.len()];
    let mut is_taken = vec![false; wanted.len()];
    for must_be_same in [true, false] {
        for (part, found) in there.iter().zip(&mut found) {
            if found.is_some() {
                continue;
            }
            let is_match = |target: &usize| {
                let other = &wanted[*target];
                !is_taken[*target] && same_name(part, other) && (!must_be_same || same(part, other))
            };
            *found = (0..wanted.len()).find(is_match);
            if let Some(target) = *found {
                is_taken[target] = true;
            }
        }
    }
    found
}

/// Writes the shape of a part into the entry of a weight. The unbalance that the entry has stays as the wanted one, or becomes `wanted`;
/// `now` is what mass and radius say.
fn set_shape(
    entry: Entry<'_>,
    now: f64,
    wanted: Option<f64>,
    shape: &str,
    place_key: &'static str,
    units: &Units<'_>,
    splices: &mut Splices<'_>,
) {
    let fits = |unbalance: f64| move |read: f64| same_amount(read, unbalance);
    if entry.has("mass") {
        let unbalance = wanted.unwrap_or(now);
        let value = units.new_value("unbalance", unbalance, Dimension::Unbalance, fits(unbalance));
        entry.exchange("mass", "unbalance", &value, splices);
        entry.unset("radius", splices);
    } else if let Some(wanted) = wanted {
        let old = entry.text("unbalance").and_then(|text| parse(text, Dimension::Unbalance, "").ok());
        if !old.is_some_and(|old| same_amount(old, wanted)) {
            let value = units.value(entry, "unbalance", wanted, Dimension::Unbalance, fits(wanted), splices);
            entry.set("unbalance", &value, &[place_key], splices);
        }
    }
    let behind = ["angle", "phase", "unbalance", "mass", place_key];
    if entry.has("shape") && !entry.has_inline("shape") {
        entry.unset_table("shape", splices);
        entry.add("shape", shape, &behind, splices);
    } else {
        entry.set("shape", shape, &behind, splices);
    }
}

/// A dimension of a shape as text; `exact`: to the last digit.
fn dimension_text(value: f64, dimension: Dimension, exact: bool) -> String {
    let unit = match dimension {
        Dimension::Length => "0 mm",
        Dimension::Angle => "0 deg",
        Dimension::Density => "0 kg/m3",
        _ => return quantity(value, dimension),
    };
    let fits = |read: f64| if exact { read == value } else { same_place(read, value) };
    quoted(&rewritten(unit, value, dimension, fits).unwrap_or_default())
}

/// Sets the unbalance of a weight; mass and radius stay mass and radius if they can.
fn set_unbalance(entry: Entry<'_>, unbalance: f64, units: &Units<'_>, splices: &mut Splices<'_>) {
    let fits = |read: f64| same_amount(read, unbalance);
    let radius = entry.text("radius").and_then(|text| parse(text, Dimension::Length, "").ok());
    match radius {
        Some(radius) if radius > 0.0 => {
            let fits = |mass: f64| same_amount(mass * radius, unbalance);
            let value = units.value(entry, "mass", unbalance / radius, Dimension::Mass, fits, splices);
            entry.set("mass", &value, &[], splices);
        }
        Some(_) => {
            // At the radius 0 no mass has any unbalance.
            let value = units.new_value("unbalance", unbalance, Dimension::Unbalance, fits);
            entry.exchange("mass", "unbalance", &value, splices);
            entry.unset("radius", splices);
        }
        None => {
            let value = units.value(entry, "unbalance", unbalance, Dimension::Unbalance, fits, splices);
            entry.set("unbalance", &value, &[], splices);
        }
    }
}
