//! `[bearings]`.

use super::text::{File, quantity, quoted};
use lanchester_model::{BearingData, Engine, Housing};
use lanchester_units::Dimension;

impl File {
    pub(super) fn bearings(&mut self, engine: &Engine) {
        let Some(bearings) = &engine.bearings else { return };
        self.header("[bearings]", "");
        let design = engine.bearing_design.as_ref();
        let of = |key: &str| match key {
            "main" => design.map(|design| (&design.main, design.main_each.as_slice())),
            "crankpin" => design.map(|design| (&design.crankpin, design.crankpin_each.as_slice())),
            _ => None,
        };
        let kinds =
            [("piston_pin", bearings.piston_pin), ("crankpin", bearings.crankpin), ("main", bearings.main)];
        for (key, bearing) in kinds {
            let Some(bearing) = bearing else { continue };
            self.header(&format!("[bearings.{key}]"), "");
            if let Some(diameter) = bearing.diameter {
                self.entry("diameter", &quantity(diameter, Dimension::Length));
            }
            self.entry("width", &quantity(bearing.width, Dimension::Length));
            let Some((all, each)) = of(key) else { continue };
            self.bearing_data(all);
            for (index, own) in each {
                self.header(&format!("[[bearings.{key}.each]]"), "");
                self.entry("number", &(index + 1).to_string());
                self.bearing_data(own);
            }
        }
        self.oil(engine);
    }

    fn bearing_data(&mut self, data: &BearingData) {
        for (key, value, dimension) in [
            ("width", data.width, Dimension::Length),
            ("diametral_clearance", data.diametral_clearance, Dimension::Length),
            ("stiffness", data.stiffness, Dimension::Stiffness),
            ("damping", data.damping, Dimension::Damping),
        ] {
            if let Some(value) = value {
                self.entry(key, &quantity(value, dimension));
            }
        }
        if let Some(law) = data.model {
            self.entry("model", &quoted(law.word()));
        }
        if let Some(grooves) = &data.grooves {
            let list: Vec<String> = grooves
                .iter()
                .map(|groove| {
                    let [from, to] = [groove.from, groove.to].map(|angle| quantity(angle, Dimension::Angle));
                    let width = quantity(groove.width, Dimension::Length);
                    format!("{{ from = {from}, to = {to}, width = {width} }}")
                })
                .collect();
            self.entry("grooves", &format!("[{}]", list.join(", ")));
        }
        match data.housing {
            None => {}
            Some(Housing::Rigid) => self.entry("housing_stiffness", "\"rigid\""),
            Some(Housing::Stiffness(value)) => {
                self.entry("housing_stiffness", &quantity(value, Dimension::Stiffness));
            }
        }
    }

    fn oil(&mut self, engine: &Engine) {
        let Some(oil) = engine.bearing_design.as_ref().map(|design| &design.oil) else { return };
        if *oil == lanchester_model::Oil::default() {
            return;
        }
        self.header("[bearings.film]", "");
        if let Some(name) = &oil.name {
            self.entry("oil", &quoted(name));
        }
        for (key, value, dimension) in [
            ("viscosity", oil.viscosity, Dimension::Viscosity),
            ("temperature", oil.temperature, Dimension::Temperature),
            ("density", oil.density, Dimension::Density),
            ("supply_pressure", oil.supply_pressure, Dimension::Pressure),
            ("roughness", oil.roughness, Dimension::Length),
        ] {
            if let Some(value) = value {
                self.entry(key, &quantity(value, dimension));
            }
        }
        if let Some(cavitation) = oil.cavitation {
            self.entry("cavitation", &quoted(cavitation.word()));
        }
    }
}
