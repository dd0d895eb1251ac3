//! The gas of an engine file as states of a graph.

use super::request::{EngineGraphError, GasStates, GasValve, GasWalls, WallCoefficient, WallLaw};
use crate::curve::Curve;
use crate::unit::Unit;
use lanchester_model::{
    CrankcasePressure, Engine, Fuel, FuelSupply, GasProcess, GasSource, HeatRelease, Opening, OpeningShape,
    Reservoir, SingleZone, WallModel, Walls,
};
use std::f64::consts::{PI, TAU};

/// Longest piece of a table over the angle [rad].
const PIECE: f64 = PI / 360.0;

impl GasStates {
    /// What `[gas]` with a single-zone cycle says: reservoirs, valves, heat release, walls.
    ///
    /// # Errors
    /// [`EngineGraphError::Gas`] where the file has no such cycle, ports instead of valves, pistons that share a chamber, or a crankcase
    /// that is measured.
    pub fn of(engine: &Engine) -> Result<GasStates, EngineGraphError> {
        let refuse = |needed: &'static str| EngineGraphError::Gas { needed };
        let gas = engine.gas.as_ref().ok_or(refuse("a [gas] in the file"))?;
        let GasSource::Cycle(cycle) = &gas.source else {
            return Err(refuse("a computed cycle, [gas.cycle] type = \"single-zone\""));
        };
        let GasProcess::SingleZone(zone) = &cycle.process else {
            return Err(refuse("[gas.cycle] type = \"single-zone\""));
        };
        let CrankcasePressure::Constant { pressure: crankcase } = gas.crankcase else {
            return Err(refuse("a constant pressure under the pistons"));
        };
        if (0..engine.cylinders.len()).any(|index| engine.chamber_pistons(index).len() > 1) {
            return Err(refuse("a chamber of its own for every piston"));
        }
        let turns = TAU * f64::from(engine.strokes.revolutions());
        let release = match &zone.combustion {
            None => None,
            Some(combustion) => {
                let heat = match combustion.fuel.supply {
                    FuelSupply::Energy { energy } => energy * combustion.fuel.efficiency,
                    FuelSupply::Mixture { .. } => 1.0,
                };
                let ends =
                    combustion.stages.iter().flat_map(|stage| [stage.start, stage.start + stage.duration]);
                let rate = |psi: f64| {
                    let both = [psi, psi - turns]
                        .map(|psi| -> f64 { combustion.stages.iter().map(|stage| wiebe(stage, psi)).sum() });
                    heat * (both[0] + both[1])
                };
                let unit = match combustion.fuel.supply {
                    FuelSupply::Energy { .. } => Unit::JOULE,
                    FuelSupply::Mixture { .. } => Unit::NONE,
                };
                Some(
                    over_the_cycle(turns, ends.collect(), unit, rate)
                        .ok_or(refuse("a finite heat release"))?,
                )
            }
        };
        let valve = |opening: &Opening, side: Reservoir| -> Result<GasValve, EngineGraphError> {
            let area = area(opening, turns)
                .ok_or(refuse("valves or areas that open and close at angles, no ports"))?;
            Ok(GasValve { pressure: side.pressure, temperature: side.temperature, area })
        };
        Ok(GasStates {
            gas_constant: cycle.gas_constant,
            heat_capacity: cycle.gas_constant / (cycle.heat_capacity_ratio - 1.0),
            compression_ratio: cycle.compression_ratio,
            crankcase,
            start: [cycle.intake.pressure, cycle.intake.temperature],
            intake: valve(&zone.intake, cycle.intake)?,
            exhaust: valve(&zone.exhaust, cycle.exhaust)?,
            release,
            heat_per_fresh: zone.combustion.as_ref().and_then(|combustion| heat_per_fresh(&combustion.fuel)),
            closes: closing(zone),
            losses: zone
                .walls
                .as_ref()
                .filter(|walls| body(walls).is_none())
                .map(|walls| losses(walls, zone, turns).ok_or(refuse("finite factors of its walls")))
                .transpose()?,
            walls: zone.walls.as_ref().and_then(body),
        })
    }
}

