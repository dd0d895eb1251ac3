//! Runs in time of the multibody rung, and how far the rungs agree.

mod columns;
pub(crate) mod crosscheck;
pub(crate) mod energy;
pub(crate) mod figure;
pub(crate) mod heat;
mod moving;
pub(crate) mod orders;
pub(crate) mod result;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod series;

pub use crosscheck::*;
pub use energy::{period_flows, run_flows};
pub use heat::PeriodHeat;
pub use orders::SimulatedOrder;
pub use result::*;
pub use run::*;
pub use section::{simulation_figures, simulation_section};
pub use series::*;
