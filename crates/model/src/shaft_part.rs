//! Weights of balance shafts as parts: the file's `[shaft.weights.shape]`.

use lanchester_shape::{GeometryError, Part, ShaftWeightShape};
use serde::Serialize;

/// A weight of a balance shaft as a part: what a disc has beyond a chord, around the shaft.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ShaftWeightPart {
    /// Its shape; `x` of the shape points along the `phase` of the weight.
    pub shape: ShaftWeightShape,
    /// Its length along the shaft [m], its middle in the plane of the weight.
    pub length: f64,
    /// Its density [kg/m^3].
    pub density: f64,
    /// The unbalance that it should have [kg m], if the file says so.
    pub wanted: Option<f64>,
}

impl ShaftWeightPart {
    /// Its unbalance [kg m], along `x` of the shape. The shaft within it is in balance.
    pub fn unbalance(&self) -> f64 {
        self.density * self.length * self.shape.moments().first.x
    }

    /// Its mass [kg], without the shaft within it.
    pub fn mass(&self) -> f64 {
        self.density * self.length * self.shape.moments().area
    }

    /// Its moment of inertia about the axis of the shaft [kg m^2], without the shaft within it.
    pub fn polar_inertia(&self) -> f64 {
        self.density * self.length * self.shape.moments().polar()
    }

    /// The weight and the piece of the shaft within it, with its middle plane at z = 0.
    ///
    /// # Errors
    /// Where its dimensions are not possible.
    pub fn part(&self) -> Result<Part, GeometryError> {
        Part::new(self.shape.outline()?, self.length, self.density)
    }
}
