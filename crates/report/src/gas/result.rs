//! What a computed cycle gives, as plain data.

use serde::Serialize;

/// Version of [`CycleResult`]; raised when a field changes its meaning or goes.
pub const CYCLE_RESULT_VERSION: u32 = 1;

/// What a computed cycle gives in one chamber.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CycleResult {
    /// [`CYCLE_RESULT_VERSION`].
    pub version: u32,
    /// Numbers of the cylinders that have it, from 1.
    pub cylinders: Vec<usize>,
    /// Which process: "Otto cycle", "single zone" and so on.
    pub process: String,
    /// Net indicated work of a cycle [J].
    pub work: f64,
    /// Work of compression and expansion [J].
    pub gross_work: f64,
    /// Work of the gas exchange [J], negative where it costs.
    pub exchange_work: f64,
    /// Net indicated mean effective pressure [Pa].
    pub mean_effective_pressure: f64,
    /// Heat released [J].
    pub heat: f64,
    /// Net indicated work over the heat released (indicated thermal efficiency); `None` where it is motored.
    pub thermal_efficiency: Option<f64>,
    /// Net indicated work over the energy of the fuel, what does not burn included (indicated efficiency, fuel conversion efficiency).
    pub indicated_efficiency: Option<f64>,
    /// Mass trapped [kg].
    pub trapped_mass: f64,
    /// Largest pressure [Pa].
    pub peak_pressure: f64,
    /// Its angle after firing top dead centre [rad].
    pub peak_pressure_angle: f64,
    /// Highest temperature [K].
    pub peak_temperature: f64,
    /// Its angle after firing top dead centre [rad].
    pub peak_temperature_angle: f64,
    /// Gas exchange, walls and the integration, where the gas is exchanged over the angle (single zone).
    pub exchange: Option<ExchangeResult>,
    /// Over the angle.
    pub trace: CycleTrace,
}

/// Gas exchange, heat to the walls and the check of the integration.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ExchangeResult {
    /// Fresh mass trapped [kg].
    pub fresh_mass: f64,
    /// Share of the trapped mass that is residual gas.
    pub residual_share: f64,
    /// Temperature when the cylinder closes [K].
    pub trapped_temperature: f64,
    /// Angle at which it closes [rad], negative: before firing.
    pub closing_angle: f64,
    /// Fresh mass taken in over that of the displaced volume at the state before the intake; for two strokes the delivery ratio.
    pub volumetric_efficiency: f64,
    /// Fresh mass trapped over fresh mass taken in.
    pub trapping_efficiency: f64,
    /// Heat to the walls in a cycle [J].
    pub wall_heat: f64,
    /// The same over the heat released; `None` where it is motored.
    pub wall_heat_share: Option<f64>,
    /// Temperature of the body that takes it [K]; `None` where the walls have temperatures that are given.
    pub body_temperature: Option<f64>,
    /// Energy that is missing from the balance of the last cycle [J].
    pub energy_residual: f64,
    /// The same over the largest of what passes.
    pub energy_residual_share: f64,
    /// Mass that is missing from the balance of the last cycle [kg].
    pub mass_residual: f64,
    /// The same over the trapped mass.
    pub mass_residual_share: f64,
    /// Whether the last cycle repeats the one before it.
    pub converged: bool,
    /// Cycles run.
    pub cycles: usize,
}

/// A cycle over the angle since firing top dead centre, equally spaced from 0 to a cycle, end point excluded. Lists are empty where the cycle does not
/// know the quantity: an ideal one knows pressure and volume.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct CycleTrace {
    /// Angle of the own crankshaft since firing top dead centre [rad].
    pub angle: Vec<f64>,
    /// Volume of the chamber [m^3].
    pub volume: Vec<f64>,
    /// Absolute pressure [Pa].
    pub pressure: Vec<f64>,
    /// Temperature [K].
    pub temperature: Vec<f64>,
    /// Mass [kg].
    pub mass: Vec<f64>,
    /// Heat released [J/rad].
    pub heat_release: Vec<f64>,
    /// Heat to the walls [J/rad].
    pub wall_heat: Vec<f64>,
    /// Mass in through the intake [kg/rad], negative: back.
    pub intake: Vec<f64>,
    /// Mass out through the exhaust [kg/rad], negative: back.
    pub exhaust: Vec<f64>,
}
