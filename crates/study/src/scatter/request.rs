//! The scatter of residual loads: what is asked for.

use crate::explore::Sense;
use lanchester_model::Engine;
use lanchester_results::{self as results, Quantity};
use lanchester_task::Tolerance;
use serde::Serialize;

/// A residual load whose scatter is asked for: a size, 0 being best.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Output {
    /// Largest resultant of the force of order 1 or 2 [N].
    Force {
        /// Order.
        order: u32,
    },
    /// Largest resultant of the couple of order 1 or 2 about the origin [N m].
    Couple {
        /// Order.
        order: u32,
    },
    /// Part of the force of order 1 or 2 that turns in one sense [N].
    ForceSense {
        /// Order.
        order: u32,
        /// Sense.
        sense: Sense,
    },
    /// Part of the couple of order 1 or 2 that turns in one sense [N m].
    CoupleSense {
        /// Order.
        order: u32,
        /// Sense.
        sense: Sense,
    },
    /// Largest resultant force of all orders, over the continuous crank angle [N].
    PeakForce,
    /// Largest resultant couple of all orders, over the continuous crank angle [N m].
    PeakCouple,
}

impl Output {
    /// What it is in the words of all studies.
    pub fn output(self) -> results::Output {
        let of = |quantity, order: u32| results::Output::of(quantity).order(f64::from(order));
        match self {
            Output::Force { order } => of(Quantity::Force, order),
            Output::Couple { order } => of(Quantity::Couple, order),
            Output::ForceSense { order, sense } => of(Quantity::Force, order).turning(sense),
            Output::CoupleSense { order, sense } => of(Quantity::Couple, order).turning(sense),
            Output::PeakForce => results::Output::of(Quantity::Force),
            Output::PeakCouple => results::Output::of(Quantity::Couple),
        }
    }

    /// Name for tables.
    pub fn name(self) -> String {
        self.output().sized_title()
    }

    /// Its unit.
    pub fn unit(self) -> &'static str {
        self.output().unit()
    }

    pub(crate) fn is_couple(self) -> bool {
        matches!(self, Output::Couple { .. } | Output::CoupleSense { .. } | Output::PeakCouple)
    }

    pub(crate) fn is_peak(self) -> bool {
        matches!(self, Output::PeakForce | Output::PeakCouple)
    }

    pub(crate) fn order(self) -> Option<u32> {
        match self {
            Output::Force { order }
            | Output::Couple { order }
            | Output::ForceSense { order, .. }
            | Output::CoupleSense { order, .. } => Some(order),
            Output::PeakForce | Output::PeakCouple => None,
        }
    }
}

/// A limit that an output should keep.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Limit {
    /// Which output.
    pub output: Output,
    /// Largest value that is good, in its unit.
    pub value: f64,
}

/// What to draw and what to tell.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ScatterRequest {
    /// The nominal engine; crankshafts and shafts turn at whole multiples of the speed of crankshaft 1.
    pub engine: Engine,
    /// Speed of the crankshaft [rad/s]; `None`: the highest of the engine.
    pub speed: Option<f64>,
    /// What varies.
    pub tolerances: Vec<Tolerance>,
    /// What is asked for.
    pub outputs: Vec<Output>,
    /// Limits on outputs that are asked for.
    pub limits: Vec<Limit>,
    /// Shares of the samples, from 0 to 1, whose largest values are told.
    pub percentiles: Vec<f64>,
    /// Number of samples.
    pub samples: u64,
    /// Seed of the draws: the same seed draws the same samples, the first of them the same whatever their number.
    pub seed: u64,
}
