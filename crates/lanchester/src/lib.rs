//! Placeholder head.

pub mod validate;
