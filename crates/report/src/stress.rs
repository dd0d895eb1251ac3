//! The flexible crankshaft: static stress, natural modes.

pub(crate) mod body;
pub(crate) mod convergence;
pub(crate) mod cycle;
pub(crate) mod deck;
pub(crate) mod fatigue;
pub(crate) mod modes;
pub(crate) mod picture;
pub(crate) mod reduced;
pub(crate) mod statics;
pub(crate) mod submodel;

pub use body::{CrankSheet, MeshOrigin, MeshOrigins, StressMaterial};
pub use convergence::{ConvergedNumber, Convergence, ConvergenceMesh};
pub use cycle::*;
pub use deck::{DECK_VERSION, SolvedDeck, SolvedStep, StaticStep, deck_csv, deck_text};
pub use fatigue::{
    CRANK_FATIGUE_VERSION, CrankFatigue, FatigueAtSpeed, FatigueFactors, FatigueMeasure, FilletFatigue,
    fatigue_csv, fatigue_text,
};
pub use modes::{CrankModes, MODES_VERSION, modes_csv, modes_text};
pub use reduced::{REDUCED_VERSION, ReducedCrank, reduced_csv, reduced_text};
pub use statics::{
    PinForces, STATIC_STRESS_VERSION, StaticStress, StressCase, static_stress_csv, static_stress_text,
};
pub use submodel::{StressSubmodel, SubmodelFillet};
