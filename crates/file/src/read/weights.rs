//! Counterweights: one by one, and the short form.

use super::Reader;
use super::crank::details::BodyDraft;
use super::cylinder::DraftCylinder;
use super::part::DraftPart;
use crate::document::{Field, Section, Span};
use lanchester_diagnostic::Mistake;
use lanchester_model::CounterweightPart;
use lanchester_model::SharedWeb;
use lanchester_model::angle;
use lanchester_model::{Counterweight, Throw};
use lanchester_model::{PartFault, part_weight};
use lanchester_units::Dimension;
use std::f64::consts::PI;

/// Shares above this are taken for a percentage without its sign.
const LARGEST_SHARE: f64 = 2.0;

/// A shape that misses its unbalance by more than this share of it is told.
const LARGEST_MISS: f64 = 0.01;

/// A `[[counterweight]]` before the throws are known.
#[derive(Debug)]
pub(super) struct DraftWeight {
    name: Option<String>,
    /// Where its name stands, or its table.
    name_span: Span,
    place: WeightPlace,
    amount: DraftAmount,
    angle: Option<f64>,
    span: Span,
}

/// What it weighs: a number, or a part.
#[derive(Debug)]
enum DraftAmount {
    Unbalance(f64),
    Part(Box<DraftPart>),
}

#[derive(Debug, Clone, Copy)]
enum WeightPlace {
    Throw(usize),
    /// Index of the throw, and of the web on it.
    Web(usize, usize),
    Plane {
        z: f64,
        crankshaft: usize,
    },
}

impl<'a> Reader<'a> {
    /// The weights of `[[counterweight]]`; `throws` and `crankshafts` say how many there are, if that is known.
    pub(super) fn weight_drafts(
        &mut self,
        throws: Option<usize>,
        crankshafts: Option<usize>,
        body: &BodyDraft,
    ) -> Option<Vec<DraftWeight>> {
        let sections = self.root.tables("counterweight").or(&[])?;
        if !self.has_few_corners(sections) {
            return None;
        }
        let drafts: Vec<Option<DraftWeight>> =
            sections.iter().map(|section| self.weight_draft(section, throws, crankshafts, body)).collect();
        drafts.into_iter().collect()
    }

    fn weight_draft(
        &mut self,
        section: &'a Section,
        throws: Option<usize>,
        crankshafts: Option<usize>,
        body: &BodyDraft,
    ) -> Option<DraftWeight> {
        let name = section.text("name");
        let amount = match section.table("shape") {
            Field::Given(shape) => {
                let web = section.whole("web").given().and_then(|web| usize::try_from(web - 1).ok());
                let part = self.part_draft(section, shape.value, &body.at_web(web));
                part.map(|part| DraftAmount::Part(Box::new(part)))
            }
            Field::Absent => self.weight_unbalance(section).map(DraftAmount::Unbalance),
            Field::Bad => None,
        };
        let angle = section.number("angle");
        let place = self.weight_place(section, throws, crankshafts);
        if name.is_bad() || angle.is_bad() {
            return None;
        }
        Some(DraftWeight {
            name: name.given(),
            name_span: super::names::name_span(section),
            place: place?,
            amount: amount?,
            angle: angle.given(),
            span: section.span.clone(),
        })
    }

