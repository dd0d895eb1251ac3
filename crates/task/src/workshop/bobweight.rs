//! The bobweight sheet: weighed parts, pin by pin.

use serde::Serialize;

/// The weighed parts of one cylinder [kg].
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct CylinderParts {
    /// Big end of the rod.
    pub big_end: f64,
    /// Both shells of the big-end bearing, if they were not weighed with the big end.
    pub bearing: f64,
    /// Small end of the rod.
    pub small_end: f64,
    /// Piston alone.
    pub piston: f64,
    /// Piston pin.
    pub piston_pin: f64,
    /// All rings of the piston.
    pub rings: f64,
    /// All locks or clips of the piston pin.
    pub locks: f64,
}

impl CylinderParts {
    /// Rotating mass [kg].
    pub fn rotating(&self) -> f64 {
        self.big_end + self.bearing
    }

    /// Reciprocating mass [kg].
    pub fn reciprocating(&self) -> f64 {
        self.small_end + self.piston + self.piston_pin + self.rings + self.locks
    }

    /// Names and masses in the order of the sheet.
    pub fn list(&self) -> [(&'static str, f64); 7] {
        [
            ("big end", self.big_end),
            ("bearing", self.bearing),
            ("small end", self.small_end),
            ("piston", self.piston),
            ("piston pin", self.piston_pin),
            ("rings", self.rings),
            ("locks", self.locks),
        ]
    }
}

/// One crankpin of a sheet.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PinParts {
    /// What it is called.
    pub name: String,
    /// Number of its throw in the engine file, from 1, where the sheet names one.
    pub throw: Option<usize>,
    /// Oil that turns with the pin [kg].
    pub oil: f64,
    /// The parts of every rod on it.
    pub cylinders: Vec<CylinderParts>,
}

/// What bobweights are made up for.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BobweightSheet {
    /// Share of the rotating masses that is balanced.
    pub rotating_share: f64,
    /// Share of the reciprocating masses that is balanced; `None`: the one with the smallest first order.
    pub reciprocating_share: Option<f64>,
    /// Bank angle of a V [rad].
    pub bank_angle: Option<f64>,
    /// How far the pin of bank 2 stands ahead of that of bank 1 [rad].
    pub split_angle: f64,
    /// Its pins.
    pub pins: Vec<PinParts>,
}
