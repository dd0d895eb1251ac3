//! Gears, pulleys and other wheels that turn with the crank at a fixed ratio: the file's `[[gear]]`.

use crate::origin::Sourced;
use crate::ratio::Ratio;
use serde::Serialize;
use std::f64::consts::PI;

/// A balanced wheel geared to crankshaft 1, or fixed to it where its ratio is 1.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Gear {
    /// Name for tables.
    pub name: String,
    /// Speed over that of crankshaft 1, signed; never 0.
    pub ratio: Ratio,
    /// Position of its axis [m].
    pub x: f64,
    /// Position of its axis [m].
    pub y: f64,
    /// Moment of inertia about its axis, and what turns with it [kg m^2], where the file gives it.
    pub inertia: Option<f64>,
    /// Its shape, where the file gives that instead.
    pub disc: Option<GearDisc>,
}

/// A wheel as a disc with a bore. Lengths in m.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct GearDisc {
    /// Outer diameter, of a gear that of the pitch circle [m].
    pub diameter: f64,
    /// Diameter of its bore [m]; 0 for none.
    pub bore: f64,
    /// Width along its axis [m].
    pub width: f64,
    /// Density [kg/m^3].
    pub density: f64,
}

impl GearDisc {
    /// Mass [kg].
    pub fn mass(&self) -> f64 {
        self.density * self.width * PI / 4.0 * (self.diameter.powi(2) - self.bore.powi(2))
    }

    /// Moment of inertia about its axis [kg m^2].
    ///
    /// ```text
    /// J = m (D^2 + d^2) / 8
    /// ```
    pub fn inertia(&self) -> f64 {
        self.mass() * (self.diameter.powi(2) + self.bore.powi(2)) / 8.0
    }
}

impl Gear {
    /// Moment of inertia about its axis [kg m^2]; `None` where the file gives neither it nor a shape.
    pub fn inertia(&self) -> Option<Sourced> {
        let shaped = self.disc.map(|disc| Sourced::from_shape(disc.inertia()));
        self.inertia.map(Sourced::given).or(shaped)
    }
}
