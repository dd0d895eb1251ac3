//! The crank train of an engine file.

use crate::block::BlockBody;
use crate::error::MultibodyError;
use crate::mount_place::MountPlace;
use crate::train::{CylinderTrain, LowerPin, RodBody, Rotor, RotorInertia, Train};
use lanchester_model::{Engine, RodJoint};
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};

/// Angles of a turn at which the reach of every rod is checked.
const CHECK_ANGLES: usize = 720;

/// Closer to locking than this share of its length a rod counts as locked.
const LOCKED: f64 = 1e-9;

impl Train {
    /// The crank train of `engine`, with these inertias of what turns.
    ///
    /// # Errors
    /// [`MultibodyError`] where a rod cannot reach its piston, a number is impossible, or the block is smaller than its parts.
    pub fn new(engine: &Engine, inertia: &RotorInertia) -> Result<Train, MultibodyError> {
        let mut rotors = rotors(engine, inertia)?;
        let cylinders = (0..engine.cylinders.len())
            .map(|index| cylinder(engine, index))
            .collect::<Result<Vec<_>, _>>()?;
        let is_master = |index: &usize| cylinders[*index].lower_pin == LowerPin::Crankpin;
        let (mut order, slaves): (Vec<usize>, Vec<usize>) = (0..cylinders.len()).partition(is_master);
        order.extend(slaves);
        for (index, rotor) in rotors.iter_mut().enumerate().take(engine.crankshafts.len()) {
            rotor.mains = engine.main_planes(index);
        }
        let gravity = engine.block.as_ref().map_or([-1.0, 0.0, 0.0], |block| block.gravity);
        let mut train = Train {
            name: engine.name.clone(),
            rotors,
            crankshafts: engine.crankshafts.len(),
            cylinders,
            order,
            block: None,
            mounts: Vec::new(),
            fixed_because: None,
            gravity,
            strokes: engine.strokes.revolutions(),
            revolutions: revolutions(engine),
            highest_speed: engine.speed.highest,
        };
        train.check_reach()?;
        train.find_firings(engine);
        match &engine.block {
            None => train.fixed_because = Some("the file has no [block]".into()),
            Some(block) => train.block = Some(BlockBody::alone(block, &train)?),
        }
        match engine.mounts.iter().find(|mount| mount.spring.is_none()) {
            Some(mount) => train.fixed_because = Some(format!("mount `{}` has no stiffness", mount.name)),
            None if engine.mounts.is_empty() && train.fixed_because.is_none() => {
                train.fixed_because = Some("the file has no mounts".into());
            }
            None => train.mounts = engine.mounts.iter().filter_map(MountPlace::new).collect(),
        }
        Ok(train)
    }

    /// Refuses rods that lose their piston somewhere in a turn.
    fn check_reach(&self) -> Result<(), MultibodyError> {
        let turns = f64::from(self.revolutions);
        let count = CHECK_ANGLES * self.revolutions as usize;
        let mut places = Vec::new();
        for k in 0..count {
            self.places_into(TAU * turns * k as f64 / count as f64, &mut places);
            for (index, (place, cylinder)) in places.iter().zip(&self.cylinders).enumerate() {
                let needed = (place.rod[0] * cylinder.axis.conj()).im.abs();
                // What is not a number is out of reach too.
                let reaches = needed < cylinder.rod.length * (1.0 - LOCKED) && place.travel[0].is_finite();
                if !reaches {
                    let length = cylinder.rod.length;
                    return Err(MultibodyError::Locks { cylinder: index + 1, needed, length });
                }
            }
        }
        Ok(())
    }
}

/// Revolutions of crankshaft 1 after which all stands as before; 1 to 64.
fn revolutions(engine: &Engine) -> u32 {
    let shafts = engine.crankshafts.iter().map(|c| c.ratio).chain(engine.shafts.iter().map(|s| s.ratio));
    let shafts: Vec<_> = shafts.collect();
    let working = engine.strokes.revolutions();
    (1..=64u32)
        .find(|all| {
            let whole = shafts.iter().all(|ratio| (*all % ratio.denominator()) == 0);
            let fires = engine.crankshafts.iter().all(|shaft| {
                (all * shaft.ratio.numerator().unsigned_abs())
                    .is_multiple_of(working * shaft.ratio.denominator())
            });
            whole && fires
        })
        .unwrap_or(64)
}

