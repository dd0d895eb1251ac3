//! What a film is asked: bearing, oil, motion, feeds.

use crate::bearing::{JournalBearing, JournalMotion, check_viscosity};
use crate::cavitation::Cavitation;
use crate::error::{FilmError, require, require_film};
use crate::plane::Plane;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// Where oil comes in or pressure is known, in the shell's frame. A feed smaller than a cell takes the nearest cell.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Feed {
    /// A groove: a rectangle of the unrolled film.
    Groove {
        /// First angle [rad].
        from: f64,
        /// Last angle [rad], `from` < `to` <= `from` + one turn (a circumferential groove).
        to: f64,
        /// Middle of its width along the axis from the middle of the bearing [m].
        middle: f64,
        /// Width along the axis [m].
        width: f64,
        /// Pressure above that at the ends [Pa].
        pressure: f64,
    },
    /// A round oil hole.
    Hole {
        /// Angle of its centre [rad].
        angle: f64,
        /// Its centre along the axis from the middle of the bearing [m].
        place: f64,
        /// Diameter [m].
        diameter: f64,
        /// Pressure above that at the ends [Pa].
        pressure: f64,
    },
    /// A line along the whole length.
    Line {
        /// Its angle [rad].
        angle: f64,
        /// Pressure above that at the ends [Pa].
        pressure: f64,
    },
}

/// A film at one instant.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmProblem {
    /// The bearing.
    pub bearing: JournalBearing,
    /// Dynamic viscosity [Pa s].
    pub viscosity: f64,
    /// The journal.
    pub motion: JournalMotion,
    /// How much further the journal's axis lies at the end z = +L/2 than in the middle [m].
    pub tilt: Plane,
    /// Cavitation.
    pub cavitation: Cavitation,
    /// Grooves, holes, lines.
    pub feeds: Vec<Feed>,
}

impl FilmProblem {
    /// Refuses numbers that leave no film.
    ///
    /// # Errors
    /// [`FilmError`], named by what is wrong.
    pub fn check(&self) -> Result<(), FilmError> {
        self.bearing.check()?;
        check_viscosity(self.viscosity)?;
        let motion = &self.motion;
        for value in [motion.velocity, self.tilt].concat() {
            require(value.is_finite(), "motion of the journal [m, m/s]", "a finite number", value)?;
        }
        require(motion.entrainment.is_finite(), "mean speed [rad/s]", "a finite number", motion.entrainment)?;
        require(motion.sliding.is_finite(), "sliding speed [rad/s]", "a finite number", motion.sliding)?;
        let reach = |sign: f64| {
            crate::plane::length(crate::plane::add(motion.eccentricity, sign, self.tilt))
                / self.bearing.clearance
        };
        let ratio = reach(1.0).max(reach(-1.0));
        require_film(ratio)?;
        for feed in &self.feeds {
            let (pressure, size) = match *feed {
                Feed::Groove { from, to, width, pressure, .. } => {
                    require(
                        to > from && to - from <= TAU + 1e-12,
                        "angle that a groove covers [rad]",
                        "above 0, at most a turn",
                        to - from,
                    )?;
                    if to - from > TAU - 1e-9 && width >= self.bearing.length {
                        return Err(FilmError::NoLand);
                    }
                    (pressure, width)
                }
                Feed::Hole { diameter, pressure, .. } => (pressure, diameter),
                Feed::Line { pressure, .. } => (pressure, 1.0),
            };
            require(size > 0.0, "width of a groove or hole [m]", "above 0", size)?;
            require(
                pressure >= 0.0,
                "pressure of a groove or hole [Pa]",
                "0 or above, over that at the ends",
                pressure,
            )?;
        }
        Ok(())
    }

    /// Whether the film is the same on both sides of the middle.
    pub fn is_symmetric(&self) -> bool {
        self.tilt == [0.0, 0.0]
            && self.feeds.iter().all(|feed| match *feed {
                Feed::Groove { middle, .. } => middle == 0.0,
                Feed::Hole { place, .. } => place == 0.0,
                Feed::Line { .. } => true,
            })
    }
}
