//! The search: prepared once, run over any stretch of cases, merged in any order.

use crate::explore::as_given::{ArrangedLoads, ArrangedView, Arrangement};
use crate::explore::candidate::Candidate;
use crate::explore::constraint::Constraint;
use crate::explore::counts::{Counts, Invalid};
use crate::explore::error::ExploreError;
use crate::explore::firing::{Firing, FiringUnit};
use crate::explore::front::{Front, Ranking};
use crate::explore::kernel::{Block, UnitCylinder};
use crate::explore::layout::{BankPair, Layout};
use crate::explore::layout_meter::LayoutMeter;
use crate::explore::layout_orders::LayoutOrders;
use crate::explore::objective::{Level, Objective};
use crate::explore::sample::{JudgedCase, Sample};
use crate::explore::space::{Banks, Space, same_angle};
use crate::explore::symmetry::DifferenceTable;
use lanchester_task::AtLeast;
use serde::{Deserialize, Serialize};
use std::cmp::Ordering;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const EXPLORATION_VERSION: u32 = 1;

/// What to search and how to judge it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct ExploreRequest {
    /// Which layouts.
    pub space: Space,
    /// What they are judged by, less being better; the first counts most in the ranking, none counts most on the front.
    pub objectives: Vec<Objective>,
    /// What they must hold.
    pub constraints: Vec<Constraint>,
    /// Films and safeties that layouts on the front and in the ranking must hold. They are computed for layouts alone that no other covers.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub at_least: Vec<AtLeast>,
    /// Most cases that may be looked at.
    pub most_cases: u128,
    /// Most layouts on the front.
    pub most_on_front: usize,
    /// Kinds of layout in the ranking.
    pub most_listed: usize,
    /// Objectives that differ by less than this share of their scale are equal. The scale of a load is that of all
    /// masses together (moments: at the length of the engine); of lengths the longest engine; of firing 1.
    pub resolution: f64,
}

impl ExploreRequest {
    /// A search with usual limits: 10^12 cases, 100 000 layouts on the front, 20 in the ranking, resolution 1e-9.
    pub fn new(space: Space, objectives: Vec<Objective>, constraints: Vec<Constraint>) -> ExploreRequest {
        ExploreRequest {
            space,
            objectives,
            constraints,
            at_least: Vec::new(),
            most_cases: 1_000_000_000_000,
            most_on_front: 100_000,
            most_listed: 20,
            resolution: 1e-9,
        }
    }
}

/// A stretch of cases, end excluded.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Run {
    /// First case.
    pub from: u128,
    /// One more than the last case.
    pub to: u128,
}

/// What is known of a search so far; all of it when [`Exploration::is_complete`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Exploration {
    /// [`EXPLORATION_VERSION`].
    pub version: u32,
    /// Cases of the space.
    pub size: u128,
    /// Names of the objectives.
    pub objectives: Vec<String>,
    /// What has been looked at: apart and rising.
    pub done: Vec<Run>,
    /// What became of the cases.
    pub counts: Counts,
    /// Pareto-optimal layouts in all objectives, by the first objective.
    pub front: Vec<Candidate>,
    /// The first kinds of layout by the objectives in their order.
    pub ranking: Vec<Candidate>,
    /// Some of the judged cases, evenly from all of them: all where they are few.
    pub sample: Vec<JudgedCase>,
}

impl Exploration {
    /// Whether all cases were looked at.
    pub fn is_complete(&self) -> bool {
        self.done == [Run { from: 0, to: self.size }]
    }

    /// The first stretch that is still to be looked at; `None` when complete.
    pub fn next(&self) -> Option<Run> {
        let from = self.done.first().filter(|run| run.from == 0).map_or(0, |run| run.to);
        let to = self.done.iter().map(|run| run.from).find(|&start| start > from).unwrap_or(self.size);
        (from < to).then_some(Run { from, to })
    }

    /// Notes a stretch as done.
    pub(super) fn mark(&mut self, run: Run) -> Result<(), ExploreError> {
        if run.from >= run.to {
            return Ok(());
        }
        if self.done.iter().any(|other| run.from < other.to && other.from < run.to) {
            return Err(ExploreError::Merge { reason: "both have looked at the same cases" });
        }
        self.done.push(run);
        self.done.sort_by_key(|run| run.from);
        self.done.dedup_by(|later, kept| {
            let joins = kept.to == later.from;
            if joins {
                kept.to = later.to;
            }
            joins
        });
        Ok(())
    }
}

