//! What layouts are judged by: numbers of which less is better.

use serde::{Deserialize, Serialize};

/// Which way a load turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sense {
    /// With the crank: of order 1 a weight on the crank removes it.
    Forward,
    /// Against the crank.
    Backward,
}

/// A number of which less is better. Loads are those on the block without gas, at the speed of the parts; the residual
/// of the layout's own counterweights and balance shafts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Objective {
    /// Largest resultant of the force of an order [N]: major half axis of its ellipse.
    Force {
        /// Order: 1 or 2.
        order: u32,
    },
    /// Largest resultant of the couple of an order about the middle of the crankshaft [N m].
    Couple {
        /// Order: 1 or 2.
        order: u32,
    },
    /// Part of the force of an order that turns in one sense [N].
    ForceSense {
        /// Order: 1 or 2.
        order: u32,
        /// Sense.
        sense: Sense,
    },
    /// Part of the couple of an order that turns in one sense [N m].
    CoupleSense {
        /// Order: 1 or 2.
        order: u32,
        /// Sense.
        sense: Sense,
    },
    /// Amplitude of the roll moment of an order by inertia [N m].
    RollMoment {
        /// Order: 1 or 2.
        order: u32,
    },
    /// Amplitude of the inertia torque of an order [N m].
    InertiaTorque {
        /// Order: 1 or 2.
        order: u32,
    },
    /// Largest bending moment along the crank by the parts that turn with it, as a free beam on its end mains [N m].
    BendingMoment,
    /// Largest load on a main bearing by the parts that turn with the crank, each throw held by its own two mains [N].
    MainLoad,
    /// Largest difference of a firing interval from the even one [rad].
    FiringUnevenness,
    /// Harmonic of the firing pulses, over that of pulses that all come together: `|SUM e^{i h angle / 2}| / cylinders`,
    /// the factor by which it takes the gas torque's harmonic of one cylinder to that of the engine.
    FiringHarmonic {
        /// Order in half cycles per revolution: 1 is order 0.5.
        half_orders: u32,
    },
    /// Successive firings of cylinders that stand side by side in one bank.
    NeighbourFirings,
    /// Length [m]: distance of the outermost cylinder axes and the ends.
    Length,
    /// Height [m]: crank radius and rod length.
    Height,
    /// Counterweights on the webs, sum of their unbalances [kg m].
    CounterweightUnbalance,
    /// Number of balance shafts.
    Shafts,
}

/// How much of a case a number depends on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Level {
    /// On the sizes that a whole block of cases shares.
    Block,
    /// On the crank.
    Crank,
    /// On the firing.
    Firing,
}

impl Objective {
    /// Name for tables and messages.
    pub fn name(self) -> String {
        match self {
            Objective::Force { order } => format!("force of order {order}"),
            Objective::Couple { order } => format!("couple of order {order}"),
            Objective::ForceSense { order, sense } => format!("{} force of order {order}", sense.name()),
            Objective::CoupleSense { order, sense } => format!("{} couple of order {order}", sense.name()),
            Objective::RollMoment { order } => format!("roll moment of order {order}"),
            Objective::InertiaTorque { order } => format!("inertia torque of order {order}"),
            Objective::BendingMoment => "bending moment".to_string(),
            Objective::MainLoad => "main-bearing load".to_string(),
            Objective::FiringUnevenness => "unevenness of firing".to_string(),
            Objective::FiringHarmonic { half_orders } => {
                format!("firing harmonic of order {}", 0.5 * f64::from(half_orders))
            }
            Objective::NeighbourFirings => "successive firings of neighbours".to_string(),
            Objective::Length => "length".to_string(),
            Objective::Height => "height".to_string(),
            Objective::CounterweightUnbalance => "counterweights".to_string(),
            Objective::Shafts => "balance shafts".to_string(),
        }
    }

    /// Its unit, empty for a plain number.
    pub fn unit(self) -> &'static str {
        match self {
            Objective::Force { .. } | Objective::ForceSense { .. } | Objective::MainLoad => "N",
            Objective::Couple { .. }
            | Objective::CoupleSense { .. }
            | Objective::RollMoment { .. }
            | Objective::InertiaTorque { .. }
            | Objective::BendingMoment => "N m",
            Objective::FiringUnevenness => "rad",
            Objective::Length | Objective::Height => "m",
            Objective::CounterweightUnbalance => "kg m",
            Objective::FiringHarmonic { .. } | Objective::NeighbourFirings | Objective::Shafts => "",
        }
    }

    /// The order that it is about, where only 1 and 2 are computed.
    pub(crate) fn order(self) -> Option<u32> {
        match self {
            Objective::Force { order }
            | Objective::Couple { order }
            | Objective::ForceSense { order, .. }
            | Objective::CoupleSense { order, .. }
            | Objective::RollMoment { order }
            | Objective::InertiaTorque { order } => Some(order),
            _ => None,
        }
    }

    pub(crate) fn level(self) -> Level {
        match self {
            Objective::Length | Objective::Height | Objective::Shafts => Level::Block,
            Objective::FiringUnevenness | Objective::FiringHarmonic { .. } | Objective::NeighbourFirings => {
                Level::Firing
            }
            _ => Level::Crank,
        }
    }
}

impl Sense {
    /// Name for tables.
    pub fn name(self) -> &'static str {
        match self {
            Sense::Forward => "forward",
            Sense::Backward => "backward",
        }
    }
}
