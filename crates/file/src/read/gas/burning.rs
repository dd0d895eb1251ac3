//! `[gas.fuel]` and `[gas.heat_release]`.

use crate::document::Section;
use crate::read::reader::Reader;
use lanchester_diagnostic::Mistake;
use lanchester_model::{Combustion, Fuel, FuelSupply, HeatRelease};
use std::f64::consts::TAU;

/// Stoichiometric air-fuel ratio and lower heating value [J/kg] of petrol and diesel oil, about.
const AIR_FUEL_RATIO: f64 = 14.6;
const HEATING_VALUE: f64 = 42.7e6;
/// Longest heat release [rad].
const LONGEST: f64 = TAU / 2.0;

impl<'a> Reader<'a> {
    /// The fuel, which must be there; `or_else` names what could stand in its place.
    pub(super) fn fuel(&mut self, gas: &'a Section, or_else: &str) -> Option<Fuel> {
        let Some(section) = Self::gas_table(gas, "fuel")? else {
            let hint = format!("add [gas.fuel] with energy = \"1200 J\" {or_else}");
            self.missing(gas.span.clone(), "[gas.fuel] is missing".into(), hint.trim_end().into());
            return None;
        };
        let efficiency = self.part_of_one(section, "efficiency", 1.0);
        let supply = match (section.has("energy"), section.has("equivalence_ratio")) {
            (true, true) => {
                self.two_sources(section, "energy", "equivalence_ratio", "how much fuel there is");
                None
            }
            (false, true) => {
                let equivalence_ratio = section.number("equivalence_ratio").given();
                let air_fuel_ratio = section.number("air_fuel_ratio").or(AIR_FUEL_RATIO);
                let heating_value = section.number("heating_value").or(HEATING_VALUE);
                Some(FuelSupply::Mixture {
                    equivalence_ratio: equivalence_ratio?,
                    air_fuel_ratio: air_fuel_ratio?,
                    heating_value: heating_value?,
                })
            }
            _ => self
                .required(section, "energy", section.number("energy"))
                .map(|energy| FuelSupply::Energy { energy }),
        };
        Some(Fuel { supply: supply?, efficiency: efficiency? })
    }

    /// What burns in a single zone; the inner `None` says that it is motored.
    pub(super) fn combustion(&mut self, gas: &'a Section) -> Option<Option<Combustion>> {
        let Some(section) = Self::gas_table(gas, "heat_release")? else {
            if gas.has("fuel") {
                self.missing(
                    gas.key_span("fuel"),
                    "[gas.fuel] needs [gas.heat_release]: when does it burn?".into(),
                    "add [gas.heat_release] with start = \"-15 deg\" and duration = \"50 deg\", or leave the fuel out for a motored engine".into(),
                );
                return None;
            }
            return Some(None);
        };
        let fuel = self.fuel(gas, "");
        let first = self.stage(section, Some(1.0));
        let stages = match Self::gas_table(section, "second")? {
            None => first.map(|first| vec![first]),
            Some(second) => {
                let share = self.required(second, "share", second.number("share"));
                let share = share.and_then(|_| self.part_of_one(second, "share", 1.0));
                let second = self.stage(second, share);
                first
                    .zip(second)
                    .map(|(first, second)| vec![HeatRelease { share: 1.0 - second.share, ..first }, second])
            }
        };
        Some(Some(Combustion { fuel: fuel?, stages: stages? }))
    }

    fn stage(&mut self, section: &'a Section, share: Option<f64>) -> Option<HeatRelease> {
        let start = self.required(section, "start", section.number("start"));
        let duration = self.required(section, "duration", section.number("duration"));
        let exponent = section.number("exponent").or(2.0);
        let completeness = self.part_of_one(section, "completeness", 0.999);
        if completeness == Some(1.0) {
            let message = "`completeness` must be less than 100 %: a Wiebe function never ends";
            self.mistakes.push(
                Mistake::error("E1205", section.value_span("completeness"), message)
                    .label("out of range")
                    .hint("write for example completeness = \"99.9 %\""),
            );
        }
        for (key, value, least) in [("start", start, -LONGEST), ("duration", duration, 0.0)] {
            let Some(value) = value else { continue };
            if value <= least || value >= LONGEST {
                let message = format!(
                    "`{key}` must lie between {:.0} deg and {:.0} deg, got {:.4} deg",
                    least.to_degrees(),
                    LONGEST.to_degrees(),
                    value.to_degrees()
                );
                self.mistakes.push(
                    Mistake::error("E1205", section.value_span(key), message)
                        .label("out of range")
                        .hint("angles count from the firing top dead centre, negative before it"),
                );
                return None;
            }
        }
        Some(HeatRelease {
            share: share?,
            start: start?,
            duration: duration?,
            exponent: exponent?,
            completeness: completeness?,
        })
    }

    /// A share above 0 and at most 1.
    fn part_of_one(&mut self, section: &Section, key: &str, usual: f64) -> Option<f64> {
        let value = section.number(key).or(usual)?;
        if value > 0.0 && value <= 1.0 {
            return Some(value);
        }
        let message = format!("`{key}` must be more than 0 % and at most 100 %, got {} %", 100.0 * value);
        self.mistakes.push(
            Mistake::error("E1205", section.value_span(key), message)
                .label("out of range")
                .hint("it is a share of the whole, such as \"98 %\""),
        );
        None
    }
}
