//! Oil films and safeties of engines as criteria, for rooms that know neither films nor finite elements.

mod fillets;
mod films;
mod measure;
mod memory;
mod meter;
mod rule;
mod similar;
mod weights;
mod words;

pub use meter::{DurabilityRequest, EngineDurability};
pub(crate) use similar::similar_durability;
pub use weights::{DurableOptions, durable_balance};
