//! The flexible crankshaft in its bearings over the cycle.

pub(crate) mod figures;
pub(crate) mod result;
pub(crate) mod tables;

pub use figures::crank_cycle_figures;
pub use result::{
    BearingCycle, CRANK_CYCLE_VERSION, CrankCycle, CrankKind, CycleLaw, CycleRun, CycleSpeed, LeastFilm,
    MainRules, SPEED_SETTLED,
};
pub use tables::{cycle_csv, cycle_text};
