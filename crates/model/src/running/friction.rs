//! Friction of the engine: the file's `[friction]`.

use serde::Serialize;

/// Friction as a mean effective pressure. Its constants come with the engine; none is built in.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum Friction {
    /// The same at every speed and load.
    Given {
        /// Mean effective pressure [Pa].
        fmep: f64,
    },
    /// Chen and Flynn's form, SAE 650733, book, eq. 24.8.
    ChenFlynn {
        /// `A` [Pa].
        constant: f64,
        /// `B` [1]: share of the highest cylinder pressure (absolute).
        peak_pressure: f64,
        /// `C` [Pa s/m]: by mean piston speed.
        speed: f64,
        /// `D` [Pa s^2/m^2]: by its square.
        speed_squared: f64,
    },
}
