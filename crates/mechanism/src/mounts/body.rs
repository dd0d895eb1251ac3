//! The body that moves on the mounts: the file's block, with pistons and rods where they are to be added.

use crate::mounts::error::MountError;
use crate::mounts::result::MountedBody;
use crate::train::rod_place::RodLinkage;
use lanchester_model::{Block, Engine, InertiaFault, MovingParts};
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::TAU;

/// Angles of a revolution over which places are averaged: the mean of a smooth periodic function, to rounding.
const ANGLES: usize = 360;

/// The block with what is added to it.
///
/// Each piston with its small end counts as a point at the piston pin, each big end as a point at its lower pin; their first and
/// second moments are averaged over a revolution of their crankshaft.
pub(crate) fn mounted_body(engine: &Engine, block: &Block) -> Result<MountedBody, MountError> {
    check(block)?;
    let (mut mass, mut first, mut second) = (0.0, Vector3::zeros(), Matrix3::zeros());
    if block.moving_parts == MovingParts::Added {
        for index in 0..engine.cylinders.len() {
            let (own_mass, own_first, own_second) = of_cylinder(engine, index)?;
            (mass, first, second) = (mass + own_mass, first + own_first, second + own_second);
        }
    }
    let added_mass = mass;
    let own = Vector3::from(block.centre);
    let mut of_block = -tensor(block);
    let half_trace = -0.5 * of_block.trace();
    for k in 0..3 {
        of_block[(k, k)] += half_trace;
    }
    mass += block.mass;
    first += block.mass * own;
    second += of_block + block.mass * own * own.transpose();
    let centre = first / mass;
    let about_centre = second - mass * centre * centre.transpose();
    let inertia = Matrix3::identity() * about_centre.trace() - about_centre;
    let inertia = [0, 1, 2].map(|i| [0, 1, 2].map(|j| inertia[(i, j)]));
    Ok(MountedBody { mass, added_mass, centre: centre.into(), inertia })
}

/// The inertia tensor of the file.
fn tensor(block: &Block) -> Matrix3<f64> {
    let rows = block.tensor();
    Matrix3::from_fn(|i, j| rows[i][j])
}

/// Mass, first and second moments `SUM r r^T dm` of piston and rod of a cylinder, about the origin.
fn of_cylinder(engine: &Engine, index: usize) -> Result<(f64, Vector3<f64>, Matrix3<f64>), MountError> {
    let cylinder = &engine.cylinders[index];
    let linkage = RodLinkage::new(engine, index)?;
    let throw = &engine.throws[cylinder.throw];
    let shaft = &engine.crankshafts[throw.crankshaft];
    let big_end = cylinder.rod.big_end_mass;
    let upper = cylinder.piston_mass + cylinder.rod.small_end_mass;
    let (mut first, mut second) = (Vector3::zeros(), Matrix3::zeros());
    // A revolution of the cylinder's own crankshaft.
    let turn = TAU / shaft.ratio.value().abs();
    let beside = cylinder.offset + cylinder.pin_offset;
    let (sin, cos) = cylinder.angle.sin_cos();
    for k in 0..ANGLES {
        let place = linkage.at(turn * k as f64 / ANGLES as f64);
        let travel = place.travel[0];
        let pin = [cos * travel - sin * beside, sin * travel + cos * beside];
        let lower = [place.lower_pin[0].re, place.lower_pin[0].im];
        for (mass, [x, y]) in [(upper, pin), (big_end, lower)] {
            let at = Vector3::new(shaft.x + x, shaft.y + y, cylinder.z);
            first += at * (mass / ANGLES as f64);
            second += at * at.transpose() * (mass / ANGLES as f64);
        }
    }
    Ok((upper + big_end, first, second))
}

/// Refuses a block that is no body.
fn check(block: &Block) -> Result<(), MountError> {
    let number =
        |quantity: &str, needed, got| Err(MountError::Number { quantity: quantity.to_owned(), needed, got });
    if !(block.mass > 0.0 && block.mass.is_finite()) {
        return number("mass of the block [kg]", "positive and finite", block.mass);
    }
    if let Some(&bad) = block.centre.iter().find(|c| !c.is_finite()) {
        return number("centre of the block [m]", "finite", bad);
    }
    let size = block.gravity.iter().map(|g| g * g).sum::<f64>().sqrt();
    if (size - 1.0).abs() > 1e-9 || size.is_nan() {
        return number("size of the direction of gravity", "1", size);
    }
    if let Some(&bad) = block.driveline_torque.iter().find(|t| !t.is_finite()) {
        return number("torque of the driveline [N m]", "finite", bad);
    }
    let Some(fault) = block.inertia_fault() else { return Ok(()) };
    let (axes, planes) = (["xx", "yy", "zz"], ["xy", "yz", "zx"]);
    let reason = match fault {
        InertiaFault::NotPositive(k) => {
            format!("I_{} must be positive, got {} kg m^2", axes[k], block.inertia[k])
        }
        InertiaFault::Triangle(k) => {
            let others = block.inertia[(k + 1) % 3] + block.inertia[(k + 2) % 3];
            let own = block.inertia[k];
            format!("I_{} must be at most the other two together, {others} kg m^2, got {own} kg m^2", axes[k])
        }
        InertiaFault::Product(k, most) => {
            let own = block.products[k];
            format!("P_{} must lie between -{most} and {most} kg m^2, got {own} kg m^2", planes[k])
        }
        InertiaFault::Products => "its three products of inertia contradict one another".to_owned(),
    };
    Err(MountError::Inertia {
        reason,
        hint: "moments and products are about the centre of mass, axes of the frame",
    })
}