/// A search, prepared.
#[derive(Debug, Clone, PartialEq)]
pub struct Explorer {
    pub(crate) request: ExploreRequest,
    size: u128,
    radices: [u128; 9],
    /// Cases that share all sizes, and all angles.
    pub(crate) per_block: u128,
    pub(crate) per_crank: u128,
    /// One cylinder of each rod ratio; `None` where the crank cannot turn, and for cylinders that stay where they are.
    units: Vec<Option<UnitCylinder>>,
    /// The engine whose cylinders stay where they are, its loads with each pattern of weights, and its views.
    arrangement: Option<Arc<Arrangement>>,
    arranged_loads: Vec<ArrangedLoads>,
    pub(crate) arranged_views: Vec<ArrangedView>,
    /// Angles of the throws: 0, then those of the list that are not 0.
    pub(crate) angles: Vec<f64>,
    /// Place in `angles` by place in the list, and back.
    place: Vec<u16>,
    digit: Vec<Option<u16>>,
    pub(crate) differences: DifferenceTable,
    /// Resolution of each objective in its unit.
    pub(crate) resolutions: Vec<f64>,
    /// Whether firing is part of the search.
    pub(crate) fires: bool,
    /// Who tells films and safeties, if anybody does.
    pub(crate) meter: Option<LayoutMeter>,
}

impl Explorer {
    /// Prepares a search; its size is known then.
    ///
    /// # Errors
    /// [`ExploreError`]: an impossible number, a choice without a value or with one twice, too many cases, no objective.
    pub fn new(request: ExploreRequest) -> Result<Explorer, ExploreError> {
        let space = &request.space;
        let size = space.size(request.most_cases)?;
        check(&request)?;
        let radices = space.radices();
        let arrangement = space.arrangement().cloned().map(Arc::new);
        let arranged_loads = match &arrangement {
            Some(own) => {
                let loads = |pattern| ArrangedLoads::of(&space.parts, own, pattern);
                space.counterweights.iter().map(loads).collect::<Result<Vec<_>, _>>()?
            }
            None => Vec::new(),
        };
        let arranged_views = arrangement.as_deref().map(ArrangedView::all).unwrap_or_default();
        let unit = |ratio: &f64| match *ratio < 1.0 && arrangement.is_none() {
            true => UnitCylinder::new(&space.parts, *ratio).map(Some),
            false => Ok(None),
        };
        let units = space.rod_ratios.iter().map(unit).collect::<Result<Vec<_>, _>>()?;
        let others = space.throw_angles.iter().copied().filter(|angle| !same_angle(*angle, 0.0));
        let angles: Vec<f64> = std::iter::once(0.0).chain(others).collect();
        let mut next = 0;
        let place: Vec<u16> = space
            .throw_angles
            .iter()
            .map(|&angle| {
                next += u16::from(!same_angle(angle, 0.0));
                if same_angle(angle, 0.0) { 0 } else { next }
            })
            .collect();
        let mut digit = vec![None; angles.len()];
        for (own, &at) in (0..).zip(&place) {
            digit[at as usize] = Some(own);
        }
        let explorer = Explorer {
            size,
            per_block: radices[7] * radices[8],
            per_crank: radices[8],
            radices,
            units,
            arrangement,
            arranged_loads,
            arranged_views,
            differences: DifferenceTable::new(&angles),
            angles,
            place,
            digit,
            resolutions: resolutions(&request),
            fires: space.firing,
            meter: None,
            request,
        };
        Ok(explorer)
    }

    /// The request.
    pub fn request(&self) -> &ExploreRequest {
        &self.request
    }

    /// Number of cases, those of invalid geometry, and duplicates, included.
    pub fn size(&self) -> u128 {
        self.size
    }

    /// Part `part` (from 1) of `parts`: all parts together are all cases once.
    ///
    /// # Errors
    /// [`ExploreError::Part`] for a part that there is not.
    pub fn part(&self, part: u64, parts: u64) -> Result<Run, ExploreError> {
        if part == 0 || part > parts {
            return Err(ExploreError::Part { part, parts });
        }
        let (n, whole, rest) =
            (u128::from(parts), self.size / u128::from(parts), self.size % u128::from(parts));
        // whole * k + rest * k / n does not overflow where size * k would.
        let at = |k: u64| whole * u128::from(k) + rest * u128::from(k) / n;
        Ok(Run { from: at(part - 1), to: at(part) })
    }

