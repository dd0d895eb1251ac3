//! The convex optimum against closed forms, golden section, random changes and its own conditions.
mod bending;
mod closed_forms;
mod conditions;
mod equals;
mod gallery;
mod give_up;
mod limits;
mod main_loads;
mod mounts;
mod robust;
mod speeds;
pub mod support;
