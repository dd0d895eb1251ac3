//! What is computed at the places of the trajectory that were kept.

use crate::powered::Powered;
use crate::reactions::{Instant, Scratch};
use crate::run::kept::{Kept, Place};
use crate::run::looking::{Looker, Seen};
use crate::run::result::Samples;
use crate::run::runner::{ANY_TIME, Runner};

impl Runner<'_> {
    /// Evaluates what was kept; `looker` sees all of it, `look` each sample as the last evaluation.
    pub(crate) fn take(
        &mut self,
        kept: &Kept,
        samples: &mut Samples,
        mut looker: Option<&mut Looker>,
        mut look: impl FnMut(&Powered<'_>, f64, &[f64]),
    ) {
        let conditions = &mut self.powered.conditions;
        let before = (conditions.window, conditions.times, conditions.delayed);
        (conditions.times, conditions.delayed) = ([0.0; 2], ANY_TIME);
        let shares = if self.powered.simulation.reactions {
            self.powered.train.main_shares(&self.powered.simulation.main_stiffness)
        } else {
            Vec::new()
        };
        samples.reserve(kept.len());
        let mut scratch = Scratch::default();
        let mut rates = vec![0.0; self.state.len()];
        for (place, time, state) in kept.iter() {
            let theta = state[0];
            self.powered.conditions.window = self.window(theta, place == Place::Behind);
            self.powered.rates(time, theta, state, &mut rates);
            let torques = self.powered.torques;
            let motion = self.powered.motion(theta, state);
            let layout = self.powered.layout;
            let mounts = if layout.moving { self.powered.mount_forces(&motion, state) } else { Vec::new() };
            let springs = self.powered.springs(&motion, state);
            let reactions = self.powered.simulation.reactions.then(|| {
                let instant = Instant {
                    motion: &motion,
                    places: &self.powered.places,
                    rates: torques.rates,
                    gas: &self.powered.forces,
                    gravity: motion.rotation().tr_mul(&self.powered.gravity()),
                    piston_damping: self.powered.simulation.piston_damping,
                    guidance: self.powered.simulation.guidance,
                };
                self.powered.train.reactions_with(&instant, &shares, &mut scratch)
            });
            if let Some(looker) = looker.as_deref_mut() {
                let seen = Seen {
                    time,
                    theta,
                    speed: state[1],
                    pose: layout.moving.then(|| (motion.position.into(), motion.orientation)),
                    mounts: &mounts,
                    springs: &springs,
                    reactions: reactions.as_ref(),
                };
                looker.look(&seen, place == Place::Behind);
            }
            if place != Place::Sample {
                continue;
            }
            samples.time.push(time);
            samples.theta.push(theta);
            samples.speed.push(state[1]);
            samples.acceleration.push(rates[1]);
            samples.gas_torque.push(torques.gas);
            samples.load_torque.push(torques.load);
            samples.starter_torque.push(torques.starter);
            samples.friction_torque.push(torques.friction);
            samples.piston_friction_torque.push(torques.piston_friction);
            samples.outside_torque.push(torques.outside);
            samples.driveline_torque.push(torques.driveline);
            if let Some(governor) = self.powered.governor_now(time, state) {
                samples.governor.push(governor.factor);
            }
            if layout.links > 0 {
                let link = |index: usize| [state[layout.link(index)], state[layout.link(index) + 1]];
                samples.driveline.push((0..layout.links).map(link).collect());
                samples.driveline_springs.push(springs);
            }
            if layout.moving {
                samples.position.push(motion.position.into());
                samples.orientation.push(motion.orientation);
                samples.velocity.push(motion.velocity.into());
                samples.spin.push(motion.spin.into());
                samples.mounts.push(mounts);
            }
            samples.reactions.extend(reactions);
            look(&self.powered, theta, state);
        }
        let conditions = &mut self.powered.conditions;
        (conditions.window, conditions.times, conditions.delayed) = before;
    }
}
