//! Kinds of moving parts.

use serde::Serialize;

/// Which moving parts a load comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Part {
    /// Crank throws and the rods' big ends.
    Rotating,
    /// Pistons and the rods' small ends (with the moving knuckle pins of articulated rods).
    Reciprocating,
    /// What the two-mass rods miss of the true rod inertia: torque and roll moment only.
    RodInertia,
    /// Weights on the crankshafts.
    Counterweights,
    /// Balance shafts.
    Shafts,
}

impl Part {
    /// All parts in the order of tables.
    pub const ALL: [Part; 5] =
        [Part::Rotating, Part::Reciprocating, Part::RodInertia, Part::Counterweights, Part::Shafts];

    /// Name for tables and legends.
    pub fn name(self) -> &'static str {
        match self {
            Part::Rotating => "rotating",
            Part::Reciprocating => "reciprocating",
            Part::RodInertia => "rod inertia",
            Part::Counterweights => "counterweights",
            Part::Shafts => "balance shafts",
        }
    }
}
