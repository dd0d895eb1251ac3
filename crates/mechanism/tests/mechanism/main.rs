//! All tests of the crate.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod bearings;
mod coefficients;
mod diagnosis;
mod edges;
mod flywheel;
mod geared_firing;
mod internal;
mod internal_properties;
mod kernels;
mod momentum;
mod motion;
mod mounts;
mod mounts_in_time;
mod mounts_properties;
mod mounts_rotors;
mod properties;
mod spectrum;
mod support;
mod support_test;
mod textbook;
mod torque;