    fn weight_place(
        &mut self,
        section: &'a Section,
        throws: Option<usize>,
        crankshafts: Option<usize>,
    ) -> Option<WeightPlace> {
        let given: Vec<&str> = ["throw", "web", "z"].into_iter().filter(|key| section.has(key)).collect();
        let (throw, web, z) = (section.whole("throw"), section.whole("web"), section.number("z"));
        let crankshaft = section.whole("crankshaft");
        if let [first, second, ..] = given.as_slice() {
            self.two_sources(section, first, second, "the place of the weight");
            return None;
        }
        if !section.has("z") && section.has("crankshaft") {
            self.without_effect(
                section,
                "crankshaft",
                "a throw or web says which crankshaft it is",
                "leave it out; it goes with z",
            );
        }
        if let Field::Given(number) = throw {
            return self.existing(number.value, throws, "throw", number.span).map(WeightPlace::Throw);
        }
        if let Field::Given(number) = web {
            let index = self.existing(number.value, throws.map(|count| 2 * count), "web", number.span)?;
            return Some(WeightPlace::Web(index / 2, index % 2));
        }
        if let Field::Given(z) = z {
            let span = section.value_span("crankshaft");
            let crankshaft = self.existing(crankshaft.or(1)?, crankshafts, "crankshaft", span)?;
            return Some(WeightPlace::Plane { z: z.value, crankshaft });
        }
        if given.is_empty() {
            self.missing(
                section.span.clone(),
                "the place of the weight is missing".into(),
                "add throw = 1, web = 1 or z = \"10 mm\"".into(),
            );
        }
        None
    }

    /// Unbalance, or mass times radius.
    pub(crate) fn weight_unbalance(&mut self, section: &'a Section) -> Option<f64> {
        let [unbalance, mass, radius] = ["unbalance", "mass", "radius"].map(|key| section.number(key));
        if section.has("unbalance") {
            if let Some(other) = ["mass", "radius"].into_iter().find(|key| section.has(key)) {
                self.two_sources(section, "unbalance", other, "the unbalance of the weight");
                return None;
            }
            return unbalance.given();
        }
        if !section.has("mass") && !section.has("radius") {
            self.missing(
                section.span.clone(),
                "the unbalance of the weight is missing".into(),
                "add unbalance = \"0.02 kg m\", or mass and radius".into(),
            );
            return None;
        }
        let mass = self.required(section, "mass", mass);
        let radius = self.required(section, "radius", radius);
        Some(mass? * radius?)
    }

