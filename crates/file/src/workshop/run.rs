//! Measured runs of a sheet.

use crate::document::{Field, Section, Span};
use crate::read::Reader;
use lanchester_diagnostic::Mistake;
use lanchester_task::workshop::{Action, PlacedWeight, Plane, Reading, Run, Sensor, VibrationQuantity};

/// What a sensor measured first, and where that stands.
type Measured = Vec<Option<(VibrationQuantity, Span)>>;

impl<'a> Reader<'a> {
    pub(super) fn runs(&mut self, planes: Option<&[Plane]>, sensors: Option<&[Sensor]>) -> Option<Vec<Run>> {
        let sections = self.root.tables("run").or(&[])?;
        if !sections.is_empty() {
            self.check_conventions(&sections[0]);
        }
        let mut measured: Measured = vec![None; sensors.map_or(0, <[Sensor]>::len)];
        let runs: Vec<Option<Run>> = sections
            .iter()
            .enumerate()
            .map(|(index, section)| self.run(index, section, planes, sensors, &mut measured))
            .collect();
        runs.into_iter().collect()
    }

    /// Senses and phases must be stated: a wrong guess would double the vibration instead of removing it.
    fn check_conventions(&mut self, run: &'a Section) {
        let (rotor, broken) = self.section("rotor");
        if broken {
            return;
        }
        let missing: Vec<&str> = ["marks", "rotation", "phase"]
            .into_iter()
            .filter(|key| rotor.is_none_or(|rotor| !rotor.has(key)))
            .collect();
        if !missing.is_empty() {
            let names: Vec<String> = missing.iter().map(|key| format!("`{key}`")).collect();
            let examples: Vec<String> = missing
                .iter()
                .map(|key| match *key {
                    "phase" => "phase = \"lag\"".to_string(),
                    key => format!("{key} = \"clockwise\""),
                })
                .collect();
            let verb = if names.len() == 1 { "is" } else { "are" };
            self.missing(
                rotor.map_or(run.span.clone(), |rotor| rotor.span.clone()),
                format!("runs are measured, but {} of [rotor] {verb} missing", names.join(" and ")),
                format!("state them, for example {}", examples.join(", ")),
            );
        }
    }

    fn run(
        &mut self,
        index: usize,
        section: &'a Section,
        planes: Option<&[Plane]>,
        sensors: Option<&[Sensor]>,
        measured: &mut Measured,
    ) -> Option<Run> {
        let name = section.text("name").or(format!("run {}", index + 1));
        let speed = self.required(section, "speed", section.number("speed"));
        let readings = self.required(section, "readings", section.tables("readings"));
        if readings.is_some_and(<[Section]>::is_empty) {
            let span = section.value_span("readings");
            let message = "a run without readings tells nothing";
            self.mistakes.push(Mistake::error("E0206", span, message).hint(section.example("readings")));
        }
        let mut seen: Vec<(usize, Span)> = Vec::new();
        let readings: Option<Vec<Option<Reading>>> = readings.map(|readings| {
            readings.iter().map(|reading| self.reading(reading, sensors, measured, &mut seen)).collect()
        });
        let weights = section.tables("weights").or(&[]).map(|weights| {
            weights.iter().map(|weight| self.placed_weight_of_run(weight, planes)).collect::<Vec<_>>()
        });
        Some(Run {
            name: name?,
            speed: speed?,
            readings: readings?.into_iter().collect::<Option<_>>()?,
            weights: weights?.into_iter().collect::<Option<_>>()?,
        })
    }

    fn reading(
        &mut self,
        section: &'a Section,
        sensors: Option<&[Sensor]>,
        measured: &mut Measured,
        seen: &mut Vec<(usize, Span)>,
    ) -> Option<Reading> {
        let sensor = section.text("sensor");
        let span = section.value_span("sensor");
        let vibration = self.vibration(section);
        let phase = self.required(section, "phase", section.number("phase"));
        let names: Option<Vec<String>> =
            sensors.map(|sensors| sensors.iter().map(|sensor| sensor.name.clone()).collect());
        let sensor = match sensor {
            Field::Given(name) => self.named(&name, &names?, "sensor")?,
            other => {
                self.required(section, "sensor", other);
                return None;
            }
        };
        if let Some((_, first)) = seen.iter().find(|(other, _)| *other == sensor) {
            let message = "a run has two readings of one sensor";
            let mistake = Mistake::error("E1104", span.clone(), message)
                .label("second reading")
                .related(first.clone(), "first reading")
                .hint("keep one of the two, or give the repeated measurement a run of its own");
            self.mistakes.push(mistake);
            return None;
        }
        seen.push((sensor, span.clone()));
        let vibration = vibration?;
        match &measured[sensor] {
            Some((quantity, first)) if *quantity != vibration.quantity => {
                let message = "one sensor is read in two quantities";
                self.mistakes.push(
                    Mistake::error("E1105", span, message)
                        .related(first.clone(), "read otherwise here")
                        .hint("read it in the same quantity in all runs, or name it as two sensors"),
                );
                return None;
            }
            _ => measured[sensor] = Some((vibration.quantity, span)),
        }
        Some(Reading { sensor, vibration, phase: phase? })
    }

    fn placed_weight_of_run(
        &mut self,
        section: &'a Section,
        planes: Option<&[Plane]>,
    ) -> Option<PlacedWeight> {
        let angle = self.required(section, "angle", section.number("angle"));
        let action = section.word("action").or("added");
        let kept = self.required(section, "kept", section.flag("kept"));
        let plane = match (section.text("plane"), planes) {
            (Field::Given(name), Some(planes)) => {
                let names: Vec<String> = planes.iter().map(|plane| plane.name.clone()).collect();
                self.named(&name, &names, "plane")
            }
            (Field::Given(_) | Field::Bad, _) => None,
            (absent, _) => self.required(section, "plane", absent).and(None),
        };
        let radius = plane.zip(planes).and_then(|(plane, planes)| planes[plane].radius);
        let unbalance = if section.has("mass") && !section.has("radius") && !section.has("unbalance") {
            let mass = section.number("mass").given();
            if plane.is_some() && radius.is_none() {
                self.missing(
                    section.span.clone(),
                    "the radius of the weight is missing".into(),
                    "add radius = \"60 mm\" to the weight or to its plane".into(),
                );
            }
            mass.zip(radius).map(|(mass, radius)| mass * radius)
        } else {
            self.weight_unbalance(section)
        };
        Some(PlacedWeight {
            plane: plane?,
            unbalance: unbalance?,
            angle: angle?,
            action: if action? == "removed" { Action::Remove } else { Action::Add },
            kept: kept?,
        })
    }
}
