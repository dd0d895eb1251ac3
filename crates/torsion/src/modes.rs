//! Free undamped vibration.

use crate::chain::Chain;
use crate::error::TorsionError;
use lanchester_numerics::SymmetricEigen;
use serde::Serialize;

/// A natural mode of the undamped chain.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Mode {
    /// Natural angular frequency [rad/s].
    pub frequency: f64,
    /// Angles of the stations at their own speeds, the largest 1.
    pub shape: Vec<f64>,
    /// Moment of inertia in this mode, of the shape as it stands [kg m^2].
    pub inertia: f64,
    /// Nodes: changes of sign of the referred angle along the shafts.
    pub nodes: usize,
}

impl Mode {
    /// Natural frequency [Hz].
    pub fn hertz(&self) -> f64 {
        self.frequency / std::f64::consts::TAU
    }
}

/// Share of the stiffest shaft's frequency squared below which a mode is rigid.
const RIGID: f64 = 1e-12;

/// Natural modes of the undamped chain while the reference turns at `speed` [rad/s] (which pendulums feel), rising; rigid turning is left out.
///
/// ```text
/// (K - w^2 J) phi = 0,    A = J^-1/2 K J^-1/2 symmetric                                                                       (50.2)
/// ```
///
/// # Errors
/// Where numbers overflow.
pub fn modes(chain: &Chain, speed: f64) -> Result<Vec<Mode>, TorsionError> {
    let n = chain.stations().len();
    let root: Vec<f64> = (0..n).map(|i| chain.referred_inertia(i).sqrt()).collect();
    let mut matrix = vec![0.0; n * n];
    for (index, shaft) in chain.shafts().iter().enumerate() {
        let k = chain.referred_stiffness(index, speed);
        let (i, j) = (shaft.from.min(shaft.to), shaft.from.max(shaft.to));
        matrix[i * n + i] += k / (root[i] * root[i]);
        matrix[j * n + j] += k / (root[j] * root[j]);
        matrix[i * n + j] -= k / (root[i] * root[j]);
    }
    let largest = (0..n).map(|i| matrix[i * n + i]).fold(0.0, f64::max);
    let eigen = SymmetricEigen::new(n, matrix).ok_or(TorsionError::Number {
        quantity: "stiffness over inertia [1/s2]",
        needed: "a finite number",
        got: f64::NAN,
    })?;
    let mut found = Vec::with_capacity(n);
    for (k, value) in eigen.values.iter().enumerate().filter(|(_, value)| **value > RIGID * largest) {
        let own = |i: usize| eigen.vectors[k * n + i] / root[i] * chain.stations()[i].ratio;
        let peak =
            (0..n).map(own).fold(0.0, |peak: f64, value| if value.abs() > peak.abs() { value } else { peak });
        let shape: Vec<f64> = (0..n).map(|i| own(i) / peak).collect();
        let referred = |i: usize| shape[i] / chain.stations()[i].ratio;
        found.push(Mode {
            frequency: value.sqrt(),
            inertia: (0..n).map(|i| chain.stations()[i].inertia * shape[i] * shape[i]).sum(),
            nodes: chain
                .shafts()
                .iter()
                .filter(|shaft| referred(shaft.from) * referred(shaft.to) < 0.0)
                .count(),
            shape,
        });
    }
    Ok(found)
}
