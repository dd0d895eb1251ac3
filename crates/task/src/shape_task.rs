//! What a counterweight may look like and what is wanted of it: the file's `[counterweight_design]`.

use lanchester_shape::{GeometryError, plausible_density};
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Least and most of a dimension; equal where it is fixed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
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
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub enum Shoulder {
    /// By the angle `delta` between chord and flank [rad], from 0 (a flat step) to less than a quarter turn. The height follows.
    Angle(Range),
    /// By the height `H` of the trapezoid [m]. The angle follows.
    Height(Range),
}

/// Limits on what follows from the dimensions. `None`: no limit.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
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
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
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
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
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
    /// How far the proof goes.
    #[serde(default)]
    pub settings: DesignSettings,
}

/// How far the proof of a best shape goes: branch and bound over boxes of shapes.
///
/// A wider gap ends it earlier, more boxes let a search that stopped go on.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct DesignSettings {
    /// No shape is better than the one found by more than this share of what is made small: 1e-6 to 0.5.
    pub gap: f64,
    /// Most boxes examined for one optimum, 1 or more; where they do not do, the result says that it is not proved.
    pub max_boxes: usize,
}

impl DesignSettings {
    /// The gap where none is asked for, and the smallest that may be.
    pub const PROVED_GAP: f64 = 1e-6;

    /// Refuses what is outside its range.
    ///
    /// # Errors
    /// [`GeometryError::Number`].
    pub fn check(&self) -> Result<(), GeometryError> {
        let refuse = |quantity, needed, got, hint| Err(GeometryError::Number { quantity, needed, got, hint });
        if !(Self::PROVED_GAP..=0.5).contains(&self.gap) {
            let hint = "the proof works with rounding of about 1e-12 of the scaled formulas";
            return refuse("gap of the proof", "from 1e-6 to 0.5 of the value", self.gap, hint);
        }
        if self.max_boxes == 0 {
            let hint = "some hundred to some ten thousand are usual";
            return refuse("largest number of boxes of the proof", "1 or more", 0.0, hint);
        }
        Ok(())
    }
}

impl Default for DesignSettings {
    fn default() -> DesignSettings {
        DesignSettings { gap: Self::PROVED_GAP, max_boxes: 200_000 }
    }
}

/// A number of a [`ShapeTask`] that has no meaning.
#[derive(Debug, Clone, PartialEq)]
pub struct ShapeFault {
    /// Key of the engine file that holds it, dotted: `arc_angle`, `limits.shoulder_angle`.
    pub key: &'static str,
    /// What is wrong with it.
    pub error: GeometryError,
}

/// Shoulders steeper than this [rad] have a height that follows the width by more than a factor of fifty.
pub const STEEPEST: f64 = 89.0 * PI / 180.0;

impl ShapeTask {
    /// The numbers that have no meaning, in the order of the keys of the engine file; none if a shape can be searched.
    pub fn faults(&self) -> Vec<ShapeFault> {
        let mut faults = Vec::new();
        if let Err(error) = plausible_density(self.density) {
            faults.push(ShapeFault { key: "density", error });
        }
        let mut add = |key, quantity, needed, got, hint| {
            faults.push(ShapeFault { key, error: GeometryError::Number { quantity, needed, got, hint } });
        };
        if !(self.least_balance > 0.0 && self.least_balance.is_finite()) {
            let hint = "give what the counterweight must balance";
            add("balance", "least balance", "positive", self.least_balance, hint);
        } else if let Some(most) = self.most_balance
            && (most.is_nan() || most < self.least_balance)
        {
            let hint = "widen the range of balance";
            add("balance", "most balance", "at least the least balance", most, hint);
        }
        let endless = f64::INFINITY;
        let mut ranges = vec![
            ("web_radius", "web radius r [m]", self.web_radius, true, endless),
            ("rectangle_height", "rectangle height h [m]", self.rectangle_height, false, endless),
            ("arc_radius", "arc radius R [m]", self.arc_radius, true, endless),
            ("arc_angle", "arc angle alpha [rad]", self.arc_angle, true, TAU),
            ("thickness", "thickness [m]", self.thickness, true, endless),
            match self.shoulder {
                Shoulder::Angle(range) => {
                    ("shoulder_angle", "shoulder angle delta [rad]", range, false, STEEPEST)
                }
                Shoulder::Height(range) => {
                    ("shoulder_height", "shoulder height H [m]", range, false, endless)
                }
            },
        ];
        ranges.extend(self.limits.shoulder_angle.map(|range| {
            ("limits.shoulder_angle", "limit of the shoulder angle [rad]", range, false, FRAC_PI_2)
        }));
        ranges.extend(self.limits.shoulder_height.map(|range| {
            ("limits.shoulder_height", "limit of the shoulder height [m]", range, false, endless)
        }));
        for (key, quantity, Range { least, most: largest }, above_zero, most) in ranges {
            if !(least.is_finite() && largest.is_finite()) {
                let got = if least.is_finite() { largest } else { least };
                let hint = "give the range within which the shape is searched";
                add(key, quantity, "finite", got, hint);
            } else if least < 0.0 || (above_zero && least == 0.0) {
                let needed = if above_zero { "positive" } else { "zero or more" };
                add(key, quantity, needed, least, "raise the least value of the range");
            } else if largest < least {
                let hint = "exchange both ends of the range";
                add(key, quantity, "a range from small to large", largest, hint);
            } else if most == TAU && largest >= most {
                add(key, quantity, "less than a full turn", largest, "lower the largest value of the range");
            } else if largest > most {
                let needed = if most == FRAC_PI_2 { "at most a quarter turn" } else { "at most 89 degrees" };
                add(key, quantity, needed, largest, "for steeper shoulders give their height instead");
            }
        }
        let limits = [
            ("limits.mass", "limit of the mass [kg]", self.limits.mass),
            ("limits.swept_radius", "limit of the swept radius [m]", self.limits.swept_radius),
            ("limits.inertia", "limit of the inertia [kg m2]", self.limits.inertia),
            ("limits.half_width", "limit of the half width [m]", self.limits.half_width),
        ];
        for (key, quantity, limit) in limits {
            if let Some(got) = limit
                && !(got > 0.0 && got.is_finite())
            {
                add(key, quantity, "positive", got, "leave the limit out if there is none");
            }
        }
        faults
    }
}
