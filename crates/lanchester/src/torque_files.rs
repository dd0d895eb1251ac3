//! Torques over the crank angle that stand in files of their own.

use crate::pressure::measured::TraceFile;
use lanchester_cycle::{TraceError, read_torque};
use lanchester_file::EngineFile;

/// Why a torque from a file is not known.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TorqueFileError {
    /// A file that the engine file names was not given.
    #[error("the torque of {name} is missing\nhint: [simulation] names this file")]
    Missing {
        /// Its name.
        name: String,
    },
    /// The file is refused.
    #[error(transparent)]
    Trace(#[from] TraceError),
}

/// Names of the files of torque that an engine file asks for, each once.
pub fn torque_file_names(file: &EngineFile) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for named in file.tasks.simulation.iter().flat_map(|input| &input.torque_files) {
        if !names.contains(&named.file.as_str()) {
            names.push(&named.file);
        }
    }
    names
}

/// Gives an engine file the torques of `files`, which hold those that [`torque_file_names`] names. Without this its torque is refused wherever it counts.
///
/// # Errors
/// [`TorqueFileError`] where a file is missing or refused.
pub fn give_torques(file: &mut EngineFile, files: &[TraceFile]) -> Result<(), TorqueFileError> {
    for named in file.tasks.simulation.iter_mut().flat_map(|input| &mut input.torque_files) {
        let found = files.iter().find(|file| file.name == named.file);
        let text = &found.ok_or_else(|| TorqueFileError::Missing { name: named.file.clone() })?.text;
        named.curve = Some(read_torque(text, &named.file, named.period)?);
    }
    Ok(())
}
