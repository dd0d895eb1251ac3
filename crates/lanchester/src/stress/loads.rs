//! Loads of a crankshaft from the closed form, named, in the frame that turns with it.

use crate::pressure::cylinders::{GasReport, cylinder_gas};
use crate::pressure::measured::TraceFile;
use crate::stress::named_load::{Extremes, MOST_ANGLES, NamedLoad, NamedLoads, SIZES, given, turn};
use crate::stress::request::{LoadSource, StaticRequest, StressError, StressLoad};
use crate::stress::simulated::simulated_loads;
use lanchester_flex::crank_case::{CrankLoad, PinLoad};
use lanchester_mechanism::{BearingPart, BearingRequest, ThrowForce, throw_forces};
use lanchester_model::Engine;
use lanchester_report::PinForces;
use std::f64::consts::{PI, TAU};

/// Steps in which extremes over the cycle are sought [rad].
const STEP: f64 = PI / 180.0;

/// An angle at which something is largest, or a cylinder fires.
struct Wanted {
    theta: f64,
    extremes: Extremes,
    fires: Vec<usize>,
}

impl Wanted {
    /// The entry of an angle, new where there is none.
    fn at(all: &mut Vec<Wanted>, theta: f64) -> &mut Wanted {
        let place = all.iter().position(|own| (own.theta - theta).abs() < 1e-9).unwrap_or_else(|| {
            all.push(Wanted { theta, extremes: Extremes::default(), fires: Vec::new() });
            all.len() - 1
        });
        &mut all[place]
    }

    /// "largest radial and resultant force on pin 1, firing top dead centre of cylinder 1".
    fn words(&self) -> String {
        let fires =
            self.fires.iter().map(|cylinder| format!("firing top dead centre of cylinder {cylinder}"));
        self.extremes.words().into_iter().chain(fires).collect::<Vec<_>>().join(", ")
    }
}

/// All loads of a request.
pub(crate) fn named_loads(
    engine: &Engine,
    traces: &[TraceFile],
    request: &StaticRequest,
) -> Result<NamedLoads, StressError> {
    if let StressLoad::Given { forces, angle } = &request.load {
        let speeds = if request.speeds.is_empty() { vec![0.0] } else { request.speeds.clone() };
        let loads = speeds.iter().map(|speed| given(engine, request.mesh.crankshaft, *speed, forces, *angle));
        let note = "Forces as given; the centrifugal field of the crankshaft acts where a speed is given.";
        let loads = loads.collect::<Result<_, _>>()?;
        return Ok(NamedLoads { loads, gas: None, notes: vec![note.to_owned()] });
    }
    if let LoadSource::Simulation(source) = &request.source {
        return simulated_loads(engine, traces, request, source);
    }
    let mut speeds = request.speeds.clone();
    if speeds.is_empty() {
        speeds = vec![engine.speed.lowest, engine.speed.highest];
        speeds.dedup();
    }
    let (mut loads, mut source) = (Vec::new(), None);
    for speed in speeds {
        let gas = match &engine.gas {
            Some(_) if request.gas => Some(cylinder_gas(engine, traces, speed)?),
            _ => None,
        };
        loads.extend(of_closed_form(engine, gas.as_ref(), speed, request)?);
        source = gas.map(|gas| gas.source).or(source);
    }
    let note = "Forces of gas and of the inertia of pistons and rods from the closed form at constant speed, sought in steps of 1 deg; the crankshaft's own \
                centrifugal field acts.";
    Ok(NamedLoads { loads, gas: source, notes: vec![note.to_owned()] })
}

fn named(
    engine: &Engine,
    crankshaft: usize,
    name: String,
    theta: f64,
    speed: f64,
    forces: &[ThrowForce],
) -> NamedLoad {
    let ratio = engine.crankshafts[crankshaft].ratio.value();
    NamedLoad {
        name,
        theta: Some(theta),
        speed,
        forces: forces
            .iter()
            .map(|own| PinForces { pin: own.throw + 1, radial: own.radial, tangential: own.tangential })
            .collect(),
        load: CrankLoad {
            pins: forces
                .iter()
                .map(|own| PinLoad { pin: own.throw + 1, force: [own.force.re, own.force.im] })
                .collect(),
            speed: ratio * speed,
            turn: turn(engine, crankshaft, theta),
            ..CrankLoad::default()
        },
    }
}

fn of_closed_form(
    engine: &Engine,
    gas: Option<&GasReport>,
    speed: f64,
    request: &StaticRequest,
) -> Result<Vec<NamedLoad>, StressError> {
    let crankshaft = request.mesh.crankshaft;
    let part = if gas.is_some() { BearingPart::All } else { BearingPart::Inertia };
    let asked = BearingRequest { speed: Some(speed), part, ..BearingRequest::default() };
    let cylinders = gas.map(|gas| gas.cylinders.as_slice());
    let at = |theta: &[f64]| throw_forces(engine, cylinders, &asked, crankshaft, theta);
    let rpm = speed * 30.0 / PI;
    if let StressLoad::Angles(angles) = &request.load {
        if angles.len() > MOST_ANGLES {
            return Err(StressError::Angles { got: angles.len(), most: MOST_ANGLES });
        }
        let one = |(theta, forces): (&f64, Vec<ThrowForce>)| {
            let name = format!("crank angle {:.1} deg, {rpm:.0} rpm", theta.to_degrees());
            named(engine, crankshaft, name, *theta, speed, &forces)
        };
        return Ok(angles.iter().zip(at(angles)?).map(one).collect());
    }
    // One period, and the angles that begin a power stroke.
    let period = TAU * f64::from(engine.strokes.revolutions());
    let count = (period / STEP).round() as usize;
    let grid: Vec<f64> = (0..count).map(|k| period * k as f64 / count as f64).collect();
    let over = at(&grid)?;
    // Angle, extremes there by pin, cylinders that fire there.
    let mut wanted: Vec<Wanted> = Vec::new();
    let throws = over.first().map_or(0, Vec::len);
    for k in 0..throws {
        let pin = over[0][k].throw + 1;
        for (name, size) in SIZES {
            let best = (0..count).max_by(|a, b| size(&over[*a][k]).total_cmp(&size(&over[*b][k])));
            if let Some(best) = best {
                Wanted::at(&mut wanted, grid[best]).extremes.add(pin, name);
            }
        }
    }
    if let Some(gas) = gas {
        for (index, theta) in gas.firing_angles.iter().enumerate() {
            if engine.throws[engine.cylinders[index].throw].crankshaft == crankshaft {
                Wanted::at(&mut wanted, theta.rem_euclid(period)).fires.push(index + 1);
            }
        }
    }
    let angles: Vec<f64> = wanted.iter().map(|own| own.theta).collect();
    let forces = at(&angles)?;
    let loads = wanted.into_iter().zip(forces).map(|(own, forces)| {
        let name = format!("{}, {rpm:.0} rpm", own.words());
        named(engine, crankshaft, name, own.theta, speed, &forces)
    });
    Ok(loads.collect())
}
