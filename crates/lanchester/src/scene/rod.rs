//! Connecting rods. Frame: x from the big end's eye towards the small end's, z along the crank.

use super::Builder;
use super::mesh::SceneMesh;
use lanchester_geometry::{Contour, Outline, Point};
use lanchester_model::RodJoint;

/// What of a rod's width a slice of it takes: from and to, in half widths from the middle plane.
type Slice = [f64; 2];

const WHOLE: Slice = [-1.0, 1.0];

impl Builder<'_> {
    /// Two eyes and a shank with flanges; a master's big end has cheeks for its knuckle pins.
    pub(super) fn rod(&self, index: usize) -> Option<SceneMesh> {
        let engine = self.engine;
        let rod = &engine.cylinders[index].rod;
        let half = self.proportions.rod_half_widths[index];
        let knuckles = self.knuckles(index);
        let slave = match rod.joint {
            RodJoint::Articulated { master, .. } => Some(self.knuckle_radius(master)),
            _ => None,
        };
        let pin = slave.unwrap_or(self.proportions.pin_radius);
        let small_pin = self.piston_pin_radius(index);
        let given = engine.envelope.and_then(|envelope| envelope.rod);
        let eye = match (slave, given) {
            (None, Some(given)) => given.big_end_radius.max(1.05 * pin),
            _ => 1.32 * pin,
        };
        let small_eye = 1.4 * small_pin;
        let length = rod.length;
        let mut mesh = Plates { mesh: SceneMesh::default(), half, facet_error: self.meshes.facet_error };

        let slices: &[Slice] = match (rod.joint, knuckles.is_empty()) {
            (RodJoint::Fork, _) => &[[-1.0, -0.5], [0.5, 1.0]],
            (RodJoint::Blade, _) => &[[-0.46, 0.46]],
            (RodJoint::Articulated { .. }, _) => &[[-0.5, 0.5]],
            _ => &[WHOLE],
        };
        for slice in slices {
            mesh.plate(ring(0.0, eye, pin)?, *slice);
        }
        if let Some(reach) = knuckles.iter().map(|knuckle| knuckle.norm()).reduce(f64::max) {
            let radius = self.knuckle_radius(index);
            let cheek = Outline::new(
                Contour::circle(Point::ORIGIN, (reach + 1.45 * radius).max(eye)).ok()?,
                vec![Contour::circle(Point::ORIGIN, pin).ok()?],
            );
            let cheek = cheek.ok()?;
            mesh.plate(cheek.clone(), [-1.0, -0.56]);
            mesh.plate(cheek, [0.56, 1.0]);
            for knuckle in &knuckles {
                mesh.plate(Contour::circle(*knuckle, radius).ok()?.into(), [-1.06, 1.06]);
            }
        }
        let small = if slave.is_some() { [-0.75, 0.75] } else { [-0.85, 0.85] };
        mesh.plate(ring(length, small_eye, small_pin)?, small);

        // Flanges end within the eyes.
        let wide = given.map_or(0.62 * eye.min(1.6 * small_eye), |given| given.shank_width / 2.0);
        let (low, high) = (wide.min(0.9 * eye), (0.8 * wide).min(0.9 * small_eye));
        let is_fork = matches!(rod.joint, RodJoint::Fork);
        let into = |radius: f64, half: f64| ((radius - half) * (radius + half)).max(0.0).sqrt();
        let start =
            if is_fork { (1.45 * eye).min(0.4 * length) } else { into(1.02 * eye, low).max(1.02 * pin) };
        let start = knuckles.iter().map(|knuckle| knuckle.norm()).fold(start, f64::max).min(0.6 * length);
        let end = length - into(1.02 * small_eye, high).max(1.02 * small_pin);
        let (from, to) = (start - 0.08 * eye, end + 0.08 * small_eye);
        if to > from {
            let thick = given.map_or(0.62, |given| (given.shank_thickness / 2.0 / half).min(1.0));
            mesh.plate(strip([from, to], [low, -low], [high, -high])?, [-0.4 * thick, 0.4 * thick]);
            let flange = 0.26;
            for side in [-1.0, 1.0] {
                let (outer, inner) = ([side * low, side * high], 1.0 - flange);
                let one = strip([from, to], [outer[0], outer[0] * inner], [outer[1], outer[1] * inner])?;
                mesh.plate(one, [-thick, thick]);
            }
        }
        if is_fork {
            // Legs on both sides of the blade.
            for slice in [[-1.0, -0.5], [0.5, 1.0]] {
                mesh.plate(strip([0.9 * eye.min(start), start * 1.06], [low, -low], [low, -low])?, slice);
            }
            mesh.plate(strip([start, start * 1.06], [low, -low], [low, -low])?, WHOLE);
        }
        Some(mesh.mesh)
    }

    /// Knuckle pins on the rod of a master, in its frame [m].
    fn knuckles(&self, index: usize) -> Vec<Point> {
        let joint = |joint: RodJoint| match joint {
            RodJoint::Articulated { master, knuckle_radius, knuckle_angle } if master == index => {
                Some(Point::polar(knuckle_radius, knuckle_angle))
            }
            _ => None,
        };
        self.engine.cylinders.iter().filter_map(|cylinder| joint(cylinder.rod.joint)).collect()
    }

    /// Radius of the knuckle pins of a master [m]: a third of what is between neighbours, or between a knuckle pin and the crankpin.
    fn knuckle_radius(&self, master: usize) -> f64 {
        let knuckles = self.knuckles(master);
        let pin = self.proportions.pin_radius;
        let mut most = 0.6 * pin;
        for (number, knuckle) in knuckles.iter().enumerate() {
            most = most.min(((knuckle.norm() - pin) / 1.5).max(0.2 * pin));
            for other in &knuckles[..number] {
                most = most.min((*knuckle - *other).norm().max(0.1 * pin) / 3.0);
            }
        }
        most
    }
}

/// Plates of a rod.
struct Plates {
    mesh: SceneMesh,
    /// Half of the rod's width [m].
    half: f64,
    facet_error: f64,
}

impl Plates {
    fn plate(&mut self, outline: Outline, [from, to]: Slice) {
        let (thickness, z) = ((to - from) * self.half, (to + from) / 2.0 * self.half);
        if let Some(plate) = SceneMesh::plate(&outline, thickness, z, self.facet_error) {
            self.mesh = std::mem::take(&mut self.mesh).with(&plate);
        }
    }
}

/// An eye about a pin at `along` on x.
fn ring(along: f64, outer: f64, inner: f64) -> Option<Outline> {
    let centre = Point::new(along, 0.0);
    let circle = |radius| Contour::circle(centre, radius).ok();
    Outline::new(circle(outer)?, vec![circle(inner)?]).ok()
}

/// A strip between two places along x, with its sides there.
fn strip([from, to]: [f64; 2], first: [f64; 2], last: [f64; 2]) -> Option<Outline> {
    let [low, high] = [first, last].map(|sides| [sides[0].min(sides[1]), sides[0].max(sides[1])]);
    let corners = [
        Point::new(from, low[0]),
        Point::new(to, high[0]),
        Point::new(to, high[1]),
        Point::new(from, low[1]),
    ];
    Some(Contour::polygon(&corners).ok()?.into())
}
