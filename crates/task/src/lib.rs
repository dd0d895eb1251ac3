//! What is asked of an engine, as plain data: what may be done to balance it and what is wanted, among which shapes counterweights and
//! weights of shafts are to be found, what its parts may be off; and the words that people use for it.
//!
//! A [`Tasks`] is what an engine file asks beside the engine that it describes. Every task can as well be built by hand.
#![forbid(unsafe_code)]

mod balance_task;
pub mod criterion;
mod default_task;
mod drilling;
mod durability;
mod free_shaft;
pub mod give_up;
pub mod main_load;
pub mod option;
mod room;
mod shaft_weight_task;
mod shape_task;
mod speed_weight;
mod task_options;
mod tasks;
mod tolerance;
pub mod workshop;

pub use balance_task::*;
pub use criterion::{criterion, criterion_name, criterion_unit};
pub use default_task::{CrankWeightPlaces, crank_weights, default_task};
pub use drilling::{CatalogueHole, DRILL_POINT, DrillBit, DrillCatalogue};
pub use durability::{AtLeast, DurabilityCriterion, DurabilityMeter, DurabilityWish, Measured, Unmeasured};
pub use room::{RoomFault, RoomFaultKind, SAME_PLACE, TaskDevice, room_faults};
pub use shaft_weight_task::{ShaftWeightAim, ShaftWeightTask, fault_of};
pub use shape_task::*;
pub use speed_weight::weighted_speed;
pub use task_options::{ChangedTask, TaskOptions};
pub use tasks::Tasks;
pub use tolerance::{Distribution, Extent, Tolerance, Varied};
