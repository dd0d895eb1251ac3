//! `[gas.cycle]` with `[gas.intake]`, `[gas.exhaust]` and `[gas.walls]`.

use crate::document::{Field, Section};
use crate::read::reader::Reader;
use lanchester_diagnostic::Mistake;
use lanchester_model::Strokes;
use lanchester_model::{GasCycle, GasProcess, HeatSplit, IdealHeat, Reservoir, SingleZone, Walls};

/// Specific gas constant of dry air [J/(kg K)]: 8.314462618 J/(mol K) over 28.9647 g/mol.
const AIR: f64 = 287.05;
/// Temperatures where the file gives none [K].
const INTAKE_TEMPERATURE: f64 = 298.15;
const EXHAUST_TEMPERATURE: f64 = 800.0;
const WALL_TEMPERATURE: f64 = 450.0;

impl<'a> Reader<'a> {
    /// A table of `[gas]`: the outer `None` says bad, the inner one absent.
    pub(super) fn gas_table(gas: &'a Section, key: &str) -> Option<Option<&'a Section>> {
        match gas.table(key) {
            Field::Given(spot) => Some(Some(spot.value)),
            Field::Absent => Some(None),
            Field::Bad => None,
        }
    }

    pub(super) fn gas_cycle(
        &mut self,
        gas: &'a Section,
        strokes: Option<Strokes>,
        compression_ratio: Option<Option<f64>>,
        ambient: Option<f64>,
    ) -> Option<GasCycle> {
        let section = gas.table("cycle").given()?;
        if compression_ratio == Some(None) {
            self.missing(
                section.span.clone(),
                "[gas.cycle] needs the compression ratio".into(),
                format!("{} in [gas]", gas.example("compression_ratio")),
            );
        }
        let kind = self.required(section, "type", section.word("type"));
        let usual_ratio = if kind == Some("single-zone") { 1.32 } else { 1.4 };
        let heat_capacity_ratio = section.number("heat_capacity_ratio").or(usual_ratio);
        if let Some(ratio) = heat_capacity_ratio
            && ratio <= 1.0
        {
            let message = format!("`heat_capacity_ratio` must be more than 1, got {ratio}");
            self.mistakes.push(
                Mistake::error("E1202", section.value_span("heat_capacity_ratio"), message)
                    .label("out of range")
                    .hint("it is 1.4 for air and some 1.3 for burned gas"),
            );
        }
        let gas_constant = section.number("gas_constant").or(AIR);
        let (intake, exhaust) = match kind {
            Some("sealed") => {
                let closed = Self::state(section, ambient, INTAKE_TEMPERATURE);
                (closed, closed)
            }
            _ => (
                Self::reservoir(gas, "intake", ambient, INTAKE_TEMPERATURE),
                Self::reservoir_if(gas, ambient, kind == Some("single-zone")),
            ),
        };
        let process = kind.and_then(|kind| self.process(kind, gas, section, strokes));
        Some(GasCycle {
            compression_ratio: compression_ratio??,
            heat_capacity_ratio: heat_capacity_ratio?,
            gas_constant: gas_constant?,
            intake: intake?,
            exhaust: exhaust?,
            process: process?,
        })
    }

    fn reservoir(gas: &'a Section, key: &str, ambient: Option<f64>, temperature: f64) -> Option<Reservoir> {
        let Some(section) = Self::gas_table(gas, key)? else {
            return Some(Reservoir { pressure: ambient?, temperature });
        };
        Self::state(section, ambient, temperature)
    }

    fn state(section: &Section, ambient: Option<f64>, temperature: f64) -> Option<Reservoir> {
        let pressure = section.number("pressure").or(ambient.unwrap_or_default());
        let temperature = section.number("temperature").or(temperature);
        Some(Reservoir { pressure: pressure.filter(|_| ambient.is_some())?, temperature: temperature? })
    }

    /// The exhaust: ideal cycles have no use for its temperature.
    fn reservoir_if(gas: &'a Section, ambient: Option<f64>, has_backflow: bool) -> Option<Reservoir> {
        if has_backflow {
            return Self::reservoir(gas, "exhaust", ambient, EXHAUST_TEMPERATURE);
        }
        let pressure = match Self::gas_table(gas, "exhaust")? {
            Some(section) => section.number("pressure").or(ambient?)?,
            None => ambient?,
        };
        Some(Reservoir { pressure, temperature: EXHAUST_TEMPERATURE })
    }

    fn process(
        &mut self,
        kind: &str,
        gas: &'a Section,
        section: &'a Section,
        strokes: Option<Strokes>,
    ) -> Option<GasProcess> {
        let peak = section.has("peak_pressure");
        match kind {
            "otto" => {
                if peak && gas.has("fuel") {
                    self.two_sources_apart(
                        [gas, section],
                        ["fuel", "peak_pressure"],
                        "how much heat there is",
                    );
                    return None;
                }
                if peak {
                    let pressure = section.number("peak_pressure").given()?;
                    return Some(GasProcess::Otto { heat: IdealHeat::PeakPressure { pressure } });
                }
                let fuel = self.fuel(gas, "or peak_pressure = \"70 bar\" to [gas.cycle]")?;
                Some(GasProcess::Otto { heat: IdealHeat::Fuel(fuel) })
            }
            "diesel" => Some(GasProcess::Diesel { fuel: self.fuel(gas, "")? }),
            "seiliger" => {
                let fuel = self.fuel(gas, "");
                let split = self.heat_split(section);
                Some(GasProcess::Seiliger { fuel: fuel?, split: split? })
            }
            "sealed" => Some(GasProcess::Sealed),
            _ => self.single_zone(gas, strokes?).map(Box::new).map(GasProcess::SingleZone),
        }
    }

    fn heat_split(&mut self, section: &'a Section) -> Option<HeatSplit> {
        match (section.has("peak_pressure"), section.has("constant_volume_share")) {
            (true, true) => {
                self.two_sources(
                    section,
                    "peak_pressure",
                    "constant_volume_share",
                    "how the heat is divided",
                );
                None
            }
            (false, true) => {
                let spot = match section.number("constant_volume_share") {
                    Field::Given(spot) => spot,
                    _ => return None,
                };
                if spot.value > 1.0 {
                    let message = format!(
                        "`constant_volume_share` must be at most 100 %, got {} %",
                        100.0 * spot.value
                    );
                    self.mistakes
                        .push(Mistake::error("E1205", spot.span, message).label("out of range").hint(
                        "it is the share of the heat that is released at constant volume, such as \"50 %\"",
                    ));
                    return None;
                }
                Some(HeatSplit::ConstantVolumeShare { share: spot.value })
            }
            _ => self
                .required(section, "peak_pressure", section.number("peak_pressure"))
                .map(|pressure| HeatSplit::PeakPressure { pressure }),
        }
    }

    fn single_zone(&mut self, gas: &'a Section, strokes: Strokes) -> Option<SingleZone> {
        let intake = self.opening(gas, "intake", strokes);
        let exhaust = self.opening(gas, "exhaust", strokes);
        let combustion = self.combustion(gas);
        let walls = self.walls(gas, strokes);
        let zone = SingleZone { intake: intake?, exhaust: exhaust?, combustion: combustion?, walls: walls? };
        self.check_timing(gas, &zone, strokes).then_some(zone)
    }

    fn walls(&mut self, gas: &'a Section, strokes: Strokes) -> Option<Option<Walls>> {
        let Some(section) = Self::gas_table(gas, "walls")? else { return Some(None) };
        let surroundings = Self::reservoir(gas, "intake", Some(0.0), INTAKE_TEMPERATURE)
            .map_or(INTAKE_TEMPERATURE, |intake| intake.temperature);
        let model = self.wall_model(section, strokes, surroundings);
        let number = |key, usual: f64| section.number(key).or(usual);
        let all = number("temperature", WALL_TEMPERATURE);
        let [piston_temperature, head_temperature, liner_temperature] =
            ["piston_temperature", "head_temperature", "liner_temperature"]
                .map(|key| section.number(key).or(all.unwrap_or(WALL_TEMPERATURE)));
        all?;
        Some(Some(Walls {
            model: model?,
            factor: number("factor", 1.0)?,
            piston_temperature: piston_temperature?,
            head_temperature: head_temperature?,
            liner_temperature: liner_temperature?,
            piston_area: number("piston_area", 1.0)?,
            head_area: number("head_area", 1.1)?,
        }))
    }

    /// Two keys in two tables that say the same thing.
    fn two_sources_apart(&mut self, sections: [&Section; 2], keys: [&str; 2], what: &str) {
        let [first, second] = keys;
        self.mistakes.push(
            Mistake::error(
                "E0203",
                sections[1].key_span(second),
                format!("`{first}` and `{second}` both give {what}"),
            )
            .label("second source")
            .related(sections[0].key_span(first), "first source")
            .hint("keep one of the two"),
        );
    }
}
