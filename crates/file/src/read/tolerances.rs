//! `[tolerances]`.

use super::reader::Reader;
use crate::document::{Field, Section};
use lanchester_diagnostic::Mistake;
use lanchester_model::Engine;
use lanchester_task::{Distribution, Extent, Tolerance, Varied};

/// Standard deviations in a half width: least and most.
const SIGMAS: [f64; 2] = [0.1, 8.0];

impl<'a> Reader<'a> {
    /// `[tolerances]` and `[tolerances.common]`, in the order of the reference; none where the file gives none.
    pub(super) fn tolerances(&mut self) -> Option<Vec<Tolerance>> {
        let (section, broken) = self.section("tolerances");
        let Some(section) = section else { return (!broken).then(Vec::new) };
        let mut found = self.tolerances_of(section, Extent::PerPart)?;
        match section.table("common") {
            Field::Absent => {}
            Field::Bad => return None,
            Field::Given(common) => found.extend(self.tolerances_of(common.value, Extent::Common)?),
        }
        Some(found)
    }

    fn tolerances_of(&mut self, section: &'a Section, extent: Extent) -> Option<Vec<Tolerance>> {
        let mut found = Some(Vec::new());
        for quantity in Varied::ALL {
            let one = match section.table(quantity.key()) {
                Field::Absent => continue,
                Field::Bad => None,
                Field::Given(spot) => self.tolerance(spot.value, quantity, extent),
            };
            // All mistakes are told, not the first alone.
            found = found.zip(one).map(|(mut list, one)| {
                list.push(one);
                list
            });
        }
        found
    }

    fn tolerance(&mut self, section: &'a Section, quantity: Varied, extent: Extent) -> Option<Tolerance> {
        let half_width = self.required(section, "plus_minus", section.number("plus_minus"));
        let sigmas = match section.number("sigmas") {
            Field::Given(spot) if (SIGMAS[0]..=SIGMAS[1]).contains(&spot.value) => Some(spot.value),
            Field::Given(spot) => {
                let message =
                    format!("`sigmas` must lie between {} and {}, got {}", SIGMAS[0], SIGMAS[1], spot.value);
                self.mistakes.push(
                    Mistake::error("E1501", spot.span, message)
                        .label("out of range")
                        .hint("3 where nothing else is known; 4 or more for a process in good control"),
                );
                None
            }
            Field::Absent => Some(3.0),
            Field::Bad => None,
        };
        let distribution = match section.word("distribution").or("normal")? {
            "uniform" => {
                if section.has("sigmas") {
                    self.without_effect(section, "sigmas", "the distribution is uniform", "leave it out");
                }
                Distribution::Uniform
            }
            _ => Distribution::Normal { sigmas: sigmas? },
        };
        Some(Tolerance { quantity, half_width: half_width?, distribution, extent })
    }

    /// Tolerances need the parts that they are on.
    pub(super) fn check_tolerances(&mut self, tolerances: &[Tolerance], engine: &Engine) {
        let (Some(section), _) = self.section("tolerances") else { return };
        for tolerance in tolerances.iter().filter(|t| t.quantity.parts(engine) == 0) {
            let part = tolerance.quantity;
            let within = match tolerance.extent {
                Extent::PerPart => Some(section),
                Extent::Common => section.table("common").given(),
            };
            let span = within.map_or(0..0, |within| within.key_span(part.key()));
            let (what, add) = match part {
                Varied::ShaftUnbalance | Varied::ShaftPhase => ("balance shaft", "[[shaft]]"),
                _ => ("counterweight", "[[counterweight]]"),
            };
            self.mistakes.push(
                Mistake::warning(
                    "W1501",
                    span,
                    format!("a tolerance of the {}, but the engine has no {what}", part.name()),
                )
                .hint(format!("add {add}, or leave the tolerance out")),
            );
        }
    }
}
