//! `[crank.body]`: journals, pins and webs.

use crate::document::{Field, Section, Span};
use crate::read::crank::DraftThrow;
use crate::read::crank::details::{BodyDraft, MaybeBody};
use crate::read::drafts::Drafts;
use crate::read::reader::Reader;
use lanchester_diagnostic::Mistake;
use lanchester_model::Throw;
use lanchester_model::{CrankBody, CrankDetails, CrankPlace};
use lanchester_model::{TOUCH, pin, throw_unbalances};
use lanchester_units::{Dimension, readable};

/// How far a given unbalance of a throw and that of its body may differ, as a share of the larger one: what a drawing without its
/// fillets, oil bores and forging drafts misses.
const AGREE: f64 = 0.05;

/// From this share on it is told that they differ.
const TOLD: f64 = 0.01;

impl<'a> Reader<'a> {
    /// Takes the unbalances of the throws from the body; what stops that is reported elsewhere. What the file gives itself, weighed or
    /// from a drawing, counts instead, and must agree with the body.
    pub(in crate::read) fn weigh(
        &mut self,
        throws: &mut [Throw],
        weighed: &[Option<Span>],
        body: &BodyDraft,
    ) -> Option<()> {
        let Some(Some(uniform)) = &body.uniform else { return Some(()) };
        let Ok(unbalances) = throw_unbalances(uniform, &body.details, throws) else { return Some(()) };
        let body_key =
            self.section("crank").0.filter(|crank| crank.has("body")).map(|crank| crank.key_span("body"));
        // What [crank] gives counts for all throws, and is told once.
        let mut told: Vec<(Span, bool)> = Vec::new();
        for (index, (throw, found)) in throws.iter_mut().zip(unbalances).enumerate() {
            let Some(span) = weighed.get(index).cloned().flatten() else {
                throw.unbalance = found.unbalance;
                throw.unbalance_offset = found.offset;
                continue;
            };
            let off = (throw.unbalance - found.unbalance).abs();
            let largest = throw.unbalance.abs().max(found.unbalance.abs());
            let own = (span.clone(), off > AGREE * largest);
            if throw.webs.is_none() || off <= TOLD * largest || told.contains(&own) {
                continue;
            }
            let [given, of_body] =
                [throw.unbalance, found.unbalance].map(|own| readable(own, Dimension::Unbalance));
            let what = format!(
                "throw {} has an unbalance of {given} here, but {of_body} by [crank.body]",
                index + 1
            );
            let mut mistake = match own.1 {
                true => Mistake::error("E0203", span, format!("{what}: they must agree to 5 %"))
                    .hint("keep one of the two, or correct masses or sizes"),
                false => Mistake::warning("W0203", span, format!("{what}: the first counts"))
                    .hint("keep one of the two if they should be one"),
            }
            .label("second source");
            if let Some(body) = &body_key {
                mistake = mistake.related(body.clone(), "first source");
            }
            self.mistakes.push(mistake);
            told.push(own);
        }
        let agrees = !told.iter().any(|(_, is_error)| *is_error);
        agrees.then_some(())
    }

