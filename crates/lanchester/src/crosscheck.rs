//! How far the rungs agree, load by load, and why where they do not.

pub(crate) mod flexible;
pub(crate) mod graph;
pub(crate) mod graph_joints;
pub(crate) mod graph_loads;
pub(crate) mod graph_states;
pub(crate) mod mounts;
pub(crate) mod orders;
pub(crate) mod pair;
pub(crate) mod ripple;
pub(crate) mod rungs;

pub use pair::{CrossCheckError, CrossCheckRequest};
pub use rungs::crosscheck;
