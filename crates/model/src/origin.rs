//! Where a number comes from.

use serde::Serialize;
use std::fmt;

/// Where a number comes from. What nobody knows is no number: it is `None` beside the key that would give it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Origin {
    /// The file gives it.
    Given,
    /// It follows from shape and density that the file gives.
    FromShape,
    /// A usual value of its kind, from a table with its source.
    Typical,
    /// Taken for want of better, such as a shaft without inertia as its weights alone.
    Assumed,
}

impl Origin {
    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Origin::Given => "given",
            Origin::FromShape => "from its shape",
            Origin::Typical => "typical value",
            Origin::Assumed => "assumed",
        }
    }

    /// That of a sum: the least certain of its parts.
    pub fn least_certain(self, other: Origin) -> Origin {
        self.max(other)
    }
}

impl fmt::Display for Origin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.words())
    }
}

/// A number with its origin.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Sourced {
    /// The number, in SI units.
    pub value: f64,
    /// Where it comes from.
    pub origin: Origin,
}

impl Sourced {
    /// A number of the file.
    pub fn given(value: f64) -> Sourced {
        Sourced { value, origin: Origin::Given }
    }

    /// A number that follows from a shape.
    pub fn from_shape(value: f64) -> Sourced {
        Sourced { value, origin: Origin::FromShape }
    }

    /// The same number times a factor.
    pub fn times(self, factor: f64) -> Sourced {
        Sourced { value: self.value * factor, ..self }
    }
}
