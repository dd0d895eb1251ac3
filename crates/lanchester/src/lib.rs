//! Lanchester: shaking forces and moments of piston engines from one engine file.
//!
//! This crate is the one that front ends and other programs import: it re-exports the rooms below and adds what
//! needs more than one of them.
//!
//! ```
//! use lanchester::mechanism::{LoadRequest, loads};
//!
//! let template = lanchester::file::template("in-line-4").expect("it is in the gallery");
//! let engine = lanchester::file::read(template.text).engine().expect("the gallery has no mistakes");
//! let loads = loads(&engine, &LoadRequest::default())?;
//! let (first, second) = (loads.total.orders[1], loads.total.orders[2]);
//! // An in-line four is free of first order and shakes at second order.
//! assert!(first.force_peak() < 1e-9 * second.force_peak());
//! # Ok::<(), lanchester::mechanism::LoadError>(())
//! ```
#![forbid(unsafe_code)]

mod arrangements;
mod best_shape;
mod bond_graph;
mod clearance;
mod comparison;
mod consequences;
mod counterweight_check;
mod counterweights;
mod crankshaft_parts;
mod crosscheck;
mod crosscheck_graph;
mod crosscheck_mounts;
mod crosscheck_orders;
mod crosscheck_ripple;
mod cycle_results;
mod engine_report;
mod inertias;
mod layout_search;
mod layout_space;
mod layout_study;
mod measured_gas;
mod mounted;
mod operating_point;
mod own_layout;
mod pressure;
mod robust_balance;
pub mod run;
mod run_plan;
mod running;
mod sample_study;
mod scene;
mod shaft_weights;
mod shape_front;
mod simulated_gas;
mod simulation;
mod speed_gas;
mod torque_report;
mod web_bounds;
mod web_excess;
mod weights_as_parts;

pub use arrangements::arrangements;
pub use best_shape::SharedWithWeb;
pub use bond_graph::{BondGraphError, BondGraphRequest, EngineBondGraph, engine_bond_graph, gauge_pressures};
pub use clearance::{
    EngineClearanceError, ExactRod, clearance_curve, clearance_model, clearances, largest_swept_radius,
};
pub use comparison::{CompareEntry, CompareError, CompareRequest, ComparedWith, compare};
pub use consequences::consequences;
pub use counterweight_check::{
    COUNTERWEIGHT_CHECK_VERSION, CheckedCounterweight, CheckedShaftWeight, CounterweightCheck,
    check_counterweights,
};
pub use counterweights::{
    COUNTERWEIGHT_DESIGNS_VERSION, CounterweightDesigns, CounterweightError, CounterweightFront,
    CounterweightRequest, DesignedCounterweight, EvolutionRequest, adopted, counterweight_front,
    design_counterweights, with_counterweights, with_outline,
};
pub use crankshaft_parts::{crankshaft_parts, engine_parts, shaft_parts};
pub use crosscheck::{CrossCheckError, CrossCheckRequest, crosscheck, rotor_inertia};
pub use cycle_results::cycle_results;
pub use engine_report::{EngineReport, fnv1a, in_one_line, provenance};
pub use inertias::{DrivelineBody, INERTIAS_VERSION, Inertias, ThrowInertia, inertias, shaped_crankshafts};
pub use lanchester_balance as balance;
pub use lanchester_bondgraph as bondgraph;
pub use lanchester_cycle as cycle;
pub use lanchester_file as file;
pub use lanchester_geometry as geometry;
pub use lanchester_mechanism as mechanism;
pub use lanchester_model as model;
pub use lanchester_multibody as multibody;
pub use lanchester_report as report;
pub use lanchester_results as results;
pub use lanchester_study as study;
pub use lanchester_table as table;
pub use lanchester_task as task;
pub use lanchester_units as units;
pub use lanchester_workshop as workshop;
pub use layout_search::{LayoutSearchError, adopted_layout, given_engine, layout_name};
pub use layout_space::{LayoutChoices, LayoutSpace, LayoutSpaceError, layout_space, own_pattern};
pub use layout_study::{LayoutRows, LayoutStudy};
pub use mounted::{MountSpeeds, MountedError, mounts};
pub use operating_point::operating_point;
pub use pressure::{
    ComputedCycle, CylinderCycle, GAS_REPORT_VERSION, GasError, GasReport, TraceFile, cylinder_gas,
    trace_names,
};
pub use robust_balance::{MOST_ENGINES, RobustError, RobustOptions, robust_balance, robust_balance_while};
pub use running::{Running, is_running, running};
pub use sample_study::SampleStudy;
pub use scene::{Scene, SceneKind, SceneMesh, SceneMotion, ScenePart, scene};
pub use shaft_weights::{
    DesignedShaftWeight, SHAFT_WEIGHT_DESIGNS_VERSION, ShaftWeightDesigns, ShaftWeightPlace,
    design_shaft_weights, named_shaft_weights, shaft_weights_to_design, with_shaft_weights,
};
pub use simulated_gas::GivenGas;
pub use simulation::{RunLength, SimulateRequest, simulate, simulate_watched};
pub use speed_gas::optimised;
pub use torque_report::{
    BearingStudy, TORQUE_REPORT_VERSION, TorqueReport, TorqueReportError, TorqueReportRequest,
    bearing_report, bearing_sizes, bearing_study, power_speeds, torque_report,
};
pub use web_bounds::{WebBoundError, optimise_on_webs};
pub use web_excess::{WebExcess, WebExcesses, web_excesses};
pub use weights_as_parts::{WeightAsPart, weights_as_parts};
