//! The governor: what it wants, and what of it reaches the gas.
//!
//! ```text
//! e = w_0 (1 - droop u) - w      c = gain (e + integral INTEGRAL of e dt)      u_c = c within 0 and 1
//! lag u' = u_c(t - delay) - u    without lag: u = u_c(t - delay)
//! ```

use super::history::History;
use super::{Layout, Powered};
use crate::simulation::Governor;

/// Beyond its ends the command of a governor fades its integral out over this much.
const FADES: f64 = 0.01;

/// The command of `governor`, before it is held within 0 and 1, where the gas has the factor `u`; `sum`: the part that the integral gives.
fn command(governor: &Governor, u: f64, speed: f64, sum: f64) -> f64 {
    governor.gain * (governor.speed * (1.0 - governor.droop * u) - speed) + sum
}

/// What the governor of a state does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct GovernorNow {
    /// Factor on the fired part of the gas.
    pub factor: f64,
    /// Command, before it is held within 0 and 1.
    pub command: f64,
    /// Rate of the factor, where the actuator lags [1/s].
    pub rate: f64,
    /// Rate of the integral's part [1/s].
    pub sum_rate: f64,
}

/// Of a state at time `t`; `delayed`: jumps between which the command a dead time before lies.
pub(crate) fn governor_now(
    governor: &Governor,
    layout: Layout,
    history: Option<&History>,
    delayed: [f64; 2],
    (t, state): (f64, &[f64]),
) -> GovernorNow {
    let (at, speed) = (layout.governor(), state[1]);
    let sum = state[at];
    let reaches = history.map(|history| history.before(t, delayed).clamp(0.0, 1.0));
    let factor = match (layout.lagged, reaches) {
        (true, _) => state[at + 1].clamp(0.0, 1.0),
        (false, Some(reaches)) => reaches,
        // At once: u = c(u), which falls with u.
        (false, None) => {
            let at_none = command(governor, 0.0, speed, sum);
            (at_none / (1.0 + governor.gain * governor.speed * governor.droop)).clamp(0.0, 1.0)
        }
    };
    let command = command(governor, factor, speed, sum);
    let rate = match layout.lagged {
        true => (reaches.unwrap_or(command.clamp(0.0, 1.0)) - state[at + 1]) / governor.lag,
        false => 0.0,
    };
    // Beyond its end the command fades the integral out: a sharp end would switch to and fro.
    let error = governor.speed * (1.0 - governor.droop * factor) - speed;
    let beyond = if error > 0.0 { command - 1.0 } else { -command };
    let share = (1.0 - beyond / FADES).clamp(0.0, 1.0);
    let sum_rate = governor.gain * governor.integral * error * share;
    GovernorNow { factor, command, rate, sum_rate }
}

impl Powered<'_> {
    /// What the governor of a state does at time `t`; `None` without one.
    pub fn governor_now(&self, t: f64, state: &[f64]) -> Option<GovernorNow> {
        let governor = self.simulation.governor.as_ref().filter(|_| self.layout.governed)?;
        let history = self.history.as_ref().map(|history| history.borrow());
        Some(governor_now(governor, self.layout, history.as_deref(), self.conditions.delayed, (t, state)))
    }
}
