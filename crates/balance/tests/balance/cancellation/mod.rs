//! Exact cancellation against closed forms, its own conditions and random changes.
mod by_stages;
mod certificates;
mod closed_forms;
mod edges;
mod support;
