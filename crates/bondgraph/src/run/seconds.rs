//! Times in messages.

/// A time; where it is tiny as a power of ten.
pub(crate) fn seconds(t: f64) -> String {
    if t != 0.0 && t < 1e-6 { format!("{t:e}") } else { format!("{t}") }
}
