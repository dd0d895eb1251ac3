//! What a counterweight is asked for.

use lanchester_model::{DesignLimits, Range, ShapeTask, Shoulder};
use lanchester_shape::{GeometryError, plausible_density};
use serde::{Deserialize, Serialize};

/// A counterweight to be found: its duty, the range of each dimension, limits.
///
/// Searched are the shapes whose shoulders do not taper inwards and whose crown is not within the web's disc.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
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
        }
    }

    /// Whether every number has a meaning.
    ///
    /// # Errors
    /// The first number that has none.
    pub fn check(&self) -> Result<(), GeometryError> {
        plausible_density(self.density)?;
        let error = |quantity, needed, got, hint| Err(GeometryError::Number { quantity, needed, got, hint });
        let positive = [("unbalance [kg m]", self.unbalance), ("least balance", self.least_balance)];
        for (quantity, got) in positive {
            if !(got > 0.0 && got.is_finite()) {
                return error(quantity, "positive", got, "give what the counterweight must balance");
            }
        }
        if let Some(most) = self.most_balance
            && (most.is_nan() || most < self.least_balance)
        {
            return error("most balance", "at least the least balance", most, "widen the range of balance");
        }
        let quarter = std::f64::consts::FRAC_PI_2;
        let turn = std::f64::consts::TAU;
        // Beyond this the height of the trapezoid follows its width by more than a factor of fifty: give the height instead.
        let steep = 89f64.to_radians();
        let mut ranges = vec![
            ("web radius r [m]", self.web_radius, true, f64::INFINITY),
            ("rectangle height h [m]", self.rectangle_height, false, f64::INFINITY),
            ("arc radius R [m]", self.arc_radius, true, f64::INFINITY),
            ("arc angle alpha [rad]", self.arc_angle, true, turn),
            ("thickness [m]", self.thickness, true, f64::INFINITY),
            match self.shoulder {
                Shoulder::Angle(range) => ("shoulder angle delta [rad]", range, false, steep),
                Shoulder::Height(range) => ("shoulder height H [m]", range, false, f64::INFINITY),
            },
        ];
        ranges.extend(
            self.limits.shoulder_angle.map(|r| ("limit of the shoulder angle [rad]", r, false, quarter)),
        );
        ranges.extend(
            self.limits
                .shoulder_height
                .map(|r| ("limit of the shoulder height [m]", r, false, f64::INFINITY)),
        );
        for (quantity, range, above_zero, most) in ranges {
            let Range { least, most: largest } = range;
            if !(least.is_finite() && largest.is_finite()) {
                let got = if least.is_finite() { largest } else { least };
                return error(quantity, "finite", got, "give the range within which the shape is searched");
            }
            if least < 0.0 || (above_zero && least == 0.0) {
                let needed = if above_zero { "positive" } else { "zero or more" };
                return error(quantity, needed, least, "raise the least value of the range");
            }
            if largest < least {
                return error(
                    quantity,
                    "a range from small to large",
                    largest,
                    "exchange both ends of the range",
                );
            }
            if largest > most || (most == turn && largest == most) {
                let needed = match most {
                    m if m == turn => "less than a full turn",
                    m if m == quarter => "at most a quarter turn",
                    _ => "at most 89 degrees",
                };
                return error(quantity, needed, largest, "for steeper shoulders give their height instead");
            }
        }
        let limits = [
            ("limit of the mass [kg]", self.limits.mass),
            ("limit of the swept radius [m]", self.limits.swept_radius),
            ("limit of the inertia [kg m2]", self.limits.inertia),
            ("limit of the half width [m]", self.limits.half_width),
        ];
        for (quantity, limit) in limits {
            if let Some(got) = limit
                && !(got > 0.0 && got.is_finite())
            {
                return error(quantity, "positive", got, "leave the limit out if there is none");
            }
        }
        Ok(())
    }
}
