//! Stress and modes of a crankshaft: its mesh from the engine file, its loads from the closed form or from a simulated run.

pub(crate) mod converge;
pub(crate) mod cycle;
pub(crate) mod deck;
pub(crate) mod export;
pub(crate) mod fatigue;
pub(crate) mod file_case;
pub(crate) mod fillet_bands;
pub(crate) mod loads;
pub(crate) mod mesh;
pub(crate) mod named_load;
pub(crate) mod oil;
pub(crate) mod own_mesh;
pub(crate) mod reduce;
pub(crate) mod request;
pub(crate) mod rule;
pub(crate) mod rule_elements;
pub(crate) mod rule_torsion;
pub(crate) mod run;
pub(crate) mod simulated;
pub(crate) mod submodel;
pub(crate) mod surface;
pub(crate) mod throw_shape;
pub(crate) mod throws;
pub(crate) mod unit_fields;
pub(crate) mod worst_point;

pub use converge::{converged_modes, converged_stress};
pub use cycle::{CycleRequest, CycleStage, crank_cycle};
pub use deck::solve_deck;
pub use export::{case_deck, case_glb, case_stl, case_vtu, cases_pvd, modes_deck, modes_glb, modes_vtu};
pub use fatigue::{FatigueRequest, crank_fatigue};
pub use file_case::stress_case;
pub use fillet_bands::FilletStudy;
pub use mesh::{MOST_NODES, MeshFile, StressMesh};
pub use reduce::reduced_crank;
pub use request::{
    GivenForce, LoadSource, ModesRequest, SimulatedSource, StaticRequest, StressError, StressLoad,
    StressStage, SubmodelRequest, support_words,
};
pub use rule::{CrankRuleError, RuleRequest, crank_rule};
pub use rule_elements::{throw_factors, with_element_factors};
pub use rule_torsion::{RuleTorsionError, crank_rule_of_file, crank_rule_with_torsion};
pub use run::{crank_modes, static_stress};
pub use surface::{
    FilletCycle, FilletPeak, SurfacePlan, SurfaceRequest, SurfaceStress, WorstCase, surface_plan,
    surface_stress,
};
pub use throws::throw_stiffnesses;
pub use unit_fields::NodeField;
