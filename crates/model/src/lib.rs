//! The physical engine: crankshafts, throws, cylinders, rods, weights, shafts, mounts, gas, with masses and inertia, in SI units.
//!
//! An [`Engine`] says what is there, not what is asked of it: that is the crate `task`. The crate `file` reads one from text.
#![forbid(unsafe_code)]

pub mod angle;
mod crank;
mod engine;
mod engine_check;
mod engine_parts;
mod fault;
mod gear;
pub mod linkage;
mod origin;
mod part_weight;
mod ratio;
mod rotating_body;
mod running;
mod shaft_part;
mod spacing;

pub use crank::*;
pub use engine::Engine;
pub use engine_parts::*;
pub use fault::Fault;
pub use gear::{Gear, GearDisc};
pub use origin::{Origin, Sourced};
pub use part_weight::{LARGEST_UNBALANCE, PartFault, PartWeight, part_weight};
pub use ratio::{Ratio, greatest_common_divisor};
pub use rotating_body::{InertiaSum, RotatingBody, RotatingKind, ShapedCrankshaft};
pub use running::*;
pub use shaft_part::ShaftWeightPart;
