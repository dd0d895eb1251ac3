//! Runs in time of the multibody rung, and how far the rungs agree.

mod beside;
mod changes;
mod columns;
pub(crate) mod crosscheck;
pub(crate) mod energy;
mod extremes;
pub(crate) mod figure;
pub(crate) mod heat;
mod moving;
pub(crate) mod orders;
pub(crate) mod period;
pub(crate) mod result;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod series;

pub use beside::ClosedFormBeside;
pub use crosscheck::*;
pub use energy::{period_flows, run_flows};
pub use extremes::{ExtremeRow, extreme_rows};
pub use heat::PeriodHeat;
pub use period::{PeriodSummary, SeriesStatistics, SimulatedOrder};
pub use result::*;
pub use run::*;
pub use section::{simulation_figures, simulation_section};
pub use series::*;
