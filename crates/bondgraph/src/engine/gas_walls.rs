//! Heat from the gas of a cylinder to crown, head and liner.
//!
//! ```text
//! Q = factor h (A_crown (T - T_crown) + A_head (T - T_head) + A_liner (T - T_liner))
//! Woschni     h = 3.26 B^-0.2 p^0.8 T^-0.55 w^0.8       p [kPa], w = c_1 S_p + c_2 V_d/(m R) (p - p_m), p_m = p_r (V_r/V)^gamma
//! Hohenberg   h = 130 V^-0.06 p^0.8 T^-0.4 (S_p + 1.4)^0.8      p [bar]
//! ```
//! | symbol | name                                                             | unit      |
//! |--------|------------------------------------------------------------------|-----------|
//! | S_p    | mean piston speed at the present speed of the crank              | m/s       |
//! | m      | mass in the closed cylinder: T_r/(p_r V_r) = 1/(m R)             | kg        |
//! | p_r    | pressure when the cylinder closed, kept by an event              | Pa        |
//! | c_1    | 6.18 with a valve open, 2.28 closed                              | 1         |
//! | c_2    | 3.24e-3 from the start of the heat release until a valve opens   | m/(s K)   |
//!
//! Sources: Woschni, SAE 670931; Heywood, *Internal Combustion Engine Fundamentals*, section 12.4.3; Hohenberg, SAE 790825.

use super::Builder;
use super::request::{GasStates, WallCoefficient, WallLaw};
use super::words::{number, quantity};
use std::f64::consts::PI;

/// Numbers of a cylinder that its walls need.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Chamber {
    /// Area of the bore [m^2].
    pub(crate) area: f64,
    /// Travel of the pin at top dead centre [m], and the stroke [m].
    pub(crate) top: f64,
    pub(crate) stroke: f64,
    /// Height of the clearance volume [m].
    pub(crate) clearance: f64,
    /// Volume at the start [m^3] and when the cylinder closes.
    pub(crate) start_volume: f64,
    pub(crate) closed_volume: f64,
}

/// Walls of all cylinders: junction, its source, temperature.
const WALLS: [&str; 3] = ["crown", "head", "liner"];

