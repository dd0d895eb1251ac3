//! What a drilled hole takes away, and the holes and slugs that a free weight is chosen from.
//!
//! Drill of radius a, depth h to the end of the full diameter, point of height `c = a/tan(point/2)` below it; R is the radius of the
//! drilled surface (radial) or of the circle of holes (axial). First moment about the axis, over the density:
//!
//! ```text
//! radial, flat     S = pi a^2 ( R h - h^2/2           + (c/3)(R - h - c/4) )
//! radial, round    S = pi a^2 ( R h - h^2/2 - a^2/8   + (c/3)(R - h - c/4) )
//! axial            S = pi a^2 ( h + c/3 ) R
//! ```
//! The centre of what a radial hole removes moves towards the axis as the hole gets deeper: that is the `h^2/2`. The round
//! surface drops away beside the crown, from which the depth is counted: that is the `a^2/8`, exact for a cylinder, as the
//! first moment of its part above the bottom is `1/2 INTEGRAL (R^2 - y^2 - (R - h)^2) dA` over the disc of the hole.
//!
//! A slug fills the hole but for its point, flush with the surface: it is the same with c = 0, with its own density.

use crate::workshop::{DrillDirection, Surface};
use serde::Serialize;
use std::f64::consts::PI;

/// Angle of the point of a common twist drill [deg] (ISO 235 leaves it to the maker; 118 deg is what shops stock).
pub const DRILL_POINT: f64 = 118.0;
/// Holes with unbalances that differ by less than this share are one: the first of them stands.
const ONE_AMOUNT: f64 = 1e-9;
/// A step that small is no step: a file may say anything.
const MOST_DEPTHS: f64 = 10_000.0;

/// A drill on a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrillBit {
    /// Diameter [m].
    pub diameter: f64,
    /// Height of its point [m].
    pub point: f64,
    /// Radius of the surface or of the circle of holes [m].
    pub radius: f64,
    /// Along which line it drills.
    pub direction: DrillDirection,
    /// Surface on which it begins.
    pub surface: Surface,
    /// Least and largest depth to the end of the full diameter [m].
    pub range: [f64; 2],
}

impl DrillBit {
    /// The drill of this diameter [m] whose point has this angle [rad] and whose tip may reach `max_depth` [m]; `None` where it cannot
    /// make any hole on a surface of this radius [m].
    pub fn new(
        (direction, surface): (DrillDirection, Surface),
        radius: f64,
        diameter: f64,
        (point, max_depth): (f64, f64),
    ) -> Option<DrillBit> {
        let a = diameter / 2.0;
        let point = if point >= PI { 0.0 } else { a / (point / 2.0).tan() };
        let radial = direction == DrillDirection::Radial;
        // Shallower than this, a round surface is not cut over the whole width.
        let least = match surface {
            Surface::Round if radial && a >= radius => return None,
            Surface::Round if radial => radius - (radius * radius - a * a).sqrt(),
            _ => 0.0,
        };
        let deepest = if radial { max_depth.min(radius) } else { max_depth };
        let range = [least, deepest - point];
        (range[0] <= range[1]).then_some(DrillBit { diameter, point, radius, direction, surface, range })
    }

    /// Area of the full diameter [m^2].
    pub fn area(&self) -> f64 {
        PI * self.diameter * self.diameter / 4.0
    }

    /// What a round surface lacks beside its crown [m^2].
    pub fn drop(&self) -> f64 {
        match self.surface {
            Surface::Round if self.direction == DrillDirection::Radial => {
                self.diameter * self.diameter / 32.0
            }
            _ => 0.0,
        }
    }

    /// First moment about the axis of a hole of this depth [m^4].
    pub fn moment(&self, depth: f64) -> f64 {
        self.moment_with(depth, self.point)
    }

    /// First moment of a slug in a hole of this depth, which leaves the point of the drill empty [m^4].
    pub fn slug_moment(&self, depth: f64) -> f64 {
        self.moment_with(depth, 0.0)
    }

