//! Loads and crank trains in the formats of other programs.
//!
//! Plain data in, text or bytes out: nothing here knows where forces come from or where the text goes. SI units throughout.
//!
//! ```
//! use lanchester_exchange::{FirstNumbers, ForceTable, LoadedPoint, OrderForces, nastran};
//! use num_complex::Complex64;
//! let size = Complex64::new(10.0, -5.0);
//! let table = ForceTable {
//!     title: "one mount".to_owned(),
//!     notes: Vec::new(),
//!     speeds: vec![100.0, 200.0],
//!     points: vec![LoadedPoint {
//!         id: 1,
//!         name: "left".to_owned(),
//!         position: [0.0, 0.1, 0.0],
//!         words: "force of the block on the mount".to_owned(),
//!     }],
//!     orders: vec![OrderForces { order: 2.0, forces: vec![vec![[size; 3], [4.0 * size; 3]]] }],
//! };
//! let deck = nastran(&table, FirstNumbers::from(1));
//! assert_eq!(deck.matches("RLOAD1").count(), 3);
//! ```
#![forbid(unsafe_code)]

mod exudyn;
mod fmu;
mod force_table;
mod nastran;
mod universal;

pub use exudyn::{RigidCylinder, RigidReference, RigidRotor, RigidTrain, exudyn};
pub use fmu::{
    FmiVersion, FmuDescription, FmuKind, FmuRole, FmuVariable, binaries_folder, fmu_archive,
    model_description,
};
pub use force_table::{ForceTable, LoadedPoint, OrderForces};
pub use nastran::{FirstNumbers, nastran};
pub use universal::universal;
