//! Ratios of a throw's sizes to the pin's diameter, and where the formulas hold.

use serde::Serialize;
use std::fmt;

/// Sizes over the pin's diameter D [1].
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct SectionRatios {
    /// Overlap of pin and journal, ((D + D_G)/2 - E)/D.
    pub s: f64,
    /// Thickness of the web, W/D.
    pub w: f64,
    /// Width of the web, B/D.
    pub b: f64,
    /// Fillet of the pin, R_H/D.
    pub r_pin: f64,
    /// Fillet of the journal, R_G/D.
    pub r_journal: f64,
    /// Bore of the journal, D_BG/D.
    pub d_journal: f64,
    /// Bore of the pin, D_BH/D.
    pub d_pin: f64,
    /// Oil bore, D_O/D.
    pub d_oil: Option<f64>,
    /// Undercut of the pin's fillet, T_H/D.
    pub t_pin: f64,
    /// Undercut of the journal's fillet, T_G/D.
    pub t_journal: f64,
}

/// A ratio outside the range in which the formulas hold.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct RangeBreach {
    /// Which one: "b = B/D".
    pub ratio: &'static str,
    /// Its value.
    pub value: f64,
    /// Where the formulas hold.
    pub range: [f64; 2],
}

impl fmt::Display for RangeBreach {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let RangeBreach { ratio, value, range: [low, high] } = self;
        if *ratio == OVERLAP && value < low {
            return write!(
                f,
                "{ratio} = {value:.4}: pin and journal do not overlap, where the rule takes a reduced web thickness, which is not covered"
            );
        }
        let (side, by) = if value < low { ("below", low - value) } else { ("above", value - high) };
        write!(f, "{ratio} = {value:.4} is {side} the range {low} to {high} by {by:.4}")
    }
}

const OVERLAP: &str = "s = S/D";

/// A ratio on a limit may miss it by rounding.
const ROUNDING: f64 = 1e-9;

impl SectionRatios {
    /// What lies outside the range of the formulas for this web; the oil bore is apart, [`SectionRatios::oil_breach`].
    ///
    /// Below s = 0 the formulas themselves go on, but want the web thickness reduced, which is not covered.
    pub fn breaches(&self) -> Vec<RangeBreach> {
        let all = [
            (OVERLAP, self.s, [0.0, 0.5]),
            ("w = W/D", self.w, [0.2, 0.8]),
            ("b = B/D", self.b, [1.1, 2.2]),
            ("r = R_H/D", self.r_pin, [0.03, 0.13]),
            ("r = R_G/D", self.r_journal, [0.03, 0.13]),
            ("d_G = D_BG/D", self.d_journal, [0.0, 0.8]),
            ("d_H = D_BH/D", self.d_pin, [0.0, 0.8]),
        ];
        all.into_iter().filter_map(|(ratio, value, range)| breach(ratio, value, range)).collect()
    }

    /// The oil bore where it is too large for the formulas.
    pub fn oil_breach(&self) -> Option<RangeBreach> {
        breach("d_O = D_O/D", self.d_oil?, [0.0, 0.2])
    }
}

fn breach(ratio: &'static str, value: f64, range: [f64; 2]) -> Option<RangeBreach> {
    let inside = value >= range[0] - ROUNDING && value <= range[1] + ROUNDING;
    (!inside).then_some(RangeBreach { ratio, value, range })
}
