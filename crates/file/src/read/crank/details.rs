//! Elements of the crankshaft that differ: `[[crank.body.journal]]`, `[[crank.body.pin]]`, `[[crank.body.web]]`, `[[crank.body.nose]]`,
//! `[[crank.body.flange]]`, and fillets and oil holes of all.

use crate::document::{Field, Section, Span};
use crate::read::crank::body::MaybeBody;
use crate::read::{Drafts, Reader};
use lanchester_diagnostic::Mistake;
use lanchester_model::{
    CrankBody, CrankDetails, CrankElementForm, CrankEnd, CrankFault, CrankPlace, EndStep, EngineParts,
    Fillet, JournalDetail, OilHole, PinDetail, SharedWeb, WebDetail, crank_faults,
};
use lanchester_units::{Dimension, readable};

/// The body with its details, while the engine is being read.
pub(in crate::read) struct BodyDraft {
    /// The uniform body.
    pub(in crate::read) uniform: MaybeBody,
    /// What differs; empty where there is a mistake in it.
    pub(in crate::read) details: CrankDetails,
    /// Whether the details are free of mistakes.
    is_good: bool,
}

/// Webs by index, with the places [m] where they stand.
type WebPlaces = Vec<(usize, f64)>;

impl BodyDraft {
    /// Sizes at a web, or the uniform ones.
    pub(in crate::read) fn at_web(&self, web: Option<usize>) -> MaybeBody {
        let at = |body: CrankBody| web.map_or(body, |web| self.details.at_web(&body, web));
        self.uniform.map(|body| body.map(at))
    }

    /// The details, if there are some; the outer `None` says bad.
    pub(in crate::read) fn into_details(self) -> Option<Option<CrankDetails>> {
        let is_empty = self.details == CrankDetails::default();
        self.is_good.then_some((!is_empty).then_some(self.details))
    }
}

impl<'a> Reader<'a> {
    /// The body with what differs; webs of the drafts get their places.
    pub(in crate::read) fn body_draft(
        &mut self,
        drafts: Option<&mut Drafts<'a>>,
        crankshafts: Option<usize>,
    ) -> BodyDraft {
        let uniform = self.crank_body();
        let bad = |uniform| BodyDraft { uniform, details: CrankDetails::default(), is_good: false };
        let Some(section) = self.body_section() else {
            return BodyDraft { uniform, details: CrankDetails::default(), is_good: true };
        };
        let throws = drafts.as_ref().map(|drafts| drafts.throws.len());
        let [pin_fillet, journal_fillet] = ["pin", "journal"].map(|kind| {
            let [radius, recess] =
                ["fillet", "recess"].map(|key| optional(section, &format!("{kind}_{key}")));
            Some(Fillet { radius: radius?, recess: recess?.unwrap_or(0.0) })
        });
        let oil_hole = self.oil_hole(section);
        let journals = self.journal_details(section, crankshafts);
        let pins = self.pin_details(section, throws);
        let webs = self.web_details(section, throws);
        let nose = self.end_steps(section, CrankEnd::Nose, crankshafts);
        let flange = self.end_steps(section, CrankEnd::Flange, crankshafts);
        let details = || {
            let (webs, places) = webs?;
            let mut ends = nose?;
            ends.extend(flange?);
            let details = CrankDetails {
                pin_fillet: pin_fillet?,
                journal_fillet: journal_fillet?,
                oil_hole: oil_hole?,
                journals: journals?,
                pins: pins?,
                webs,
                ends,
            };
            Some((details, places))
        };
        let Some((details, places)) = details() else { return bad(uniform) };
        if let (Some(Some(body)), Some(drafts)) = (&uniform, drafts)
            && !self.place_webs(body, &details, &places, section, drafts)
        {
            return bad(uniform);
        }
        BodyDraft { uniform, details, is_good: true }
    }

