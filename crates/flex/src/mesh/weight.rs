//! A weight that a body carries and whose shape is not known.

use serde::{Deserialize, Serialize};

/// A weight without elements of its own.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct CarriedWeight {
    /// Its name: "web 1".
    pub name: String,
    /// Mass times place [kg m], in the frame of the mesh.
    pub unbalance: [f64; 2],
    /// Its plane [m].
    pub z: f64,
    /// What carries it: "web 1", "webs 1 and 2", "end face FLYWHEEL".
    pub place: String,
    /// Force on each node over the square of the speed about z [kg m].
    #[serde(skip)]
    pub forces: Vec<(u32, [f64; 3])>,
}
