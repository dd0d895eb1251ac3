//! Strength of crankshafts by formulas: tables and words.

pub(crate) mod rule;
pub(crate) mod rule_tables;

pub use rule::{CRANK_RULE_VERSION, CrankRule, SpeedSheet, ThrowMesh, rule_section, rule_text};
pub use rule_tables::rule_csv;
