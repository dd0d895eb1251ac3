//! The clearances of an engine: its exact linkages joined with the shapes on its crankshafts.

use lanchester_geometry::Point;
use lanchester_geometry::clearance::{
    ClearanceCurve, ClearanceError, ClearanceModel, Clearances, Obstacle, RodBounds, RodMotion, RodPose,
    SweptRoom,
};
use lanchester_mechanism::{LoadError, RodLinkage};
use lanchester_model::Engine;

/// Why the clearances of an engine cannot be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EngineClearanceError {
    /// What is in the way, or what turns, is not given or not possible.
    #[error(transparent)]
    Clearance(#[from] ClearanceError),
    /// A linkage does not turn.
    #[error(transparent)]
    Linkage(#[from] LoadError),
}

/// The exact motion of a cylinder's rod and piston, as clearances ask for it.
#[derive(Debug, Clone, PartialEq)]
pub struct ExactRod(RodLinkage);

impl RodMotion for ExactRod {
    fn pose(&self, theta: f64) -> RodPose {
        let place = self.0.at(theta);
        let [lower_pin, lower_pin_rate] = place.lower_pin.map(|pin| Point::new(pin.re, pin.im));
        let ([direction, direction_rate], [travel, travel_rate]) = (place.direction, place.travel);
        RodPose { lower_pin, lower_pin_rate, direction, direction_rate, travel, travel_rate }
    }

    fn bounds(&self) -> RodBounds {
        let reach = self.0.reach();
        RodBounds { lower_pin: reach.lower_pin, direction: reach.direction, travel: reach.travel }
    }
}

/// An engine prepared for its clearances, with the exact motion of all its rods, articulated ones included.
///
/// # Errors
/// [`EngineClearanceError`] where the engine names nothing to stay clear of, a bore is missing, or a linkage does not turn.
pub fn clearance_model(engine: &Engine) -> Result<ClearanceModel<'_, ExactRod>, EngineClearanceError> {
    let rods = (0..engine.cylinders.len()).map(|index| RodLinkage::new(engine, index).map(ExactRod));
    let rods = rods.collect::<Result<Vec<_>, _>>()?;
    Ok(ClearanceModel::new(engine, rods)?)
}

/// The smallest distance of every counterweight and web from crankcase, pistons, liners and rods, over all angles and in space,
/// each with its proof: [`ClearanceModel::clearances`].
///
/// # Errors
/// As [`clearance_model`], and where nothing that turns has a shape or geared crankshafts have too long a period.
pub fn clearances(engine: &Engine) -> Result<Clearances, EngineClearanceError> {
    Ok(clearance_model(engine)?.clearances()?)
}

/// The distance of a counterweight or web, by its index in [`Clearances::bodies`], from an obstacle at `count` angles:
/// [`ClearanceModel::curve`].
///
/// # Errors
/// As [`clearances`], and where there is no such counterweight or obstacle.
pub fn clearance_curve(
    engine: &Engine,
    body: usize,
    obstacle: Obstacle,
    count: usize,
) -> Result<ClearanceCurve, EngineClearanceError> {
    Ok(clearance_model(engine)?.curve(body, obstacle, count)?)
}

/// The largest swept radius of a counterweight on a crankshaft (by index) between two planes [m] that keeps the wanted clearance
/// whatever its shape: sufficient, not necessary, [`ClearanceModel::largest_swept_radius`].
///
/// # Errors
/// As [`clearance_model`], and where there is no such crankshaft or the planes do not rise.
pub fn largest_swept_radius(
    engine: &Engine,
    crankshaft: usize,
    faces: [f64; 2],
) -> Result<Option<SweptRoom>, EngineClearanceError> {
    Ok(clearance_model(engine)?.largest_swept_radius(crankshaft, faces)?)
}
