//! What gas and friction have to keep: the signs that the keys of the file have, and finite numbers.

use crate::fault::{Fault, Part};
use crate::running::friction::Friction;
use crate::running::gas::{
    Combustion, CrankcasePressure, Fuel, FuelSupply, Gas, GasCycle, GasProcess, GasSource, HeatSplit,
    IdealHeat, Opening, OpeningShape, PressureTrace, Reservoir, WallModel, Walls,
};

/// Faults of the gas.
pub(crate) fn of_gas(gas: &Gas, faults: &mut Vec<Fault>) {
    let part = &mut Part { faults, name: &|| "gas".into() };
    part.positive("ambient_pressure [Pa]", gas.ambient_pressure);
    if let Some(ratio) = gas.compression_ratio()
        && !(ratio > 1.0 && ratio.is_finite())
    {
        part.add("compression_ratio", "more than 1", ratio, "it is the largest volume over the smallest");
    }
    match &gas.source {
        GasSource::Traces { traces, .. } => {
            if traces.is_empty() {
                part.add("traces", "one or more", 0, "name a file with the pressures, or give a cycle");
            }
            traces.iter().for_each(|trace| of_trace(trace, part));
        }
        GasSource::Cycle(cycle) => of_cycle(cycle, part),
    }
    match &gas.crankcase {
        CrankcasePressure::Constant { pressure } => part.positive("crankcase pressure [Pa]", *pressure),
        CrankcasePressure::Trace(trace) => of_trace(trace, part),
    }
}

/// Faults of the friction.
pub(crate) fn of_friction(friction: &Friction, faults: &mut Vec<Fault>) {
    let part = &mut Part { faults, name: &|| "friction".into() };
    match *friction {
        Friction::Given { fmep } => part.not_negative("fmep [Pa]", fmep),
        Friction::ChenFlynn { constant, peak_pressure, speed, speed_squared } => {
            part.not_negative("constant [Pa]", constant);
            part.not_negative("peak_pressure", peak_pressure);
            part.not_negative("speed [Pa s/m]", speed);
            part.not_negative("speed_squared [Pa s^2/m^2]", speed_squared);
        }
    }
}

fn of_trace(trace: &PressureTrace, part: &mut Part<'_>) {
    trace.speed.iter().for_each(|speed| part.positive("speed of a trace [rad/s]", *speed));
    part.finite("top_dead_centre of a trace [rad]", trace.top_dead_centre);
}

fn of_cycle(cycle: &GasCycle, part: &mut Part<'_>) {
    let ratio = cycle.heat_capacity_ratio;
    if !(ratio > 1.0 && ratio.is_finite()) {
        part.add(
            "heat_capacity_ratio",
            "more than 1",
            ratio,
            "it is that at constant pressure over that at constant volume",
        );
    }
    part.positive("gas_constant [J/(kg K)]", cycle.gas_constant);
    for Reservoir { pressure, temperature } in [cycle.intake, cycle.exhaust] {
        part.positive("pressure before or behind the valves [Pa]", pressure);
        part.positive("temperature before or behind the valves [K]", temperature);
    }
    match &cycle.process {
        GasProcess::Otto { heat: IdealHeat::Fuel(fuel) } | GasProcess::Diesel { fuel } => of_fuel(fuel, part),
        GasProcess::Otto { heat: IdealHeat::PeakPressure { pressure } } => {
            part.positive("peak pressure [Pa]", *pressure);
        }
        GasProcess::Seiliger { fuel, split } => {
            of_fuel(fuel, part);
            match *split {
                HeatSplit::PeakPressure { pressure } => part.positive("peak pressure [Pa]", pressure),
                HeatSplit::ConstantVolumeShare { share } => of_share("constant-volume share", share, part),
            }
        }
        GasProcess::Sealed => {}
        GasProcess::SingleZone(zone) => {
            of_opening(&zone.intake, part);
            of_opening(&zone.exhaust, part);
            zone.combustion.iter().for_each(|combustion| of_combustion(combustion, part));
            zone.walls.iter().for_each(|walls| of_walls(walls, part));
        }
    }
}

fn of_share(quantity: &'static str, share: f64, part: &mut Part<'_>) {
    if !(0.0..=1.0).contains(&share) {
        part.add(quantity, "from 0 to 1", share, "give the share of the whole");
    }
}

fn of_fuel(fuel: &Fuel, part: &mut Part<'_>) {
    of_share("efficiency of the combustion", fuel.efficiency, part);
    match fuel.supply {
        FuelSupply::Energy { energy } => part.not_negative("energy [J]", energy),
        FuelSupply::Mixture { equivalence_ratio, air_fuel_ratio, heating_value } => {
            part.not_negative("equivalence_ratio", equivalence_ratio);
            part.positive("air_fuel_ratio", air_fuel_ratio);
            part.positive("heating_value [J/kg]", heating_value);
        }
    }
}

fn of_opening(opening: &Opening, part: &mut Part<'_>) {
    part.finite("opens [rad]", opening.opens);
    part.not_negative("discharge_coefficient", opening.discharge_coefficient);
    match opening.shape {
        OpeningShape::Valve { closes, lift, diameter, number, piston_clearance } => {
            part.finite("closes [rad]", closes);
            part.not_negative("lift [m]", lift);
            part.positive("diameter [m]", diameter);
            if number == 0 {
                part.add(
                    "number of valves",
                    "1 or more",
                    number,
                    "leave the opening out, or give its valves",
                );
            }
            piston_clearance.iter().for_each(|own| part.finite("piston_clearance [m]", *own));
        }
        OpeningShape::Area { closes, area } => {
            part.finite("closes [rad]", closes);
            part.not_negative("area [m^2]", area);
        }
        OpeningShape::Port { area } => part.not_negative("area [m^2]", area),
    }
}

fn of_combustion(combustion: &Combustion, part: &mut Part<'_>) {
    of_fuel(&combustion.fuel, part);
    for stage in &combustion.stages {
        of_share("share of a heat release", stage.share, part);
        part.finite("start of a heat release [rad]", stage.start);
        part.positive("duration of a heat release [rad]", stage.duration);
        part.not_negative("exponent of a heat release", stage.exponent);
        of_share("completeness of a heat release", stage.completeness, part);
    }
}

fn of_walls(walls: &Walls, part: &mut Part<'_>) {
    part.not_negative("factor of the walls", walls.factor);
    for temperature in [walls.piston_temperature, walls.head_temperature, walls.liner_temperature] {
        part.positive("temperature of the walls [K]", temperature);
    }
    for area in [walls.piston_area, walls.head_area] {
        part.not_negative("area of the walls over that of the bore", area);
    }
    match &walls.model {
        WallModel::Woschni | WallModel::Hohenberg => {}
        WallModel::Constant { coefficient } => part.not_negative("coefficient [W/(m^2 K)]", *coefficient),
        WallModel::Table { angles, coefficients } => {
            angles.iter().for_each(|angle| part.finite("angles [rad]", *angle));
            coefficients.iter().for_each(|own| part.not_negative("coefficients [W/(m^2 K)]", *own));
            if angles.len() != coefficients.len() {
                let needed = format!("{}, one an angle", angles.len());
                part.add("number of coefficients", needed, coefficients.len(), "give one an angle");
            }
        }
        WallModel::Conductance(body) => {
            part.not_negative("conductance [W/K]", body.conductance);
            part.positive("capacity [J/K]", body.capacity);
            part.not_negative("to_ambient [W/K]", body.to_ambient);
            part.positive("ambient [K]", body.ambient);
            body.temperature.iter().for_each(|own| part.positive("temperature of the body [K]", *own));
        }
    }
}
