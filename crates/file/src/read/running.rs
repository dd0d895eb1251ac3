//! `[friction]`, `[flywheel]` and `[bearings]`.

use super::crank::details::BodyDraft;
use super::crank::details::MaybeBody;
use super::drafts::Drafts;
use super::reader::Reader;
use crate::document::{Field, Section};
use lanchester_diagnostic::Mistake;
use lanchester_model::Flywheel;
use lanchester_model::Friction;
use lanchester_model::SpeedRange;
use lanchester_model::{Bearings, PlainBearing};
use lanchester_units::Dimension;

/// Keys of Chen and Flynn's form.
const CHEN_FLYNN: [&str; 4] = ["constant", "peak_pressure", "speed", "speed_squared"];

/// Shares of the peak pressure above this are taken for a slip: Chen and Flynn's is about 0.005.
const SUSPICIOUS_SHARE: f64 = 0.05;

/// Speeds that differ by less than this share are the same: files round them.
const SAME: f64 = 1e-9;

/// Lengths by which a bearing may exceed its pin and still fit [m]: files round them.
const TOUCH: f64 = 1e-9;

impl<'a> Reader<'a> {
    /// `[friction]`: the outer `None` says bad, the inner one absent.
    pub(super) fn friction(&mut self) -> Option<Option<Friction>> {
        let (section, broken) = self.section("friction");
        let Some(section) = section else { return (!broken).then_some(None) };
        let form = CHEN_FLYNN.into_iter().find(|key| section.has(key));
        // Friction of the pistons alone is for runs in time, with gas or without.
        if section.has("piston_damping") && !section.has("fmep") && form.is_none() {
            return Some(None);
        }
        self.needs_gas("friction", "it takes from the torque of the gas");
        match (section.has("fmep"), form) {
            (true, Some(other)) => {
                self.two_sources(section, "fmep", other, "the friction");
                None
            }
            (true, None) => section.number("fmep").given().map(|fmep| Some(Friction::Given { fmep })),
            (false, None) => {
                self.missing(
                    section.span.clone(),
                    "[friction] has neither `fmep` nor `constant`".into(),
                    "add fmep = \"1.2 bar\", or constant, peak_pressure, speed and speed_squared of Chen and Flynn"
                        .into(),
                );
                None
            }
            (false, Some(_)) => {
                let constant = self.required(section, "constant", section.number("constant"));
                let peak_pressure = section.number("peak_pressure").or(0.0);
                let speed = section.number("speed").or(0.0);
                let speed_squared = section.number("speed_squared").or(0.0);
                if let Some(share) = peak_pressure.filter(|share| *share > SUSPICIOUS_SHARE) {
                    let message =
                        format!("friction takes {share} of the highest cylinder pressure: usual is 0.005");
                    self.mistakes.push(
                        Mistake::warning("W0802", section.value_span("peak_pressure"), message)
                            .hint("it is a bare share of the pressure in bar, not in percent"),
                    );
                }
                Some(Some(Friction::ChenFlynn {
                    constant: constant?,
                    peak_pressure: peak_pressure?,
                    speed: speed?,
                    speed_squared: speed_squared?,
                }))
            }
        }
    }

    /// `[flywheel]`: the outer `None` says bad, the inner one absent.
    pub(super) fn flywheel(
        &mut self,
        range: Option<SpeedRange>,
        body: &MaybeBody,
    ) -> Option<Option<Flywheel>> {
        let (section, broken) = self.section("flywheel");
        let Some(section) = section else { return (!broken).then_some(None) };
        let inertia = optional(section.number("inertia"));
        let crankshaft_inertia = optional(section.number("crankshaft_inertia"));
        if section.has("crankshaft_inertia") && matches!(body, Some(Some(_))) {
            let body = self.section("crank").0.map_or(0..0, |crank| crank.key_span("body"));
            self.mistakes.push(
                Mistake::error(
                    "E0203",
                    section.key_span("crankshaft_inertia"),
                    "`crankshaft_inertia` and [crank.body] both give the inertia of the crankshaft",
                )
                .label("second source")
                .related(body, "first source")
                .hint("leave it out: it follows from the body"),
            );
        }
        let fluctuation = match section.number("fluctuation") {
            Field::Given(spot) if spot.value > 0.0 && spot.value < 2.0 => Some(Some(spot.value)),
            Field::Given(spot) => {
                let got = lanchester_units::readable(spot.value, Dimension::Share);
                let message = format!("`fluctuation` must lie between 0 and 200 %, got {got}");
                self.mistakes.push(Mistake::error("E1303", spot.span, message).label("out of range").hint(
                    "it is the highest less the lowest speed over their mean, usually 1 % to 5 % at idle",
                ));
                None
            }
            Field::Absent => Some(None),
            Field::Bad => None,
        };
        let speeds = match section.numbers("speeds") {
            Field::Given(list) => {
                let out = |speed: &f64| {
                    range.is_some_and(|range| {
                        *speed < range.lowest * (1.0 - SAME) || *speed > range.highest * (1.0 + SAME)
                    })
                };
                for spot in list.value.iter().filter(|spot| out(&spot.value)) {
                    let shown = lanchester_units::readable(spot.value, Dimension::Speed);
                    let message = format!("the engine does not run at {shown}");
                    self.mistakes.push(
                        Mistake::error("E1304", spot.span.clone(), message)
                            .related(self.root.value_span("speed"), "its speeds")
                            .hint("give a speed within these, or let `speed` of the file reach it"),
                    );
                }
                Some(list.value.iter().map(|spot| spot.value).collect())
            }
            Field::Absent => Some(Vec::new()),
            Field::Bad => None,
        };
        Some(Some(Flywheel {
            inertia: inertia?,
            crankshaft_inertia: crankshaft_inertia?,
            fluctuation: fluctuation?,
            speeds: speeds?,
        }))
    }

