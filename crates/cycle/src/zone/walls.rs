//! Heat from the gas to the walls.

use crate::volume::CylinderVolume;
use lanchester_model::{WallModel, Walls};

/// Closed state to which Woschni's motored pressure refers: pressure [Pa], volume [m^3], temperature [K].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Reference {
    pub(crate) pressure: f64,
    pub(crate) volume: f64,
    pub(crate) temperature: f64,
}

/// In which part of the cycle the gas is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Phase {
    /// A valve is open.
    Exchange,
    /// Closed, before heat is released.
    Compression,
    /// Closed, from the beginning of the heat release on.
    Burning,
}

/// Heat flow to the walls [W].
///
/// ```text
/// Q = factor h (A_piston (T - T_piston) + A_head (T - T_head) + A_liner (T - T_liner))              (28.15)
/// Woschni     h = 3.26 B^-0.2 p^0.8 T^-0.55 w^0.8        p [kPa], w = C_1 S_p + C_2 V_d T_r/(p_r V_r) (p - p_m)       (28.16)
///             gas exchange C_1 = 6.18, C_2 = 0; compression 2.28, 0; from the start of the heat release 2.28, 3.24e-3 m/(s K)
/// Hohenberg   h = 130 V^-0.06 p^0.8 T^-0.4 (S_p + 1.4)^0.8       p [bar]                              (28.17)
/// ```
/// A coefficient that the file gives stands for that of (28.16) or (28.17). A conductance stands for all of it: `Q = factor G (T - T_b)`.
///
/// `S_p` is the mean piston speed, `p_m = p_r (V_r/V)^gamma` the pressure without heat release from the reference state at
/// closing. Sources: [Woschni1967], [Heywood1988] sec. 12.4.3; [Hohenberg1979].
pub(crate) struct WallLosses<'a> {
    pub(crate) walls: &'a Walls,
    pub(crate) volume: &'a CylinderVolume,
    pub(crate) mean_piston_speed: f64,
    pub(crate) gamma: f64,
    pub(crate) reference: Reference,
}

impl WallLosses<'_> {
    /// Coefficient [W/(m^2 K)] at a pressure [Pa], temperature [K] and volume [m^3], at the angle `psi` [rad].
    pub(crate) fn coefficient(
        &self,
        [pressure, temperature]: [f64; 2],
        volume: f64,
        psi: f64,
        phase: Phase,
    ) -> f64 {
        let speed = self.mean_piston_speed;
        let coefficient = match &self.walls.model {
            WallModel::Constant { coefficient } => *coefficient,
            WallModel::Conductance(_) => 0.0,
            WallModel::Table { angles, coefficients } => {
                between(angles, coefficients, psi, self.volume.cycle())
            }
            WallModel::Woschni => {
                let [c1, c2] = match phase {
                    Phase::Exchange => [6.18, 0.0],
                    Phase::Compression => [2.28, 0.0],
                    Phase::Burning => [2.28, 3.24e-3],
                };
                let reference = &self.reference;
                let burned = if c2 > 0.0 {
                    let motored = reference.pressure * (reference.volume / volume).powf(self.gamma);
                    let scale = self.volume.displaced() * reference.temperature
                        / (reference.pressure * reference.volume);
                    c2 * scale * (pressure - motored).max(0.0)
                } else {
                    0.0
                };
                3.26 * self.volume.bore().powf(-0.2)
                    * (pressure / 1e3).powf(0.8)
                    * temperature.powf(-0.55)
                    * (c1 * speed + burned).powf(0.8)
            }
            WallModel::Hohenberg => {
                130.0
                    * volume.powf(-0.06)
                    * (pressure / 1e5).powf(0.8)
                    * temperature.powf(-0.4)
                    * (speed + 1.4).powf(0.8)
            }
        };
        self.walls.factor * coefficient
    }

    /// Heat flow [W] at the angle `psi` [rad].
    pub(crate) fn flow(&self, [pressure, temperature]: [f64; 2], volume: f64, psi: f64, phase: Phase) -> f64 {
        let walls = self.walls;
        if let WallModel::Conductance(body) = &walls.model {
            return walls.factor
                * body.conductance
                * (temperature - body.temperature.unwrap_or(body.ambient));
        }
        let areas = [
            (walls.piston_area * self.volume.area(), walls.piston_temperature),
            (walls.head_area * self.volume.head_area(), walls.head_temperature),
            (self.volume.liner_area(psi), walls.liner_temperature),
        ];
        let driving: f64 = areas.iter().map(|(area, wall)| area * (temperature - wall)).sum();
        self.coefficient([pressure, temperature], volume, psi, phase) * driving
    }
}

/// Value at `psi` on the straight lines between points over one `cycle` [rad], of which there is one at least.
fn between(angles: &[f64], values: &[f64], psi: f64, cycle: f64) -> f64 {
    let count = angles.len().min(values.len());
    let turned = angles[0] + (psi - angles[0]).rem_euclid(cycle);
    let place = angles[..count].partition_point(|angle| *angle <= turned).max(1) - 1;
    let (from, value) = (angles[place], values[place]);
    let (to, next) = match place + 1 < count {
        true => (angles[place + 1], values[place + 1]),
        false => (angles[0] + cycle, values[0]),
    };
    value + (next - value) * (turned - from) / (to - from)
}
