//! Compressible flow through an opening.

/// Share of pressure difference below which the flow goes over from its square root to a straight line.
const SMOOTH: f64 = 1e-4;

/// What of a perfect gas its flow depends on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FlowGas {
    pub(crate) gamma: f64,
    pub(crate) gas_constant: f64,
    /// Pressure ratio below which the flow is choked.
    critical: f64,
    /// sqrt(2 gamma/(gamma - 1)).
    factor: f64,
}

impl FlowGas {
    pub(crate) fn new(gamma: f64, gas_constant: f64) -> FlowGas {
        FlowGas {
            gamma,
            gas_constant,
            critical: (2.0 / (gamma + 1.0)).powf(gamma / (gamma - 1.0)),
            factor: (2.0 * gamma / (gamma - 1.0)).sqrt(),
        }
    }

    /// From a state upstream (pressure [Pa], temperature [K]) to a lower pressure [Pa] [kg/s].
    pub(crate) fn flow(&self, area: f64, [pressure, temperature]: [f64; 2], downstream: f64) -> f64 {
        let ratio = (downstream / pressure).max(self.critical);
        // r^(2/gamma) - r^((gamma+1)/gamma), as a product: no cancellation near r = 1.
        let power = ratio.ln() / self.gamma;
        let y = -(2.0 * power).exp() * ((self.gamma - 1.0) * power).exp_m1();
        let small = SMOOTH * (self.gamma - 1.0) / self.gamma;
        let root = y / (y * y + small * small).sqrt().sqrt();
        area * pressure / (self.gas_constant * temperature).sqrt() * self.factor * root
    }
}

/// Mass flow of a perfect gas through an opening of effective area [m^2] from a state upstream to a pressure downstream [kg/s], isentropic
/// to its throat.
///
/// ```text
/// dm/dt = A p_u/sqrt(R T_u) sqrt(2 gamma/(gamma - 1) (r^(2/gamma) - r^((gamma + 1)/gamma)))       (28.10)
/// r = max(p_d/p_u, (2/(gamma + 1))^(gamma/(gamma - 1)))
/// ```
/// Below a pressure difference of a ten-thousandth it goes over into a straight line, so that it has a slope at rest: at a thousandth
/// it is a quarter of a per cent too small, at a hundredth 25 parts in a million. `upstream` is pressure [Pa] and
/// temperature [K]; where it has the lower pressure, nothing flows.
///
/// Source: [Heywood1988] app. C, eqs. C.8 and C.9.
pub fn mass_flow(area: f64, upstream: [f64; 2], downstream: f64, gamma: f64, gas_constant: f64) -> f64 {
    if downstream >= upstream[0] {
        0.0
    } else {
        FlowGas::new(gamma, gas_constant).flow(area, upstream, downstream)
    }
}
