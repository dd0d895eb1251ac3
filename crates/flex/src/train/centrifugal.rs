//! What the centrifugal stress does to the stiffness of a turning crankshaft.
//!
//! ```text
//! S_ij = INT grad u_i : sigma grad u_j dV    sigma: stress under the centrifugal field of a unit of speed, carried by the mains     (book, eq. 51.14)
//! ```
//! A mass that turns on about the axis by a small angle keeps its distance from it: `N` alone, of straight displacements, would have it move outwards.

use super::coupling::{BearingPlace, Coupling};
use crate::FlexError;
use crate::case::StaticCase;
use crate::mesh::Mesh;
use crate::sparse::{Quantity, Structure, dot};
use crate::statics::StaticSystem;

/// Speed of the case [rad/s].
const SPEED: f64 = 100.0;

/// The centrifugal field of the elements with the forces of the mains that carry it, the least ones with its resultant and moment.
///
/// Weights without a shape are left out: their mass is in no matrix either.
pub(crate) fn carried_by_mains(
    mesh: &Mesh,
    base: &StaticCase,
    system: &StaticSystem<'_>,
    bearings: &[BearingPlace],
    couplings: &[Coupling],
) -> Result<StaticCase, FlexError> {
    let mut case = StaticCase { speed: SPEED, ..base.clone() };
    for (node, force) in mesh.weights.iter().flat_map(|weight| &weight.forces) {
        case = case.push(&[(*node, 1.0)], force.map(|force| -SPEED * SPEED * force));
    }
    let forces = system.forces(&case)?;
    let mains: Vec<(f64, &Coupling)> = bearings
        .iter()
        .zip(couplings)
        .filter(|(place, _)| place.set.starts_with("MAIN_"))
        .map(|(place, coupling)| (place.z, coupling))
        .collect();
    let count = mains.len().max(1) as f64;
    let middle = mains.iter().map(|(z, _)| z).sum::<f64>() / count;
    let spread: f64 = mains.iter().map(|(z, _)| (z - middle).powi(2)).sum();
    let sum = |arm: &dyn Fn(f64) -> f64| -> [f64; 2] {
        [0, 1].map(|axis| forces.iter().zip(&mesh.nodes).map(|(force, at)| arm(at[2]) * force[axis]).sum())
    };
    let (force, moment) = (sum(&|_| 1.0), sum(&|z| z - middle));
    for (z, coupling) in &mains {
        // One main alone carries no moment: the inertia of the body does.
        let tilt = if spread > 0.0 { (z - middle) / spread } else { 0.0 };
        case = coupling.push(case, [0, 1].map(|axis| -force[axis] / count - tilt * moment[axis]));
    }
    Ok(case)
}

/// `S` for these shapes, row by row, from the displacements under [`carried_by_mains`].
pub(crate) fn geometric(
    mesh: &Mesh,
    structure: &Structure,
    displacements: &[[f64; 3]],
    shapes: &[Vec<f64>],
) -> Vec<f64> {
    let images = structure.assemble(mesh, Quantity::Geometric(displacements), &[]).multiply_all(shapes);
    let unit = 1.0 / (SPEED * SPEED);
    shapes.iter().flat_map(|shape| images.iter().map(move |image| unit * dot(shape, image))).collect()
}
