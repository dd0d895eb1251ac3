//! Loads of the main bearings of the rigid crankshaft by the three rules of the simulation.

use crate::crosscheck::pair::{CrossCheckRequest, Pair};
use crate::inertias::rotor_inertia;
use lanchester_mechanism::CylinderGas;
use lanchester_model::Engine;
use lanchester_multibody::{MainRule, Train};
use lanchester_report::MainRules;
use std::cell::RefCell;

/// Loads at these angles; why not, in words.
pub(crate) fn main_rules(
    engine: &Engine,
    gas: Option<&[CylinderGas]>,
    speed: f64,
    theta: &[f64],
    crankshaft: usize,
) -> Result<MainRules, String> {
    let train = Train::new(engine, &rotor_inertia(engine)).map_err(|error| error.to_string())?;
    let shares = train.main_shares(&[]);
    let request = CrossCheckRequest::default();
    let pair = Pair { engine, speed, gas, train, request: &request, derivative: RefCell::default() };
    let mut loads: Vec<[Vec<[f64; 2]>; 3]> = Vec::new();
    for theta in theta {
        let all = pair.reactions(*theta, &shares);
        let rotor = all.rotors.get(crankshaft).ok_or("the simulation has no such crankshaft")?;
        let count = rotor.mains[0].len();
        if count == 0 {
            return Err("the simulation has no main bearings of this crankshaft".to_owned());
        }
        loads.resize_with(count, Default::default);
        for (main, own) in loads.iter_mut().enumerate() {
            for (rule, trace) in own.iter_mut().enumerate() {
                trace.push(rotor.mains[rule][main]);
            }
        }
    }
    Ok(MainRules { names: MainRule::ALL.map(|rule| rule.name().to_owned()), theta: theta.to_vec(), loads })
}
