//! Bond graphs: elements, causality, equations, simulation, audit.
//!
//! A [`Description`] says what a graph is made of, by a file ([`Graph::read`]) or by calls; [`Graph::new`] checks names, ports,
//! domains and units; [`causality`] assigns causality step by step; [`equations`] gives the state equations as expressions, which
//! are shown, made linear, or compiled and integrated.
//!
//! ```
//! use lanchester_bondgraph::{Description, Graph, equations};
//! let graph = Graph::new(
//!     &Description::new("oscillator")
//!         .element("car", "1", &[("domain", "translation")])
//!         .element("mass", "I", &[("inertia", "2 kg"), ("flow", "1 m/s")])
//!         .element("spring", "C", &[("stiffness", "8 N/m")])
//!         .bonds(&["car > mass", "car > spring"]),
//! ).expect("a good graph");
//! let equations = equations(&graph).expect("no conflict");
//! let poles = equations.linear().expect("linear").poles;
//! assert!((poles[0].frequency - 2.0).abs() < 1e-12);
//! ```
#![forbid(unsafe_code)]

mod causality;
mod check;
mod curve;
mod description;
mod domain;
mod engine;
mod equations;
mod expression;
mod file;
mod graph;
mod linear;
mod mistake;
mod output;
mod reading;
mod relax;
mod run;
mod subgraph;
mod unit;

pub use causality::loops::AlgebraicLoop;
pub use causality::{Causality, Follower, Preference, Step, causality};
pub use curve::Curve;
pub use description::{Description, Entry, Happening, Text, Use};
pub use domain::Domain;
pub use engine::{
    CompliantJoints, EngineBlock, EngineDrive, EngineGraphError, EngineJoints, EngineLink, EngineLoad,
    EngineRequest, EngineStart, EngineStarter, GasStates, GasValve, GasWalls, LoadLaw, WallCoefficient,
    WallLaw, engine_graph,
};
pub use equations::{Equations, equations};
pub use file::{is_graph_file, used_graphs};
pub use graph::{Asked, Graph, Kind, Period};
pub use linear::{Linear, NotLinear, Pole, Transfer};
pub use mistake::diagnostic_codes;
pub use output::draw::{
    DrawnBond, DrawnElement, DrawnLabel, DrawnName, DrawnTile, LabelAnchor, Placed, drawing, moving_drawing,
    placed,
};
pub use output::export::{graphml, modelica};
pub use output::latex::equations_latex;
pub use output::mathml::mathml;
pub use output::parts::{EquationPart, PartLine};
pub use output::shown::{Equation, Notation, ShownEquations, ShownState, ShownUnknown};
pub use output::text::{
    audit_text, causality_text, equations_text, graph_text, linear_text, simulation_csv, simulation_text,
    simulation_text_in_short,
};
pub use output::write::graph_file;
pub use run::audit::{Audit, BondEnergy, ElementEnergy, Residual};
pub use run::motion::{PeriodicEnd, PeriodicMotion};
pub use run::simulate::{Cancel, Event, Method, Simulation, SimulationRequest};
pub use unit::{Unit, duration};
