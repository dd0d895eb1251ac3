//! Cylinders whose rods sit on the knuckle pins of a master rod.

mod bound;
mod motion;
mod quadrature;
mod rod;
mod rods;

pub(crate) use bound::ArticulatedBound;
pub(crate) use rod::ArticulatedRod;
pub(crate) use rods::{ArticulatedRods, articulated_rods};
