//! What a balancing machine shows.

use crate::document::{Field, Section};
use crate::read::Reader;
use lanchester_diagnostic::Mistake;
use lanchester_task::workshop::{Display, DisplayKind, Plane};
use std::f64::consts::PI;

impl<'a> Reader<'a> {
    pub(super) fn displays(&mut self, planes: Option<&[Plane]>) -> Option<Vec<Display>> {
        let sections = self.root.tables("display").or(&[])?;
        let displays: Vec<Option<Display>> =
            sections.iter().map(|section| self.display(section, planes)).collect();
        displays.into_iter().collect()
    }

    fn display(&mut self, section: &'a Section, planes: Option<&[Plane]>) -> Option<Display> {
        let unbalance = self.required(section, "unbalance", section.number("unbalance"));
        let angle = self.required(section, "angle", section.number("angle"));
        let spot = section.word("spot").or("heavy");
        let kind = match section.word("kind").or("plane")? {
            "couple" => self.couple_planes(section),
            _ => self.display_plane(section, planes),
        };
        let turned = if spot? == "light" { PI } else { 0.0 };
        Some(Display { kind: kind?, unbalance: unbalance?, angle: angle? + turned })
    }

    fn couple_planes(&mut self, section: &'a Section) -> Option<DisplayKind> {
        for key in ["plane", "z"] {
            if section.has(key) {
                self.without_effect(section, key, "a couple stands in two planes", "write planes = [..]");
            }
        }
        let places = self.required(section, "planes", section.numbers("planes"))?;
        match places.as_slice() {
            [first, second] if first.value != second.value => {
                Some(DisplayKind::Couple { z: [first.value, second.value] })
            }
            other => {
                let message = format!("a couple needs two planes apart, got {}", other.len());
                let span = section.value_span("planes");
                self.mistakes.push(Mistake::error("E0206", span, message).hint(section.example("planes")));
                None
            }
        }
    }

    fn display_plane(&mut self, section: &'a Section, planes: Option<&[Plane]>) -> Option<DisplayKind> {
        if section.has("planes") {
            self.without_effect(
                section,
                "planes",
                "an unbalance of kind \"plane\" stands in one",
                "write kind = \"couple\", or one plane",
            );
        }
        let (plane, z) = (section.text("plane"), section.number("z"));
        if section.has("plane") && section.has("z") {
            self.two_sources(section, "plane", "z", "the place of the unbalance");
            return None;
        }
        match (plane, z) {
            (_, Field::Given(z)) => Some(DisplayKind::Plane { z: z.value }),
            (Field::Given(name), _) => {
                let planes = planes?;
                let names: Vec<String> = planes.iter().map(|plane| plane.name.clone()).collect();
                let plane = &planes[self.named(&name, &names, "plane")?];
                if plane.z.is_none() {
                    let message = format!("the place of plane \"{}\" along the shaft is missing", plane.name);
                    let hint = "add z = \"40 mm\" to the plane";
                    self.missing(name.span, message, hint.into());
                }
                plane.z.map(|z| DisplayKind::Plane { z })
            }
            (Field::Bad, _) | (_, Field::Bad) => None,
            _ => {
                self.missing(
                    section.span.clone(),
                    "the place of the unbalance is missing".into(),
                    "add plane = \"front\", or z = \"40 mm\"".into(),
                );
                None
            }
        }
    }
}
