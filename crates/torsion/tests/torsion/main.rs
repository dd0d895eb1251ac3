//! Tests of torsional vibration.
#![allow(clippy::unwrap_used)]

mod closed_forms;
mod damper;
mod external;
mod forced;
mod published;
mod refused;
mod time;
