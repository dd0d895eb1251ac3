//! Runs in time of the crank train as rigid bodies, as the engine's file describes them.
//!
//! | quantity | what it is |
//! |---|---|
//! | `run angle at T s` | crank angle of the run at a time, from its start [rad] |
//! | `run speed at T s` | speed of the run at a time [rad/s] |

use crate::case::Run;
use crate::gas_run::traces;
use lanchester::multibody::RunOutcome;
use lanchester::{RunLength, SimulateRequest, simulate};

/// A quantity of a run in time.
pub(crate) struct RunKey {
    /// Whether it is the speed, not the angle.
    speed: bool,
    /// When [s].
    time: f64,
}

impl RunKey {
    /// The quantity of this name; `None` if it is not one of these.
    pub fn parse(text: &str) -> Option<RunKey> {
        let (what, time) = text.strip_prefix("run ")?.split_once(" at ")?;
        let time = time.strip_suffix(" s")?.parse().ok().filter(|time| *time > 0.0)?;
        match what {
            "angle" => Some(RunKey { speed: false, time }),
            "speed" => Some(RunKey { speed: true, time }),
            _ => None,
        }
    }

    /// Its value.
    pub fn of(&self, run: &Run) -> Result<f64, String> {
        // Whole revolutions are far apart at low speed: only the end is asked for.
        let request = SimulateRequest {
            length: Some(RunLength::Time(self.time)),
            step: Some(std::f64::consts::TAU),
            ..SimulateRequest::default()
        };
        let found = simulate(&run.file, &traces(), &request).map_err(|error| error.to_string())?;
        let [time, theta, speed] = found.run.end;
        if found.run.outcome != RunOutcome::Complete || (time - self.time).abs() > 1e-9 {
            return Err(format!("the run ends after {time} s"));
        }
        let start = found.run.samples.theta.first().copied().unwrap_or(0.0);
        Ok(if self.speed { speed } else { theta - start })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read() {
        assert!(RunKey::parse("run angle at 0.25 s").is_some_and(|key| !key.speed && key.time == 0.25));
        assert!(RunKey::parse("run speed at 5 s").is_some_and(|key| key.speed));
        for name in ["run", "run speed", "run power at 1 s", "run speed at 1", "run speed at -1 s"] {
            assert!(RunKey::parse(name).is_none(), "{name}");
        }
    }
}
