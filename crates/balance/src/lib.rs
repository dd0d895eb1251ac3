//! Balancing: the best counterweights and balance shafts that exist for an engine, with the proof.
//!
//! Every device is linear in its complex unbalance, so that the smallest peak of a load over the cycle is a convex
//! problem; free positions, given amounts and on/off choices are searched by branch and bound around it.
#![forbid(unsafe_code)]

mod answer;
mod arrangement;
mod as_it_stands;
mod balance_rate;
mod bending;
mod branch;
mod cancellation;
mod check;
mod consequences;
mod convex;
mod cost;
mod criterion;
mod durable;
mod error;
mod fitted;
mod infeasible;
mod judged;
mod limits;
mod mounts;
mod operator;
mod optimum;
mod over_speed;
mod problem;
mod robust;
mod rounding;
mod settings;
mod stages;
mod wave;

pub use answer::*;
pub use arrangement::*;
pub use as_it_stands::as_it_stands;
pub use balance_rate::{BalanceRate, balance_rates};
pub use cancellation::*;
pub use consequences::{
    Affected, AffectedPart, BendingAlong, CONSEQUENCES_VERSION, Change, Consequence, Consequences,
    consequences,
};
pub use durable::{
    DURABLE_VERSION, Durable, DurableEnd, DurableLimit, DurableRequest, DurableRow, DurableSettings,
    DurableStage, durable,
};
pub use error::BalanceError;
pub use fitted::{bare, fitted};
pub use optimum::{optimise, optimise_watched, optimise_with};
pub use over_speed::*;
pub use robust::{
    ROBUST_VERSION, RobustAnswer, RobustLimit, RobustMeasure, RobustRequest, RobustStage, optimise_robust,
    optimise_robust_while,
};
pub use settings::{BalanceSettings, Next, SearchState, StopCause};
