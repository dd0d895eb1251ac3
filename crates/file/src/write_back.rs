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
mod weight;

use crate::engine_file::EngineFile;
use crate::read::{read, read_with_origin};
use amount::Units;
use counterweights::CounterweightWriter;
pub use difference::difference;
pub use edit::{Edit, EditError, FileEntry, edit, file_entries};
use entry::List;
use lanchester_diagnostic::Diagnostic;
use lanchester_model::Engine;
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
