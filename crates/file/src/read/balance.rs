//! `[balance]`: what may be done to balance the engine, and what is wanted.

mod catalogue;
mod crank_inertia;
mod criteria;
mod devices;
mod drill;
mod durability;
mod follows;
mod free_shaft;
mod free_weight;
mod ties;

use super::reader::Reader;
use crate::document::{Field, Section, Span};
use crank_inertia::DraftInertia;
use free_weight::DraftFreeWeight;
use lanchester_diagnostic::Mistake;
use lanchester_model::Engine;
use lanchester_model::Mount;
use lanchester_task::default_task;
use lanchester_task::{
    BalanceTask, Criterion, DurabilityWish, FreeInertia, FreeShaft, GiveUp, Limit, Load, Place, Stage,
};
use lanchester_units::Dimension;

/// `[balance]` before the engine is known.
pub(super) struct DraftBalance {
    weights: Vec<DraftFreeWeight>,
    shafts: Vec<(FreeShaft, Span)>,
    shaft_costs: Vec<f64>,
    inertias: Vec<DraftInertia>,
    stages: Vec<Stage>,
    limits: Vec<Limit>,
    give_up: Vec<GiveUp>,
    cancel: Vec<(Load, f64)>,
    most_optional: Option<usize>,
    /// Speeds at which forces at mounts are judged with their weights, and where `speeds` stands.
    speeds: Option<(Vec<(f64, f64)>, Span)>,
    /// Where `added mass` is asked for.
    mass_span: Option<Span>,
    /// Criteria that are about main bearings, and where they stand.
    of_mains: Vec<(Criterion, Span)>,
    /// Films and safeties, and where each stands.
    durability: (DurabilityWish, Vec<Span>),
}

impl<'a> Reader<'a> {
    /// What `[balance]` says, as far as it can be told without the engine; `Some(None)` if the file has none.
    pub(super) fn balance_draft(
        &mut self,
        throws: Option<usize>,
        crankshafts: Option<usize>,
        mounts: Option<&[Mount]>,
    ) -> Option<Option<DraftBalance>> {
        let (section, broken) = self.section("balance");
        let Some(section) = section else { return (!broken).then_some(None) };
        let stages = self.stages(section, mounts);
        let limits = self.limits(section, mounts);
        let budget = self.budget(section);
        let cancel = self.cancelled(section, mounts);
        let give_up = stages.as_ref().and_then(|stages| self.given_up(section, stages, mounts));
        let durability = self.durability_wish(section);
        let mass_span = self.mass_span(section, mounts);
        let most_optional = section.whole("most_optional");
        let speeds = self.judged_speeds(section);
        let counterweights = self.free_counterweights(section, throws, crankshafts);
        let shafts = self.free_shafts(section);
        let inertias = self.free_inertias(section);
        let (mut weights, (shafts, shaft_costs, shaft_weights), inertias) =
            (counterweights?, shafts?, inertias?);
        weights.extend(shaft_weights);
        let are_tied = self.follow_leaders(&mut weights);
        let mut draft = DraftBalance {
            weights,
            shafts,
            shaft_costs,
            inertias,
            stages: stages?,
            limits: limits?.into_iter().chain(budget?).collect(),
            cancel: cancel?,
            give_up: give_up?,
            most_optional: None,
            speeds: speeds?.map(|speeds| (speeds, section.key_span("speeds"))),
            mass_span,
            of_mains: self.of_mains(section, mounts),
            durability: durability?,
        };
        if let Field::Given(most) = &most_optional {
            draft.most_optional = usize::try_from(most.value).ok();
            if !draft.has_optional() {
                let why = "no weight, shaft or inertia is optional";
                self.without_effect(section, "most_optional", why, "write optional = true where it is meant");
            }
        }
        (are_tied && !most_optional.is_bad()).then_some(Some(draft))
    }

