//! What a drilled hole takes away.
//!
//! Its first moment about the axis is that of [`lanchester_task::DrillBit`].

use lanchester_task::DrillBit;
use lanchester_task::workshop::{Drill, DrillDirection, Surface};
use serde::Serialize;
use std::f64::consts::PI;

/// A hole to drill.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Hole {
    /// Angle on the rotor [rad], within [0, 2 pi).
    pub angle: f64,
    /// Diameter of the drill [m].
    pub diameter: f64,
    /// Depth from the surface to the end of the full diameter [m].
    pub depth: f64,
    /// Depth from the surface that the tip of the drill reaches [m].
    pub tip: f64,
    /// Mass removed [kg].
    pub mass: f64,
    /// Unbalance removed, at its angle [kg m].
    pub unbalance: f64,
}

/// A drill on a surface of a material.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bit {
    bit: DrillBit,
    density: f64,
}

impl Bit {
    /// The drill of this diameter; `None` where it cannot make any hole there.
    pub(crate) fn of(drill: &Drill, radius: f64, diameter: f64) -> Option<Bit> {
        let on = (drill.direction, drill.surface);
        let bit = DrillBit::new(on, radius, diameter, (drill.point, drill.max_depth))?;
        Some(Bit { bit, density: drill.density })
    }

    /// Unbalance that a hole of this depth removes [kg m].
    pub(crate) fn unbalance(&self, depth: f64) -> f64 {
        self.density * self.bit.moment(depth)
    }

    /// Depth of the hole that removes this unbalance, held within what may be drilled [m].
    pub(crate) fn depth(&self, unbalance: f64) -> f64 {
        let (r, c) = (self.bit.radius, self.bit.point);
        let lever = unbalance / (self.density * self.bit.area());
        let depth = match self.bit.direction {
            DrillDirection::Axial => lever / r - c / 3.0,
            DrillDirection::Radial => {
                let slope = r - c / 3.0;
                let wanted = lever + self.bit.drop() - c / 3.0 * (r - c / 4.0);
                let root = slope * slope - 2.0 * wanted;
                if root < 0.0 { self.bit.range[1] } else { 2.0 * wanted / (slope + root.sqrt()) }
            }
        };
        depth.clamp(self.bit.range[0], self.bit.range[1])
    }

    /// Least and largest unbalance that one hole can remove [kg m].
    pub(crate) fn bounds(&self) -> [f64; 2] {
        self.bit.range.map(|depth| self.unbalance(depth))
    }

    /// Every depth that is a multiple of the step and may be drilled, rising [m].
    pub(crate) fn depths(&self, step: f64) -> Vec<f64> {
        self.bit.depths(step)
    }

    /// Depths from the least to the largest, so many and evenly apart [m].
    pub(crate) fn even_depths(&self, count: usize) -> Vec<f64> {
        let [least, most] = self.bit.range;
        (0..count).map(|k| least + (most - least) * k as f64 / (count - 1) as f64).collect()
    }

    /// Mass that a hole of this depth removes [kg].
    pub(crate) fn mass(&self, depth: f64) -> f64 {
        let (a, r) = (self.bit.diameter / 2.0, self.bit.radius);
        let full = match (self.bit.direction, self.bit.surface) {
            (DrillDirection::Radial, Surface::Round) => {
                // Mean height of the surface over the disc, y = a sin t; the trapezoidal rule is exact to rounding for a
                // smooth periodic integrand.
                const STEPS: usize = 64;
                let mean: f64 = (0..STEPS)
                    .map(|k| {
                        let (sine, cosine) = (PI * k as f64 / STEPS as f64).sin_cos();
                        2.0 * cosine * cosine * (r * r - a * a * sine * sine).sqrt()
                    })
                    .sum::<f64>()
                    / STEPS as f64;
                mean - (r - depth)
            }
            _ => depth,
        };
        self.density * self.bit.area() * (full + self.bit.point / 3.0)
    }

    /// The hole.
    pub(crate) fn hole(&self, angle: f64, depth: f64) -> Hole {
        Hole {
            angle,
            diameter: self.bit.diameter,
            depth,
            tip: depth + self.bit.point,
            mass: self.mass(depth),
            unbalance: self.unbalance(depth),
        }
    }
}

