//! Ideal cycles of a perfect gas on the exact volume of the engine's own mechanism: Otto, Diesel, Seiliger, and a closed cylinder.
//!
//! Compression and expansion are isentropic, heat is released at top dead centre, valves open and close at dead centres and pressures level
//! at once. The cylinder holds fresh gas alone, of the state before the intake. A closed cylinder is compressed and expands in every revolution. (Book, eqs. 28.2 to 28.7; [Heywood1988] ch. 5.)

use crate::error::CycleError;
use crate::pieces::Pieces;
use crate::volume::CylinderVolume;
use lanchester_model::{Fuel, FuelSupply, GasCycle, GasProcess, HeatSplit, IdealHeat};
use lanchester_results::{End, PeriodicCurve};
use serde::Serialize;
use std::f64::consts::TAU;

/// An ideal cycle.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct IdealCycle {
    /// Absolute pressure [Pa] over the angle since firing top dead centre.
    #[serde(skip)]
    pub pressure: PeriodicCurve,
    /// Mass of the gas [kg].
    pub mass: f64,
    /// Heat of a cycle [J].
    pub heat: f64,
    /// Share of the heat at constant volume.
    pub constant_volume_share: f64,
    /// Angle at which heat at constant pressure ends [rad]; 0 without.
    pub cut_off_angle: f64,
    /// Start of compression, its end, after heat at constant volume, after heat at constant pressure, end of expansion.
    pub states: [GasState; 5],
    /// Work of the closed part over the heat: `1 - (T_5 - T_1)/(heat/(m c_v))`; 0 without heat.
    pub efficiency: f64,
    /// Work of the closed part [J], from the temperatures.
    pub closed_work: f64,
}

/// A state of the gas.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct GasState {
    /// Pressure [Pa].
    pub pressure: f64,
    /// Volume [m^3].
    pub volume: f64,
    /// Temperature [K].
    pub temperature: f64,
}

/// Energy that the fuel releases [J] beside `air` kilograms of fresh air.
pub(crate) fn released(fuel: &Fuel, air: f64) -> f64 {
    let energy = match fuel.supply {
        FuelSupply::Energy { energy } => energy,
        FuelSupply::Mixture { equivalence_ratio, air_fuel_ratio, heating_value } => {
            // What has no air does not burn.
            equivalence_ratio.min(1.0) * air / air_fuel_ratio * heating_value
        }
    };
    energy * fuel.efficiency
}

fn refuse<T>(quantity: &'static str, needed: String, got: f64, hint: &'static str) -> Result<T, CycleError> {
    Err(CycleError::Number { quantity, needed, got, hint })
}

