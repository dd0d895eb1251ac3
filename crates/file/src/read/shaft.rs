//! Balance shafts.

pub(in crate::read) mod part;

use super::Reader;
use crate::document::Section;
use lanchester_diagnostic::Mistake;
use lanchester_model::ShaftWeightPart;
use lanchester_model::{BalanceShaft, ShaftWeight};
use lanchester_units::Dimension;

/// Weights that overlap by less [m] touch.
const TOUCH: f64 = 1e-9;

impl<'a> Reader<'a> {
    pub(super) fn shafts(&mut self) -> Option<Vec<BalanceShaft>> {
        let sections = self.root.tables("shaft").or(&[])?;
        let shafts: Vec<Option<BalanceShaft>> =
            sections.iter().enumerate().map(|(index, section)| self.shaft(index, section)).collect();
        self.check_unique_parts("shaft", sections, &shafts, |shaft| &shaft.name);
        shafts.into_iter().collect()
    }

    fn shaft(&mut self, index: usize, section: &'a Section) -> Option<BalanceShaft> {
        let name = section.text("name").or(format!("shaft {}", index + 1));
        let ratio = self.required(section, "ratio", section.ratio("ratio"));
        let [x, y] = ["x", "y"].map(|key| section.number(key).or(0.0));
        let inertia = super::simulation::optional(section.number("inertia"));
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
        let tables = weights?;
        let weights: Vec<Option<ShaftWeight>> =
            tables.iter().map(|section| self.shaft_weight(section)).collect();
        self.check_weights_apart(tables, &weights);
        Some(BalanceShaft {
            name: name?,
            ratio: ratio?,
            x: x?,
            y: y?,
            weights: weights.into_iter().collect::<Option<Vec<ShaftWeight>>>()?,
            inertia: inertia?,
        })
    }

    /// Weights of one shaft that are parts and share metal, which then counts twice.
    fn check_weights_apart(&mut self, tables: &[Section], weights: &[Option<ShaftWeight>]) {
        let parts: Vec<(usize, &ShaftWeight, &ShaftWeightPart)> = weights
            .iter()
            .enumerate()
            .filter_map(|(index, weight)| {
                let weight = weight.as_ref()?;
                Some((index, weight, weight.part.as_ref()?))
            })
            .collect();
        for (number, (one, first, front)) in parts.iter().enumerate() {
            for (two, second, rear) in &parts[number + 1..] {
                let apart = (first.z - second.z).abs();
                let overlap = ((front.length + rear.length) / 2.0 - apart).min(front.length).min(rear.length);
                if overlap <= TOUCH || !front.shape.meets(&rear.shape, second.phase - first.phase) {
                    continue;
                }
                let overlap = lanchester_units::readable(overlap, Dimension::Length);
                let message = format!(
                    "weights {} and {} of one shaft overlap by {overlap} along it: what both have counts twice",
                    one + 1,
                    two + 1
                );
                self.mistakes.push(
                    Mistake::warning("W0902", tables[*two].value_span("z"), message)
                        .related(tables[*one].value_span("z"), "the other weight")
                        .hint("set them farther apart, or make them shorter"),
                );
            }
        }
    }
}
