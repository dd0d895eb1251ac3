//! Quadratic solid elements with the node numbering and the integration rules of CalculiX: C3D10, C3D15, C3D20.

mod kind;
mod matrices;
mod quadrature;
mod recovery;
mod shape_functions;

pub use kind::ElementKind;
pub(crate) use matrices::gradients;
pub use matrices::{ElementMatrix, geometric_matrix, jacobian_determinant, mass_matrix, stiffness_matrix};
pub use quadrature::{IntegrationPoint, mass_rule, recovery_points, stiffness_rule};
pub use recovery::{Stress, extrapolation, stress_at};
pub use shape_functions::{ShapeValues, local_coordinates, shape_values};
