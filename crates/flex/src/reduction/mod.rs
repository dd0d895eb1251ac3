//! Reduced models of a crankshaft: Craig and Bampton's constraint modes and fixed-interface modes.
//!
//! Each bearing surface follows a reference point as a rigid body (6 coordinates); between them the body keeps its modes with all reference
//! points fixed.
//!
//! ```text
//! u = Psi q_b + Phi q_m    K_II Psi_I = -K_IB R    K_II Phi = M_II Phi diag(l)        (book, eq. 43.11)
//! k = [Psi^T K Psi, 0; 0, diag(l)]    m = [Psi Phi]^T M [Psi Phi]                     (book, eq. 43.12)
//! ```

mod build;
mod interface;
mod model;
mod npz;

pub(crate) use build::project;
pub use build::{Reduction, ReductionOptions, reduce, reduce_watched};
pub use interface::{Interface, interfaces};
pub use model::{ReducedMode, ReducedModel};
pub use npz::{Array, read_npz, write_npz};
