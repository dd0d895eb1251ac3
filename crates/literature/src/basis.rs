//! What a published method sizes its weights for.

use serde::Serialize;

/// Which resultant the counterweights are sized for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Basis {
    /// The force of the whole crank.
    Force,
    /// The couple of the whole crank, where its force vanishes.
    Couple,
    /// The force of the front half, where both vanish for the whole.
    HalfForce,
    /// The moment of the front half about the middle of the crank.
    HalfCouple,
    /// Nothing to balance.
    Nothing,
}
