//! An engine file that was read, with the files that it names.

use crate::failure::Failure;
use lanchester::file::{Diagnostic, EngineFile, read, write_back};
use lanchester::model::Engine;
use lanchester::{MeshFile, StressMesh, TraceFile, give_torques, torque_file_names, trace_names};
use lanchester_files::{open_regular, shown};
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

/// An engine file may be this long; a longer one is some other file.
const LONGEST_INPUT: u64 = 4 << 20;
/// A file of pressures or torques may be this long.
const LONGEST_TRACE: u64 = 64 << 20;

/// An engine that can be asked.
#[derive(Debug)]
pub struct Prepared {
    /// What messages call the file.
    pub name: String,
    /// The text of the engine file.
    pub text: String,
    /// Where files that it names are; `None` for a text without a place.
    pub folder: Option<PathBuf>,
    /// The engine, and what is asked of it.
    pub file: EngineFile,
    /// Warnings of the reader.
    pub warnings: Vec<Diagnostic>,
    traces: OnceLock<Vec<TraceFile>>,
}

impl Prepared {
    /// Reads an engine file.
    ///
    /// # Errors
    /// Where it cannot be read or has mistakes.
    pub fn read(path: &Path) -> Result<Prepared, Failure> {
        let name = shown(path);
        let hint = "`Engine.templates()` lists engines to start from";
        let text = text_of(path, LONGEST_INPUT, hint)?;
        let folder = path.parent().unwrap_or(Path::new("")).to_path_buf();
        Prepared::of_text(text, name, Some(folder))
    }

    /// Reads the text of an engine file; `name` is what messages call it.
    ///
    /// # Errors
    /// Where it has mistakes, or files that it names have.
    pub fn of_text(text: String, name: String, folder: Option<PathBuf>) -> Result<Prepared, Failure> {
        let reading = read(&text);
        let Some(mut file) = reading.file else {
            return Err(Failure::Mistakes { name, text, diagnostics: reading.diagnostics });
        };
        let torques = beside(torque_file_names(&file), folder.as_deref(), "[simulation]")?;
        give_torques(&mut file, &torques).map_err(Failure::refused)?;
        Ok(Prepared { name, text, folder, file, warnings: reading.diagnostics, traces: OnceLock::new() })
    }

    /// The engine.
    pub fn engine(&self) -> &Engine {
        &self.file.engine
    }

    /// The files of pressure that it names.
    ///
    /// # Errors
    /// Where one cannot be read.
    pub fn traces(&self) -> Result<&[TraceFile], Failure> {
        if let Some(traces) = self.traces.get() {
            return Ok(traces);
        }
        let traces = beside(trace_names(self.engine()), self.folder.as_deref(), "[gas]")?;
        Ok(self.traces.get_or_init(|| traces))
    }

    /// A mesh with the text of the file that it names.
    ///
    /// # Errors
    /// Where it cannot be read.
    pub fn mesh(&self, mesh: StressMesh) -> Result<StressMesh, Failure> {
        let Some(own) = &mesh.own else { return Ok(mesh) };
        let text = beside(vec![&own.name], self.folder.as_deref(), "[crank.mesh]")?
            .pop()
            .map(|file| file.text.into());
        Ok(StressMesh { own: Some(MeshFile { name: own.name.clone(), text }), ..mesh })
    }

    /// The same file with the weights and shapes of `fitted`, comments and order preserved.
    ///
    /// # Errors
    /// Where the file's form cannot hold them.
    pub fn fitted(&self, fitted: &Engine) -> Result<Arc<Prepared>, Failure> {
        let text = write_back(&self.text, fitted).map_err(Failure::refused)?;
        self.with_text(text)
    }

    /// Another text in the same place.
    ///
    /// # Errors
    /// As [`Prepared::of_text`].
    pub fn with_text(&self, text: String) -> Result<Arc<Prepared>, Failure> {
        Prepared::of_text(text, self.name.clone(), self.folder.clone()).map(Arc::new)
    }
}

/// The text of a workshop sheet.
///
/// # Errors
/// Where it cannot be read.
pub fn sheet_file_text(path: &Path) -> Result<String, Failure> {
    text_of(path, LONGEST_INPUT, "give the place of a workshop sheet")
}

/// Files that an engine file names, from its own folder; `section` names them.
fn beside(names: Vec<&str>, folder: Option<&Path>, section: &str) -> Result<Vec<TraceFile>, Failure> {
    let hint = format!("{section} names it: give its place from the folder of the engine file");
    let read = |name: &str| {
        let folder = folder.ok_or_else(|| {
            Failure::option(
                format_args!(
                    "{section} names the file {name}, and the engine comes from a text without a folder"
                ),
                "give `folder=`, or read the engine from its file",
            )
        })?;
        let text = text_of(&folder.join(name), LONGEST_TRACE, &hint)?;
        Ok(TraceFile { name: name.to_owned(), text })
    };
    names.into_iter().map(read).collect()
}

/// The text of a regular file.
fn text_of(path: &Path, longest: u64, hint: &str) -> Result<String, Failure> {
    let name = shown(path);
    let mut bytes = Vec::new();
    open_regular(path)
        .and_then(|file| file.take(longest + 1).read_to_end(&mut bytes))
        .map_err(|error| Failure::option(format_args!("cannot read {name}: {error}"), hint))?;
    if bytes.len() as u64 > longest {
        return Err(Failure::option(
            format_args!("{name} is longer than {} MiB", longest >> 20),
            "is this the right file?",
        ));
    }
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        Failure::option(format_args!("{name} is not UTF-8 text (byte {at})"), "save the file as UTF-8")
    })
}
