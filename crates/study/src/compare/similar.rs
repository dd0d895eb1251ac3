//! Geometrically similar engines.
//!
//! Every length of an engine times `k`, its masses times `k^3`: the same engine in another size. At `k` times less speed its
//! pistons are as fast; with the same pressures over the crank angle it then is the same engine in every stress:
//!
//! ```text
//! F ~ m r w^2 ~ k^2      M, T, energy ~ k^3      unbalance ~ k^4      inertia ~ k^5      power ~ k^2
//! ```
//! Book, eqs. 31.1 to 31.3. At another speed it is similar to the original at the speed of equal piston speed.

use serde::Serialize;

/// In what engines are made equal before they are compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Equal {
    /// In nothing: as they are.
    #[default]
    AsTheyAre,
    /// In displacement.
    Displacement,
    /// In power.
    Power,
}

/// What a similar engine keeps of the original.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Held {
    /// Its speed.
    #[default]
    Speed,
    /// Its mean piston speed.
    PistonSpeed,
}

/// A similar engine: what its size and its speed are, over those of the original.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Similar {
    /// Lengths, over those of the original.
    pub length: f64,
    /// Speed of the crankshaft, over that of the original.
    pub speed: f64,
}

/// Why there is no similar engine.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SimilarError {
    /// A measure that is not positive cannot be made equal to another.
    #[error("equal {measure} needs a positive one of every engine, got {got}")]
    Measure {
        /// Which measure.
        measure: &'static str,
        /// What an engine has.
        got: f64,
    },
}

impl Similar {
    /// The engine as it is.
    pub const SAME: Similar = Similar { length: 1.0, speed: 1.0 };

    /// The engine in the size in which its displacement or power is `wanted`, having `own` in its own.
    ///
    /// Powers are compared at the same pressures over the crank angle.
    ///
    /// # Errors
    /// [`SimilarError`] where a measure is not positive and finite.
    pub fn of(equal: Equal, held: Held, own: f64, wanted: f64) -> Result<Similar, SimilarError> {
        let (measure, exponent) = match (equal, held) {
            (Equal::AsTheyAre, _) => return Ok(Similar::SAME),
            (Equal::Displacement, _) => ("displacement", 3.0),
            (Equal::Power, Held::Speed) => ("power", 3.0),
            (Equal::Power, Held::PistonSpeed) => ("power", 2.0),
        };
        if let Some(&got) = [own, wanted].iter().find(|value| !(**value > 0.0 && value.is_finite())) {
            return Err(SimilarError::Measure { measure, got });
        }
        let length = if own == wanted { 1.0 } else { (wanted / own).powf(1.0 / exponent) };
        let speed = match held {
            Held::Speed => 1.0,
            Held::PistonSpeed => 1.0 / length,
        };
        Ok(Similar { length, speed })
    }

    /// Speed of the original, over its own, at which its pistons are as fast as those of the similar engine: there its
    /// loads are those of the similar engine but for their factors.
    pub fn speed_of_original(self) -> f64 {
        self.length * self.speed
    }

    /// Forces at equal piston speed and pressures.
    pub fn force(self) -> f64 {
        self.length.powi(2)
    }

    /// Moments and energies at equal piston speed and pressures.
    pub fn moment(self) -> f64 {
        self.length.powi(3)
    }

    /// Volumes and masses.
    pub fn mass(self) -> f64 {
        self.length.powi(3)
    }

    /// Unbalances.
    pub fn unbalance(self) -> f64 {
        self.length.powi(4)
    }

    /// Moments of inertia.
    pub fn inertia(self) -> f64 {
        self.length.powi(5)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_made_equal_is_equal() {
        let by_volume = Similar::of(Equal::Displacement, Held::Speed, 1e-3, 2e-3).unwrap();
        assert!((by_volume.mass() - 2.0).abs() < 1e-15 && by_volume.speed == 1.0);
        let by_power = Similar::of(Equal::Power, Held::PistonSpeed, 40e3, 60e3).unwrap();
        assert!((by_power.length.powi(2) - 1.5).abs() < 1e-15);
        // Power = torque times speed.
        assert!((by_power.moment() * by_power.speed - 1.5).abs() < 1e-15);
        assert_eq!(by_power.speed_of_original(), 1.0);
        assert_eq!(Similar::of(Equal::AsTheyAre, Held::Speed, 0.0, 1.0), Ok(Similar::SAME));
        assert_eq!(Similar::of(Equal::Power, Held::Speed, 3.0, 3.0), Ok(Similar::SAME));
        let refused = Similar::of(Equal::Power, Held::Speed, 0.0, 3.0).unwrap_err();
        assert_eq!(refused.to_string(), "equal power needs a positive one of every engine, got 0");
    }
}
