//! The crankshaft as a body: by elements, their expansion from the short form, material, checks.

pub(crate) mod body;
pub(crate) mod check;
pub(crate) mod details;
pub(crate) mod elements;
pub(crate) mod expansion;
pub(crate) mod mains;
pub(crate) mod material;
pub(crate) mod plain_web;

pub use body::*;
pub use check::{CrankFault, CrankPlace, crank_faults};
pub use details::*;
pub use elements::{CrankElement, CrankElementForm, Disc, Fillet, OilHole, RoundBar};
pub use expansion::CrankElementsFault;
pub use material::{CrankMaterial, Forging, MaterialPreset};
pub use plain_web::{PlainWeb, SharedWeb, TOUCH, ThrowUnbalance, pin, throw_unbalances};
