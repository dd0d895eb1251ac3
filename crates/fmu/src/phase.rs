//! How far an instance is.

/// How far an instance is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// Made: inputs and parameters may be set.
    Made,
    /// Being initialised.
    Initialising,
    /// Stepped through.
    Running,
    /// Ended: values may be read.
    Ended,
    /// A function panicked: nothing is left but to be freed.
    Broken,
}

impl Phase {
    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Phase::Made => "not yet initialised",
            Phase::Initialising => "being initialised",
            Phase::Running => "running",
            Phase::Ended => "ended",
            Phase::Broken => "broken by an earlier failure and can only be freed",
        }
    }

    /// Whether parameters may be set.
    pub fn is_before_run(self) -> bool {
        matches!(self, Phase::Made | Phase::Initialising)
    }
}
