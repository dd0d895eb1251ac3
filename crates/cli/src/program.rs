//! What made a result.

/// Name, version and commit of this program.
pub const PROGRAM: &str =
    concat!("lanchester ", env!("CARGO_PKG_VERSION"), " (", env!("LANCHESTER_COMMIT"), ")");
