//! `[gas]`: traces or a cycle, and the crankcase.

mod burning;
mod cycle;
mod opening;
mod walls;

use super::drafts::Drafts;
use super::reader::Reader;
use crate::document::{Field, Section};
use lanchester_diagnostic::Mistake;
use lanchester_model::Strokes;
use lanchester_model::{ATMOSPHERE, CrankcasePressure, Gas, GasSource, PressureTrace};
use lanchester_units::Dimension;

/// `[gas]`: the outer `None` says bad, the inner one absent.
pub(super) type MaybeGas = Option<Option<Gas>>;

impl<'a> Reader<'a> {
    pub(super) fn gas(&mut self, strokes: Option<Strokes>) -> MaybeGas {
        let (section, broken) = self.section("gas");
        let Some(section) = section else { return (!broken).then_some(None) };
        let ambient_pressure = section.number("ambient_pressure").or(ATMOSPHERE);
        let compression_ratio = self.compression_ratio(section);
        let crankcase = self.crankcase(section, ambient_pressure);
        let source = match (section.has("trace"), section.has("cycle")) {
            (true, true) => {
                self.two_sources(section, "trace", "cycle", "the pressure in the cylinders");
                None
            }
            (false, false) => {
                self.missing(
                    section.span.clone(),
                    "[gas] has neither `trace` nor `cycle`".into(),
                    "add [[gas.trace]] with file = \"pressure.csv\", or [gas.cycle] with type = \"otto\""
                        .into(),
                );
                None
            }
            (true, false) => self
                .traces(section)
                .zip(compression_ratio)
                .map(|(traces, compression_ratio)| GasSource::Traces { traces, compression_ratio }),
            (false, true) => {
                self.gas_cycle(section, strokes, compression_ratio, ambient_pressure).map(GasSource::Cycle)
            }
        };
        Some(Some(Gas { ambient_pressure: ambient_pressure?, source: source?, crankcase: crankcase? }))
    }

    fn compression_ratio(&mut self, section: &Section) -> Option<Option<f64>> {
        match section.number("compression_ratio") {
            Field::Absent => Some(None),
            Field::Bad => None,
            Field::Given(spot) if spot.value > 1.0 => Some(Some(spot.value)),
            Field::Given(spot) => {
                let message = format!("`compression_ratio` must be more than 1, got {}", spot.value);
                self.mistakes.push(
                    Mistake::error("E1201", spot.span, message)
                        .label("out of range")
                        .hint("it is the largest volume of a cylinder over the smallest, such as 10.5"),
                );
                None
            }
        }
    }

    fn traces(&mut self, section: &'a Section) -> Option<Vec<PressureTrace>> {
        let sections = section.tables("trace").given()?;
        if sections.is_empty() {
            self.missing(
                section.key_span("trace"),
                "`trace` is an empty list".into(),
                "add [[gas.trace]] with file = \"pressure.csv\"".into(),
            );
            return None;
        }
        let traces: Vec<Option<PressureTrace>> =
            sections.iter().map(|section| self.trace(section, sections.len() > 1)).collect();
        for (index, trace) in traces.iter().enumerate() {
            let Some(PressureTrace { speed: Some(speed), .. }) = trace else { continue };
            let same =
                |other: &Option<PressureTrace>| other.as_ref().is_some_and(|t| t.speed == Some(*speed));
            if let Some(first) = traces[..index].iter().position(same) {
                let shown = lanchester_units::readable(*speed, Dimension::Speed);
                self.mistakes.push(
                    Mistake::error(
                        "E1206",
                        sections[index].value_span("speed"),
                        format!("two traces were measured at {shown}"),
                    )
                    .related(sections[first].value_span("speed"), "the other")
                    .hint("keep one of them, or average them"),
                );
            }
        }
        traces.into_iter().collect()
    }

    fn trace(&mut self, section: &'a Section, is_one_of_many: bool) -> Option<PressureTrace> {
        let speed = match section.number("speed") {
            Field::Given(spot) => Some(Some(spot.value)),
            Field::Bad => None,
            Field::Absent if is_one_of_many => {
                self.missing(
                    section.span.clone(),
                    "several traces need the speed of each".into(),
                    section.example("speed"),
                );
                None
            }
            Field::Absent => Some(None),
        };
        self.trace_file(section, speed)
    }

    fn trace_file(&mut self, section: &'a Section, speed: Option<Option<f64>>) -> Option<PressureTrace> {
        let file = self.required(section, "file", section.text("file"));
        let gauge = section.word("pressures").or("absolute").map(|word| word == "gauge");
        let top_dead_centre = section.number("top_dead_centre").or(0.0);
        let counted_from_first =
            section.word("counted_from").or("own firing").map(|word| word == "cylinder 1");
        Some(PressureTrace {
            file: file?,
            speed: speed?,
            gauge: gauge?,
            top_dead_centre: top_dead_centre?,
            counted_from_first: counted_from_first?,
        })
    }

    fn crankcase(&mut self, gas: &'a Section, ambient: Option<f64>) -> Option<CrankcasePressure> {
        let section = match gas.table("crankcase") {
            Field::Absent => return ambient.map(|pressure| CrankcasePressure::Constant { pressure }),
            Field::Bad => return None,
            Field::Given(spot) => spot.value,
        };
        match (section.has("pressure"), section.has("file")) {
            (true, true) => {
                self.two_sources(section, "pressure", "file", "the pressure under the pistons");
                None
            }
            (false, true) => self.trace_file(section, Some(None)).map(CrankcasePressure::Trace),
            _ => self
                .required(section, "pressure", section.number("pressure"))
                .map(|pressure| CrankcasePressure::Constant { pressure }),
        }
    }

    /// Gas acts on a bore, and where there are several cylinders it must be known when each fires.
    pub(super) fn check_gas(&mut self, drafts: &Drafts<'a>) {
        let Some(section) = self.section("gas").0 else { return };
        let mut cylinders = drafts.cylinders.iter().enumerate();
        let bare = cylinders.find(|(_, draft)| draft.as_ref().is_some_and(|d| d.cylinder.bore.is_none()));
        if let Some((index, _)) = bare {
            self.missing(
                section.span.clone(),
                format!("[gas] needs the bore of cylinder {}", index + 1),
                "add bore = \"79.5 mm\" to [piston] or to the cylinder".into(),
            );
        }
        if drafts.cylinders.len() > 1 && !self.root.has("firing") {
            self.missing(
                section.span.clone(),
                "[gas] needs [firing]: when does each cylinder fire?".into(),
                "add [firing] with order = [1, 3, 4, 2]".into(),
            );
        }
    }
}
