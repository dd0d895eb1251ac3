//! Sizes of a web with its pin and journal, as UR M53 names them.

use crate::ratios::SectionRatios;
use serde::Serialize;

/// Sizes of a web with its pin and journal [m].
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct WebSection {
    /// Diameter of the pin, D.
    pub pin_diameter: f64,
    /// Diameter of its bore, D_BH; 0 for none.
    pub pin_bore: f64,
    /// Radius of the pin's fillet, R_H.
    pub pin_fillet: f64,
    /// Depth of its undercut, T_H.
    pub pin_recess: f64,
    /// Diameter of the oil bore in the pin, D_O; `None`: there is none.
    pub oil_bore: Option<f64>,
    /// Diameter of the journal, D_G.
    pub journal_diameter: f64,
    /// Diameter of its bore, D_BG; 0 for none.
    pub journal_bore: f64,
    /// Radius of the journal's fillet, R_G.
    pub journal_fillet: f64,
    /// Depth of its undercut, T_G.
    pub journal_recess: f64,
    /// Crank radius, E.
    pub crank_radius: f64,
    /// Thickness of the web along the crank, W.
    pub web_thickness: f64,
    /// Width of the web across its throw in the middle of the overlap, B.
    pub web_width: f64,
}

impl WebSection {
    /// How far pin and journal overlap, S = (D + D_G)/2 - E [m]; negative where they do not.
    pub fn overlap(&self) -> f64 {
        0.5 * (self.pin_diameter + self.journal_diameter) - self.crank_radius
    }

    /// Its ratios to the pin's diameter.
    pub fn ratios(&self) -> SectionRatios {
        let over = |length: f64| length / self.pin_diameter;
        SectionRatios {
            s: over(self.overlap()),
            w: over(self.web_thickness),
            b: over(self.web_width),
            r_pin: over(self.pin_fillet),
            r_journal: over(self.journal_fillet),
            d_journal: over(self.journal_bore),
            d_pin: over(self.pin_bore),
            d_oil: self.oil_bore.map(over),
            t_pin: over(self.pin_recess),
            t_journal: over(self.journal_recess),
        }
    }
}
