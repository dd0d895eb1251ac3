//! The best counterweight of the tool paper's family for a duty within limits, and the trade between two aims.
//!
//! The thickness follows from the shape; a local search finds a shape, and branch and bound over intervals proves that no
//! other is better (book, "The counterweight as a part").

mod arc;
mod bend;
mod curve;
mod descent;
mod evolution;
mod front;
mod interval;
mod jet;
mod number;
mod optimum;
mod problem;
mod refute;
mod sector;
mod task;

pub use evolution::{Evolution, Evolved, evolve};
pub use front::{Front, front, front_within};
pub use lanchester_task::{DesignLimits, DesignSettings, Objective, Range, ShapeTask, Shoulder};
pub use optimum::{
    DESIGN_VERSION, Design, DesignOutcome, Infeasible, Limit, NearestLimit, Optimum, design, design_within,
    largest_balance,
};
pub use task::DesignTask;

/// Most variables of a linear programme of this design: those of the shape, and the violation.
const COLUMNS: usize = 6;

#[cfg(test)]
mod tests;
