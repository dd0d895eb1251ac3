//! Inertias of everything that turns, in one table: each body with its number, what it is at crankshaft 1, and where it comes from.

use lanchester_geometry::crankshaft::crankshaft;
use lanchester_mechanism::KnownInertia;
use lanchester_model::{Engine, EngineParts, Flywheel, InertiaSum, RotatingBody, ShapedCrankshaft, Sourced};
use lanchester_multibody::RotorInertia;
use lanchester_task::Tasks;
use serde::Serialize;
use std::borrow::Cow;

/// Version of [`Inertias`]; raised when a field changes its meaning or goes.
pub const INERTIAS_VERSION: u32 = 1;

/// What turns with an engine.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Inertias {
    /// [`INERTIAS_VERSION`].
    pub version: u32,
    /// All that turns at a fixed ratio to crankshaft 1.
    pub bodies: Vec<RotatingBody>,
    /// Of crankshafts that are bodies what belongs to each throw: pin, webs and counterweights on them; part of the crankshaft's own number.
    pub throws: Vec<ThrowInertia>,
    /// What is behind the flywheel on springs, in order; not in the sum.
    pub driveline: Vec<DrivelineBody>,
    /// All bodies as seen at crankshaft 1.
    pub sum: InertiaSum,
}

/// Share of a throw in the inertia of its crankshaft.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ThrowInertia {
    /// Index of its crankshaft.
    pub crankshaft: usize,
    /// Index of the throw.
    pub throw: usize,
    /// Mass [kg].
    pub mass: f64,
    /// Moment of inertia about the axis of its crankshaft [kg m^2].
    pub inertia: f64,
}

/// An inertia of the driveline.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct DrivelineBody {
    /// Speed over that of crankshaft 1 where no spring twists.
    pub ratio: f64,
    /// Moment of inertia about its axis [kg m^2].
    pub inertia: Sourced,
}

/// Crankshafts that are bodies, with mass, centre and inertia from their shape; `None` for others.
pub fn shaped_crankshafts(engine: &Engine) -> Vec<Option<ShapedCrankshaft>> {
    let of = |index: usize| {
        let body = crankshaft(engine, index).ok()?;
        let (mass, centre) = (body.mass.mass, body.mass.centre);
        Some(ShapedCrankshaft { mass, centre, inertia: body.polar_inertia })
    };
    (0..engine.crankshafts.len()).map(of).collect()
}

/// All that turns with `engine` at a fixed ratio to crankshaft 1: the one list that torque, cyclic speed fluctuation, mounts and simulation take their
/// inertia from.
pub fn rotating_bodies(engine: &Engine) -> Vec<RotatingBody> {
    engine.rotating_bodies(&shaped_crankshafts(engine))
}

/// [`rotating_bodies`] as a multibody simulation takes them.
pub fn rotor_inertia(engine: &Engine) -> RotorInertia {
    RotorInertia::of(&rotating_bodies(engine))
}

/// What of [`rotating_bodies`] swings the speed: flywheel and crankshafts, as seen at crankshaft 1.
pub(crate) fn known_inertia(engine: &Engine) -> KnownInertia {
    KnownInertia::of_bodies(&rotating_bodies(engine))
}

/// `engine` with the inertia of its crankshafts as bodies among its numbers, for kernels that know the numbers alone: mounts that feel what turns.
pub(crate) fn with_known_rotors(engine: &Engine) -> Cow<'_, Engine> {
    let is_given = engine.flywheel.as_ref().is_some_and(|wheel| wheel.crankshaft_inertia.is_some());
    let bodies = if is_given || !engine.is_on_springs() { None } else { known_inertia(engine).crankshaft };
    let with = |inertia| {
        let add = |parts: &mut EngineParts| {
            parts.flywheel.get_or_insert_with(Flywheel::default).crankshaft_inertia = Some(inertia);
        };
        engine.with(add).ok().map(Cow::Owned)
    };
    bodies.and_then(with).unwrap_or(Cow::Borrowed(engine))
}

/// The inertias of an engine and of the driveline that its file gives.
pub fn inertias(engine: &Engine, tasks: &Tasks) -> Inertias {
    let bodies = rotating_bodies(engine);
    let throws = throw_inertias(engine);
    let mut ratio = 1.0;
    let links = tasks.simulation.iter().flat_map(|input| &input.driveline);
    let driveline = links
        .map(|link| {
            ratio *= link.ratio;
            DrivelineBody { ratio, inertia: Sourced::given(link.inertia) }
        })
        .collect();
    let sum = InertiaSum::of(&bodies);
    Inertias { version: INERTIAS_VERSION, bodies, throws, driveline, sum }
}

/// Mass and moment of inertia about the crank axis that each throw has of the crankshaft, by throw; without those whose crankshaft says too little.
pub(crate) fn throw_inertias(engine: &Engine) -> Vec<ThrowInertia> {
    let shares =
        (0..engine.crankshafts.len()).filter_map(|index| Some((index, crankshaft(engine, index).ok()?)));
    let mut throws: Vec<ThrowInertia> = shares
        .flat_map(|(crankshaft, body)| body.throws.into_iter().map(move |share| (crankshaft, share)))
        .filter_map(|(crankshaft, share)| {
            let (mass, inertia) = (share.mass, share.polar_inertia);
            Some(ThrowInertia { crankshaft, throw: share.throw?, mass, inertia })
        })
        .collect();
    throws.sort_by_key(|share| share.throw);
    throws
}
