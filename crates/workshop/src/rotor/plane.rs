//! Correction planes: any set of unbalances on one shaft as two, and back.
//!
//! ```text
//! U_1 = SUM U (z_2 - z) / (z_2 - z_1),   U_2 = SUM U (z - z_1) / (z_2 - z_1)
//! ```
//! keeps `SUM U` and `SUM z U`, so that a rigid shaft cannot tell the two from the many.

use crate::error::WorkshopError;
use lanchester_model::Engine;
use num_complex::Complex64;
use serde::Serialize;

/// A plane across the shaft with a name.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Plane {
    /// What it is called.
    pub name: String,
    /// Where it is [m], from the origin.
    pub z: f64,
}

/// An unbalance in a plane.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PlaneUnbalance {
    /// Name of the plane or of what brings the unbalance.
    pub name: String,
    /// Plane [m], from the origin.
    pub z: f64,
    /// Unbalance in the frame of the crankshaft [kg m].
    #[schemars(with = "[f64; 2]")]
    pub unbalance: Complex64,
}

/// The outermost planes of a crankshaft (by index) that can carry weights: of its webs, or of its throws where the file
/// has no webs. One plane, or none, where there are not two.
pub fn end_planes(engine: &Engine, crankshaft: usize) -> Vec<Plane> {
    let planes = engine
        .throws
        .iter()
        .filter(|t| t.crankshaft == crankshaft)
        .flat_map(|t| t.webs.map_or(vec![t.z], |webs| webs.to_vec()));
    let (low, high) = planes.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), z| (l.min(z), h.max(z)));
    let ends = if high > low { vec![("front", low), ("rear", high)] } else { vec![("throw", low)] };
    ends.into_iter().filter(|(_, z)| z.is_finite()).map(|(name, z)| Plane { name: name.into(), z }).collect()
}

/// Planes closer together than this share of the length of the shaft cannot be told apart.
const CLOSEST: f64 = 1e-6;

/// The unbalances as two in the planes given.
///
/// # Errors
/// [`WorkshopError`] where the planes coincide or are not finite.
pub fn in_two_planes(
    unbalances: &[PlaneUnbalance],
    planes: &[Plane; 2],
) -> Result<[PlaneUnbalance; 2], WorkshopError> {
    let [first, second] = planes;
    let distance = second.z - first.z;
    let length = unbalances.iter().fold(first.z.abs().max(second.z.abs()), |m, u| m.max(u.z.abs()));
    if distance.abs() <= CLOSEST * length || !distance.is_finite() {
        return Err(WorkshopError::Number {
            quantity: "distance [m]",
            part: format!("the planes `{}` and `{}`", first.name, second.name),
            needed: "different from 0".into(),
            got: distance,
            hint: "choose two planes apart from each other along the crank",
        });
    }
    let sum: Complex64 = unbalances.iter().map(|u| u.unbalance).sum();
    let moment: Complex64 = unbalances.iter().map(|u| u.unbalance * (u.z - first.z)).sum();
    let rear = moment / distance;
    let at = |plane: &Plane, unbalance| PlaneUnbalance { name: plane.name.clone(), z: plane.z, unbalance };
    Ok([at(first, sum - rear), at(second, rear)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn plane(name: &str, z: f64) -> Plane {
        Plane { name: name.into(), z }
    }

    /// 30 g mm a third of the way along is 20 and 10 g mm.
    #[test]
    fn by_the_lever() {
        let one = [PlaneUnbalance { name: "w".into(), z: 0.1, unbalance: Complex64::new(0.0, 3e-5) }];
        let [front, rear] = in_two_planes(&one, &[plane("a", 0.0), plane("b", 0.3)]).unwrap();
        assert!((front.unbalance.im - 2e-5).abs() < 1e-18 && (rear.unbalance.im - 1e-5).abs() < 1e-18);
        let error = in_two_planes(&one, &[plane("a", 0.1), plane("b", 0.1)]).unwrap_err().to_string();
        assert!(error.contains("`a` and `b`"), "{error}");
    }

    proptest! {
        /// Sum and moment stay; a second transfer and back changes nothing.
        #[test]
        fn prop_sum_and_moment_stay(
            parts in proptest::collection::vec((-0.5f64..0.5, -0.01f64..0.01, -0.01f64..0.01), 1..8),
            low in -0.6f64..-0.1, high in 0.1f64..0.6,
        ) {
            let parts: Vec<_> = parts.into_iter().map(|(z, x, y)| PlaneUnbalance {
                name: String::new(), z, unbalance: Complex64::new(x, y),
            }).collect();
            let outside = in_two_planes(&parts, &[plane("a", low), plane("b", high)]).unwrap();
            let sum = |list: &[PlaneUnbalance]| list.iter().map(|u| u.unbalance).sum::<Complex64>();
            let moment = |list: &[PlaneUnbalance]| list.iter().map(|u| u.z * u.unbalance).sum::<Complex64>();
            prop_assert!((sum(&parts) - sum(&outside)).norm() < 1e-15);
            prop_assert!((moment(&parts) - moment(&outside)).norm() < 1e-15);
            let inside = [plane("c", -0.05), plane("d", 0.07)];
            let there = in_two_planes(&outside, &inside).unwrap();
            let back = in_two_planes(&there, &[plane("a", low), plane("b", high)]).unwrap();
            for (one, two) in outside.iter().zip(&back) {
                prop_assert!((one.unbalance - two.unbalance).norm() < 1e-13);
            }
        }
    }
}
