//! What changes on the way: governor, misfires, fuel, load, clutch, stop.
//!
//! ```text
//! p = p_motored + c (p - p_motored)     c = u fuel fires_k     u: governor's, fuel: of all cylinders, fires_k: of one
//! e = w_0 (1 - droop u) - w             u_c = gain e + sum     lag u' = u_c (from 0 to 1) - u     sum' = gain integral e h
//! ```
//! The expansion of the motored pressure mirrors its compression. With the gas as states `c` is a factor on the heat release. `h` falls from 1 to 0
//! over a hundredth beyond the end of `u_c` towards which `e` drives. Factors that events change are states without a rate, which the events set; an
//! event that could come again has a state that says whether it still waits.

use super::Builder;
use super::changing::Changing;
use super::request::load_at;
use super::words::{number, quantity};
use crate::curve::Curve;
use lanchester_model::{Action, Governor, When};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Beyond its ends the wanted factor of a governor fades its integral out over this much.
const FADES: f64 = 0.01;

/// Share of the duration behind which a stop at the start ends a run.
const AT_ONCE: f64 = 1e-9;

impl Builder<'_> {
    /// Governor and events as states and signals, before what they act on.
    pub(crate) fn changes(&mut self) {
        if let Some(governor) = self.request.governor.filter(|_| self.has_gas()) {
            self.governor(&governor);
        }
        let events = self.request.events.clone();
        let mut starts: BTreeMap<String, (f64, &'static str)> = BTreeMap::new();
        let sets: Vec<Vec<(String, f64)>> = events.iter().map(|event| self.settings(&event.action)).collect();
        for (name, _) in sets.iter().flatten() {
            let (start, unit) = if name == "load_torque" { (0.0, "N m") } else { (1.0, "") };
            starts.insert(name.clone(), (start, unit));
        }
        for (event, set) in events.iter().zip(&sets) {
            if matches!(event.when, When::Time(at) | When::Angle(at) if at <= 0.0) {
                for (name, value) in set {
                    starts.entry(name.clone()).and_modify(|start| start.0 = *value);
                }
            }
        }
        for (name, (start, unit)) in &starts {
            let rate = if *unit == "N m" { "0 W" } else { "0 rad/s" };
            self.integral(name, rate, &amount(*start, unit));
        }
        for (index, (event, set)) in events.iter().zip(&sets).enumerate() {
            let stops = event.action == Action::Stop;
            if set.is_empty() && !stops {
                continue;
            }
            let (when, again) = match event.when {
                When::Time(at) if at <= 0.0 && stops => {
                    (format!("t - {}", quantity(AT_ONCE * self.request.duration, "s")), false)
                }
                When::Time(at) | When::Angle(at) if at <= 0.0 => continue,
                When::Time(at) => (format!("t - {}", quantity(at, "s")), false),
                When::Angle(at) => {
                    (format!("theta - {}", quantity(self.request.start_angle + at, "rad")), true)
                }
                When::SpeedRises(speed) => (format!("crank.flow - {}", quantity(speed, "rad/s")), true),
                When::SpeedFalls(speed) => (format!("{} - crank.flow", quantity(speed, "rad/s")), true),
            };
            let waits = format!("event{}_waits", index + 1);
            let mut new: Vec<(String, String)> = (set.iter())
                .map(|(name, value)| {
                    let value = amount(*value, starts[name].1);
                    let value = if again { format!("{waits}*{value} + (1 - {waits})*{name}") } else { value };
                    (name.clone(), value)
                })
                .collect();
            if again && !new.is_empty() {
                self.integral(&waits, "0 rad/s", "1");
                new.push((waits, "0".into()));
            }
            let new: Vec<(&str, &str)> = new.iter().map(|(a, b)| (a.as_str(), b.as_str())).collect();
            let graph = std::mem::take(&mut self.graph);
            self.graph = if stops { graph.stop(&when) } else { graph.event(&when, &new) };
        }
        self.changing = Changing::of(starts.into_keys());
        for index in 0..self.engine.cylinders.len() {
            let factors = self.factors(index);
            if !factors.is_empty() && self.has_gas() {
                self.signal(&format!("fired{}", index + 1), &factors.join("*"));
            }
        }
    }

    /// Whether gas acts.
    fn has_gas(&self) -> bool {
        self.request.gas_states.is_some() || !self.request.pressures.is_empty()
    }

    /// What an action sets, by name.
    fn settings(&self, action: &Action) -> Vec<(String, f64)> {
        match action {
            Action::Misfire(cylinder) if self.has_gas() => vec![(format!("fires{}", cylinder + 1), 0.0)],
            Action::Fuel(share) if self.has_gas() => vec![("fuel".into(), *share)],
            Action::Load(law) => {
                // Only constants and none can be written; of any other law it is the torque at the start speed.
                let torque = load_at(law, self.request.speed, 0.0);
                vec![("load_share".into(), 0.0), ("load_torque".into(), torque)]
            }
            Action::ClutchOpen if !self.request.driveline.is_empty() => vec![("clutch_closed".into(), 0.0)],
            Action::Misfire(_) | Action::Fuel(_) | Action::ClutchOpen | Action::Stop => Vec::new(),
        }
    }

    /// Factors on the fired part of the gas of a cylinder.
    fn factors(&self, index: usize) -> Vec<String> {
        let own = format!("fires{}", index + 1);
        let mut factors = Vec::new();
        if self.request.governor.is_some() {
            factors.push("governor".to_owned());
        }
        factors.extend(["fuel".to_owned(), own].into_iter().filter(|name| self.changing.has(name)));
        factors
    }

    /// The signal by which the fired part of the gas of a cylinder is multiplied, where something changes it.
    pub(crate) fn fired(&self, index: usize) -> Option<String> {
        (!self.factors(index).is_empty()).then(|| format!("fired{}", index + 1))
    }

    fn governor(&mut self, governor: &Governor) {
        let (gain, speed) = (quantity(governor.gain, "s/rad"), quantity(governor.speed, "rad/s"));
        let droop = number(governor.droop);
        let error = format!("{speed}*(1 - {droop}*governor) - crank.flow");
        if governor.lag == 0.0 {
            // At once: u = c(u), which falls with u.
            let at_none = format!("{gain}*({speed} - crank.flow) + governor_sum");
            self.signal("governor", &format!("min(max(({at_none})/(1 + {gain}*{speed}*{droop}), 0), 1)"));
        }
        self.signal("governor_error", &error);
        self.signal("governor_wanted", &format!("{gain}*governor_error + governor_sum"));
        if governor.lag > 0.0 {
            let rate =
                format!("(min(max(governor_wanted, 0), 1) - governor)/{}", quantity(governor.lag, "s"));
            self.integral("governor", &rate, &quantity(governor.start, "rad"));
        }
        let fades = number(FADES);
        let share = |beyond: &str| format!("min(max(1 - ({beyond})/{fades}, 0), 1)");
        let rate = format!(
            "{gain}*{}*governor_error*if(governor_error > 0 rad/s, {}, {})",
            quantity(governor.integral, "1/s"),
            share("governor_wanted - 1"),
            share("-governor_wanted")
        );
        self.integral("governor_sum", &rate, &quantity(governor.start, "rad"));
    }
}