    /// A search of which nothing is known yet.
    pub fn start(&self) -> Exploration {
        Exploration {
            version: EXPLORATION_VERSION,
            size: self.size,
            objectives: self.request.objectives.iter().map(|objective| objective.name()).collect(),
            done: Vec::new(),
            counts: self.no_counts(),
            front: Vec::new(),
            ranking: Vec::new(),
            sample: Vec::new(),
        }
    }

    /// Objectives in whole steps of their resolution: what is compared.
    pub fn steps(&self, values: &[f64]) -> Vec<i64> {
        values.iter().zip(&self.resolutions).map(|(value, step)| (value / step).round() as i64).collect()
    }

    /// Joins what two runs of this search have found.
    ///
    /// # Errors
    /// [`ExploreError::Merge`] where they are not of this search or have looked at the same cases.
    pub fn merge(&self, one: Exploration, other: Exploration) -> Result<Exploration, ExploreError> {
        let blank = self.start();
        for part in [&one, &other] {
            let kinds =
                |e: &Exploration| e.counts.broken.iter().map(|b| b.constraint.clone()).collect::<Vec<_>>();
            if (part.version, part.size, &part.objectives) != (blank.version, blank.size, &blank.objectives)
                || kinds(part) != kinds(&blank)
            {
                return Err(ExploreError::Merge { reason: "they are not results of this search" });
            }
        }
        let mut whole = one;
        for run in &other.done {
            whole.mark(*run)?;
        }
        whole.counts.add(&other.counts);
        let mut front = Front::of(std::mem::take(&mut whole.front));
        front.merge(other.front, self.request.most_on_front)?;
        let mut ranking = Ranking::of(std::mem::take(&mut whole.ranking), self.request.most_listed);
        ranking.merge(other.ranking);
        (whole.front, whole.ranking) = (front.sorted(), ranking.into_candidates());
        let mut sample = Sample::of(std::mem::take(&mut whole.sample));
        sample.merge(other.sample);
        whole.sample = sample.into_cases();
        Ok(whole)
    }

    /// The layout of a case, whether it is an engine or not.
    ///
    /// # Errors
    /// [`ExploreError::NoSuchCase`] beyond the space.
    pub fn layout(&self, case: u128) -> Result<Layout, ExploreError> {
        if case >= self.size {
            return Err(ExploreError::NoSuchCase { last: self.size - 1, got: case });
        }
        let space = &self.request.space;
        let mut layout = self.sizes(&self.size_digits(case / self.per_block));
        layout.case = case;
        let mut throws = vec![0; space.groups()];
        self.set_throws(case % self.per_block / self.per_crank, &mut throws);
        layout.throw_angles = throws.iter().map(|&throw| self.angles[throw as usize]).collect();
        if self.fires {
            let units = layout.firing_units();
            let pin = |unit: &FiringUnit| layout.throw_angles[unit.group] + unit.lead;
            let mut firing = Firing::new(space.parts.strokes.revolutions(), layout.neighbours());
            firing.set_crank(units.iter().map(|unit| (pin(unit), unit.axis)));
            firing.set_code((case % self.per_crank) as u64);
            let cycle = TAU * f64::from(space.parts.strokes.revolutions());
            let first = layout.first_firing();
            let angles: Vec<f64> =
                firing.angles().iter().map(|angle| (first + angle).rem_euclid(cycle)).collect();
            layout.firing_angles = Some(layout.by_cylinder(angles));
        }
        Ok(layout)
    }

    /// The case of a layout of this space: the inverse of [`Explorer::layout`]. `None` where it is not in the space.
    pub fn case_of(&self, layout: &Layout) -> Option<u128> {
        let space = &self.request.space;
        let at = |list: &[f64], value: f64| list.iter().position(|own| *own == value);
        let mut digits = [0; 7];
        digits[0] = at(&space.spacings, layout.spacing)?;
        if let (Banks::Two { bank_angles, split_angles, staggers }, Some(pair)) = (&space.banks, layout.banks)
        {
            digits[1] = at(bank_angles, pair.bank_angle)?;
            digits[2] = at(split_angles, pair.split_angle)?;
            digits[3] = at(staggers, pair.stagger)?;
        }
        digits[4] = at(&space.rod_ratios, layout.rod_ratio)?;
        digits[5] = space.counterweights.iter().position(|own| *own == layout.counterweights)?;
        digits[6] = space.shafts.iter().position(|own| *own == layout.shafts)?;
        let mut case = 0;
        for (digit, radix) in digits.iter().zip(self.radices) {
            case = case * radix + *digit as u128;
        }
        if layout.groups() != space.groups() || layout.firing_angles.is_some() != self.fires {
            return None;
        }
        for angle in &layout.throw_angles[1..] {
            let place = self.angles.iter().position(|own| same_angle(*own, *angle))?;
            case = case * self.place.len() as u128 + u128::from(self.digit[place]?);
        }
        case *= self.per_crank;
        let Some(firing) = &layout.firing_angles else { return Some(case) };
        (case..case + self.per_crank).find(|&code| {
            let same = |a: &f64, b: &f64| same_angle(0.5 * a, 0.5 * b);
            let own = self.layout(code).ok().and_then(|own| own.firing_angles);
            own.is_some_and(|own| own.iter().zip(firing).all(|(a, b)| same(a, b)))
        })
    }

