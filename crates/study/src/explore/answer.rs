//! The answer of a search, for people and programs: the front with its layouts in full, and where an engine stands in it.

use crate::explore::counts::Counts;
use crate::explore::error::ExploreError;
use crate::explore::explorer::{EXPLORATION_VERSION, Exploration, Explorer, Run};
use crate::explore::layout::Layout;
use crate::explore::layout_orders::LayoutOrders;
use crate::explore::objective::Objective;
use crate::explore::sample::JudgedCase;
use crate::explore::space::ChoiceCount;
use lanchester_task::{AtLeast, DurabilityCriterion, Measured};
use serde::Serialize;

/// What a search found.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ExploreAnswer {
    /// [`EXPLORATION_VERSION`].
    pub version: u32,
    /// Name of the engine from whose parts the layouts are made.
    pub engine: String,
    /// Speed at which they are judged [rad/s].
    pub speed: f64,
    /// Cylinders of each layout.
    pub cylinders: usize,
    /// Cases of the space.
    pub size: u128,
    /// Choices with more than one value: the product of their counts is the size.
    pub choices: Vec<ChoiceCount>,
    /// What the layouts are judged by.
    pub objectives: Vec<JudgedBy>,
    /// What they must hold, in words.
    pub constraints: Vec<String>,
    /// What the user should know of the space.
    pub notes: Vec<String>,
    /// What has been looked at: the whole space, or the part that was asked for.
    pub done: Vec<Run>,
    /// What became of the cases.
    pub counts: Counts,
    /// Pareto-optimal layouts, by the first objective.
    pub front: Vec<FoundLayout>,
    /// The first kinds of layout by the objectives in their order.
    pub ranking: Vec<FoundLayout>,
    /// Some of the judged cases, evenly from all of them: what the front is the edge of.
    pub sample: Vec<JudgedCase>,
    /// Films and safeties that are told of the layouts found.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub durability: Vec<DurabilityCriterion>,
    /// What the layouts found hold of them, in words: a limit that was judged for layouts alone that no other covers.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub at_least: Vec<String>,
    /// Where the engine of the file stands, with its own weights and shafts.
    pub given: Option<GivenEngine>,
}

/// An objective with its name and unit.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct JudgedBy {
    /// The objective.
    pub objective: Objective,
    /// Its name.
    pub name: String,
    /// Its unit, empty for a plain number.
    pub unit: &'static str,
}

/// A layout that was found.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FoundLayout {
    /// Its number in the list, from 1.
    pub number: usize,
    /// The layout.
    pub layout: Layout,
    /// Its objectives in the order of the request, in SI units.
    pub values: Vec<f64>,
    /// Cases with equal objectives, this one included.
    pub alike: u128,
    /// Cylinders by firing; `None` where firing is left out.
    pub firing_order: Option<Vec<usize>>,
    /// Largest difference of a firing interval from the even one [rad]; `None` where firing is left out.
    pub unevenness: Option<f64>,
    /// All its loads of orders 1 and 2.
    pub orders: LayoutOrders,
    /// Films and safeties, in the order of [`ExploreAnswer::durability`]; empty where they were not asked for.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub durability: Vec<Measured>,
}

/// Where an engine stands in a search.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct GivenEngine {
    /// Its objectives as it is; `None` where it does not tell.
    pub values: Vec<Option<f64>>,
    /// Constraints that it breaks, in words.
    pub broken: Vec<String>,
    /// Numbers of the layouts of the front that beat it; none where an objective is not known.
    pub beaten_by: Vec<usize>,
    /// Number of the layout of the front that has its objectives.
    pub equals: Option<usize>,
    /// Its case, weights and shafts apart; `None` where it is not in the space.
    pub case: Option<u128>,
    /// Why it is not in the space, in words.
    pub outside: Option<String>,
}

impl Explorer {
    /// The answer that people read, of what is known.
    ///
    /// # Errors
    /// [`ExploreError`] where the exploration is not of this search.
    pub fn answer(
        &self,
        exploration: &Exploration,
        engine: &str,
        notes: Vec<String>,
    ) -> Result<ExploreAnswer, ExploreError> {
        let request = self.request();
        let found = |list: &[crate::explore::Candidate]| {
            list.iter()
                .enumerate()
                .map(|(index, candidate)| {
                    let layout = self.layout(candidate.case)?;
                    Ok(FoundLayout {
                        number: index + 1,
                        values: candidate.values.clone(),
                        alike: candidate.alike,
                        firing_order: layout.firing_order(),
                        unevenness: layout.unevenness(request.space.parts.strokes),
                        orders: self.orders(candidate.case)?,
                        layout,
                        durability: Vec::new(),
                    })
                })
                .collect::<Result<Vec<_>, ExploreError>>()
        };
        let judged =
            |&objective: &Objective| JudgedBy { objective, name: objective.name(), unit: objective.unit() };
        Ok(ExploreAnswer {
            version: EXPLORATION_VERSION,
            engine: engine.to_owned(),
            speed: request.space.parts.speed,
            cylinders: request.space.cylinders,
            size: self.size(),
            choices: request.space.choices(),
            objectives: request.objectives.iter().map(judged).collect(),
            constraints: request.constraints.iter().map(|constraint| constraint.name()).collect(),
            notes,
            done: exploration.done.clone(),
            counts: exploration.counts.clone(),
            front: found(&exploration.front)?,
            ranking: found(&exploration.ranking)?,
            sample: exploration.sample.clone(),
            durability: Vec::new(),
            at_least: request.at_least.iter().map(limit_words).collect(),
            given: None,
        })
    }

    /// Tells films and safeties of the first layouts of front and ranking.
    ///
    /// # Errors
    /// [`ExploreError`] where nobody tells them, or more are asked for than may be.
    pub fn tell_durability(
        &self,
        answer: &mut ExploreAnswer,
        criteria: &[DurabilityCriterion],
        most: usize,
    ) -> Result<(), ExploreError> {
        answer.durability = criteria.to_vec();
        for found in answer.front.iter_mut().take(most).chain(answer.ranking.iter_mut().take(most)) {
            found.durability = self.durability(found.layout.case, criteria)?;
        }
        Ok(())
    }
}

/// "main-bearing film at least 2 um".
fn limit_words(limit: &AtLeast) -> String {
    let (factor, unit) = if limit.criterion.is_film() { (1e6, " um") } else { (1.0, "") };
    format!("{} at least {}{unit}", limit.criterion.title(), (factor * limit.least * 1e6).round() / 1e6)
}
