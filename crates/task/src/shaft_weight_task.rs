//! Among which shapes the weights of balance shafts are to be found: the file's `[shaft_weight_design]`.

use crate::shape_task::{Range, ShapeFault};
use lanchester_shape::{GeometryError, ShaftWeightShape, plausible_density};
use serde::{Deserialize, Serialize};

/// What of a shaft's weight is made as small as possible.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ShaftWeightAim {
    /// Its mass.
    Mass,
    /// Its length along the shaft; among equal ones its mass.
    Length,
    /// Its radius; among equal ones its mass.
    Radius,
    /// Its moment of inertia about the axis of the shaft.
    Inertia,
}

/// Shapes among which the weight of a shaft is to be found. Its duty, the unbalance, is that of the weight.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct ShaftWeightTask {
    /// What is made as small as possible.
    pub minimise: ShaftWeightAim,
    /// Density [kg/m^3].
    pub density: f64,
    /// Radius `r` of the shaft [m].
    pub shaft_radius: f64,
    /// Radius `R` of the weight [m]; the largest is its envelope.
    pub radius: Range,
    /// Distance `c` of the chord from the axis [m]; negative on the far side.
    pub chord: Range,
    /// Length `L` along the shaft [m].
    pub length: Range,
}

impl ShaftWeightTask {
    /// The numbers that have no meaning, by the keys of `[shaft_weight_design]`; none if a weight can be searched.
    pub fn faults(&self) -> Vec<ShapeFault> {
        let mut faults = Vec::new();
        if let Err(error) = plausible_density(self.density) {
            faults.push(ShapeFault { key: "density", error });
        }
        let mut add = |key, quantity, needed, got, hint| {
            faults.push(ShapeFault { key, error: GeometryError::Number { quantity, needed, got, hint } });
        };
        for (key, quantity, range) in [
            ("radius", "radius of the weight [m]", self.radius),
            ("chord", "distance of the chord [m]", self.chord),
            ("length", "length of the weight [m]", self.length),
        ] {
            let is_range = range.least <= range.most && range.least.is_finite() && range.most.is_finite();
            if !is_range {
                let needed = "a finite range from small to large";
                add(key, quantity, needed, range.most, "exchange both ends");
            }
        }
        if self.length.least <= 0.0 {
            let hint = "raise the least length";
            add("length", "length of the weight [m]", "positive", self.length.least, hint);
        }
        let corner = |radius, chord| ShaftWeightShape { shaft_radius: self.shaft_radius, radius, chord };
        if let Err(fault) = fault_of(corner(self.radius.least, self.chord.least)) {
            faults.push(fault);
        } else if let Err(fault) = fault_of(corner(self.radius.least, self.chord.most)) {
            faults.push(fault);
        }
        faults
    }
}

/// Whether the dimensions of a shape are possible; if not, the key of the one that is not.
/// What is wrong with a shape, with the key of the dimension that is to blame.
///
/// # Errors
/// [`ShapeFault`] where its dimensions are not possible.
pub fn fault_of(shape: ShaftWeightShape) -> Result<(), ShapeFault> {
    shape.checked().map(|_| ()).map_err(|error| {
        let key = if shape.shaft_radius.is_nan() || shape.shaft_radius <= 0.0 {
            "shaft_diameter"
        } else if shape.radius.is_nan() || shape.radius <= shape.shaft_radius {
            "radius"
        } else {
            "chord"
        };
        ShapeFault { key, error }
    })
}
