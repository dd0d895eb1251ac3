//! `[clearance]`: what the crankshaft must stay clear of.

use super::drafts::Drafts;
use super::reader::Reader;
use crate::document::{Field, Section};
use lanchester_diagnostic::Mistake;
use lanchester_model::{Envelope, Liner, RodEnvelope, Skirt};

/// Keys that say nothing one without the others.
const LINER: [&str; 2] = ["liner_end", "liner_wall"];
const ROD: [&str; 4] = ["big_end_radius", "big_end_width", "shank_width", "shank_thickness"];

/// `[clearance]`: the outer `None` says bad, the inner one absent.
pub(super) type MaybeEnvelope = Option<Option<Envelope>>;

impl<'a> Reader<'a> {
    pub(super) fn clearance(&mut self) -> MaybeEnvelope {
        let (section, broken) = self.section("clearance");
        let Some(section) = section else { return (!broken).then_some(None) };
        let [least, crankcase_radius, skirt_length, skirt_width] =
            ["least", "crankcase_radius", "skirt_length", "skirt_width"].map(|key| optional(section, key));
        if section.has("skirt_width") && !section.has("skirt_length") && self.whole {
            let hint = section.example("skirt_length");
            self.without_effect(section, "skirt_width", "`skirt_length` is missing", &hint);
        }
        let liner = self.together(section, LINER);
        let rod = self.together(section, ROD);
        let envelope = Envelope {
            least: least?,
            crankcase_radius: crankcase_radius?,
            skirt: skirt_length?.zip(Some(skirt_width?)).map(|(length, width)| Skirt { length, width }),
            liner: liner?.map(|[end, wall]| Liner { end, wall }),
            rod: rod?.map(|[big_end_radius, big_end_width, shank_width, shank_thickness]| RodEnvelope {
                big_end_radius,
                big_end_width,
                shank_width,
                shank_thickness,
            }),
        };
        if envelope == Envelope::default() && !section.has("skirt_width") {
            self.mistakes.push(
                Mistake::warning("W0204", section.span.clone(), "[clearance] says nothing")
                    .hint("leave it out, or give what the crankshaft must stay clear of"),
            );
        }
        Some(Some(envelope))
    }

    /// Lengths of which all or none are needed.
    fn together<const N: usize>(
        &mut self,
        section: &'a Section,
        keys: [&'static str; N],
    ) -> Option<Option<[f64; N]>> {
        let Some(there) = keys.into_iter().find(|key| section.has(key)) else { return Some(None) };
        for gone in keys.into_iter().filter(|key| !section.has(key)) {
            self.missing(
                section.key_span(there),
                format!("`{there}` needs `{gone}` beside it"),
                section.example(gone),
            );
        }
        let values: Option<Vec<f64>> = keys.into_iter().map(|key| section.number(key).given()).collect();
        values.and_then(|values| values.try_into().ok()).map(Some)
    }

    /// Skirts and liners are of the diameter of the bore.
    pub(super) fn check_bores(&mut self, envelope: &MaybeEnvelope, drafts: &Drafts<'a>) {
        let Some(section) = self.section("clearance").0 else { return };
        let Some(Some(envelope)) = envelope else { return };
        let needs = [("skirt_length", envelope.skirt.is_some()), ("liner_end", envelope.liner.is_some())];
        let mut cylinders = drafts.cylinders.iter().enumerate();
        let bare = cylinders.find(|(_, draft)| draft.as_ref().is_some_and(|d| d.cylinder.bore.is_none()));
        let Some((index, _)) = bare else { return };
        for (key, _) in needs.into_iter().filter(|(_, is_needed)| *is_needed) {
            self.missing(
                section.key_span(key),
                format!("`{key}` needs the bore of cylinder {}", index + 1),
                "add bore = \"79.5 mm\" to [piston] or to the cylinder".into(),
            );
        }
    }
}

fn optional(section: &Section, key: &str) -> Option<Option<f64>> {
    match section.number(key) {
        Field::Given(spot) => Some(Some(spot.value)),
        Field::Absent => Some(None),
        Field::Bad => None,
    }
}
