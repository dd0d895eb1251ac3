//! Gas in the cylinders and under the pistons: measured traces or a cycle to be computed, the file's `[gas]`.
//!
//! Angles count from a cylinder's own firing top dead centre in its crankshaft's sense of rotation; pressures are absolute.

use serde::Serialize;

/// One standard atmosphere [Pa].
pub const ATMOSPHERE: f64 = 101_325.0;

/// The gas of an engine.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Gas {
    /// Pressure of the surroundings [Pa]: gauge pressures count from it.
    pub ambient_pressure: f64,
    /// Where the pressure in the cylinders comes from.
    pub source: GasSource,
    /// Pressure under the pistons.
    pub crankcase: CrankcasePressure,
}

impl Gas {
    /// Largest over smallest volume of a cylinder, where it is known.
    pub fn compression_ratio(&self) -> Option<f64> {
        match &self.source {
            GasSource::Traces { compression_ratio, .. } => *compression_ratio,
            GasSource::Cycle(cycle) => Some(cycle.compression_ratio),
        }
    }
}

/// Where the pressure in the cylinders comes from.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum GasSource {
    /// Measured traces, one file a speed.
    Traces {
        /// The files, in the order of the engine file.
        traces: Vec<PressureTrace>,
        /// Largest over smallest volume, where it is known.
        compression_ratio: Option<f64>,
    },
    /// A cycle to be computed.
    Cycle(GasCycle),
}

/// A file with pressures over the crank angle.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PressureTrace {
    /// Name of the file, relative to the engine file.
    pub file: String,
    /// Speed of crankshaft 1 at which it was measured [rad/s]; `None`: it holds for all speeds.
    pub speed: Option<f64>,
    /// Whether its pressures count from that of the surroundings.
    pub gauge: bool,
    /// Angle of the file at which the cylinder (or cylinder 1) is at its firing top dead centre [rad].
    pub top_dead_centre: f64,
    /// Whether all its columns count from the firing of cylinder 1, not each from that of its own cylinder.
    pub counted_from_first: bool,
}

/// Pressure under the pistons.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum CrankcasePressure {
    /// The same at all angles [Pa].
    Constant {
        /// Absolute pressure [Pa].
        pressure: f64,
    },
    /// Measured.
    Trace(PressureTrace),
}

/// A cycle to be computed, the same for all cylinders.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct GasCycle {
    /// Largest over smallest volume of a cylinder, more than 1.
    pub compression_ratio: f64,
    /// Ratio of the specific heats, more than 1.
    pub heat_capacity_ratio: f64,
    /// Gas constant [J/(kg K)].
    pub gas_constant: f64,
    /// State of the gas before the intake valve; of a closed cylinder at bottom dead centre.
    pub intake: Reservoir,
    /// State of the gas behind the exhaust valve.
    pub exhaust: Reservoir,
    /// What happens to the gas.
    pub process: GasProcess,
}

/// Gas of constant state.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Reservoir {
    /// Absolute pressure [Pa].
    pub pressure: f64,
    /// Temperature [K].
    pub temperature: f64,
}

/// What happens to the gas.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum GasProcess {
    /// Heat at constant volume.
    Otto {
        /// How much of it.
        heat: IdealHeat,
    },
    /// Heat at constant pressure.
    Diesel {
        /// How much of it.
        fuel: Fuel,
    },
    /// Heat at constant volume, then at constant pressure.
    Seiliger {
        /// How much of it.
        fuel: Fuel,
        /// How it is divided.
        split: HeatSplit,
    },
    /// A closed cylinder without valves and heat: `p V^n` stays the same, with the ratio of the specific heats as `n`.
    Sealed,
    /// One zone with valves, heat release and heat to the walls.
    SingleZone(Box<SingleZone>),
}

/// Heat of the Otto cycle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum IdealHeat {
    /// That of the fuel.
    Fuel(Fuel),
    /// What leads to this pressure.
    PeakPressure {
        /// Absolute pressure [Pa].
        pressure: f64,
    },
}

/// How the heat of the Seiliger cycle is divided.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum HeatSplit {
    /// Constant volume up to this pressure.
    PeakPressure {
        /// Absolute pressure [Pa].
        pressure: f64,
    },
    /// This share of the heat at constant volume.
    ConstantVolumeShare {
        /// From 0 to 1.
        share: f64,
    },
}

/// Energy that is released in one cylinder in one cycle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Fuel {
    /// How much of it there is.
    pub supply: FuelSupply,
    /// Share of the chemical energy that is released.
    pub efficiency: f64,
}

