//! A question: how its arguments are read, what computes its answer, of which type that is.

use crate::answer::Data;
use crate::failure::Failure;
use crate::guard::Watch;
use crate::options::Options;
use crate::prepared::Prepared;
use schemars::{JsonSchema, Schema, SchemaGenerator};
use std::sync::Arc;

/// Computes the answer about engines: most questions are about the first alone.
pub type Run = Box<dyn Fn(&[Arc<Prepared>], &Watch) -> Result<Data, Failure> + Send + Sync>;

/// How long an answer takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum How {
    /// Milliseconds at most: it is computed where it is asked.
    Short,
    /// It may be longer: Ctrl-C is heard meanwhile.
    Long,
}

/// A question.
pub struct Question {
    /// Its name.
    pub name: &'static str,
    /// How long it takes.
    pub how: How,
    /// Reads its arguments.
    pub read: fn(&Options<'_>) -> Result<Run, Failure>,
    /// The type of its answer.
    pub schema: fn(&mut SchemaGenerator) -> Schema,
}

impl Question {
    /// A question whose answer is a `T`.
    pub const fn of<T: JsonSchema>(
        name: &'static str,
        how: How,
        read: fn(&Options<'_>) -> Result<Run, Failure>,
    ) -> Question {
        Question { name, how, read, schema: SchemaGenerator::subschema_for::<T> }
    }
}
