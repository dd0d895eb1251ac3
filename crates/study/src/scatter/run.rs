//! The scatter of residual loads: what is asked for, and what is told.

use crate::explore::Sense;
use crate::scatter::error::ScatterError;
use crate::scatter::scattering::Scattering;
use lanchester_model::Engine;
use lanchester_results::{self as results, Quantity};
use lanchester_task::Tolerance;
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const SCATTER_VERSION: u32 = 1;

/// A residual load whose scatter is asked for: a size, 0 being best.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
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
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Limit {
    /// Which output.
    pub output: Output,
    /// Largest value that is good, in its unit.
    pub value: f64,
}

/// What to draw and what to tell.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ScatterRequest {
    /// The nominal engine: one crankshaft, plain rods.
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

/// Scatter of all outputs.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Scatter {
    /// [`SCATTER_VERSION`].
    pub version: u32,
    /// Samples drawn.
    pub samples: u64,
    /// Seed.
    pub seed: u64,
    /// Deviations drawn for each sample.
    pub variables: usize,
    /// By output, in the order of the request.
    pub outputs: Vec<OutputScatter>,
}

/// Scatter of one output.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OutputScatter {
    /// Which.
    pub output: Output,
    /// Of the nominal engine.
    pub nominal: f64,
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub deviation: f64,
    /// Smallest of the samples.
    pub least: f64,
    /// Largest of the samples.
    pub most: f64,
    /// Number of the sample that has it, from 0.
    pub most_sample: u64,
    /// Percentiles in the order of the request.
    pub percentiles: Vec<Percentile>,
    /// Largest relative error of the percentiles: 0 where all samples were kept.
    pub percentile_error: f64,
    /// Against its limits, in the order of the request.
    pub capabilities: Vec<Capability>,
    /// Which tolerance the scatter comes from, in the order of the request.
    pub contributions: Vec<Contribution>,
}

/// A percentile.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Percentile {
    /// Share of the samples, from 0 to 1.
    pub share: f64,
    /// What this share does not exceed.
    pub value: f64,
}

/// How an output stands to a limit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Capability {
    /// The limit.
    pub limit: f64,
    /// `(limit - mean) / (3 standard deviations)`: for a normal distribution.
    pub cpk: f64,
    /// `(limit - median) / (99.865 % percentile - median)`: for any distribution (ISO 22514-2).
    pub cpk_by_percentiles: f64,
    /// Samples beyond the limit.
    pub beyond: u64,
}

/// What one tolerance adds to the scatter.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Contribution {
    /// Place of the tolerance in the request, from 0.
    pub tolerance: usize,
    /// First-order index: share of the output's variance that would vanish if the deviations of this tolerance, one at a
    /// time, were known. Shares sum to 1 less what only several together do.
    pub share: f64,
    /// Its standard error: what other samples of the same number would change, about.
    pub error: f64,
}

/// Scatter of the outputs over samples of the engine.
///
/// Sample `k` depends on seed and `k` alone, and sums do not depend on their order: the result is the same for any number
/// of threads. [`Scattering`] draws the same samples stretch by stretch.
///
/// # Errors
/// [`ScatterError`] where the request is impossible or the engine is of a kind that is not computed.
pub fn scatter(request: &ScatterRequest) -> Result<Scatter, ScatterError> {
    let scattering = Scattering::new(request.clone())?;
    let tally = scattering.draw_all(0..request.samples)?;
    scattering.scatter(&tally).ok_or(ScatterError::NoSample)
}
