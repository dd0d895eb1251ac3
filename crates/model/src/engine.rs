//! An engine that is known to be valid.
//!
//! Every index exists, every linkage turns, every mass is finite and not negative, no two parts of a kind have one name. Nothing downstream
//! checks this again: [`EngineParts`] are plain data, and become an engine by [`Engine::new`] alone.

use crate::engine_check;
use crate::engine_parts::EngineParts;
use crate::fault::Fault;
use serde::Serialize;

/// A piston engine in its general form, known to be valid. Its parts are read as fields: `engine.throws[0].radius`.
///
/// # Example
/// ```
/// use lanchester_model::{Crankshaft, Cylinder, Engine, EngineParts, Rod, SpeedRange, Throw};
///
/// let single = Engine::new(EngineParts {
///     name: "Single".into(),
///     speed: SpeedRange { lowest: 100.0, highest: 300.0 },
///     crankshafts: vec![Crankshaft::default()],
///     throws: vec![Throw { radius: 0.03, ..Throw::default() }],
///     cylinders: vec![Cylinder { piston_mass: 0.3, rod: Rod::by_thirds(0.1, 0.3), ..Cylinder::default() }],
///     ..EngineParts::default()
/// })
/// .unwrap();
/// assert!((single.cylinders[0].reciprocating_mass() - 0.4).abs() < 1e-15);
///
/// let faults = single.with(|parts| parts.cylinders[0].rod.length = 0.02).unwrap_err();
/// assert!(faults[0].to_string().starts_with("cylinders[0].rod: length [m] must be more than"));
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(transparent)]
pub struct Engine(EngineParts);

impl std::ops::Deref for Engine {
    type Target = EngineParts;

    fn deref(&self) -> &EngineParts {
        &self.0
    }
}

impl Engine {
    /// The engine of these parts.
    ///
    /// # Errors
    /// All [`Fault`]s at once: a number that is not finite or has the wrong sign, a place in a list that does not exist, a linkage that
    /// cannot turn, two parts of one name.
    pub fn new(parts: EngineParts) -> Result<Engine, Vec<Fault>> {
        let faults = engine_check::faults(&parts);
        if faults.is_empty() { Ok(Engine(parts)) } else { Err(faults) }
    }

    /// A copy with a change.
    ///
    /// # Errors
    /// As [`Engine::new`].
    pub fn with(&self, change: impl FnOnce(&mut EngineParts)) -> Result<Engine, Vec<Fault>> {
        let mut parts = self.0.clone();
        change(&mut parts);
        Engine::new(parts)
    }

    /// A copy without the weights on its crankshafts.
    pub fn without_counterweights(&self) -> Engine {
        Engine(EngineParts { counterweights: Vec::new(), ..self.0.clone() })
    }

    /// A copy without balance shafts.
    pub fn without_shafts(&self) -> Engine {
        Engine(EngineParts { shafts: Vec::new(), ..self.0.clone() })
    }

    /// Its parts, to be changed and made an engine again.
    pub fn into_parts(self) -> EngineParts {
        self.0
    }
}
