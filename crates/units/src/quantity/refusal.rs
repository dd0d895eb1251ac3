//! A text that is refused, in words.

/// Why a text is no quantity of the dimension that is due.
#[derive(Debug, Clone, PartialEq)]
pub struct Refusal {
    /// Code of the diagnostic that says so.
    pub code: &'static str,
    /// What was needed and what was got.
    pub message: String,
    /// A few words for the place of the text.
    pub label: String,
    /// What to do.
    pub hint: String,
}
