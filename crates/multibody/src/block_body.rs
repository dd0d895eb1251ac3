//! The block by itself: the file's numbers less everything that moves in it.
//!
//! ```text
//! alone = [block] - mean over the angle of pistons and rods (where its numbers hold them) - SUM over rotors of J z z^T
//! ```
//! Mass and transverse inertia of rotors stay in it: they move with the block. Their polar inertia does not, because they spin.

use crate::block::{BlockBody, point_inertia};
use crate::error::MultibodyError;
use crate::place::Place;
use crate::train::Train;
use lanchester_model::{Block, MovingParts};
use nalgebra::{Matrix3, Vector3};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Angles of a revolution over which places are averaged: the mean of a smooth periodic function, to rounding.
const ANGLES: u32 = 360;

/// A vector across the crank axis in a plane.
pub(crate) fn in_plane(across: Complex64, z: f64) -> Vector3<f64> {
    Vector3::new(across.re, across.im, z)
}

impl BlockBody {
    /// The block without what moves in it.
    pub(crate) fn alone(block: &Block, train: &Train) -> Result<BlockBody, MultibodyError> {
        let mut body = BlockBody::whole(block);
        body.check("nothing")?;
        if block.moving_parts == MovingParts::Included {
            for (index, part) in moving_parts(train).into_iter().enumerate() {
                body.mass -= part.mass;
                body.first_moment -= part.first_moment;
                body.inertia -= part.inertia;
                body.check(&format!("piston and rod of cylinder {}", index + 1))?;
            }
        }
        for rotor in &train.rotors {
            body.inertia[(2, 2)] -= rotor.inertia;
            body.check(&format!("the polar inertia of {}", rotor.name))?;
        }
        Ok(body)
    }
}

/// Piston and rod of every cylinder with the mean of their moments over the angle.
pub(crate) fn moving_parts(train: &Train) -> Vec<BlockBody> {
    let zero = BlockBody { mass: 0.0, first_moment: Vector3::zeros(), inertia: Matrix3::zeros() };
    let mut parts = vec![zero; train.cylinders.len()];
    let count = ANGLES * train.revolutions;
    let weight = 1.0 / f64::from(count);
    let mut places = Vec::new();
    for k in 0..count {
        train.places_into(TAU * f64::from(train.revolutions) * f64::from(k) * weight, &mut places);
        for (index, part) in parts.iter_mut().enumerate() {
            for (mass, at, own) in bodies(train, index, &places[index]) {
                part.mass += weight * mass;
                part.first_moment += weight * mass * at;
                part.inertia += weight * (own + point_inertia(mass, at));
            }
        }
    }
    parts
}

/// Mass, centre [m] and inertia about the centre [kg m^2] of piston and rod of cylinder `index`.
pub(crate) fn bodies(train: &Train, index: usize, place: &Place) -> [(f64, Vector3<f64>, Matrix3<f64>); 2] {
    let cylinder = &train.cylinders[index];
    let shaft = train.rotors[cylinder.rotor].axis;
    let piston = shaft + cylinder.axis * Complex64::new(place.travel[0], cylinder.offset);
    let rod = shaft + place.on_rod(cylinder.rod.centre)[0];
    [
        (cylinder.piston_mass, in_plane(piston, cylinder.z), Matrix3::zeros()),
        (cylinder.rod.mass, in_plane(rod, cylinder.z), rod_inertia(train, index, place)),
    ]
}

/// Inertia tensor of a rod about its centre, block axes [kg m^2].
pub(crate) fn rod_inertia(train: &Train, index: usize, place: &Place) -> Matrix3<f64> {
    let rod = &train.cylinders[index].rod;
    let along = in_plane(place.rod[0] / rod.length, 0.0);
    let across = Matrix3::identity() - along * along.transpose();
    rod.inertia * across + rod.axial_inertia * along * along.transpose()
}