    pub(in crate::read) fn body_section(&self) -> Option<&'a Section> {
        self.section("crank").0?.table("body").given()
    }

    /// The body as far as it can be told without the throws.
    pub(in crate::read) fn crank_body(&mut self) -> MaybeBody {
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
            let [inner, outer] = [inner, outer].map(|value| readable(value, Dimension::Length));
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
    pub(in crate::read) fn check_body(&mut self, draft_of: &BodyDraft, drafts: &Drafts<'a>) {
        let (Some(Some(body)), Some(section)) = (&draft_of.uniform, self.body_section()) else { return };
        let throws = || drafts.throws.iter().enumerate().filter_map(|(k, t)| Some((k, t.as_ref()?)));
        if let Some((index, _)) = throws().find(|(_, draft)| draft.throw.webs.is_none()) {
            self.missing(
                section.span.clone(),
                format!("[crank.body] needs the distance of the webs of throw {}", index + 1),
                "add web_distance = \"44 mm\" to [crank] or to the throw".into(),
            );
        }
        for (index, draft) in throws() {
            for web in [2 * index, 2 * index + 1] {
                if let Some(Some(own)) = draft_of.at_web(Some(web))
                    && let Err(error) = own.web(draft.throw.radius)
                {
                    let span = self.place_span(section, CrankPlace::Web(web), "pin_end_radius");
                    self.impossible_size(section, "pin_end_radius", span, &error);
                    break;
                }
            }
            if let Some(distance) = draft.web_distance
                && distance <= body.web_thickness
            {
                let [distance, thickness] =
                    [distance, body.web_thickness].map(|value| readable(value, Dimension::Length));
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
        self.check_web_overlaps(body, &draft_of.details, section, drafts);
    }

    /// The rear web of each throw against the front web of the next on its crankshaft: apart, or one web.
    fn check_web_overlaps(
        &mut self,
        body: &CrankBody,
        details: &CrankDetails,
        section: &'a Section,
        drafts: &Drafts<'a>,
    ) {
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
            let [rear_web, front_web] = [2 * one + 1, 2 * two];
            let thickness = [rear_web, front_web].map(|web| details.at_web(body, web).web_thickness / 2.0);
            let overlap = end + (thickness[0] + thickness[1]) - start;
            if front.throw.crankshaft != rear.throw.crankshaft || overlap <= TOUCH {
                continue;
            }
            if *end >= *start - TOUCH {
                self.check_shared_web(body, section, [(*one, front), (*two, rear)]);
                continue;
            }
            let overlap = readable(overlap, Dimension::Length);
            self.mistakes.push(
                Mistake::error(
                    "E0904",
                    self.place_span(section, CrankPlace::Web(front_web), "thickness"),
                    format!(
                        "webs {} and {} overlap by {overlap} along the crank: the rear one of throw {} and the front one of throw {}",
                        2 * one + 2,
                        2 * two + 1,
                        one + 1,
                        two + 1
                    ),
                )
                .related(rear.web_span.clone(), "the web distance")
                .hint(format!(
                    "make the webs thinner or their distance smaller, or set the throws farther apart; for one web between both pins the web distance is the distance of the throws, {}, or more",
                    readable(rear.throw.z - front.throw.z, Dimension::Length)
                )),
            );
        }
    }

    /// Two pins with one web between them must not overlap along the crank, and must touch where nothing is between them.
    fn check_shared_web(
        &mut self,
        body: &CrankBody,
        section: &'a Section,
        [(one, front), (two, rear)]: [(usize, &DraftThrow); 2],
    ) {
        let (Some([_, end]), Some([start, _])) = (front.throw.webs, rear.throw.webs) else { return };
        let thickness = body.web_thickness - (end - start);
        let [front_pin, rear_pin] = [front, rear].map(|draft| pin(&draft.throw));
        let (message, hint) = if thickness < -TOUCH {
            let overlap = readable(-thickness, Dimension::Length);
            let most = rear.throw.z - front.throw.z + body.web_thickness;
            (
                format!("crankpins {} and {} overlap by {overlap} along the crank", one + 1, two + 1),
                format!(
                    "set the throws farther apart, or make the web distance smaller: with {} the pins touch, with less a web is between them",
                    readable(most, Dimension::Length)
                ),
            )
        } else if thickness <= TOUCH && (rear_pin - front_pin).norm() >= body.pin_diameter {
            (
                format!(
                    "nothing joins crankpins {} and {}: no web is between them and they do not overlap across",
                    one + 1,
                    two + 1
                ),
                "make the web distance smaller: what is missing becomes a web between the pins".to_owned(),
            )
        } else {
            return;
        };
        self.mistakes.push(
            Mistake::error("E0904", section.value_span("web_thickness"), message)
                .related(rear.web_span.clone(), "the web distance")
                .hint(hint),
        );
    }
}
