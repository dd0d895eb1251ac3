//! Events: changes of sign of the event functions, located on the interpolant.

use crate::root::bisect;
use crate::{Settings, Step, System};

/// Places within a step at which the signs are looked at: a function that changes its sign twice between two of them is missed.
const LOOKS: [f64; 4] = [0.25, 0.5, 0.75, 1.0];

/// Signs of the event functions, kept over restarts; zero where still unknown.
#[derive(Debug, Clone, Default)]
pub(crate) struct Sides {
    signs: Vec<f64>,
}

/// An event within a step.
pub(crate) struct Crossing {
    pub(crate) index: usize,
    pub(crate) rising: bool,
    pub(crate) place: f64,
}

impl Sides {
    /// Forgets what is known, as after a state that was set from outside.
    pub(crate) fn forget(&mut self) {
        self.signs.clear();
    }

    /// Whether the sign of every event function is known.
    pub(crate) fn are_known(&self, count: usize) -> bool {
        self.signs.len() == count && !self.signs.contains(&0.0)
    }

    /// The first event within the step; its sign is turned over. Without one, unknown signs are learned.
    pub(crate) fn first_crossing(
        &mut self,
        system: &mut impl System,
        step: &Step,
        settings: &Settings,
    ) -> Option<Crossing> {
        let count = system.events();
        if count == 0 {
            return None;
        }
        self.signs.resize(count, 0.0);
        let mut values = vec![0.0; count];
        let mut state = step.start.to_vec();
        if self.signs.contains(&0.0) {
            system.event_functions(step.from, &state, &mut values);
            for (sign, value) in self.signs.iter_mut().zip(&values) {
                if *sign == 0.0 && *value != 0.0 && value.is_finite() {
                    *sign = value.signum();
                }
            }
        }
        let mut before = step.from;
        for look in LOOKS {
            let after = if look == 1.0 { step.to } else { step.from + look * (step.to - step.from) };
            step.at(after, &mut state);
            system.event_functions(after, &state, &mut values);
            let mut first: Option<Crossing> = None;
            for index in 0..count {
                if self.signs[index] == 0.0 && values[index] != 0.0 && values[index].is_finite() {
                    self.signs[index] = values[index].signum();
                }
                if values[index] * self.signs[index] < 0.0 {
                    let place = locate(system, step, settings, index, (before, after), self.signs[index]);
                    let sense = (step.to - step.from).signum();
                    if first.as_ref().is_none_or(|f| sense * place < sense * f.place) {
                        first = Some(Crossing { index, rising: self.signs[index] < 0.0, place });
                    }
                }
            }
            if let Some(crossing) = first {
                self.signs[crossing.index] *= -1.0;
                return Some(crossing);
            }
            before = after;
        }
        None
    }
}

/// The place just behind the change of sign of one event function.
fn locate(
    system: &mut impl System,
    step: &Step,
    settings: &Settings,
    index: usize,
    (before, after): (f64, f64),
    sign: f64,
) -> f64 {
    let mut state = step.start.to_vec();
    let mut values = vec![0.0; system.events()];
    let mut value = |t: f64| {
        step.at(t, &mut state);
        system.event_functions(t, &state, &mut values);
        values[index]
    };
    let (at_before, at_after) = (value(before), value(after));
    bisect(value, before, after, at_before, at_after, sign < 0.0, settings.event_tolerance).after
}
