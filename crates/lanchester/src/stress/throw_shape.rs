//! Whether two throws of a crankshaft are one, moved along it, turned about it or mirrored.

use lanchester_flex::FlexError;
use lanchester_flex::crank_mesh::CrankMesh;
use lanchester_flex::throw_stress::throw_direction;
use lanchester_geometry::crankshaft::CrankshaftBody;
use lanchester_strength::{RuleThrow, WebSection};

/// Unit of the lengths [m]: that of a throw, so that all numbers are of one size.
const UNIT: f64 = 0.1;
/// Numbers nearer than this are one [1].
const NEAR: f64 = 1e-9;

/// Faces of a solid along the crank from the front cut, and eight numbers of its figure across it.
#[derive(Debug, Clone, Copy)]
struct Solid {
    faces: [f64; 2],
    figure: [f64; 8],
}

/// A throw between the middles of its main journals, seen in its own direction.
#[derive(Debug, Clone)]
pub(super) struct ThrowShape {
    length: f64,
    sections: [WebSection; 2],
    /// Main bearings, webs and the middle of the pin, from the front cut.
    planes: [f64; 5],
    solids: Vec<Solid>,
}

impl ThrowShape {
    /// From the body of the crankshaft, the mesh of the bay and the sizes of the throw.
    ///
    /// # Errors
    /// [`FlexError::Missing`] where the mesh has no such pin or no cuts.
    pub(super) fn new(
        body: &CrankshaftBody,
        bay: &CrankMesh,
        throw: &RuleThrow,
    ) -> Result<ThrowShape, FlexError> {
        let [front, rear] = bay.cut_planes()?;
        let [x, y] = throw_direction(bay, throw.throw + 1)?;
        let back = -y.atan2(x);
        let clipped = |faces: [f64; 2]| {
            let faces = faces.map(|face| (face.clamp(front, rear) - front) / UNIT);
            (faces[1] - faces[0] > NEAR).then_some(faces)
        };
        let (square, cube) = (UNIT * UNIT, UNIT * UNIT * UNIT);
        let mut solids = Vec::new();
        for (_, outline, faces) in body.outlines() {
            let Some(faces) = clipped(faces) else { continue };
            let own = outline.turned(back).moments();
            let fourth = square * square;
            let [x, y] = [own.first.x / cube, own.first.y / cube];
            let seconds = [own.xx / fourth, own.yy / fourth, own.xy / fourth];
            let figure = [own.area / square, x, y, seconds[0], seconds[1], seconds[2], 0.0, 0.0];
            solids.push(Solid { faces, figure });
        }
        // Inserts and holes: places and densities, which no outline has.
        for placed in &body.parts {
            let start = placed.part.faces()[0] + placed.z;
            for insert in placed.part.inserts() {
                let Some(faces) = clipped([start + insert.from, start + insert.to]) else { continue };
                let centre = insert.centre.turned(placed.turn + back);
                let [r, x, y] = [insert.radius, centre.x, centre.y].map(|length| length / UNIT);
                solids.push(Solid { faces, figure: [0.0, 0.0, 0.0, r, x, y, 1.0, insert.density] });
            }
        }
        let ([a, b], [c, d]) = (throw.mains, throw.webs);
        Ok(ThrowShape {
            length: (rear - front) / UNIT,
            sections: throw.sections,
            planes: [a, c, throw.pin, d, b].map(|plane| (plane - front) / UNIT),
            solids,
        })
    }

    /// The same with its front behind.
    pub(super) fn mirrored(&self) -> ThrowShape {
        let [front, rear] = self.sections;
        let [a, b, c, d, e] = self.planes.map(|plane| self.length - plane);
        let turned = |own: &Solid| {
            let [low, high] = own.faces.map(|face| self.length - face);
            Solid { faces: [high, low], figure: own.figure }
        };
        ThrowShape {
            length: self.length,
            sections: [rear, front],
            planes: [e, d, c, b, a],
            solids: self.solids.iter().map(turned).collect(),
        }
    }

    /// Whether another one has the same sizes in the same places.
    pub(super) fn is_near(&self, other: &ThrowShape) -> bool {
        let near = |a: f64, b: f64| (a - b).abs() <= NEAR * (1.0 + a.abs());
        let same = |a: &Solid, b: &Solid| {
            let numbers = |own: &Solid| own.faces.into_iter().chain(own.figure).collect::<Vec<_>>();
            numbers(a).into_iter().zip(numbers(b)).all(|(a, b)| near(a, b))
        };
        near(self.length, other.length)
            && self.sections == other.sections
            && self.planes.into_iter().zip(other.planes).all(|(a, b)| near(a, b))
            && self.solids.len() == other.solids.len()
            && self.solids.iter().all(|own| other.solids.iter().any(|other| same(own, other)))
            && other.solids.iter().all(|other| self.solids.iter().any(|own| same(own, other)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lanchester_flex::crank_mesh::{CrankMeshOptions, crank_mesh_of_bay};
    use lanchester_geometry::crankshaft::crankshaft;
    use lanchester_strength::rule_throws;

    #[test]
    fn a_mirrored_throw_is_known_again() {
        let text = include_str!("../../../../examples/in-line-4-crank-by-elements.toml");
        let engine = lanchester_file::read(text).engine().expect("the example has no mistakes");
        let options = CrankMeshOptions { size: 14e-3, fillet_elements: 2, ..CrankMeshOptions::default() };
        let body = crankshaft(&engine, 0).expect("it has a body");
        let throws = rule_throws(&engine, 0).expect("it has all sizes");
        let shape = |throw: &RuleThrow| {
            let bay = crank_mesh_of_bay(&engine, 0, options, throw.throw + 1).expect("it is meshed");
            ThrowShape::new(&body, &bay, throw).expect("it has a pin")
        };
        let shapes: Vec<ThrowShape> = throws.iter().map(shape).collect();
        assert!(shapes[1].is_near(&shapes[1]) && !shapes[1].mirrored().is_near(&shapes[1]));
        assert!(!shapes[2].is_near(&shapes[1]) && shapes[2].mirrored().is_near(&shapes[1]));
        // The rear web of the last throw is that of the flange, wider than the front web of the first.
        assert!(!shapes[3].is_near(&shapes[0]) && !shapes[3].mirrored().is_near(&shapes[0]));
    }
}
