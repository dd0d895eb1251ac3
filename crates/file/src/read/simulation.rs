//! `[simulation]` and all that a run in time takes from the file.

pub(crate) mod event;
pub(in crate::read) mod extras;
pub(in crate::read) mod parts;
pub(crate) mod start;

use super::reader::Reader;
use crate::document::{Field, Section};
use lanchester_diagnostic::Mistake;
use lanchester_model::{
    BlockKind, DrivelineInertia, ImposedAgainst, MainSharing, RodGuidance, RunLength, SimulationInput,
    SpeedKind, StartOfBlock, TorqueFile, TorqueOrder,
};
use lanchester_task::option;
use lanchester_units::{Bound, Dimension, within};

/// Standard acceleration of gravity [m/s^2] (CGPM 1901).
const STANDARD_GRAVITY: f64 = 9.806_65;

/// Tolerances of a step that are accepted.
const TOLERANCES: [f64; 2] = [1e-13, 1e-2];

/// The value of a key that may be absent; `None` if it is bad.
pub(super) fn optional<T>(field: Field<T>) -> Option<Option<T>> {
    match field {
        Field::Given(spot) => Some(Some(spot.value)),
        Field::Absent => Some(None),
        Field::Bad => None,
    }
}

impl<'a> Reader<'a> {
    /// What the file says of a run: the outer `None` says bad, the inner one that it says nothing.
    pub(super) fn simulation(&mut self, cylinders: Option<usize>) -> Option<Option<SimulationInput>> {
        let (section, broken) = self.section("simulation");
        let own = match section {
            Some(section) => self.simulation_keys(section, cylinders),
            None => (!broken).then(SimulationInput::default),
        };
        let load = self.load();
        let starter = self.starter();
        let governor = self.governor();
        let driveline = self.driveline();
        let piston_damping = match self.section("friction") {
            (Some(friction), _) => optional(friction.number("piston_damping")),
            (None, _) => Some(None),
        };
        let mut input = own?;
        input.load = load?;
        input.starter = starter?;
        input.governor = governor?;
        input.driveline = driveline?;
        input.piston_damping = piston_damping?;
        let is_empty = section.is_none() && input == SimulationInput::default();
        Some((!is_empty).then_some(input))
    }

    fn simulation_keys(&mut self, section: &'a Section, cylinders: Option<usize>) -> Option<SimulationInput> {
        let speed = optional(section.word("speed")).map(|word| {
            word.map(|word| if word == "imposed" { SpeedKind::Imposed } else { SpeedKind::Free })
        });
        let against = optional(section.word("imposed_against")).map(|word| {
            word.map(|word| if word == "ground" { ImposedAgainst::Ground } else { ImposedAgainst::Block })
        });
        let imposed = self.imposed(section);
        if !matches!(speed, Some(Some(SpeedKind::Imposed)) | None) {
            for key in ["imposed_against", "imposed"].into_iter().filter(|key| section.has(key)) {
                let hint = "ask for an imposed speed, or write speed = \"imposed\"";
                self.unused_as_it_stands(section, key, "the speed is free", hint);
            }
        }
        let start = match section.table("start") {
            Field::Given(spot) => Some(spot.value),
            _ => None,
        };
        let start_bad = section.table("start").is_bad();
        let of_start = |key: &str| start.map_or(Some(None), |start| optional(start.number(key)));
        let (start_speed, start_angle) = (of_start("speed"), of_start("angle"));
        let start_block = start.map_or(Some(None), |start| optional(start.word("block"))).map(|word| {
            word.map(
                |word| {
                    if word == "as drawn" { StartOfBlock::AsDrawn } else { StartOfBlock::Equilibrium }
                },
            )
        });
        if let (Some(start), true) = (start.filter(|start| start.has("speed")), section.has("imposed")) {
            self.without_effect(start, "speed", "`imposed` gives the speed at every time", "leave it out");
        }
        let duration = self.text_of(section, "duration", duration);
        let gravity = self.text_of(section, "gravity", gravity);
        let block = optional(section.word("block"))
            .map(|word| word.map(|w| if w == "mounts" { BlockKind::Mounts } else { BlockKind::Fixed }));
        let gas = optional(section.word("gas"));
        let step = optional(section.number("step"));
        let tolerance = self.step_tolerance(section);
        let tolerances = self.state_tolerances(section);
        let crank_as_body = optional(section.word("crankshaft")).map(|word| word.map(|word| word == "body"));
        let points = self.named_points(section);
        let meshes = self.meshes(section);
        let guidance = optional(section.word("guidance")).map(|word| {
            word.map(|word| if word == "piston" { RodGuidance::Piston } else { RodGuidance::Crankpin })
        });
        let mains = optional(section.word("mains")).map(|word| {
            word.map(|word| match word {
                "springs" => MainSharing::Springs,
                "beam" => MainSharing::Beam,
                _ => MainSharing::Cut,
            })
        });
        let main_stiffness = match section.numbers("main_stiffness") {
            Field::Given(list) => Some(list.value.iter().map(|spot| spot.value).collect()),
            Field::Absent => Some(Vec::new()),
            Field::Bad => None,
        };
        let torque = self.torques(section);
        let events = self.events(section, cylinders);
        if start_bad {
            return None;
        }
        let (torque, torque_files) = torque?;
        Some(SimulationInput {
            speed: speed?,
            imposed_against: against?,
            imposed: imposed?,
            start_speed: start_speed?,
            start_angle: start_angle?,
            start_block: start_block?,
            duration: duration?,
            block: block?,
            gravity: gravity?,
            gas: gas?.map(|word| word != "off"),
            gas_states: gas? == Some("states"),
            step: step?,
            tolerance: tolerance?,
            tolerances: tolerances?,
            crank_as_body: crank_as_body?,
            points: points?,
            meshes: meshes?,
            guidance: guidance?,
            mains: mains?,
            main_stiffness: main_stiffness?,
            torque,
            torque_files,
            events: events?,
            ..SimulationInput::default()
        })
    }

