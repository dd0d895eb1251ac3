//! Weights to be found.

use super::Reader;
use super::drill;
use super::follows::Follows;
use crate::document::{Field, Section, Span};
use lanchester_diagnostic::Mistake;
use lanchester_model::Engine;
use lanchester_model::angle;
use lanchester_task::WHAT_FITS;
use lanchester_task::{Catalogue, Cost, DrillCatalogue, FreeWeight, Phase, Place, Seat};
use lanchester_units::Dimension;

/// Why a weight needs its largest amount.
pub(super) const PLACE_TO_BE_FOUND: &str = "a weight whose place is to be found";

/// A free weight before the throws are known.
#[derive(Debug)]
pub(super) struct DraftFreeWeight {
    pub(super) name: String,
    pub(super) place: FreePlace,
    pub(super) own: Properties,
}

/// Where it sits; every z as in the file.
#[derive(Debug, Clone, Copy)]
pub(super) enum FreePlace {
    Throw(usize),
    /// Index of the throw, and of the web on it.
    Web(usize, usize),
    Plane {
        z: Place,
        crankshaft: usize,
    },
    Shaft {
        shaft: usize,
        z: Place,
    },
}

/// What holds wherever it sits.
#[derive(Debug, Clone)]
pub(super) struct Properties {
    pub(super) name: Option<String>,
    /// From the throw, from the crankshaft's zero or from +x.
    direction: Phase,
    least: f64,
    most: Option<f64>,
    fits: bool,
    pub(super) optional: bool,
    radius: Option<f64>,
    catalogue: Option<Catalogue>,
    drill: Option<DrillCatalogue>,
    pub(super) cost: Cost,
    equal_parts: Option<String>,
    pub(super) follows: Option<Follows>,
    pub(super) span: Span,
}

impl<'a> Reader<'a> {
    pub(super) fn free_counterweights(
        &mut self,
        section: &'a Section,
        throws: Option<usize>,
        crankshafts: Option<usize>,
    ) -> Option<Vec<DraftFreeWeight>> {
        let sections = section.tables("counterweight").or(&[])?;
        let read: Vec<Option<Vec<DraftFreeWeight>>> = sections
            .iter()
            .enumerate()
            .map(|(index, section)| self.free_counterweight(index, section, throws, crankshafts))
            .collect();
        let weights: Vec<DraftFreeWeight> =
            read.into_iter().collect::<Option<Vec<_>>>()?.into_iter().flatten().collect();
        if let Some(most) = section.limit("counterweight")
            && weights.len() > most
        {
            let message = format!("the file has {} free weights, more than {most}", weights.len());
            self.mistakes.push(Mistake::error("E0004", section.key_span("counterweight"), message));
            return None;
        }
        Some(weights)
    }

    /// One weight, or one for every throw or web.
    fn free_counterweight(
        &mut self,
        index: usize,
        section: &'a Section,
        throws: Option<usize>,
        crankshafts: Option<usize>,
    ) -> Option<Vec<DraftFreeWeight>> {
        let places = self.free_places(section, throws, crankshafts);
        let is_found = |place: &FreePlace| matches!(place, FreePlace::Plane { z: Place::Between(..), .. });
        let why = places.as_ref().and_then(|places| places.iter().any(is_found).then_some(PLACE_TO_BE_FOUND));
        let own = self.properties(section, "angle", why)?;
        let places = places?;
        let is_one = !section.has("throws") && !section.has("webs");
        if let (false, Some(follows)) = (is_one, &own.follows) {
            let why = "it would tie all of these weights to one";
            self.without_effect(section, follows.key, why, "write the weights one by one to tie them");
            return None;
        }
        let weights = places.into_iter().enumerate().map(|(number, place)| {
            let name = match (&own.name, place) {
                (Some(name), _) if is_one => name.clone(),
                (Some(name), _) => format!("{name} {}", number + 1),
                (None, FreePlace::Throw(throw)) => format!("throw {}", throw + 1),
                (None, FreePlace::Web(throw, side)) => format!("web {}", 2 * throw + side + 1),
                (None, FreePlace::Plane { .. } | FreePlace::Shaft { .. }) => {
                    format!("free weight {}", index + 1)
                }
            };
            DraftFreeWeight { name, place, own: own.clone() }
        });
        Some(weights.collect())
    }

