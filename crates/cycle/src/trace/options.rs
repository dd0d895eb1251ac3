//! What is told about a file of pressures beside its text.

use serde::Serialize;

/// What is told about a file of pressures beside its text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TraceOptions<'a> {
    /// Its name, for messages.
    pub name: &'a str,
    /// Length of the working cycle [rad]: 2 pi or 4 pi.
    pub cycle: f64,
    /// Whether its pressures count from that of the surroundings.
    pub gauge: bool,
    /// Pressure of the surroundings [Pa].
    pub ambient_pressure: f64,
    /// Angle of the file at firing top dead centre [rad].
    pub top_dead_centre: f64,
    /// What was measured.
    pub place: TracePlace,
}

/// Where pressures were measured: it decides what is plausible.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum TracePlace {
    /// In a cylinder.
    Cylinder,
    /// Under the piston.
    Crankcase,
}