    fn oil_hole(&mut self, section: &'a Section) -> Option<Option<OilHole>> {
        match section.table("oil_hole") {
            Field::Absent => Some(None),
            Field::Bad => None,
            Field::Given(spot) => {
                let hole = spot.value;
                let diameter = self.required(hole, "diameter", hole.number("diameter"));
                let angle = hole.number("angle").or(0.0);
                Some(Some(OilHole { diameter: diameter?, angle: angle? }))
            }
        }
    }

    /// The elements that a table names, each once among all tables of its kind.
    fn numbers(
        &mut self,
        section: &'a Section,
        what: &str,
        count: Option<usize>,
        known: &mut Vec<(usize, usize, Span)>,
        crankshaft: usize,
    ) -> Option<Vec<usize>> {
        let numbers = self.required(section, "numbers", section.wholes("numbers"))?;
        let mut found = Vec::new();
        let mut is_good = true;
        for spot in numbers {
            let Some(index) = self.existing(spot.value, count, what, spot.span.clone()) else {
                is_good = false;
                continue;
            };
            if let Some((.., first)) = known.iter().find(|(of, seen, _)| (*of, *seen) == (crankshaft, index))
            {
                let message = format!("{what} {} has two tables", index + 1);
                self.mistakes.push(
                    Mistake::error("E0203", spot.span, message)
                        .label("second source")
                        .related(first.clone(), "first source")
                        .hint("join the two"),
                );
                is_good = false;
                continue;
            }
            known.push((crankshaft, index, spot.span));
            found.push(index);
        }
        is_good.then_some(found)
    }

    fn crankshaft_of(&mut self, section: &'a Section, crankshafts: Option<usize>) -> Option<usize> {
        let number = section.whole("crankshaft").or(1)?;
        self.existing(number, crankshafts, "crankshaft", section.value_span("crankshaft"))
    }

    fn journal_details(
        &mut self,
        section: &'a Section,
        crankshafts: Option<usize>,
    ) -> Option<Vec<JournalDetail>> {
        /// More journals than any crankshaft has: which there are is known later.
        const MANY: usize = 1000;
        let tables = section.tables("journal").or(&[])?;
        let (mut found, mut known, mut is_good) = (Vec::new(), Vec::new(), true);
        for own in tables {
            let Some(crankshaft) = self.crankshaft_of(own, crankshafts) else {
                is_good = false;
                continue;
            };
            let numbers = self.numbers(own, "journal", Some(MANY), &mut known, crankshaft);
            let sizes = ["diameter", "bore", "fillet", "recess"].map(|key| optional(own, key));
            let (Some(numbers), [Some(diameter), Some(bore), Some(fillet), Some(recess)]) = (numbers, sizes)
            else {
                is_good = false;
                continue;
            };
            found.extend(numbers.into_iter().map(|journal| JournalDetail {
                crankshaft,
                journal,
                diameter,
                bore,
                fillet,
                recess,
            }));
        }
        is_good.then_some(found)
    }

    fn pin_details(&mut self, section: &'a Section, throws: Option<usize>) -> Option<Vec<PinDetail>> {
        let tables = section.tables("pin").or(&[])?;
        let (mut found, mut known, mut is_good) = (Vec::new(), Vec::new(), true);
        for own in tables {
            let numbers = self.numbers(own, "pin", throws, &mut known, 0);
            let sizes = ["diameter", "bore", "fillet", "recess"].map(|key| optional(own, key));
            let hole = self.oil_hole(own);
            let (Some(numbers), [Some(diameter), Some(bore), Some(fillet), Some(recess)], Some(oil_hole)) =
                (numbers, sizes, hole)
            else {
                is_good = false;
                continue;
            };
            found.extend(numbers.into_iter().map(|throw| PinDetail {
                throw,
                diameter,
                bore,
                fillet,
                recess,
                oil_hole,
            }));
        }
        is_good.then_some(found)
    }

