//! Published balancing methods, as their sources mean them: each fits its own devices to an engine and says what they
//! leave over.
//!
//! * [`MatrixMethod`]: matrix-based crankshaft balancing tool, Applied Sciences 2021, 11, 8997;
//! * [`ThreeCylinderRule`], [`FourCylinderRule`], [`BalanceFactor`]: J. Singh, Mass balancing of 3-cylinder and
//!   4-cylinder inline engines with balancer shafts using bond graph approach, ME thesis, Thapar University, 2017;
//! * [`TwinArrangement`], [`sweep`]: the nine arrangements of the twin-cylinder thesis and its sweep of the crank.
//!
//! Equations that the sources print wrongly are used corrected; what was printed stands beside them, under its own name.
//! None of these methods seeks an optimum: they cancel one chosen resultant, or try counterweights in steps. The first two
//! sources' methods work with unbalances, so that one [`Resultant`] serves for every speed.
#![forbid(unsafe_code)]

mod arrangement_task;
mod basis;
mod comparison;
mod crank_sweep;
mod half_rules;
mod matrices;
mod matrix_method;
mod printed_v;
mod remark;
mod resultant;
mod shaft_pair;
mod swept;
mod twin_arrangement;
mod usual;

pub use arrangement_task::{arrangement_task, crank_task, swept_task};
pub use basis::Basis;
pub use comparison::{
    METHOD_ANSWER_VERSION, MethodAnswer, MethodFound, MethodWeight, OrderLeft, PublishedMethod,
};
pub use crank_sweep::{CrankLoad, CrankSweep, SweepOptions, SweptCrank, sweep};
pub use half_rules::{
    BalanceFactor, BalancerPhase, FourCylinderBalance, FourCylinderRule, ThreeCylinderBalance,
    ThreeCylinderRule,
};
pub use matrices::{Matrix, MethodMatrices};
pub use matrix_method::{Alpha, Equilibrium, MatrixBalance, MatrixMethod};
pub use printed_v::{AngleRule, PrintedV};
pub use remark::Remark;
pub use resultant::{EngineResidual, OrderResultant, Resultant};
pub use shaft_pair::{ShaftOrder, ShaftPair};
pub use swept::{SWEPT_VERSION, Swept, swept};
pub use twin_arrangement::{
    ArrangementOptions, CrankRule, GivenAmounts, TwinArrangement, arranged, crank_load, swept_crank,
    with_even_crank,
};
pub use usual::{SHAFT_DISTANCE, largest_radius, outer_throws};
