//! Quantities over time or angle, with their names and units.

use serde::Serialize;

/// One quantity over the samples of a run.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Series {
    /// Its name: `crank.momentum`.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Its values.
    pub values: Vec<f64>,
}

/// Values of the quantity of this name, where there is one.
pub fn values_of<'a>(series: &'a [Series], name: &str) -> Option<&'a [f64]> {
    series.iter().find(|series| series.name == name).map(|series| series.values.as_slice())
}
