//! Weights outside that are to come off, and slugs that may take their place.

use serde::Serialize;

/// A weight outside the crankcase that is to come off.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct External {
    /// What carries it.
    pub name: String,
    /// Where along the shaft [m].
    pub z: f64,
    /// Mass times radius [kg m], not negative.
    pub unbalance: f64,
    /// Angle on the rotor [rad].
    pub angle: f64,
}

/// Heavy-metal slugs that may be set into the counterweights.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SlugRoom {
    /// Diameter [m].
    pub diameter: f64,
    /// Longest slug [m].
    pub longest: f64,
    /// Density of the slug [kg/m^3].
    pub density: f64,
    /// Density of the crank [kg/m^3].
    pub crank_density: f64,
    /// Least metal between holes and between a hole and the rim [m].
    pub land: f64,
    /// Outer radius of the counterweight [m].
    pub rim: f64,
    /// Angle between the outermost slugs that a counterweight has room for [rad].
    pub sector: f64,
}
