//! The crank train of an engine as plain data: rotors, cylinders with their loops, block and mounts.
//!
//! Directions across the crank axis are complex, `x + i y`; everything is placed in the axes of the block. Angles of every shaft follow
//! from the crank angle of crankshaft 1 by its ratio.

use crate::block_body::BlockBody;
use crate::error::MultibodyError;
use crate::mount_place::MountPlace;
use lanchester_model::{Engine, RodJoint, RotatingBody, RotatingKind};
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};

/// Angles of a turn at which the reach of every rod is checked.
const CHECK_ANGLES: usize = 720;

/// Closer to locking than this share of its length a rod counts as locked.
const LOCKED: f64 = 1e-9;

/// Polar moments of inertia of what turns, each about its own axis [kg m^2].
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RotorInertia {
    /// Of every crankshaft, with the flywheel and its counterweights, without rods; `None` where it is unknown.
    pub crankshafts: Vec<Option<f64>>,
    /// Of the flywheel, which is part of the first number of `crankshafts` [kg m^2].
    pub flywheel: f64,
    /// Of every balance shaft, then of every gear; `None` where it is unknown.
    pub shafts: Vec<Option<f64>>,
}

impl RotorInertia {
    /// Of all that turns with an engine, as [`lanchester_model::EngineParts::rotating_bodies`] lists it.
    pub fn of(bodies: &[RotatingBody]) -> RotorInertia {
        let mut inertia = RotorInertia::default();
        let mut flywheel = None;
        for body in bodies {
            let own = body.inertia.map(|own| own.value);
            match body.kind {
                RotatingKind::Crankshaft(_) => inertia.crankshafts.push(own),
                RotatingKind::Flywheel => flywheel = own,
                RotatingKind::Shaft(_) | RotatingKind::Gear(_) => inertia.shafts.push(own),
            }
        }
        if let (Some(first), Some(flywheel)) = (inertia.crankshafts.first_mut(), flywheel) {
            *first = Some(first.unwrap_or(0.0) + flywheel);
        }
        inertia.flywheel = flywheel.unwrap_or(0.0);
        inertia
    }
}

/// An unbalance on a rotor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unbalance {
    /// Its plane [m], from the origin.
    pub z: f64,
    /// Mass times radius with its direction where crankshaft 1 stands at 0 [kg m].
    pub moment: Complex64,
}

/// A crankshaft or a balance shaft: polar inertia about its axis and unbalances; its mass and its transverse inertia belong to the block.
#[derive(Debug, Clone, PartialEq)]
pub struct Rotor {
    /// Name for tables.
    pub name: String,
    /// Speed over that of crankshaft 1, signed.
    pub ratio: f64,
    /// Where its axis is [m].
    pub axis: Complex64,
    /// Polar moment of inertia about its axis [kg m^2]; 0 where it is unknown.
    pub inertia: f64,
    /// Share of it that sits behind the last main bearing, as the flywheel does [kg m^2].
    pub flywheel: f64,
    /// Whether the inertia is known.
    pub known: bool,
    /// Its unbalances.
    pub unbalances: Vec<Unbalance>,
    /// `SUM U e` at `theta = 0` [kg m].
    pub first_moment: Complex64,
    /// `SUM U z e` at `theta = 0` [kg m^2].
    pub product: Complex64,
    /// Planes of its main bearings [m], rising; empty for a balance shaft.
    pub mains: Vec<f64>,
}

impl Rotor {
    fn new(name: String, ratio: f64, axis: Complex64) -> Rotor {
        let zero = Complex64::ZERO;
        Rotor {
            name,
            ratio,
            axis,
            inertia: 0.0,
            flywheel: 0.0,
            known: false,
            unbalances: Vec::new(),
            first_moment: zero,
            product: zero,
            mains: Vec::new(),
        }
    }

