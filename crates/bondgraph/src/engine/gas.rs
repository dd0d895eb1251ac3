//! Gas as states: volume, mass and energy of every cylinder, valves, heat release, walls.
//!
//! ```text
//! dm/dt = A p_u/sqrt(R T_u) sqrt(2 gamma/(gamma - 1)) y^(1/2)        y = r^(2/gamma) - r^((gamma + 1)/gamma)
//! r = max(p_d/p_u, (2/(gamma + 1))^(gamma/(gamma - 1)))              enthalpy flow: c_p T_u dm/dt
//! ```
//! Upstream (u) is the side of the higher pressure. Near rest the root goes over into a straight line: `y/(y^2 + y_0^2)^(1/4)` with
//! `y_0 = 1e-4 (gamma - 1)/gamma`. Source: Heywood, *Internal Combustion Engine Fundamentals*, appendix C, eqs. C.8 and C.9; the field
//! with its three ports: Karnopp, Margolis, Rosenberg, *System Dynamics*, 5th edition, section 12.4.

use super::Builder;
use super::gas_walls::Chamber;
use super::numbers::{dead_centres, travel};
use super::request::{GasStates, GasValve};
use super::words::{number, quantity};
use crate::curve::Curve;

impl Builder<'_> {
    /// Reservoirs and the engine's body, shared by all cylinders.
    pub(crate) fn surroundings(&mut self) {
        let Some(gas) = self.request.gas_states.clone() else { return };
        self.parameter("gas_constant", gas.gas_constant, "J/kg/K");
        self.parameter("heat_capacity", gas.heat_capacity, "J/kg/K");
        for (name, valve) in [("intake", &gas.intake), ("exhaust", &gas.exhaust)] {
            for (what, effort, domain) in [
                ("mass", quantity(valve.pressure, "Pa"), "mass"),
                ("heat", quantity(valve.temperature, "K"), "heat"),
            ] {
                let (junction, source) = (format!("{name}_{what}"), format!("{name}_{what}_state"));
                self.element(&junction, "0", &[("domain", domain)]);
                self.element(&source, "Se", &[("effort", &effort)]);
                self.bond(&source, &junction);
            }
        }
        if let Some(law) = &gas.losses {
            self.wall_temperatures(law);
        }
        if let Some(walls) = gas.walls {
            let (start, ambient) = (quantity(walls.start, "K"), quantity(walls.ambient, "K"));
            self.element("body", "0", &[("domain", "heat")]);
            let keys = [("capacitance", quantity(walls.body_capacity, "J/K")), ("effort", start)];
            self.element("body_heat", "C", &[(keys[0].0, &keys[0].1), (keys[1].0, &keys[1].1)]);
            self.element("ambient", "0", &[("domain", "heat")]);
            self.element("ambient_state", "Se", &[("effort", &ambient)]);
            self.conduction("loss", walls.body_to_ambient);
            self.bond("body", "body_heat");
            self.bond("ambient_state", "ambient");
            self.bond("body", "loss.1");
            self.bond("ambient", "loss.2");
        }
    }

    /// A conductance between two heat bonds: what leaves one enters the other.
    fn conduction(&mut self, name: &str, conductance: f64) {
        let flow = format!("{}*(e1 - e2)", quantity(conductance, "W/K"));
        self.element(name, "R", &[("flow", &format!("{flow} ; -{flow}"))]);
    }

    /// The gas of a cylinder on its stroke junction.
    pub(crate) fn gas_states(&mut self, index: usize, gas: &GasStates) {
        let k = index + 1;
        let area = self.own("area", index);
        let [top, bottom] = dead_centres(self.engine, index);
        let bore = self.numbers.cylinders[index].area;
        let clearance = (top - bottom) / (gas.compression_ratio - 1.0);
        let volume = bore * (clearance + top - self.start_travel(index));
        let name = |what: &str| format!("{what}{k}");
        let keys = [
            ("gas_constant", "gas_constant".to_owned()),
            ("heat_capacity", "heat_capacity".to_owned()),
            ("volume", quantity(volume, "m3")),
            ("pressure", quantity(gas.start[0], "Pa")),
            ("temperature", quantity(gas.start[1], "K")),
        ];
        let keys: Vec<(&str, &str)> = keys.iter().map(|(key, value)| (*key, value.as_str())).collect();
        self.element(&name("gas"), "Gas", &keys);
        self.element(&name("bore"), "TF", &[("ratio", &area)]);
        self.element(
            &name("crankcase"),
            "Se",
            &[("effort", &format!("{}*{area}", quantity(gas.crankcase, "Pa")))],
        );
        self.element(&name("mass"), "0", &[("domain", "mass")]);
        self.element(&name("heat"), "0", &[("domain", "heat")]);
        self.bond(&name("stroke"), &format!("bore{k}.1"));
        self.bond(&format!("bore{k}.2"), &format!("gas{k}.1"));
        self.bond(&name("crankcase"), &name("stroke"));
        self.bond(&name("mass"), &format!("gas{k}.2"));
        self.bond(&name("heat"), &format!("gas{k}.3"));
        if gas.losses.is_none() {
            self.signal(&name("volume"), &format!("{} - gas{k}.1.displacement", quantity(volume, "m3")));
        }
        self.valve("intake", k, &gas.intake, true);
        self.valve("exhaust", k, &gas.exhaust, false);
        if let Some(release) = &gas.release {
            let table = self.shared_table("heat_release", release);
            let speed = if self.numbers_ratio(index) == 1.0 {
                "crank.flow".to_owned()
            } else {
                format!("{}*crank.flow", number(self.numbers_ratio(index)))
            };
            let fired = self.fired(index).map_or(String::new(), |fired| format!("{fired}*"));
            let burnt = format!("{fired}table({table}, psi{k})*{speed}");
            match gas.heat_per_fresh {
                None => self.signal(&name("release_rate"), &burnt),
                Some(heat) => {
                    self.fresh_gas(k, gas, &burnt, gas.start[0] * volume / (gas.gas_constant * gas.start[1]));
                    let rate = format!("{}*closed_fresh{k}*{burnt}", quantity(heat, "J/kg"));
                    self.signal(&name("release_rate"), &rate);
                }
            }
            self.element(&name("combustion"), "MSf", &[("flow", &name("release_rate"))]);
            self.bond(&name("combustion"), &name("heat"));
        }
        if let Some(law) = &gas.losses {
            let closing = self.crank_angle(index, gas.closes);
            let chamber = Chamber {
                area: bore,
                top,
                stroke: top - bottom,
                clearance,
                start_volume: volume,
                closed_volume: bore * (clearance + top - travel(self.engine, index, closing)),
            };
            self.wall_heat(index, gas, law, chamber);
        }
        if let Some(walls) = &gas.walls {
            self.conduction(&name("cooling"), walls.gas_to_body);
            self.bond(&name("heat"), &format!("cooling{k}.1"));
            self.bond("body", &format!("cooling{k}.2"));
        }
    }

    /// Fresh gas in the cylinder, and how much of it there was when the cylinder closed: what flows in from the intake is fresh, what
    /// flows out is as fresh as what is in.
    fn fresh_gas(&mut self, k: usize, gas: &GasStates, burnt: &str, start: f64) {
        let (fresh, closed) = (format!("fresh{k}"), format!("closed_fresh{k}"));
        let share = format!("fresh{k}/gas{k}.2.displacement");
        let rate = format!(
            "intake{k}.1.flow*if(intake_mass.effort > mass{k}.effort, 1, {share}) - exhaust{k}.1.flow*if(mass{k}.effort > exhaust_mass.effort, {share}, 0) - {closed}*{burnt}"
        );
        let start = quantity(start, "kg");
        self.integral(&fresh, &rate, &start);
        self.integral(&closed, "0 kg/s", &start);
        self.at_closing(k, gas.closes, &[(&closed, &fresh)]);
    }

    /// Angle of crankshaft 1 where the crankshaft of a cylinder has turned so far since its firing [rad].
    fn crank_angle(&self, index: usize, psi: f64) -> f64 {
        self.numbers.cylinders[index].firing.unwrap_or(0.0) + psi / self.numbers_ratio(index)
    }

    pub(crate) fn numbers_ratio(&self, index: usize) -> f64 {
        let throw = self.engine.cylinders[index].throw;
        self.engine.crankshafts[self.engine.throws[throw].crankshaft].ratio.value().abs()
    }

    /// A table that all cylinders read.
    pub(crate) fn shared_table(&mut self, name: &str, curve: &Curve) -> String {
        if !self.graph.tables.iter().any(|(known, _)| known.text == name) {
            self.graph.tables.push((name.into(), curve.clone()));
        }
        name.to_owned()
    }

    /// A valve between a reservoir and a cylinder, positive flow into the cylinder at the intake and out of it at the exhaust.
    fn valve(&mut self, kind: &str, k: usize, valve: &GasValve, into: bool) {
        let name = format!("{kind}{k}");
        let table = self.shared_table(&format!("{kind}_area"), &valve.area);
        let opening = format!("{kind}_area_now{k}");
        self.signal(&opening, &format!("table({table}, psi{k})"));
        let gamma = "(1 + gas_constant/heat_capacity)";
        let flow = |pressure: &str, temperature: &str, down: &str| {
            let ratio = format!("max({down}/{pressure}, (2/({gamma} + 1))^({gamma}/({gamma} - 1)))");
            let y = format!("({ratio}^(2/{gamma}) - {ratio}^(({gamma} + 1)/{gamma}))");
            let small = format!("(1e-4*({gamma} - 1)/{gamma})");
            format!(
                "{opening}*{pressure}/sqrt(gas_constant*{temperature})*sqrt(2*{gamma}/({gamma} - 1))*{y}/sqrt(sqrt({y}^2 + {small}^2))"
            )
        };
        let mass = format!("if(e1 > e3, {}, -{})", flow("e1", "e2", "e3"), flow("e3", "e4", "e1"));
        let heat = format!("(gas_constant + heat_capacity)*if(e1 > e3, e2, e4)*{mass}");
        let laws = format!("{mass} ; {heat} ; -{mass} ; -{heat}");
        self.element(&name, "MR", &[("flow", &laws)]);
        let own = [format!("mass{k}"), format!("heat{k}")];
        let far = [format!("{kind}_mass"), format!("{kind}_heat")];
        let order =
            if into { [&far[0], &far[1], &own[0], &own[1]] } else { [&own[0], &own[1], &far[0], &far[1]] };
        for (port, junction) in order.into_iter().enumerate() {
            self.bond(junction, &format!("{name}.{}", port + 1));
        }
    }
}
