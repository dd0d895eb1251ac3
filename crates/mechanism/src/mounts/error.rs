//! Why mounts cannot be computed.

use crate::inertia::request::LoadError;

/// Why mounts cannot be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MountError {
    /// The engine has no block.
    #[error(
        "the motion on the mounts needs the mass, centre and inertia of the block\nhint: add a [block] section"
    )]
    NoBlock,
    /// The engine has no mounts.
    #[error("the motion on the mounts needs mounts, got none\nhint: add [[mount]] entries with a stiffness")]
    NoMounts,
    /// A mount has a place only.
    #[error(
        "mount `{mount}` needs a stiffness\nhint: give each [[mount]] a `stiffness`, such as \"200 N/mm\""
    )]
    NoStiffness {
        /// Its name.
        mount: String,
    },
    /// A number lies outside what is possible.
    #[error("{quantity} must be {needed}, got {got}")]
    Number {
        /// Which number, with its unit.
        quantity: String,
        /// What is possible.
        needed: &'static str,
        /// What was given.
        got: f64,
    },
    /// No body has this inertia.
    #[error("no body has this inertia: {reason}\nhint: {hint}")]
    Inertia {
        /// Which inequality is broken, with numbers.
        reason: String,
        /// What to look at.
        hint: &'static str,
    },
    /// A mount's table does not rise.
    #[error("the table of mount `{mount}` must rise in frequency, got {got} rad/s after {before} rad/s")]
    Table {
        /// Its name.
        mount: String,
        /// A frequency [rad/s].
        before: f64,
        /// The one that follows it [rad/s].
        got: f64,
    },
    /// The mounts leave the block a motion without any force.
    #[error(
        "the mounts leave the block free: {motion}\nhint: add a mount off that line, or stiffness in that direction"
    )]
    Free {
        /// The motion in words.
        motion: String,
    },
    /// The orders have no common period that is short enough.
    #[error("the orders of the excitation must repeat within {limit} revolutions, got order {order}")]
    Period {
        /// Longest period [revolutions].
        limit: u32,
        /// The order that does not fit.
        order: f64,
    },
    /// Undamped, and excited at a natural frequency: no steady motion exists.
    #[error(
        "order {order} at {speed} rad/s meets a natural frequency of the undamped block, where no steady motion \
         exists\nhint: give the mounts `damping` or a `loss_factor`"
    )]
    Resonance {
        /// Order.
        order: f64,
        /// Speed of crankshaft 1 [rad/s].
        speed: f64,
    },
    /// The iteration for the roots did not end.
    #[error("the damped modes were not found: the iteration for the roots did not converge")]
    Roots,
    /// The engine's own loads cannot be computed.
    #[error(transparent)]
    Loads(#[from] LoadError),
}
