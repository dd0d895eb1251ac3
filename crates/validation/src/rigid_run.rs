//! Runs in time of the crank train as rigid bodies, as the engine's file describes them.
//!
//! | quantity | what it is |
//! |---|---|
//! | `run angle at T s` | crank angle of the run at a time, from its start [rad] |
//! | `run speed at T s` | speed of the run at a time [rad/s] |
//!
//! [`RigidQuantity`] is what the atlas draws of such a run over the crank angle.

use crate::case::Run;
use crate::gas_run::traces;
use lanchester::multibody::{Reactions, RunOutcome};
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

/// Revolutions over which the motion of a piston is shown, as the flexible paper does.
const SHOWN: usize = 3;
/// Samples of a revolution.
const EACH: usize = 360;

/// What a run at imposed speed in a block that stands, without weight, says of cylinder 1 over the crank angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum RigidQuantity {
    /// Position of the piston pin, its speed, its acceleration: 0, 1, 2.
    Travel(usize),
    /// Force of the rod on the crankpin: towards the crank axis, else in the sense of rotation.
    RodForce { radial: bool },
}

impl RigidQuantity {
    /// Its values from angle 0 on, the end excluded, and over how many revolutions: of forces, over a cycle of the gas.
    pub fn of(self, run: &Run) -> Result<(usize, Vec<f64>), String> {
        let revolutions = match self {
            RigidQuantity::Travel(_) => SHOWN,
            RigidQuantity::RodForce { .. } => {
                (run.with_gas()?.bearings.period / std::f64::consts::TAU).round().max(1.0) as usize
            }
        };
        let request = SimulateRequest {
            speed: Some(run.loads.speed),
            length: Some(RunLength::Revolutions(revolutions as f64)),
            imposed: Some(true),
            on_mounts: Some(false),
            gravity: Some(false),
            step: Some(std::f64::consts::TAU / EACH as f64),
            ..SimulateRequest::default()
        };
        let found = simulate(&run.file, &traces(), &request).map_err(|error| error.to_string())?;
        let reactions = &found.run.samples.reactions;
        let count = revolutions * EACH;
        if found.run.outcome != RunOutcome::Complete || reactions.len() < count {
            return Err(format!("the run has {} samples of {count}", reactions.len()));
        }
        let first = |reactions: &Reactions| {
            let own = reactions.cylinders.first()?;
            Some(match self {
                RigidQuantity::Travel(rate) => own.travel[rate],
                RigidQuantity::RodForce { radial: true } => -own.throw_frame[0],
                RigidQuantity::RodForce { radial: false } => own.throw_frame[1],
            })
        };
        let values: Option<Vec<f64>> = reactions.iter().take(count).map(first).collect();
        Ok((revolutions, values.ok_or("the engine has no cylinder")?))
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
