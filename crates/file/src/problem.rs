//! What is wrong with a layout or a firing order, for the reader to find its place in the file.

/// Something wrong in the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Problem {
    /// Key that it is about, dotted: "layout.bank_angle", "firing.order". The key may be missing from the file.
    pub(crate) key: &'static str,
    /// What was needed and what was got.
    pub(crate) message: String,
    /// What to do.
    pub(crate) hint: Option<String>,
}

impl Problem {
    /// A problem without a hint.
    pub(crate) fn new(key: &'static str, message: impl Into<String>) -> Problem {
        Problem { key, message: message.into(), hint: None }
    }

    /// The problem with a hint.
    pub(crate) fn hint(mut self, hint: impl Into<String>) -> Problem {
        self.hint = Some(hint.into());
        self
    }
}

/// An angle in degrees for a message: "22.5 deg".
pub(crate) fn degrees(angle: f64) -> String {
    let rounded = (angle.to_degrees() * 1e3).round() / 1e3;
    format!("{} deg", rounded + 0.0)
}