    /// Webs that differ, and the places [m] of those whose place is given, in the z of the file.
    fn web_details(
        &mut self,
        section: &'a Section,
        throws: Option<usize>,
    ) -> Option<(Vec<WebDetail>, WebPlaces)> {
        let tables = section.tables("web").or(&[])?;
        let (mut found, mut places, mut known, mut is_good) = (Vec::new(), Vec::new(), Vec::new(), true);
        for own in tables {
            let numbers = self.numbers(own, "web", throws.map(|count| 2 * count), &mut known, 0);
            let sizes = ["thickness", "radius", "pin_end_radius", "position"].map(|key| optional(own, key));
            let (Some(numbers), [Some(thickness), Some(radius), Some(pin_end_radius), Some(position)]) =
                (numbers, sizes)
            else {
                is_good = false;
                continue;
            };
            if let (Some(place), many @ 2..) = (position, numbers.len()) {
                let place = readable(place, Dimension::Length);
                let message = format!("{many} webs cannot stand in one place, {place}");
                self.mistakes.push(
                    Mistake::error("E0904", own.value_span("position"), message)
                        .hint("give each web a table of its own, or leave `position` out"),
                );
                is_good = false;
            }
            for web in numbers {
                places.extend(position.map(|place| (web, place)));
                if thickness.is_some() || radius.is_some() || pin_end_radius.is_some() {
                    found.push(WebDetail { web, thickness, radius, pin_end_radius });
                }
            }
        }
        is_good.then_some((found, places))
    }

    fn end_steps(
        &mut self,
        section: &'a Section,
        end: CrankEnd,
        crankshafts: Option<usize>,
    ) -> Option<Vec<EndStep>> {
        let key = if end == CrankEnd::Nose { "nose" } else { "flange" };
        let tables = section.tables(key).or(&[])?;
        let steps: Vec<Option<EndStep>> = tables
            .iter()
            .map(|own| {
                let [length, diameter] =
                    ["length", "diameter"].map(|key| self.required(own, key, own.number(key)));
                let bore = own.number("bore").or(0.0);
                let crankshaft = self.crankshaft_of(own, crankshafts);
                Some(EndStep {
                    crankshaft: crankshaft?,
                    end,
                    length: length?,
                    diameter: diameter?,
                    bore: bore?,
                })
            })
            .collect();
        steps.into_iter().collect()
    }

