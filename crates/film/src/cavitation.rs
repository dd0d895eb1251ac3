//! What becomes of the film where pressure would fall below that of the surroundings.

use serde::{Deserialize, Serialize};

/// Model of cavitation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Cavitation {
    /// None: negative pressure is kept (Sommerfeld's condition).
    Full,
    /// The full film, its negative pressure set to zero (Guembel's, half Sommerfeld's condition).
    Gumbel,
    /// Pressure and its slope vanish together where the film ruptures (Swift, Stieber): p >= 0 with complementarity.
    Reynolds,
    /// Oil is conserved in the cavity too (Jakobsson, Floberg, Olsson): pressure and emptiness complementary.
    MassConserving,
}

impl Cavitation {
    /// All of them, in order of detail.
    pub const ALL: [Cavitation; 4] =
        [Cavitation::Full, Cavitation::Gumbel, Cavitation::Reynolds, Cavitation::MassConserving];

    /// Its name in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Cavitation::Full => "full",
            Cavitation::Gumbel => "gumbel",
            Cavitation::Reynolds => "reynolds",
            Cavitation::MassConserving => "mass-conserving",
        }
    }
}
