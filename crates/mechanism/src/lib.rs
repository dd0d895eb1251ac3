//! Closed-form crank train: exact kinematics, orders, inertia loads.
//!
//! [`loads`] computes everything about an engine at one speed: over the cycle, by order split into parts that turn with
//! the crank and against it, by kind of part, by cylinder, with true extremes and a diagnosis in words. Who needs one of
//! these many times over prepares it: [`Mechanism`] is the engine at one speed, [`OrderPlan`] and [`TracePlan`] write its
//! loads without allocating.
//!
//! What moves: [`motion`], [`exact_coefficients`], [`series_coefficients`]. Rigid parts, constant speed, no play.

#![forbid(unsafe_code)]

mod bearings;
mod curves;
mod inertia;
mod mounts;
mod speed;
mod torque;
mod train;
mod wording;

pub use bearings::*;
pub use inertia::*;
pub use mounts::*;
pub use speed::*;
pub use torque::*;
pub use train::*;
