//! Why an engine or a run is refused.

use serde::Serialize;

/// What keeps a simulation from starting.
#[derive(Debug, Clone, PartialEq, thiserror::Error, Serialize)]
#[non_exhaustive]
pub enum MultibodyError {
    /// A number lies outside what is possible.
    #[error("{quantity} must be {needed}, got {got}")]
    Number {
        /// What it is, with its unit.
        quantity: String,
        /// What it must be.
        needed: &'static str,
        /// What it is.
        got: f64,
    },
    /// The rod of a cylinder does not reach its piston pin at every angle.
    #[error(
        "the rod of cylinder {cylinder} is {length} m long, but its piston pin is up to {needed} m beside its lower pin: the crank train locks"
    )]
    Locks {
        /// Number of the cylinder, from 1.
        cylinder: usize,
        /// Largest distance to be bridged across the cylinder axis [m].
        needed: f64,
        /// Length of the rod [m].
        length: f64,
    },
    /// An articulated rod sits on a rod that is articulated itself or belongs to another throw.
    #[error(
        "cylinder {cylinder} has its knuckle pin on the rod of cylinder {master}, which must be a plain rod on the same throw"
    )]
    MasterNotPlain {
        /// Number of the cylinder, from 1.
        cylinder: usize,
        /// Number of its master, from 1.
        master: usize,
    },
    /// The numbers of the block are smaller than the parts that they hold.
    #[error(
        "the block less {part} would have {quantity} of {}: the numbers in [block] must hold all its parts, or say moving_parts = \"added\"",
        four_digits(*got)
    )]
    BlockTooSmall {
        /// What was taken from it last.
        part: String,
        /// Which number, with its unit.
        quantity: &'static str,
        /// What would be left.
        got: f64,
    },
    /// The block is to move, but the file lacks something for it.
    #[error("the block cannot move: {missing}; add it, or simulate with the block fixed")]
    NoMounts {
        /// What is missing.
        missing: String,
    },
    /// A run with free speed needs the polar inertia of everything that turns.
    #[error("free speed needs the moment of inertia of the {part}: give {keys}")]
    NoInertia {
        /// What has no inertia.
        part: String,
        /// Keys of the engine file that give it.
        keys: &'static str,
    },
    /// Pressures are given, but a cylinder lacks what turns them into forces.
    #[error("cylinder {cylinder} has gas but no {missing}")]
    NoGasData {
        /// Number of the cylinder, from 1.
        cylinder: usize,
        /// What is missing.
        missing: &'static str,
    },
    /// The run would take too long.
    #[error(
        "the run would take {}: {}",
        [
            beyond(*evaluations, *most_evaluations, "evaluations of the equations of motion"),
            beyond(*samples, *most_samples, "samples"),
        ]
        .into_iter()
        .flatten()
        .collect::<Vec<_>>()
        .join(", and "),
        match samples > most_samples {
            true => "make it shorter, take a larger sample step, or ask for a long run",
            false => "make it shorter, or ask for a long run",
        }
    )]
    TooLong {
        /// Estimate of the evaluations of the equations of motion.
        evaluations: f64,
        /// Samples.
        samples: f64,
        /// Evaluations that are allowed.
        most_evaluations: f64,
        /// Samples that are allowed.
        most_samples: f64,
    },
    /// An imposed speed that ends at rest, or backwards, before the revolutions of the run are done.
    #[error(
        "the imposed speed turns the crankshaft {turned:.4} revolutions until {at} s and no further: a run of {wanted} revolutions never ends\nhint: ask for fewer revolutions, or for a time"
    )]
    StandsStill {
        /// Time at which the crankshaft has turned furthest [s].
        at: f64,
        /// Revolutions until then, from the start.
        turned: f64,
        /// Revolutions that were asked for.
        wanted: f64,
    },
    /// A periodic motion is asked for under an imposed speed that changes over time.
    #[error(
        "a motion under an imposed speed that changes over time has no period: ask for a number of revolutions or a time, or for a constant speed"
    )]
    NoPeriod,
    /// A crankshaft is to turn as a body, and the file does not describe one.
    #[error("{name} cannot turn as a body: {reason}")]
    NoCrankBody {
        /// Name of the crankshaft.
        name: String,
        /// Why.
        reason: String,
    },
    /// A shaft cannot be driven by the teeth that are given.
    #[error("the gear of \"{shaft}\" has no line of action: {reason}")]
    NoMesh {
        /// Name of the shaft.
        shaft: String,
        /// Why.
        reason: String,
    },
    /// A saved state of another run.
    #[error(
        "the saved state has {got} numbers and is that of another engine or simulation: this one has {needed}"
    )]
    ForeignState {
        /// Numbers of a state of this run.
        needed: usize,
        /// Numbers of the state that was saved.
        got: usize,
    },
    /// The equations of motion have no solution at a state.
    #[error("the mass matrix at crank angle {theta} rad is not positive definite")]
    Singular {
        /// Crank angle of crankshaft 1 [rad].
        theta: f64,
    },
}

/// How many of something a run would take, where that is more than it may.
fn beyond(count: f64, most: f64, name: &str) -> Option<String> {
    let about = match count <= COUNTABLE {
        true => format!("about {count:.1e} {name}"),
        false => format!("more {name} than could ever be made"),
    };
    (count > most).then(|| format!("{about}, where {most:.0e} are allowed"))
}

/// Evaluations that no machine makes in a lifetime.
const COUNTABLE: f64 = 1e18;

/// `value` with four significant digits.
fn four_digits(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}
