//! Torque of an engine without gas: that of the inertia of pistons and rods alone, whose mean over a revolution is zero.

use crate::inertia::request::LoadRequest;
use crate::speed::energy::{Breaks, EnergyVariation, STRETCHES};
use crate::torque::cycle::{InertiaTorque, inertia_orders};
use crate::torque::firing_chart::{firing_chart, no_firing};
use crate::torque::gas_train::{area, check_lever};
use crate::torque::request::{TorqueError, TorqueRequest};
use crate::torque::result::{
    CylinderTorque, Indicated, IndicatedWork, TORQUE_VERSION, Torque, TorqueHarmonic,
};
use crate::train::mechanism::{Selection, period};
use crate::train::motion::motion;
use lanchester_model::Engine;
use lanchester_results::{Extreme, Extremes};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Torque of `engine` without gas: an engine that is motored, or whose file says nothing of pressures. The crankshaft gives energy to pistons and
/// rods and takes it back; its torque at constant speed swings about zero. Bore and firing are not needed.
///
/// # Errors
/// [`TorqueError`] where the lever is not one of this engine, or the request is impossible.
pub fn torque_without_gas(engine: &Engine, request: &TorqueRequest) -> Result<Torque, TorqueError> {
    for index in 0..engine.cylinders.len() {
        check_lever(engine, index, request.lever)?;
    }
    let inertia = InertiaTorque::of(engine, request, Selection::All)?;
    let speed = inertia.speed();
    let revolutions = period(engine)?;
    request.loads().check_angles(revolutions)?;
    let period = TAU * f64::from(revolutions);
    let count = request.samples * revolutions as usize;
    let theta: Vec<f64> = (0..count).map(|j| period * j as f64 / count as f64).collect();
    let sampled = |own: &InertiaTorque| theta.iter().map(|theta| own.at(*theta)).collect::<Vec<f64>>();

    let motion = motion(engine, &LoadRequest { samples: 1, ..LoadRequest::default() })?;
    let cylinders = (motion.iter().enumerate())
        .map(|(index, motion)| {
            let own = InertiaTorque::of(engine, request, Selection::Cylinder(index))?;
            let bore = engine.cylinders[index].bore.unwrap_or(0.0);
            Ok(CylinderTorque {
                cylinder: index + 1,
                firing_angle: motion.firing_angle.unwrap_or(motion.top_dead_centre),
                gas: vec![0.0; count],
                inertia: sampled(&own),
                pressure: Vec::new(),
                crankcase: Vec::new(),
                volume: Vec::new(),
                clearance: None,
                work: IndicatedWork { swept: area(bore) * motion.stroke, ..IndicatedWork::default() },
                peak_pressure: Extreme { value: 0.0, theta: 0.0 },
            })
        })
        .collect::<Result<Vec<_>, TorqueError>>()?;

    let orders = inertia_orders(&inertia);
    let harmonics = orders
        .iter()
        .map(|loads| TorqueHarmonic { order: loads.order, gas: Complex64::ZERO, inertia: loads.shaft_torque })
        .collect();
    let breaks = Breaks::new(period, std::iter::empty(), STRETCHES * revolutions as usize);
    let of_inertia = breaks.sample(|theta| inertia.at(theta));
    let extremes = of_inertia.extremes();
    let nowhere = Extreme { value: 0.0, theta: 0.0 };
    let fastest = |(index, motion): (usize, &crate::inertia::result::CylinderMotion)| {
        let throw = &engine.throws[engine.cylinders[index].throw];
        let ratio = engine.crankshafts[throw.crankshaft].ratio.value().abs();
        Indicated::piston_speed(motion.stroke, ratio * speed)
    };
    Ok(Torque {
        version: TORQUE_VERSION,
        engine: engine.name.clone(),
        speed,
        lever: request.lever,
        with_gas: false,
        period,
        gas: vec![0.0; count],
        inertia: sampled(&inertia),
        gas_extremes: Extremes { max: nowhere, min: nowhere },
        inertia_extremes: extremes,
        total_extremes: extremes,
        indicated: Indicated {
            torque: 0.0,
            power: 0.0,
            displacement: cylinders.iter().map(|cylinder| cylinder.work.swept).sum(),
            imep: 0.0,
            crankcase_mep: 0.0,
            torque_per_mep: 0.0,
            mean_piston_speed: motion.iter().enumerate().map(fastest).fold(0.0, f64::max),
            peak_pressure: 0.0,
        },
        energy: of_inertia.energy(of_inertia.integral() / period),
        gas_energy: EnergyVariation {
            mean: 0.0,
            excess: 0.0,
            highest: 0.0,
            lowest: 0.0,
            own_period: period,
            absolute: 0.0,
        },
        orders,
        harmonics,
        cylinders,
        firing: firing_chart(engine).unwrap_or_else(|_| no_firing(engine, period)),
        theta,
    })
}
