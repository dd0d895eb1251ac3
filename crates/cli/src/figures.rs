//! Figures as files of their own.

use crate::failure::Failure;
use crate::files::write_result;
use lanchester::report::Figure;
use std::path::{Path, PathBuf};

/// Writes figures into a folder, and says where they are.
pub(crate) fn write_figures(
    folder: &Path,
    engine_file: &Path,
    figures: &[Figure],
) -> Result<Vec<PathBuf>, Failure> {
    let write = |figure: &Figure| {
        let path = folder.join(format!("{}.svg", figure.id));
        write_result(&path, engine_file, &figure.svg())?;
        Ok(path)
    };
    figures.iter().map(write).collect()
}
