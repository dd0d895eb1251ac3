//! `[load]`, `[starter]` and `[governor]`.

use crate::document::{Field, Section};
use crate::read::reader::Reader;
use lanchester_diagnostic::Mistake;
use lanchester_model::{Governor, LoadCurve, LoadLaw, ReactsOn, RunLoad, Starter};
use std::f64::consts::TAU;

/// Keys that belong to one law of a load or another.
const LAW_KEYS: [&str; 6] = ["torque", "at", "power", "least_speed", "table", "period"];

fn reacts_on(field: Field<&'static str>, default: ReactsOn) -> Option<ReactsOn> {
    match field {
        Field::Given(spot) if spot.value == "block" => Some(ReactsOn::Block),
        Field::Given(_) => Some(ReactsOn::Ground),
        Field::Absent => Some(default),
        Field::Bad => None,
    }
}

impl<'a> Reader<'a> {
    /// `[load]`: the outer `None` says bad, the inner one absent.
    pub(in crate::read) fn load(&mut self) -> Option<Option<RunLoad>> {
        let (section, broken) = self.section("load");
        let Some(section) = section else { return (!broken).then_some(None) };
        let side = reacts_on(section.word("reacts_on"), ReactsOn::Ground);
        let word = self.required(section, "type", section.word("type"))?;
        let used: &[&str] = match word {
            "constant" => &["torque"],
            "viscous" | "quadratic" => &["torque", "at"],
            "power" => &["power", "least_speed"],
            "table" => &["table", "period"],
            _ => &[],
        };
        for key in LAW_KEYS.into_iter().filter(|key| section.has(key) && !used.contains(key)) {
            let because = format!("the load is of the type \"{word}\"");
            self.without_effect(section, key, &because, "leave it out, or change the type");
        }
        let law = match word {
            "constant" => self.required(section, "torque", section.number("torque")).map(LoadLaw::Constant),
            "viscous" | "quadratic" => {
                let torque = self.required(section, "torque", section.number("torque"));
                let at = self.required(section, "at", section.number("at"));
                torque.zip(at).map(|(torque, at)| match word {
                    "viscous" => LoadLaw::Viscous { torque, at },
                    _ => LoadLaw::Quadratic { torque, at },
                })
            }
            "power" => {
                let power = self.required(section, "power", section.number("power"));
                let least = self.required(section, "least_speed", section.number("least_speed"));
                power.zip(least).map(|(power, least_speed)| LoadLaw::Power { power, least_speed })
            }
            "table" => self.load_table(section),
            _ => Some(LoadLaw::None),
        };
        Some(Some(RunLoad { law: law?, reacts_on: side? }))
    }

    fn load_table(&mut self, section: &'a Section) -> Option<LoadLaw> {
        let tables = self.required(section, "table", section.tables("table"))?;
        let over_angle = tables.iter().any(|table| table.has("angle"));
        let is_map = tables.iter().any(|table| table.has("angle") && table.has("speed"));
        let period = section.number("period").or(TAU)?;
        if !over_angle && section.has("period") {
            self.without_effect(section, "period", "the table is over the speed", "leave it out");
        }
        if tables.is_empty() {
            self.missing(
                section.value_span("table"),
                "a table of a load has no points".into(),
                section.example("table"),
            );
            return None;
        }
        let (key, other) = if over_angle { ("angle", "speed") } else { ("speed", "angle") };
        // Of one kind one curve; over both one a speed.
        let mut curves: Vec<LoadCurve> = Vec::new();
        let mut is_good = true;
        for table in tables {
            if !is_map && table.has(other) {
                let message = format!("a point of a load's table has `{other}`, others have `{key}`");
                self.mistakes.push(
                    Mistake::error("E1803", table.key_span(other), message)
                        .hint("give all points a speed, all an angle, or all both"),
                );
                is_good = false;
                continue;
            }
            let speed = if is_map { self.required(table, "speed", table.number("speed")) } else { Some(0.0) };
            let at = self.required(table, key, table.number(key));
            let torque = self.required(table, "torque", table.number("torque"));
            let (Some(speed), Some(at), Some(torque)) = (speed, at, torque) else {
                is_good = false;
                continue;
            };
            if curves.last().is_some_and(|last| last.speed > speed) {
                self.must_rise(table, "speed", "speeds of a load");
                is_good = false;
            }
            if curves.last().is_none_or(|last| last.speed != speed) {
                curves.push(LoadCurve { speed, points: Vec::new() });
            }
            let Some(LoadCurve { points, .. }) = curves.last_mut() else { continue };
            if points.last().is_some_and(|last| last[0] >= at) {
                let within = if is_map { " at one speed" } else { "" };
                self.must_rise(table, key, &format!("{key}s of a load{within}"));
                is_good = false;
            }
            points.push([at, torque]);
            is_good &= self.check_load_point(table, over_angle.then_some(period), [at, torque]);
        }
        if !is_good {
            return None;
        }
        if is_map {
            return Some(LoadLaw::Map { period, curves });
        }
        let points = curves.into_iter().next()?.points;
        Some(if over_angle { LoadLaw::Angle { period, points } } else { LoadLaw::Table(points) })
    }

