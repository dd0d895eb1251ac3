//! Errors as reasons with remedies.

use lanchester_task::Unmeasured;

/// An error in words as a reason and what would help: what stands behind its hint, else `remedy`.
pub(super) fn split_hint(error: &str, remedy: &str) -> Unmeasured {
    let (reason, hint) = error.split_once("\nhint: ").unwrap_or((error, remedy));
    Unmeasured { reason: reason.replace('\n', "; "), remedy: hint.replace('\n', "; ") }
}
