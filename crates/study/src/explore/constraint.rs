//! What a layout must hold to be judged at all.

use crate::explore::objective::{Level, Objective};
use serde::{Deserialize, Serialize};

/// What a layout must hold to be judged.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Constraint {
    /// Every firing interval is even within `tolerance` [rad].
    EvenFiring {
        /// Largest difference of an interval from the even one [rad].
        tolerance: f64,
    },
    /// An objective is at most `limit`, in its SI unit.
    AtMost {
        /// Which.
        objective: Objective,
        /// Its limit.
        limit: f64,
    },
    /// Between the facing webs of neighbouring groups there is room for a main bearing.
    BearingRoom {
        /// Least room [m].
        least: f64,
    },
    /// Split pins overlap, seen along the crank: pin diameter less the distance of their axes. Shared pins always hold it.
    PinOverlap {
        /// Least overlap [m].
        least: f64,
    },
}

impl Constraint {
    /// Name for tables and messages.
    pub fn name(self) -> String {
        match self {
            Constraint::EvenFiring { tolerance } => {
                format!("even firing within {} deg", rounded(tolerance.to_degrees()))
            }
            Constraint::AtMost { objective, limit } => {
                let text = format!("{} at most {} {}", objective.name(), rounded(limit), objective.unit());
                text.trim_end().to_string()
            }
            Constraint::BearingRoom { least } => format!("room for bearings of {} m", rounded(least)),
            Constraint::PinOverlap { least } => format!("overlap of split pins of {} m", rounded(least)),
        }
    }

    pub(crate) fn level(self) -> Level {
        match self {
            Constraint::EvenFiring { .. } => Level::Firing,
            Constraint::AtMost { objective, .. } => objective.level(),
            Constraint::BearingRoom { .. } | Constraint::PinOverlap { .. } => Level::Block,
        }
    }

    /// Its number, which must be finite.
    pub(crate) fn number(self) -> f64 {
        match self {
            Constraint::EvenFiring { tolerance } => tolerance,
            Constraint::AtMost { limit, .. } => limit,
            Constraint::BearingRoom { least } | Constraint::PinOverlap { least } => least,
        }
    }
}

/// Six digits are enough to be recognised.
fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}
