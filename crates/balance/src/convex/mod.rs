//! Convex programmes over the continuous cycle: solved, polished and proved.

mod certificate;
mod cone;
pub(crate) mod curve;
pub(crate) mod dense;
mod exchange;
mod kkt;
mod polish;
pub(crate) mod programme;

pub(crate) use exchange::{Failure, GAP, HOLDS, better, proved, solve};