    fn free_places(
        &mut self,
        section: &'a Section,
        throws: Option<usize>,
        crankshafts: Option<usize>,
    ) -> Option<Vec<FreePlace>> {
        let given: Vec<&str> =
            ["throw", "throws", "web", "webs", "z"].into_iter().filter(|key| section.has(key)).collect();
        let (throw, web, crankshaft) =
            (section.whole("throw"), section.whole("web"), section.whole("crankshaft"));
        let (throws_word, webs_word) = (section.word("throws"), section.word("webs"));
        if let [first, second, ..] = given.as_slice() {
            self.two_sources(section, first, second, "the place of the weight");
            return None;
        }
        if !section.has("z") && section.has("crankshaft") {
            let why = "a throw or web says which crankshaft it is";
            self.without_effect(section, "crankshaft", why, "leave it out; it goes with z");
        }
        if let Field::Given(number) = throw {
            let index = self.existing(number.value, throws, "throw", number.span)?;
            return Some(vec![FreePlace::Throw(index)]);
        }
        if let Field::Given(number) = web {
            let index = self.existing(number.value, throws.map(|count| 2 * count), "web", number.span)?;
            return Some(vec![FreePlace::Web(index / 2, index % 2)]);
        }
        if throws_word.given().is_some() {
            return Some((0..throws?).map(FreePlace::Throw).collect());
        }
        if webs_word.given().is_some() {
            return Some((0..2 * throws?).map(|web| FreePlace::Web(web / 2, web % 2)).collect());
        }
        if section.has("z") {
            let z = self.place(section, "z", None)?;
            let span = section.value_span("crankshaft");
            let crankshaft = self.existing(crankshaft.or(1)?, crankshafts, "crankshaft", span)?;
            return Some(vec![FreePlace::Plane { z, crankshaft }]);
        }
        if given.is_empty() {
            self.missing(
                section.span.clone(),
                "the place of the weight is missing".into(),
                "add throw = 1, web = 1, z = \"10 mm\" or webs = \"all\"".into(),
            );
        }
        None
    }

    /// What holds wherever the weight sits. `direction_key` is `angle` or `phase`; `why` says why its place asks for a
    /// largest amount.
    pub(super) fn properties(
        &mut self,
        section: &'a Section,
        direction_key: &str,
        why: Option<&str>,
    ) -> Option<Properties> {
        let name = section.text("name");
        let [along, line] = [direction_key, "line"].map(|key| section.number(key));
        let fits = section.word("most").given() == Some(WHAT_FITS);
        let bounds = self.bounds(section, fits);
        let radius = section.number("radius");
        let optional = section.truth("optional").or(false);
        let follows = self.follows(section);
        let bounded = bounds.unwrap_or((0.0, None));
        let catalogue = match radius.is_bad() {
            true => None,
            false => self.catalogue(section, radius.clone().given(), bounded),
        };
        let drilled = self.drilled(section, bounded);
        let cost = self.cost(section, radius.clone().given());
        let equal_parts = match section.text("equal_parts") {
            Field::Given(name) => Some(name.value),
            Field::Absent => None,
            Field::Bad => return None,
        };
        if section.has(direction_key) && section.has("line") {
            self.two_sources(section, direction_key, "line", "the direction of the weight");
            return None;
        }
        if name.is_bad() || along.is_bad() || line.is_bad() || radius.is_bad() {
            return None;
        }
        let (follows, (least, most), optional) = (follows?, bounds?, optional?);
        let (catalogue, cost) = (catalogue?, cost?);
        let (drill, catalogue) = match drilled? {
            Some((drill, amounts)) => (Some(drill), Some(amounts)),
            None => (None, catalogue),
        };
        // A list is an end to what may be chosen.
        let most = most.or_else(|| catalogue.as_ref().and_then(Catalogue::largest));
        if let Some(follows) = &follows {
            let keys = [
                direction_key,
                "line",
                "least",
                "most",
                "unbalance",
                "optional",
                "step",
                "catalogue",
                "drill",
                "equal_parts",
            ];
            for key in keys.into_iter().filter(|key| section.has(key)) {
                let why = format!("the weight follows \"{}\"", follows.leader_name);
                self.without_effect(section, key, &why, "give it to that weight");
            }
        } else if most.is_none() && !fits {
            let why = if optional { Some("an optional weight") } else { why };
            if let Some(why) = why {
                self.most_missing(&section.span, why, "most = \"0.1 kg m\"");
            }
        }
        let direction = match (along.given(), line.given()) {
            (Some(angle), _) => Phase::Direction(angle),
            (_, Some(angle)) => Phase::Line(angle),
            _ => Phase::Free,
        };
        Some(Properties {
            name: name.given(),
            direction,
            least,
            most,
            fits,
            optional,
            radius: radius.given(),
            catalogue,
            drill,
            cost,
            equal_parts,
            follows,
            span: section.span.clone(),
        })
    }