    /// A key whose text `parse` understands, or a message with its hint.
    fn text_of<T>(
        &mut self,
        section: &Section,
        key: &str,
        parse: impl Fn(&str) -> Result<T, (String, String)>,
    ) -> Option<Option<T>> {
        let text = match section.text(key) {
            Field::Given(spot) => spot,
            Field::Absent => return Some(None),
            Field::Bad => return None,
        };
        match parse(text.value.trim()) {
            Ok(value) => Some(Some(value)),
            Err((message, hint)) => {
                self.mistakes.push(Mistake::error("E1801", text.span, message).hint(hint));
                None
            }
        }
    }

    fn step_tolerance(&mut self, section: &Section) -> Option<Option<f64>> {
        let tolerance = optional(section.number("tolerance"))?;
        let [least, most] = TOLERANCES;
        match tolerance.filter(|tolerance| !(least..=most).contains(tolerance)) {
            None => Some(tolerance),
            Some(got) => {
                let message = format!("`tolerance` must lie between 1e-13 and 1e-2, got {got}");
                self.mistakes.push(
                    Mistake::error("E0108", section.value_span("tolerance"), message)
                        .label("out of range")
                        .hint("for example tolerance = 1e-9"),
                );
                None
            }
        }
    }

    fn imposed(&mut self, section: &'a Section) -> Option<Vec<[f64; 2]>> {
        let tables = section.tables("imposed").or(&[])?;
        let mut points: Vec<[f64; 2]> = Vec::new();
        let mut is_good = true;
        for table in tables {
            let at = self.required(table, "at", table.number("at"));
            let speed = self.required(table, "speed", table.number("speed"));
            let (Some(at), Some(speed)) = (at, speed) else {
                is_good = false;
                continue;
            };
            if points.last().is_some_and(|last| last[0] >= at) {
                self.must_rise(table, "at", "times of an imposed speed");
                is_good = false;
            }
            points.push([at, speed]);
        }
        is_good.then_some(points)
    }

    /// The entries of a list do not rise.
    pub(super) fn must_rise(&mut self, table: &Section, key: &str, what: &str) {
        let message = format!("the {what} must rise");
        self.mistakes.push(
            Mistake::error("E1803", table.value_span(key), message)
                .label("not above the one before")
                .hint("sort the entries, and give each value once"),
        );
    }

