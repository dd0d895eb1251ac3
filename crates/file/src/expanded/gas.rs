//! `[gas]` and its tables.

use super::text::{File, quantity, quoted};
use lanchester_model::Engine;
use lanchester_model::*;
use lanchester_units::Dimension;

impl File {
    pub(super) fn gas(&mut self, engine: &Engine) {
        let Some(gas) = &engine.gas else { return };
        self.header("[gas]", "angles from the firing top dead centre");
        self.entry("ambient_pressure", &quantity(gas.ambient_pressure, Dimension::Pressure));
        if let Some(ratio) = gas.compression_ratio() {
            self.entry("compression_ratio", &format!("{ratio:?}"));
        }
        self.header("[gas.crankcase]", "");
        match &gas.crankcase {
            CrankcasePressure::Constant { pressure } => {
                self.entry("pressure", &quantity(*pressure, Dimension::Pressure));
            }
            CrankcasePressure::Trace(trace) => self.trace(trace),
        }
        match &gas.source {
            GasSource::Traces { traces, .. } => {
                for trace in traces {
                    self.header("[[gas.trace]]", "");
                    self.trace(trace);
                }
            }
            GasSource::Cycle(cycle) => self.gas_cycle(cycle),
        }
    }

    fn trace(&mut self, trace: &PressureTrace) {
        self.entry("file", &quoted(&trace.file));
        if let Some(speed) = trace.speed {
            self.entry("speed", &quantity(speed, Dimension::Speed));
        }
        if trace.gauge {
            self.entry("pressures", "\"gauge\"");
        }
        self.entry_unless_zero("top_dead_centre", trace.top_dead_centre, Dimension::Angle);
        if trace.counted_from_first {
            self.entry("counted_from", "\"cylinder 1\"");
        }
    }

    fn gas_cycle(&mut self, cycle: &GasCycle) {
        self.header("[gas.cycle]", "");
        let (kind, fuel) = match &cycle.process {
            GasProcess::Otto { heat: IdealHeat::Fuel(fuel) } => ("otto", Some(fuel)),
            GasProcess::Otto { heat: IdealHeat::PeakPressure { .. } } => ("otto", None),
            GasProcess::Diesel { fuel } => ("diesel", Some(fuel)),
            GasProcess::Seiliger { fuel, .. } => ("seiliger", Some(fuel)),
            GasProcess::Sealed => ("sealed", None),
            GasProcess::SingleZone(zone) => ("single-zone", zone.combustion.as_ref().map(|c| &c.fuel)),
        };
        self.entry("type", &quoted(kind));
        self.entry("heat_capacity_ratio", &format!("{:?}", cycle.heat_capacity_ratio));
        self.entry("gas_constant", &quantity(cycle.gas_constant, Dimension::SpecificHeat));
        match &cycle.process {
            GasProcess::Otto { heat: IdealHeat::PeakPressure { pressure } }
            | GasProcess::Seiliger { split: HeatSplit::PeakPressure { pressure }, .. } => {
                self.entry("peak_pressure", &quantity(*pressure, Dimension::Pressure));
            }
            GasProcess::Seiliger { split: HeatSplit::ConstantVolumeShare { share }, .. } => {
                self.entry("constant_volume_share", &format!("{share:?}"));
            }
            GasProcess::Sealed => {
                self.entry("pressure", &quantity(cycle.intake.pressure, Dimension::Pressure));
                self.entry("temperature", &quantity(cycle.intake.temperature, Dimension::Temperature));
                return;
            }
            _ => {}
        }
        let zone = match &cycle.process {
            GasProcess::SingleZone(zone) => Some(zone),
            _ => None,
        };
        self.header("[gas.intake]", "");
        self.entry("pressure", &quantity(cycle.intake.pressure, Dimension::Pressure));
        self.entry("temperature", &quantity(cycle.intake.temperature, Dimension::Temperature));
        if let Some(zone) = zone {
            self.opening(&zone.intake);
        }
        self.header("[gas.exhaust]", "");
        self.entry("pressure", &quantity(cycle.exhaust.pressure, Dimension::Pressure));
        if let Some(zone) = zone {
            self.entry("temperature", &quantity(cycle.exhaust.temperature, Dimension::Temperature));
            self.opening(&zone.exhaust);
        }
        if let Some(fuel) = fuel {
            self.fuel(fuel);
        }
        if let Some(zone) = zone {
            self.heat_release(zone);
            self.walls(zone);
        }
    }

