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

mod bearing_films;
mod bond_graph;
mod comparison;
mod consequences;
mod crosscheck;
mod durability;
mod engine_report;
mod exchange;
mod graph_report;
mod inertias;
mod layouts;
mod mounted;
mod operating_point;
mod parts;
mod pressure;
mod published;
mod robust_balance;
pub mod run;
mod running;
mod sample_study;
mod scene;
mod simulation;
mod stress;
mod torque_files;
mod torque_report;
mod torsion_study;
mod value_list;

pub use bearing_films::{
    BEARING_FILMS_VERSION, BearingFilms, BearingFilmsError, FilmMethod, bearing_films,
    bearing_films_over_speed, film_faults,
};
pub use bond_graph::{BondGraphError, BondGraphRequest, EngineBondGraph, engine_bond_graph, gauge_pressures};
pub use comparison::{CompareEntry, CompareError, CompareRequest, ComparedWith, compare};
pub use consequences::consequences;
pub use crosscheck::*;
pub use durability::{DurabilityRequest, DurableOptions, EngineDurability, durable_balance};
pub use engine_report::{EngineReport, fnv1a, in_one_line, provenance};
pub use exchange::*;
pub use graph_report::bond_graph_report;
pub use inertias::{
    DrivelineBody, INERTIAS_VERSION, Inertias, ThrowInertia, inertias, rotating_bodies, rotor_inertia,
    shaped_crankshafts,
};
pub use lanchester_balance as balance;
pub use lanchester_bondgraph as bondgraph;
pub use lanchester_cycle as cycle;
pub use lanchester_exchange as exchange_formats;
pub use lanchester_file as file;
pub use lanchester_film as film;
pub use lanchester_flex as flex;
pub use lanchester_geometry as geometry;
pub use lanchester_literature as literature;
pub use lanchester_mechanism as mechanism;
pub use lanchester_model as model;
pub use lanchester_multibody as multibody;
pub use lanchester_report as report;
pub use lanchester_results as results;
pub use lanchester_strength as strength;
pub use lanchester_study as study;
pub use lanchester_table as table;
pub use lanchester_task as task;
pub use lanchester_torsion as torsion;
pub use lanchester_units as units;
pub use lanchester_workshop as workshop;
pub use layouts::*;
pub use mounted::{MountSpeeds, MountedError, mounts, mounts_with_rotors};
pub use operating_point::{operating_point, sensitivity_amount};
pub use parts::*;
pub use pressure::*;
pub use published::*;
pub use robust_balance::{MOST_ENGINES, RobustError, RobustOptions, robust_balance, robust_balance_while};
pub use running::{Running, is_running, running};
pub use sample_study::{SampleStudy, SavedScatter};
pub use scene::{Scene, SceneKind, SceneMesh, SceneMotion, ScenePart, scene};
pub use simulation::{RunLength, RunStart, SimulateRequest, simulate, simulate_watched, simulation_beside};
pub use stress::*;
pub use torque_files::{TorqueFileError, give_torques, torque_file_names};
pub use torque_report::{
    BearingStudy, TORQUE_REPORT_VERSION, TorqueReport, TorqueReportError, TorqueReportRequest,
    bearing_report, bearing_sizes, bearing_study, power_speeds, torque_report,
};
pub use torsion_study::{
    EngineTorsionError, ExcitingGas, TORSION_SPEEDS, TorsionRequest, engine_chain, engine_excitation,
    meshed_throws, torque_period, torsion,
};
pub use value_list::value_list;
