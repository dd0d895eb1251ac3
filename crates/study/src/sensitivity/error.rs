//! Why sensitivities are refused.

use lanchester_mechanism::{LoadError, MountError, TorqueError};

/// Why sensitivities are refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SensitivityError {
    /// Nothing is asked for.
    #[error("a sensitivity needs at least one output, got none")]
    NoOutput,
    /// Nothing varies.
    #[error("nothing varies\nhint: name a quantity that the engine has, such as piston mass")]
    NoInput,
    /// A quantity that the engine does not have.
    #[error("the engine has no {quantity}\nhint: leave it out")]
    NoSuchPart {
        /// Its name.
        quantity: &'static str,
    },
    /// A share of nothing, or of sizes that differ.
    #[error(
        "the {quantity} has no size of which a share could be taken: it is 0, or differs from part to part\nhint: say how far it goes with its unit, or let each part vary by itself"
    )]
    NoSize {
        /// Its name.
        quantity: &'static str,
    },
    /// An amount that is none.
    #[error("the {quantity} must vary by a finite amount above 0, got {got}")]
    Amount {
        /// Its name.
        quantity: &'static str,
        /// The amount.
        got: f64,
    },
    /// A factor that would reach 0.
    #[error(
        "the {quantity} must vary by less than 100 % of itself, got {got} %\nhint: it is a factor on what the file says, and would reach 0"
    )]
    Factor {
        /// Its name.
        quantity: &'static str,
        /// The amount [%].
        got: f64,
    },
    /// Too few or too many draws.
    #[error("shares of the variance need from 16 to 10 000 000 draws, got {got}")]
    Samples {
        /// How many.
        got: u64,
    },
    /// Ranges without an engine.
    #[error(
        "no draw from the ranges is an engine: rods would be too short, or masses below nothing\nhint: make the ranges smaller"
    )]
    NoEngine,
    /// It was given up: nobody waits for it any more.
    #[error("the draws for the shares of the variance were stopped")]
    Stopped,
    /// An output of another name.
    #[error(
        "there is no output \"{got}\"\nhint: write force, couple, roll moment, torque, excess energy, speed fluctuation, main-bearing load 1, crankpin load 1, piston-pin load 1, side thrust 1, bending moment or mount force NAME; behind it `order 2` or `mean`, before it `gas` or `inertia`"
    )]
    NoSuchOutput {
        /// The name.
        got: String,
    },
    /// A load that criteria refuse.
    #[error("{message}\nhint: {hint}")]
    Wording {
        /// What is wrong.
        message: String,
        /// What to write.
        hint: String,
    },
    /// A number that is none.
    #[error(
        "the number of a {of} must be a whole number from 1 on, got \"{got}\"\nhint: write {of} 1, or {of} for the largest of all"
    )]
    Number {
        /// Of what.
        of: &'static str,
        /// What was got.
        got: String,
    },
    /// A bearing, cylinder or mount that the engine does not have.
    #[error(
        "the engine has no {of} {got}, the last one is {of} {count}\nhint: they are numbered from 1, crankshaft 1 first"
    )]
    NoSuchNumber {
        /// Of what.
        of: &'static str,
        /// The number.
        got: usize,
        /// How many there are.
        count: usize,
    },
    /// A size that the load does not have.
    #[error(
        "the {load} has no such size\nhint: ask for the peak or for one order of a load, for the mean of a torque or of the force on a bearing, for excess energy, speed fluctuation and bending moment as they are"
    )]
    NoSuchSize {
        /// Its name.
        load: String,
    },
    /// An order that is none.
    #[error("an order must be above 0 and at most 1000, got {got}")]
    Order {
        /// The order.
        got: f64,
    },
    /// An output with gas of an engine without.
    #[error(
        "the {output} needs the gas, and the engine file says nothing of it\nhint: add [gas] with [[gas.trace]] or [gas.cycle], or write `inertia` before the load"
    )]
    NoGas {
        /// Its name.
        output: String,
    },
    /// A fluctuation of a speed that is not known or not periodic.
    #[error("there is no speed fluctuation: {reason}\nhint: {fix}")]
    NoFluctuation {
        /// Why.
        reason: String,
        /// What fixes it.
        fix: String,
    },
    /// A load of which gas and inertia have no part of their own.
    #[error("there is no {load} of gas or inertia alone\nhint: leave `gas` or `inertia` out")]
    NoSuchPartOf {
        /// The load.
        load: String,
    },
    /// Gas leaves the block in balance.
    #[error(
        "gas gives the block no {load} of its own\nhint: its roll moment is the opposite of the gas torque: write `gas torque`"
    )]
    NoGasForce {
        /// The load.
        load: String,
    },
    /// The loads cannot be computed.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// The torque or the bearings cannot be computed.
    #[error(transparent)]
    Torque(#[from] TorqueError),
    /// The mounts cannot be computed.
    #[error(transparent)]
    Mounts(#[from] MountError),
}
