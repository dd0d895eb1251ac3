//! What a workshop sheet says: what is measured on a real rotor, crank or engine, and what may be done to it.

mod bobweight;
mod sheet;
mod slug;

pub use bobweight::{BobweightSheet, CylinderParts, PinParts};
pub use sheet::*;
pub use slug::{External, SlugRoom};
