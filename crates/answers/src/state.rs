//! What answers are made of: all that lasts from one question to the next.

use crate::files::{FileState, Files};
use crate::problem::{Problem, Status};
use crate::remembered::Remembered;
use lanchester::file::EngineFile;
use lanchester::mechanism::MountStudy;
use lanchester::model::Engine;
use lanchester::{TraceFile, give_torques, torque_file_names, trace_names};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

/// All that the block on its mounts depends on.
pub(crate) type MountsAsked = (Engine, Vec<TraceFile>, usize);

/// What answers are made of.
pub struct Studio {
    pub(crate) program: String,
    pub(crate) files: Box<dyn Files>,
    /// Name of the file that was opened or saved last: its changes are told.
    open: Mutex<Option<String>>,
    /// The block on its mounts, by engine, traces and number of speeds.
    pub(crate) mounted: Remembered<MountsAsked, MountStudy>,
    /// Time since any fixed moment.
    pub(crate) clock: fn() -> Duration,
}

impl Studio {
    /// `program`: its name, version and commit, for reports; `clock`: the time since any fixed moment.
    pub fn new(program: String, files: Box<dyn Files>, clock: fn() -> Duration) -> Studio {
        Studio { program, files, open: Mutex::default(), mounted: Remembered::default(), clock }
    }

    /// A file is the open one from now on.
    pub fn opened(&self, name: &str) {
        *self.open.lock().unwrap_or_else(PoisonError::into_inner) = Some(name.to_string());
    }

    /// The open file as it stands now; `None` where there is none any more.
    pub fn open_file(&self) -> Option<FileState> {
        let name = self.open.lock().unwrap_or_else(PoisonError::into_inner).clone();
        name.and_then(|name| self.files.open(&name).ok())
    }

    /// The files of pressure that an engine names.
    pub(crate) fn traces(&self, engine: &Engine) -> Result<Vec<TraceFile>, Problem> {
        self.named(trace_names(engine), "[gas]")
    }

    /// Gives an engine file the torques of the files that it names.
    pub(crate) fn with_torques(&self, mut file: EngineFile) -> Result<EngineFile, Problem> {
        let files = self.named(torque_file_names(&file), "[simulation]")?;
        give_torques(&mut file, &files).map_err(Problem::refused)?;
        Ok(file)
    }

    fn named(&self, names: Vec<&str>, by: &str) -> Result<Vec<TraceFile>, Problem> {
        let read = |name: &str| Ok(TraceFile { name: name.to_string(), text: self.files.named(name, by)? });
        names.into_iter().map(read).collect()
    }
}

/// What a question that was left behind gets.
pub fn superseded() -> Problem {
    Problem::new(Status::Conflict, "a newer question took the place of this one", "wait for the newer answer")
}
