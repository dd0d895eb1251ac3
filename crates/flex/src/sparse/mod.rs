//! Sparse symmetric matrices of a mesh: order of elimination, parallel assembly, Cholesky factor, solution.

mod assembly;
mod factor;
mod halves;
mod matrix;
mod order;
mod real;
mod solve;
mod substitution;

pub use assembly::{DenseTerm, Quantity, Structure};
pub use factor::{Factor, FactorPlan, Precision, SolveEstimate, make_product, negative_eigenvalues};
pub use matrix::{Pattern, SymmetricMatrix};
pub(crate) use matrix::{add, dot, norm};
pub use order::{nested_dissection, postorder};
pub use solve::{SolveReport, Solver};
