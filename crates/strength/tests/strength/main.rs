//! Formulas after UR M53, sheets, fatigue at a point.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod findley;
mod rule;
