//! Why a study of scatter is refused.

use lanchester_mechanism::LoadError;
use lanchester_model::Fault;

/// Why a study of scatter is refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ScatterError {
    /// A number lies outside what is possible.
    #[error("{quantity} must be {needed}, got {got}")]
    Number {
        /// Which number.
        quantity: &'static str,
        /// What is possible.
        needed: &'static str,
        /// What was asked for.
        got: f64,
    },
    /// Nothing varies.
    #[error(
        "a scatter needs at least one tolerance, got none\nhint: add [tolerances] to the engine file, for example piston_mass = {{ plus_minus = \"1.5 g\" }}"
    )]
    NoTolerance,
    /// Nothing is asked for.
    #[error("a scatter needs at least one output, got none")]
    NoOutput,
    /// No sample was drawn.
    #[error("a scatter needs at least one sample, got none")]
    NoSample,
    /// What is kept of two stretches of samples does not fit together.
    #[error(
        "what is kept of the samples before {to} and of those from {from} on does not join to one scatter\nhint: they are of two runs, or one between them is missing"
    )]
    NotJoined {
        /// The sample behind the first stretch.
        to: u64,
        /// The first sample of the second.
        from: u64,
    },
    /// A limit on an output that is not asked for.
    #[error("limit {place} is on the {output}, which is not among the outputs\nhint: ask for it too")]
    LimitWithoutOutput {
        /// Place of the limit in the list, from 1.
        place: usize,
        /// Its output in words.
        output: String,
    },
    /// A limit on something whose scatter is not reported.
    #[error("the scatter tells {needed}; got a limit on `{got}`\nhint: give the limit on one of these")]
    Criterion {
        /// What it tells.
        needed: &'static str,
        /// What the limit is on.
        got: String,
    },
    /// A tolerance on parts that the engine does not have.
    #[error("tolerance {place} is on {quantity}, but the engine has none")]
    NoSuchPart {
        /// Place of the tolerance in the list, from 1.
        place: usize,
        /// What it is on.
        quantity: &'static str,
    },
    /// A tolerance within which an engine cannot turn, or a mass is negative.
    #[error(
        "within the tolerances cylinder {cylinder} would be no cylinder: {reason}\nhint: make the tolerance smaller"
    )]
    Impossible {
        /// Number of the cylinder, from 1.
        cylinder: usize,
        /// Why.
        reason: &'static str,
    },
    /// A drawn engine that none can be.
    #[error("within the tolerances an engine is drawn that cannot be: {0}")]
    Sample(Fault),
    /// An engine of a kind whose scatter is not computed.
    #[error(
        "the scatter needs {needed}, got {got}\nhint: the orders of a scatter are whole ones: give it a ratio without a fraction, or leave it out of the file"
    )]
    Engine {
        /// What is needed.
        needed: &'static str,
        /// What the engine has.
        got: String,
    },
    /// Numbers of parts that do not fit the cylinders.
    #[error("each of the {cylinders} cylinders needs one {part}, got {got}")]
    Parts {
        /// Cylinders.
        cylinders: usize,
        /// Which part.
        part: &'static str,
        /// How many there are.
        got: usize,
    },
    /// The loads of the engine cannot be computed.
    #[error(transparent)]
    Load(#[from] LoadError),
}
