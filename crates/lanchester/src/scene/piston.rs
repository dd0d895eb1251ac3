//! Pistons and liners. Frame: x along the cylinder away from the crankshaft, from the height of the piston pin, z along the crank.

use super::Builder;
use super::cylinder::Poses;
use super::mesh::{Ring, SceneMesh};
use lanchester_geometry::{Contour, Corner, Outline, Point};
use num_complex::Complex64;

/// Height of the crown above the pin, in bores.
const CROWN: f64 = 0.40;
/// Length of the skirt below the pin, in bores.
const SKIRT: f64 = 0.28;
/// Radius of the piston pin, in bores.
const PIN: f64 = 0.125;
/// How much smaller the piston is than the bore.
const GAP: f64 = 0.985;

impl Builder<'_> {
    /// From the pin to the lower edge of the skirt [m].
    pub(super) fn skirt(&self, index: usize) -> f64 {
        let given = self.engine.envelope.and_then(|envelope| envelope.skirt).map(|skirt| skirt.length);
        given.unwrap_or(SKIRT * self.proportions.bores[index])
    }

    /// Radius of the piston pin [m].
    pub(super) fn piston_pin_radius(&self, index: usize) -> f64 {
        let given = self.engine.bearings.and_then(|bearings| bearings.piston_pin?.diameter);
        given.map_or(PIN * self.proportions.bores[index], |diameter| diameter / 2.0)
    }

    /// From the pin to the crown [m]: less where another piston comes from the other side.
    fn crown(&self, index: usize, poses: &Poses) -> f64 {
        let usual = CROWN * self.proportions.bores[index];
        match self.opposite(index) {
            Some((other, distance)) => {
                let tops = self.poses(other).map_or(0.0, |other| other.ends()[1]) + poses.ends()[1];
                usual.min((0.48 * (distance - tops)).max(0.2 * usual))
            }
            None => usual,
        }
    }

    /// The cylinder that faces this one from another crankshaft, and the distance of their feet [m].
    fn opposite(&self, index: usize) -> Option<(usize, f64)> {
        let engine = self.engine;
        let foot = |index: usize| {
            let cylinder = &engine.cylinders[index];
            let crankshaft = &engine.crankshafts[engine.throws[cylinder.throw].crankshaft];
            let along = Complex64::cis(cylinder.angle);
            (Complex64::new(crankshaft.x, crankshaft.y) + along * Complex64::new(0.0, cylinder.offset), along)
        };
        let (own, along) = foot(index);
        (0..engine.cylinders.len()).find_map(|other| {
            let (at, back) = foot(other);
            let apart = (at - own) / along;
            let faces = (along + back).norm() < 1e-6
                && (engine.cylinders[other].z - engine.cylinders[index].z).abs() < 1e-6
                && apart.im.abs() < 0.1 * self.proportions.bores[index];
            (faces && apart.re > 1e-6).then_some((other, apart.re))
        })
    }

    /// Crown with ring grooves, two skirts, bosses and the pin.
    pub(super) fn piston(&self, index: usize, poses: &Poses) -> Option<SceneMesh> {
        let (bore, cylinder) = (self.proportions.bores[index], &self.engine.cylinders[index]);
        let (crown, skirt, pin) =
            (self.crown(index, poses), self.skirt(index), self.piston_pin_radius(index));
        let radius = GAP * bore / 2.0;
        let facet_error = self.meshes.facet_error;
        // The crown is solid down to a little above the small end.
        let under = crown - (0.2 * bore).min(0.5 * crown);
        let ring = |along: f64, radius: f64| Ring { along, radius };
        let mut rings = vec![ring(under, 0.0), ring(under, radius)];
        let (land, groove) = (0.22 * (crown - under), 0.13 * (crown - under));
        for number in 0..2 {
            let from = under + land + f64::from(number) * (land + groove);
            for (along, radius) in [
                (from, radius),
                (from, 0.955 * radius),
                (from + groove, 0.955 * radius),
                (from + groove, radius),
            ] {
                rings.push(ring(along, radius));
            }
        }
        let edge = 0.06 * (crown - under);
        rings.extend([ring(crown - edge, radius), ring(crown, radius - edge), ring(crown, 0.0)]);
        let mut mesh = SceneMesh::turned(&rings);

        // Skirts carry the side thrust: they stand across the crank, in the plane of the page (z, x) turned about the cylinder.
        let panel = panel(0.9 * radius, radius, 0.62)?;
        let length = under + skirt;
        if let Some(panel) = SceneMesh::plate(&panel, length, 0.0, facet_error) {
            // A plate's x and y become y and z of the piston.
            let at = (under - skirt) / 2.0;
            let one = panel.rolled().moved([at, 0.0, 0.0]);
            mesh = mesh.with(&one.clone().turned_over()).with(&one);
        }
        let boss = boss(1.55 * pin, under)?.moved(Point::new(0.0, cylinder.pin_offset));
        let circle =
            |radius: f64| Some(Contour::circle(Point::new(0.0, cylinder.pin_offset), radius).ok()?.into());
        let width = 0.14 * bore;
        for side in [-1.0, 1.0] {
            let z = side * (0.33 * bore - width / 2.0);
            mesh = mesh.with(&SceneMesh::plate(&boss, width, z, facet_error)?);
        }
        Some(mesh.with(&SceneMesh::plate(&circle(pin)?, 0.7 * bore, 0.0, facet_error)?))
    }

    /// A tube in which the piston moves.
    pub(super) fn liner(&self, index: usize, poses: &Poses) -> Option<SceneMesh> {
        let bore = self.proportions.bores[index];
        let [bottom, top] = poses.ends();
        let given = self.engine.envelope.and_then(|envelope| envelope.liner);
        let low = given.map_or(bottom - 0.5 * self.skirt(index), |liner| liner.end);
        let mut high = top + self.crown(index, poses) + 0.02 * bore;
        if let Some((_, distance)) = self.opposite(index) {
            high = high.min(distance / 2.0);
        }
        let (inner, outer) = (bore / 2.0, bore / 2.0 + given.map_or(0.035 * bore, |liner| liner.wall));
        let ring = |along: f64, radius: f64| Ring { along, radius };
        (high > low).then(|| {
            SceneMesh::turned(&[
                ring(low, inner),
                ring(low, outer),
                ring(high, outer),
                ring(high, inner),
                ring(low, inner),
            ])
        })
    }
}

/// A piece of a ring about the origin towards +x, up to where it is `share` of the radius wide.
fn panel(inner: f64, outer: f64, share: f64) -> Option<Outline> {
    let half = f64::asin(share);
    let bulge = (half / 2.0).tan();
    let corners = [
        Corner { at: Point::polar(outer, -half), bulge },
        Corner { at: Point::polar(outer, half), bulge: 0.0 },
        Corner { at: Point::polar(inner, half), bulge: -bulge },
        Corner { at: Point::polar(inner, -half), bulge: 0.0 },
    ];
    Outline::new(Contour::new(&corners).ok()?, Vec::new()).ok()
}

/// Half a disc about the pin that goes on up to the crown at `height`.
fn boss(radius: f64, height: f64) -> Option<Outline> {
    let corners = [
        Corner { at: Point::new(height.max(0.1 * radius), radius), bulge: 0.0 },
        Corner { at: Point::new(0.0, radius), bulge: 1.0 },
        Corner { at: Point::new(0.0, -radius), bulge: 0.0 },
        Corner { at: Point::new(height.max(0.1 * radius), -radius), bulge: 0.0 },
    ];
    Outline::new(Contour::new(&corners).ok()?, Vec::new()).ok()
}
