//! The scatter of residual loads: what is told.

use crate::scatter::request::Output;
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const SCATTER_VERSION: u32 = 1;

/// Scatter of all outputs.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
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
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
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
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Percentile {
    /// Share of the samples, from 0 to 1.
    pub share: f64,
    /// What this share does not exceed.
    pub value: f64,
}

/// How an output stands to a limit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
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
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Contribution {
    /// Place of the tolerance in the request, from 0.
    pub tolerance: usize,
    /// First-order index: share of the output's variance that would vanish if the deviations of this tolerance, one at a
    /// time, were known. Shares sum to 1 less what only several together do.
    pub share: f64,
    /// Its standard error: what other samples of the same number would change, about.
    pub error: f64,
}

/// A deviation that is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
pub struct Deviation {
    /// Place of its tolerance in the list, from 0.
    pub tolerance: usize,
    /// Index of the part; `None` for all parts together.
    pub part: Option<usize>,
}
