//! Gears, pulleys and other wheels that turn with the crank.

use super::reader::Reader;
use crate::document::Section;
use lanchester_diagnostic::Mistake;
use lanchester_model::{Gear, GearDisc};

/// Keys of a gear's shape.
const SHAPE: [&str; 4] = ["diameter", "width", "density", "bore"];

impl<'a> Reader<'a> {
    pub(super) fn gears(&mut self) -> Option<Vec<Gear>> {
        let sections = self.root.tables("gear").or(&[])?;
        let gears: Vec<Option<Gear>> =
            sections.iter().enumerate().map(|(index, section)| self.gear(index, section)).collect();
        self.check_unique_parts("gear", sections, &gears, |gear| &gear.name);
        gears.into_iter().collect()
    }

    fn gear(&mut self, index: usize, section: &'a Section) -> Option<Gear> {
        let name = section.text("name").or(format!("gear {}", index + 1));
        let ratio = self.required(section, "ratio", section.ratio("ratio"));
        let [x, y] = ["x", "y"].map(|key| section.number(key).or(0.0));
        let inertia = super::simulation::optional(section.number("inertia"));
        let shape = SHAPE.into_iter().find(|key| section.has(key));
        if let (true, Some(key)) = (section.has("inertia"), shape) {
            self.two_sources(section, "inertia", key, "the inertia of the gear");
            return None;
        }
        if !section.has("inertia") && shape.is_none() {
            self.missing(
                section.span.clone(),
                "a gear needs its `inertia`, or `diameter`, `width` and `density`".into(),
                section.example("inertia"),
            );
            return None;
        }
        let disc = match shape {
            Some(_) => Some(self.gear_disc(section)?),
            None => None,
        };
        Some(Gear { name: name?, ratio: ratio?, x: x?, y: y?, inertia: inertia?, disc })
    }

    fn gear_disc(&mut self, section: &'a Section) -> Option<GearDisc> {
        let [diameter, width] =
            ["diameter", "width"].map(|key| self.required(section, key, section.number(key)));
        let mut density = self.density(section);
        if density == Some(None) {
            density = self.required(section, "density", section.number("density")).map(Some);
        }
        let bore = section.number("bore").or(0.0);
        let disc = GearDisc { diameter: diameter?, bore: bore?, width: width?, density: density?? };
        if disc.bore >= disc.diameter {
            self.mistakes.push(
                Mistake::error(
                    "E0905",
                    section.value_span("bore"),
                    "the bore of the gear is as large as the gear",
                )
                .hint("give a smaller bore: both are diameters"),
            );
            return None;
        }
        Some(disc)
    }
}
