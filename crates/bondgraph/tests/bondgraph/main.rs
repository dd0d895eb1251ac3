//! All tests of the crate.

mod bad_input;
mod causality;
mod codes;
mod course;
mod dry_friction;
mod engine_events;
mod engine_gas;
mod event;
mod external;
mod gas;
mod graph_file;
mod joints;
mod notation;
mod output;
mod periodic;
mod printed;
mod shipped;
mod textbook;
