//! Results as tables, plots and pages: pure functions from data to text.
//!
//! Nothing here opens a file, asks the time or prints. Figures are SVG of our own (decision record 10): one
//! figure is a string that works in a page and as a file of its own, light and dark.
#![forbid(unsafe_code)]

mod bearings;
mod brief;
mod engine;
mod gas;
mod graph;
mod kit;
mod layouts;
mod loads;
mod mounts;
mod optimum;
mod page;
mod parts;
mod printed;
mod published;
#[cfg(test)]
mod sample;
mod simulated;
mod strength;
mod stress;
mod study;
mod torque;
mod torsion;
pub mod workshop;

pub use bearings::*;
pub use brief::*;
pub use engine::*;
pub use gas::*;
pub use graph::*;
pub use kit::*;
pub use layouts::*;
pub use loads::*;
pub use mounts::*;
pub use optimum::*;
pub use page::{Provenance, ReportHead, figures, report};
pub use parts::*;
pub use printed::*;
pub use published::*;
pub use simulated::*;
pub use strength::*;
pub use stress::*;
pub use study::*;
pub use torque::*;
pub use torsion::*;
