//! What happens between two pieces of a run: events, halts, the starter's end.

use crate::run::result::{Happened, Occasion, RunOutcome, Stall};
use crate::run::runner::Runner;
use crate::run::watch::{Mark, Watch};
use crate::simulation::{Action, When};

/// Times [s] and angles [rad] closer than this are one moment.
const SAME_MOMENT: f64 = 1e-11;

impl Runner<'_> {
    pub(super) fn note(&mut self, what: Occasion) {
        let (time, theta, speed) = (self.time, self.state[0], self.state[1]);
        if let Some(history) = &self.powered.history {
            history.borrow_mut().jump(time);
        }
        self.happened.push(Happened { what, time, theta, speed });
        // What the steps were like before says nothing of what comes.
        self.step = None;
    }

    /// Does what a watch asks for.
    pub(super) fn answer(&mut self, watch: Watch) -> Option<RunOutcome> {
        let mark = match watch {
            Watch::Grip => {
                self.release();
                return None;
            }
            Watch::Speed(_, _, mark) | Watch::Angle(_, mark) | Watch::Time(_, mark) => mark,
        };
        match mark {
            Mark::Mode | Mark::Kink => None,
            Mark::Knot => self.ended(),
            Mark::Starter => {
                self.powered.conditions.starter = false;
                self.note(Occasion::StarterOff);
                None
            }
            Mark::Halt => {
                self.halt(true);
                None
            }
            Mark::Event(index) => self.happen(Some(self.powered.simulation.events[index].when)),
        }
    }

    /// All that happens at `when`, or whose time or angle has come, in the order of the list.
    pub(super) fn happen(&mut self, when: Option<When>) -> Option<RunOutcome> {
        let simulation = self.powered.simulation;
        for (index, event) in simulation.events.iter().enumerate() {
            let has_come = match event.when {
                When::Time(time) => self.time >= time - SAME_MOMENT,
                When::Angle(angle) => self.state[0] >= simulation.start_angle + angle - SAME_MOMENT,
                When::SpeedRises(_) | When::SpeedFalls(_) => false,
            };
            if !self.pending[index] || !(has_come || when == Some(event.when)) {
                continue;
            }
            self.pending[index] = false;
            self.note(Occasion::Event { index });
            if let Some(end) = self.act(index) {
                return Some(end);
            }
            self.grip();
        }
        None
    }

    /// Lets a crank go that friction holds no longer, after what acts on it has changed at once: no change of sign tells of it.
    pub(crate) fn grip(&mut self) {
        if self.powered.conditions.held {
            let state = self.state.clone();
            self.powered.rates(self.time, state[0], &state, &mut vec![0.0; state.len()]);
            if self.powered.holding.abs() > self.powered.dry_torque() {
                self.release();
            }
        }
    }

    fn release(&mut self) {
        self.powered.conditions.held = false;
        self.note(Occasion::Released);
        self.halt(false);
    }

    /// Opens the clutch: its spring loses its twist.
    fn open_clutch(&mut self) {
        if self.powered.conditions.clutch_open {
            return;
        }
        let (theta, state) = (self.state[0], self.state.clone());
        let before = self.powered.energy(theta, &state)[3];
        self.powered.conditions.clutch_open = true;
        self.powered.conditions.clutch_work += self.powered.energy(theta, &state)[3] - before;
    }

    fn act(&mut self, index: usize) -> Option<RunOutcome> {
        let conditions = &mut self.powered.conditions;
        match self.powered.simulation.events[index].action.clone() {
            Action::Misfire(cylinder) => conditions.misfires[cylinder] = true,
            Action::Fuel(share) => conditions.fired.fill(share),
            Action::Load(law) => conditions.load = law,
            Action::ClutchOpen => {
                self.open_clutch();
                return None;
            }
            Action::Stop => return Some(RunOutcome::Stopped),
        }
        let failed = conditions.fired.iter_mut().zip(&conditions.misfires).filter(|(_, misfires)| **misfires);
        failed.for_each(|(fired, _)| *fired = 0.0);
        None
    }

    /// Keeps the farthest place from which the starter cannot turn the crank on; `left`: what all torques but dry ones give.
    fn note_stall(&mut self, left: f64) {
        let Some(starter) = self.powered.simulation.starter.filter(|_| self.powered.conditions.starter)
        else {
            return;
        };
        let (theta, held_by) = (self.state[0], self.powered.dry_torque());
        let is_farthest = self.stall.is_none_or(|stall| theta > stall.theta);
        if left > held_by || !is_farthest {
            return;
        }
        let torque = self.powered.torques.starter;
        self.stall = Some(Stall {
            time: self.time,
            theta,
            starter: torque,
            others: left - torque,
            held_by,
            missing: held_by - left,
            ratio: starter.ratio,
        });
    }

    /// The crank stands: friction holds it, or it goes on in the sense that the other torques give it.
    pub(super) fn halt(&mut self, noted: bool) {
        self.state[1] = 0.0;
        let theta = self.state[0];
        self.powered.conditions.window = self.window(theta, self.powered.conditions.sense > 0.0);
        self.powered.conditions.held = true;
        let state = self.state.clone();
        let mut rates = vec![0.0; state.len()];
        self.powered.rates(self.time, theta, &state, &mut rates);
        let left = -self.powered.holding;
        self.note_stall(left);
        if left.abs() <= self.powered.dry_torque() {
            self.note(Occasion::Held);
            return;
        }
        self.powered.conditions.held = false;
        self.powered.conditions.sense = left.signum();
        if noted {
            self.note(Occasion::Reversed);
        }
    }
}