impl Builder<'_> {
    /// Temperatures of crown, head and liner, shared by all cylinders.
    pub(crate) fn wall_temperatures(&mut self, law: &WallLaw) {
        for (place, name) in WALLS.into_iter().enumerate() {
            if place == 1 && law.areas[1] == 0.0 {
                continue;
            }
            let (junction, source) = (format!("{name}_wall"), format!("{name}_temperature"));
            self.element(&junction, "0", &[("domain", "heat")]);
            self.element(&source, "Se", &[("effort", &quantity(law.temperatures[place], "K"))]);
            self.bond(&source, &junction);
        }
    }

    /// The walls of one cylinder.
    pub(crate) fn wall_heat(&mut self, index: usize, gas: &GasStates, law: &WallLaw, chamber: Chamber) {
        let k = index + 1;
        let bore = (4.0 * chamber.area / PI).sqrt();
        self.signal(&format!("depth{k}"), &format!("{} - s{k}", quantity(chamber.top, "m")));
        self.signal(
            &format!("volume{k}"),
            &format!("{}*({} + depth{k})", quantity(chamber.area, "m2"), quantity(chamber.clearance, "m")),
        );
        let piston_speed =
            format!("{}*abs(crank.flow)", quantity(chamber.stroke / PI * self.numbers_ratio(index), "m"));
        let pressure = |unit: &str| format!("(mass{k}.effort/{unit})^0.8");
        let coefficient = match &law.coefficient {
            WallCoefficient::Given(curve) => {
                let table = self.shared_table("wall_coefficient", curve);
                format!("table({table}, psi{k})")
            }
            WallCoefficient::Hohenberg => format!(
                "130 W/m2/K*(volume{k}/(1 m3))^(-0.06)*{}*(heat{k}.effort/(1 K))^(-0.4)*({piston_speed}/(1 m/s) + 1.4)^0.8",
                pressure("(1e5 Pa)")
            ),
            WallCoefficient::Woschni { phases } => {
                let [first, second] = [("woschni_flow", &phases[0]), ("woschni_burning", &phases[1])]
                    .map(|(name, curve)| self.shared_table(name, curve));
                let mut speed = format!("table({first}, psi{k})*{piston_speed}");
                if gas.release.is_some() {
                    self.closed_state(k, gas, chamber);
                    let gamma = "(1 + gas_constant/heat_capacity)";
                    let motored = format!(
                        "closed_pressure{k}*({}/volume{k})^{gamma}",
                        quantity(chamber.closed_volume, "m3")
                    );
                    self.signal(&format!("motored{k}"), &motored);
                    speed += &format!(
                        " + table({second}, psi{k})*{}/(gas{k}.2.displacement*gas_constant)*max(mass{k}.effort - motored{k}, 0)",
                        quantity(chamber.area * chamber.stroke, "m3")
                    );
                }
                self.signal(&format!("gas_speed{k}"), &speed);
                format!(
                    "{} W/m2/K*{}*(heat{k}.effort/(1 K))^(-0.55)*(gas_speed{k}/(1 m/s))^0.8",
                    number(3.26 * bore.powf(-0.2)),
                    pressure("(1000 Pa)")
                )
            }
        };
        self.signal(&format!("wall_coefficient{k}"), &format!("{}*{coefficient}", number(law.factor)));
        let areas = [
            (law.areas[0] > 0.0).then(|| quantity(law.areas[0] * chamber.area, "m2")),
            (law.areas[1] > 0.0).then(|| quantity(law.areas[1] * chamber.area, "m2")),
            Some(format!("{}*depth{k}", quantity(PI * bore, "m"))),
        ];
        let mut flows = Vec::new();
        let mut far = Vec::new();
        for (wall, area) in WALLS.iter().zip(areas) {
            let Some(area) = area else { continue };
            flows.push(format!("wall_coefficient{k}*{area}*(e1 - e{})", flows.len() + 2));
            far.push(format!("{wall}_wall"));
        }
        let back: Vec<String> = flows.iter().map(|flow| format!("-{flow}")).collect();
        let laws = format!("{} ; {}", flows.join(" + "), back.join(" ; "));
        let name = format!("wall{k}");
        self.element(&name, "MR", &[("flow", &laws)]);
        self.bond(&format!("heat{k}"), &format!("{name}.1"));
        for (port, wall) in far.iter().enumerate() {
            self.bond(wall, &format!("{name}.{}", port + 2));
        }
    }

    /// Keeps the pressure at which the cylinder closed.
    fn closed_state(&mut self, k: usize, gas: &GasStates, chamber: Chamber) {
        let gamma = 1.0 + gas.gas_constant / gas.heat_capacity;
        let start = gas.start[0] * (chamber.start_volume / chamber.closed_volume).powf(gamma);
        let name = format!("closed_pressure{k}");
        self.integral(&name, "0 Pa/s", &quantity(start, "Pa"));
        self.at_closing(k, gas.closes, &[(&name, &format!("mass{k}.effort"))]);
    }

    /// Sets states where a cylinder closes, once a cycle.
    pub(crate) fn at_closing(&mut self, k: usize, closes: f64, set: &[(&str, &str)]) {
        let share = f64::from(self.engine.strokes.revolutions()).recip();
        let when = format!("sin({}*(psi{k} - {}))", number(share), quantity(closes, "rad"));
        match self.graph.events.iter_mut().find(|event| event.when.text == when) {
            Some(event) => event.set.extend(set.iter().map(|(a, b)| ((*a).into(), (*b).into()))),
            None => self.graph = std::mem::take(&mut self.graph).event(&when, set),
        }
    }
}
