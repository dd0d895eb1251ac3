//! From options to what the facade is asked.

pub(crate) mod balance;
pub(crate) mod explore;
pub(crate) mod loads;
pub(crate) mod search;
pub(crate) mod shape;
pub(crate) mod stress;