/// The body that takes heat by a conductance; one without a temperature starts with that of the surroundings.
fn body(walls: &Walls) -> Option<GasWalls> {
    let WallModel::Conductance(body) = &walls.model else { return None };
    Some(GasWalls {
        gas_to_body: walls.factor * body.conductance,
        body_capacity: body.capacity,
        body_to_ambient: body.to_ambient,
        ambient: body.ambient,
        start: body.temperature.unwrap_or(body.ambient),
    })
}

/// Heat of a kilogram of fresh air with its fuel [J/kg]: what has no air does not burn.
fn heat_per_fresh(fuel: &Fuel) -> Option<f64> {
    match fuel.supply {
        FuelSupply::Energy { .. } => None,
        FuelSupply::Mixture { equivalence_ratio, air_fuel_ratio, heating_value } => {
            Some(equivalence_ratio.min(1.0) / air_fuel_ratio * heating_value * fuel.efficiency)
        }
    }
}

/// Angles at which an opening begins and ends [rad].
fn open(opening: &Opening) -> [f64; 2] {
    match opening.shape {
        OpeningShape::Valve { closes, .. } | OpeningShape::Area { closes, .. } => [opening.opens, closes],
        OpeningShape::Port { .. } => [opening.opens, opening.opens],
    }
}

/// Angle at which the cylinder closes [rad].
fn closing(zone: &SingleZone) -> f64 {
    open(&zone.intake)[1].max(open(&zone.exhaust)[1])
}

/// Walls of the file; Woschni's factors are steps over the angle.
fn losses(walls: &Walls, zone: &SingleZone, turns: f64) -> Option<WallLaw> {
    let coefficient = match &walls.model {
        WallModel::Conductance(_) => return None,
        WallModel::Hohenberg => WallCoefficient::Hohenberg,
        WallModel::Constant { coefficient } => {
            WallCoefficient::Given(steps(&[(0.0, *coefficient)], turns, COEFFICIENT)?)
        }
        WallModel::Table { angles, coefficients } => {
            let mut points: Vec<[f64; 2]> =
                angles.iter().zip(coefficients).map(|(angle, value)| [*angle, *value]).collect();
            points.push([angles.first()? + turns, *coefficients.first()?]);
            WallCoefficient::Given(Curve::straight(&points, true, [Unit::NONE, COEFFICIENT])?)
        }
        WallModel::Woschni => {
            let valves = [open(&zone.intake), open(&zone.exhaust)];
            let start = closing(zone) - turns;
            let stages = zone.combustion.iter().flat_map(|combustion| &combustion.stages);
            let ignition = stages.map(|stage| stage.start).fold(f64::INFINITY, f64::min);
            let mut places: Vec<f64> = valves.iter().flatten().copied().chain([ignition]).collect();
            places.retain(|place| place.is_finite());
            for place in &mut places {
                *place = place.rem_euclid(turns);
            }
            places.push(0.0);
            places.sort_by(f64::total_cmp);
            places.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
            let factors = |k: usize| {
                let next = places.get(k + 1).copied().unwrap_or(turns);
                let middle = start + (0.5 * (places[k] + next) - start).rem_euclid(turns);
                let is_open = valves.iter().any(|[from, to]| (middle - from).rem_euclid(turns) < to - from);
                match (is_open, middle > ignition) {
                    (true, _) => [6.18, 0.0],
                    (false, false) => [2.28, 0.0],
                    (false, true) => [2.28, 3.24e-3],
                }
            };
            let of = |which: usize, unit: Unit| {
                let values: Vec<(f64, f64)> =
                    (0..places.len()).map(|k| (places[k], factors(k)[which])).collect();
                steps(&values, turns, unit)
            };
            let phases = Box::new([of(0, Unit::NONE)?, of(1, Unit::of([1, 0, -1, 0, -1]))?]);
            WallCoefficient::Woschni { phases }
        }
    };
    Some(WallLaw {
        coefficient,
        factor: walls.factor,
        temperatures: [walls.piston_temperature, walls.head_temperature, walls.liner_temperature],
        areas: [walls.piston_area, walls.head_area],
    })
}

