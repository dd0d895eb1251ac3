//! Which effects of the rotors count.

use serde::Serialize;

/// What of the rotors acts on the motion of the block.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
pub struct RotorEffects {
    /// Their gyroscopic couple.
    pub couple: bool,
    /// Their polar inertia does not follow the roll.
    pub roll: bool,
}

impl RotorEffects {
    /// Both.
    pub const BOTH: RotorEffects = RotorEffects { couple: true, roll: true };
    /// None: the rotors are held fast in the block.
    pub const NONE: RotorEffects = RotorEffects { couple: false, roll: false };
    /// The gyroscopic couple alone.
    pub const COUPLE: RotorEffects = RotorEffects { couple: true, roll: false };
    /// That their inertia does not follow the roll alone.
    pub const ROLL: RotorEffects = RotorEffects { couple: false, roll: true };
}

impl Default for RotorEffects {
    fn default() -> Self {
        RotorEffects::BOTH
    }
}
