//! A load of a crankshaft with its name, in the frame that turns with it.

use crate::stress::request::StressError;
use lanchester_flex::crank_case::{CrankLoad, PinLoad};
use lanchester_mechanism::ThrowForce;
use lanchester_model::Engine;
use lanchester_report::PinForces;
use std::f64::consts::PI;

/// Most crank angles at a time: each keeps the stress of the whole crankshaft.
pub(crate) const MOST_ANGLES: usize = 360;

/// A named load.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct NamedLoad {
    pub name: String,
    pub theta: Option<f64>,
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    pub forces: Vec<PinForces>,
    pub load: CrankLoad,
}

/// Loads of a request.
pub(crate) struct NamedLoads {
    pub loads: Vec<NamedLoad>,
    /// Where the pressures come from.
    pub gas: Option<String>,
    /// What is to be said of them.
    pub notes: Vec<String>,
}

/// Forces that are largest at one instant: by pin the names of their sizes.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Extremes(Vec<(usize, Vec<&'static str>)>);

impl Extremes {
    /// Adds a size of the force on a pin.
    pub fn add(&mut self, pin: usize, name: &'static str) {
        match self.0.iter_mut().find(|(own, _)| *own == pin) {
            Some((_, names)) => names.push(name),
            None => self.0.push((pin, vec![name])),
        }
    }

    /// "largest radial and resultant force on pin 1", by pin.
    pub fn words(&self) -> Vec<String> {
        let one =
            |(pin, names): &(usize, Vec<&str>)| format!("largest {} force on pin {pin}", names.join(" and "));
        self.0.iter().map(one).collect()
    }
}

/// Angle from the block's x axis to that of the frame of a crankshaft, along its first throw [rad].
pub(crate) fn turn(engine: &Engine, crankshaft: usize, theta: f64) -> f64 {
    let own = &engine.crankshafts[crankshaft];
    own.ratio.value() * theta + own.phase
}

/// A size of the force on a pin, and how it is called.
type Size = (&'static str, fn(&ThrowForce) -> f64);

/// Sizes whose extremes are load cases.
pub(crate) const SIZES: [Size; 3] = [
    ("radial", |own| own.radial.abs()),
    ("tangential", |own| own.tangential.abs()),
    ("resultant", |own| own.force.norm()),
];

/// Forces that the user gives, along and across throws.
pub(crate) fn given(
    engine: &Engine,
    crankshaft: usize,
    speed: f64,
    forces: &[PinForces],
    angle: Option<f64>,
) -> Result<NamedLoad, StressError> {
    let own = &engine.crankshafts[crankshaft];
    let sense = f64::from(own.ratio.numerator().signum());
    let pin = |force: &PinForces| {
        let throw = force.pin.checked_sub(1).and_then(|index| engine.throws.get(index));
        let throw = throw.filter(|throw| throw.crankshaft == crankshaft).ok_or_else(|| {
            let pins: Vec<String> = (0..engine.throws.len())
                .filter(|index| engine.throws[*index].crankshaft == crankshaft)
                .map(|index| (index + 1).to_string())
                .collect();
            let there = format!("pins {} on crankshaft {}", pins.join(", "), crankshaft + 1);
            StressError::Missing { what: "pin", number: force.pin, there }
        })?;
        let (sin, cos) = throw.angle.sin_cos();
        let (along, across) = (force.radial, sense * force.tangential);
        Ok(PinLoad { pin: force.pin, force: [along * cos - across * sin, along * sin + across * cos] })
    };
    let words = |force: &PinForces| {
        format!(
            "pin {}: {:.3} kN radial, {:.3} kN tangential",
            force.pin,
            1e-3 * force.radial,
            1e-3 * force.tangential
        )
    };
    let mut name = forces.iter().map(words).collect::<Vec<_>>().join("; ");
    if speed != 0.0 {
        name.push_str(&format!(", {:.0} rpm", speed * 30.0 / PI));
    }
    let pins = forces.iter().map(pin).collect::<Result<Vec<PinLoad>, StressError>>()?;
    if let Some(angle) = angle {
        name.push_str(&format!(", crank angle {:.1} deg", angle.to_degrees()));
    }
    let turn = turn(engine, crankshaft, angle.unwrap_or(0.0));
    let load = CrankLoad { pins, speed: own.ratio.value() * speed, turn, ..CrankLoad::default() };
    Ok(NamedLoad { name, theta: angle, speed, forces: forces.to_vec(), load })
}
