//! Gas in the cylinder: measured traces, ideal cycles and single-zone filling and emptying on the engine's own mechanism, and what
//! the gas does there.
//!
//! Angles `psi` [rad] are those through which the cylinder's own crankshaft has turned since its firing top dead centre, in
//! the sense of rotation; pressures are absolute. Curves are [`PeriodicCurve`](lanchester_results::PeriodicCurve)s over them.
#![forbid(unsafe_code)]

mod error;
mod ideal;
mod indicated;
mod pieces;
mod trace;
mod volume;
mod zone;

pub use error::CycleError;
pub use ideal::{GasState, IdealCycle, ideal_cycle};
pub use indicated::{Indicated, PvPoint, indicated, pressure_volume, work_between};
pub use trace::{
    MOST_HARMONICS, MeasuredTrace, TraceError, TraceFault, TraceOptions, TracePlace, at_speed, check_firing,
    read_torque, read_trace, trace_codes,
};
pub use volume::CylinderVolume;
pub use zone::{
    Balance, Contents, PistonGap, SinceClosing, ThroughFlow, ZoneCycle, ZoneOutcome, ZoneSettings, fill,
    mass_flow, piston_gap, single_zone,
};
