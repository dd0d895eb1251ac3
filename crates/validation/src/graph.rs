//! What the bond graph of an engine gives: its parameters, the order of its pressure peaks, the rocking of its block.
//!
//! | quantity | what it is |
//! |---|---|
//! | `graph parameter NAME` | a parameter of the graph with its gas as states, in SI units |
//! | `graph heat capacity ratio` | `1 + R/c_v` of its gas |
//! | `graph intake pressure`, `graph intake temperature` | of the reservoir before its intake |
//! | `graph firing order` | numbers of the cylinders in the order of their pressure peaks, written as one number |
//! | `graph rocking` | first order of pitch and yaw of the block on its mounts at the engine's speed, without gas [rad/s] |

use lanchester::bondgraph::{
    Description, EngineBlock, EngineDrive, EngineRequest, Graph, Simulation, SimulationRequest, engine_graph,
    equations,
};
use lanchester::model::Engine;
use lanchester::{BondGraphRequest, engine_bond_graph};
use std::f64::consts::TAU;

/// Revolutions after which the start of the block has died away.
const SETTLED: f64 = 66.0;

/// A quantity of the bond graph.
pub(crate) enum GraphKey {
    Parameter(String),
    HeatCapacityRatio,
    /// Element whose effort it is.
    Source(&'static str),
    FiringOrder,
    Rocking,
}

impl GraphKey {
    /// The quantity of this name; `None` if it is not one of these.
    pub fn parse(text: &str) -> Option<GraphKey> {
        let name = text.strip_prefix("graph ")?;
        if let Some(parameter) = name.strip_prefix("parameter ") {
            return Some(GraphKey::Parameter(parameter.to_owned()));
        }
        Some(match name {
            "heat capacity ratio" => GraphKey::HeatCapacityRatio,
            "intake pressure" => GraphKey::Source("intake_mass_state"),
            "intake temperature" => GraphKey::Source("intake_heat_state"),
            "firing order" => GraphKey::FiringOrder,
            "rocking" => GraphKey::Rocking,
            _ => return None,
        })
    }

    /// Its value.
    pub fn of(&self, engine: &Engine) -> Result<f64, String> {
        match self {
            GraphKey::Parameter(name) => parameter(&with_gas(engine)?, name),
            GraphKey::HeatCapacityRatio => {
                let graph = with_gas(engine)?;
                Ok(1.0 + parameter(&graph, "gas_constant")? / parameter(&graph, "heat_capacity")?)
            }
            GraphKey::Source(name) => {
                let graph = with_gas(engine)?;
                let element = graph.elements.iter().find(|element| element.name.text == *name);
                let effort = element.and_then(|element| element.get("effort")).map(|text| text.text.as_str());
                effort.and_then(number).ok_or_else(|| format!("the graph has no source {name:?}"))
            }
            GraphKey::FiringOrder => firing_order(engine),
            GraphKey::Rocking => rocking(engine),
        }
    }
}

fn with_gas(engine: &Engine) -> Result<Description, String> {
    let request = BondGraphRequest {
        imposed: Some(true),
        block: Some(EngineBlock::Fixed),
        gas_as_states: true,
        ..BondGraphRequest::default()
    };
    engine_bond_graph(engine, &[], &request).map(|found| found.description).map_err(|error| error.to_string())
}

/// The number before the unit.
fn number(text: &str) -> Option<f64> {
    text.split(' ').next()?.parse().ok()
}

fn parameter(graph: &Description, name: &str) -> Result<f64, String> {
    let found = graph.parameters.iter().find(|(known, _)| known.text == name);
    let value = found.and_then(|(_, value)| number(&value.text));
    value.ok_or_else(|| format!("the graph has no parameter {name:?}"))
}

fn run(description: &Description, places: &[f64], tolerance: f64) -> Result<Simulation, String> {
    let told = |mistakes: Vec<lanchester::file::Diagnostic>| {
        mistakes.iter().map(|mistake| mistake.message.clone()).collect::<Vec<_>>().join("; ")
    };
    let found = equations(&Graph::new(description).map_err(told)?).map_err(told)?;
    let duration = places.last().copied().unwrap_or(0.0);
    let request = SimulationRequest { duration, tolerance, ..found.request() };
    let run = found.simulate_at(&request, places);
    if run.complete { Ok(run) } else { Err(run.ended) }
}

fn values<'a>(run: &'a Simulation, name: &str) -> Result<&'a [f64], String> {
    run.values(name).ok_or_else(|| format!("the graph has no {name:?}"))
}

/// Over the second cycle from the start: the first begins anywhere.
fn firing_order(engine: &Engine) -> Result<f64, String> {
    let cycle = TAU * f64::from(engine.strokes.revolutions()) / engine.speed.highest;
    let count = 720;
    let places: Vec<f64> = (1..=count).map(|k| cycle * (1.0 + f64::from(k) / f64::from(count))).collect();
    let run = run(&with_gas(engine)?, &places, 1e-6)?;
    let mut peaks = Vec::new();
    for cylinder in 1..=engine.cylinders.len() {
        let pressure = &values(&run, &format!("mass{cylinder}.effort"))?[1..];
        let at = (0..pressure.len()).max_by(|a, b| pressure[*a].total_cmp(&pressure[*b]));
        peaks.push((at, cylinder));
    }
    peaks.sort_unstable();
    let first = peaks.iter().position(|(_, cylinder)| *cylinder == 1).unwrap_or(0);
    peaks.rotate_left(first);
    Ok(peaks.iter().fold(0.0, |number, (_, cylinder)| 10.0 * number + *cylinder as f64))
}

fn rocking(engine: &Engine) -> Result<f64, String> {
    let speed = engine.speed.highest;
    let request = EngineRequest {
        block: EngineBlock::Space,
        mounts: true,
        drive: EngineDrive::Imposed,
        crankshaft_inertia: engine.crankshafts.iter().map(|_| 0.0).collect(),
        ..EngineRequest::free(speed, SETTLED + 1.0)
    };
    let description = engine_graph(engine, &request).map_err(|error| error.to_string())?;
    let turn = TAU / speed;
    let count = 96;
    let places: Vec<f64> = (1..=count).map(|k| turn * (SETTLED + f64::from(k) / f64::from(count))).collect();
    let run = run(&description, &places, 1e-8)?;
    let first = |name: &str| -> Result<f64, String> {
        let values = &values(&run, name)?[1..];
        let sum = values.iter().enumerate().fold([0.0; 2], |[c, s], (k, value)| {
            let (sin, cos) = (TAU * (k + 1) as f64 / f64::from(count)).sin_cos();
            [c + value * cos, s + value * sin]
        });
        Ok(sum[0].hypot(sum[1]) * 2.0 / f64::from(count))
    };
    Ok(first("wx.flow")?.hypot(first("wy.flow")?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_simulated_engine_is_the_example() {
        let body = |text: &str| text.lines().skip(1).map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(
            body(include_str!(
                "../../../validation/three-four-cylinder-thesis/three-cylinder-simulated.toml"
            )),
            body(include_str!("../../../examples/three-cylinder.toml"))
        );
    }

    #[test]
    fn names_are_read() {
        assert!(
            matches!(GraphKey::parse("graph parameter r"), Some(GraphKey::Parameter(name)) if name == "r")
        );
        assert!(matches!(GraphKey::parse("graph firing order"), Some(GraphKey::FiringOrder)));
        assert!(GraphKey::parse("graph").is_none() && GraphKey::parse("graph speed").is_none());
    }
}
