//! Published methods for an engine: all of them, and the nine arrangements of the twin-cylinder thesis.

mod arrangements;
mod methods;

pub use arrangements::arrangements;
pub use methods::{MethodKind, MethodLoad, MethodLoads, MethodResult, loads_as_it_is, published_methods};
