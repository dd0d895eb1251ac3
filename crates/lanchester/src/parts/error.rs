//! Why counterweights cannot be designed, fitted or exported.

use crate::parts::clearance::EngineClearanceError;
use lanchester_geometry::GeometryError;
use lanchester_geometry::crankshaft::CrankshaftError;
use lanchester_model::Fault;

/// Why no counterweight can be designed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CounterweightError {
    /// With it there would be no engine.
    #[error(transparent)]
    Engine(Fault),
    /// No weight on any web.
    #[error(
        "no counterweight stands on a web\nhint: {}", match .has_weights {
            true => "name one, or give the weights a web: `web = 1` in [[counterweight]], `at = \"webs\"` in [counterweights]",
            false => "find the best ones on the webs first"
        }
    )]
    NoneOnAWeb {
        /// Whether there are weights elsewhere.
        has_weights: bool,
    },
    /// A name that no weight has.
    #[error("no counterweight is called \"{name}\"\nhint: the names are {known}")]
    Unknown {
        /// The name.
        name: String,
        /// The names that there are.
        known: String,
    },
    /// A weight without any unbalance.
    #[error(
        "counterweight \"{name}\" has no unbalance to be designed for\nhint: give one, or leave the weight out"
    )]
    NoDuty {
        /// Its name.
        name: String,
    },
    /// Weights of different duties where one is due.
    #[error(
        "the weights have different duties: {}\nhint: name one of them, or give one unbalance for all", .duties.join(", ")
    )]
    Duties {
        /// Each weight with its duty, in words.
        duties: Vec<String>,
    },
    /// A name that several weights have.
    #[error("{count} counterweights are called \"{name}\"\nhint: give each its own name")]
    Several {
        /// The name.
        name: String,
        /// How many have it.
        count: usize,
    },
    /// A whole web where the engine has no plain one to take the place of.
    #[error(
        "the outline of a whole web needs a weight on a web, and [crank.body] for the plain web that it replaces; \"{name}\" has not both\nhint: draw the counterweight alone, or add them to the engine file"
    )]
    NoPlainWeb {
        /// Name of the weight.
        name: String,
    },
    /// A part that is no single weight, or does not fit its web.
    #[error("counterweight \"{name}\": {fault}\nhint: change its outline or its inserts")]
    Fault {
        /// Name of the weight.
        name: String,
        /// What is wrong.
        fault: String,
    },
    /// Something that the crankshaft must stay clear of and that is not given completely.
    #[error(transparent)]
    Clearance(#[from] EngineClearanceError),
    /// A crankshaft that is no body.
    #[error(transparent)]
    Crankshaft(#[from] CrankshaftError),
    /// A name that no balance shaft has.
    #[error("no balance shaft is called \"{name}\"\nhint: {}", match .known.as_str() {
        "" => "the file has no [[shaft]]".to_owned(),
        known => format!("the names are {known}"),
    })]
    UnknownShaft {
        /// The name.
        name: String,
        /// The names that there are.
        known: String,
    },
    /// A balance shaft none of whose weights is a part.
    #[error(
        "no weight of the shaft \"{name}\" has a shape yet\nhint: design them first, in a file with a section [shaft_weight_design]"
    )]
    BareShaft {
        /// Name of the shaft.
        name: String,
    },
    /// No weight that is a part.
    #[error(
        "no counterweight and no weight of a balance shaft has a shape yet\nhint: design shapes first, or take them from a drawing"
    )]
    NoPart,
    /// Numbers of the task that have no meaning.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
}

impl CounterweightError {
    /// The first of the faults of parts that make no valid engine.
    pub(crate) fn engine(faults: Vec<Fault>) -> CounterweightError {
        CounterweightError::Engine(Fault::first_of(faults))
    }
}
