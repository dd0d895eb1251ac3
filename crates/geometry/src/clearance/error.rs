//! Why a clearance cannot be computed.

use lanchester_shape::GeometryError;
use thiserror::Error;

/// Why a clearance cannot be computed.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ClearanceError {
    /// The engine says nothing of what the crankshaft must stay clear of.
    #[error(
        "the engine has no crankcase, skirt, liner or rod envelope to stay clear of\nhint: add a section [clearance]"
    )]
    NoEnvelope,
    /// Nothing that turns has a shape.
    #[error(
        "no counterweight has an outline and the crankshaft has no webs\nhint: give a counterweight its shape, or the section [crank.body]"
    )]
    NoShape,
    /// A piston or liner of unknown diameter.
    #[error(
        "cylinder {cylinder} has no bore, which its piston and liner need\nhint: add bore to the engine file"
    )]
    NoBore {
        /// Cylinder, from 1.
        cylinder: usize,
    },
    /// The motions are not those of the engine's cylinders.
    #[error(
        "needed the motion of {needed} cylinders, got {got}\nhint: give one motion for each cylinder, by number"
    )]
    Motions {
        /// Cylinders of the engine.
        needed: usize,
        /// Motions given.
        got: usize,
    },
    /// A number that cannot be.
    #[error("{quantity} must be {needed}, got {got}")]
    Number {
        /// Which number.
        quantity: &'static str,
        /// What is possible.
        needed: &'static str,
        /// What was given.
        got: f64,
    },
    /// A part or an obstacle that the engine does not have.
    #[error("there is no {what}, needed one of those that the clearances list")]
    Unknown {
        /// What was asked for.
        what: String,
    },
    /// Crankshafts that stand as before after very many turns only.
    #[error(
        "crankshafts at the speed ratios {first} and {second} stand as before after more than {limit} turns only\nhint: give the ratios as fractions of small numbers"
    )]
    PeriodTooLong {
        /// One ratio.
        first: String,
        /// The other one.
        second: String,
        /// Most turns that are searched.
        limit: u32,
    },
    /// The outline of a plain web.
    #[error("web {web}: {source}")]
    Web {
        /// Web, from 1.
        web: usize,
        /// What is wrong.
        source: GeometryError,
    },
}
