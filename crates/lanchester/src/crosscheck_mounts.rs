//! Condition C: the block on its mounts, linear response against the simulated motion.

use crate::crosscheck::{CrossCheckError, Pair};
use lanchester_report::CrossRow;

/// Rows of condition C, or why it does not apply.
pub(crate) fn moving_block(pair: &Pair<'_>) -> Result<Result<Vec<CrossRow>, String>, CrossCheckError> {
    if let Some(reason) = &pair.train.fixed_because {
        return Ok(Err(reason.clone()));
    }
    Ok(Err("to come".into()))
}
