//! All that is told of an engine on its mounts, from its loads by order.

use crate::mounts::error::MountError;
use crate::mounts::excitation::Excitation;
use crate::mounts::result::{MOUNT_RESULT_VERSION, MountStudy, PointMotion, Transmissibility};
use crate::mounts::rotor_effects::RotorEffects;
use crate::mounts::system::MountSystem;
use lanchester_model::Engine;

/// Frequencies of the transmissibility, and how far below and above the natural ones they reach.
const FREQUENCIES: usize = 241;
const BELOW: f64 = 0.2;
const ABOVE: f64 = 8.0;

/// What to tell.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MountRequest {
    /// Points of the block whose motion is told [m].
    pub points: Vec<[f64; 3]>,
    /// What the excitation is, in words.
    pub excitation: String,
    /// What the user should know of it.
    pub warnings: Vec<String>,
    /// Angular momentum of the rotors over the speed of crankshaft 1 [kg m^2] in place of that of the file.
    pub rotors: Option<f64>,
    /// What of them acts.
    pub effects: RotorEffects,
}

/// The block of `engine` on its mounts: at rest, its natural motions, and shaken by `excitations`.
///
/// # Errors
/// As [`MountSystem::new`] and [`MountSystem::response`].
pub fn mount_study(
    engine: &Engine,
    excitations: &[Excitation],
    request: &MountRequest,
) -> Result<MountStudy, MountError> {
    if let Some(&bad) = request.points.iter().flatten().find(|c| !c.is_finite()) {
        return Err(MountError::Number { quantity: "point [m]".to_owned(), needed: "finite", got: bad });
    }
    let mut system = MountSystem::new(engine)?.with_effects(request.effects);
    if let Some(rotors) = request.rotors {
        system = system.with_rotors(rotors);
    }
    let response = system.response(excitations)?;
    let modes = system.modes()?;
    let motion = |&point: &[f64; 3]| PointMotion {
        point,
        displacement: response
            .speeds
            .iter()
            .map(|s| s.orders.iter().map(|o| o.motion_at(response.centre, point)).collect())
            .collect(),
    };
    let natural = modes.modes.iter().map(|m| m.angular_frequency);
    let (lowest, highest) = natural.fold((f64::INFINITY, 0.0f64), |(low, high), w| (low.min(w), high.max(w)));
    let (from, to) = (BELOW * lowest, ABOVE * highest);
    let step = (to / from).powf(1.0 / (FREQUENCIES - 1) as f64);
    let angular_frequency: Vec<f64> = (0..FREQUENCIES).map(|k| from * step.powi(k as i32)).collect();
    Ok(MountStudy {
        version: MOUNT_RESULT_VERSION,
        engine: engine.name.clone(),
        excitation: request.excitation.clone(),
        warnings: request.warnings.clone(),
        body: system.body().clone(),
        rotors: system.rotors(),
        rotor_effects: request.effects,
        at_rest: system.at_rest(),
        points: request.points.iter().map(motion).collect(),
        transmissibility: Transmissibility {
            ratio: system.transmissibility(&angular_frequency)?,
            angular_frequency,
        },
        modes,
        response,
    })
}
