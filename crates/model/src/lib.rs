//! The physical engine: crankshafts, throws, cylinders, rods, weights, shafts, mounts, gas, with masses and inertia, in SI units.
//!
//! An [`Engine`] says what is there, not what is asked of it: that is the crate `task`. The crate `file` reads one from text.
#![forbid(unsafe_code)]

pub mod angle;
mod bearing_design;
mod bearings;
mod block;
mod crank_body;
mod crank_check;
mod crank_details;
mod crank_elements;
mod crank_expansion;
mod crank_material;
mod engine;
mod engine_check;
mod fault;
mod flywheel;
mod friction;
mod gas;
mod gear;
pub mod linkage;
mod mains;
mod mount;
mod origin;
mod part_weight;
mod plain_web;
mod ratio;
mod rotating_body;
mod shaft_part;
mod simulation;
mod spacing;

pub use bearing_design::*;
pub use bearings::{Bearings, PlainBearing};
pub use block::*;
pub use crank_body::*;
pub use crank_check::{CrankFault, CrankPlace, crank_faults};
pub use crank_details::*;
pub use crank_elements::{CrankElement, CrankElementForm, Disc, Fillet, OilHole, RoundBar};
pub use crank_expansion::CrankElementsFault;
pub use crank_material::{CrankMaterial, Forging, MaterialPreset};
pub use engine::*;
pub use fault::Fault;
pub use flywheel::Flywheel;
pub use friction::Friction;
pub use gas::*;
pub use gear::{Gear, GearDisc};
pub use mount::*;
pub use origin::{Origin, Sourced};
pub use part_weight::{LARGEST_UNBALANCE, PartFault, PartWeight, part_weight};
pub use plain_web::{PlainWeb, SharedWeb, TOUCH, ThrowUnbalance, pin, throw_unbalances};
pub use ratio::{Ratio, greatest_common_divisor};
pub use rotating_body::{InertiaSum, RotatingBody, RotatingKind, ShapedCrankshaft};
pub use shaft_part::ShaftWeightPart;
pub use simulation::*;
