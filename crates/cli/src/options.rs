//! The command line of each command, as clap sees it.

pub(crate) mod bondgraph;
pub(crate) mod compare;
pub(crate) mod complete;
pub(crate) mod counterweight;
pub(crate) mod durable;
pub(crate) mod explore;
pub(crate) mod export;
pub(crate) mod mounts;
pub(crate) mod published;
pub(crate) mod robust;
pub(crate) mod run;
pub(crate) mod scatter;
pub(crate) mod search;
pub(crate) mod search_limit;
pub(crate) mod sensitivity;
pub(crate) mod share;
pub(crate) mod simulation;
pub(crate) mod stress;
pub(crate) mod studio;
pub(crate) mod torque;
pub(crate) mod torsion;
pub(crate) mod workshop;
