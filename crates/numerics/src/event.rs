//! Events: changes of sign of the event functions, located on the interpolant.

use crate::root::bisect;
use crate::{Settings, Step, System};

/// Places within a step at which the signs are looked at: a function that changes its sign twice between two of them is missed.
const LOOKS: [f64; 4] = [0.25, 0.5, 0.75, 1.0];

/// Share of what an event function varies within a step by which it must keep away from zero to be far from it.
const FAR: f64 = 0.2;

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

    /// Whether every event function keeps its sign at both ends of a step and three places of the cubic between them, at a distance from
    /// zero of a share of what it varies.
    pub(crate) fn are_far(
        &self,
        system: &mut impl System,
        [(from, start), (to, end)]: [(f64, &[f64]); 2],
        [first, last]: [&[f64]; 2],
        h: f64,
    ) -> bool {
        let count = system.events();
        if !self.are_known(count) {
            return false;
        }
        let mut least = vec![f64::INFINITY; count];
        let mut most = vec![f64::NEG_INFINITY; count];
        let (mut values, mut state) = (vec![0.0; count], start.to_vec());
        for x in std::iter::once(0.0).chain(LOOKS) {
            if x == 1.0 {
                state.copy_from_slice(end);
            } else {
                let y = 1.0 - x;
                let weights =
                    [y * y * (1.0 + 2.0 * x), x * x * (3.0 - 2.0 * x), h * x * y * y, -h * x * x * y];
                for (i, value) in state.iter_mut().enumerate() {
                    *value = weights[0] * start[i]
                        + weights[1] * end[i]
                        + weights[2] * first[i]
                        + weights[3] * last[i];
                }
            }
            system.event_functions(from + x * (to - from), &state, &mut values);
            for (index, value) in values.iter().enumerate() {
                let value = value * self.signs[index];
                if value.is_nan() {
                    return false;
                }
                least[index] = least[index].min(value);
                most[index] = most[index].max(value);
            }
        }
        least.iter().zip(&most).all(|(least, most)| *least > FAR * (most - least) && *least > 0.0)
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
