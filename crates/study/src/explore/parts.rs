//! What all layouts of a space share: strokes, speed, and the parts that they are made of.

use crate::explore::error::ExploreError;
use lanchester_model::Strokes;
use serde::{Deserialize, Serialize};

/// The parts of which every layout of a space is made, and the speed at which it is judged.
///
/// Cylinders are equal and centred. A *group* is what stands at one place along the crank: one cylinder of an in-line
/// engine, a pair of two banks.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Parts {
    /// Strokes in a working cycle.
    pub strokes: Strokes,
    /// Speed of the crankshaft [rad/s].
    pub speed: f64,
    /// Crank radius [m].
    pub crank_radius: f64,
    /// Mass of a piston with pin, rings and clips [kg].
    pub piston_mass: f64,
    /// Mass of a rod that counts at the crankpin [kg].
    pub rod_big_end_mass: f64,
    /// Mass of a rod that counts at the piston pin [kg].
    pub rod_small_end_mass: f64,
    /// Moment of inertia of a rod about its centre of gravity [kg m^2]; `None`: that of its two masses.
    pub rod_inertia: Option<f64>,
    /// Unbalance of the crank itself at one group, pins and plain webs [kg m]; split pins have half of it each.
    pub throw_unbalance: f64,
    /// Distance of the outer web planes of a group [m]: its counterweights stand half of it before and behind its middle.
    pub web_distance: f64,
    /// Thickness of a web along the crank [m].
    pub web_thickness: f64,
    /// Diameter of a crankpin [m].
    pub pin_diameter: f64,
    /// Bore [m].
    pub bore: f64,
    /// What the engine is longer than the distance of its outermost cylinder axes [m], both ends together.
    pub end_length: f64,
}

impl Parts {
    /// Reciprocating mass of one cylinder [kg].
    pub fn reciprocating_mass(&self) -> f64 {
        self.piston_mass + self.rod_small_end_mass
    }

    /// Refuses numbers of which no engine is made.
    pub(crate) fn check(&self) -> Result<(), ExploreError> {
        let positive = [
            ("speed [rad/s]", self.speed),
            ("crank radius [m]", self.crank_radius),
            ("piston mass [kg]", self.piston_mass),
            ("web distance [m]", self.web_distance),
            ("pin diameter [m]", self.pin_diameter),
            ("bore [m]", self.bore),
        ];
        let not_negative = [
            ("big-end mass [kg]", self.rod_big_end_mass),
            ("small-end mass [kg]", self.rod_small_end_mass),
            ("rod inertia [kg m^2]", self.rod_inertia.unwrap_or(0.0)),
            ("web thickness [m]", self.web_thickness),
            ("length of the ends [m]", self.end_length),
        ];
        for (quantity, got) in positive {
            if !(got > 0.0 && got.is_finite()) {
                return Err(ExploreError::Number { quantity, needed: "positive and finite", got });
            }
        }
        for (quantity, got) in not_negative {
            if !(got >= 0.0 && got.is_finite()) {
                return Err(ExploreError::Number { quantity, needed: "finite and not negative", got });
            }
        }
        if !self.throw_unbalance.is_finite() {
            let quantity = "unbalance of a throw [kg m]";
            return Err(ExploreError::Number { quantity, needed: "finite", got: self.throw_unbalance });
        }
        Ok(())
    }
}