    /// First- and second-order loads of a case, balance shafts included.
    ///
    /// # Errors
    /// [`ExploreError`] beyond the space, or where the case is no engine.
    pub fn orders(&self, case: u128) -> Result<LayoutOrders, ExploreError> {
        let layout = self.layout(case)?;
        let orders = Block::of_layout(&self.request.space.parts, &layout)?;
        Ok(self.with_shafts(orders, &layout))
    }

    pub(crate) fn no_counts(&self) -> Counts {
        Counts::new(self.request.constraints.iter().map(|constraint| constraint.name()).collect())
    }

    /// Digits of the sizes of a block.
    pub(crate) fn size_digits(&self, block: u128) -> [usize; 7] {
        let mut rest = block;
        let mut digits = [0; 7];
        for place in (0..7).rev() {
            digits[place] = (rest % self.radices[place]) as usize;
            rest /= self.radices[place];
        }
        digits
    }

    /// Places of the throws' angles of a crank of a block.
    #[inline]
    pub(crate) fn set_throws(&self, crank: u128, throws: &mut [u16]) {
        let count = self.place.len() as u128;
        let mut rest = crank;
        throws[0] = 0;
        for throw in throws[1..].iter_mut().rev() {
            *throw = self.place[(rest % count) as usize];
            rest /= count;
        }
    }

    /// Order of two cranks by their digits; `None` where an angle of the first is not in the list.
    #[inline]
    pub(crate) fn compare(&self, image: &[u16], own: &[u16]) -> Option<Ordering> {
        let mut order = Ordering::Equal;
        for (a, b) in image.iter().zip(own).skip(1) {
            order = order.then(self.digit[*a as usize]?.cmp(&self.digit[*b as usize]?));
        }
        Some(order)
    }

    /// The layout of these sizes, all throws at angle 0.
    pub(crate) fn sizes(&self, digits: &[usize; 7]) -> Layout {
        let space = &self.request.space;
        let banks = match &space.banks {
            Banks::InLine | Banks::AsGiven(_) => None,
            Banks::Two { bank_angles, split_angles, staggers } => Some(BankPair {
                bank_angle: bank_angles[digits[1]],
                split_angle: split_angles[digits[2]],
                stagger: staggers[digits[3]],
            }),
        };
        Layout {
            case: 0,
            cylinders: space.cylinders,
            spacing: space.spacings[digits[0]],
            banks,
            rod_ratio: space.rod_ratios[digits[4]],
            counterweights: space.counterweights[digits[5]].clone(),
            shafts: space.shafts[digits[6]].clone(),
            throw_angles: vec![0.0; space.groups()],
            firing_angles: None,
            arrangement: self.arrangement.clone(),
        }
    }

    /// Why these sizes have an invalid geometry.
    pub(crate) fn invalid(&self, digits: &[usize; 7], layout: &Layout) -> Option<Invalid> {
        let parts = &self.request.space.parts;
        let several = layout.groups() > 1;
        if layout.arrangement.is_some() {
            // What the engine of the file is made of fits.
            None
        } else if self.units[digits[4]].is_none() {
            Some(Invalid::RodTooShort)
        } else if several && layout.spacing < parts.web_distance + parts.web_thickness {
            Some(Invalid::WebsOverlap)
        } else if several && layout.spacing < parts.bore {
            Some(Invalid::BoresOverlap)
        } else {
            None
        }
    }

    /// The cranks of these sizes, prepared.
    pub(crate) fn block(&self, digits: &[usize; 7], layout: &Layout) -> Block {
        if let Some(loads) = self.arranged_loads.get(digits[5]) {
            return Block::of_arrangement(loads, layout.groups(), &self.angles);
        }
        let unit =
            self.units[digits[4]].as_ref().expect("invariant: sizes of invalid geometry are not prepared");
        Block::new(&self.request.space.parts, unit, layout, &self.angles)
    }