    /// All weights on the crankshafts; throws stand relative to the origin already.
    pub(super) fn counterweights(
        &mut self,
        drafts: Vec<DraftWeight>,
        throws: &[Throw],
        cylinders: &[DraftCylinder<'a>],
        body: &BodyDraft,
        origin: f64,
    ) -> Option<Vec<Counterweight>> {
        let short = self.short_form(throws, cylinders);
        let count = drafts.len();
        let single: Vec<(Counterweight, bool, Span)> = drafts
            .into_iter()
            .enumerate()
            .filter_map(|(index, draft)| {
                let (is_named, span) = (draft.name.is_some(), draft.name_span.clone());
                Some((self.placed_weight(draft, index, throws, body, origin)?, is_named, span))
            })
            .collect();
        let all_placed = single.len() == count;
        let mut weights = short?;
        let short_span = self.root.key_span("counterweights");
        let mut names: Vec<(String, Span)> =
            weights.iter().map(|weight| (weight.name.clone(), short_span.clone())).collect();
        let given: Vec<String> =
            single.iter().filter(|one| one.1).map(|(weight, ..)| weight.name.clone()).collect();
        for (mut weight, is_named, span) in single {
            // Weights that have their names from one place are numbered.
            let is_taken =
                |name: &String| names.iter().any(|(other, _)| other == name) || given.contains(name);
            if !is_named && is_taken(&weight.name) {
                let numbered = (2..).map(|number| format!("{} ({number})", weight.name));
                weight.name = numbered.into_iter().find(|name| !is_taken(name)).unwrap_or_default();
            }
            names.push((weight.name.clone(), span));
            weights.push(weight);
        }
        self.check_unique("counterweight", &names);
        if let Some(most) = self.root.limit("counterweight")
            && weights.len() > most
        {
            let message = format!("the file has {} counterweights, more than {most}", weights.len());
            let span = self.root.key_span("counterweight");
            self.mistakes.push(Mistake::error("E0004", span, message));
        }
        all_placed.then_some(weights)
    }

    fn placed_weight(
        &mut self,
        draft: DraftWeight,
        index: usize,
        throws: &[Throw],
        body: &BodyDraft,
        origin: f64,
    ) -> Option<Counterweight> {
        let (crankshaft, z, angle, name) = match draft.place {
            WeightPlace::Throw(index) => {
                let throw = &throws[index];
                let angle = angle::direction(throw.angle + draft.angle.unwrap_or(PI));
                (throw.crankshaft, throw.z, angle, format!("throw {}", index + 1))
            }
            WeightPlace::Web(index, web) => {
                let throw = &throws[index];
                let angle = angle::direction(throw.angle + draft.angle.unwrap_or(PI));
                let Some(webs) = throw.webs else {
                    self.web_distance_missing(draft.span, index);
                    return None;
                };
                (throw.crankshaft, webs[web], angle, format!("web {}", 2 * index + web + 1))
            }
            WeightPlace::Plane { z, crankshaft } => {
                (crankshaft, z - origin, draft.angle.unwrap_or(0.0), format!("weight {}", index + 1))
            }
        };
        let name = draft.name.unwrap_or(name);
        let part = match draft.amount {
            DraftAmount::Unbalance(unbalance) => {
                return Some(Counterweight { name, crankshaft, z, unbalance, angle, part: None });
            }
            DraftAmount::Part(part) => *part,
        };
        let web = match draft.place {
            WeightPlace::Web(index, web) => Some(2 * index + web),
            _ => None,
        };
        let DraftPart { form, part, wanted, span, wanted_span } = part;
        let shared =
            web.filter(|_| matches!(body.uniform, Some(Some(_)))).and_then(|web| SharedWeb::of(throws, web));
        if let Some(shared) = shared {
            let [one, two] = shared.webs().map(|web| web + 1);
            self.mistakes.push(
                Mistake::error(
                    "E0904",
                    span,
                    format!(
                        "no counterweight sits on web {one}: it is one with web {two}, between crankpins {} and {}",
                        shared.front + 1,
                        shared.rear + 1
                    ),
                )
                .hint("give the place of the weight along the crank as `z`, then it stands by itself; or give it by its unbalance"),
            );
            return None;
        }
        let part = CounterweightPart { form, part, web, z, angle, wanted };
        let weight = match part_weight(&part, throws, body.at_web(web)?.as_ref()) {
            Ok(weight) => weight,
            Err(fault) => {
                self.part_fault(span, fault);
                return None;
            }
        };
        if let Some(wanted) = wanted {
            self.check_wanted(wanted_span, wanted, weight.unbalance);
        }
        let (z, unbalance, angle) = (weight.z, weight.unbalance, weight.angle);
        Some(Counterweight { name, crankshaft, z, unbalance, angle, part: Some(Box::new(part)) })
    }

    pub(super) fn part_fault(&mut self, span: Span, fault: PartFault) {
        let mistake = match fault {
            PartFault::Couple { .. } => Mistake::error("E0902", span, fault.to_string())
                .hint("move the blind inserts and chamfers so that those of both faces lie opposite, or bore through"),
            PartFault::TooLarge => {
                Mistake::error("E0901", span, fault.to_string()).hint("check the units of its dimensions")
            }
            PartFault::Overlap(error) => {
                let text = error.to_string();
                let (message, hint) = text.split_once("\nhint: ").unwrap_or((&text, ""));
                let message = format!("what the part shares with the plain web cannot be told: {message}");
                Mistake::error("E0901", span, message).hint(hint)
            }
            // Told with [crank.body].
            PartFault::Web(_) => return,
        };
        self.mistakes.push(mistake);
    }

    /// The shape against the unbalance that it should have.
    pub(super) fn check_wanted(&mut self, span: Span, wanted: f64, unbalance: f64) {
        let miss = unbalance - wanted;
        if miss.abs() <= LARGEST_MISS * wanted {
            return;
        }
        let [shown, by] = lanchester_units::readable_difference(unbalance, wanted, Dimension::Unbalance);
        let share = if wanted > 0.0 {
            format!(" ({})", lanchester_units::readable(miss.abs() / wanted, Dimension::Share))
        } else {
            String::new()
        };
        let side = if miss > 0.0 { "more" } else { "less" };
        self.mistakes.push(
            Mistake::warning("W0901", span, format!("the shape has {shown}, {by}{share} {side} than this"))
                .label("wanted")
                .hint("change the shape; loads are those of the shape"),
        );
    }

    pub(super) fn web_distance_missing(&mut self, span: Span, throw: usize) {
        self.missing(
            span,
            format!("a weight on a web of throw {} needs the distance of its webs", throw + 1),
            "add web_distance = \"44 mm\" to [crank] or to the throw".into(),
        );
    }

    /// `[counterweights]`: shares of what turns and of what goes to and fro, opposite every throw.
    fn short_form(
        &mut self,
        throws: &[Throw],
        cylinders: &[DraftCylinder<'a>],
    ) -> Option<Vec<Counterweight>> {
        let (section, broken) = self.section("counterweights");
        let Some(section) = section else { return (!broken).then(Vec::new) };
        let rotating = section.number("rotating_share").or(0.0);
        let reciprocating = section.number("reciprocating_share").or(0.0);
        let at = section.word("at").or("throws");
        let (rotating, reciprocating, at) = (rotating?, reciprocating?, at?);
        if at == "webs"
            && let Some(bare) = throws.iter().position(|throw| throw.webs.is_none())
        {
            self.web_distance_missing(section.value_span("at"), bare);
            return None;
        }
        let mut weights = Vec::new();
        for (index, throw) in throws.iter().enumerate() {
            let driven = || cylinders.iter().map(|draft| &draft.cylinder).filter(|c| c.throw == index);
            let big_ends: f64 = driven().map(|c| c.rod.big_end_mass).sum();
            let reciprocating_mass: f64 = driven().map(|c| c.reciprocating_mass()).sum();
            let wanted = rotating * (throw.unbalance + big_ends * throw.radius)
                + reciprocating * reciprocating_mass * throw.radius;
            // A crank whose own unbalance lies opposite the throw may need weight along it.
            let (unbalance, angle) = if wanted < 0.0 {
                (-wanted, throw.angle)
            } else {
                (wanted, angle::direction(throw.angle + PI))
            };
            let crankshaft = throw.crankshaft;
            match throw.webs {
                Some(webs) if at == "webs" => weights.extend(webs.iter().enumerate().map(|(web, &z)| {
                    let name = format!("web {}", 2 * index + web + 1);
                    Counterweight { name, crankshaft, z, unbalance: unbalance / 2.0, angle, part: None }
                })),
                _ => {
                    let name = format!("throw {}", index + 1);
                    weights.push(Counterweight {
                        name,
                        crankshaft,
                        z: throw.z,
                        unbalance,
                        angle,
                        part: None,
                    });
                }
            }
        }
        Some(weights)
    }

    /// Shares that say nothing or look like slips.
    pub(super) fn check_shares(&mut self) {
        let (Some(section), _) = self.section("counterweights") else { return };
        let keys = ["rotating_share", "reciprocating_share"];
        if !keys.iter().any(|key| section.has(key)) {
            self.missing(
                section.span.clone(),
                "[counterweights] says no share".into(),
                "add rotating_share = \"100 %\", or reciprocating_share, or leave the table out".into(),
            );
            return;
        }
        let shares = keys.map(|key| section.number(key));
        if keys.iter().zip(&shares).all(|(key, share)| match share {
            Field::Given(share) => share.value == 0.0,
            Field::Absent => !section.has(key),
            Field::Bad => false,
        }) {
            self.mistakes.push(
                Mistake::warning("W0204", section.span.clone(), "[counterweights] asks for weights of 0")
                    .hint("leave it out, or give a share above 0"),
            );
        }
        for (key, share) in keys.into_iter().zip(shares) {
            if let Field::Given(share) = share
                && share.value > LARGEST_SHARE
            {
                let percent = share.value * 100.0;
                self.mistakes.push(
                    Mistake::warning("W0802", share.span, format!("`{key}` is {percent} %"))
                        .label("more than 200 %")
                        .hint(format!("a bare number is a fraction: write \"{} %\"?", share.value)),
                );
            }
        }
    }
}
