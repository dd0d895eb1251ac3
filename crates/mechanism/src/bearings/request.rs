//! What may be asked of bearing loads.

use crate::inertia::request::LoadRequest;
use serde::Serialize;

/// Which loads count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BearingPart {
    /// Gas and inertia.
    All,
    /// Gas alone.
    Gas,
    /// Inertia alone: of pistons, rods, throws and counterweights.
    Inertia,
}

impl BearingPart {
    /// All of them in the order of tables.
    pub const ALL: [BearingPart; 3] = [BearingPart::All, BearingPart::Gas, BearingPart::Inertia];

    /// Name for tables and legends.
    pub fn name(self) -> &'static str {
        match self {
            BearingPart::All => "gas and inertia",
            BearingPart::Gas => "gas",
            BearingPart::Inertia => "inertia",
        }
    }
}

/// What to compute.
#[derive(Debug, Clone, PartialEq)]
pub struct BearingRequest {
    /// Speed of crankshaft 1 [rad/s]; `None`: the highest speed of the engine. The pressures must be those of this speed.
    pub speed: Option<f64>,
    /// Which loads count.
    pub part: BearingPart,
    /// Whether the weights on the crankshafts count.
    pub counterweights: bool,
    /// Angles of the traces in one revolution of crankshaft 1.
    pub samples: usize,
}

impl Default for BearingRequest {
    /// Everything at the highest speed, every degree.
    fn default() -> Self {
        BearingRequest { speed: None, part: BearingPart::All, counterweights: true, samples: 360 }
    }
}

impl BearingRequest {
    pub(crate) fn loads(&self) -> LoadRequest {
        LoadRequest { speed: self.speed, samples: self.samples, ..LoadRequest::default() }
    }
}
