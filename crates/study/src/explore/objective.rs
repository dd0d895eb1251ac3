//! What layouts are judged by: numbers of which less is better.

use lanchester_results::{Counted, Output, Quantity};
use serde::{Deserialize, Serialize};

pub use lanchester_results::Sense;

/// A number of which less is better. Loads are those on the block without gas, at the speed of the parts; the residual
/// of the layout's own counterweights and balance shafts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
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

/// Highest harmonic of the firing, in half orders.
const LARGEST_HARMONIC: u32 = 1000;

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
    /// What it is in the words of all studies.
    pub fn output(self) -> Output {
        let of = |quantity, order: u32| Output::of(quantity).order(f64::from(order));
        match self {
            Objective::Force { order } => of(Quantity::Force, order),
            Objective::Couple { order } => of(Quantity::Couple, order),
            Objective::ForceSense { order, sense } => of(Quantity::Force, order).turning(sense),
            Objective::CoupleSense { order, sense } => of(Quantity::Couple, order).turning(sense),
            Objective::RollMoment { order } => of(Quantity::RollMoment, order),
            Objective::InertiaTorque { order } => of(Quantity::Torque, order).counting(Counted::Inertia),
            Objective::BendingMoment => Output::of(Quantity::BendingMoment),
            Objective::MainLoad => Output::of(Quantity::MainBearingLoad),
            Objective::FiringUnevenness => Output::of(Quantity::UnevenFiring),
            Objective::FiringHarmonic { half_orders } => {
                Output::of(Quantity::FiringHarmonic).order(0.5 * f64::from(half_orders))
            }
            Objective::NeighbourFirings => Output::of(Quantity::NeighbourFirings),
            Objective::Length => Output::of(Quantity::Length),
            Objective::Height => Output::of(Quantity::Height),
            Objective::CounterweightUnbalance => Output::of(Quantity::Counterweights),
            Objective::Shafts => Output::of(Quantity::BalanceShafts),
        }
    }

    /// Every objective, of an order with the orders that are usual.
    pub fn all() -> Vec<Objective> {
        let of_order = |order| {
            let turning = [Sense::Forward, Sense::Backward].into_iter();
            let forces = turning.clone().map(move |sense| Objective::ForceSense { order, sense });
            let couples = turning.map(move |sense| Objective::CoupleSense { order, sense });
            [Objective::Force { order }, Objective::Couple { order }]
                .into_iter()
                .chain(forces)
                .chain(couples)
                .chain([Objective::RollMoment { order }, Objective::InertiaTorque { order }])
        };
        let without_order = [
            Objective::BendingMoment,
            Objective::MainLoad,
            Objective::FiringUnevenness,
            Objective::NeighbourFirings,
            Objective::Length,
            Objective::Height,
            Objective::CounterweightUnbalance,
            Objective::Shafts,
        ];
        let harmonics = (1..=LARGEST_HARMONIC).map(|half_orders| Objective::FiringHarmonic { half_orders });
        (1..=2).flat_map(of_order).chain(without_order).chain(harmonics).collect()
    }

    /// The objective that an output is, if layouts can be judged by it.
    pub fn of(output: &Output) -> Option<Objective> {
        Objective::all().into_iter().find(|objective| objective.output() == *output)
    }

    /// Name for tables and messages.
    pub fn name(self) -> String {
        self.output().title()
    }

    /// Its unit, empty for a plain number.
    pub fn unit(self) -> &'static str {
        self.output().unit()
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
