//! A long study in turns: each takes about as long as a window likes to wait, and the next goes on from it.

use crate::asker::Asker;
use crate::problem::{Problem, Status};
use crate::state::superseded;
use lanchester::run::{Study, stretch};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::time::Duration;

/// How long a turn goes on.
const TURN: Duration = Duration::from_millis(400);
/// Blocks that are computed between two looks at the clock.
const BLOCKS: u64 = 4;

/// How far a study has come; whoever asks hands it back unchanged.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(in crate::questions) struct SoFar {
    /// Blocks that are done.
    pub(in crate::questions) blocks: u64,
    /// What is kept of them.
    pub(in crate::questions) kept: String,
}

/// A turn of a study.
#[derive(Debug, Serialize, JsonSchema)]
pub(in crate::questions) struct Turn {
    /// Where the next turn goes on.
    pub(in crate::questions) so_far: SoFar,
    /// Share of the study that is done, 0 to 1.
    pub(in crate::questions) done: f64,
}

/// One turn, and what is kept of the whole study where this was the last one.
pub(super) fn turn<S: Study>(
    asker: &Asker,
    study: &S,
    so_far: Option<SoFar>,
) -> Result<(Turn, Option<S::Kept>), Problem> {
    let began = (asker.studio.clock)();
    let all = study.blocks();
    let (first, mut kept) = match so_far {
        None => (0, study.nothing()),
        Some(SoFar { blocks, kept }) if blocks <= all => {
            (blocks, serde_json::from_str(&kept).map_err(|_| torn())?)
        }
        Some(_) => return Err(torn()),
    };
    let mut next = first;
    while next < all && (next == first || (asker.studio.clock)().saturating_sub(began) < TURN) {
        if !asker.waits() {
            return Err(superseded());
        }
        let end = all.min(next + BLOCKS);
        let (more, _) = stretch(study, next..end).map_err(Problem::refused)?;
        kept = study.join(kept, more).map_err(Problem::refused)?;
        next = end;
    }
    let text = serde_json::to_string(&kept).map_err(|error| {
        let hint = "this is an internal error: please report it with the engine file";
        Problem::new(Status::Broken, format!("what was found cannot be kept: {error}"), hint)
    })?;
    let done = if all == 0 { 1.0 } else { next as f64 / all as f64 };
    let turn = Turn { so_far: SoFar { blocks: next, kept: text }, done };
    Ok((turn, (next == all).then_some(kept)))
}

/// How long a study takes [s], from some of its blocks in the middle.
pub(super) fn estimate<S: Study>(asker: &Asker, study: &S) -> Result<f64, Problem> {
    let all = study.blocks();
    let from = (all / 2).min(all.saturating_sub(BLOCKS));
    let end = all.min(from + BLOCKS);
    let began = (asker.studio.clock)();
    stretch(study, from..end).map_err(Problem::refused)?;
    let took = (asker.studio.clock)().saturating_sub(began).as_secs_f64();
    Ok(took * all as f64 / (end - from).max(1) as f64)
}

/// What was handed back is not what was handed out.
pub(in crate::questions) fn torn() -> Problem {
    let hint = "start it again from its beginning";
    Problem::new(Status::BadQuestion, "the study cannot go on from there", hint)
}
