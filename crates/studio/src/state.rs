//! What answers are made of: all that lasts from one question to the next.

use crate::folder::Folder;
use crate::lanes::Lanes;
use crate::problem::Problem;
use crate::remembered::Remembered;
use axum::http::StatusCode;
use lanchester::TraceFile;
use lanchester::mechanism::MountStudy;
use lanchester::model::Engine;
use std::sync::{Arc, Mutex};
use tokio::sync::Semaphore;

/// All that the block on its mounts depends on.
pub(crate) type MountsAsked = (Engine, Vec<TraceFile>, usize);

/// What answers are made of.
pub(crate) struct Studio {
    pub(crate) program: String,
    pub(crate) folder: Folder,
    /// Name of the file that was opened or saved last: its changes are told.
    pub(crate) open: Mutex<Option<String>>,
    pub(crate) lanes: Lanes,
    /// The block on its mounts, by engine, traces and number of speeds.
    pub(crate) mounted: Remembered<MountsAsked, MountStudy>,
    /// Computations at a time: as many as there are processors.
    pub(crate) processors: Arc<Semaphore>,
}

/// What a question that was left behind gets.
pub(crate) fn superseded() -> Problem {
    Problem::new(
        StatusCode::CONFLICT,
        "a newer question took the place of this one",
        "wait for the newer answer",
    )
}
