//! What a governor with a dead time wanted before: the method of steps.
//!
//! Each accepted step leaves the command at nine places as a polynomial of the time, exact to the order of the steps' own interpolant. Where the command or one of its derivatives
//! jumps (the start, events), the jump comes back after each dead time, weaker every time: steps end there.

use std::collections::VecDeque;

/// Places within a step, those of Chebyshev and Lobatto from 0 to 1.
const PLACES: usize = 9;

/// How often a jump comes back strongly enough to count.
const RETURNS: u32 = 4;

/// Times closer than this are one [s].
const SAME: f64 = 1e-11;

/// How far beside a jump its side is taken [s].
const BESIDE: f64 = 1e-12;

/// How far the polynomial of the last step is followed beyond it, as a share of its length.
const BEYOND: f64 = 0.25;

/// The command of a governor, before it is held within 0 and 1, over past times.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct History {
    /// Before the start.
    start: f64,
    delay: f64,
    steps: VecDeque<Past>,
    jumps: Vec<f64>,
}

#[derive(Debug, Clone, PartialEq)]
struct Past {
    from: f64,
    to: f64,
    times: [f64; PLACES],
    /// Barycentric weights of the times.
    weights: [f64; PLACES],
    commands: [f64; PLACES],
}

impl Past {
    fn at(&self, t: f64) -> f64 {
        let (mut above, mut below) = (0.0, 0.0);
        for k in 0..PLACES {
            let apart = t - self.times[k];
            if apart == 0.0 {
                return self.commands[k];
            }
            let weight = self.weights[k] / apart;
            above += weight * self.commands[k];
            below += weight;
        }
        above / below
    }
}

impl History {
    /// Of a governor that commands `start` before the start, with the dead time `delay` [s].
    pub fn new(start: f64, delay: f64) -> History {
        History { start, delay, steps: VecDeque::new(), jumps: vec![0.0] }
    }

    /// Where within a step, as shares of its length, the command is asked for.
    pub fn places() -> [f64; PLACES] {
        std::array::from_fn(|k| 0.5 * (1.0 - (std::f64::consts::PI * k as f64 / (PLACES - 1) as f64).cos()))
    }

    /// A step with its times [s], which rise, and the commands at them; one without length is passed over.
    pub fn push(&mut self, times: [f64; PLACES], commands: [f64; PLACES]) {
        let (from, to) = (times[0], times[PLACES - 1]);
        if times.windows(2).any(|pair| pair[1] <= pair[0]) {
            return;
        }
        let weight = |k: usize| {
            let others = times.iter().enumerate().filter(|(j, _)| *j != k);
            others.map(|(_, other)| (to - from) / (times[k] - other)).product::<f64>()
        };
        let weights = std::array::from_fn(weight);
        self.steps.push_back(Past { from, to, times, weights, commands });
    }

    /// Command one dead time before `t` [s], on the side of `window` of any jump.
    pub fn before(&self, t: f64, window: [f64; 2]) -> f64 {
        let t = (t - self.delay).max(window[0] + BESIDE).min(window[1] - BESIDE);
        if self.steps.front().is_none_or(|first| t < first.from) {
            return self.start;
        }
        let index = self.steps.partition_point(|step| step.to < t);
        let step = self.steps.get(index).or(self.steps.back());
        step.map_or(self.start, |step| step.at(t.min(step.to + BEYOND * (step.to - step.from))))
    }

    /// Something happens at `t` [s].
    pub fn jump(&mut self, t: f64) {
        self.jumps.push(t);
    }

    /// Neighbouring jumps of the command about one dead time before `t` [s].
    pub fn window(&self, t: f64) -> [f64; 2] {
        let past = t - self.delay;
        let all =
            self.jumps.iter().flat_map(|jump| (0..=RETURNS).map(move |k| jump + f64::from(k) * self.delay));
        all.fold([f64::NEG_INFINITY, f64::INFINITY], |[low, high], jump| {
            if jump <= past + SAME { [low.max(jump), high] } else { [low, high.min(jump)] }
        })
    }

    /// The same, seen from a clock that starts `time` [s] later.
    pub fn earlier_by(&self, time: f64) -> History {
        let step = |step: &Past| Past {
            from: step.from - time,
            to: step.to - time,
            times: step.times.map(|t| t - time),
            ..step.clone()
        };
        let jumps = self.jumps.iter().map(|jump| jump - time).collect();
        History { steps: self.steps.iter().map(step).collect(), jumps, ..*self }
    }

    /// Forgets what no time from `t` [s] on asks for.
    pub fn forget_before(&mut self, t: f64) {
        while self.steps.len() > 1 && self.steps.front().is_some_and(|first| first.to < t - 2.0 * self.delay)
        {
            self.steps.pop_front();
        }
        let (delay, last) = (self.delay, f64::from(RETURNS + 2));
        self.jumps.retain(|jump| jump + last * delay > t);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A smooth command comes back to rounding a dead time later, and a jump on the side that is asked for.
    #[test]
    fn what_was_commanded_comes_back() {
        let mut history = History::new(0.3, 0.2);
        let command = |t: f64| (3.0 * t).sin();
        for k in 0..10 {
            let times = History::places().map(|x| 0.05 * (f64::from(k) + x));
            history.push(times, times.map(command));
        }
        for t in [0.2 + 1e-9, 0.25, 0.333, 0.61] {
            let window = history.window(t);
            assert!((history.before(t, window) - command(t - 0.2)).abs() < 1e-12, "{t}");
        }
        assert_eq!(history.window(0.1), [f64::NEG_INFINITY, 0.0]);
        assert_eq!(history.before(0.1, history.window(0.1)), 0.3);
        // At the jump itself, from before and from after.
        assert_eq!(history.before(0.2, [f64::NEG_INFINITY, 0.0]), 0.3);
        assert!(history.before(0.2, [0.0, 0.2]).abs() < 1e-11);
    }
}