/// The ideal cycle of a cylinder.
///
/// # Errors
/// [`CycleError::Number`] where the heat cannot be released as told, [`CycleError::NotIdeal`] for a single zone.
pub fn ideal_cycle(cycle: &GasCycle, volume: &CylinderVolume) -> Result<IdealCycle, CycleError> {
    let gamma = cycle.heat_capacity_ratio;
    let specific_heat = cycle.gas_constant / (gamma - 1.0);
    let [small, large] = [0.0, volume.bottom_angle()].map(|psi| volume.at(psi)[0]);
    let ratio = large / small;
    let [p1, t1] = [cycle.intake.pressure, cycle.intake.temperature];
    let mass = p1 * large / (cycle.gas_constant * t1);
    let capacity = mass * specific_heat;
    let compressed = GasState {
        pressure: p1 * ratio.powf(gamma),
        volume: small,
        temperature: t1 * ratio.powf(gamma - 1.0),
    };
    // Heat at constant volume and at constant pressure [J].
    let rise = |pressure: f64| capacity * compressed.temperature * (pressure / compressed.pressure - 1.0);
    let peak_hint = "the peak pressure lies above the pressure at the end of compression";
    let check_peak = |pressure: f64| {
        if pressure > compressed.pressure {
            return Ok(rise(pressure));
        }
        let needed = format!("more than the {:.4e} Pa that compression alone gives", compressed.pressure);
        refuse("peak pressure [Pa]", needed, pressure, peak_hint)
    };
    let [at_volume, at_pressure] = match &cycle.process {
        GasProcess::Otto { heat: IdealHeat::Fuel(fuel) } => [released(fuel, mass), 0.0],
        GasProcess::Otto { heat: IdealHeat::PeakPressure { pressure } } => [check_peak(*pressure)?, 0.0],
        GasProcess::Diesel { fuel } => [0.0, released(fuel, mass)],
        GasProcess::Seiliger { fuel, split } => {
            let all = released(fuel, mass);
            let at_volume = match split {
                HeatSplit::ConstantVolumeShare { share } => share * all,
                HeatSplit::PeakPressure { pressure } => check_peak(*pressure)?,
            };
            if at_volume > all {
                let needed = format!("at least the {at_volume:.4} J that the peak pressure takes");
                return refuse("heat of a cycle [J]", needed, all, "lower the peak pressure or add fuel");
            }
            [at_volume, all - at_volume]
        }
        GasProcess::Sealed => [0.0, 0.0],
        GasProcess::SingleZone(_) => return Err(CycleError::NotIdeal),
    };
    let heat = at_volume + at_pressure;
    let lifted = compressed.temperature + at_volume / capacity;
    let at_top = GasState {
        pressure: compressed.pressure * lifted / compressed.temperature,
        volume: small,
        temperature: lifted,
    };
    let burned = lifted + at_pressure / (gamma * capacity);
    let cut_off = small * burned / lifted;
    if cut_off >= large {
        let needed = format!("less than {:.4}, so that heat ends before bottom dead centre", ratio);
        return refuse("ratio of the volumes across the heat release", needed, burned / lifted, "less fuel");
    }
    let hot = GasState { pressure: at_top.pressure, volume: cut_off, temperature: burned };
    let expanded = GasState {
        pressure: hot.pressure * (cut_off / large).powf(gamma),
        volume: large,
        temperature: burned * (cut_off / large).powf(gamma - 1.0),
    };
    let start = GasState { pressure: p1, volume: large, temperature: t1 };
    let cut_off_angle = if at_pressure > 0.0 { angle_of(volume, cut_off) } else { 0.0 };
    let closed_work = heat - capacity * (expanded.temperature - t1);

    let isentrope = |state: GasState| {
        move |psi: f64| {
            let [v, rate] = volume.at(psi);
            let value = state.pressure * (state.volume / v).powf(gamma);
            End { value, slope: -gamma * value * rate / v }
        }
    };
    let bottom = volume.bottom_angle();
    let mut pieces = Pieces::default();
    if cut_off_angle > 0.0 {
        pieces.constant(0.0, hot.pressure);
    }
    pieces.smooth(cut_off_angle, bottom, &isentrope(hot));
    if volume.cycle() > TAU {
        if cycle.process == GasProcess::Sealed {
            pieces.smooth(bottom, TAU, &isentrope(start));
            pieces.smooth(TAU, TAU + bottom, &isentrope(start));
        } else {
            pieces.constant(bottom, cycle.exhaust.pressure);
            pieces.constant(TAU, cycle.intake.pressure);
        }
    }
    pieces.smooth(volume.cycle() - TAU + bottom, volume.cycle(), &isentrope(start));
    Ok(IdealCycle {
        pressure: pieces.curve(volume.cycle())?,
        mass,
        heat,
        constant_volume_share: if heat > 0.0 { at_volume / heat } else { 1.0 },
        cut_off_angle,
        states: [start, compressed, at_top, hot, expanded],
        efficiency: if heat > 0.0 { closed_work / heat } else { 0.0 },
        closed_work,
    })
}

/// Angle between the dead centres at which the volume is `wanted` on the way down.
fn angle_of(volume: &CylinderVolume, wanted: f64) -> f64 {
    let (mut low, mut high) = (0.0, volume.bottom_angle());
    // To neighbouring doubles: the volume rises all the way.
    while low + (high - low) / 2.0 > low && low + (high - low) / 2.0 < high {
        let middle = low + (high - low) / 2.0;
        if volume.at(middle)[0] < wanted {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}
