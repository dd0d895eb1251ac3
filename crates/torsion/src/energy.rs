//! Work and energy of a chain over a period in the time domain.
//!
//! ```text
//! E = 1/2 SUM J_i theta_i'^2 + 1/2 SUM k (phi_a - phi_b)^2        missing = gas + masses - load - damping - (E_end - E_start)   (50.16)
//! gas  INT SUM T_i theta_i' dt      load  INT L theta' dt      damping  INT (SUM c_i phi_i' theta_i' + SUM c (phi_a' - phi_b')^2) dt
//! ```
//! `masses` is the work of the torque that stands for varying inertia, and 0 where inertia varies: it is kinetic energy then. Powers are taken between the
//! stages of the integrator, so that nothing makes the sums balance but the solution itself.

use serde::Serialize;

/// Missing energy over the turnover up to which a period is balanced.
pub const BALANCED: f64 = 1e-4;

/// Work and energy over a period [J].
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct ChainEnergy {
    /// Work of the gas.
    pub gas: f64,
    /// Work of the torque that stands for varying inertia; 0 where inertia varies.
    pub masses: f64,
    /// Taken by the load.
    pub load: f64,
    /// Lost in the dampers.
    pub damping: f64,
    /// Change of kinetic and elastic energy.
    pub change: f64,
    /// What is missing: gas + masses - load - damping - change.
    pub missing: f64,
    /// Sum of the sizes of all powers over time, by which `missing` is judged.
    pub turnover: f64,
}

impl ChainEnergy {
    /// Missing energy over the turnover.
    pub fn error(&self) -> f64 {
        if self.turnover > 0.0 { self.missing.abs() / self.turnover } else { self.missing.abs() }
    }

    /// Adds powers [gas, masses, load, damping] that act for a time.
    pub(crate) fn add(&mut self, time: f64, powers: [f64; 4]) {
        let [gas, masses, load, damping] = powers;
        self.gas += time * gas;
        self.masses += time * masses;
        self.load += time * load;
        self.damping += time * damping;
        self.turnover += time * powers.iter().map(|power| power.abs()).sum::<f64>();
    }

    /// With the change of energy, and so with what is missing.
    pub(crate) fn closed(self, change: f64) -> ChainEnergy {
        let missing = self.gas + self.masses - self.load - self.damping - change;
        ChainEnergy { change, missing, ..self }
    }
}
