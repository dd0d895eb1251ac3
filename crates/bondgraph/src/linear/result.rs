//! What a linear graph is made of.

use serde::Serialize;

/// Operations that an entry of A, B, C or D comes from; each rounds.
pub(crate) const ROUNDINGS: f64 = 8.0;

/// A linear graph.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Linear {
    /// Version of this structure.
    pub version: u32,
    /// States.
    pub states: Vec<String>,
    /// Inputs: the sources.
    pub inputs: Vec<String>,
    /// Outputs: what was asked for; else flow of every inertia, effort of every capacitor, and every signal.
    pub outputs: Vec<String>,
    /// A, row by row.
    pub a: Vec<Vec<f64>>,
    /// B.
    pub b: Vec<Vec<f64>>,
    /// C.
    pub c: Vec<Vec<f64>>,
    /// D.
    pub d: Vec<Vec<f64>>,
    /// Poles, the slowest first.
    pub poles: Vec<Pole>,
    /// From each input to each output.
    pub transfer: Vec<Transfer>,
}

/// A pole.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Pole {
    /// Real part [1/s].
    pub real: f64,
    /// Imaginary part [rad/s].
    pub imaginary: f64,
    /// Absolute value [rad/s].
    pub frequency: f64,
    /// Damping ratio.
    pub damping: f64,
    /// Its natural frequency [Hz].
    pub hertz: f64,
}

/// A transfer function; coefficients of rising powers of s.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Transfer {
    /// Input.
    pub input: String,
    /// Output.
    pub output: String,
    /// Numerator.
    pub numerator: Vec<f64>,
    /// Denominator, the highest coefficient 1.
    pub denominator: Vec<f64>,
}
