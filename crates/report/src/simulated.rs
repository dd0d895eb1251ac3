//! Runs in time of the multibody rung, and how far the rungs agree.

pub(crate) mod crosscheck;
pub(crate) mod figure;
pub(crate) mod orders;
pub(crate) mod result;
pub(crate) mod run;
pub(crate) mod section;

pub use crosscheck::*;
pub use orders::{SimulatedOrder, simulation_orders_csv};
pub use result::*;
pub use run::*;
pub use section::{simulation_figures, simulation_section};
