//! Balance shafts.

use super::Reader;
use crate::diagnostic::Mistake;
use crate::document::Section;
use crate::engine::{BalanceShaft, ShaftWeight};

impl<'a> Reader<'a> {
    pub(super) fn shafts(&mut self) -> Option<Vec<BalanceShaft>> {
        let sections = self.root.tables("shaft").or(&[])?;
        let shafts: Vec<Option<BalanceShaft>> =
            sections.iter().enumerate().map(|(index, section)| self.shaft(index, section)).collect();
        shafts.into_iter().collect()
    }

    fn shaft(&mut self, index: usize, section: &'a Section) -> Option<BalanceShaft> {
        let name = section.text("name").or(format!("shaft {}", index + 1));
        let ratio = self.required(section, "ratio", section.ratio("ratio"));
        let [x, y] = ["x", "y"].map(|key| section.number(key).or(0.0));
        let weights = self.required(section, "weights", section.tables("weights"));
        if weights.is_some_and(<[Section]>::is_empty) {
            self.mistakes.push(
                Mistake::warning(
                    "W0204",
                    section.value_span("weights"),
                    "a shaft without weights does nothing",
                )
                .hint(section.example("weights")),
            );
        }
        let weights: Vec<Option<ShaftWeight>> =
            weights?.iter().map(|section| self.shaft_weight(section)).collect();
        Some(BalanceShaft {
            name: name?,
            ratio: ratio?,
            x: x?,
            y: y?,
            weights: weights.into_iter().collect::<Option<Vec<ShaftWeight>>>()?,
        })
    }
}
