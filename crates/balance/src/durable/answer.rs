//! What the search answers: plain data in SI units.

use crate::answer::{Answer, Effect, FoundWeight};
use crate::durable::moved::moved;
use crate::fitted::fitted;
use crate::settings::StopCause;
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, DurabilityCriterion, DurabilityWish, Measured, Unmeasured};
use num_complex::Complex64;
use serde::Serialize;

/// Version of [`Durable`]; raised when a field changes its meaning or goes.
pub const DURABLE_VERSION: u32 = 1;

/// How far a search goes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct DurableSettings {
    /// Most engines whose films and safeties are computed, 1 or more.
    pub most_evaluations: usize,
}

impl Default for DurableSettings {
    /// 400 engines.
    fn default() -> DurableSettings {
        DurableSettings { most_evaluations: 400 }
    }
}

/// Films and safeties of an engine with the weights of an optimum, and with those that a local search made of them.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Durable {
    /// [`DURABLE_VERSION`].
    pub version: u32,
    /// Film of every main bearing, least film of the big ends, safety after UR M53, and what else is wanted.
    pub rows: Vec<DurableRow>,
    /// What must hold.
    pub limits: Vec<DurableLimit>,
    /// How the search ended.
    pub end: DurableEnd,
    /// Engines whose films and safeties were computed for the search.
    pub evaluations: usize,
    /// The stages with the moved weights; empty where none was moved.
    pub stages: Vec<DurableStage>,
    /// The weights, moved or as the optimum has them.
    pub weights: Vec<FoundWeight>,
    /// Criteria before and after with the moved weights, as [`Answer::effects`] has them at the optimum; empty where none was moved.
    pub effects: Vec<Effect>,
}

/// A film or safety before, at the optimum and after.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct DurableRow {
    /// Which.
    pub criterion: DurabilityCriterion,
    /// Its name for tables.
    pub name: String,
    /// Its SI unit; empty for a plain number.
    pub unit: String,
    /// With the weights that the engine had.
    pub before: Measured,
    /// With those of the proved optimum.
    pub optimum: Measured,
    /// With those of the search.
    pub after: Measured,
}

/// A film or safety that must not fall below a value.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct DurableLimit {
    /// Which.
    pub criterion: DurabilityCriterion,
    /// Its name for tables.
    pub name: String,
    /// Its SI unit; empty for a plain number.
    pub unit: String,
    /// The smallest value allowed.
    pub least: f64,
    /// What was reached; `None` where it is not known.
    pub value: Option<f64>,
    /// Whether it holds; `None` where it is not known.
    pub is_met: Option<bool>,
}

/// A stage of the balancing with moved weights.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct DurableStage {
    /// SI unit, or `1` for a weighted sum.
    pub unit: String,
    /// At the proved optimum.
    pub optimum: f64,
    /// How far it may be raised.
    pub allowed: f64,
    /// With the moved weights.
    pub value: f64,
}

/// How a local search ended. Whatever it found: a global optimum is not claimed.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum DurableEnd {
    /// Nothing was wanted: films and safeties are reported alone.
    NotAsked,
    /// The proved optimum holds all that must hold: it is the optimum of the limited problem too.
    NotNeeded,
    /// Weights were moved.
    Moved,
    /// Nothing near the optimum, nor any start, was better.
    NothingBetter,
    /// The search was stopped: the best so far stands.
    Stopped {
        /// Why.
        cause: StopCause,
    },
    /// Weights cannot change it.
    NoWeights {
        /// Why.
        reason: String,
    },
    /// What is wanted is not known.
    NotMeasured(Unmeasured),
}

impl Durable {
    /// As the optimum has it.
    pub(super) fn unmoved(answer: &Answer, rows: Vec<DurableRow>, wish: &DurabilityWish) -> Durable {
        let mut found = Durable {
            version: DURABLE_VERSION,
            rows,
            limits: Vec::new(),
            end: DurableEnd::NotAsked,
            evaluations: 0,
            stages: Vec::new(),
            weights: answer.weights.clone(),
            effects: Vec::new(),
        };
        found.judge(wish);
        found
    }

    /// Sets the limits beside what was reached.
    pub(super) fn judge(&mut self, wish: &DurabilityWish) {
        let limit = |one: &lanchester_task::AtLeast| {
            let row = self.rows.iter().find(|row| row.criterion == one.criterion);
            let value = row.and_then(|row| row.after.value());
            DurableLimit {
                criterion: one.criterion,
                name: one.criterion.title(),
                unit: one.criterion.unit().to_owned(),
                least: one.least,
                value,
                is_met: value.map(|value| value >= one.least * (1.0 - 1e-9)),
            }
        };
        self.limits = wish.at_least.iter().map(limit).collect();
    }

    pub(super) fn take(&mut self, task: &BalanceTask, unbalances: Vec<Complex64>) {
        for ((found, free), unbalance) in self.weights.iter_mut().zip(&task.weights).zip(unbalances) {
            if found.unbalance != unbalance {
                found.unbalance = unbalance;
                found.used = unbalance.norm() > 0.0;
                found.mass = free.radius.map(|radius| unbalance.norm() / radius);
            }
        }
    }

    /// Whether weights were moved.
    pub fn is_moved(&self) -> bool {
        !self.stages.is_empty()
    }

    /// Whether all that must hold does.
    pub fn is_met(&self) -> bool {
        self.limits.iter().all(|limit| limit.is_met == Some(true))
    }

    /// Whether what was asked to be large could be looked for.
    pub fn is_searched(&self) -> bool {
        !matches!(self.end, DurableEnd::NoWeights { .. } | DurableEnd::NotMeasured(_))
    }

    /// The answer with these weights and what they do: its stages, with their proof, stay those of the optimum.
    pub fn answer(&self, answer: &Answer) -> Answer {
        let mut moved = answer.clone();
        if self.is_moved() {
            moved.weights.clone_from(&self.weights);
            moved.effects.clone_from(&self.effects);
        }
        moved
    }

    /// The engine with these weights.
    pub fn engine(&self, engine: &Engine, answer: &Answer) -> Engine {
        let unbalances: Vec<Complex64> = self.weights.iter().map(|weight| weight.unbalance).collect();
        fitted(engine, &moved(answer, &unbalances))
    }
}