    fn moment_with(&self, depth: f64, c: f64) -> f64 {
        let r = self.radius;
        let lever = match self.direction {
            DrillDirection::Radial => {
                r * depth - depth * depth / 2.0 - self.drop() + c / 3.0 * (r - depth - c / 4.0)
            }
            DrillDirection::Axial => (depth + c / 3.0) * r,
        };
        self.area() * lever
    }

    /// Every depth that is a multiple of the step and may be drilled, rising [m].
    pub fn depths(&self, step: f64) -> Vec<f64> {
        let first = (self.range[0] / step - 1e-9).ceil().max(0.0);
        let last = (self.range[1] / step + 1e-9).floor();
        let count = ((last - first).max(-1.0) + 1.0).min(MOST_DEPTHS) as usize;
        (0..count).map(|k| (first + k as f64) * step).collect()
    }
}

/// Holes of which a free weight is one: it is what the hole removes, opposite to it, or what a slug in it adds.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct DrillCatalogue {
    /// Along which line holes are drilled.
    pub direction: DrillDirection,
    /// Shape of the surface where a radial hole begins; an axial hole begins on a flat face.
    pub surface: Surface,
    /// Radius of the drilled surface (radial), or of the circle of holes (axial) [m].
    pub radius: f64,
    /// Diameters of the drills [m], rising.
    pub diameters: Vec<f64>,
    /// Depth from the surface that the tip of the drill may reach [m].
    pub max_depth: f64,
    /// Depths to the end of the full diameter are multiples of this [m].
    pub depth_step: f64,
    /// Angle of the drill point [rad]; pi is a flat bottom.
    pub point: f64,
    /// Density of what is drilled [kg/m^3].
    pub density: f64,
    /// Density of the slugs that fill the holes [kg/m^3]; none: the holes stay empty.
    pub slug_density: Option<f64>,
}

/// A hole of a catalogue.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CatalogueHole {
    /// Diameter of the drill [m].
    pub diameter: f64,
    /// Depth from the surface to the end of the full diameter [m].
    pub depth: f64,
    /// Depth from the surface that the tip of the drill reaches [m].
    pub tip: f64,
    /// Unbalance that the hole removes, or that the slug in it adds beyond what was drilled away [kg m].
    pub unbalance: f64,
    /// Density of the slug that fills it [kg/m^3]; none: it stays empty.
    pub slug_density: Option<f64>,
}

impl DrillCatalogue {
    /// Whole and half millimetres from 1 mm to 20 mm: the drills that every shop has [m].
    pub fn metric() -> Vec<f64> {
        (2..=40).map(|half| 0.5e-3 * f64::from(half)).collect()
    }

    /// How many holes it can have at most, some of which may weigh the same.
    pub fn count(&self) -> usize {
        let most = (self.max_depth / self.depth_step).min(MOST_DEPTHS) as usize;
        self.diameters.len().saturating_mul(most + 1)
    }

    /// Its holes by rising unbalance, each above zero; of those that weigh the same the one with the smallest drill.
    pub fn holes(&self) -> Vec<CatalogueHole> {
        let mut holes = Vec::new();
        for &diameter in &self.diameters {
            let on = (self.direction, self.surface);
            let Some(bit) = DrillBit::new(on, self.radius, diameter, (self.point, self.max_depth)) else {
                continue;
            };
            for depth in bit.depths(self.depth_step) {
                let removed = self.density * bit.moment(depth);
                let added = self.slug_density.map(|density| density * bit.slug_moment(depth));
                let unbalance = added.map_or(removed, |added| added - removed);
                if depth > 0.0 && unbalance > 0.0 {
                    let (tip, slug_density) = (depth + bit.point, self.slug_density);
                    holes.push(CatalogueHole { diameter, depth, tip, unbalance, slug_density });
                }
            }
        }
        // Stable: of equal ones the smallest drill comes first.
        holes.sort_by(|a, b| a.unbalance.total_cmp(&b.unbalance));
        holes.dedup_by(|a, b| (a.unbalance - b.unbalance).abs() <= ONE_AMOUNT * b.unbalance.abs());
        holes
    }

