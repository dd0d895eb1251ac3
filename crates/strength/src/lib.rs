//! Strength of crankshafts: formulas after IACS UR M53, fatigue at a point after Findley.
//!
//! SI units. Loads over the cycle and stress histories come in as numbers; nothing here knows where they come from.
//!
//! ```
//! use lanchester_strength::{RuleFactors, WebSection};
//! let section = WebSection {
//!     pin_diameter: 0.048, journal_diameter: 0.055, crank_radius: 0.04775, web_thickness: 0.02, web_width: 0.08,
//!     pin_fillet: 0.003, journal_fillet: 0.003, ..WebSection::default()
//! };
//! let factors = RuleFactors::new(&section.ratios());
//! assert!((factors.alpha_b.value - 2.7196).abs() < 5e-5);
//! ```
#![forbid(unsafe_code)]

mod circle;
mod crank_throws;
mod element_factors;
mod error;
mod factors;
mod fatigue_strength;
mod findley;
mod nominal;
mod ratios;
mod section;
mod sheet;

pub use circle::{Circle, smallest_circle};
pub use crank_throws::{RuleThrow, rule_throws};
pub use element_factors::FilletStresses;
pub use error::{Need, StrengthError};
pub use factors::{Factor, FactorPart, FactorValues, OilFactors, RuleFactors};
pub use fatigue_strength::{fatigue_strength, oil_bore_radius};
pub use findley::{
    CriticalPlane, FatigueLimits, Findley, LimitsError, PointFatigue, StressState, static_safety, von_mises,
};
pub use nominal::{NominalBore, NominalWeb, alternation};
pub use ratios::{RangeBreach, SectionRatios};
pub use section::WebSection;
pub use sheet::{
    ACCEPTABLE, ADDITIONAL, BoreSheet, ElementWeb, FilletSheet, RULE_WORDS, RuleMaterial, ThrowLoad,
    ThrowSheet, WebSheet, rule_sheet,
};