    /// Gives webs of another thickness or place theirs: without a place the face towards the pin stays. Whether it could.
    fn place_webs(
        &mut self,
        body: &CrankBody,
        details: &CrankDetails,
        places: &[(usize, f64)],
        section: &'a Section,
        drafts: &mut Drafts<'a>,
    ) -> bool {
        let planes = |drafts: &Drafts<'_>| -> Option<Vec<_>> {
            drafts.throws.iter().map(|draft| draft.as_ref().map(|draft| draft.throw.clone())).collect()
        };
        let before = planes(drafts).map(|throws| SharedWeb::all(&throws));
        for (index, draft) in drafts.throws.iter_mut().enumerate() {
            let Some(draft) = draft else { continue };
            for side in 0..2 {
                let web = 2 * index + side;
                draft.web_growth[side] = (details.at_web(body, web).web_thickness - body.web_thickness) / 2.0;
                draft.web_positions[side] =
                    places.iter().find(|(placed, _)| *placed == web).map(|(_, place)| *place);
            }
            draft.move_by(0.0);
        }
        let after = planes(drafts).map(|throws| SharedWeb::all(&throws));
        let mut is_good = true;
        for shared in before.iter().flatten() {
            for web in shared.webs() {
                let own = details.webs.iter().any(|own| own.web == web)
                    || places.iter().any(|(placed, _)| *placed == web);
                if own {
                    let message = format!(
                        "web {} joins crankpins {} and {}: its thickness and shape follow from the pins",
                        web + 1,
                        shared.front + 1,
                        shared.rear + 1
                    );
                    self.mistakes.push(
                        Mistake::error(
                            "E0904",
                            self.place_span(section, CrankPlace::Web(web), "numbers"),
                            message,
                        )
                        .hint("leave it out of [[crank.body.web]]"),
                    );
                    is_good = false;
                }
            }
        }
        if is_good
            && let (Some(before), Some(after)) = (before, after)
            && let Some(new) = after.iter().find(|shared| !before.contains(shared))
        {
            let [one, two] = new.webs();
            let message = format!("webs {} and {} pass through each other", one + 1, two + 1);
            self.mistakes.push(
                Mistake::error("E0904", self.place_span(section, CrankPlace::Web(two), "thickness"), message)
                    .hint("make them thinner, or set the throws farther apart"),
            );
            is_good = false;
        }
        is_good
    }

    /// Whether single elements fit together, once the whole engine is known.
    pub(in crate::read) fn check_elements(&mut self, parts: &EngineParts) {
        let (Some(section), Some(details)) = (self.body_section(), &parts.crank_details) else { return };
        for own in &details.journals {
            let Ok(elements) = parts.crank_elements(own.crankshaft) else { continue };
            let is_journal = |form: &CrankElementForm| matches!(form, CrankElementForm::Journal { .. });
            let count = elements.iter().filter(|element| is_journal(&element.form)).count();
            let place = CrankPlace::Journal { crankshaft: own.crankshaft, journal: own.journal };
            let span = self.place_span(section, place, "numbers");
            self.existing(own.journal as i64 + 1, Some(count), "journal", span);
        }
        // Webs that overlap are told with the throws, before the whole is known.
        for fault in crank_faults(parts).into_iter().filter(|fault| !fault.is_overlap()) {
            let CrankFault { place, key, bound, limit, got, remedy } = fault;
            let [limit, got] = [limit, got].map(|length| readable(length, Dimension::Length));
            let message = format!("`{key}` of {} must be {bound} {limit}, got {got}", place.name());
            let code = if matches!(key, "position" | "thickness") { "E0904" } else { "E0905" };
            let span = self.place_span(section, place, key);
            self.mistakes.push(Mistake::error(code, span, message).hint(remedy));
        }
    }

    /// Where the file gives a size of an element: in its own table, or for all of its kind in `[crank.body]`.
    pub(in crate::read) fn place_span(&self, body: &'a Section, place: CrankPlace, key: &str) -> Span {
        let (list, number, crankshaft, of_all) = match place {
            CrankPlace::Journal { crankshaft, journal } => ("journal", journal, crankshaft, "journal_"),
            CrankPlace::Pin(throw) => ("pin", throw, 0, "pin_"),
            CrankPlace::Web(web) => ("web", web, 0, "web_"),
            CrankPlace::End(index) => {
                let steps =
                    ["nose", "flange"].into_iter().flat_map(|list| body.tables(list).given().unwrap_or(&[]));
                let own = steps.into_iter().nth(index);
                return own.map_or(body.span.clone(), |own| own.value_span(key));
            }
        };
        let tables = body.tables(list).given().unwrap_or(&[]);
        let own = tables.iter().find(|own| {
            let of = if own.knows("crankshaft") { own.whole("crankshaft").given().unwrap_or(1) } else { 1 };
            let names = |numbers: Vec<crate::document::Spot<i64>>| {
                numbers.iter().any(|spot| usize::try_from(spot.value - 1) == Ok(number))
            };
            usize::try_from(of - 1) == Ok(crankshaft) && own.wholes("numbers").given().is_some_and(names)
        });
        if let Some(own) = own.filter(|own| own.knows(key) && own.has(key)) {
            return own.value_span(key);
        }
        let all = [format!("{of_all}{key}"), key.to_owned()];
        match (all.iter().find(|key| body.knows(key) && body.has(key)), own) {
            (Some(key), _) => body.value_span(key),
            (None, Some(own)) => own.span.clone(),
            (None, None) => body.span.clone(),
        }
    }
}

/// The outer `None` says bad, the inner one absent.
fn optional(section: &Section, key: &str) -> Option<Option<f64>> {
    match section.number(key) {
        Field::Given(spot) => Some(Some(spot.value)),
        Field::Absent => Some(None),
        Field::Bad => None,
    }
}
