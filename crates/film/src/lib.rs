//! Hydrodynamic journal-bearing films.
//!
//! Frame and signs as everywhere: e is the journal's centre from the bearing's, n(a) = (cos a, sin a), film thickness h = c - e.n,
//! v = e' - w_m z x e with w_m the mean of the two angular speeds against that frame; force is that of the film on the journal.
//!
//! ```
//! use lanchester_film::{JournalBearing, JournalMotion, attitude, short_bearing_force};
//! let bearing = JournalBearing::new(0.05, 0.03, 1e-4)?;
//! let motion = JournalMotion { eccentricity: [0.266_298e-4, 0.0], entrainment: 78.54, ..JournalMotion::default() };
//! let force = short_bearing_force(&bearing, 0.1, &motion, true)?;
//! assert!((force[0].hypot(force[1]) - 525.0).abs() < 0.1);
//! # Ok::<(), lanchester_film::FilmError>(())
//! ```
#![forbid(unsafe_code)]

mod axial;
mod balance;
mod banded;
mod bearing;
mod block_ring;
mod cavitation;
mod cells;
mod contact;
mod direct;
mod error;
mod grid;
mod long;
mod oil;
mod orbit;
mod plane;
mod problem;
mod separable;
mod shaft;
mod sheet;
mod short;
mod solution;
mod solver;
mod table;
mod tilted;

pub use balance::{BALANCED, FilmEnergy};
pub use bearing::{CLEARANCE_RATIO, JournalBearing, JournalMotion, VISCOSITY, check_viscosity};
pub use cavitation::Cavitation;
pub use contact::{contact_force, contact_with_slope, tilted_contact};
pub use direct::{DirectOrbit, DirectRequest};
pub use error::FilmError;
pub use grid::FilmGrid;
pub use long::{long_bearing_force, sommerfeld_load};
pub use oil::{
    DENSITY, HEAT_SHARE, OIL_DENSITY, OilCurve, SPECIFIC_HEAT, check_density, oil_grades, temperature_rise,
};
pub use orbit::{
    FilmOrbit, JournalCycle, LeastFilm, OrbitOutcome, OrbitRequest, journal_orbit, orbit_least_film,
};
pub use plane::Plane;
pub use problem::{Feed, FilmProblem};
pub use shaft::{FloatingShaft, ShaftJournal, ShaftOrbits, ShaftRequest};
pub use sheet::{
    BearingFilm, BearingFilmRequest, BearingKind, Carried, FilmOil, FilmSource, ShaftBody, ShaftRun,
    bearing_film, shaft_films,
};
pub use short::{ocvirk_load, short_bearing_force};
pub use solution::{FilmSolution, attitude};
pub use solver::FilmSolver;
pub use table::{FilmTable, Impedance};
pub use tilted::{TiltedImpedance, TiltedMotion, tilted_impedance, tilted_pressure};