    fn needs_gas(&mut self, key: &str, why: &str) {
        if !self.root.has("gas") && self.whole {
            self.unused_as_it_stands(self.root, key, why, "add [gas] with [[gas.trace]] or [gas.cycle]");
        }
    }

    /// `[bearings]`: the outer `None` says bad, the inner one absent.
    pub(super) fn bearings(&mut self, body: &MaybeBody) -> Option<Option<Bearings>> {
        let (section, broken) = self.section("bearings");
        let Some(section) = section else { return (!broken).then_some(None) };
        let has_body = matches!(body, Some(Some(_)));
        let [piston_pin, crankpin, main] =
            [("piston_pin", false), ("crankpin", has_body), ("main", has_body)]
                .map(|(key, has_body)| self.plain_bearing(section, key, has_body));
        Some(Some(Bearings { piston_pin: piston_pin?, crankpin: crankpin?, main: main? }))
    }

    fn plain_bearing(
        &mut self,
        bearings: &'a Section,
        key: &'static str,
        has_body: bool,
    ) -> Option<Option<PlainBearing>> {
        let section = match bearings.table(key) {
            Field::Given(spot) => spot.value,
            Field::Absent => return Some(None),
            Field::Bad => return None,
        };
        let diameter = if has_body {
            if section.has("diameter") {
                let body = self.section("crank").0.map_or(0..0, |crank| crank.key_span("body"));
                self.mistakes.push(
                    Mistake::error(
                        "E0203",
                        section.key_span("diameter"),
                        "`diameter` and [crank.body] both give the diameter of this bearing",
                    )
                    .label("second source")
                    .related(body, "first source")
                    .hint("leave it out: it follows from the body"),
                );
                return None;
            }
            Some(None)
        } else {
            self.required(section, "diameter", section.number("diameter")).map(Some)
        };
        let width = self.required(section, "width", section.number("width"));
        Some(Some(PlainBearing { diameter: diameter?, width: width? }))
    }

    /// A bearing is no wider than what it sits on, and a piston pin fits into its piston.
    pub(super) fn check_bearings(
        &mut self,
        bearings: &Option<Option<Bearings>>,
        body: &BodyDraft,
        drafts: &Drafts<'a>,
    ) {
        let (Some(Some(bearings)), Some(section)) = (bearings, self.section("bearings").0) else { return };
        if let (Some(crankpin), Some(Some(uniform))) = (bearings.crankpin, &body.uniform) {
            let half = |web: usize| body.details.at_web(uniform, web).web_thickness / 2.0;
            let length = drafts
                .throws
                .iter()
                .enumerate()
                .filter_map(|(index, draft)| {
                    let [front, rear] = draft.as_ref()?.throw.webs?;
                    Some(rear - front - (half(2 * index) + half(2 * index + 1)))
                })
                .fold(f64::INFINITY, f64::min);
            if crankpin.width > length + TOUCH {
                let [width, length] = [crankpin.width, length]
                    .map(|value| lanchester_units::readable(value, Dimension::Length));
                let at = section.table("crankpin").given().map_or(0..0, |table| table.value_span("width"));
                self.mistakes.push(
                    Mistake::error(
                        "E1301",
                        at,
                        format!("a bearing {width} wide does not fit on a crankpin {length} long"),
                    )
                    .hint("the crankpin is as long as the web distance less the web thickness"),
                );
            }
        }
        let bore = drafts.cylinders.iter().flatten().filter_map(|draft| draft.cylinder.bore);
        let bore = bore.fold(f64::INFINITY, f64::min);
        let Some(pin) = bearings.piston_pin else { return };
        let table = section.table("piston_pin").given();
        for (key, size) in [("diameter", pin.diameter.unwrap_or(0.0)), ("width", pin.width)] {
            if size < bore {
                continue;
            }
            let [size, bore] = [size, bore].map(|value| lanchester_units::readable(value, Dimension::Length));
            self.mistakes.push(
                Mistake::error(
                    "E1302",
                    table.map_or(0..0, |table| table.value_span(key)),
                    format!("a piston pin with a {key} of {size} does not fit into a bore of {bore}"),
                )
                .hint("check the number and its unit"),
            );
        }
    }
}

fn optional(field: Field<f64>) -> Option<Option<f64>> {
    match field {
        Field::Given(spot) => Some(Some(spot.value)),
        Field::Absent => Some(None),
        Field::Bad => None,
    }
}