/// How the chemical energy is given.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum FuelSupply {
    /// The energy itself.
    Energy {
        /// In one cylinder and cycle [J].
        energy: f64,
    },
    /// By the fresh air that the cylinder holds.
    Mixture {
        /// Fuel over air, divided by that of complete combustion.
        equivalence_ratio: f64,
        /// Air over fuel of complete combustion, by mass.
        air_fuel_ratio: f64,
        /// Lower heating value [J/kg].
        heating_value: f64,
    },
}

/// Single-zone filling and emptying.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SingleZone {
    /// Intake valves or ports.
    pub intake: Opening,
    /// Exhaust valves or ports.
    pub exhaust: Opening,
    /// What burns; `None`: the engine is motored.
    pub combustion: Option<Combustion>,
    /// Heat to the walls; `None`: adiabatic.
    pub walls: Option<Walls>,
}

/// Valves or ports to one reservoir.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Opening {
    /// Angle at which it begins to open [rad], from 0 up to the length of the cycle.
    pub opens: f64,
    /// Share of the geometric area through which the flow passes.
    pub discharge_coefficient: f64,
    /// Its geometric area.
    pub shape: OpeningShape,
}

/// Geometric area of an opening.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum OpeningShape {
    /// Poppet valves: the curtain under the head, at most the seat's circle; the lift is `L sin^2` over the angle.
    Valve {
        /// Angle at which it is closed [rad], beyond that at which it opens by less than a cycle.
        closes: f64,
        /// Largest lift [m].
        lift: f64,
        /// Diameter of the seat [m].
        diameter: f64,
        /// How many there are in a cylinder.
        number: u32,
        /// Distance of the closed valve from the piston at top dead centre, along the cylinder axis [m].
        piston_clearance: Option<f64>,
    },
    /// A given area: `A sin^2` over the angle.
    Area {
        /// Angle at which it is closed [rad], beyond that at which it opens by less than a cycle.
        closes: f64,
        /// Largest area [m^2].
        area: f64,
    },
    /// Ports of constant width in the cylinder wall, which the piston uncovers and covers again.
    Port {
        /// Area at bottom dead centre [m^2].
        area: f64,
    },
}

/// What burns, and when.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Combustion {
    /// How much of it.
    pub fuel: Fuel,
    /// Wiebe functions; their shares add up to 1.
    pub stages: Vec<HeatRelease>,
}

/// Heat release by one Wiebe function, scaled to be complete at its end.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct HeatRelease {
    /// Share of the whole heat.
    pub share: f64,
    /// Angle at which it begins [rad], negative before top dead centre.
    pub start: f64,
    /// Angle over which it lasts [rad].
    pub duration: f64,
    /// Exponent `m`.
    pub exponent: f64,
    /// Share that the unscaled function would have released at its end: `1 - exp(-a)`.
    pub completeness: f64,
}

/// Heat to the walls.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Walls {
    /// Whose heat transfer coefficient.
    pub model: WallModel,
    /// Factor on the coefficient.
    pub factor: f64,
    /// Temperature of the piston's crown [K].
    pub piston_temperature: f64,
    /// Temperature of the head [K].
    pub head_temperature: f64,
    /// Temperature of the liner [K].
    pub liner_temperature: f64,
    /// Area of the crown over that of the bore.
    pub piston_area: f64,
    /// Area of the head over that of the bore.
    pub head_area: f64,
}

/// Whose heat transfer coefficient.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum WallModel {
    /// Woschni 1967.
    Woschni,
    /// Hohenberg 1979.
    Hohenberg,
    /// The same at every angle.
    Constant {
        /// Heat transfer coefficient [W/(m^2 K)].
        coefficient: f64,
    },
    /// Given over the angle since firing top dead centre, straight between its points, repeating after a cycle.
    Table {
        /// Angles [rad], rising, within one cycle.
        angles: Vec<f64>,
        /// Heat transfer coefficients [W/(m^2 K)], one an angle.
        coefficients: Vec<f64>,
    },
    /// No coefficient and no area: a conductance from the gas of every cylinder to the body of the engine, which gives heat to the surroundings.
    Conductance(WallBody),
}

/// The body of the engine as a store of heat that all cylinders share.
///
/// ```text
/// Q_gas = G (T - T_b)        C T_b' = SUM of Q_gas - G_a (T_b - T_a)
/// ```
/// Source: Singh 2017, eq. 3.38.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct WallBody {
    /// Conductance `G` from the gas of one cylinder to the body [W/K].
    pub conductance: f64,
    /// Heat capacity `C` of the body [J/K].
    pub capacity: f64,
    /// Conductance `G_a` from the body to the surroundings [W/K].
    pub to_ambient: f64,
    /// Temperature `T_a` of the surroundings [K].
    pub ambient: f64,
    /// Temperature `T_b` of the body [K], at the start of a run in which it changes; `None`: the one at which it settles, where as much heat leaves it
    /// as comes.
    pub temperature: Option<f64>,
}