    /// The task of the engine; `origin` is the z of its reference plane in the file.
    pub(super) fn balance_task(
        &mut self,
        draft: Option<DraftBalance>,
        engine: &Engine,
        origin: f64,
    ) -> Option<Option<BalanceTask>> {
        let Some(draft) = draft else { return Some(None) };
        let is_empty = draft.weights.is_empty() && draft.shafts.is_empty() && draft.inertias.is_empty();
        let mut task = BalanceTask {
            shaft_costs: draft.shaft_costs,
            shafts: draft.shafts.iter().map(|(shaft, _)| shaft.clone()).collect(),
            inertias: self.crank_inertias(draft.inertias, engine)?,
            ties: ties::ties(&draft.weights),
            stages: draft.stages,
            limits: draft.limits,
            cancel: draft.cancel,
            give_up: draft.give_up,
            most_optional: draft.most_optional,
            speeds: Vec::new(),
            speed_weights: Vec::new(),
            weights: Vec::new(),
            durability: draft.durability.0,
        };
        if is_empty {
            task.weights = default_task(engine).weights;
        } else {
            for weight in &draft.weights {
                task.weights.push(self.placed_free_weight(weight, engine, origin)?);
            }
            ties::bound_followers(&mut task);
            let spans: Vec<Span> = draft.weights.iter().map(|weight| weight.own.span.clone()).collect();
            let shaft_spans: Vec<Span> = draft.shafts.into_iter().map(|(_, span)| span).collect();
            self.check_costs(&task, &spans);
            self.check_told_apart(&task, &spans);
            self.check_device_names(&task, &spans, &shaft_spans);
            self.check_room(&task, engine, &spans, &shaft_spans);
        }
        task.judge_at(draft.speeds.as_ref().map_or(&[], |(speeds, _)| speeds));
        if let Some((_, span)) = &draft.speeds
            && let Some(speed) = task.speeds.iter().find(|speed| !engine.speed.holds(**speed))
        {
            let message = format!(
                "the engine does not run at {}",
                lanchester_units::readable(*speed, Dimension::Speed)
            );
            self.mistakes.push(
                Mistake::error("E1304", span.clone(), message)
                    .related(self.root.value_span("speed"), "its speeds")
                    .hint("give speeds between the lowest and the highest of `speed`"),
            );
        }
        if let Some((_, span)) = draft.speeds.clone()
            && !engine.is_on_springs()
            && !task.counts_gas()
            && task.durability.is_empty()
        {
            let message = "`speeds` has no effect: no mount has springs, no criterion counts the gas, and all other loads are largest \
                           at the highest speed";
            self.mistakes.push(
                Mistake::warning("W0204", span, message)
                    .hint("give [block] and stiffness to every [[mount]], name a criterion \"with gas\", or leave it out"),
            );
        }
        let has_speeds = draft
            .speeds
            .as_ref()
            .filter(|_| !task.counts_gas() && !task.counts_mounts() && task.durability.is_empty());
        if let Some((_, span)) = has_speeds.filter(|_| engine.is_on_springs()) {
            let message = "`speeds` has no effect on what [balance] asks for: neither a mount force nor a load with gas is minimised or \
                           limited, and all other loads are largest at the highest speed";
            self.mistakes.push(
                Mistake::warning("W0204", span.clone(), message)
                    .hint("name one, such as \"mount force\", or leave it out"),
            );
        }
        if let Some(span) = draft.mass_span {
            self.check_radii(&task, span);
        }
        self.check_named_mains(engine, &draft.of_mains);
        self.check_durability_parts(&task.durability, engine, &draft.durability.1);
        Some(Some(task))
    }

    fn free_inertias(&mut self, section: &'a Section) -> Option<Vec<DraftInertia>> {
        let sections = section.tables("inertia").or(&[])?;
        let inertias: Vec<Option<DraftInertia>> =
            sections.iter().enumerate().map(|(index, section)| self.free_inertia(index, section)).collect();
        for (index, inertia) in inertias.iter().enumerate() {
            let Some(inertia) = inertia else { continue };
            let inertia = &inertia.inertia;
            let is_twin = |other: &Option<DraftInertia>| {
                other.as_ref().is_some_and(|other| other.inertia.name == inertia.name)
            };
            if let Some(twin) = inertias[..index].iter().position(is_twin) {
                self.one_name("inertias", &inertia.name, [&sections[twin].span, &sections[index].span]);
            }
        }
        inertias.into_iter().collect()
    }

