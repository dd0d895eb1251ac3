//! The crank train of an engine as rigid bodies for another program, with our loads beside it.

use crate::inertias::rotor_inertia;
use lanchester_exchange::{RigidCylinder, RigidReference, RigidRotor, RigidTrain};
use lanchester_mechanism::{LoadError, LoadRequest, loads};
use lanchester_model::Engine;
use lanchester_multibody::{LowerPin, MultibodyError, Train};

/// Why there is no such train.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RigidTrainError {
    /// The engine is no crank train of rigid bodies.
    #[error(transparent)]
    Train(#[from] MultibodyError),
    /// Its loads cannot be computed.
    #[error(transparent)]
    Loads(#[from] LoadError),
    /// It has rods on rods.
    #[error("cylinder {cylinder} has an articulated rod, of which the script has no joint")]
    Articulated {
        /// Its number, from 1.
        cylinder: usize,
    },
}

/// Angles of our loads in one revolution.
const ANGLES: usize = 36;

/// The crank train at a speed of crankshaft 1 [rad/s], the highest of the engine where none is given.
///
/// # Errors
/// [`RigidTrainError`] where the engine has what the script has not.
pub fn rigid_train(engine: &Engine, speed: Option<f64>) -> Result<RigidTrain, RigidTrainError> {
    let speed = speed.unwrap_or(engine.speed.highest);
    let train = Train::new(engine, &rotor_inertia(engine))?;
    let found =
        loads(engine, &LoadRequest { speed: Some(speed), samples: ANGLES, ..LoadRequest::default() })?;
    let trace = &found.total.trace;
    let revolutions = (found.period / std::f64::consts::TAU).round().max(1.0) as u32;
    let cylinder = |(index, own): (usize, &lanchester_multibody::CylinderTrain)| match own.lower_pin {
        LowerPin::Knuckle { .. } => Err(RigidTrainError::Articulated { cylinder: index + 1 }),
        LowerPin::Crankpin => Ok(RigidCylinder {
            rotor: own.rotor,
            crankpin: [own.crankpin.re, own.crankpin.im],
            axis: own.axis.arg(),
            offset: own.net_offset,
            z: own.z,
            piston_mass: own.piston_mass,
            rod_length: own.rod.length,
            rod_mass: own.rod.mass,
            rod_centre: own.rod.centre * own.rod.length,
            rod_inertia: own.rod.inertia,
        }),
    };
    let rotors = train
        .rotors
        .iter()
        .map(|own| RigidRotor::new(&own.name, own.ratio, own.axis, own.first_moment, own.product));
    let loads = (0..trace.theta.len())
        .map(|k| [trace.force_x[k], trace.force_y[k], trace.couple_x[k], trace.couple_y[k]])
        .collect();
    Ok(RigidTrain {
        name: engine.name.clone(),
        speed,
        revolutions,
        rotors: rotors.collect(),
        cylinders: train.cylinders.iter().enumerate().map(cylinder).collect::<Result<_, _>>()?,
        reference: RigidReference { theta: trace.theta.clone(), loads },
    })
}
