//! Files of the repository that programs of Lanchester embed: published numbers with their engines, and bond graphs.
//!
//! ```
//! let motor = lanchester_data::BOND_GRAPHS.iter().find(|(name, _)| *name == "dc-motor");
//! assert!(motor.is_some_and(|(_, text)| text.contains("[elements]")));
//! ```

mod graphs;
mod published;

pub use graphs::BOND_GRAPHS;
pub use published::{FILES, TRACES};
