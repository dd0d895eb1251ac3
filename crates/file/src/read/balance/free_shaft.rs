//! Balance shafts that may be fitted.

use super::Reader;
use super::free_weight::{DraftFreeWeight, FreePlace, PLACE_TO_BE_FOUND};
use crate::document::{Section, Span};
use lanchester_diagnostic::Mistake;
use lanchester_task::{FreeShaft, Place};

/// The shafts, what each costs if it is used, and the weights of all of them.
type Shafts = (Vec<(FreeShaft, Span)>, Vec<f64>, Vec<DraftFreeWeight>);

impl<'a> Reader<'a> {
    /// The shafts, and the weights of all of them.
    pub(super) fn free_shafts(&mut self, section: &'a Section) -> Option<Shafts> {
        let sections = section.tables("shaft").or(&[])?;
        let read: Vec<_> =
            sections.iter().enumerate().map(|(index, section)| self.free_shaft(index, section)).collect();
        let (mut shafts, mut costs, mut weights) = (Vec::new(), Vec::new(), Vec::new());
        for (found, section) in read.into_iter().zip(sections) {
            let (shaft, cost, own) = found?;
            costs.push(cost);
            shafts.push((shaft, section.span.clone()));
            weights.extend(own);
        }
        if costs.iter().all(|cost| *cost == 0.0) {
            costs.clear();
        }
        Some((shafts, costs, weights))
    }

    fn free_shaft(
        &mut self,
        index: usize,
        section: &'a Section,
    ) -> Option<(FreeShaft, f64, Vec<DraftFreeWeight>)> {
        let cost = section.number("fixed_cost").or(0.0);
        let name = section.text("name").or(format!("free shaft {}", index + 1));
        let ratio = self.required(section, "ratio", section.ratio("ratio"));
        let [x, y] = ["x", "y"].map(|key| self.place(section, key, Some(0.0)));
        let optional = section.truth("optional").or(false);
        let sections = self.required(section, "weights", section.tables("weights"));
        if sections.is_some_and(<[Section]>::is_empty) {
            self.mistakes.push(
                Mistake::warning(
                    "W0204",
                    section.value_span("weights"),
                    "a shaft without weights does nothing",
                )
                .hint(section.example("weights")),
            );
        }
        let is_found = |place: &Option<Place>| matches!(place, Some(Place::Between(..)));
        let why = if optional == Some(true) {
            Some("a weight on an optional shaft")
        } else if is_found(&x) || is_found(&y) {
            Some("a weight on a shaft whose place is to be found")
        } else {
            None
        };
        let weights: Vec<Option<DraftFreeWeight>> = sections?
            .iter()
            .enumerate()
            .map(|(place, section)| {
                let z = self.place(section, "z", None);
                let why = if is_found(&z) { Some(PLACE_TO_BE_FOUND) } else { why };
                let own = self.properties(section, "phase", why)?;
                let name = own.name.clone().unwrap_or(format!("{} {}", name.as_deref()?, place + 1));
                Some(DraftFreeWeight { name, place: FreePlace::Shaft { shaft: index, z: z? }, own })
            })
            .collect();
        let weights: Vec<DraftFreeWeight> = weights.into_iter().collect::<Option<_>>()?;
        let shaft = FreeShaft { name: name?, ratio: ratio?, x: x?, y: y?, optional: optional? };
        Some((shaft, cost?, weights))
    }
}