/// Least wall between two holes of one plane [m]; negative where they meet.
///
/// Axial holes are parallel. Radial ones come together towards the axis: the wall is least at the bottom corner of one
/// beside the flank of the other. The points below the full diameters are narrower and count as such.
pub(crate) fn wall(direction: DrillDirection, radius: f64, one: &Hole, other: &Hole) -> f64 {
    let apart = (one.angle - other.angle).abs().rem_euclid(2.0 * PI);
    let apart = apart.min(2.0 * PI - apart);
    let (a, b) = (one.diameter / 2.0, other.diameter / 2.0);
    match direction {
        DrillDirection::Axial => 2.0 * radius * (apart / 2.0).sin() - a - b,
        // Beyond a quarter turn the flanks part again.
        DrillDirection::Radial if apart >= PI / 2.0 => radius - one.depth.max(other.depth),
        DrillDirection::Radial => {
            let flank = |own: &Hole, own_half: f64, other_half: f64| {
                let bottom = radius - own.depth;
                bottom * apart.sin() - own_half * apart.cos() - other_half
            };
            flank(one, a, b).min(flank(other, b, a))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drill(direction: DrillDirection, surface: Surface, point: f64) -> Drill {
        Drill {
            direction,
            surface,
            diameters: vec![0.012],
            max_depth: 0.03,
            depth_step: None,
            point: point.to_radians(),
            density: 7850.0,
            land: 0.0,
            spacing: 0.0,
            most_holes: 3,
            angle_step: 0.1,
        }
    }

    /// Mass and static moment of what is removed, summed over thin slices across and along the hole.
    fn brute(bit: &Bit, depth: f64) -> (f64, f64) {
        let (a, r, c) = (bit.bit.diameter / 2.0, bit.bit.radius, bit.bit.point);
        let (n, m) = (1200, 240);
        let (mut volume, mut moment) = (0.0, 0.0);
        for i in 0..n {
            let y = -a + 2.0 * a * (i as f64 + 0.5) / n as f64;
            for j in 0..m {
                let z = -a + 2.0 * a * (j as f64 + 0.5) / m as f64;
                let rho = y.hypot(z);
                if rho > a {
                    continue;
                }
                let cell = (2.0 * a / n as f64) * (2.0 * a / m as f64);
                let top = match (bit.bit.direction, bit.bit.surface) {
                    (DrillDirection::Radial, Surface::Round) => (r * r - y * y).sqrt(),
                    _ => r,
                };
                let bottom = r - depth - c * (1.0 - rho / a);
                volume += cell * (top - bottom);
                moment += cell
                    * match bit.bit.direction {
                        DrillDirection::Radial => (top * top - bottom * bottom) / 2.0,
                        DrillDirection::Axial => (top - bottom) * r,
                    };
            }
        }
        (bit.density * volume, bit.density * moment)
    }

    #[test]
    fn formulas_agree_with_a_sum_over_slices() {
        for (direction, surface) in [
            (DrillDirection::Radial, Surface::Round),
            (DrillDirection::Radial, Surface::Flat),
            (DrillDirection::Axial, Surface::Flat),
        ] {
            for point in [118.0, 90.0, 180.0] {
                let bit = Bit::of(&drill(direction, surface, point), 0.05, 0.012).unwrap();
                for depth in [0.004, 0.015] {
                    let (mass, moment) = brute(&bit, depth);
                    // The cells at the rim of the disc are whole or missing: 2e-3.
                    assert!((bit.mass(depth) / mass - 1.0).abs() < 2e-3, "{direction:?} {surface:?} {point}");
                    assert!(
                        (bit.unbalance(depth) / moment - 1.0).abs() < 2e-3,
                        "{direction:?} {surface:?} {point}"
                    );
                }
            }
        }
    }

    #[test]
    fn depth_is_the_inverse_of_unbalance() {
        for direction in [DrillDirection::Radial, DrillDirection::Axial] {
            for surface in [Surface::Round, Surface::Flat] {
                let bit = Bit::of(&drill(direction, surface, 118.0), 0.05, 0.012).unwrap();
                for depth in [0.001, 0.01, 0.02] {
                    assert!((bit.depth(bit.unbalance(depth)) - depth).abs() < 1e-15, "{direction:?}");
                }
                assert_eq!(bit.depth(1.0), bit.bit.range[1], "held at the deepest");
                assert_eq!(bit.depth(0.0), bit.bit.range[0]);
            }
        }
    }

    /// A 12 mm drill of 118 deg, 20 mm deep into steel at 60 mm: by hand.
    #[test]
    fn an_axial_hole_by_hand() {
        let bit = Bit::of(&drill(DrillDirection::Axial, Surface::Flat, 118.0), 0.06, 0.012).unwrap();
        let cone = 6.0 / 59f64.to_radians().tan();
        let grams = 7.85e-3 * PI * 36.0 * (20.0 + cone / 3.0);
        assert!((bit.mass(0.02) * 1e3 - grams).abs() < 1e-12);
        assert!((bit.unbalance(0.02) * 1e6 - 60.0 * grams).abs() < 1e-9);
    }

    #[test]
    fn walls() {
        let bit = Bit::of(&drill(DrillDirection::Radial, Surface::Flat, 118.0), 0.05, 0.012).unwrap();
        let at = |degrees: f64, depth| bit.hole(degrees.to_radians(), depth);
        let (one, other) = (at(350.0, 0.01), at(20.0, 0.02));
        let shallow = wall(DrillDirection::Radial, 0.05, &one, &at(20.0, 0.01));
        let deep = wall(DrillDirection::Radial, 0.05, &one, &other);
        assert!(deep < shallow && deep > 0.0);
        // Bottom corner at 30 mm: 30 sin 30 - 6 cos 30 - 6.
        assert!((deep - (15.0 - 6.0 * 30f64.to_radians().cos() - 6.0) * 1e-3).abs() < 1e-12);
        let axial = wall(DrillDirection::Axial, 0.05, &one, &other);
        assert!((axial - (100.0 * 15f64.to_radians().sin() - 12.0) * 1e-3).abs() < 1e-12);
    }
}