    /// Whether an angle lies within the period, and a torque over the speed alone is not negative.
    fn check_load_point(&mut self, table: &Section, period: Option<f64>, [angle, torque]: [f64; 2]) -> bool {
        match period {
            Some(period) if angle >= period => {
                let message = "an angle of a load lies beyond the period of its table";
                self.mistakes.push(
                    Mistake::error("E1803", table.value_span("angle"), message)
                        .hint("give angles from 0 to below `period`, which is 360 deg by default"),
                );
            }
            None if torque < 0.0 => {
                let message = "the torque of a load over the speed must not be negative";
                self.mistakes.push(
                    Mistake::error("E1803", table.value_span("torque"), message)
                        .hint("it acts against the rotation; a table over the angle may change its sign"),
                );
            }
            _ => return true,
        }
        false
    }

    /// `[starter]`: the outer `None` says bad, the inner one absent.
    pub(in crate::read) fn starter(&mut self) -> Option<Option<Starter>> {
        let (section, broken) = self.section("starter");
        let Some(section) = section else { return (!broken).then_some(None) };
        let [stall_torque, free_speed, ratio, until] = ["stall_torque", "free_speed", "ratio", "until"]
            .map(|key| self.required(section, key, section.number(key)));
        let side = reacts_on(section.word("reacts_on"), ReactsOn::Block);
        let starter = Starter {
            stall_torque: stall_torque?,
            free_speed: free_speed?,
            ratio: ratio?,
            until: until?,
            reacts_on: side?,
        };
        let reached = starter.free_speed / starter.ratio;
        if starter.until > reached {
            self.mistakes.push(
                Mistake::error(
                    "E1803",
                    section.value_span("until"),
                    "the starter has no torque left at the speed at which it lets go",
                )
                .hint("`until` counts at the crankshaft: it must be below free_speed / ratio"),
            );
            return None;
        }
        Some(Some(starter))
    }

    /// `[governor]`: the outer `None` says bad, the inner one absent.
    pub(in crate::read) fn governor(&mut self) -> Option<Option<Governor>> {
        let (section, broken) = self.section("governor");
        let Some(section) = section else { return (!broken).then_some(None) };
        if !self.root.has("gas") && self.whole {
            let hint = "add [gas] with [[gas.trace]] or [gas.cycle]";
            self.unused_as_it_stands(self.root, "governor", "it scales the fired part of the gas", hint);
        }
        let [speed, gain] = ["speed", "gain"].map(|key| self.required(section, key, section.number(key)));
        let [integral, delay, lag] = ["integral", "delay", "lag"].map(|key| section.number(key).or(0.0));
        let [droop, start] = ["droop", "start"].map(|key| {
            let share = section.number(key).or(0.0)?;
            let fits = if key == "droop" { share < 1.0 } else { share <= 1.0 };
            if !fits {
                let message =
                    format!("`{key}` of a governor must lie between 0 and 100 %, got {} %", 100.0 * share);
                self.mistakes.push(
                    Mistake::error("E0108", section.value_span(key), message)
                        .label("out of range")
                        .hint(section.example(key)),
                );
            }
            fits.then_some(share)
        });
        Some(Some(Governor {
            speed: speed?,
            gain: gain?,
            integral: integral?,
            droop: droop?,
            delay: delay?,
            lag: lag?,
            start: start?,
        }))
    }
}
