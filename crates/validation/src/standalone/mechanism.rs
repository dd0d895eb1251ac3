//! Mechanisms that are no engines, on the referee of the multibody rung: `squeezer beta at T s` and so on are the angles of Andrews' squeezer [rad].

use lanchester::multibody::referee::squeezer::squeezer_angles;

/// The squeezer's angles, as the test set names them.
const ANGLES: [&str; 5] = ["beta", "Theta", "gamma", "Phi", "delta"];

/// An angle of the squeezer.
pub(crate) struct MechanismKey {
    index: usize,
    /// When [s].
    time: f64,
}

impl MechanismKey {
    /// The quantity of this name; `None` if it is not one of these.
    pub fn parse(text: &str) -> Option<MechanismKey> {
        let (name, time) = text.strip_prefix("squeezer ")?.split_once(" at ")?;
        let index = ANGLES.iter().position(|angle| *angle == name)?;
        let time = time.strip_suffix(" s")?.parse().ok().filter(|time| *time > 0.0 && *time <= 1.0)?;
        Some(MechanismKey { index, time })
    }

    /// Its value.
    pub fn of(&self) -> Result<f64, String> {
        let angles = squeezer_angles(self.time).ok_or("the mechanism does not run to its end")?;
        Ok(angles[self.index])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read() {
        assert!(MechanismKey::parse("squeezer Theta at 0.03 s").is_some_and(|key| key.index == 1));
        for name in ["squeezer", "squeezer beta", "squeezer alpha at 1 s", "squeezer beta at -1 s"] {
            assert!(MechanismKey::parse(name).is_none(), "{name}");
        }
    }
}
