//! What a counterweight is asked for.

use lanchester_shape::GeometryError;
use lanchester_task::{DesignLimits, DesignSettings, Objective, Range, ShapeTask, Shoulder};
use serde::{Deserialize, Serialize};

/// A counterweight to be found: its duty, the range of each dimension, limits.
///
/// Searched are the shapes whose shoulders do not taper inwards and whose crown is not within the web's disc.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct DesignTask {
    /// Unbalance that is full balance [kg m].
    pub unbalance: f64,
    /// Least unbalance as a part of it: 1 for full balance.
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
    pub settings: DesignSettings,
}

impl DesignTask {
    /// The duty `unbalance` [kg m] within what `task` allows.
    pub fn new(unbalance: f64, task: &ShapeTask) -> DesignTask {
        DesignTask {
            unbalance,
            least_balance: task.least_balance,
            most_balance: task.most_balance,
            density: task.density,
            web_radius: task.web_radius,
            rectangle_height: task.rectangle_height,
            shoulder: task.shoulder,
            arc_radius: task.arc_radius,
            arc_angle: task.arc_angle,
            thickness: task.thickness,
            limits: task.limits,
            settings: task.settings,
        }
    }

    /// Whether every number has a meaning.
    ///
    /// # Errors
    /// The first number that has none.
    pub fn check(&self) -> Result<(), GeometryError> {
        if !(self.unbalance > 0.0 && self.unbalance.is_finite()) {
            return Err(GeometryError::Number {
                quantity: "unbalance [kg m]",
                needed: "positive",
                got: self.unbalance,
                hint: "give what the counterweight must balance",
            });
        }
        self.settings.check()?;
        self.shapes().faults().into_iter().next().map_or(Ok(()), |fault| Err(fault.error))
    }

    /// What is searched, without the duty.
    fn shapes(&self) -> ShapeTask {
        ShapeTask {
            minimise: Objective::Mass,
            least_balance: self.least_balance,
            most_balance: self.most_balance,
            density: self.density,
            web_radius: self.web_radius,
            rectangle_height: self.rectangle_height,
            shoulder: self.shoulder,
            arc_radius: self.arc_radius,
            arc_angle: self.arc_angle,
            thickness: self.thickness,
            limits: self.limits,
            settings: self.settings,
        }
    }
}