    fn free_inertia(&mut self, index: usize, section: &'a Section) -> Option<DraftInertia> {
        let name = section.text("name").or(format!("inertia {}", index + 1));
        let ratio = self.required(section, "ratio", section.number("ratio"));
        let given = super::simulation::optional(section.number("crank_inertia"));
        let (most, optional) = (section.number("most"), section.truth("optional").or(false));
        if optional == Some(true) && !section.has("most") {
            self.most_missing(&section.span, "an optional inertia", "most = \"0.02 kg m2\"");
        }
        if most.is_bad() {
            return None;
        }
        let inertia = FreeInertia {
            name: name?,
            ratio: ratio?,
            crank_inertia: 0.0,
            most: most.given(),
            optional: optional?,
        };
        Some(DraftInertia { inertia, given: given?, span: section.value_span("crank_inertia") })
    }

    /// Speeds at which loads are judged, with their weights.
    fn judged_speeds(&mut self, section: &'a Section) -> Option<Option<Vec<(f64, f64)>>> {
        let sections = match section.tables("speeds") {
            Field::Given(sections) => sections.value,
            Field::Absent => return Some(None),
            Field::Bad => return None,
        };
        let mut speeds = Vec::new();
        for one in sections {
            let speed = self.required(one, "speed", one.number("speed"));
            let weight = one.number("weight").or(1.0);
            speeds.push(speed.zip(weight));
        }
        Some(Some(speeds.into_iter().collect::<Option<_>>()?))
    }

    /// One place, or two to find one between.
    fn place(&mut self, section: &'a Section, key: &str, default: Option<f64>) -> Option<Place> {
        let places = match (section.numbers(key), default) {
            (Field::Given(places), _) => places.value,
            (Field::Absent, Some(default)) => return Some(Place::At(default)),
            (Field::Absent, None) => return self.required(section, key, Field::Absent),
            (Field::Bad, _) => return None,
        };
        match places.as_slice() {
            [one] => Some(Place::At(one.value)),
            [first, second] if first.value < second.value => Some(Place::Between(first.value, second.value)),
            [first, second] => {
                let [from, to] =
                    [first, second].map(|place| lanchester_units::readable(place.value, Dimension::Length));
                let message = format!("`{key}` runs from {from} to {to}");
                self.mistakes.push(
                    Mistake::error("E0305", section.value_span(key), message)
                        .label("smaller value first")
                        .hint("write the smaller value first, then the larger; or one value alone"),
                );
                None
            }
            other => {
                let message = format!("`{key}` needs one or two places, got {}", other.len());
                self.mistakes.push(
                    Mistake::error("E0206", section.value_span(key), message)
                        .hint("write [\"-50 mm\", \"50 mm\"] for any place between the two"),
                );
                None
            }
        }
    }

    /// Choices and places to be found need an end to what may be chosen.
    fn most_missing(&mut self, span: &Span, what: &str, example: &str) {
        self.missing(
            span.clone(),
            format!("{what} needs its largest amount"),
            format!("add {example}: choices and places are searched for within such an amount"),
        );
    }

    fn one_name(&mut self, what: &str, name: &str, [first, second]: [&Span; 2]) {
        self.mistakes.push(
            Mistake::error("E0513", second.clone(), format!("two {what} are called \"{name}\""))
                .related(first.clone(), "the other")
                .hint("give each its own name"),
        );
    }
}

impl DraftBalance {
    fn has_optional(&self) -> bool {
        self.weights.iter().any(|weight| weight.own.optional)
            || self.shafts.iter().any(|(shaft, _)| shaft.optional)
            || self.inertias.iter().any(|draft| draft.inertia.optional)
    }
}