    /// Loads with the layout's balance shafts.
    #[inline]
    pub(crate) fn with_shafts(&self, mut orders: LayoutOrders, layout: &Layout) -> LayoutOrders {
        for shaft in &layout.shafts.shafts {
            shaft.add_to(&mut orders);
        }
        orders
    }

    /// Sum of the weights on the webs [kg m]: the same for every crank, since a weight turns with its throw.
    pub(crate) fn counterweights(&self, digits: &[usize; 7], layout: &Layout) -> f64 {
        if let Some(loads) = self.arranged_loads.get(digits[5]) {
            return loads.counterweights;
        }
        let parts = &self.request.space.parts;
        let weights = (0..layout.groups()).flat_map(|group| layout.web_weights(parts, group));
        weights.map(|(_, weight)| weight.norm()).sum()
    }

    /// An objective that depends on sizes alone.
    pub(crate) fn size_value(&self, objective: Objective, layout: &Layout) -> f64 {
        let parts = &self.request.space.parts;
        match objective {
            Objective::Length => length(layout, parts.end_length),
            Objective::Height => match &layout.arrangement {
                Some(arrangement) => arrangement.height(),
                None => parts.crank_radius + parts.crank_radius / layout.rod_ratio,
            },
            Objective::Shafts => layout.shafts.shafts.len() as f64,
            _ => 0.0,
        }
    }
}

/// Distance of the outermost cylinder axes, and the ends [m].
fn length(layout: &Layout, ends: f64) -> f64 {
    if let Some(arrangement) = &layout.arrangement {
        return arrangement.length() + ends;
    }
    let stagger = layout.banks.map_or(0.0, |pair| pair.stagger.abs());
    (layout.groups() as f64 - 1.0) * layout.spacing + stagger + ends
}

/// Refuses objectives and limits that cannot be.
fn check(request: &ExploreRequest) -> Result<(), ExploreError> {
    if request.objectives.is_empty() {
        return Err(ExploreError::NoObjective);
    }
    if !(request.resolution > 0.0 && request.resolution < 1.0) {
        let got = request.resolution;
        return Err(ExploreError::Number { quantity: "resolution", needed: "above 0 and below 1", got });
    }
    let limited = request.constraints.iter().filter_map(|constraint| match constraint {
        Constraint::AtMost { objective, .. } => Some(*objective),
        _ => None,
    });
    for objective in request.objectives.iter().copied().chain(limited) {
        if let Some(order) = objective.order().filter(|order| !(1..=2).contains(order)) {
            let got = f64::from(order);
            return Err(ExploreError::Number { quantity: "order of an objective", needed: "1 or 2", got });
        }
        if objective == (Objective::FiringHarmonic { half_orders: 0 }) {
            return Err(ExploreError::Number {
                quantity: "half orders of a firing harmonic",
                needed: "1 or more",
                got: 0.0,
            });
        }
        if objective.level() == Level::Firing && !request.space.firing {
            return Err(ExploreError::FiringLeftOut { what: objective.name() });
        }
    }
    for constraint in &request.constraints {
        let of_groups = matches!(constraint, Constraint::BearingRoom { .. } | Constraint::PinOverlap { .. });
        if let Some(arrangement) = request.space.arrangement().filter(|_| of_groups) {
            let (what, engine) = (constraint.name(), arrangement.name.clone());
            return Err(ExploreError::FixedPins { what, engine });
        }
        if constraint.level() == Level::Firing && !request.space.firing {
            return Err(ExploreError::FiringLeftOut { what: constraint.name() });
        }
        if !constraint.number().is_finite() {
            let got = constraint.number();
            return Err(ExploreError::Number { quantity: "limit of a constraint", needed: "finite", got });
        }
    }
    Ok(())
}

/// What is one step of each objective.
fn resolutions(request: &ExploreRequest) -> Vec<f64> {
    let (space, parts) = (&request.space, &request.space.parts);
    let mass = parts.reciprocating_mass() + parts.rod_big_end_mass;
    let unbalance = space.cylinders as f64 * mass * parts.crank_radius
        + space.groups() as f64 * parts.throw_unbalance.abs();
    let force = unbalance * parts.speed * parts.speed;
    let widest = space.spacings.iter().copied().fold(0.0, f64::max);
    let length = space.groups() as f64 * widest + parts.end_length + parts.web_distance;
    let scale = |objective: &Objective| match objective.unit() {
        "N" => force,
        "N m" => force * length,
        "kg m" => unbalance,
        "m" => length,
        _ => 1.0,
    };
    request.objectives.iter().map(|objective| request.resolution * scale(objective)).collect()
}