    /// Least and largest amount.
    fn bounds(&mut self, section: &'a Section, fits: bool) -> Option<(f64, Option<f64>)> {
        let [least, most, given] = ["least", "most", "unbalance"].map(|key| section.number(key));
        if section.has("unbalance") {
            if let Some(other) = ["least", "most"].into_iter().find(|key| section.has(key)) {
                self.two_sources(section, "unbalance", other, "the amount of the weight");
                return None;
            }
            return given.given().map(|amount| (amount, Some(amount)));
        }
        if most.is_bad() && !fits {
            return None;
        }
        let (least, most) = (least.or(0.0)?, most.given());
        if let Some(most) = most
            && least > most
        {
            let [small, large] =
                [least, most].map(|amount| lanchester_units::readable(amount, Dimension::Unbalance));
            self.mistakes.push(
                Mistake::error(
                    "E0305",
                    section.value_span("least"),
                    format!("the amount must be at least {small} and at most {large}"),
                )
                .label("more than `most`")
                .related(section.value_span("most"), "largest amount")
                .hint("exchange the two, or write unbalance = \"0.05 kg m\" for a given amount"),
            );
            return None;
        }
        Some((least, most))
    }

    /// The weight in the frame of the engine; `origin` is the z of its reference plane in the file.
    pub(super) fn placed_free_weight(
        &mut self,
        draft: &DraftFreeWeight,
        engine: &Engine,
        origin: f64,
    ) -> Option<FreeWeight> {
        let from_origin = |place: Place| match place {
            Place::At(z) => Place::At(z - origin),
            Place::Between(first, last) => Place::Between(first - origin, last - origin),
        };
        let on_throw = |index: usize| {
            let throw = &engine.throws[index];
            let crankshaft = &engine.crankshafts[throw.crankshaft];
            let zero = crankshaft.phase + throw.angle;
            (throw, Seat::Crankshaft(throw.crankshaft), zero)
        };
        let (seat, z, zero) = match draft.place {
            FreePlace::Throw(index) => {
                let (throw, seat, zero) = on_throw(index);
                (seat, Place::At(throw.z), Some(zero))
            }
            FreePlace::Web(index, side) => {
                let (throw, seat, zero) = on_throw(index);
                let Some(webs) = throw.webs else {
                    self.web_distance_missing(draft.own.span.clone(), index);
                    return None;
                };
                (seat, Place::At(webs[side]), Some(zero))
            }
            FreePlace::Plane { z, crankshaft } => {
                let phase = engine.crankshafts[crankshaft].phase;
                (Seat::Crankshaft(crankshaft), from_origin(z), (phase != 0.0).then_some(phase))
            }
            FreePlace::Shaft { shaft, z } => (Seat::Shaft(shaft), from_origin(z), None),
        };
        // Angles from the frame's own zero stay as the file has them.
        let turned = |angle: f64| zero.map_or(angle, |zero| angle::direction(zero + angle));
        Some(FreeWeight {
            least: draft.own.least,
            most: draft.own.most,
            fits: draft.own.fits,
            phase: match drill::of_weight(draft.own.direction, draft.own.drill.as_ref()) {
                Phase::Free => Phase::Free,
                Phase::Line(angle) => Phase::Line(turned(angle)),
                Phase::Direction(angle) => Phase::Direction(turned(angle)),
            },
            optional: draft.own.optional,
            radius: draft.own.radius,
            cost: draft.own.cost,
            catalogue: draft.own.catalogue.clone(),
            drill: draft.own.drill.clone(),
            equal_parts: draft.own.equal_parts.clone(),
            ..FreeWeight::new(&draft.name, seat, z)
        })
    }
}
