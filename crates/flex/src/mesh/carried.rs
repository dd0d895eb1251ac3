//! Centrifugal force of a weight whose shape is not known, spread over elements.
//!
//! ```text
//! b = a + t x (x - x_m)    a = F/V    INT (r.r 1 - r r^T) dV t = (p - x_m) x F    f_i = INT N_i b dV    r = x - x_m         (book, eq. 43.18)
//! ```
//! `x_m` is the middle of the elements, `V` their volume, `p` a point of the line of the force. The field of forces `b` is the one of least square that has the
//! resultant and the moment of `F`.

use super::{CarriedWeight, Mesh};
use crate::element::{ElementKind, ShapeValues, gradients, mass_rule, shape_values};
use lanchester_numerics::Lu;
use std::collections::BTreeMap;

/// Kinds of elements with the points of their mass and the shape functions there.
type Rules = Vec<Vec<(f64, ShapeValues)>>;

impl CarriedWeight {
    /// A weight whose force these elements carry; `None` where they have no volume.
    pub fn over(
        mesh: &Mesh,
        elements: &[usize],
        [name, place]: [&str; 2],
        unbalance: [f64; 2],
        z: f64,
    ) -> Option<CarriedWeight> {
        let rules: Rules = ElementKind::ALL
            .iter()
            .map(|kind| {
                let rule = mass_rule(*kind).into_iter();
                rule.map(|point| (point.weight, shape_values(*kind, point.at))).collect()
            })
            .collect();
        // Volume, first and second moments.
        let mut sums = [0.0; 10];
        each_point(mesh, elements, &rules, |_, _, volume, [x, y, z]| {
            let parts = [1.0, x, y, z, x * x, y * y, z * z, x * y, y * z, z * x];
            sums.iter_mut().zip(parts).for_each(|(sum, part)| *sum += volume * part);
        });
        let volume = sums[0];
        if volume.is_nan() || volume <= 0.0 {
            return None;
        }
        let middle: [f64; 3] = std::array::from_fn(|k| sums[k + 1] / volume);
        let [mx, my, mz] = middle;
        let [xx, yy, zz] = std::array::from_fn(|k| sums[k + 4] - volume * middle[k].powi(2));
        let [xy, yz, zx] =
            [sums[7] - volume * mx * my, sums[8] - volume * my * mz, sums[9] - volume * mz * mx];
        let mut turn = cross([-mx, -my, z - mz], [unbalance[0], unbalance[1], 0.0]).to_vec();
        let spread = vec![yy + zz, -xy, -zx, -xy, zz + xx, -yz, -zx, -yz, xx + yy];
        Lu::new(3, spread).ok()?.solve(&mut turn);
        let turn = [turn[0], turn[1], turn[2]];
        let mut forces: BTreeMap<u32, [f64; 3]> = BTreeMap::new();
        each_point(mesh, elements, &rules, |nodes, shape, volume, at| {
            let by_turn = cross(turn, std::array::from_fn(|k| at[k] - middle[k]));
            let even = [unbalance[0] / sums[0], unbalance[1] / sums[0], 0.0];
            for (node, n) in nodes.iter().zip(shape.n) {
                let force = forces.entry(*node).or_default();
                for axis in 0..3 {
                    force[axis] += n * volume * (even[axis] + by_turn[axis]);
                }
            }
        });
        let (name, place, forces) = (name.to_owned(), place.to_owned(), forces.into_iter().collect());
        Some(CarriedWeight { name, unbalance, z, place, forces })
    }
}

fn each_point(
    mesh: &Mesh,
    elements: &[usize],
    rules: &Rules,
    mut act: impl FnMut(&[u32], &ShapeValues, f64, [f64; 3]),
) {
    for element in elements.iter().map(|index| &mesh.elements[*index]) {
        let places = mesh.places(element);
        for (weight, shape) in &rules[element.kind as usize] {
            let (determinant, _) = gradients(&places, shape);
            let at = std::array::from_fn(|axis| places.iter().zip(shape.n).map(|(at, n)| n * at[axis]).sum());
            act(&element.nodes, shape, weight * determinant, at);
        }
    }
}

/// Vector product.
pub(crate) fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}
