//! Bars of a published figure: one value a case, from values that were computed for it.

use crate::kit::figure::Panel;
use crate::kit::plot::{Bar, CaseBars};

/// Bars over numbered cases.
#[derive(Debug, Clone, PartialEq)]
pub struct PublishedBars {
    /// What the ordinate is.
    pub quantity: String,
    /// Its SI unit.
    pub unit: String,
    /// Number of the case and value in SI, not negative.
    pub cases: Vec<(f64, f64)>,
    /// A level to compare with: its name and value in SI.
    pub level: Option<(String, f64)>,
}

impl PublishedBars {
    /// Draws them.
    pub fn panel(&self) -> Panel {
        let bars = self.cases.iter().map(|&(at, value)| Bar { at, value }).collect();
        let level = self.level.as_ref().map(|(name, value)| (name.as_str(), *value));
        CaseBars { quantity: &self.quantity, unit: &self.unit, case: "case", bars, level }.panel()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_level_is_told_and_reaches_into_the_drawing() {
        let bars = |level| PublishedBars {
            quantity: "F".to_owned(),
            unit: "N".to_owned(),
            cases: vec![(1.0, 5.0), (9.0, 2.0)],
            level,
        };
        let (without, with) = (bars(None).panel(), bars(Some(("half the four".to_owned(), 8.0))).panel());
        assert!(without.description.contains("1 5.00; 9 2.00"), "{}", without.description);
        assert!(with.description.contains("half the four 8.00"), "{}", with.description);
        assert_ne!(without, with);
    }
}
