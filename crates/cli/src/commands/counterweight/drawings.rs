//! Drawings of the counterweights and shaft weights of an engine.

use crate::failure::Failure;
use crate::files::write_result;
use lanchester::model::Engine;
use lanchester::report::{counterweight_drawings, shaft_weight_drawings};
use std::path::Path;

/// Draws the counterweights and the weights of balance shafts of an engine into the folder, those of one shape once.
pub(super) fn draw(engine: &Engine, folder: &Path, file: &Path) -> Result<(), Failure> {
    for figure in counterweight_drawings(engine).into_iter().chain(shaft_weight_drawings(engine)) {
        write_result(&folder.join(format!("{}.svg", figure.id)), file, &figure.svg())?;
    }
    Ok(())
}
