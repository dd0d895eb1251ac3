//! Gas on the pistons.

use lanchester_results::PeriodicCurve;
use serde::Serialize;

/// Pressures on the two sides of one piston, at one speed.
///
/// Both over the angle [rad] through which the cylinder's own crankshaft has turned since the cylinder's firing top dead
/// centre, in the sense of rotation; their period is that of the working cycle (2 pi for two strokes, 4 pi for four). The
/// force on the piston towards the crank is `(cylinder - crankcase) A` with the bore's area `A`.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CylinderGas {
    /// Absolute pressure in the cylinder [Pa].
    pub cylinder: PeriodicCurve,
    /// Absolute pressure under the piston [Pa].
    pub crankcase: PeriodicCurve,
}
