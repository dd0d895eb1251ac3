//! What a counterweight may look like and what is wanted of it: the file's `[counterweight_design]`.

use serde::{Deserialize, Serialize};

/// Least and most of a dimension; equal where it is fixed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Range {
    /// Least value.
    pub least: f64,
    /// Largest value.
    pub most: f64,
}

impl Range {
    /// From `least` to `most`.
    pub const fn new(least: f64, most: f64) -> Range {
        Range { least, most }
    }

    /// One value.
    pub const fn fixed(value: f64) -> Range {
        Range { least: value, most: value }
    }
}

/// How the flank between rectangle and arc is given.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Shoulder {
    /// By the angle `delta` between chord and flank [rad], from 0 (a flat step) to less than a quarter turn. The height follows.
    Angle(Range),
    /// By the height `H` of the trapezoid [m]. The angle follows.
    Height(Range),
}

/// Limits on what follows from the dimensions. `None`: no limit.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct DesignLimits {
    /// Largest mass [kg].
    pub mass: Option<f64>,
    /// Largest swept radius of web and counterweight [m].
    pub swept_radius: Option<f64>,
    /// Largest polar inertia of the counterweight about the crank axis [kg m^2].
    pub inertia: Option<f64>,
    /// Largest half width of the counterweight, across its axis [m].
    pub half_width: Option<f64>,
    /// Least and largest shoulder angle `delta` [rad].
    pub shoulder_angle: Option<Range>,
    /// Least and largest trapezoid height `H` [m].
    pub shoulder_height: Option<Range>,
}

/// What is made as small as possible.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Objective {
    /// Mass of the counterweight [kg].
    Mass,
    /// Swept radius of web and counterweight [m].
    SweptRadius,
    /// Polar inertia of the counterweight about the crank axis [kg m^2].
    Inertia,
    /// Thickness [m].
    Thickness,
}

/// Shapes among which a counterweight is to be found. Its duty, the unbalance, is that of the weight.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ShapeTask {
    /// What is made as small as possible.
    pub minimise: Objective,
    /// Least unbalance as a part of the duty: 1 for full balance.
    pub least_balance: f64,
    /// Largest unbalance as a part of it, if there is one.
    pub most_balance: Option<f64>,
    /// Density [kg/m^3].
    pub density: f64,
    /// Radius `r` of the web's disc [m].
    pub web_radius: Range,
    /// Height `h` of the rectangle [m].
    pub rectangle_height: Range,
    /// The flank.
    pub shoulder: Shoulder,
    /// Radius `R` of the arc [m].
    pub arc_radius: Range,
    /// Included angle `alpha` of the arc [rad].
    pub arc_angle: Range,
    /// Thickness [m].
    pub thickness: Range,
    /// Limits.
    pub limits: DesignLimits,
}
