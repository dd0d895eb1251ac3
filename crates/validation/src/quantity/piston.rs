//! Where the piston of cylinder 1 is, and how it is accelerated in the crank train of the flexible crankshaft.
//!
//! | quantity | what it is |
//! |---|---|
//! | `piston travel at N deg` | from its top dead centre, at a whole crank angle [m] |
//! | `piston height at N deg` | of its pin above the lowest point of the crankpin's circle [m] |
//! | `piston acceleration in the flexible train` | largest, by the rod of that train on the circle of its pin [m/s²] |
//! | `piston force in the flexible train` | that times the oscillating mass [N] |

use crate::case::Run;
use lanchester::flex::train::Slider;
use lanchester::model::Engine;

/// Half of a central formula of order 8 for the second derivative: weight of the middle, then of both neighbours.
const SECOND: [f64; 5] = [-205.0 / 72.0, 8.0 / 5.0, -1.0 / 5.0, 8.0 / 315.0, -1.0 / 560.0];
/// Its step [rad]: what it leaves out and what rounding adds are both below 1e-12 of the acceleration.
const STEP: f64 = 0.02;
/// Angles of a revolution among which the largest acceleration is taken; dead centres are among them.
const ANGLES: usize = 3600;

/// A quantity of the piston's motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum PistonKey {
    /// From top dead centre, or above the lowest point of the pin's circle.
    Place { is_travel: bool, degrees: u16 },
    /// In the flexible train: acceleration, or the force of the oscillating mass.
    Train { is_force: bool },
}

impl PistonKey {
    /// The quantity of this name; `None` if it is not one of these.
    pub fn parse(text: &str) -> Option<PistonKey> {
        let text = text.strip_prefix("piston ")?;
        if let Some(what) = text.strip_suffix(" in the flexible train") {
            return match what {
                "acceleration" => Some(PistonKey::Train { is_force: false }),
                "force" => Some(PistonKey::Train { is_force: true }),
                _ => None,
            };
        }
        let (what, degrees) = text.split_once(" at ")?;
        let is_travel = match what {
            "travel" => true,
            "height" => false,
            _ => return None,
        };
        let degrees = degrees.strip_suffix(" deg")?.parse().ok().filter(|degrees| *degrees < 360)?;
        Some(PistonKey::Place { is_travel, degrees })
    }

    /// Its value.
    pub fn of(self, run: &Run) -> Result<f64, String> {
        match self {
            PistonKey::Place { is_travel, degrees } => place(run, is_travel, degrees),
            PistonKey::Train { is_force } => {
                let cylinder = run.engine.cylinders.first().ok_or("the engine has no cylinder")?;
                let mass = if is_force { cylinder.reciprocating_mass() } else { 1.0 };
                Ok(mass * train_acceleration(&run.engine)?)
            }
        }
    }
}

fn place(run: &Run, is_travel: bool, degrees: u16) -> Result<f64, String> {
    let motion = run.loads.motion.first().ok_or("the engine has no cylinder")?;
    let angle = f64::from(degrees).to_radians();
    let at = motion.trace.theta.iter().position(|theta| (theta - angle).abs() < 1e-9);
    let place = motion.trace.position[at.ok_or("the motion has no such angle")?];
    let radius = run.engine.throws.first().map_or(0.0, |throw| throw.radius);
    Ok(if is_travel { motion.top - place } else { place + radius })
}

/// Largest acceleration of piston 1 with a pin that turns on its circle at the engine's highest speed [m/s²].
fn train_acceleration(engine: &Engine) -> Result<f64, String> {
    let cylinder = engine.cylinders.first().ok_or("the engine has no cylinder")?;
    let throw = engine.throws.get(cylinder.throw).ok_or("the cylinder has no throw")?;
    let rod = &cylinder.rod;
    let slider = Slider {
        angle: cylinder.angle,
        offset: cylinder.net_offset(),
        length: rod.length,
        piston: cylinder.piston_mass,
        rod: rod.mass(),
        centre: rod.length * rod.small_end_mass / rod.mass(),
        inertia: rod.inertia.unwrap_or(0.0),
    };
    let travel = |theta: f64| {
        let (sin, cos) = (theta + throw.angle).sin_cos();
        slider.travel([throw.radius * cos, throw.radius * sin])
    };
    let second = |theta: f64| {
        let pair = |(k, weight): (usize, &f64)| {
            let away = k as f64 * STEP;
            weight * if k == 0 { travel(theta) } else { travel(theta + away) + travel(theta - away) }
        };
        SECOND.iter().enumerate().map(pair).sum::<f64>() / (STEP * STEP)
    };
    let angle = |k: usize| std::f64::consts::TAU * k as f64 / ANGLES as f64;
    let largest = (0..ANGLES).map(|k| second(angle(k)).abs()).fold(0.0, f64::max);
    Ok(largest * engine.speed.highest * engine.speed.highest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::Bench;
    use crate::quantity::Key;
    use crate::source::{Edit, ExactName, KinematicsName};

    #[test]
    fn names_are_read() {
        assert_eq!(
            PistonKey::parse("piston travel at 90 deg"),
            Some(PistonKey::Place { is_travel: true, degrees: 90 })
        );
        assert_eq!(
            PistonKey::parse("piston height at 0 deg"),
            Some(PistonKey::Place { is_travel: false, degrees: 0 })
        );
        assert_eq!(
            PistonKey::parse("piston force in the flexible train"),
            Some(PistonKey::Train { is_force: true })
        );
        for name in [
            "piston travel",
            "piston speed at 90 deg",
            "piston travel at 400 deg",
            "piston mass in the flexible train",
        ] {
            assert!(PistonKey::parse(name).is_none(), "{name}");
        }
    }

    #[test]
    fn the_flexible_train_moves_its_piston_as_the_closed_form_does() {
        let sources = crate::files::sources();
        let source = sources.iter().find(|source| source.key == "flexible-paper").expect("it is there");
        let edits = [Edit::Named("single".into())];
        let run = Bench::default()
            .run(source, &edits, KinematicsName::Named(ExactName::Exact), None)
            .expect("an engine");
        let number = |key: &str| Key::parse(key).expect("a key").number_of(&run).expect("a number");
        for (train, closed) in [
            ("piston acceleration in the flexible train", "piston acceleration"),
            ("piston force in the flexible train", "Fx max"),
        ] {
            let (train, closed) = (number(train), number(closed));
            assert!((train / closed - 1.0).abs() < 1e-9, "{train} and {closed}");
        }
    }
}