    /// The hole with this unbalance [kg m], to rounding.
    pub fn hole(&self, unbalance: f64) -> Option<CatalogueHole> {
        let is_it = |hole: &CatalogueHole| (hole.unbalance - unbalance).abs() <= 1e-6 * unbalance;
        let distance = |hole: &CatalogueHole| (hole.unbalance - unbalance).abs();
        let nearest = self.holes().into_iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
        nearest.filter(is_it)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn catalogue() -> DrillCatalogue {
        DrillCatalogue {
            direction: DrillDirection::Radial,
            surface: Surface::Round,
            radius: 0.06,
            diameters: vec![0.008, 0.012],
            max_depth: 0.02,
            depth_step: 0.002,
            point: 118f64.to_radians(),
            density: 7850.0,
            slug_density: None,
        }
    }

    /// First moment of the hole by cubes: all that lies below the surface, within the full diameter or the cone of the point.
    fn by_cells(bit: &DrillBit, depth: f64, point: f64) -> f64 {
        let (a, steps) = (bit.diameter / 2.0, 160);
        let cell = 2.0 * a / f64::from(steps);
        let mut sum = 0.0;
        for j in 0..steps {
            for k in 0..steps {
                let (y, z) = (-a + (f64::from(j) + 0.5) * cell, -a + (f64::from(k) + 0.5) * cell);
                let s = y.hypot(z);
                if s > a {
                    continue;
                }
                let r = bit.radius;
                let top = if bit.surface == Surface::Round { (r * r - y * y).sqrt() } else { r };
                let bottom = r - depth - point * (1.0 - s / a);
                sum += cell * cell * (top * top - bottom * bottom) / 2.0;
            }
        }
        sum
    }

    #[test]
    fn moments_are_those_of_the_cells() {
        for surface in [Surface::Round, Surface::Flat] {
            let on = (DrillDirection::Radial, surface);
            let bit = DrillBit::new(on, 0.06, 0.012, (118f64.to_radians(), 0.03)).expect("a hole");
            for depth in [0.002, 0.01, 0.025] {
                for (own, point) in [(bit.moment(depth), bit.point), (bit.slug_moment(depth), 0.0)] {
                    let cells = by_cells(&bit, depth, point);
                    assert!((own / cells - 1.0).abs() < 1e-3, "{surface:?} {depth}: {own} {cells}");
                }
            }
        }
    }

    #[test]
    fn holes_rise_and_are_found_by_their_unbalance() {
        let mut catalogue = catalogue();
        for slug_density in [None, Some(18_000.0)] {
            catalogue.slug_density = slug_density;
            let holes = catalogue.holes();
            assert!(holes.len() > 10 && holes.is_sorted_by(|a, b| a.unbalance < b.unbalance), "{holes:?}");
            for hole in &holes {
                let steps = hole.depth / 0.002;
                assert!(hole.tip <= 0.02 + 1e-12 && (steps - steps.round()).abs() < 1e-9, "{hole:?}");
                assert_eq!(catalogue.hole(hole.unbalance), Some(*hole));
            }
        }
        assert_eq!(catalogue.hole(1.0), None);
        // A slug lighter than what was drilled away adds nothing.
        catalogue.slug_density = Some(2700.0);
        assert_eq!(catalogue.holes(), []);
    }

    #[test]
    fn the_standard_drills_are_whole_and_half_millimetres() {
        let metric = DrillCatalogue::metric();
        assert_eq!((metric.len(), metric[0]), (39, 0.001));
        assert!((metric[38] - 0.02).abs() < 1e-15);
    }
}
