//! Stress of the crankshaft: fatigue, loads from runs.

mod fatigue;
mod loads_of_runs;
