//! Why a question of the workshop cannot be answered.

use lanchester_mechanism::LoadError;

/// A question of the workshop that has no meaning.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum WorkshopError {
    /// The engine's own loads cannot be computed.
    #[error(transparent)]
    Loads(#[from] LoadError),
    /// A number is not possible.
    #[error("{quantity} of {part} must be {needed}, got {got}\nhint: {hint}")]
    Number {
        /// Which number, with its unit.
        quantity: &'static str,
        /// Whose.
        part: String,
        /// What is possible.
        needed: String,
        /// What was given.
        got: f64,
        /// What to do.
        hint: &'static str,
    },
    /// A throw, crankshaft or weight that is not there, or cannot be used so.
    #[error("{what}\nhint: {hint}")]
    Impossible {
        /// What was needed and what was got.
        what: String,
        /// What to do.
        hint: &'static str,
    },
    /// A run stands alone at its speed.
    #[error(
        "{run} was made at {speed_rpm:.0} rpm, {other} at {other_rpm:.0} rpm: runs at different speeds cannot be compared\nhint: repeat it at the speed of the others; at every speed an initial run and all trial runs are needed"
    )]
    OtherSpeed {
        /// Name of the run.
        run: String,
        /// Its speed [rpm].
        speed_rpm: f64,
        /// Name of a run at another speed.
        other: String,
        /// The speed of that [rpm].
        other_rpm: f64,
    },
    /// No run at this speed tells what a plane does.
    #[error(
        "no run at {speed_rpm:.0} rpm tells what a weight in plane \"{plane}\" does\nhint: at every speed make an initial run and one run with a trial weight in each plane"
    )]
    NoTrial {
        /// Name of the plane.
        plane: String,
        /// The speed [rpm].
        speed_rpm: f64,
    },
    /// Fewer runs than unknowns.
    #[error(
        "{got} runs at {speed_rpm:.0} rpm cannot tell the planes apart: {needed} are needed\nhint: make an initial run and one run with a trial weight in each plane"
    )]
    FewRuns {
        /// Runs that there are.
        got: usize,
        /// Runs that are needed.
        needed: usize,
        /// The speed [rpm].
        speed_rpm: f64,
    },
    /// Trial weights that were never moved one by one.
    #[error(
        "at {speed_rpm:.0} rpm the weights in {} were always changed together, so that their effects cannot be told apart\nhint: make one run in which only one of them is changed", .planes.join(" and ")
    )]
    MovedTogether {
        /// Names of the planes.
        planes: Vec<String>,
        /// The speed [rpm].
        speed_rpm: f64,
    },
    /// A sensor without the readings that its fit needs.
    #[error(
        "sensor \"{sensor}\" has no reading in {run}, without which its influence coefficients cannot be told\nhint: add the reading, or leave this sensor out of all runs of this speed"
    )]
    SensorMissing {
        /// Name of the sensor.
        sensor: String,
        /// Name of the run.
        run: String,
    },
    /// Planes with the same effect on every sensor.
    #[error(
        "weights in {} do the same to every sensor at every speed: the influence coefficients are singular\nhint: correct in one of these planes only, or add a sensor at the other bearing or runs at another speed", .planes.join(" and ")
    )]
    Singular {
        /// Names of the planes.
        planes: Vec<String>,
    },
    /// Fewer readings than planes.
    #[error(
        "{readings} {} cannot determine weights in {planes} planes\nhint: add a sensor or a speed, or correct in fewer planes", if *.readings == 1 { "reading" } else { "readings" }
    )]
    FewReadings {
        /// Sensors times speeds.
        readings: usize,
        /// Planes with trial weights.
        planes: usize,
    },
    /// The sheet does not say something that is needed.
    #[error("{needed} is needed for {purpose}\nhint: {hint}")]
    Missing {
        /// What is missing.
        needed: String,
        /// What for.
        purpose: &'static str,
        /// What to add.
        hint: &'static str,
    },
}

impl WorkshopError {
    pub(crate) fn missing(
        needed: impl Into<String>,
        purpose: &'static str,
        hint: &'static str,
    ) -> WorkshopError {
        WorkshopError::Missing { needed: needed.into(), purpose, hint }
    }
}
