//! Why an engine's crankshaft is no body.

use lanchester_model::CrankElementsFault;
use lanchester_shape::GeometryError;

/// What an engine needs so that its crankshaft is a body.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CrankshaftError {
    /// A crankshaft that the engine does not have.
    #[error("the engine has {count} crankshaft(s), asked for number {}\nhint: they are counted from 1 in the file", .index + 1)]
    NoCrankshaft {
        /// Index that was asked for.
        index: usize,
        /// How many there are.
        count: usize,
    },
    /// An engine whose file says nothing of journals, pins and webs.
    #[error(
        "the engine file has no [crank.body], which the crankshaft as a body needs\nhint: add [crank.body] with density, journal_diameter, pin_diameter, web_thickness, web_radius, pin_end_radius and end_journals"
    )]
    NoBody,
    /// A crankshaft without throws.
    #[error("crankshaft {} has no throw\nhint: give it one", .index + 1)]
    NoThrow {
        /// Its index.
        index: usize,
    },
    /// A throw without places for its webs.
    #[error(
        "throw {} needs the distance of its webs\nhint: add web_distance = \"44 mm\" to [crank] or to the throw", .throw + 1
    )]
    NoWebs {
        /// Index of the throw.
        throw: usize,
    },
    /// Webs that leave no room for the crankpin.
    #[error(
        "the webs of throw {} leave {:.4} mm for the crankpin\nhint: the pin is as long as the distance of the webs less their thickness", .throw + 1, 1e3 * .length
    )]
    NoPin {
        /// Index of the throw.
        throw: usize,
        /// Length that is left [m].
        length: f64,
    },
    /// A journal, pin, web or weight whose shape cannot be.
    #[error("{what}: {source}")]
    Shape {
        /// Its name.
        what: String,
        /// Why.
        source: GeometryError,
    },
    /// Two pieces at the same place along the crank whose common outline cannot be told.
    #[error("{first} and {second}: {source}")]
    Joint {
        /// One piece.
        first: String,
        /// The other piece.
        second: String,
        /// Why.
        source: GeometryError,
    },
}

impl From<CrankElementsFault> for CrankshaftError {
    fn from(fault: CrankElementsFault) -> CrankshaftError {
        match fault {
            CrankElementsFault::NoCrankshaft { index, count } => {
                CrankshaftError::NoCrankshaft { index, count }
            }
            CrankElementsFault::NoThrow { index } => CrankshaftError::NoThrow { index },
            CrankElementsFault::NoWebs { throw } => CrankshaftError::NoWebs { throw },
            CrankElementsFault::NoPin { throw, length } => CrankshaftError::NoPin { throw, length },
            _ => CrankshaftError::NoBody,
        }
    }
}