/// Refuses what is not finite or not in range.
fn number(quantity: &str, needed: &'static str, got: f64, fits: bool) -> Result<f64, MultibodyError> {
    if fits && got.is_finite() {
        Ok(got)
    } else {
        Err(MultibodyError::Number { quantity: quantity.to_owned(), needed, got })
    }
}

fn rotors(engine: &Engine, inertia: &RotorInertia) -> Result<Vec<Rotor>, MultibodyError> {
    let polar = |list: &[Option<f64>], index: usize, name: &str| {
        let given = list.get(index).copied().flatten();
        let value = given.unwrap_or(0.0);
        number(&format!("moment of inertia of {name} [kg m^2]"), "0 or more", value, value >= 0.0)
            .map(|value| (value, given.is_some()))
    };
    let mut rotors = Vec::new();
    for (index, shaft) in engine.crankshafts.iter().enumerate() {
        let mut rotor = Rotor::new(shaft.name.clone(), shaft.ratio.value(), Complex64::new(shaft.x, shaft.y));
        (rotor.inertia, rotor.known) = polar(&inertia.crankshafts, index, &shaft.name)?;
        rotor.flywheel = if index == 0 { inertia.flywheel } else { 0.0 };
        for throw in engine.throws.iter().filter(|throw| throw.crankshaft == index) {
            let direction = Complex64::cis(shaft.phase + throw.angle);
            rotor.add(throw.unbalance_plane(), throw.unbalance * direction);
        }
        for weight in engine.counterweights.iter().filter(|weight| weight.crankshaft == index) {
            rotor.add(weight.z, Complex64::from_polar(weight.unbalance, shaft.phase + weight.angle));
        }
        rotors.push(rotor);
    }
    for (index, shaft) in engine.geared_shafts().iter().enumerate() {
        let mut rotor = Rotor::new(shaft.name.clone(), shaft.ratio.value(), Complex64::new(shaft.x, shaft.y));
        (rotor.inertia, rotor.known) = polar(&inertia.shafts, index, &shaft.name)?;
        for weight in &shaft.weights {
            rotor.add(weight.z, Complex64::from_polar(weight.unbalance, weight.phase));
        }
        rotors.push(rotor);
    }
    Ok(rotors)
}

fn cylinder(engine: &Engine, index: usize) -> Result<CylinderTrain, MultibodyError> {
    let cylinder = &engine.cylinders[index];
    let throw = &engine.throws[cylinder.throw];
    let shaft = &engine.crankshafts[throw.crankshaft];
    let lower_pin = match cylinder.rod.joint {
        RodJoint::Crankpin | RodJoint::Fork | RodJoint::Blade => LowerPin::Crankpin,
        RodJoint::Articulated { master, knuckle_radius, knuckle_angle } => {
            let driver = &engine.cylinders[master];
            let plain = !matches!(driver.rod.joint, RodJoint::Articulated { .. });
            if !plain || driver.throw != cylinder.throw {
                return Err(MultibodyError::MasterNotPlain { cylinder: index + 1, master: master + 1 });
            }
            let place = Complex64::from_polar(knuckle_radius / driver.rod.length, knuckle_angle);
            LowerPin::Knuckle { master, place }
        }
    };
    let rod = &cylinder.rod;
    let of = |what: &str, unit: &str| format!("{what} of cylinder {} [{unit}]", index + 1);
    let length = number(&of("rod length", "m"), "positive", rod.length, rod.length > 0.0)?;
    let mass = number(&of("rod mass", "kg"), "0 or more", rod.mass(), rod.mass() >= 0.0)?;
    let piston = cylinder.piston_mass;
    let piston_mass = number(&of("piston mass", "kg"), "0 or more", piston, piston >= 0.0)?;
    let centre = rod.centre_of_gravity() / length;
    let two_masses = mass * centre * (1.0 - centre) * length * length;
    let inertia = rod.inertia.unwrap_or(two_masses);
    let inertia = number(&of("rod inertia", "kg m^2"), "0 or more", inertia, inertia >= 0.0)?;
    Ok(CylinderTrain {
        rotor: throw.crankshaft,
        throw: cylinder.throw,
        crankpin: Complex64::from_polar(throw.radius, shaft.phase + throw.angle),
        axis: Complex64::cis(cylinder.angle),
        net_offset: cylinder.net_offset(),
        offset: cylinder.offset,
        z: cylinder.z,
        piston_mass,
        rod: RodBody { length, mass, centre, inertia, axial_inertia: rod.axial_inertia },
        lower_pin,
        area: cylinder.bore.map(|bore| 0.25 * PI * bore * bore),
        firing_angle: cylinder.firing_angle,
    })
}