/// W/(m^2 K).
const COEFFICIENT: Unit = Unit::of([0, 1, -3, 0, -1]);

/// Steps over one cycle: where each begins, and its value.
fn steps(values: &[(f64, f64)], turns: f64, unit: Unit) -> Option<Curve> {
    let pieces: Vec<(f64, [f64; 4])> =
        values.iter().map(|(start, value)| (*start, [*value, 0.0, 0.0, 0.0])).collect();
    Curve::cubics(&pieces, turns, true, [Unit::NONE, unit])
}

/// Share of the heat of a stage that is released in a radian: Wiebe's function, complete at its end.
fn wiebe(stage: &HeatRelease, psi: f64) -> f64 {
    let y = (psi - stage.start) / stage.duration;
    if !(0.0..=1.0).contains(&y) {
        return 0.0;
    }
    let a = -(1.0 - stage.completeness).ln();
    let m = stage.exponent;
    stage.share / stage.completeness * a * (m + 1.0) / stage.duration
        * y.powf(m)
        * (-a * y.powf(m + 1.0)).exp()
}

/// Effective area of valves over the angle [m^2]; none for ports.
fn area(opening: &Opening, turns: f64) -> Option<Curve> {
    let unit = Unit::of([2, 0, 0, 0, 0]);
    let opens = opening.opens;
    let (closes, mut kinks) = match opening.shape {
        OpeningShape::Valve { closes, .. } | OpeningShape::Area { closes, .. } => {
            (closes, vec![opens, closes])
        }
        OpeningShape::Port { .. } => return None,
    };
    if let OpeningShape::Valve { lift, diameter, .. } = opening.shape
        && lift > diameter / 4.0
    {
        // From there on the seat's circle is the narrowest place.
        let at = (diameter / (4.0 * lift)).sqrt().asin() / PI * (closes - opens);
        kinks.extend([opens + at, closes - at]);
    }
    let shape = opening.shape;
    let coefficient = opening.discharge_coefficient;
    over_the_cycle(turns, kinks, unit, move |psi| {
        let since = (psi - opens).rem_euclid(turns);
        if since > closes - opens {
            return 0.0;
        }
        let share = (PI * since / (closes - opens)).sin().powi(2);
        coefficient
            * match shape {
                OpeningShape::Valve { lift, diameter, number, .. } => {
                    f64::from(number) * PI * diameter * (lift * share).min(diameter / 4.0)
                }
                OpeningShape::Area { area, .. } | OpeningShape::Port { area } => area * share,
            }
    })
}

/// A function of the angle as cubics over one cycle, with its own slopes at the ends of each piece; kinks lie between pieces.
fn over_the_cycle(turns: f64, kinks: Vec<f64>, unit: Unit, of: impl Fn(f64) -> f64) -> Option<Curve> {
    let mut places: Vec<f64> = kinks.into_iter().map(|kink| kink.rem_euclid(turns)).collect();
    places.extend([0.0, turns]);
    places.sort_by(f64::total_cmp);
    places.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    let mut pieces = Vec::new();
    for pair in places.windows(2) {
        let count = ((pair[1] - pair[0]) / PIECE).ceil().max(1.0);
        let h = (pair[1] - pair[0]) / count;
        for k in 0..count as usize {
            let start = pair[0] + h * k as f64;
            // A hair inside, so that the values are those of this side of a kink.
            let inside = |share: f64| of(start + h * share.clamp(1e-9, 1.0 - 1e-9));
            let e = 1e-3;
            let slope = |at: f64, way: f64| {
                let [a, b, c] = [0.0, 1.0, 2.0].map(|step| inside(at + way * step * e));
                way * (4.0 * b - 3.0 * a - c) / (2.0 * e * h)
            };
            let (a, end) = (inside(0.0), inside(1.0));
            let (b, last) = (slope(0.0, 1.0), slope(1.0, -1.0));
            let rise = (end - a) / h;
            pieces
                .push((start, [a, b, (3.0 * rise - 2.0 * b - last) / h, (b + last - 2.0 * rise) / (h * h)]));
        }
    }
    Curve::cubics(&pieces, turns, true, [Unit::NONE, unit])
}
