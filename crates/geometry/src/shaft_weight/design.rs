//! A weight of a shaft with its dimensions, and what became of a task.

use super::nearest::NearestShaftWeight;
use lanchester_model::ShaftWeightPart;
use lanchester_shape::ShaftWeightShape;
use serde::Serialize;

/// A weight with its dimensions.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ShaftWeightDesign {
    /// Its shape.
    pub shape: ShaftWeightShape,
    /// Its length [m].
    pub length: f64,
    /// Its density [kg/m^3].
    pub density: f64,
    /// Its mass without the shaft [kg].
    pub mass: f64,
    /// Its unbalance [kg m].
    pub unbalance: f64,
    /// Its moment of inertia about the shaft's axis [kg m^2], without the shaft.
    pub polar_inertia: f64,
    /// Distance of its centre from the axis [m], without the shaft.
    pub centre: f64,
}

impl ShaftWeightDesign {
    /// A weight of this shape.
    pub fn new(shape: ShaftWeightShape, length: f64, density: f64) -> ShaftWeightDesign {
        let part = ShaftWeightPart { shape, length, density, wanted: None };
        let (mass, unbalance, polar_inertia) = (part.mass(), part.unbalance(), part.polar_inertia());
        let centre = shape.moments().centroid().x;
        ShaftWeightDesign { shape, length, density, mass, unbalance, polar_inertia, centre }
    }

    /// The weight as a part that should have the unbalance `wanted` [kg m].
    pub fn part(&self, wanted: f64) -> ShaftWeightPart {
        let ShaftWeightDesign { shape, length, density, .. } = *self;
        ShaftWeightPart { shape, length, density, wanted: Some(wanted) }
    }
}

/// What became of a task.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "outcome")]
pub enum ShaftWeightOutcome {
    /// The best weight: none within the ranges is better, rounding apart; of least inertia by more than one part in a million.
    Best(ShaftWeightDesign),
    /// No weight within the ranges has the unbalance.
    Infeasible {
        /// The least unbalance within the ranges [kg m].
        least: f64,
        /// The largest one [kg m].
        most: f64,
        /// For each limit alone the nearest value with which there is a weight; none is listed that cannot help alone.
        nearest: Vec<NearestShaftWeight>,
    },
}
