//! What a balancing machine shows, plane by plane.

use crate::rotor::plane::PlaneUnbalance;
use lanchester_task::workshop::{Display, DisplayKind};
use num_complex::Complex64;

/// The heavy spots that a balancing machine shows; a couple is its two opposed unbalances.
pub fn displayed(displays: &[Display]) -> Vec<PlaneUnbalance> {
    let mut planes = Vec::with_capacity(displays.len());
    for (index, display) in displays.iter().enumerate() {
        let name = format!("display {}", index + 1);
        let unbalance = Complex64::from_polar(display.unbalance, display.angle);
        match display.kind {
            DisplayKind::Plane { z } => planes.push(PlaneUnbalance { name, z, unbalance }),
            DisplayKind::Couple { z: [first, second] } => planes.extend([
                PlaneUnbalance { name: name.clone(), z: first, unbalance },
                PlaneUnbalance { name, z: second, unbalance: -unbalance },
            ]),
        }
    }
    planes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rotor::plane::{Plane, in_two_planes};

    #[test]
    fn a_couple_needs_twice_as_much_at_half_the_distance() {
        let couple = Display { kind: DisplayKind::Couple { z: [0.0, 0.2] }, unbalance: 1e-4, angle: 0.3 };
        let shown = displayed(&[couple]);
        assert_eq!(shown[0].unbalance, -shown[1].unbalance);
        let planes = [("a", 0.05), ("b", 0.15)].map(|(name, z)| Plane { name: name.into(), z });
        let near = in_two_planes(&shown, &planes).unwrap();
        assert!((near[0].unbalance - shown[0].unbalance * 2.0).norm() < 1e-18);
    }
}
