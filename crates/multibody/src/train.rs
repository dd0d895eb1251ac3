//! The crank train of an engine as plain data: rotors, cylinders with their loops, block and mounts.
//!
//! Directions across the crank axis are complex, `x + i y`; everything is placed in the axes of the block. Angles of every shaft follow
//! from the crank angle of crankshaft 1 by its ratio.

mod gear_mesh;
mod of_engine;

use crate::block::BlockBody;
use crate::mount_place::MountPlace;
use lanchester_model::{RotatingBody, RotatingKind};
use num_complex::Complex64;

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
    /// `INTEGRAL (x + i y)^2 dm` at `theta = 0` [kg m^2]: by what its inertias across the axis differ, and their product; 0 where it has none, or nobody says.
    pub unequal: Complex64,
    /// Teeth by which crankshaft 1 drives it, where they are known.
    pub mesh: Option<Mesh>,
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
            unequal: zero,
            mesh: None,
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

pub use gear_mesh::Mesh;

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
    /// The speed ratio of the crankshaft of cylinder `index`.
    pub fn ratio(&self, index: usize) -> f64 {
        self.rotors[self.cylinders[index].rotor].ratio
    }

    /// Angle through which the own crankshaft of cylinder `index` has turned since it fired, in its sense of rotation [rad].
    pub fn own_angle(&self, index: usize, theta: f64) -> f64 {
        self.ratio(index).abs() * (theta - self.cylinders[index].firing_angle.unwrap_or(0.0))
    }

    /// Gives a rotor the first moment `first` [kg m], the moment `product = INTEGRAL z (x + i y) dm` and the moment `unequal` of [`Rotor::unequal`]
    /// [kg m^2] of a body, all at `theta = 0`: what its unbalances lack is added in its outermost planes of main bearings. Nothing happens to a rotor without two of them.
    pub fn set_body(&mut self, index: usize, first: Complex64, product: Complex64, unequal: Complex64) {
        let Some(rotor) = self.rotors.get_mut(index) else { return };
        let (Some(&front), Some(&rear)) = (rotor.mains.first(), rotor.mains.last()) else { return };
        if rear <= front {
            return;
        }
        let (first, product) = (first - rotor.first_moment, product - rotor.product);
        let behind = (product - front * first) / (rear - front);
        rotor.add(front, first - behind);
        rotor.add(rear, behind);
        rotor.unequal = unequal;
    }
}
