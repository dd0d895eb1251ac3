//! Rings around pins and journals, which touch them without friction and let go where they would have to pull.

mod pair;
mod ring;
mod system;

pub(crate) use pair::ContactFace;
pub use pair::ContactReport;
pub(crate) use ring::{Ring, RingShape, add_ring};
pub(crate) use system::ContactSystem;
