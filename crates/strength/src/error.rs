//! What the sheet needs and the engine does not say.

use serde::Serialize;
use std::fmt;

/// A number that the engine does not give.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, schemars::JsonSchema)]
pub struct Need {
    /// Where: "pin 2", "throws 1 and 2".
    pub place: String,
    /// What was needed, and what there is.
    pub what: String,
    /// What gives it.
    pub remedy: String,
}

impl fmt::Display for Need {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}; {}", self.place, self.what, self.remedy)
    }
}

/// Why there is no sheet.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StrengthError {
    /// The engine has no crankshaft by elements.
    #[error(
        "formulas after UR M53 need the crankshaft as a body: {0}\nhint: give journals, pins and webs in [crank.body]"
    )]
    NoBody(#[from] lanchester_model::CrankElementsFault),
    /// All that is missing.
    #[error("formulas after UR M53 need more of crankshaft {crankshaft}:{}", listed(.needs))]
    Needs {
        /// Its number, from 1.
        crankshaft: usize,
        /// What is missing, all at once.
        needs: Vec<Need>,
    },
    /// Loads that do not fit the throws.
    #[error("loads of {needed} throws with the same number of angles each are needed, got {got}")]
    Loads {
        /// Throws of the crankshaft.
        needed: usize,
        /// What came, in words.
        got: String,
    },
}

fn listed(needs: &[Need]) -> String {
    needs.iter().map(|need| format!("\n  {need}")).collect()
}
