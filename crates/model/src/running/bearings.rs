//! Sizes of the bearings: the file's `[bearings]`.

use serde::Serialize;

/// Sizes of the plain bearings, the same for all of a kind.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Bearings {
    /// Piston pin in the rod's small end.
    pub piston_pin: Option<PlainBearing>,
    /// Crankpin in one rod's big end.
    pub crankpin: Option<PlainBearing>,
    /// Main journals.
    pub main: Option<PlainBearing>,
}

/// Size of a plain bearing.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PlainBearing {
    /// Diameter of the pin or journal [m]; `None` where the crank's body has it.
    pub diameter: Option<f64>,
    /// Width that carries [m].
    pub width: f64,
}
