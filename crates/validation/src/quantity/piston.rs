//! Where the piston of cylinder 1 is.
//!
//! | quantity | what it is |
//! |---|---|
//! | `piston travel at N deg` | from its top dead centre, at a whole crank angle [m] |
//! | `piston height at N deg` | of its pin above the lowest point of the crankpin's circle [m] |

use crate::case::Run;

/// A quantity of the piston's motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PistonKey {
    /// Whether it counts from top dead centre.
    is_travel: bool,
    degrees: u16,
}

impl PistonKey {
    /// The quantity of this name; `None` if it is not one of these.
    pub fn parse(text: &str) -> Option<PistonKey> {
        let (what, degrees) = text.strip_prefix("piston ")?.split_once(" at ")?;
        let is_travel = match what {
            "travel" => true,
            "height" => false,
            _ => return None,
        };
        let degrees = degrees.strip_suffix(" deg")?.parse().ok().filter(|degrees| *degrees < 360)?;
        Some(PistonKey { is_travel, degrees })
    }

    /// Its value.
    pub fn of(self, run: &Run) -> Result<f64, String> {
        let motion = run.loads.motion.first().ok_or("the engine has no cylinder")?;
        let angle = f64::from(self.degrees).to_radians();
        let at = motion.trace.theta.iter().position(|theta| (theta - angle).abs() < 1e-9);
        let place = motion.trace.position[at.ok_or("the motion has no such angle")?];
        let radius = run.engine.throws.first().map_or(0.0, |throw| throw.radius);
        Ok(if self.is_travel { motion.top - place } else { place + radius })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read() {
        assert_eq!(
            PistonKey::parse("piston travel at 90 deg"),
            Some(PistonKey { is_travel: true, degrees: 90 })
        );
        assert!(PistonKey::parse("piston height at 0 deg").is_some_and(|key| !key.is_travel));
        for name in ["piston travel", "piston speed at 90 deg", "piston travel at 400 deg"] {
            assert!(PistonKey::parse(name).is_none(), "{name}");
        }
    }
}