    fn torques(&mut self, section: &'a Section) -> Option<(Vec<TorqueOrder>, Vec<TorqueFile>)> {
        let tables = section.tables("torque").or(&[])?;
        let (mut orders, mut files) = (Vec::new(), Vec::new());
        let mut is_good = true;
        for table in tables {
            if table.has("file") {
                for key in ["order", "sin", "cos"].into_iter().filter(|key| table.has(key)) {
                    let why = "`file` gives the torque over the whole period";
                    self.without_effect(table, key, why, "give the order a table of its own");
                }
                let (file, period) = (table.text("file"), optional(table.number("period")));
                match (self.required(table, "file", file), period) {
                    (Some(file), Some(period)) => files.push(TorqueFile { file, period, curve: None }),
                    _ => is_good = false,
                }
                continue;
            }
            if table.has("period") {
                self.without_effect(table, "period", "an order has its own", "leave it out");
            }
            let order = self.required(table, "order", table.number("order"));
            let (sin, cos) = (table.number("sin").or(0.0), table.number("cos").or(0.0));
            if !table.has("sin") && !table.has("cos") {
                let message = "an order of the torque has neither `sin` nor `cos`".to_string();
                self.missing(table.span.clone(), message, table.example("cos"));
                is_good = false;
            }
            match (order, sin, cos) {
                (Some(order), Some(sin), Some(cos)) => orders.push(TorqueOrder { order, sin, cos }),
                _ => is_good = false,
            }
        }
        is_good.then_some((orders, files))
    }

    fn driveline(&mut self) -> Option<Vec<DrivelineInertia>> {
        let tables = self.root.tables("driveline").or(&[])?;
        let links: Vec<Option<DrivelineInertia>> = tables.iter().map(|table| self.link(table)).collect();
        links.into_iter().collect()
    }

    fn link(&mut self, table: &'a Section) -> Option<DrivelineInertia> {
        let inertia = self.required(table, "inertia", table.number("inertia"));
        let stiffness = self.required(table, "stiffness", table.number("stiffness"));
        let damping = table.number("damping").or(0.0);
        let ratio = table.number("ratio").or(1.0);
        if ratio == Some(0.0) {
            self.mistakes.push(
                Mistake::error("E0110", table.value_span("ratio"), "`ratio` is 0")
                    .hint("give the speed of this inertia over that of what is before it"),
            );
            return None;
        }
        Some(DrivelineInertia { inertia: inertia?, stiffness: stiffness?, damping: damping?, ratio: ratio? })
    }
}

/// `10 revolutions`, `2 s` or `periodic`.
fn duration(text: &str) -> Result<RunLength, (String, String)> {
    let refused = || {
        (
            format!(
                "`duration` needs a number of revolutions or a time above 0, or \"periodic\", got \"{text}\""
            ),
            "write it like \"10 revolutions\" or \"2 s\"".to_string(),
        )
    };
    if text == "periodic" {
        return Ok(RunLength::Periodic);
    }
    match revolutions(text) {
        Some(turns) => (turns > 0.0).then_some(RunLength::Revolutions(turns)).ok_or_else(refused),
        None => option::time(text, "duration").map(RunLength::Time).map_err(|_| refused()),
    }
}

/// `3 revolutions` as 3.
pub(super) fn revolutions(text: &str) -> Option<f64> {
    let number = text.strip_suffix("revolutions").or_else(|| text.strip_suffix("revolution"))?;
    number.trim().parse::<f64>().ok().filter(|turns| turns.is_finite() && *turns <= lanchester_units::LARGEST)
}

/// `on`, `off` or an acceleration.
fn gravity(text: &str) -> Result<f64, (String, String)> {
    match text {
        "on" => Ok(STANDARD_GRAVITY),
        "off" => Ok(0.0),
        _ => lanchester_units::parse(text, Dimension::Acceleration, "gravity")
            .and_then(|value| {
                within(value, Dimension::Acceleration, Bound::NotNegative, "gravity", text, None)
            })
            .map_err(|_| {
                (
                    format!(
                        "`gravity` needs \"on\", \"off\" or an acceleration of 0 or more, got \"{text}\""
                    ),
                    "its direction is `gravity` of [block]".to_string(),
                )
            }),
    }
}
