//! Forces of the rods on the pins of the throws, in the frame that turns with the crankshaft: what stresses it.

use super::plan::BearingPlan;
use super::request::{BearingPart, BearingRequest};
use crate::torque::gas::CylinderGas;
use crate::torque::gas_train::GasTrain;
use crate::torque::request::{Lever, TorqueError};
use lanchester_model::Engine;
use num_complex::Complex64;
use serde::Serialize;

/// Force of all rods on the pin of one throw at one angle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ThrowForce {
    /// Index of the throw.
    pub throw: usize,
    /// Along the throw, positive away from the crank axis [N].
    pub radial: f64,
    /// Across it, positive where it drives the crankshaft [N].
    pub tangential: f64,
    /// In the frame that turns with the crankshaft, real part along throw 1 of it [N].
    #[schemars(with = "[f64; 2]")]
    pub force: Complex64,
}

/// Forces on all pins of a crankshaft at crank angles `theta` [rad], in the frame that turns with it; `gas` as in [`crate::bearing_loads`].
///
/// # Errors
/// As [`crate::torque`].
pub fn throw_forces(
    engine: &Engine,
    gas: Option<&[CylinderGas]>,
    request: &BearingRequest,
    crankshaft: usize,
    theta: &[f64],
) -> Result<Vec<Vec<ThrowForce>>, TorqueError> {
    let request = BearingRequest { samples: 4, ..request.clone() };
    let plan = BearingPlan::new(engine, gas, &request)?;
    let train = match gas.filter(|_| request.part != BearingPart::Inertia) {
        Some(gas) => Some(GasTrain::new(engine, gas, Lever::Exact)?),
        None => None,
    };
    let gas_force = |cylinder: usize, theta: f64| {
        let piston = train.as_ref().map(|train| &train.pistons[cylinder]);
        piston.map_or(0.0, |piston| piston.force.at(piston.own_angle(theta)))
    };
    let throws: Vec<usize> =
        (0..engine.throws.len()).filter(|throw| engine.throws[*throw].crankshaft == crankshaft).collect();
    let sense =
        engine.crankshafts.get(crankshaft).map_or(1.0, |own| f64::from(own.ratio.numerator().signum()));
    let at = |theta: &f64| {
        let of = |throw: &usize| {
            let on_pin = |(index, cylinder): (usize, &lanchester_model::Cylinder)| {
                (cylinder.throw == *throw && crate::train::mechanism::master_of(cylinder).is_none())
                    .then(|| plan.rod_at(index, *theta, &gas_force).lower_pin)
            };
            let sum: Complex64 = engine.cylinders.iter().enumerate().filter_map(on_pin).sum();
            let along = sum * Complex64::cis(-engine.pin_angle(*throw, *theta));
            let force = along * Complex64::cis(engine.throws[*throw].angle);
            ThrowForce { throw: *throw, radial: along.re, tangential: sense * along.im, force }
        };
        throws.iter().map(of).collect()
    };
    Ok(theta.iter().map(at).collect())
}
