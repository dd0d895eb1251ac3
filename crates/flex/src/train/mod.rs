//! The crank train with a flexible crankshaft in its bearings.
//!
//! * [`crank_basis`] makes the [`CrankBody`] of a mesh: modes and shapes of its bearings, in the frame that turns with it.
//! * [`CrankTrain`] joins it with rods and pistons by [`TrainLaw`]s: rigid, contact, bushing, film.
//! * [`run_cycles`] integrates until the cycles repeat; [`run_free`] with a flywheel that turns freely; [`StressBasis`] gives the stress at the fillets.

mod assembly;
mod basis;
mod body;
mod centrifugal;
mod coupling;
mod cycle;
mod films;
mod flywheel;
mod law;
mod mixing;
mod motion;
mod parts;
mod plane;
mod slider;
mod snapshot;
mod spot;
mod stage;
mod stress;
mod ties;

pub use basis::{BasisKind, BasisOptions, CrankBasis, crank_basis};
pub use body::CrankBody;
pub use coupling::BearingPlace;
pub(crate) use coupling::Coupling;
pub use cycle::{
    CycleOptions, CycleOutcome, CycleState, CycleWatch, EnergyBalance, RecordedCycle, TrainCycles,
    run_cycles, run_cycles_watched, run_free,
};
pub(crate) use films::solved_film;
pub use films::{FilmInstant, largest_film_pressure};
pub use flywheel::{FreeFlywheel, FreeSpeed};
pub use law::TrainLaw;
pub use motion::{ImposedMotion, PeriodicForce};
pub use parts::{CrankTrain, TrainCylinder, TrainMain};
pub use plane::{Plane, Square};
pub use slider::Slider;
pub use snapshot::CycleInstant;
pub use stress::{FilletCycle, FilletNodes, StressBasis, StressInstant};