fn amount(value: f64, unit: &str) -> String {
    if unit.is_empty() { number(value) } else { quantity(value, unit) }
}

/// The pressure without combustion: from firing to half a turn behind it what it was as far before.
pub(crate) fn motored(fired: &Curve) -> Option<Curve> {
    let (pieces, end) = fired.pieces();
    let first = pieces.first()?.0;
    let cycle = end - first;
    let ends = pieces.iter().skip(1).map(|piece| piece.0).chain([end]);
    // Pieces of one cycle from 0 on, cut at 0, half a turn and as far before the end.
    let cuts = [0.0, PI, cycle - PI, cycle];
    let mut whole: Vec<(f64, f64, [f64; 4])> = Vec::new();
    for ((start, coefficients), stop) in pieces.iter().zip(ends) {
        for turn in [-1.0, 0.0, 1.0] {
            let (from, to) = (start + turn * cycle, stop + turn * cycle);
            let inner = cuts.into_iter().filter(|cut| *cut > from && *cut < to);
            let places: Vec<f64> = [from].into_iter().chain(inner).chain([to]).collect();
            for pair in places.windows(2) {
                if pair[0] >= 0.0 && pair[1] <= cycle {
                    whole.push((pair[0], pair[1], moved(coefficients, pair[0] - from)));
                }
            }
        }
    }
    let mut found: Vec<(f64, [f64; 4])> = Vec::new();
    for (from, to, coefficients) in whole {
        if from >= PI {
            found.push((from, coefficients));
        }
        if from >= cycle - PI {
            let [a, b, c, d] = moved(&coefficients, to - from);
            found.push((cycle - to, [a, -b, c, -d]));
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    // Rounding may leave two pieces of one place.
    found.dedup_by(|a, b| (a.0 - b.0).abs() < 1e-12);
    Curve::cubics(&found, cycle, true, fired.units())
}

/// Coefficients of a cubic about a place further on.
fn moved([a, b, c, d]: &[f64; 4], by: f64) -> [f64; 4] {
    [a + by * (b + by * (c + by * d)), b + by * (2.0 * c + 3.0 * by * d), c + 3.0 * by * d, *d]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::unit::Unit;
    use std::f64::consts::TAU;

    #[test]
    fn the_motored_expansion_mirrors_the_compression() {
        let value = |x: f64| 2.0 + (0.5 * x).cos() + 0.3 * x.sin() + 0.2 * (1.5 * x).cos();
        let slope = |x: f64| -0.5 * (0.5 * x).sin() + 0.3 * x.cos() - 0.3 * (1.5 * x).sin();
        let (count, begin) = (97, -0.7);
        let h = 2.0 * TAU / f64::from(count);
        let pieces: Vec<(f64, [f64; 4])> = (0..count)
            .map(|k| {
                let x = begin + h * f64::from(k);
                let rise = (value(x + h) - value(x)) / h;
                let (b, last) = (slope(x), slope(x + h));
                let bends = [(3.0 * rise - 2.0 * b - last) / h, (b + last - 2.0 * rise) / (h * h)];
                (x, [value(x), b, bends[0], bends[1]])
            })
            .collect();
        let curve = Curve::cubics(&pieces, begin + 2.0 * TAU, true, [Unit::NONE; 2]).expect("it rises");
        let found = motored(&curve).expect("it has pieces");
        for k in 0..1000 {
            let x = 2.0 * TAU * (f64::from(k) + 0.5) / 1000.0;
            let want = if x < PI { curve.at(-x, 0) } else { curve.at(x, 0) };
            assert!((found.at(x, 0) - want).abs() < 1e-12, "{x}");
        }
    }
}