    /// Planes in which the polar inertia of the shaft without its flywheel acts on a block that turns [m]: the middles of its bays, or the origin.
    pub(crate) fn bays(&self) -> impl Iterator<Item = f64> + '_ {
        let origin = (self.mains.len() < 2).then_some(0.0);
        self.mains.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).chain(origin)
    }

    fn add(&mut self, z: f64, moment: Complex64) {
        if moment != Complex64::ZERO {
            self.unbalances.push(Unbalance { z, moment });
            self.first_moment += moment;
            self.product += z * moment;
        }
    }
}

/// What the lower end of a rod sits on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LowerPin {
    /// The crankpin.
    Crankpin,
    /// A knuckle pin on the rod of another cylinder.
    Knuckle {
        /// Index of the master's cylinder.
        master: usize,
        /// From the master's crankpin, over the line from there to its piston pin.
        place: Complex64,
    },
}

/// A rod as a rigid body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RodBody {
    /// Distance of its eyes [m].
    pub length: f64,
    /// Mass [kg].
    pub mass: f64,
    /// Distance of the centre of mass from the lower eye over the length.
    pub centre: f64,
    /// Moment of inertia about the centre across the rod [kg m^2].
    pub inertia: f64,
    /// Moment of inertia along the rod [kg m^2].
    pub axial_inertia: f64,
}

/// A cylinder with its piston and rod.
#[derive(Debug, Clone, PartialEq)]
pub struct CylinderTrain {
    /// Index of its crankshaft among the rotors.
    pub rotor: usize,
    /// Index of its throw.
    pub throw: usize,
    /// Crankpin (of an articulated rod: its master's) from the crankshaft's axis at `theta = 0` [m].
    pub crankpin: Complex64,
    /// Direction of the cylinder axis.
    pub axis: Complex64,
    /// Net offset of the piston pin [m].
    pub net_offset: f64,
    /// Offset of the cylinder axis, on which the piston's centre and the gas force lie [m].
    pub offset: f64,
    /// Plane [m].
    pub z: f64,
    /// Mass of the piston [kg].
    pub piston_mass: f64,
    /// Its rod.
    pub rod: RodBody,
    /// What the rod sits on.
    pub lower_pin: LowerPin,
    /// Area of the bore [m^2], where it is known.
    pub area: Option<f64>,
    /// `theta` at which it fires, a top dead centre of its chamber [rad]; `None` where the file gives no firing.
    pub firing_angle: Option<f64>,
}

/// The crank train of an engine in its block.
#[derive(Debug, Clone, PartialEq)]
pub struct Train {
    /// Name of the engine.
    pub name: String,
    /// Crankshafts, then balance shafts.
    pub rotors: Vec<Rotor>,
    /// How many of the rotors are crankshafts.
    pub crankshafts: usize,
    /// Cylinders as in the file.
    pub cylinders: Vec<CylinderTrain>,
    /// Indices of the cylinders such that masters come before their articulated rods.
    pub order: Vec<usize>,
    /// The block without all that moves in it, where the file gives it.
    pub block: Option<BlockBody>,
    /// Its mounts, where each of them has stiffness.
    pub mounts: Vec<MountPlace>,
    /// Why the block cannot move, where it cannot.
    pub fixed_because: Option<String>,
    /// Direction of gravity, a unit vector in the frame.
    pub gravity: [f64; 3],
    /// Revolutions of a working cycle.
    pub strokes: u32,
    /// Revolutions of crankshaft 1 after which all shafts stand as before and all cylinders fire anew.
    pub revolutions: u32,
    /// Highest speed that the file names [rad/s].
    pub highest_speed: f64,
}

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

    /// The speed ratio of the crankshaft of cylinder `index`.
    pub fn ratio(&self, index: usize) -> f64 {
        self.rotors[self.cylinders[index].rotor].ratio
    }

    /// Angle through which the own crankshaft of cylinder `index` has turned since it fired, in its sense of rotation [rad].
    pub fn own_angle(&self, index: usize, theta: f64) -> f64 {
        self.ratio(index).abs() * (theta - self.cylinders[index].firing_angle.unwrap_or(0.0))
    }

    /// The first rotor whose polar inertia nobody gave.
    pub fn unknown_inertia(&self) -> Option<&Rotor> {
        self.rotors.iter().find(|rotor| !rotor.known)
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
