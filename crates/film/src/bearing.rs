//! Journal bearing and the motion of its journal.

use crate::error::{FilmError, require};
use crate::plane::{Plane, add, quarter};
use serde::{Deserialize, Serialize};

/// Accepted ratios of radial clearance to journal radius; common is 1e-3.
pub const CLEARANCE_RATIO: [f64; 2] = [1e-4, 1e-2];
/// Accepted dynamic viscosities [Pa s]: from petrol to cold heavy oil.
pub const VISCOSITY: [f64; 2] = [2e-4, 20.0];

/// A plain cylindrical bearing.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct JournalBearing {
    /// Radius of the journal [m].
    pub radius: f64,
    /// Length of the bearing along the axis [m].
    pub length: f64,
    /// Radial clearance [m]: half the difference of the diameters.
    pub clearance: f64,
}

impl JournalBearing {
    /// A bearing whose numbers can belong together.
    ///
    /// # Errors
    /// [`FilmError::Number`] for a length or radius that is not above 0, [`FilmError::Clearance`] for a clearance outside [`CLEARANCE_RATIO`].
    pub fn new(radius: f64, length: f64, clearance: f64) -> Result<JournalBearing, FilmError> {
        let bearing = JournalBearing { radius, length, clearance };
        bearing.check()?;
        Ok(bearing)
    }

    /// The same check for numbers that came from elsewhere.
    ///
    /// # Errors
    /// As [`JournalBearing::new`].
    pub fn check(&self) -> Result<(), FilmError> {
        require(self.radius > 0.0, "journal radius [m]", "above 0", self.radius)?;
        require(self.length > 0.0, "bearing length [m]", "above 0", self.length)?;
        require(self.clearance > 0.0, "radial clearance [m]", "above 0", self.clearance)?;
        let ratio = self.clearance / self.radius;
        if !(CLEARANCE_RATIO[0]..=CLEARANCE_RATIO[1]).contains(&ratio) {
            return Err(FilmError::Clearance {
                clearance: self.clearance,
                radius: self.radius,
                range: CLEARANCE_RATIO,
            });
        }
        Ok(())
    }

    /// Length over diameter.
    pub fn slenderness(&self) -> f64 {
        self.length / (2.0 * self.radius)
    }

    /// Force per closing speed that the dimensionless impedance is multiplied by [N s/m]: 12 mu R^3 L / c^3.
    pub fn force_scale(&self, viscosity: f64) -> f64 {
        12.0 * viscosity * (self.radius / self.clearance).powi(3) * self.length
    }

    /// Pressure per closing speed that the dimensionless pressure is multiplied by [Pa s/m]: 12 mu R^2 / c^3.
    pub fn pressure_scale(&self, viscosity: f64) -> f64 {
        12.0 * viscosity * self.radius * self.radius / self.clearance.powi(3)
    }
}

/// Refuses a length over diameter that no bearing has.
pub(crate) fn check_slenderness(slenderness: f64) -> Result<(), FilmError> {
    let range = (0.02..=20.0).contains(&slenderness);
    require(range, "length over diameter of a bearing", "0.02 to 20", slenderness)
}

/// Refuses a viscosity that no lubricant has.
///
/// # Errors
/// [`FilmError::Viscosity`].
pub fn check_viscosity(viscosity: f64) -> Result<(), FilmError> {
    if (VISCOSITY[0]..=VISCOSITY[1]).contains(&viscosity) {
        Ok(())
    } else {
        Err(FilmError::Viscosity { viscosity, range: VISCOSITY })
    }
}

/// Where the journal is and how it moves, in the bearing's frame.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct JournalMotion {
    /// Journal centre from bearing centre, e [m].
    pub eccentricity: Plane,
    /// Its rate, e' [m/s].
    pub velocity: Plane,
    /// Mean of the angular speeds of journal and shell against that frame, w_m [rad/s]: a main W/2, a big end (W + rod's)/2.
    pub entrainment: f64,
    /// Journal's less shell's angular speed [rad/s]: what shears the oil.
    pub sliding: f64,
}

impl JournalMotion {
    /// Velocity of the journal as the film sees it [m/s]: v = e' - w_m z x e. The film closes where v.n > 0.
    pub fn closing(&self) -> Plane {
        add(self.velocity, -self.entrainment, quarter(self.eccentricity))
    }
}