    fn opening(&mut self, opening: &Opening) {
        self.entry("opens", &quantity(opening.opens, Dimension::Angle));
        match opening.shape {
            OpeningShape::Valve { closes, lift, diameter, number, piston_clearance } => {
                self.entry("closes", &quantity(closes, Dimension::Angle));
                self.entry("lift", &quantity(lift, Dimension::Length));
                self.entry("diameter", &quantity(diameter, Dimension::Length));
                self.entry("number", &number.to_string());
                if let Some(clearance) = piston_clearance {
                    self.entry("piston_clearance", &quantity(clearance, Dimension::Length));
                }
            }
            OpeningShape::Area { closes, area } => {
                self.entry("closes", &quantity(closes, Dimension::Angle));
                self.entry("area", &quantity(area, Dimension::Area));
            }
            OpeningShape::Port { area } => self.entry("area", &quantity(area, Dimension::Area)),
        }
        self.entry("discharge_coefficient", &format!("{:?}", opening.discharge_coefficient));
    }

    fn fuel(&mut self, fuel: &Fuel) {
        self.header("[gas.fuel]", "");
        match fuel.supply {
            FuelSupply::Energy { energy } => self.entry("energy", &quantity(energy, Dimension::Energy)),
            FuelSupply::Mixture { equivalence_ratio, air_fuel_ratio, heating_value } => {
                self.entry("equivalence_ratio", &format!("{equivalence_ratio:?}"));
                self.entry("air_fuel_ratio", &format!("{air_fuel_ratio:?}"));
                self.entry("heating_value", &quantity(heating_value, Dimension::SpecificEnergy));
            }
        }
        self.entry("efficiency", &format!("{:?}", fuel.efficiency));
    }

    fn heat_release(&mut self, zone: &SingleZone) {
        for (index, stage) in zone.combustion.iter().flat_map(|burning| &burning.stages).enumerate() {
            if index == 0 {
                self.header("[gas.heat_release]", "");
            } else {
                self.header("[gas.heat_release.second]", "");
                self.entry("share", &format!("{:?}", stage.share));
            }
            self.entry("start", &quantity(stage.start, Dimension::Angle));
            self.entry("duration", &quantity(stage.duration, Dimension::Angle));
            self.entry("exponent", &format!("{:?}", stage.exponent));
            self.entry("completeness", &format!("{:?}", stage.completeness));
        }
    }

    fn walls(&mut self, zone: &SingleZone) {
        let Some(walls) = &zone.walls else { return };
        self.header("[gas.walls]", "");
        let list = |values: &[f64], dimension| {
            let texts: Vec<String> = values.iter().map(|value| quantity(*value, dimension)).collect();
            format!("[{}]", texts.join(", "))
        };
        let model = match &walls.model {
            WallModel::Woschni => "woschni",
            WallModel::Hohenberg => "hohenberg",
            WallModel::Constant { .. } => "constant",
            WallModel::Table { .. } => "table",
            WallModel::Conductance(_) => "conductance",
        };
        self.entry("model", &quoted(model));
        match &walls.model {
            WallModel::Woschni | WallModel::Hohenberg => {}
            WallModel::Constant { coefficient } => {
                self.entry("coefficient", &quantity(*coefficient, Dimension::HeatTransfer));
            }
            WallModel::Table { angles, coefficients } => {
                self.entry("angles", &list(angles, Dimension::Angle));
                self.entry("coefficients", &list(coefficients, Dimension::HeatTransfer));
            }
            WallModel::Conductance(body) => {
                self.entry("conductance", &quantity(body.conductance, Dimension::ThermalConductance));
                self.entry("body_capacity", &quantity(body.capacity, Dimension::HeatCapacity));
                self.entry("body_to_ambient", &quantity(body.to_ambient, Dimension::ThermalConductance));
                self.entry("ambient_temperature", &quantity(body.ambient, Dimension::Temperature));
                if let Some(temperature) = body.temperature {
                    self.entry("body_temperature", &quantity(temperature, Dimension::Temperature));
                }
                self.entry("factor", &format!("{:?}", walls.factor));
                return;
            }
        }
        self.entry("factor", &format!("{:?}", walls.factor));
        for (key, value) in [
            ("piston_temperature", walls.piston_temperature),
            ("head_temperature", walls.head_temperature),
            ("liner_temperature", walls.liner_temperature),
        ] {
            self.entry(key, &quantity(value, Dimension::Temperature));
        }
        self.entry("piston_area", &format!("{:?}", walls.piston_area));
        self.entry("head_area", &format!("{:?}", walls.head_area));
    }
}
