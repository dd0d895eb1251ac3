//! `[crank.body]`: journals, pins and webs.

use super::crank::DraftThrow;
use super::{Drafts, Reader};
use crate::crank_body::CrankBody;
use crate::diagnostic::Mistake;
use crate::document::{Field, Section};
use crate::quantity::{self, Dimension};

/// Webs that overlap by less [m] touch.
const TOUCH: f64 = 1e-9;

/// `[crank.body]`: the outer `None` says bad, the inner one absent.
pub(super) type MaybeBody = Option<Option<CrankBody>>;

impl DraftThrow {
    /// Takes its unbalance from the body; what stops that is reported elsewhere.
    pub(super) fn weigh(&mut self, body: &MaybeBody) {
        if let (Some(Some(body)), Some(webs)) = (body, self.throw.webs)
            && let Ok(unbalance) = body.throw_unbalance(self.throw.radius, webs)
        {
            self.throw.unbalance = unbalance;
        }
    }
}

impl<'a> Reader<'a> {
    fn body_section(&self) -> Option<&'a Section> {
        self.section("crank").0?.table("body").given()
    }

    /// The body as far as it can be told without the throws.
    pub(super) fn crank_body(&mut self) -> MaybeBody {
        let (crank, broken) = self.section("crank");
        let Some(crank) = crank else { return (!broken).then_some(None) };
        let section = match crank.table("body") {
            Field::Absent => return Some(None),
            Field::Bad => return None,
            Field::Given(spot) => spot.value,
        };
        let mut density = self.density(section);
        if density == Some(None) {
            density = self.required(section, "density", section.number("density")).map(Some);
        }
        let [journal_diameter, pin_diameter, web_thickness, web_radius, pin_end_radius] =
            ["journal_diameter", "pin_diameter", "web_thickness", "web_radius", "pin_end_radius"]
                .map(|key| self.required(section, key, section.number(key)));
        let [journal_bore, pin_bore] = ["journal_bore", "pin_bore"].map(|key| section.number(key).or(0.0));
        let end_journals = self.end_journals(section);
        let pairs = [
            ("journal_bore", journal_bore, journal_diameter, false, "the journal"),
            ("pin_bore", pin_bore, pin_diameter, false, "the crankpin"),
            ("journal_diameter", journal_diameter, web_radius.map(|r| 2.0 * r), true, "the disc of the web"),
            ("pin_diameter", pin_diameter, pin_end_radius.map(|r| 2.0 * r), true, "the end of the web"),
        ];
        for (key, inner, outer, may_be_equal, what) in pairs {
            let (Some(inner), Some(outer)) = (inner, outer) else { continue };
            if inner < outer || (may_be_equal && inner == outer) {
                continue;
            }
            let [inner, outer] = [inner, outer].map(|value| quantity::readable(value, Dimension::Length));
            self.mistakes.push(
                Mistake::error(
                    "E0905",
                    section.value_span(key),
                    format!("`{key}` of {inner} does not fit into {what}, whose diameter is {outer}"),
                )
                .hint("check both: diameters of journals and pins, but radii of webs, are given"),
            );
        }
        Some(Some(CrankBody {
            density: density??,
            journal_diameter: journal_diameter?,
            journal_bore: journal_bore?,
            pin_diameter: pin_diameter?,
            pin_bore: pin_bore?,
            web_thickness: web_thickness?,
            web_radius: web_radius?,
            pin_end_radius: pin_end_radius?,
            end_journals: end_journals?,
        }))
    }

    fn end_journals(&mut self, section: &'a Section) -> Option<[f64; 2]> {
        let key = "end_journals";
        let lengths = self.required(section, key, section.numbers(key))?;
        match lengths.as_slice() {
            [both] => Some([both.value; 2]),
            [front, rear] => Some([front.value, rear.value]),
            other => {
                let message = format!("`{key}` needs one or two lengths, got {}", other.len());
                self.mistakes.push(
                    Mistake::error("E0206", section.value_span(key), message).hint(section.example(key)),
                );
                None
            }
        }
    }

    /// Webs and pins must have room along the crank, and a web must be a hull of two discs.
    pub(super) fn check_body(&mut self, body: &MaybeBody, drafts: &Drafts<'a>) {
        let (Some(Some(body)), Some(section)) = (body, self.body_section()) else { return };
        let throws = || drafts.throws.iter().enumerate().filter_map(|(k, t)| Some((k, t.as_ref()?)));
        if let Some((index, _)) = throws().find(|(_, draft)| draft.web_distance.is_none()) {
            self.missing(
                section.span.clone(),
                format!("[crank.body] needs the distance of the webs of throw {}", index + 1),
                "add web_distance = \"44 mm\" to [crank] or to the throw".into(),
            );
        }
        for (index, draft) in throws() {
            if let Err(error) = body.web(draft.throw.radius) {
                self.impossible_number(section, "pin_end_radius", &error);
            }
            if let Some(distance) = draft.web_distance
                && distance <= body.web_thickness
            {
                let [distance, thickness] =
                    [distance, body.web_thickness].map(|value| quantity::readable(value, Dimension::Length));
                self.mistakes.push(
                    Mistake::error(
                        "E0905",
                        section.value_span("web_thickness"),
                        format!(
                            "webs {thickness} thick leave no crankpin on throw {}: their middles stand {distance} apart",
                            index + 1
                        ),
                    )
                    .related(draft.web_span.clone(), "the web distance")
                    .hint("the crankpin is as long as the web distance less the web thickness"),
                );
            }
        }
        self.check_web_overlaps(body, section, drafts);
    }

    /// The rear web of each throw against the front web of the next on its crankshaft.
    fn check_web_overlaps(&mut self, body: &CrankBody, section: &'a Section, drafts: &Drafts<'a>) {
        let mut webs: Vec<(usize, &DraftThrow, [f64; 2])> = drafts
            .throws
            .iter()
            .enumerate()
            .filter_map(|(index, draft)| {
                let draft = draft.as_ref()?;
                Some((index, draft, draft.throw.webs?))
            })
            .collect();
        webs.sort_by(|a, b| {
            (a.1.throw.crankshaft.cmp(&b.1.throw.crankshaft)).then(a.1.throw.z.total_cmp(&b.1.throw.z))
        });
        for pair in webs.windows(2) {
            let [(one, front, [_, end]), (two, rear, [start, _])] = pair else { continue };
            let overlap = end + body.web_thickness - start;
            if front.throw.crankshaft != rear.throw.crankshaft || overlap <= TOUCH {
                continue;
            }
            let overlap = quantity::readable(overlap, Dimension::Length);
            self.mistakes.push(
                Mistake::error(
                    "E0904",
                    section.value_span("web_thickness"),
                    format!(
                        "webs {} and {} overlap by {overlap} along the crank: the rear one of throw {} and the front one of throw {}",
                        2 * one + 2,
                        2 * two + 1,
                        one + 1,
                        two + 1
                    ),
                )
                .related(rear.web_span.clone(), "the web distance")
                .hint("make the webs thinner or their distance smaller, or set the throws farther apart"),
            );
        }
    }
}
